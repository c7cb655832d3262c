"""rc2 leaks, rounding, load-speed: what chapter 3 is measured by."""

import csv
import unittest

from host import HostTest

DISCRETISERS = ("armoured", "naive", "supercover", "half", "blindee", "bilinear", "slices")
TETRAHEDRON = """v 0 0 0
v 9 1 2
v 1 9 3
v 2 3 9
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""


class Tables(HostTest):
    def table(self, command, *arguments):
        """The rows of the table that the command writes, numbers as numbers, and what it prints."""
        text = self.succeed(command, *arguments, "--out", "table.csv")

        def value(word):
            try:
                return float(word)
            except ValueError:
                return word

        with open(self.folder / "table.csv", newline="") as file:
            return [{k: value(v) for k, v in row.items()} for row in csv.DictReader(file)], text

    def refuse_common(self, command):
        self.refuse(command, "--out", "no/folder.csv", says="no/folder.csv")
        self.refuse(command, "--what", says="--what")


class Leaks(Tables):
    def test_only_armoured_and_supercover_are_tight(self):
        rows, text = self.table("leaks", self.write("tetrahedron.obj", TETRAHEDRON), "--meshes", 2)
        meshes = list(dict.fromkeys(row["mesh"] for row in rows))
        self.assertEqual(meshes[0], "tetrahedron.obj")
        self.assertEqual([(row["mesh"], row["discretiser"]) for row in rows],
                         [(mesh, name) for mesh in meshes for name in DISCRETISERS])
        for row in rows:
            self.assertIn(row["mesh"], text)
            self.assertEqual(row["meshes"], 1 if row["mesh"] == "tetrahedron.obj" else 2)
            if row["discretiser"] in ("armoured", "supercover"):
                self.assertEqual((row["tunnels_6"], row["tunnels_26"]), (0, 0), row)
            if row["discretiser"] == "naive":
                self.assertEqual(row["tunnels_6"], 0, row)
            self.assertLessEqual(row["tunnels_6"], row["tunnels_18"])
            self.assertLessEqual(row["tunnels_18"], row["tunnels_26"])
            self.assertEqual(row["leaking_26"] > 0, row["tunnels_26"] > 0)
            if row["discretiser"] == "armoured":
                self.assertEqual(row["voxels_to_armoured"], 1)
        leaking = {row["discretiser"] for row in rows if row["tunnels_26"]}
        self.assertEqual(leaking, set(DISCRETISERS) - {"armoured", "supercover"})

    def test_bad_input(self):
        self.refuse_common("leaks")
        self.refuse("leaks", "nowhere.obj", says="nowhere.obj")
        self.refuse("leaks", "--meshes", 0, says="--meshes")


class Rounding(Tables):
    def test_many_bits_are_exact_and_a_wide_slab_is_tight(self):
        rows, text = self.table("rounding", "--n", "20,40", "--bits", "4,30")
        self.assertEqual([(row["scene"], row["n"], row["bits"], row["rounding"]) for row in rows],
                         [(scene, n, bits, kind) for scene in ("random", "sphere") for n in (20, 40)
                          for bits in (4, 30) for kind in ("origin", "centroid", "widened")])
        for row in rows:
            self.assertIn(f"{row['scene']}, n = {row['n']:.0f}", text)
            wrong = row["missing"] + row["extra"]
            self.assertAlmostEqual(row["error"], wrong / row["voxels"], places=8)
            self.assertEqual(wrong == 0, row["bits"] == 30, row)
            if row["rounding"] == "widened":
                self.assertEqual(row["missing"], 0)
                self.assertIn(row["tunnels_26"], (0, ""))
            self.assertEqual(row["tunnels_26"] == "", row["scene"] == "random")

    def test_every_side_it_offers(self):
        self.table("rounding", "--n", 20, "--bits", 8)

    def test_bad_input(self):
        self.refuse_common("rounding")
        for option, value in (("--n", 19), ("--n", 513), ("--bits", 1), ("--bits", "8,x")):
            self.refuse("rounding", option, value, says=option)


class LoadSpeed(Tables):
    def test_counts_and_times(self):
        scene = self.write("tetrahedron.obj", TETRAHEDRON)
        rows, text = self.table("load-speed", scene, "room", "--n", 32, "--repeats", 2)
        self.assertEqual([row["scene"] for row in rows],
                         ["small triangles", "large triangles", "tetrahedron.obj", "room"])
        small, large, tetrahedron, room = rows
        self.assertEqual((small["triangles"], large["triangles"]), (20 * 4**7, 1000))
        self.assertEqual([tetrahedron[key] for key in ("polygons", "triangles", "facets")], [4] * 3)
        self.assertGreater(room["triangles"], room["polygons"])
        for row in rows:
            self.assertIn(row["scene"], text)
            self.assertEqual(row["n"], 32)
            self.assertGreater(row["voxels"], 0)
            for step in ("import", "packets", "load", "list", "direct"):
                self.assertGreaterEqual(row[step + "_ms"], 0)

    def test_voxels_are_counted_for_each_facet(self):
        # Facets far apart, so that no voxel has two.
        row = self.table("load-speed", "dust:0.2:1", "--n", 16, "--repeats", 1)[0][-1]
        text = self.succeed("voxelize", "dust:0.2:1", "--n", 16)
        self.assertRegex(text, rf"voxels occupied +{row['voxels']:.0f}\n")
        self.assertEqual(row["voxels"], row["facets"])

    def test_bad_input(self):
        self.refuse_common("load-speed")
        self.refuse("load-speed", "nowhere.obj", says="nowhere.obj")
        self.refuse("load-speed", "ball:900", "--n", 32, says="ball:900")
        for option, value in (("--n", 15), ("--n", 1025), ("--repeats", 0)):
            self.refuse("load-speed", option, value, says=option)


if __name__ == "__main__":
    unittest.main()
