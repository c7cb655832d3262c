"""Synthesis to standard cells and timing of what comes out: what scripts/area measures with.

Yosys maps the RTL to Debian's OSU library of 0.18 um (package qflow-tech-osu018), abc buffers and sizes
it, OpenSTA times the netlist without wire load. The memories of a column (rc2_ram) stay apart, as
bits; FIFOs are flip-flops.
"""

import hashlib
import json
import os
import re
import subprocess
import tempfile

LIBRARY = "/usr/share/qflow/tech/osu018/osu018_stdcells.lib"
NAND2 = 24.0  # um2 of NAND2X1, the gate of a gate equivalent
FLIP_FLOP = 96.0  # um2 of DFFPOSX1
DELAY = 5000  # ps that abc aims at
# What is steady while a light runs has no share in the longest path.
STEADY = ("light_i", "x_i", "y_i", "step_i", "dx_i", "dy_i", "at_i", "distance_i", "zs_i", "source_i")
# Counts of targets: both machines know when light ends without them, and lanes have none of them
# with RC2_COUNTS=0.
INSTRUMENTS = {"rc2_cell_thesis": ("u_tally", "u_arrivals")}


def short_hash(text):
    return hashlib.sha1(text.encode()).hexdigest()[:12]


def run(words, folder):
    done = subprocess.run(words, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          check=False)
    if done.returncode:
        raise SystemExit(f"{words[0]} failed in {folder}:\n{(done.stdout + done.stderr)[-2000:]}")
    return done.stdout


class Design:
    """One module of the machine, synthesised with the given macros; modules in `apart` stay boxes.

    The netlist stays in `folder` as long as what Yosys elaborates and the script are the same: an edit
    of a comment, or of what is not part of this module, asks for no synthesis.
    """

    def __init__(self, root, folder, top, macros, apart=()):
        self.root, self.top, self.apart = root, top, apart
        self.macros = macros
        self.script = self.commands()
        self.content = self.elaborated(folder)
        self.base = os.path.join(folder, f"{top}-{short_hash(self.script + self.content)}")

    def elaborated(self, folder):
        """What the module is before synthesis, as a hash that does not depend on places in the sources. It is kept, too."""
        text = self.script + "".join(open(path).read() for path in self.sources())
        kept = os.path.join(folder, f"{self.top}-{short_hash(text)}.elaborated")
        if not os.path.exists(kept):
            with tempfile.NamedTemporaryFile("r", suffix=".il") as file:
                run(["yosys", "-q", "-p", "; ".join([*self.reading(), f"write_rtlil {file.name}"])], self.root)
                found = file.read()
            found = re.sub(r"^(autoidx|\s*attribute \\(src|module_src)) .*\n", "", found, flags=re.MULTILINE)
            numbers = {}
            found = re.sub(r"\$[^\s\[\]]*\$\d+", lambda name: f"${numbers.setdefault(name[0], len(numbers))}", found)
            with open(kept, "w") as file:
                file.write(short_hash(found))
        return open(kept).read()

    def sources(self):
        found = (os.path.join(at, name) for at, _, names in os.walk(f"{self.root}/rtl") for name in names)
        return sorted(path for path in found if path.endswith(".sv"))

    def reading(self):
        """Reads the design; what is `apart`, and an instrument, is left out."""
        macros = " ".join(f"-DRC2_{name}={value}" for name, value in self.macros.items())
        levels = sorted({os.path.dirname(os.path.relpath(path, self.root)) for path in self.sources()})
        own = next(os.path.relpath(path, self.root) for path in self.sources() if path.endswith(f"/{self.top}.sv"))
        hierarchy = f"hierarchy -check -top {self.top} " + " ".join(f"-libdir {level}" for level in levels)
        dropped = INSTRUMENTS.get(self.top, ())
        return [
            f"read_verilog -sv {macros} rtl/rc2_pkg.sv {own}",
            hierarchy,
            *(f"delete {self.top}/{name}" for name in dropped),
            *(["proc", f"setundef -undriven -zero {self.top}"] if dropped else []),
            *(f"blackbox {name}" for name in self.apart),
            hierarchy,
            # Else what only an assertion looks at would count.
            "chformal -remove",
        ]

    def commands(self):
        return "\n".join([
            *self.reading(),
            "tee -o @BASE@.memories stat =*rc2_ram*",
            "blackbox =*rc2_ram*",
            f"synth -flatten -top {self.top}",
            f"dfflibmap -liberty {LIBRARY}",
            f"abc -liberty {LIBRARY} -D {DELAY} -constr @BASE@.constraints",
            # OpenSTA reads no concatenations and no unknown bits.
            "setundef -zero",
            "splitnets",
            "opt_clean -purge",
            f"tee -o @BASE@.area stat -liberty {LIBRARY}",
            "write_verilog -noattr -noexpr @BASE@.v",
        ])

    def figures(self):
        """Area in um2 without memories, flip-flops, bits of memory."""
        result = f"{self.base}.json"
        if not os.path.exists(result):
            with open(f"{self.base}.constraints", "w") as file:
                file.write("set_driving_cell BUFX4\nset_load 0.05\n")
            with open(f"{self.base}.ys", "w") as file:
                file.write(self.script.replace("@BASE@", self.base))
            run(["yosys", "-q", "-s", f"{self.base}.ys"], self.root)
            area = open(f"{self.base}.area").read()
            # Memories and blocks stand apart; of everything else the library must know the area.
            strange = re.findall(r"Area for cell type (\$(?!paramod)\S+) is unknown", area)
            if strange:
                raise SystemExit(f"{self.top}: {', '.join(strange)} is no gate: {self.base}.area")
            memories = open(f"{self.base}.memories").read()
            flip_flops = re.search(r"DFFPOSX1 +(\d+)", area)
            found = {
                "area": float(re.search(r"Chip area for .*: ([\d.]+)", area).group(1)),
                "flip_flops": int(flip_flops.group(1)) if flip_flops else 0,
                "memory_bits": sum(int(bits) for bits in re.findall(r"memory bits: +(\d+)", memories)),
            }
            with open(result, "w") as file:
                json.dump(found, file)
        return json.load(open(result))

    def instances(self, name):
        """How many of a module that stands apart are in the netlist; figures() has made it."""
        return len(re.findall(rf"^  {name} ", open(f"{self.base}.v").read(), re.MULTILINE))


def timed_netlist(design):
    """The netlist as OpenSTA reads it: with a buffer for each wire between ports where Yosys joins them in one assignment."""
    netlist = f"{design.base}.v"
    if "assign {" not in open(netlist).read():
        return netlist
    buffered = f"{design.base}-sta.v"
    if not os.path.exists(buffered):
        written = f"{buffered}.{os.getpid()}"  # another job may want the same
        run(["yosys", "-q", "-p", f"read_verilog {netlist}; insbuf -buf BUFX2 A Y; write_verilog -noattr -noexpr {written}"], design.root)
        os.replace(written, buffered)
    return buffered


def longest_path(design, parts=()):
    """ns from clock to clock of the longest path of a design put together from its parts, and its ends."""
    reads = "".join(f"read_verilog {timed_netlist(part)}\n" for part in (*parts, design))
    steady = " ".join(STEADY)
    clock = "[get_ports clk_i]" if "input clk_i;" in open(f"{design.base}.v").read() else ""
    script = f"""read_liberty {LIBRARY}
{reads}link_design {design.top}
create_clock -name clk -period 20 {clock}
foreach port [all_inputs] {{
  set name [get_property $port full_name]
  if {{ $name ne "clk_i" }} {{ set_input_delay 0.3 -clock clk $port }}
  if {{ [lsearch {{{steady}}} [regsub {{\\[.*}} $name ""]] >= 0 }} {{ set_false_path -from $port }}
}}
set_output_delay 0.3 -clock clk [all_outputs]
report_checks -path_delay max -format full -digits 3
exit
"""
    path = f"{design.base}-{len(parts)}.tcl"
    with open(path, "w") as file:
        file.write(script)
    report = run(["sta", "-no_splash", "-exit", path], design.root)
    slack = re.search(r"(-?[\d.]+)\s+slack", report)
    if not slack:
        raise SystemExit(f"sta found no path in {design.top}: {path}")
    ends = [re.search(rf"{end}: (\S+)", report).group(1) for end in ("Startpoint", "Endpoint")]
    netlists = {part.top: open(f"{part.base}.v").read() for part in (design, *parts)}
    names = {}
    for top, netlist in netlists.items():
        for name, pins in re.findall(r"DFFPOSX1 (\S+) \(\n(.*?)\n  \);", netlist, re.DOTALL):
            names[top, name] = re.search(r"\.Q\(\\?(.*?) *\)", pins).group(1).replace(" ", "")

    # Yosys makes a register without a name only where it takes a FIFO's read address into the memory.
    def register(end):
        *way, name = end.split("/")
        of = design.top
        for part in way:
            of = re.search(rf"\n  (\S+) \\?{re.escape(part)} +\(", netlists[of]).group(1)
        name = names.get((of, name), name)
        return "/".join([*way, "a FIFO's read address" if re.match(r"_\d+_", name) else name])

    return {"ns": round(20 - float(slack.group(1)), 2), "from": register(ends[0]), "to": register(ends[1])}


def netlist_ports(design):
    """(name, direction, bits) of each port of a netlist."""
    with open(f"{design.base}.v") as file:
        netlist = file.read()
    top = netlist[netlist.index(f"module {design.top}("):]
    return [(name, direction, int(high or 0) + 1)
            for direction, high, name in re.findall(r"\n  (input|output) (?:\[(\d+):0\] )?(\w+);", top[:top.index("endmodule")])]
