"""rc2 run: what it writes is there, complete, and consistent with itself."""

import shutil
import subprocess
import unittest

from host import MODELS, ROOM, HostTest, exr_channels, png_size

DUCK = MODELS / "Collada/duck.dae"


class Run(HostTest):
    def check_run(self, scene, machine, n, *options):
        text = self.succeed(
            "run", scene, "--machine", machine, "--n", n, "--dump", "dump.csv", *options
        )
        report = self.report()
        self.check_report(report, machine, n)
        self.check_dump(report, n)
        self.check_pictures(report, n)
        for path in report["files"].values():
            self.assertIn(path, text)
            self.assertTrue((self.folder / path).is_file())
        self.assertEqual(
            self.files(),
            ["dump.csv", "out", "out/picture.exr", "out/picture.png", "out/report.json"],
        )
        return report

    def check_report(self, report, machine, n):
        self.assertEqual((report["machine"], report["n"]), (machine, n))
        self.assertEqual((report["L"], report["fa"]), (2 * n, 16))
        self.assertEqual((report["rule"], report["light_rule"]), ("armoured", "accurate"))
        facets = report["facets"]
        self.assertGreaterEqual(facets["loaded"] + facets["degenerate"] + facets["outside"],
                                facets["read"])
        sources = len(report["sources"])
        self.assertEqual(report["lights"]["used"], sources)
        for per_source in (report["cycles"]["light"], report["lit"]):
            self.assertEqual(len(per_source), sources)
        targets = report["targets"]
        self.assertEqual(targets["total"], sources * (24 * report["L"] ** 2 + 2))
        self.assertEqual(targets["total"],
                         targets["absorbed"] + targets["escaped"] + targets["skipped"])
        for name in ("visits", "merged"):
            self.assertEqual(report["beams"][name],
                             sum(source["beams"][name] for source in report["sources"]))
        self.assertGreater(report["beams"]["visits"], 0)
        self.assertEqual(report["agreement"]["reference"], "golden")
        self.assertEqual(report["agreement"]["voxels_differing"], 0)
        self.assertEqual(report["agreement"]["owners_differing"], 0)
        self.assertEqual(report["agreement"]["lights_differing"], 0)
        for tool in ("rc2", "compiler", "verilator", "assimp", "openexr"):
            self.assertRegex(report["tools"][tool], r"\d+\.\d+|none")
        self.assertTrue(report["commit"])
        self.assertTrue(all(seconds >= 0 for seconds in report["seconds"].values()))
        clocked = machine != "golden"
        for cycles in report["cycles"]["light"]:
            self.assertEqual(cycles > 0, clocked)
        self.assertEqual(report["cycles"]["load"] > 0, clocked and facets["loaded"] > 0)

    def check_dump(self, report, n):
        header, rows = self.rows("dump.csv")
        sources = len(report["sources"])
        self.assertEqual(header, ",".join(["x,y,z,facet,core,gap"] + [f"light{k}" for k in range(sources)]))
        self.assertEqual(len(rows), report["voxels"])
        places = [(z, y, x) for x, y, z, *_ in rows]
        self.assertEqual(places, sorted(set(places)))
        self.assertTrue(all(0 <= coordinate < n for place in places for coordinate in place))
        self.assertTrue(all(row[3] < report["facets"]["loaded"] for row in rows))
        for k, source in enumerate(report["sources"]):
            counts = [row[6 + k] for row in rows]
            if report["light_rule"] == "thesis":  # else light goes on through what it lights
                self.assertEqual(sum(counts), source["targets"]["absorbed"])
            self.assertEqual(sum(count > 0 for count in counts), source["lit"])
            self.assertEqual(source["lit"], report["lit"][k])
            self.assertNotIn(tuple(reversed(source["voxel"])), places)

    def check_pictures(self, report, n):
        names = {"R": 2, "G": 2, "B": 2, "Z": 2, "N.X": 2, "N.Y": 2, "N.Z": 2, "facet.id": 0}
        names.update({f"light{k}": 0 for k in range(len(report["sources"]))})
        self.assertEqual(exr_channels(self.folder / "out/picture.exr"), names)
        width, height = png_size(self.folder / "out/picture.png")
        self.assertEqual(width, height)
        self.assertEqual(width % n, 0)

    def check_both_machines(self, scene, n, *options):
        golden = self.check_run(scene, "golden", n, *options)
        golden_dump = (self.folder / "dump.csv").read_text()
        cycle = self.check_run(scene, "cycle", n, *options)
        self.write("golden.csv", golden_dump)
        self.succeed("compare", "golden.csv", "dump.csv")
        for same in ("facets", "lights", "lit", "voxels"):
            self.assertEqual(golden[same], cycle[same])
        # The golden model skips nothing, not even what ends in voxels that are not there to be lit.
        self.assertEqual(golden["targets"]["total"], cycle["targets"]["total"])
        self.assertEqual(golden["targets"]["skipped"], 0)
        for ends in ("absorbed", "escaped"):
            self.assertGreaterEqual(golden["targets"][ends], cycle["targets"][ends])
        return cycle

    def test_room_file_with_its_lights(self):
        report = self.check_both_machines(ROOM, 16)
        self.assertEqual(report["fit"], "cube")
        self.assertFalse(report["lights"]["default"])
        self.assertGreater(report["lights"]["read"], 0)

    def test_duck_gets_a_default_light(self):
        report = self.check_both_machines(DUCK, 12)
        self.assertTrue(report["lights"]["default"])
        self.assertEqual(report["sources"][0]["voxel"], [3, 9, 11])
        self.assertEqual(report["ignored"], {"primitives": 0, "lights": 1, "textures": 1})

    def test_generated_room(self):
        report = self.check_both_machines("room", 15)
        self.assertEqual(report["fit"], "none")
        self.assertFalse(report["lights"]["default"])

    def test_ball(self):
        self.assertGreater(self.check_both_machines("ball:5", 14)["voxels"], 0)

    def test_shells(self):
        self.check_both_machines("shells:10:3", 12)

    def test_dust(self):
        report = self.check_both_machines("dust:5:2", 8)
        self.assertEqual(report["voxels"], round(0.05 * 8**3))

    def test_empty(self):
        report = self.check_both_machines("empty", 6)
        self.assertEqual((report["voxels"], report["lit"]), (0, [0]))
        self.assertEqual(report["targets"]["absorbed"], 0)

    def test_the_smallest_machine(self):
        self.check_both_machines("empty", 2)

    def test_two_lights_with_colours(self):
        report = self.check_both_machines("ball:3", 10, "--light", "0,0,0", "--light",
                                          "9,8,7,0.5,0.25,0")
        self.assertEqual([s["voxel"] for s in report["sources"]], [[0, 0, 0], [9, 8, 7]])
        self.assertEqual([s["colour"] for s in report["sources"]], [[1, 1, 1], [0.5, 0.25, 0]])
        self.assertEqual(report["lights"],
                         {"read": 2, "used": 2, "outside": 0, "default": False})

    def test_the_default_light_moves_to_a_free_voxel(self):
        # The usual place in a cube of side 4 is (1, 3, 3).
        self.write("wall.obj", "v 0 0 3\nv 3 0 3\nv 3 3 3\nv 0 3 3\nf 1 2 3 4\n")
        self.succeed("run", "wall.obj", "--n", 4, "--fit", "none", "--dump", "wall.csv")
        report = self.report()
        occupied = {row[:3] for row in self.rows("wall.csv")[1]}
        self.assertIn((1, 3, 3), occupied)
        cube = [(x, y, z) for x in range(4) for y in range(4) for z in range(4)]
        away = lambda at: (at[0] - 1) ** 2 + (at[1] - 3) ** 2 + (at[2] - 3) ** 2
        voxel = tuple(report["sources"][0]["voxel"])
        self.assertNotIn(voxel, occupied)
        self.assertEqual(away(voxel), min(away(at) for at in cube if at not in occupied))

    def test_the_seed_completes_the_name(self):
        for scene in ("shells:10", "dust:5"):
            self.succeed("run", scene, "--n", 8, "--seed", 7, "--dump", "a.csv")
            self.assertEqual(self.report()["scene"], scene + ":7")
            self.succeed("run", scene + ":7", "--n", 8, "--dump", "b.csv")
            self.succeed("compare", "a.csv", "b.csv")
            self.succeed("run", scene + ":8", "--n", 8, "--seed", 7, "--dump", "c.csv")
            self.assertEqual(self.rc2("compare", "a.csv", "c.csv").returncode, 1)

    def test_options_reach_the_machine(self):
        self.succeed("run", "ball:3", "--n", 8, "--rule", "naive", "--fraction-bits", 2,
                     "--target-distance", 5, "--fa", 1, "--mode", "thesis", "--out", "deep/er")
        report = self.report("deep/er")
        self.assertEqual((report["rule"], report["fraction_bits"]), ("naive", 2))
        self.assertEqual((report["L"], report["fa"]), (5, 1))
        self.assertEqual((report["mode"], report["cycles"]["hop_stages"]), ("thesis", 3))
        self.assertEqual(report["targets"]["total"], 24 * 25 + 2)
        self.assertEqual(report["beams"]["max_queue"], 1)

    @unittest.skipUnless(shutil.which("fst2vcd"), "fst2vcd of GTKWave is not installed")
    def test_the_waveform_has_every_signal_of_its_list(self):
        for mode in ("fast", "thesis"):
            result = self.rc2("run", "ball:1", "--n", 4, "--machine", "rtl", "--mode", mode, "--light",
                              "0,0,0", "--waves", "w.fst")
            if "no such Verilated machine" in result.stderr:
                self.skipTest("the Verilated machines are not built")
            vcd = subprocess.run(["fst2vcd", "w.fst"], cwd=self.folder, capture_output=True,
                                 text=True, check=True).stdout
            scope, names = [], set()
            for line in vcd.split("$enddefinitions")[0].splitlines():
                words = line.split()
                if words[:1] == ["$scope"]:
                    scope.append(words[2])
                elif words[:1] == ["$upscope"]:
                    scope.pop()
                elif words[:1] == ["$var"]:
                    names.add(".".join(scope + ["".join(words[4:-1])]))
            listed = [line for line in (self.folder / "w.gtkw").read_text().splitlines()
                      if line.startswith("rc2.")]
            self.assertGreater(len(listed), 50)
            self.assertEqual([name for name in listed if name not in names], [])

    def test_both_modes_light_the_same(self):
        for mode in ("fast", "thesis"):
            self.succeed("run", "room", "--n", 12, "--mode", mode, "--light-rule", "thesis", "--dump", mode + ".csv")
            cycles = self.report()["cycles"]
            self.assertEqual(len(cycles["light"]), len(self.report()["sources"]))
        self.succeed("compare", "fast.csv", "thesis.csv")

    def test_every_rule(self):
        voxels = {}
        for rule in ("armoured", "naive", "supercover", "half", "blindee"):
            self.succeed("run", "ball:4", "--n", 10, "--rule", rule)
            voxels[rule] = self.report()["voxels"]
        self.assertLess(voxels["naive"], voxels["armoured"])
        self.assertLess(voxels["naive"], voxels["supercover"])

    def test_the_accurate_light_rule_lights_more(self):
        lit = {}
        for rule in ("thesis", "accurate"):
            self.succeed("run", "room", "--n", 24, "--machine", "golden", "--light-rule", rule)
            self.assertEqual(self.report()["light_rule"], rule)
            lit[rule] = self.report()["lit"][0]
        self.assertGreater(lit["accurate"], lit["thesis"])

    def test_the_error_of_light_is_a_table(self):
        self.succeed("light-error", "boxes", "sheets", "--n", 24, "--reach", "1,2", "--out", "error.csv")
        rows = (self.folder / "error.csv").read_text().splitlines()
        self.assertEqual(len(rows), 1 + 2 * 2 * 2 * 6 * 3)  # scenes, L, rules, lights, sets of voxels

    def test_a_second_run_replaces_the_first(self):
        self.succeed("run", "ball:3", "--n", 8)
        before = (self.folder / "out/picture.exr").read_bytes()
        self.succeed("run", "empty", "--n", 8)
        self.assertNotEqual((self.folder / "out/picture.exr").read_bytes(), before)
        self.assertEqual(self.report()["scene"], "empty")

    def test_facets_and_lights_outside_are_counted(self):
        self.write("three.obj", "v 1 1 1\nv 4 1 1\nv 1 4 1\nv 50 50 50\nv 60 50 50\nv 50 60 50\n"
                   "f 1 2 3\nf 4 5 6\nf 1 1 2\n")
        text = self.succeed("run", "three.obj", "--fit", "none", "--n", 8)
        facets = self.report()["facets"]
        self.assertEqual((facets["read"], facets["loaded"]), (3, 1))
        self.assertEqual((facets["outside"], facets["degenerate"]), (1, 1))
        self.assertIn("1 facets outside the cube dropped", text)

    def test_the_help_names_every_option(self):
        text = self.succeed("run", "--help")
        for option in ("--machine", "--n", "--fit", "--fraction-bits", "--rule", "--light",
                       "--light-rule", "--target-distance", "--fa", "--out", "--dump", "--waves",
                       "--waves-from", "--waves-cycles", "--seed"):
            self.assertIn(option, text)
        self.assertRegex(self.succeed("--version"), r"\A\d+\.\d+\.\d+\n\Z")


class Volume(HostTest):
    def test_an_openvdb_file_beside_the_pictures(self):
        self.succeed("run", "ball:3", "--n", 8, "--volume", "ball.vdb")
        self.assertEqual((self.folder / "ball.vdb").read_bytes()[:4], b" BDV")
        self.assertEqual(self.report()["files"]["volume"], "ball.vdb")
        self.refuse("run", "ball:3", "--n", 8, "--volume", "nowhere/ball.vdb", "--out", "other", says="nowhere/ball.vdb")


if __name__ == "__main__":
    unittest.main()
