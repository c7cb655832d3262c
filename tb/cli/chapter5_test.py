"""rc2 choices and rc2 virtual-image: what chapter 5 leaves open."""

import csv
import unittest

from host import HostTest


class Choices(HostTest):
    def test_each_choice_has_a_row_and_the_machines_is_best(self):
        text = self.succeed("choices", "gallery", "--n", 32, "--out", "c.csv")
        with open(self.folder / "c.csv", newline="") as file:
            rows = {row["choice"]: row for row in csv.DictReader(file)}
        self.assertEqual(len(rows), 14)
        gross = {choice: float(row["gross_percent"]) for choice, row in rows.items()}
        for choice, row in rows.items():
            self.assertIn(f"{gross[choice]:.2f}", text)
        for choice in "leave: facing", "leave: gap", "leave: own facet", "leave: nothing":
            self.assertGreater(gross[choice], 2 * gross["machine"], choice)
        for choice in "point: centre", "point: side":
            self.assertGreater(float(rows[choice]["mean_distance"]), 4 * float(rows["machine"]["mean_distance"]))
        degrees = {choice: float(row["mean_degrees"]) for choice, row in rows.items()}
        self.assertGreater(degrees["normal: side"], 10 * degrees["machine"])

    def test_bad_input(self):
        self.refuse("choices", says="SCENE")
        self.refuse("choices", "gallery", "--n", 2000, says="--n")
        self.refuse("choices", "nothing.obj", "--n", 16, says="nothing.obj")


class VirtualImage(HostTest):
    def test_the_thesis_three_cases(self):
        self.succeed("virtual-image", "--n", "24,48", "--out", "v.csv")
        rows = [line.split() for line in self.succeed("virtual-image", "--n", "24,48").splitlines()[1:]]
        self.assertEqual(len(rows), 2 * 4)
        for n, point, centre, side, sides in (("24", *rows[:4]), ("48", *rows[4:])):
            self.assertEqual({row[0] for row in (point, centre, side, sides)}, {n})
            mean, largest, clouds, dark = (list(map(float, column)) for column in
                                           zip(*(row[-4:] for row in (point, centre, side, sides))))
            # One point; a cloud round it, a voxel or two wide; several clouds, and light is missing.
            self.assertLess(largest[0], 0.3)
            self.assertTrue(0.3 < mean[1] < 2 and 0.3 < mean[2] < 2, mean)
            self.assertEqual(clouds[:3], [1, 1, 1])
            self.assertGreater(clouds[3], 1)
            self.assertGreater(mean[3], 4)
            self.assertEqual(dark[0], 0)
            self.assertGreater(dark[3], 20)
        with open(self.folder / "v.csv", newline="") as file:
            kinds = {row["what"] for row in csv.DictReader(file)}
        self.assertEqual(kinds, {"source", "image", "voxel", "ray", "from"})

    def test_bad_input(self):
        self.refuse("virtual-image", "--n", 4, says="--n")
        self.refuse("virtual-image", "--out", "no/folder.csv", says="no/folder.csv")


if __name__ == "__main__":
    unittest.main()
