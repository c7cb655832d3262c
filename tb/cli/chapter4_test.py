"""rc2 emission and rc2 path-table: the ways of light that chapter 4 compares."""

import csv
import unittest

from host import HostTest

WAYS = ["ask-all", "ask-seen", "voxels", "border", "virtual", "beams", "table", "lanes"]


class Emission(HostTest):
    def test_each_light_has_a_row_for_each_way(self):
        text = self.succeed("emission", "ball:3", "--n", "8,12", "--out", "e.csv")
        with open(self.folder / "e.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["way"] for row in rows], 2 * 3 * WAYS)
        for first in range(0, len(rows), len(WAYS)):
            ways = {row["way"]: {key: int(row[key]) for key in list(row)[3:] if key != "way"}
                    for row in rows[first:first + len(WAYS)]}
            self.assertEqual(ways["ask-all"]["rays"], 2 * ways["ask-all"]["occupied"])
            self.assertLess(ways["ask-seen"]["rays"], ways["ask-all"]["rays"])
            for way in "virtual", "beams", "table", "lanes":
                self.assertEqual((ways[way]["lit"], ways[way]["differ"]), (ways["virtual"]["lit"], 0), way)
            self.assertEqual({**ways["table"], "looks": 0}, ways["beams"])
            self.assertLess(ways["lanes"]["cycles"], ways["virtual"]["cycles"])
            self.assertRegex(text, rf"\b{ways['border']['visits']}\b")

    def test_table_of_paths(self):
        text = self.succeed("path-table", "--n", "16", "--rows").splitlines()
        self.assertEqual(text[1].split(), ["16", "16", "15", "175", "240", "120", "10", "11"])
        self.assertEqual(text[2:4], ["0" * 15, "0" * 7 + "1" + "0" * 7])
        self.assertEqual(len(text), 2 + 16)

    def test_bad_input(self):
        self.refuse("emission", says="SCENE")
        self.refuse("emission", "ball:3", "--n", 4, says="--n")
        self.refuse("emission", "nothing.obj", "--n", 8, says="nothing.obj")
        self.refuse("emission", "ball:3", "--n", 8, "--out", "no/folder.csv", says="no/folder.csv")
        self.refuse("path-table", "--n", 1, says="--n")


if __name__ == "__main__":
    unittest.main()
