"""What the program refuses: one sentence, an exit code that is not 0, and no file left behind."""

import os
import pty
import resource
import subprocess
import unittest

from host import BAD_INPUT, MODELS, RC2, SANITIZED, HostTest

TRIANGLE = "v 1 1 1\nv 5 1 1\nv 1 5 1\nf 1 2 3\n"


class Files(HostTest):
    def test_damaged_files_of_assimp(self):
        for path in sorted((MODELS / "invalid").iterdir()):
            if path.name != "malformed2.obj":
                with self.subTest(path.name):
                    self.refuse("run", path, "--n", 6, says=path.name)

    def test_damaged_gltf(self):
        for name in ("IndexOutOfRange/AllIndicesOutOfRange.gltf", "MissingBin/BoxTextured.gltf",
                     "RecursiveNodes/RecursiveNodes.gltf", "SchemaFailures/sceneWrongType.gltf",
                     "TestNoRootNode/NoScene.gltf", "TestNoRootNode/SceneWithoutNodes.gltf",
                     "wrongTypes/badArray.gltf", "wrongTypes/badNumber.gltf",
                     "wrongTypes/badObject.gltf", "wrongTypes/badString.gltf",
                     "wrongTypes/badUint.gltf", "issue_3269/texcoord_crash.gltf",
                     "BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb"):
            with self.subTest(name):
                self.refuse("run", MODELS / "glTF2" / name, "--n", 6, says=name)

    def test_damage_that_assimp_leaves_out(self):
        # It drops the damaged parts and reads the rest; every polygon that it hands on is counted.
        for name in ("invalid/malformed2.obj", "glTF2/IndexOutOfRange/IndexOutOfRange.gltf",
                     "glTF2/IncorrectVertexArrays/Cube.gltf"):
            with self.subTest(name):
                self.succeed("run", MODELS / name, "--n", 6, "--light", "0,5,0")
                facets = self.report()["facets"]
                self.assertGreater(facets["read"], 0)
                self.assertGreaterEqual(
                    facets["loaded"] + facets["degenerate"] + facets["outside"], facets["read"])

    def test_files_without_polygons(self):
        self.write("empty.obj", "")
        self.write("points.obj", "v 1 2 3\nv 4 5 6\nl 1 2\n")
        self.write("empty.stl", "solid nothing\nendsolid nothing\n")
        self.write("empty.ply", "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\n"
                   "property float y\nproperty float z\nelement face 0\n"
                   "property list uchar int vertex_indices\nend_header\n")
        self.write("text.txt", "this is not a scene")
        for name in self.files():
            with self.subTest(name):
                self.refuse("run", name, says=name)

    def test_vertices_that_are_not_finite(self):
        for number in ("nan", "inf", "-inf"):
            with self.subTest(number):
                self.write("bad.obj", TRIANGLE.replace("v 5 1 1", f"v {number} 1 1"))
                self.refuse("run", "bad.obj", says="bad.obj")
                self.refuse("run", "bad.obj", "--fit", "none", says="bad.obj")

    def test_polygon_through_the_border(self):
        self.write("large.obj", TRIANGLE.replace("5", "50"))
        self.refuse("run", "large.obj", "--fit", "none", "--n", 8, says="--fit cube")

    def test_scene_without_extent(self):
        self.write("dot.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n")
        self.refuse("run", "dot.obj", says="dot.obj")
        self.refuse("run", "empty", "--fit", "cube", says="--fit none")

    def test_no_such_file(self):
        self.refuse("run", "nowhere.obj", says="nowhere.obj")
        self.refuse("run", ".", says=".: there is no such file")

    def test_empty_words(self):
        self.refuse("run", "", says="word 2 of the command line is empty")
        self.refuse("run", "empty", "--light", "", says="--light: word 4 of the command line is empty")
        # The parser would go round for ever.
        self.refuse("thesis", "", "--fa", "1", says="word 2")


class GeneratedNames(HostTest):
    def test_malformed(self):
        for name in ("ball", "ball:", "ball:x", "ball:0", "ball:99", "ball:3:4", "room:1", "empty:",
                     "shells", "shells:", "shells:0", "shells:101", "shells:x:1", "shells:5:x",
                     "shells:5:1:2", "dust:-1:1", "dust:nan:1", "dust:5:-1"):
            with self.subTest(name):
                self.refuse("run", name, "--n", 8, says=name)


class Options(HostTest):
    def test_unknown_or_incomplete(self):
        self.refuse(says="rc2 --help lists them")
        self.refuse("paint", says="paint")
        self.refuse("run", says="SCENE")
        self.refuse("run", "room", "--colour", says="--colour")
        self.refuse("run", "room", "ball:3", says="ball:3")
        self.refuse("run", "room", "--out", says="--out")
        self.refuse("run", "room", "--machine", "abacus", says="abacus")
        self.refuse("run", "room", "--fit", "sphere", says="sphere")
        self.refuse("run", "room", "--light-rule", "lamp", says="lamp")
        self.refuse("run", "room", "--light-rule", "accurate", "--mode", "thesis", says="--light-rule")
        self.refuse("light-error", "plates:0", "--n", 16, says="plates:0")
        self.refuse("run", "room", "--rule", "leather", says="leather")
        self.refuse("run", "room", "--seed", "-1", says="--seed")

    def test_numbers_out_of_range(self):
        for option, values in (("--n", (1, 0, -5, 1025, 5000, 10**12, "x", "1.5", "")),
                               ("--fraction-bits", (-1, 9, "x")),
                               ("--target-distance", (0, -1, 32768, 10**12)),
                               ("--fa", (0, -1, 10**12))):
            for value in values:
                with self.subTest(option=option, value=value):
                    self.refuse("run", "ball:1", option, value, says=option)

    def test_waves_need_the_rtl(self):
        for machine in ("golden", "cycle"):
            self.refuse("run", "room", "--machine", machine, "--waves", "w.fst", says="--machine rtl")
        self.refuse("run", "room", "--waves-from", 5, says="--waves")
        for option in ("--waves-from=-1", "--waves-cycles=0"):
            self.refuse("run", "room", "--machine", "rtl", "--waves", "w.fst", option,
                        says=option.split("=")[0])


class Lights(HostTest):
    def test_malformed(self):
        for light in ("1", "1,2", "1,2,3,4", "1,2,3,4,5", "1,2,3,1,1,1,1", "1,2,x", "1,2,",
                      "1.5,2,3", " 1,2,3", "1,2,3,red,0,0", "1,2,3,-1,0,0", "1,2,3,nan,0,0",
                      "1,2,3,inf,0,0", "99999999999,0,0"):
            with self.subTest(light):
                self.refuse("run", "empty", "--n", 8, "--light", light, says=f"--light {light}: ")

    def test_outside_the_cube(self):
        for light in ("8,0,0", "0,8,0", "0,0,8", "-1,0,0"):
            with self.subTest(light):
                self.refuse("run", "empty", "--n", 8, "--light", light, says="0 to 7")

    def test_in_an_occupied_voxel(self):
        self.succeed("voxelize", "ball:3", "--n", 8, "--dump", "ball.csv")
        occupied = self.rows("ball.csv")[1]
        x, y, z, facet, *_ = occupied[len(occupied) // 2]
        for machine in ("golden", "cycle"):
            message = self.refuse("run", "ball:3", "--n", 8, "--machine", machine, "--light",
                                  f"{x},{y},{z}",
                                  says=f"voxel ({x},{y},{z}) is occupied by facet {facet}")
        proposal = message.split("for example with --light ")[1].strip()
        self.assertNotIn(tuple(map(int, proposal.split(","))), {row[:3] for row in occupied})
        self.succeed("run", "ball:3", "--n", 8, "--light", proposal)

    def test_the_proposal_is_the_nearest_free_voxel(self):
        # Around (2,2,2) all is occupied but (4,4,4), which is farther away than (5,2,2).
        taken = [(x, y, z) for x in range(5) for y in range(5) for z in range(5) if x + y + z < 12]
        lines = []
        for x, y, z in taken:
            lines += [f"v {x - 0.1} {y - 0.1} {z}", f"v {x + 0.1} {y - 0.1} {z}",
                      f"v {x} {y + 0.1} {z}", "f -3 -2 -1"]
        self.write("block.obj", "\n".join(lines) + "\n")
        message = self.refuse("run", "block.obj", "--fit", "none", "--n", 6, "--light", "2,2,2")
        x, y, z = map(int, message.split("for example with --light ")[1].split(","))
        self.assertEqual((x - 2) ** 2 + (y - 2) ** 2 + (z - 2) ** 2, 9)

    def test_lights_of_the_scene_outside_the_cube_are_counted(self):
        self.write("lamps.ac", AC3D)
        self.succeed("run", "lamps.ac", "--fit", "none", "--n", 8)
        self.assertEqual(self.report()["lights"],
                         {"read": 2, "used": 1, "outside": 1, "default": False})
        self.assertEqual(self.report()["sources"][0]["voxel"], [2, 3, 4])


class Outputs(HostTest):
    def test_a_folder_that_cannot_be_made(self):
        self.write("file", "in the way")
        for out in ("file", "file/below", "file/far/below"):
            with self.subTest(out):
                self.refuse("run", "room", "--n", 8, "--out", out, says=f"--out {out}")
        self.refuse("run", "room", "--n", 8, "--out", "/proc/rc2", says="/proc/rc2")
        self.assertEqual((self.folder / "file").read_text(), "in the way")

    def test_a_dump_that_cannot_be_written(self):
        (self.folder / "taken").mkdir()
        for dump in ("missing/dump.csv", "taken"):
            with self.subTest(dump):
                self.refuse("run", "room", "--n", 8, "--dump", dump, says=dump)

    def test_it_is_found_before_the_long_work(self):
        # The machine of this size would never end within the time limit.
        (self.folder / "taken").mkdir()
        for dump in ("missing/dump.csv", "taken"):
            self.refuse("run", "empty", "--n", 256, "--target-distance", 32767, "--machine",
                        "golden", "--dump", dump, says=dump)

    def test_what_was_there_before_stays(self):
        (self.folder / "out").mkdir()
        self.write("out/mine.txt", "mine")
        self.refuse("run", "ball:3", "--n", 8, "--light", "8,8,8")
        self.assertEqual(self.files(), ["out", "out/mine.txt"])

    @unittest.skipIf(SANITIZED, "the address sanitizer needs all the address space")
    def test_too_little_memory(self):
        limit = 1 << 30
        self.refuse("run", "empty", "--n", 1024, "--machine", "golden",
                    says="--n 1024: there is not enough memory",
                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))


class Terminal(HostTest):
    def test_a_message_is_one_line_there_too(self):
        ours, theirs = pty.openpty()
        done = subprocess.run([RC2, "run", "nowhere.obj"], cwd=self.folder, stderr=theirs, timeout=60)
        os.close(theirs)
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertRegex(os.read(ours, 4096).decode(), r"\Arc2: nowhere.obj: [^\n]+\n\Z")
        os.close(ours)


AC3D = """AC3Db
MATERIAL "" rgb 1 1 1  amb 0.2 0.2 0.2  emis 0 0 0  spec 0 0 0  shi 10  trans 0
OBJECT world
kids 3
OBJECT light
loc 2.2 3.4 3.9
kids 0
OBJECT light
loc 90 3 4
kids 0
OBJECT poly
numvert 3
1 1 1
5 1 1
1 5 1
numsurf 1
SURF 0x20
mat 0
refs 3
0 0 0
1 0 0
2 0 0
kids 0
"""

if __name__ == "__main__":
    unittest.main()
