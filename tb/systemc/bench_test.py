"""The SystemC benches: right units pass, wrong ones are named, and two models load in one time."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

BENCHES = pathlib.Path(os.environ["RC2_BENCHES"])
MODELS = ("rtl", "cycle")
OUTPUTS = {"machine": ("b", "r", "readback"), "cell": ("words_out", "link0_out", "home")}

REPORT = re.compile(
    r"first difference: cycle (?P<cycle>\d+), (?:cell \((?P<x>\d+),(?P<y>\d+)\)|no cell), "
    r"stream (?P<stream>\w+)\n  expected (?P<expected>[^\n]+)\n  got      (?P<got>[^\n]+)\n\Z")


def bench(unit, *arguments):
    return subprocess.run(
        [BENCHES / f"systemc_{unit}", *map(str, arguments)], capture_output=True, text=True,
        timeout=100, env={**os.environ, "SYSTEMC_DISABLE_COPYRIGHT_MESSAGE": "1"})


class Bench(unittest.TestCase):
    def agree(self, unit, model, *arguments):
        result = bench(unit, "--model", model, *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        self.assertIn("no difference", result.stdout)
        return result.stdout

    def test_every_model_does_what_the_reference_says(self):
        for unit in OUTPUTS:
            for model in MODELS:
                for seed in range(1, 9):
                    with self.subTest(unit=unit, model=model, seed=seed):
                        said = self.agree(unit, model, "--seed", seed, "--jobs", 50)
                        self.assertEqual(said.count("5 of 5 stall patterns"), said.count("beats, "))

    def test_two_models_take_the_same_cycles_under_the_same_stalls(self):
        def cycles(model):
            said = self.agree("machine", model, "--seed", 9, "--jobs", 100)
            return re.search(r"busy cycles[^:]*: ([\d ]+)\n", said)[1].split()

        rtl, cycle = map(cycles, MODELS)
        self.assertGreater(len(rtl), 200)
        self.assertEqual(rtl, cycle)

    def differ(self, unit, model, kind, stream, beat=2):
        """The report of the first beat from this one on that is not free to be what it is."""
        for number in range(beat, beat + 20):
            fault = f"{kind}:{stream}:{number}"
            result = bench(unit, "--model", model, "--jobs", 20, "--fault", fault)
            if result.returncode != 0:
                break
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertIn("A DIFFERENCE", result.stdout)
        report = REPORT.search(result.stdout)
        self.assertTrue(report, result.stdout)
        self.assertNotEqual(report["expected"], report["got"])
        return number, report

    def test_every_fault_of_every_output_is_named(self):
        for unit, streams in OUTPUTS.items():
            for model in MODELS:
                for stream in streams:
                    for kind in ("flip", "drop", "repeat", "withdraw", "hang"):
                        with self.subTest(unit=unit, model=model, stream=stream, kind=kind):
                            _, report = self.differ(unit, model, kind, stream)
                            # What is lost on one stream may be missed first on another.
                            if kind in ("flip", "withdraw"):
                                self.assertEqual(report["stream"], stream)
                            if stream not in ("b", "r") and report["stream"] == stream:
                                self.assertIsNotNone(report["x"])

    def test_the_report_names_cycle_cell_expected_and_got(self):
        beat, wrong = self.differ("machine", "rtl", "flip", "readback")
        _, right = self.differ("machine", "rtl", "hang", "readback", beat)
        self.assertEqual((wrong["x"], wrong["y"]), (right["x"], right["y"]))
        self.assertEqual(wrong["expected"], right["expected"])
        # The beat that hangs is the one that was flipped.
        bits = [int(re.search(r"\(bits ([0-9a-f]+)\)", wrong[side])[1], 16)
                for side in ("expected", "got")]
        self.assertEqual(bits[0] ^ bits[1], 1)
        self.assertLess(int(wrong["cycle"]), int(right["cycle"]))

    def test_waves(self):
        with tempfile.TemporaryDirectory(prefix="rc2-systemc-") as folder:
            for model, endings in (("rtl", {".vcd", ".fst"}), ("cycle", {".vcd"})):
                path = pathlib.Path(folder) / model / "waves"
                self.agree("machine", model, "--jobs", 1, "--waves", path)
                self.assertEqual({file.suffix for file in path.parent.iterdir()}, endings)
                self.assertIn("readback_valid", path.with_suffix(".vcd").read_text())

    def test_bad_input(self):
        for arguments, says in ((("--fault", "flip:readback"), "write KIND:STREAM:BEAT"),
                                (("--fault", "flip:nothing:1"), "it has b r readback"),
                                (("--model", "golden"), "--model"),
                                (("--jobs", "many"), "--jobs")):
            result = bench("machine", *arguments)
            self.assertEqual(result.returncode, 2)
            self.assertIn(says, result.stderr)


if __name__ == "__main__":
    unittest.main()
