"""scripts/switching.py on a counter of four bits, of which everything is known."""

import os
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, os.environ["RC2_SOURCE_DIR"] + "/scripts")
import switching
from synthesis import Design, netlist_ports

COUNTER = """module counter (input logic clk_i, input logic rst_ni, input logic start_i, input logic count_i,
                output logic [3:0] count_o);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) count_o <= '0;
    else if (count_i) count_o <= count_o + 1'b1;
    assert (count_o != 4'd9 || !count_i);
  end
endmodule
"""


@unittest.skipUnless(shutil.which("iverilog"), "only `make area` needs Icarus, and installs it")
class Switching(unittest.TestCase):
    def setUp(self):
        folder = tempfile.mkdtemp(prefix="rc2-switching-")
        self.addCleanup(shutil.rmtree, folder)
        self.folder = pathlib.Path(folder)
        (self.folder / "rtl").mkdir()
        (self.folder / "rtl/rc2_pkg.sv").write_text("package rc2_pkg; localparam int One = 1; endpackage\n")
        (self.folder / "rtl/counter.sv").write_text(COUNTER)
        design = Design(folder, folder, "counter", {})
        self.figures = design.figures()
        self.gates = switching.Gates(design)

    def replay(self, counts, wrong=0):
        """Two cycles of reset, one of rest, the start, then what `counts` says, a letter a cycle."""
        names = [name for name, direction, _ in netlist_ports(self.gates.design) if direction == "input" and name != "clk_i"]
        value = 0

        def line(**high):
            return f"{high.get('start_i', 0)} {sum(high.get(name, 0) << i for i, name in enumerate(reversed(names))):x} {value:x}"

        lines = [line(), line(), line(rst_ni=1), line(rst_ni=1, start_i=1)]
        for letter in counts:
            lines.append(line(rst_ni=1, count_i=int(letter)))
            value = (value + int(letter) + wrong) % 16
        (self.folder / "record.txt").write_text("\n".join(lines) + "\n")
        return self.gates.replay(f"{self.folder}/record.txt", len(counts))

    def test_what_only_an_assertion_looks_at_is_no_part_of_it(self):
        self.assertEqual(self.figures["flip_flops"], 4)
        self.assertEqual(len(self.gates.registers), 4)

    def test_a_switch_costs_what_the_library_says(self):
        direction, load, inner = switching.pins_of_cells()["DFFPOSX1"]["CLK"]
        self.assertEqual((direction, load), ("input", 0.0279235))
        self.assertAlmostEqual(inner, (0.006865 + 0.11034) / 2)
        self.assertAlmostEqual(self.gates.clock, 4 * 2 * (inner + 1.8 ** 2 * load / 2))

    def test_counting(self):
        found = self.replay("1" * 16)
        self.assertEqual((found.cycles, found.active), (17, 16))
        # Bit k switches in every 2^k-th cycle; the sum's own nets come on top.
        self.assertGreaterEqual(found.switches, 30)
        self.assertGreater(found.data, 0)

    def test_standing_still_costs_the_clock_only(self):
        found = self.replay("0" * 16)
        self.assertEqual((found.active, found.switches, found.data), (0, 0, 0.0))

    def test_duty(self):
        self.assertEqual(self.replay("0011" * 4).active, 8)

    def test_gates_that_differ_are_found(self):
        with self.assertRaises(SystemExit) as refused:
            self.replay("0011", wrong=1)
        self.assertIn("gates differ", str(refused.exception))


if __name__ == "__main__":
    unittest.main()
