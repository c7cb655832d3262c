"""rc2 diffusion, queues: how long light takes, and how deep the queues are."""

import csv
import unittest

from host import HostTest, png_size


class Diffusion(HostTest):
    def lights(self, *arguments):
        text = self.succeed("diffusion", *arguments, "--out", "lights.csv")
        with open(self.folder / "lights.csv", newline="") as file:
            return list(csv.DictReader(file)), text

    def test_the_machine_that_run_runs(self):
        rows, text = self.lights("shells:10:1", "--n", 12, "--fa", "1,8")
        self.assertEqual(len(rows), 2 * 3 * 2 * 2)
        for row in rows:
            self.succeed("run", "shells:10:1", "--machine", "cycle", "--n", 12, "--mode", row["mode"],
                         "--light", f"{row['x']},{row['y']},{row['z']}", "--target-distance", row["L"],
                         "--fa", row["fa"], "--light-rule", "thesis")
            (light,) = self.report()["sources"]
            self.assertEqual(light["cycles"], int(row["T"]))
            self.assertEqual(light["beams"], {"visits": int(row["visits"]), "merged": int(row["merged"]),
                                              "max_queue": int(row["deepest"])})
            self.assertRegex(text, rf"\b{row['T']}\b")

    def test_the_accurate_rule_beside_the_thesis_s(self):
        rows, _ = self.lights("room", "--n", 16, "--light-rule", "thesis,accurate")
        self.assertEqual([row["rule"] for row in rows if row["mode"] == "thesis"], ["thesis"] * 6)
        fast = [row for row in rows if row["mode"] == "fast"]
        self.assertEqual([row["rule"] for row in fast], ["thesis", "accurate"] * 6)
        for row in fast:
            self.assertEqual(row["prepare"] == "0", row["rule"] == "thesis")
            self.succeed("run", "room", "--machine", "cycle", "--n", 16, "--light-rule", row["rule"], "--light",
                         f"{row['x']},{row['y']},{row['z']}", "--target-distance", row["L"], "--fa", row["fa"])
            cycles = self.report()["cycles"]
            self.assertEqual(cycles["light"] + cycles["prepare"], [int(row["T"]), int(row["prepare"])])

    def test_sources_bounds_and_excess(self):
        rows, _ = self.lights("empty", "dust:3:1", "--n", "8,9", "--fa", 4, "--skip", "off")
        for row in rows:
            n, fast = int(row["n"]), row["mode"] == "fast"
            place = [int(row[axis]) for axis in "xyz"]
            if row["scene"] == "empty":
                self.assertEqual(place, {"centre": [n // 2] * 3, "corner": [0] * 3}.get(row["source"], place))
            kmax = max(max(at, n - 1 - at) for at in place)
            self.assertEqual(int(row["kmax"]), kmax)
            self.assertEqual(int(row["P"]), 2 if fast else 3)
            self.assertEqual(int(row["bound"]), int(row["P"]) * (kmax + 1))
            self.assertEqual(int(row["excess"]), int(row["T"]) - int(row["bound"]))
            self.assertIn(int(row["L"]), (n - 1, 2 * n))
            if fast:
                self.assertGreaterEqual(int(row["excess"]), -1)

    def test_skipping_saves_visits_where_little_is_in_the_way(self):
        rows, _ = self.lights("ball:1", "--n", "16", "--mode", "fast", "--skip", "on,off")
        for on, off in zip(rows[:len(rows) // 2], rows[len(rows) // 2:]):
            self.assertEqual((on["skip"], off["skip"]), ("on", "off"))
            self.assertEqual([on[key] for key in "xyzL"], [off[key] for key in "xyzL"])
            self.assertLess(2 * int(on["visits"]), int(off["visits"]))

    def test_bad_input(self):
        self.refuse("diffusion", says="SCENE")
        self.refuse("diffusion", "nowhere.obj", says="nowhere.obj")
        for option, value in (("--n", 1), ("--n", 1025), ("--fa", 0), ("--fa", 65), ("--mode", "slow")):
            with self.subTest(option=option, value=value):
                self.refuse("diffusion", "empty", option, value, says=option)
        self.refuse("diffusion", "empty", "--n", 4, "--out", "no/folder.csv", says="no/folder.csv")


class Queues(HostTest):
    def test_a_row_for_each_time_a_column_for_each_scene_and_mode(self):
        out = self.succeed("queues", "empty", "dust:3:1", "--n", 16, "--times", "8,16,24", "--out", "q.png")
        self.assertEqual([line.rsplit(":", 1)[0] for line in out.splitlines()],
                         ["empty, fast", "empty, thesis", "dust:3:1, fast", "dust:3:1, thesis"])
        width, height = png_size(self.folder / "q.png")
        self.assertTrue(4 * 128 < width < 5.5 * 128 and 3 * 128 < height < 4 * 128, (width, height))

    def test_bad_input(self):
        self.refuse("queues", "empty", says="--out")
        self.refuse("queues", "empty", "--n", 129, "--out", "q.png", says="--n")
        self.refuse("queues", "empty", "--times", 0, "--out", "q.png", says="--times")
        self.refuse("queues", "empty", "--n", 8, "--out", "no/q.png", says="no/q.png")


if __name__ == "__main__":
    unittest.main()
