"""What rc2_limits says of the macros of a build: nothing, or a sentence that names the one that is wrong; to
Verilator and to Yosys."""

import os
import pathlib
import re
import subprocess
import unittest

ROOT = os.environ["RC2_SOURCE_DIR"]
FOLDERS = [folder for folder, _, _ in os.walk(f"{ROOT}/rtl")]
# Of each macro what is just inside its range, and just outside while the others are as by default.
LEAST = {"N": 2, "F": 0, "LMAX": 2, "FAMAX": 1, "FEEDERS": 1, "LAYERS": 0, "THESIS": 0, "COUNTS": 0, "SKIPS": 0,
         "RAYS": 0, "RAYDEPTH": 1, "RAYQ": 1}
MOST = {"N": 1024, "F": 8, "LMAX": 4096, "FAMAX": 4093, "FEEDERS": 1024, "LAYERS": 1, "THESIS": 1, "COUNTS": 1, "SKIPS": 1,
        "RAYS": 0, "RAYDEPTH": 7, "RAYQ": 255}
OUTSIDE = {
    "N": (-1, 0, 1, 1025), "F": (-1, 9), "LMAX": (-5, 0, 1, 4097), "FAMAX": (-1, 0, 4094), "FEEDERS": (-1, 0, 3, 32),
    "LAYERS": (-1, 2), "THESIS": (-1, 2), "COUNTS": (-1, 2), "SKIPS": (-1, 2), "RAYS": (-1, 2), "RAYDEPTH": (-1, 0, 8), "RAYQ": (-1, 0, 256),
}


def run(*words):
    done = subprocess.run(words, cwd=ROOT, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def verilator(top, file, macros):
    """(exit code, what is said)"""
    code, text = run("verilator", "--lint-only", "-Wall", *macros, *(word for folder in FOLDERS for word in ("-y", folder)),
                     "--top-module", top, "rtl/rc2.vlt", "rtl/trace.vlt", "rtl/rc2_pkg.sv", file)
    return code, re.findall(r"^%(?:Warning|Error).*?: (?:.*?: )?(.*)", re.sub(r"%Error: Exiting.*", "", text), re.MULTILINE)


def yosys(top, file, macros):
    code, text = run("yosys", "-q", "-w", "^Replacing memory", "-p", f"read_verilog -sv {' '.join(macros)} rtl/rc2_pkg.sv {file}; "
                     f"hierarchy -check -top {top} {' '.join(f'-libdir {folder}' for folder in FOLDERS)}")
    return code, re.findall(r"(?:Warning|ERROR): (.*?)\.?$", text, re.MULTILINE)


class Limits(unittest.TestCase):
    def look(self, top, **macros):
        """(what Verilator says, what Yosys says); who says something refuses, who refuses says it."""
        words = [f"-DRC2_{name}={value}" for name, value in macros.items()]
        found = []
        for tool in (verilator, yosys):
            code, said = tool(top, f"rtl/{top}.sv", words)
            self.assertEqual(code != 0, bool(said), (tool.__name__, macros, said))
            found.append(said)
        return found

    def refuse(self, top, name, value, **macros):
        for said in self.look(top, **{**macros, name: value}):
            self.assertEqual(len(said), 1, (top, name, value, said))
            self.assertRegex(said[0], rf"\ARC2_{name}, .* must be .*\d", (top, value))

    def test_every_macro_has_a_range(self):
        text = pathlib.Path(f"{ROOT}/rtl/rc2_pkg.sv").read_text()
        self.assertEqual(set(re.findall(r"`define RC2_(\w+)", text)), set(LEAST))

    def test_outside(self):
        for name, values in OUTSIDE.items():
            for value in values:
                self.refuse("rc2_limits", name, value)

    def test_rays_want_layers_lanes_and_neighbours(self):
        for macros in ({"LAYERS": 0}, {"THESIS": 1}, {"N": 2}):
            self.refuse("rc2_limits", "RAYS", 1, **macros)

    def test_inside(self):
        for macros in ({}, {"N": 3}, {"N": 3, "RAYS": 1}, LEAST, MOST):
            self.assertEqual(self.look("rc2_limits", **macros), [[], []], macros)

    def test_whoever_is_built_asks(self):
        for top in ("rc2_machine", "rc2_cell", "rc2_cell_thesis"):
            self.refuse(top, "N", 0, THESIS=int(top == "rc2_cell_thesis"))

    def test_the_smallest_machines_are_read(self):
        for macros in ({}, {"LAYERS": 1, "COUNTS": 1, "SKIPS": 1}, {"THESIS": 1}):
            self.assertEqual(self.look("rc2_machine", **{**LEAST, **macros}), [[], []], macros)


if __name__ == "__main__":
    unittest.main()
