"""rc2 render, render-error: pictures by rays."""

import csv
import unittest

from host import ROOM, SANITIZED, HostTest, exr_channels, png_size


class Render(HostTest):
    def render(self, *arguments):
        text = self.succeed("render", *arguments)
        return self.report(), text

    def test_report_holds_the_laws(self):
        report, text = self.render("gallery", "--n", 24, "--depth", 3)
        rays = report["rays"]
        self.assertEqual(len(rays["issued"]), 4)
        self.assertEqual(rays["issued"][0], 24 * 24)
        self.assertEqual(sum(rays["issued"]), rays["hits"] + rays["escaped"])
        self.assertLessEqual(rays["rescued"], rays["hits"])
        self.assertTrue(report["unused_camera"])
        self.assertIn("camera is not used", text)
        self.assertEqual(png_size(self.folder / "out/picture.png"), (528, 528))
        self.assertEqual(set(exr_channels(self.folder / "out/picture.exr")),
                         {"R", "G", "B", "Z", "N.X", "N.Y", "N.Z", "facet.id", "light0", "light1"})

    def test_progressive_writes_every_stage(self):
        self.render("gallery", "--n", 16, "--depth", 2, "--progressive")
        stages = ["0-loaded", "1-depth-0", "2-depth-1", "picture"]
        self.assertEqual(self.files(), sorted(
            ["out", "out/report.json"] + [f"out/{stage}.{kind}" for stage in stages for kind in ("exr", "png")]))
        pictures = {(self.folder / f"out/{stage}.png").read_bytes() for stage in stages}
        self.assertEqual(len(pictures), len(stages))

    def test_dump_is_that_of_run(self):
        self.succeed("run", "gallery", "--n", 12, "--machine", "golden", "--fraction-bits", 6, "--rule", "armoured",
                     "--dump", "run.csv", "--out", "run")
        report, _ = self.render("gallery", "--n", 12, "--dump", "render.csv")
        self.assertIn("render.csv", report["files"])
        voxels = [[row[:5] for row in self.rows(name)[1]] for name in ("run.csv", "render.csv")]
        self.assertEqual(*voxels)

    def test_camera_of_the_scene(self):
        for scene in "gallery", ROOM:
            front, _ = self.render(scene, "--n", 16)
            camera, text = self.render(scene, "--n", 16, "--view", "camera")
            self.assertNotEqual(front["rays"], camera["rays"])
            self.assertFalse(camera["unused_camera"])
            self.assertNotIn("camera is not used", text)

    def test_depth_and_weight_end_branches(self):
        shallow, _ = self.render("gallery", "--n", 16, "--depth", 0)
        self.assertEqual(shallow["rays"]["issued"], [256])
        self.assertGreater(shallow["rays"]["too_deep"], 0)
        heavy, _ = self.render("gallery", "--n", 16, "--least-weight", 1)
        self.assertEqual(sum(heavy["rays"]["issued"]), 256)
        self.assertGreater(heavy["rays"]["too_light"], 0)

    def test_the_network_finds_what_golden_finds(self):
        golden, _ = self.render("gallery", "--n", 20, "--depth", 3)
        picture = (self.folder / "out/picture.exr").read_bytes()
        self.assertEqual(golden["traffic"]["cycles"], 0)
        for queue in 1, 3:
            cycle, text = self.render("gallery", "--n", 20, "--depth", 3, "--machine", "cycle", "--queue", queue)
            self.assertEqual(cycle["rays"], golden["rays"])
            self.assertTrue(cycle["agrees_with_golden"])
            self.assertIn("in every hit", text)
            traffic = cycle["traffic"]
            self.assertEqual(traffic["run_on"] + traffic["sent_again"], sum(cycle["rays"]["issued"][1:]))
            self.assertGreaterEqual(traffic["cycles"], max(traffic["busiest"], traffic["latency"]))
        self.assertEqual((self.folder / "out/picture.exr").read_bytes(), picture)

    @unittest.skipIf(SANITIZED, "there is no Verilated array")
    def test_the_verilated_array_finds_it_too(self):
        for view in "front", "camera":
            job = ["gallery", "--n", 4, "--light", "1,2,2", "--depth", 3, "--view", view, "--queue", 1]
            cycle, _ = self.render(*job, "--machine", "cycle")
            rtl, text = self.render(*job, "--machine", "rtl")
            self.assertIn("in every hit", text)
            self.assertEqual(rtl["rays"], cycle["rays"])
            for what in "cycles", "busiest", "hops", "run_on", "sent_again":
                self.assertEqual(rtl["traffic"][what], cycle["traffic"][what], what)

    def test_traffic(self):
        text = self.succeed("ray-traffic", "gallery", "--n", "12,16", "--depth", "0,2", "--queue", "1,2", "--out", "t.csv")
        with open(self.folder / "t.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 2 * 2 * 2)
        for row in rows:
            self.assertRegex(text, rf"\b{row['T']}\b")
            if row["depth"] == "0":
                self.assertEqual((row["hops"], row["rays"]), ("0", str(int(row["n"]) ** 2)))
        mirrors = self.succeed("ray-traffic", "gallery", "--n", 12, "--all-mirrors", "--depth", 2, "--queue", 1)
        self.assertNotIn(mirrors.splitlines()[1], text)
        self.succeed("ray-traffic", "gallery", "--n", 12, "--looks", "1,2", "--arithmetic", 2, "--depth", 2, "--queue", 1,
                     "--out", "u.csv")
        with open(self.folder / "u.csv", newline="") as file:
            self.assertEqual([(row["looks"], row["arithmetic"]) for row in csv.DictReader(file)], [("1", "2"), ("2", "2")])

    def test_bad_input(self):
        self.refuse("ray-traffic", "ball:4", "--n", 16, "--queue", 0, says="--queue")
        self.refuse("ray-traffic", "ball:4", "--n", 16, "--looks", 3, says="--looks")
        self.refuse("ray-traffic", "ball:4", "--n", 16, "--view", "camera", says="has no camera")
        self.refuse("render", "ball:4", "--n", 16, "--queue", 0, says="--queue")
        if not SANITIZED:
            rtl = ["render", "ball:1.5", "--n", 4, "--machine", "rtl"]
            self.refuse(*rtl, "--depth", 5, says="--depth 5")
            self.refuse(*rtl, "--queue", 3, says="--queue 3")
            self.refuse("render", "ball:3", "--n", 9, "--machine", "rtl", says="rtl_rays_n9")
        self.refuse("render", "ball:4", "--n", 16, "--view", "camera", says="has no camera")
        self.refuse("render", "ball:4", "--n", 16, "--depth", 8, says="--depth")
        self.refuse("render", "ball:4", "--n", 16, "--least-weight", "1.5", says="--least-weight 1.5")
        self.refuse("render", "ball:4", "--n", 16, "--least-weight", "nan", says="--least-weight")
        self.refuse("render", "ball:4", "--n", 16, "--rule", "naive", says="--rule naive")
        self.refuse("render", "nothing.obj", says="nothing.obj")
        self.refuse("render", "ball:4", "--n", 16, "--light", "8,8,4", says="occupied")
        (self.folder / "file").write_text("")
        self.refuse("render", "ball:4", "--n", 16, "--out", "file", says="--out file")

    def test_error_falls_with_n(self):
        self.succeed("render-error", "gallery", "--n", "16,64", "--depth", "0,1", "--out", "error.csv")
        with open(self.folder / "error.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 2 * (1 + 2 * 2))
        coarse, fine = ([row for row in rows if row["n"] == n] for n in ("16", "64"))
        for a, b in zip(coarse, fine):
            for column in "wrong_percent", "rmse", "flip":
                self.assertLess(float(b[column]), float(a[column]), (column, b["depth"]))
        self.assertLess(float(fine[0]["gross_percent"]), 0.5)
        self.assertGreater(float(fine[0]["straight_percent"]), 97)
        self.assertEqual([row["smooth"] for row in fine], ["1", "0", "0", "0", "0"])
        one_bounce = next(row for row in fine if row["depth"] == "1" and row["shadows"] == "0")
        self.assertLess(float(one_bounce["wrong_percent"]), 4)


if __name__ == "__main__":
    unittest.main()
