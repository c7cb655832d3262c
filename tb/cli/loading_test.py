"""rc2 loading, walk: cycles to load scenes, and the thesis's wave beside them."""

import csv
import unittest

from host import HostTest

# Three, four and six sides: 3 words and one for each side.
POLYGONS = """v 1 1 1
v 6 2 3
v 2 6 5
v 7 1 1
v 7 6 1
v 7 6 6
v 7 1 6
v 2 0 0
v 4 0 0
v 6 2 0
v 4 4 0
v 2 4 0
v 0 2 0
f 1 2 3
f 4 5 6 7
f 8 9 10 11 12 13
"""


class Loading(HostTest):
    def loads(self, *arguments):
        """The rows of the table, and what was printed."""
        text = self.succeed("loading", *arguments, "--out", "loads.csv")
        with open(self.folder / "loads.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        text_of = ("scene", "bound_by")
        return [{k: v if k in text_of else float(v) for k, v in row.items()} for row in rows], text

    def cycles(self, scene, *options):
        text = self.succeed("voxelize", scene, "--machine", "cycle", *options)
        return int(text.rsplit("clock cycles", 1)[1])

    def test_words_are_those_of_the_packets(self):
        scene = self.write("polygons.obj", POLYGONS)
        (row,), _ = self.loads(scene, "--n", 8, "--feeders", 1)
        self.assertEqual((row["facets"], row["words"], row["feeder_words"]), (3, 22, 22))

    def test_the_machine_that_voxelize_runs(self):
        rows, text = self.loads("ball:3", "--n", 8, "--feeders", "1,2,4,8")
        self.assertEqual([row["feeders"] for row in rows], [1, 2, 4, 8])
        for row in rows:
            self.assertEqual(row["cycles"],
                             self.cycles("ball:3", "--n", 8, "--feeders", int(row["feeders"])))
            self.assertIn(f"{row['cycles']:.0f}", text)

    def test_feeders_help_and_nothing_beats_the_bound(self):
        n = 16
        rows, _ = self.loads("ball:6", "--n", n, "--feeders", "1,2,4,8,16")
        for row in rows:
            self.assertEqual(row["bound"], max(row["feeder_words"], row["cell_words"]))
            self.assertEqual(row["bound_by"],
                             "feeder" if row["feeder_words"] >= row["cell_words"] else "cell")
            self.assertGreaterEqual(row["cycles"], row["bound"])
            self.assertEqual(row["feeder_words"] == row["words"], row["feeders"] == 1)
            self.assertLessEqual(row["cell_words"], row["row_words"])
            self.assertLessEqual(row["row_words"], row["feeder_words"])
        self.assertEqual(rows[-1]["feeder_words"], rows[-1]["row_words"])
        for few, more in zip(rows, rows[1:]):
            self.assertLessEqual(more["feeder_words"], few["feeder_words"])
            self.assertLessEqual(more["cycles"], few["cycles"] + 2 * n)

    def test_the_wave_visits_every_cell(self):
        ours = []
        for scene in ("ball:6", "room", "dust:0.03:1", "dust:0.03:2", "dust:0.03:3"):
            (row,), text = self.loads(scene, "--n", 16, "--feeders", 1, "--sample", 100_000)
            self.assertEqual(row["wave_sample"], row["facets"])
            self.assertGreaterEqual(row["wave_cycles"], row["cycles"])
            # A word a cycle, and the way to the far corner.
            self.assertGreaterEqual(row["wave_cycles"], row["words"] + 2 * 15)
            self.assertNotIn("sample", text)
            ours.append(row["cycles"] - row["words"])
        # A facet of one voxel goes no further than that.
        self.assertLess(min(ours[2:]), 2 * 15)

    def test_a_sample_stands_for_all(self):
        (whole,), _ = self.loads("ball:6", "--n", 16, "--feeders", 1, "--sample", 100_000)
        (part,), text = self.loads("ball:6", "--n", 16, "--feeders", 1, "--sample", 60)
        self.assertEqual(part["wave_sample"], 60)
        self.assertIn("sample of 60", text)
        self.assertAlmostEqual(part["wave_cycles"] / whole["wave_cycles"], 1, delta=0.15)

    def test_each_scene_with_each_side(self):
        rows, _ = self.loads("ball:2", "room", "--n", "8,12", "--feeders", "1,4")
        self.assertEqual([(row["scene"], row["n"], row["feeders"]) for row in rows],
                         [(scene, n, r) for scene in ("ball:2", "room") for n in (8, 12)
                          for r in (1, 4)])

    def test_bad_input(self):
        self.refuse("loading", says="SCENE")
        self.refuse("loading", "nowhere.obj", says="nowhere.obj")
        self.refuse("loading", "empty", "--n", 8, "--feeders", 1, says="no facet is left")
        for option, value in (("--n", 1), ("--n", "8,x"), ("--n", 1025), ("--feeders", 3),
                              ("--feeders", 0), ("--feeders", 16), ("--sample", 0)):
            with self.subTest(option=option, value=value):
                self.refuse("loading", "ball:2", "--n", 8, option, value, says=option)
        self.refuse("loading", "ball:2", "--n", 8, "--feeders", 1, "--out", "no/folder.csv",
                    says="no/folder.csv")


class Walk(HostTest):
    def test_every_stage_of_every_cycle(self):
        scene = self.write("triangle.obj", POLYGONS.replace("f 4 5 6 7\nf 8 9 10 11 12 13\n", ""))
        for feeders in (1, 2, 8):
            text = self.succeed("walk", scene, "--feeders", feeders, "--out", "walk.csv")
            header, rows = self.rows("walk.csv")
            self.assertEqual(header, "cycle,x,y,words,divides,writes")
            cycles = [row[0] for row in rows]
            self.assertEqual(sorted(set(cycles)), list(range(1, cycles[-1] + 1)))
            self.assertIn(f"clock cycles {cycles[-1]}\n", text)
            self.assertEqual(len({row[:3] for row in rows}), len(rows))
            # The first word is in the first stages; every voxel is written once.
            self.assertEqual({row[1] for row in rows if row[0] == 1}, {-1})
            text = self.succeed("voxelize", scene, "--fit", "none", "--n", 8)
            voxels = int(text.split("voxels occupied")[1])
            self.assertEqual(sum(row[5] for row in rows), voxels)
            # Only cells divide, and they do so before they have anything to write.
            divided = [row for row in rows if row[4]]
            self.assertGreaterEqual(min(row[1] for row in divided), 0)
            self.assertLess(divided[0][0], next(row for row in rows if row[5])[0])
            self.assertLessEqual(max(row[3] for row in rows), 2)

    def test_bad_input(self):
        self.refuse("walk", "ball:3", says="--out")
        self.refuse("walk", "ball:3", "--out", "no/folder.csv", says="no/folder.csv")
        self.refuse("walk", "ball:3", "--n", 65, "--out", "w.csv", says="--n")
        self.refuse("walk", "ball:3", "--feeders", 3, "--out", "w.csv", says="--feeders 3")
        self.refuse("walk", "ball:30", "--n", 64, "--out", "w.csv", says="too many")


if __name__ == "__main__":
    unittest.main()
