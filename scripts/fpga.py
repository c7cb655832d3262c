"""Synthesis to FPGAs: logic of three families by Yosys, and what fits an iCE40 HX8K by nextpnr.

Of ECP5 and Xilinx 7 there are only Yosys's counts: Debian has no place and route for them. Gates of no
library in particular are counted here too, by Yosys's number of transistors for each.
"""

import itertools
import json
import os
import re
import subprocess

from synthesis import run, short_hash

# Synthesis; cells that are look-up tables, with what each counts for; flip-flops; blocks of memory;
# multipliers. Memory in look-up tables counts with them, as much as it takes.
FAMILIES = {
    "iCE40": ("synth_ice40", {"SB_LUT4": 1}, "SB_DFF", "SB_RAM", "SB_MAC"),
    "ECP5": ("synth_ecp5", {"LUT4": 1, "CCU2C": 2, "TRELLIS_DPR16X4": 4}, "TRELLIS_FF", "DP16KD|PDPW16KD", "MULT18X18D"),
    "Xilinx 7": ("synth_xilinx -family xc7 -flatten",
                 {**{f"LUT{k}": 1 for k in range(1, 7)}, "RAM32M": 4, "RAM64M": 4, "RAM32X1D": 2, "RAM64X1D": 2, "RAM128X1D": 4},
                 "FD[RSCP]E", "RAMB18|RAMB36", "DSP48E1"),
}
TRANSISTORS = 4  # of a NAND2
HX8K_PINS = 32  # among which the inputs are dealt out


def base(design, folder, *words):
    """Where a run keeps its files, until the design or the words change."""
    return os.path.join(folder, f"{design.top}-{short_hash(''.join((*words, design.content)))}")


def yosys(design, at, script):
    with open(f"{at}.ys", "w") as file:
        file.write("\n".join(script))
    run(["yosys", "-q", "-s", f"{at}.ys"], design.root)


def cells(text):
    """Of the last table of `stat`: kind -> number."""
    table = text[text.rindex("Number of cells:"):]
    return {kind: int(number) for kind, number in re.findall(r"^\s+\$?(\w+)\s+(\d+)\s*$", table, re.MULTILINE)}


def logic(design, folder, family):
    """Look-up tables, flip-flops, blocks of memory and multipliers of a whole design, memories and all."""
    synth, tables, flip_flop, block, multiplier = FAMILIES[family]
    at = base(design, folder, synth)
    if not os.path.exists(f"{at}.json"):
        yosys(design, at, [*design.reading(), f"{synth} -top {design.top}", f"tee -o {at}.stat stat"])
        found = cells(open(f"{at}.stat").read())

        def count(pattern):
            return sum(number for kind, number in found.items() if re.match(pattern, kind))

        with open(f"{at}.json", "w") as file:
            json.dump({"tables": sum(weight * found.get(kind, 0) for kind, weight in tables.items()), "flip_flops": count(flip_flop),
                       "blocks": count(block), "multipliers": count(multiplier)}, file)
    return json.load(open(f"{at}.json"))


def generic(design, folder):
    """NAND2 equivalents without memories: transistors of CMOS gates by fours."""
    at = base(design, folder, "generic")
    if not os.path.exists(f"{at}.json"):
        yosys(design, at, [*design.reading(), "blackbox =*rc2_ram*", f"synth -flatten -top {design.top}", f"tee -o {at}.stat stat -tech cmos"])
        transistors = re.findall(r"transistors: +(\d+)", open(f"{at}.stat").read())[-1]
        with open(f"{at}.json", "w") as file:
            json.dump({"nand2": round(int(transistors) / TRANSISTORS)}, file)
    return json.load(open(f"{at}.json"))


def pins(ports):
    """A frame that brings a design to a few pins: each input from one of them, all outputs as one sum."""
    inputs = [(name, len(of["bits"])) for name, of in ports.items() if of["direction"] == "input" and name != "clk_i"]
    outputs = [(name, len(of["bits"])) for name, of in ports.items() if of["direction"] == "output"]
    wires = itertools.cycle(range(HX8K_PINS))
    ties = [f".{name}({{{', '.join(f'from[{next(wires)}]' for _ in range(width))}}})" for name, width in inputs]
    return "\n".join((
        f"module pins(input clk_i, input [{HX8K_PINS - 1}:0] from, output to);",
        *(f"  wire [{width - 1}:0] {name};" for name, width in outputs),
        "  framed u_framed (.clk_i(clk_i), " + ", ".join((*ties, *(f".{name}({name})" for name, _ in outputs))) + ");",
        "  assign to = ^{" + ", ".join(name for name, _ in outputs) + "};",
        "endmodule", ""))


def place(design, folder):
    """A design on an iCE40 HX8K: its logic cells and blocks of memory, and, if it fits, the clock from register to
    register."""
    at = base(design, folder, "place")
    if not os.path.exists(f"{at}.json"):
        yosys(design, at, [*design.reading(), f"synth_ice40 -top {design.top}", f"write_json {at}.framed"])
        with open(f"{at}.v", "w") as file:
            file.write(pins(json.load(open(f"{at}.framed"))["modules"][design.top]["ports"]))
        # The design stays as it is: that inputs share a pin must not make anything simpler.
        yosys(design, at, [f"read_json {at}.framed", f"rename {design.top} framed", "setattr -mod -set keep_hierarchy 1 framed",
                           f"read_verilog {at}.v", "synth_ice40 -top pins", "setattr -mod -unset keep_hierarchy framed", "flatten",
                           f"write_json {at}.pins"])
        done = subprocess.run(["nextpnr-ice40", "--hx8k", "--package", "ct256", "--json", f"{at}.pins", "--seed", "1", "--freq", "50",
                               "--timing-allow-fail"], capture_output=True, text=True, check=False)
        cells = [int(number) for number in re.findall(r"ICESTORM_LC: +(\d+)/", done.stderr)]
        if not cells:
            raise SystemExit(f"nextpnr-ice40 failed in {folder}:\n{done.stderr[-2000:]}")
        clocks = re.findall(r"Max frequency for clock .*: ([\d.]+) MHz", done.stderr)
        with open(f"{at}.json", "w") as file:
            json.dump({"cells": cells[-1], "blocks": int(re.findall(r"ICESTORM_RAM: +(\d+)/", done.stderr)[-1]),
                       "mhz": float(clocks[-1]) if done.returncode == 0 else None}, file)
    return json.load(open(f"{at}.json"))
