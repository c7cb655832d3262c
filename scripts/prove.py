"""One proof of scripts/formal: a checker of tb/formal around units of rtl/, read by Yosys and put to z3
by yosys-smtbmc. Nothing of a unit is changed for its proof, but by the fault that the proof must find."""

import dataclasses
import glob
import os
import re
import shutil
import subprocess
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LIMIT = 900  # seconds for one question to the solver


@dataclasses.dataclass(frozen=True)
class Fault:
    """A text of a file of rtl/ that occurs there once, and what is put in its place."""

    file: str
    good: str
    bad: str


@dataclasses.dataclass(frozen=True)
class Proof:
    """`depth` cycles from reset (bounded) or of the induction; 1 where a unit has no state (all inputs)."""

    checker: str  # tb/formal/<checker>.sv, its top module
    says: str
    units: str
    method: str  # "induction", "bounded" or "all inputs"
    fault: Fault
    depth: int = 1
    reach: int = 12  # cycles from reset in which the fault of an induction must show
    params: tuple = ()  # of the checker
    macros: tuple = ()  # of rc2_pkg
    stubs: tuple = ()  # files of tb/formal that stand for units of the same name
    fast: bool = True  # also a test of make test

    @property
    def sizes(self):
        return ", ".join(f"{name} = {value}" for name, value in (*self.macros, *self.params))

    @property
    def name(self):
        return "-".join((self.checker, *(f"{name.lower()}{value}" for name, value in (*self.macros, *self.params))))

    @property
    def how(self):
        return {"all inputs": "all inputs", "induction": f"induction, k = {self.depth}",
                "bounded": f"bounded, {self.depth} cycles"}[self.method]


class Disproved(Exception):
    """What stands against a proof: an assertion that can fail, or no answer."""


def read(folder, rtl, proof):
    """The checker with the units of folder `rtl` as SMT-LIB; returns the file."""
    os.makedirs(folder, exist_ok=True)
    model = f"{folder}/model.smt2"
    stubs = [f"{ROOT}/tb/formal/{stub}.sv" for stub in proof.stubs]
    files = [f"{rtl}/rc2_pkg.sv", *stubs, f"{ROOT}/tb/formal/{proof.checker}.sv"]
    macros = " ".join(f"-DRC2_{name}={value}" for name, value in proof.macros)
    params = " ".join(f"-chparam {name} {value}" for name, value in proof.params)
    search = " ".join(f"-libdir {level}" for level in (rtl, *sorted(glob.glob(f"{rtl}/*/"))))
    # What is undefined may be anything. Memories become registers before they are flattened, so that a
    # checker finds their words by name.
    script = (f"read_verilog -sv -formal {macros} {' '.join(files)}; "
              f"hierarchy -check -top {proof.checker} {params} {search}; proc; memory_map; flatten; "
              f"setundef -anyseq; opt -full; wreduce; opt_clean; async2sync; dffunmap; opt_clean; write_smt2 -wires {model}")
    done = subprocess.run(["yosys", "-q", "-w", "^Replacing memory", "-e", ".", "-p", script],
                          capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"scripts/formal: yosys cannot read {proof.checker}: {done.stdout}{done.stderr}")
    return model


def ask(model, what, *options):
    """Puts one question; raises Disproved with the assertion that fails and the file of its waveform."""
    folder = os.path.dirname(model)
    waves = f"{folder}/{what}.vcd"
    log = f"{folder}/{what}.txt"
    command = ["yosys-smtbmc", "-s", "z3", "--unroll", "--noprogress", "--dump-vcd", waves, *options, model]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        raise Disproved(f"no answer in {LIMIT} s") from None
    with open(log, "w") as file:
        file.write(done.stdout + done.stderr)
    if "Status: PASSED" in done.stdout:
        return
    failed = re.findall(r"Assert failed in \S+ (\S+)", done.stdout)
    if not failed:
        raise SystemExit(f"scripts/formal: {' '.join(command)} says neither yes nor no; see {log}")
    raise Disproved(f"{where(failed[0])} fails, see {waves}")


def where(source):
    """File and line of an assertion, out of Yosys's path of instances."""
    file, line = re.match(r"([^:]*):(\d+)", source.split("|")[-1]).groups()
    return f"{os.path.basename(file)}:{line}"


def broken_rtl(folder, fault):
    """A copy of rtl/ with the fault in it."""
    rtl = f"{folder}/rtl"
    shutil.rmtree(rtl, ignore_errors=True)
    shutil.copytree(f"{ROOT}/rtl", rtl)
    path = f"{rtl}/{fault.file}"
    with open(path) as file:
        text = file.read()
    if text.count(fault.good) != 1:
        raise SystemExit(f"scripts/formal: {fault.good!r} stands {text.count(fault.good)} times in rtl/{fault.file}, "
                         "not once; mend tb/formal/proofs.py")
    with open(path, "w") as file:
        file.write(text.replace(fault.good, fault.bad))
    return rtl


def prove(proof, folder):
    """Proves it and has it find its fault. Returns (None or what stands against it, where the fault showed,
    seconds of the proof)."""
    start = time.monotonic()
    model = read(f"{folder}/{proof.name}", f"{ROOT}/rtl", proof)
    steps = ["-t", str(proof.depth)]
    try:
        ask(model, "base", *steps)
        if proof.method == "induction":
            ask(model, "step", "-i", *steps)
    except Disproved as against:
        return str(against), "", time.monotonic() - start
    seconds = time.monotonic() - start
    broken = f"{folder}/{proof.name}-broken"
    model = read(broken, broken_rtl(broken, proof.fault), proof)
    try:
        ask(model, "fault", "-t", str(proof.reach if proof.method == "induction" else proof.depth))
    except Disproved as found:
        text = str(found)
        return ("its fault: " + text if "no answer" in text else None), text.split()[0], seconds
    return "its fault passes unnoticed", "", seconds
