"""rc2 measure and peers: the benchmark's lines say what the other commands say."""

import csv
import unittest

from host import HostTest


class Bench(HostTest):
    def lines(self, *arguments):
        self.succeed(*arguments, "--out", "lines.csv")
        with open(self.folder / "lines.csv", newline="") as file:
            return list(csv.DictReader(file))

    def test_errors_are_those_of_light_error(self):
        rows = self.lines("measure", "boxes", "--n", 24, "--lights", 6, "--machine", "golden", "--reach", "1,2")
        self.succeed("light-error", "boxes", "--n", 24, "--reach", "1,2", "--out", "error.csv")
        with open(self.folder / "error.csv", newline="") as file:
            expected = {(row["light_x"], row["light_y"], row["light_z"], row["L"], row["rule"], row["population"]): row
                        for row in csv.DictReader(file)}
        self.assertEqual(3 * len(rows), len(expected))
        for row in rows:
            for population in ("facing", "exposed", "seen"):
                other = expected[row["x"], row["y"], row["z"], row["L"], row["light_rule"], population]
                self.assertEqual(row["visits"], other["visits"])
                self.assertEqual(row[population], other["voxels"])
                for kind in ("false_dark", "false_lit", "false_dark_tolerant", "false_lit_tolerant"):
                    self.assertEqual(row[f"{population}_{kind}"], other[kind])

    def test_cycles_are_those_of_run(self):
        rows = self.lines("measure", "shells:10:1", "--n", 12, "--lights", 2, "--machine", "cycle", "--light-rule",
                          "thesis", "--mode", "fast,thesis", "--fa", "1,8", "--fraction-bits", 4)
        self.assertEqual(len(rows), 2 * 2 * 2)
        for row in rows:
            self.succeed("run", "shells:10:1", "--machine", "cycle", "--n", 12, "--mode", row["mode"], "--light",
                         f"{row['x']},{row['y']},{row['z']}", "--target-distance", row["L"], "--fa", row["fa"],
                         "--light-rule", "thesis")
            (light,) = self.report()["sources"]
            self.assertEqual(light["cycles"], int(row["light_cycles"]))

    def test_skipping_saves_work_and_no_light(self):
        on, off = self.lines("measure", "sphere", "--n", 16, "--lights", 1, "--machine", "cycle", "--light-rule", "accurate",
                             "--skip", "on,off")
        self.assertEqual((on["skip"], off["skip"]), ("on", "off"))
        self.assertEqual(on["facing_false_dark"], off["facing_false_dark"])
        self.assertLess(int(on["visits"]), int(off["visits"]))

    def test_few_bits_widen_the_voxels(self):
        voxels = [int(self.lines("measure", "boxes", "--n", 24, "--lights", 1, "--machine", "golden", *bits)[0]["voxels"])
                  for bits in (("--coefficient-bits", 3), ("--coefficient-bits", 5), ())]
        self.assertEqual(voxels, sorted(voxels, reverse=True))
        self.assertGreater(voxels[0], voxels[2])

    def test_machines_agree_and_rays_are_nearly_right(self):
        machines = self.lines("measure", "sphere", "--n", 32, "--lights", 2, "--light-rule", "thesis")
        errors = {}
        for row in machines:
            errors.setdefault(row["light"], set()).add((row["facing_false_dark"], row["facing_false_lit"], row["rmse"]))
        self.assertEqual([len(of) for of in errors.values()], [1, 1])
        peers = self.lines("peers", "sphere", "--n", 32, "--lights", 2)
        methods = {row["method"]: row for row in peers}
        self.assertEqual(set(methods), {"openvdb-0.5", "openvdb-0.867", "direct", "embree-1", "embree-8", "walk",
                                        "walk-leaving", "sweep"})
        for name in ("embree-1", "embree-8"):
            row = methods[name]
            self.assertLess(int(row["facing_false_dark"]) + int(row["facing_false_lit"]), 0.01 * int(row["facing"]))
        for name in ("direct", "openvdb-0.867"):
            self.assertEqual((methods[name]["tunnels_26"], float(methods[name]["uncovered_percent"])), ("0", 0.0))
        self.assertGreater(int(methods["openvdb-0.5"]["tunnels_26"]), 0)

    def test_what_cannot_be_measured_is_said(self):
        text = self.succeed("measure", "sphere", "--n", 16, "--lights", 1, "--rule", "naive", "--out", "lines.csv")
        self.assertIn("2 lights measured, 2 skipped", text)
        self.refuse("measure", "empty", "--n", 16, "--out", "other.csv", says="nothing to light")
        self.refuse("peers", "sphere", "--n", 4, "--out", "other.csv", says="--n")


if __name__ == "__main__":
    unittest.main()
