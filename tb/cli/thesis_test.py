"""rc2 thesis: the tables and snapshots of the thesis."""

import pathlib
import os
import unittest

from host import HostTest, png_size

PRINTED = pathlib.Path(os.environ["RC2_SOURCE_DIR"]) / "docs" / "thesis"


class Tables(HostTest):
    def table(self, name, *arguments):
        out = self.succeed("thesis", "--table", name, *arguments, "--out", "table.csv")
        self.assertEqual(out, "")
        return (self.folder / "table.csv").read_text().splitlines()

    def printed(self, name):
        return (PRINTED / f"diffusion_{name}.csv").read_text().splitlines()

    def test_a_part_of_the_table_of_longest_queues(self):
        printed = self.printed("fa_max")
        self.assertEqual(self.table("fa_max", "--n", "20..24"), printed[:1] + printed[20:25])

    def test_columns_are_the_printed_ones(self):
        for name, arguments, rows in (("fa1", ("--n", "2..5"), 4),
                                      ("fa_sweep", ("--n", 6, "--fa", "2..4"), 3)):
            table = self.table(name, *arguments)
            self.assertEqual(table[0], self.printed(name)[0])
            self.assertEqual(len(table), 1 + rows)

    def test_the_conflict_rule_is_passed_on(self):
        self.assertNotEqual(self.table("fa1", "--n", 10),
                            self.table("fa1", "--n", 10, "--conflict", "back-to-tail"))

    def test_rays_one_by_one_against_beams(self):
        rows = [line.split(",") for line in self.table("modes", "--n", 8)]
        self.assertEqual([row[1] for row in rows], ["cones", "plane", "x", "z", "xyz"])
        self.assertEqual(rows[1][2:4], ["8", "15"])

    def test_bad_input(self):
        for arguments, says in (
            (("--table", "fa_max", "--n", "0..4"), "--n 0..4"),
            (("--table", "fa_max", "--n", "4..3"), "--n 4..3"),
            (("--table", "fa_max", "--n", "4..x"), "--n 4..x"),
            (("--table", "fa_max", "--n", "4..999999999999"), "--n 4..999999999999"),
            (("--table", "fa1", "--n", "4", "--fa", "2"), "--fa"),
            (("--table", "fa1", "--n", "4", "--times", "2"), "--times"),
            (("--table", "fa_sweep", "--n", "4"), "--fa"),
            (("--table", "fa_mini", "--n", "4"), "fa_mini"),
            (("--table", "fa1", "--snapshots"), "--snapshots"),
            ((), "--table"),
        ):
            with self.subTest(arguments):
                self.refuse("thesis", *arguments, "--out", "x", says=says)
        self.refuse("thesis", "--table", "fa1", says="--out")
        self.refuse("thesis", "--table", "fa1", "--out", "no/folder.csv", says="no/folder.csv")


class Snapshots(HostTest):
    def test_a_row_for_each_time_and_the_end(self):
        out = self.succeed("thesis", "--snapshots", "--fa", 16, "--times", "0,100", "--out", "s.png")
        self.assertIn("after 0, 100, 144 cycles", out)
        width, height = png_size(self.folder / "s.png")
        self.assertGreater(width, 17 * 64)
        self.assertGreater(height, 3 * 64)

    def test_bad_input(self):
        for arguments, says in (
            ((), "--fa"),
            (("--fa", "1..3"), "--fa"),
            (("--fa", "0"), "--fa"),
            (("--fa", "2", "--n", "65"), "--n"),
            (("--fa", "2", "--times", "100000"), "--times 100000"),
            (("--fa", "2", "--times", "2,1"), "--times 1"),
            (("--fa", "2", "--times", "-1"), "--times -1"),
        ):
            with self.subTest(arguments):
                self.refuse("thesis", "--snapshots", *arguments, "--out", "x.png", says=says)


if __name__ == "__main__":
    unittest.main()
