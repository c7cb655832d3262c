"""rc2 voxelize and rc2 compare."""

import unittest

from host import BAD_INPUT, DIFFERENT, DONE, ROOM, HostTest


class Voxelize(HostTest):
    def test_both_machines_dump_the_same_voxels(self):
        for scene in (ROOM, "shells:10:4"):
            golden = self.succeed("voxelize", scene, "--n", 12, "--dump", "golden.csv")
            cycle = self.succeed("voxelize", scene, "--n", 12, "--machine", "cycle", "--dump",
                                 "cycle.csv")
            self.succeed("compare", "golden.csv", "cycle.csv")
            header, rows = self.rows("golden.csv")
            self.assertEqual(header, "x,y,z,facet,core,gap")
            self.assertRegex(golden, rf"voxels occupied +{len(rows)}\n")
            self.assertNotIn("cycles", golden)
            self.assertIn("clock cycles", cycle)

    def test_the_dump_of_a_run_has_the_same_voxels(self):
        self.succeed("voxelize", "ball:3", "--n", 8, "--dump", "voxels.csv")
        self.succeed("run", "ball:3", "--n", 8, "--dump", "run.csv")
        self.assertEqual(self.rows("voxels.csv")[1], [row[:6] for row in self.rows("run.csv")[1]])

    def test_it_writes_nothing_unless_told(self):
        self.succeed("voxelize", "ball:3", "--n", 8)
        self.assertEqual(self.files(), [])

    def test_bad_input(self):
        self.refuse("voxelize", "nowhere.obj", says="nowhere.obj")
        self.refuse("voxelize", "room", "--n", 1, says="--n 1")
        self.refuse("voxelize", "room", "--light", "1,2,3", says="--light")
        self.refuse("voxelize", "room", "--n", 8, "--dump", "no/folder.csv", says="no/folder.csv")


# A box with every corner between voxel centres: those of 4 to 9 are inside, along z up to `top`.
def box(top, sides=6):
    corners = [f"v {x} {y} {z}\n" for z in (3.25, top) for y in (3.25, 9.25) for x in (3.25, 9.25)]
    quads = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"]
    return "".join(corners + [f"f {quad}\n" for quad in quads[:sides]])


class Layers(HostTest):
    def layers(self, scene, *options):
        """What is printed, as numbers by name."""
        text = self.succeed("voxelize", scene, "--n", 16, *options)
        counts = (line.rsplit(None, 1) for line in text.splitlines())
        return {" ".join(name.split()): int(count) for name, count in counts}

    def test_both_machines_have_the_same_layers(self):
        for scene in ("room", ROOM, "shells:10:4"):
            golden = self.layers(scene, "--layers", "all")
            cycle = self.layers(scene, "--layers", "all", "--machine", "cycle")
            self.assertGreater(cycle.pop("clock cycles"), 0)
            self.assertEqual(golden, cycle)
            self.assertGreater(golden["inside voxels"], 0)

    def test_armour_and_shown_are_the_voxels_of_their_rules(self):
        found = self.layers("room", "--layers", "all")
        self.assertEqual(found["armour packets"], found["facets loaded"])
        self.assertEqual(found["armour voxels"], found["voxels occupied"])
        self.assertEqual(self.layers("room", "--rule", "armoured")["voxels occupied"],
                         found["armour voxels"])
        self.assertEqual(self.layers("room", "--rule", "naive")["voxels occupied"],
                         found["shown voxels"])

    def test_inside_a_box(self):
        scene = self.write("box.obj", box(9.25))
        found = self.layers(scene, "--fit", "none", "--layers", "all")
        self.assertEqual((found["inside voxels"], found["guard voxels"], found["solids"]), (216, 0, 1))

    def test_a_plate_is_thin(self):
        scene = self.write("plate.obj", box(3.5))
        found = self.layers(scene, "--fit", "none", "--layers", "all")
        self.assertEqual((found["inside voxels"], found["solids"]), (0, 1))
        self.assertGreaterEqual(found["guard voxels"], 36)

    def test_nothing_is_inside_what_is_open(self):
        scene = self.write("open.obj", box(9.25, sides=5))
        found = self.layers(scene, "--fit", "none", "--layers", "all")
        self.assertEqual((found["inside packets"], found["solids"]), (0, 0))
        self.assertEqual(found["open, nothing inside"], 1)

    def test_who_does_not_ask_pays_nothing(self):
        self.assertNotIn("inside voxels", self.layers("room"))
        cycles = self.layers("room", "--machine", "cycle")["clock cycles"]
        self.assertLess(cycles, self.layers("room", "--machine", "cycle", "--layers",
                                            "all")["clock cycles"])

    def test_bad_input(self):
        self.refuse("voxelize", "room", "--layers", "two", says="--layers")
        self.refuse("voxelize", "room", "--layers", "all", "--rule", "naive", says="--rule naive")


class Compare(HostTest):
    left = "x,y,z,facet,core,gap,light0\n1,0,0,5,1,0,7\n2,0,0,5,1,0,0\n0,0,1,6,1,0,1\n"

    def compare(self, left, right):
        self.write("a.csv", left)
        self.write("b.csv", right)
        return self.rc2("compare", "a.csv", "b.csv")

    def test_equal(self):
        result = self.compare(self.left, self.left)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))
        self.assertEqual(result.stdout.split(), "voxels differing 0 owners differing 0 lights "
                         "differing 0".split())

    def test_every_kind_of_difference(self):
        right = "x,y,z,facet,core,gap,light0\n1,0,0,4,1,0,7\n2,0,0,5,1,0,3\n0,0,2,6,1,0,1\n"
        result = self.compare(self.left, right)
        self.assertEqual(result.returncode, DIFFERENT)
        self.assertEqual(result.stderr, "")
        self.assertEqual(result.stdout.splitlines(), [
            "voxels differing  2",
            "owners differing  1",
            "lights differing  1",
            "  voxel (1,0,0), facet: expected 5, got 4",
            "  voxel (2,0,0), light0: expected 0, got 3",
            "  voxel (0,0,1), facet: expected 6, got none",
            "  voxel (0,0,2), facet: expected none, got 6",
        ])

    def test_only_the_first_ten_are_shown(self):
        rows = "".join(f"{x},0,0,1,1,0\n" for x in range(30))
        result = self.compare("x,y,z,facet,core,gap\n" + rows, "x,y,z,facet,core,gap\n")
        self.assertEqual(result.stdout.splitlines()[0], "voxels differing  30")
        self.assertEqual(len(result.stdout.splitlines()), 3 + 10)

    def test_a_missing_light_differs(self):
        result = self.compare(self.left, "x,y,z,facet,core,gap\n1,0,0,5,1,0\n2,0,0,5,1,0\n0,0,1,6,1,0\n")
        self.assertEqual(result.returncode, DIFFERENT)
        self.assertIn("lights differing  3", result.stdout)

    def test_a_bad_line_is_named(self):
        for bad in ("", "x,y\n", *(f"x,y,z,facet,core,gap\n{row}\n" for row in (
                        "1,2,3", "1,2,3,4,0,0,5", "1,2,3,x,0,0", "1,2,3,4,0,0\n1,2,3,4,0,0")),
                    "\0" * 50):
            self.write("good.csv", self.left)
            self.write("bad.csv", bad)
            self.refuse("compare", "good.csv", "bad.csv", says="bad.csv: line ")
            self.refuse("compare", "bad.csv", "good.csv", says="bad.csv: line ")

    def test_a_file_that_cannot_be_read(self):
        self.write("good.csv", self.left)
        self.refuse("compare", "good.csv", "none.csv", says="none.csv")
        self.refuse("compare", ".", "good.csv")
        self.assertEqual(self.rc2("compare", "good.csv").returncode, BAD_INPUT)


if __name__ == "__main__":
    unittest.main()
