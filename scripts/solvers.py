"""What scripts/formal asks its solvers: Yosys reads a checker with the units that it holds, and z3 (by
yosys-smtbmc) or ABC, which bears more gates, says whether an assertion can fail."""

import glob
import os
import re
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LIMIT = 1200  # seconds for one question
# What is undefined may be anything. Memories become registers before they are flattened, so that a
# checker finds their words by name.
FLAT = ("proc; memory_map; flatten; setundef -anyseq; opt; wreduce; opt_clean; async2sync; dffunmap; "
        "opt_clean")
# Registers may hold anything before the reset, so nothing is asked of the first cycle.
GATES = ("chformal -assert -skip 1; write_rtlil model.il; techmap; opt -fast; abc -g AND -fast; opt_clean; "
         "dffunmap; simplemap; aigmap; write_aiger -I -B -zinit -no-startoffset -map model.aim model.aig")

# The same for z3: gates, so that bits that nobody looks at are gone.
BITS = "techmap; opt -fast; abc -g AND -fast; opt_clean; dffunmap; simplemap; opt_clean; write_smt2 -wires model.smt2"


class Disproved(Exception):
    """What stands against a proof: an assertion that can fail, or no answer."""


def run(command, folder, log):
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        raise Disproved(f"no answer in {LIMIT} s") from None
    with open(f"{folder}/{log}", "w") as file:
        file.write(done.stdout + done.stderr)
    return done


def read(folder, rtl, proof):
    """Writes the checker with the units of folder `rtl` into `folder`, as its solver wants it."""
    os.makedirs(folder, exist_ok=True)
    files = [f"{ROOT}/tb/formal/{name}.sv" for name in (*proof.stubs, proof.checker)]
    macros = " ".join(f"-DRC2_{name}={value}" for name, value in proof.macros)
    params = " ".join(f"chparam -set {name} {value} {proof.checker};" for name, value in proof.params)
    search = " ".join(f"-libdir {level}" for level in (rtl, *sorted(glob.glob(f"{rtl}/*/"))))
    script = (f"read_verilog -sv -formal {macros} {rtl}/rc2_pkg.sv {' '.join(files)}; {params} "
              f"hierarchy -check -top {proof.checker} {search}; {FLAT}; "
              f"{GATES if proof.abc else BITS if proof.bits else 'write_smt2 -wires model.smt2'}")
    done = run(["yosys", "-q", "-w", "^Replacing memory", "-e", ".", "-p", script], folder, "yosys.txt")
    if done.returncode:
        raise SystemExit(f"scripts/formal: yosys cannot read {proof.checker}: {done.stdout}{done.stderr}")


def ask_z3(folder, what, *options):
    """One question; raises Disproved with the assertion that fails and the file of its waveform."""
    done = run(["yosys-smtbmc", "-s", "z3", "--unroll", "--noprogress", "--dump-vcd", f"{what}.vcd", *options,
                "model.smt2"], folder, f"{what}.txt")
    failed = re.findall(r"Assert failed in \S+ (\S+)", done.stdout)
    if failed:
        raise Disproved(f"{where(failed[0])} fails, see {folder}/{what}.vcd")
    if "Status: PASSED" not in done.stdout:
        raise SystemExit(f"scripts/formal: z3 says neither yes nor no; see {folder}/{what}.txt")


def ask_abc(folder, what, depth):
    """The same of the first `depth` cycles."""
    done = run(["yosys-abc", "-c", f"read_aiger model.aig; fold; strash; bmc3 -F {depth}; write_cex -a {what}.cex"],
               folder, f"{what}.txt")
    if re.search(rf"No output asserted in {depth} frames", done.stdout):
        return
    if "was asserted in frame" not in done.stdout:
        raise SystemExit(f"scripts/formal: ABC says neither yes nor no; see {folder}/{what}.txt")
    raise Disproved(f"{where(replay(folder, what))} fails, see {folder}/{what}.vcd")


def replay(folder, what):
    """ABC's counterexample as a waveform; returns what fails in it. All of its registers begin with 0:
    what is arbitrary in them are inputs of the first cycle."""
    with open(f"{folder}/model.aig", "rb") as file:
        latches = int(file.readline().split()[3])
    with open(f"{folder}/{what}.cex") as file:
        frames = [line.split("#")[0] for line in file.read().splitlines()[1:]]
    with open(f"{folder}/{what}.aiw", "w") as file:
        file.write("\n".join(["1", "b0", "0" * latches, *frames, "."]) + "\n")
    done = run(["yosys", "-q", "-p", f"read_rtlil model.il; sim -map model.aim -r {what}.aiw -vcd {what}.vcd "
                "-clock clk_i"], folder, f"{what}-sim.txt")
    return re.findall(r"Assert \S+ \((\S+)\) failed", done.stdout + done.stderr)[0]


def where(source):
    """File and line of an assertion, out of Yosys's path of instances: the unit's rather than its parents'."""
    files = [part.rsplit(":", 1) for part in source.split("|")]
    file, line = min(files, key=lambda part: "assert" not in line_of(*part))
    return f"{os.path.basename(file)}:{line.split('.')[0]}"


def line_of(file, line):
    with open(file) as source:
        return source.read().splitlines()[int(line.split(".")[0]) - 1]
