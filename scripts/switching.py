"""The gates of a cell in simulation: which nets switch, and what that costs by the library.

A switch of a net costs what the library says for each pin on it (internal_power, at the fastest edge and the
least load, mean of rise and fall), and half the capacitance of the pins that it drives times the square of the voltage.
Gates have no delay here, so there are no glitches, and wires no capacitance.
"""

import collections
import dataclasses
import os
import re

from synthesis import LIBRARY, netlist_ports, run

UNCOUNTED = ("home_o", "skipped_o", "busy_o")  # what a cell without counters of targets says differently
VOLTS = 1.8
CYCLE = 10  # steps of the bench's time


def pins_of_cells():
    """gate -> pin -> (direction, pF, pJ of a switch)"""
    found = {}
    with open(LIBRARY) as file:
        for gate in re.split(r"\ncell \(", file.read())[1:]:
            pins = found.setdefault(gate[:gate.index(")")].strip(), {})
            for pin in re.split(r"\n  pin ?\(", gate)[1:]:
                inner = [float(first) for first in re.findall(r"(?:rise|fall)_power\s*\(.*?values\s*\(\s*\\?\s*\"([-\d.e]+)", pin, re.DOTALL)]
                pins[pin[:pin.index(")")].strip()] = (
                    re.search(r"direction : (\w+)", pin)[1], float(re.search(r"\bcapacitance : ([-\d.e]+)", pin)[1]),
                    sum(inner) / len(inner) if inner else 0.0)
    return found


def unit(net):
    """The instance that a net is in: "u_side_lane.u_straight", or "" of the cell's own."""
    return net.rpartition(".")[0]


@dataclasses.dataclass
class Count:
    """Of the cycle that starts a light and its cycles, over all cells that were replayed."""

    cycles: int = 0
    active: int = 0  # cycles in which a register changed
    clocked: int = 0  # registers in units of which one changed, summed over the cycles
    switches: int = 0
    data: float = 0.0  # pJ of all nets but the clock

    def __add__(self, other):
        return Count(*(a + b for a, b in zip(dataclasses.astuple(self), dataclasses.astuple(other))))

    def found(self, gates):
        """Per cell and cycle."""
        return {"duty": self.active / self.cycles, "unit_duty": self.clocked / self.cycles / len(gates.registers), "switches": self.switches / self.cycles, "data_pj": self.data / self.cycles,
                "clock_pj": gates.clock, "registers": len(gates.registers), "nets": len(gates.cost)}


class Gates:
    """The netlist of a design, ready to be replayed."""

    def __init__(self, design):
        self.design = design
        with open(f"{design.base}.v") as file:
            netlist = file.read()
        pins = pins_of_cells()
        self.cost = collections.Counter()  # pJ of a switch of a net
        self.registers = set()
        for gate, instance in re.findall(r"\n  (\w+) \S+ \(\n(.*?)\n  \);", netlist, re.DOTALL):
            if gate not in pins:
                continue
            for pin, net in re.findall(r"\.(\w+)\(\\?(.*?) ?\)(?:,|$)", instance, re.MULTILINE):
                if "'" in net:  # a constant
                    continue
                direction, load, inner = pins[gate][pin]
                self.cost[net] += inner + (VOLTS ** 2 * load / 2 if direction == "input" else 0)
                if gate.startswith("DFF") and pin == "Q":
                    self.registers.add(net)
        # Two edges a cycle.
        self.clock = 2 * self.cost.pop("clk_i")
        self.build()

    def build(self):
        """Icarus needs 20 kB for each instance of a gate, so it gets the function that the library gives of it."""
        design, self.simulation = self.design, f"{self.design.base}-replay"
        if os.path.exists(self.simulation):
            return
        script = "\n".join([
            *design.reading(), "proc", "select =*rc2_ram*", f"write_verilog -noattr -selected {design.base}-memories.v", "design -reset", f"read_liberty -ignore_miss_func {LIBRARY}", f"read_verilog -lib {design.base}-memories.v", f"read_verilog {design.base}.v",
            f"hierarchy -check -top {design.top}", "flatten", "setundef -zero -init", f"write_verilog -noattr {design.base}-logic.v"])
        with open(f"{design.base}-logic.ys", "w") as file:
            file.write(script)
        run(["yosys", "-q", "-s", f"{design.base}-logic.ys"], design.root)
        with open(f"{design.base}-bench.v", "w") as file:
            file.write(bench(design, self.cost))
        run(["iverilog", "-g2005-sv", "-s", "bench", "-o", self.simulation, f"{design.base}-bench.v", f"{design.base}-logic.v",
             f"{design.base}-memories.v"], design.root)

    def replay(self, record, cycles):
        """Counts from the start of the light on."""
        waves = f"{record}.vcd"
        said = run(["vvp", self.simulation, f"+record={record}", f"+waves={waves}", f"+cycles={cycles}"], self.design.root)
        if "0 differences" not in said:
            raise SystemExit(f"{self.simulation}: gates differ from the RTL in {record}: {said[-300:]}")
        found = self.count(waves, cycles)
        os.remove(waves)
        return found

    def nets(self, width, name):
        """What a variable of the waves is in the netlist, highest bit first; None for what is not there."""
        name = name.lstrip("\\")
        found = [name] if width == 1 else [f"{name}[{k}]" for k in reversed(range(width))]
        return [net if net in self.cost else None for net in found]

    def count(self, waves, cycles):
        found, nets, level, active = Count(cycles + 1), {}, {}, set()
        sizes = collections.Counter(unit(net) for net in self.registers)
        with open(waves) as file:
            for line in file:
                words = line.split()
                if line.startswith("$var"):
                    nets.setdefault(words[3], self.nets(int(words[2]), words[4]))
                elif line[0] == "#":
                    now = int(line[1:]) // CYCLE
                elif line[0] in "01xb":
                    bits, code = (words[0][1:], words[1]) if line[0] == "b" else (line[0], words[0][1:])
                    bits = bits.rjust(len(nets[code]), "0")
                    for net, old, new in zip(nets[code], level.get(code, bits), bits):
                        if net and old != new:
                            found.switches += 1
                            found.data += self.cost[net]
                            if net in self.registers:
                                active.add((now, unit(net)))
                    level[code] = bits
        found.active = len({now for now, _ in active})
        found.clocked = sum(sizes[of] for _, of in active)
        return found


def bench(design, nets):
    """Applies what a cell saw, a line a cycle, and compares what it says; dumps the cycles of the light."""
    ports = netlist_ports(design)
    inputs = [(name, width) for name, direction, width in ports if direction == "input" and name != "clk_i"]
    outputs = [(name, width) for name, direction, width in ports if direction == "output"]
    compared = "".join(("0" if name in UNCOUNTED else "1") * width for name, width in outputs)
    # A port of several bits is one variable in the simulation, any other net is one by itself.
    whole = {f"{name}[{k}]": name for name, width in (*inputs, *outputs) for k in range(width) if width > 1}
    watched = dict.fromkeys(whole.get(net, net) for net in nets)
    ins, outs = sum(width for _, width in inputs), sum(width for _, width in outputs)
    return f"""`timescale 1ns / 1ns
module bench;
  reg clk_i = 0, start;
{''.join(f"  reg [{width - 1}:0] {name} = 0;{chr(10)}" for name, width in inputs)}\
{''.join(f"  wire [{width - 1}:0] {name};{chr(10)}" for name, width in outputs)}\
  reg [{ins - 1}:0] in;
  reg [{outs - 1}:0] expected;
  wire [{outs - 1}:0] out = {{{', '.join(name for name, _ in outputs)}}};
  wire [{outs - 1}:0] compared = {outs}'b{compared};
  {design.top} dut (.clk_i(clk_i), {', '.join(f'.{name}({name})' for name, _ in (*inputs, *outputs))});
  reg [8*400-1:0] record, waves;
  integer file, wrong = 0, left = -1, cycles, k;
  initial begin
    if (!$value$plusargs("record=%s", record) || !$value$plusargs("waves=%s", waves) || !$value$plusargs("cycles=%d", cycles)) $finish;
    file = $fopen(record, "r");
    $dumpfile(waves);
    while (left != 0 && $fscanf(file, "%b %h %h", start, in, expected) == 3) begin
      {{{', '.join(name for name, _ in inputs)}}} = in;
      #4;
      // What no memory has been told yet is unknown here only.
      for (k = 0; k < {outs}; k = k + 1) if (compared[k] && out[k] !== 1'bx && out[k] !== expected[k]) wrong = wrong + 1;
      if (start) begin
{''.join(f"        $dumpvars(0, dut.{chr(92)}{net} );{chr(10)}" for net in watched)}\
        left = cycles;
      end else if (left > 0) left = left - 1;
      #1 clk_i = 1;
      #5 clk_i = 0;
    end
    $display("%0d cycles of light left, %0d differences", left, wrong);
    $finish;
  end
endmodule
"""
