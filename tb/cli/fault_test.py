"""rc2 run --machine rtl with a machine that is wrong on purpose."""

import os
import pathlib
import pty
import re
import shutil
import subprocess
import tempfile
import unittest

from host import BROKEN, DISAGREEMENT, RC2, HostTest

RUN = ("run", "ball:3", "--machine", "rtl", "--n", 8, "--light", "0,0,0")


class Fault(HostTest):
    @classmethod
    def setUpClass(cls):
        # The program looks for the machine beside itself.
        cls.home = pathlib.Path(tempfile.mkdtemp(prefix="rc2-cli-"))
        cls.addClassCleanup(shutil.rmtree, cls.home)
        cls.program = shutil.copy(RC2, cls.home / "rc2")
        (cls.home / "rtl").mkdir()
        shutil.copy(os.environ["RC2_FAULTY_MACHINE"], cls.home / "rtl/librc2_rtl_n8.so")

    def disagree(self, fault, **expected):
        result = self.rc2(*RUN, "--dump", "dump.csv", environment={"RC2_TEST_FAULT": fault})
        self.assertEqual(result.returncode, DISAGREEMENT, result.stderr)
        self.assertRegex(result.stderr, r"\Arc2: rtl disagrees with the golden model[^\n]*\n\Z")
        agreement = self.report()["agreement"]
        counts = {name: agreement[name + "_differing"] for name in ("voxels", "owners", "lights")}
        self.assertEqual(counts, {"voxels": 0, "owners": 0, "lights": 0, **expected})
        self.assertIn("DISAGREES", result.stdout)
        for difference in agreement["first"]:
            voxel = "({},{},{})".format(*difference["voxel"])
            self.assertIn(f"voxel {voxel}, {difference['what']}: expected ", result.stdout)
        self.assertTrue((self.folder / "dump.csv").is_file())
        return agreement["first"]

    def test_without_a_fault_all_is_well(self):
        self.succeed(*RUN)

    def test_a_wrong_count_of_light(self):
        first, second = self.disagree("light", lights=2)
        self.assertEqual(first["got"], first["expected"] + 1)
        self.assertEqual(second["got"], second["expected"] - 1)

    def test_a_wrong_owner(self):
        self.assertEqual(self.disagree("owner", owners=1)[0]["what"], "facet")

    def test_a_lost_voxel(self):
        first = self.disagree("voxel", voxels=1, lights=1)[0]
        self.assertEqual((first["what"], first["got"]), ("facet", None))

    def difference(self, fault):
        result = self.rc2("difference", "ball:3", "--n", 8, "--light", "0,0,0", "--waves", "d.fst",
                          environment={"RC2_TEST_FAULT": fault})
        self.assertEqual(result.stderr, "")
        return result

    def test_without_a_fault_there_is_no_difference(self):
        result = self.difference("")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stdout, r"\Ano difference: \d+ voxels, 1 lights, 64 cells in each of \d\d cycles\n\Z")
        self.assertEqual(self.files(), [])

    def test_the_first_difference_is_named_and_shown(self):
        result = self.difference("queue")
        self.assertEqual(result.returncode, DISAGREEMENT)
        self.assertIn("first difference: light 0 at (0,0,0), cycle 9 (109 since the reset of rtl), cell (3,2)\n", result.stdout)
        before, then = result.stdout.split("queues around it then")
        self.assertNotIn("!", before)
        (expected, got), = re.findall(r"(\d+)/(\d+)!", then)
        self.assertEqual(int(got), int(expected) + 1)
        self.assertIn("60 cycles from 89 on", result.stdout)
        self.assertIn("d.fst", self.files())

    def test_light_that_differs_without_a_queue_is_named_too(self):
        result = self.difference("light")
        self.assertEqual(result.returncode, DISAGREEMENT)
        voxel = re.search(r"rtl and golden: voxel \((\d),(\d),(\d)\), light0: expected", result.stdout)
        self.assertIn(f"column ({voxel[1]},{voxel[2]}) in the end", result.stdout)

    def test_a_light_that_takes_longer_is_a_difference(self):
        result = self.difference("late")
        self.assertEqual(result.returncode, DISAGREEMENT)
        expected, got = re.fullmatch(r"  light 0: (\d+) cycles on the cycle model, (\d+) on rtl\n", result.stdout).groups()
        self.assertEqual(int(got), int(expected) + 1)

    def break_a_law(self, fault, says):
        self.fail_with(BROKEN, *RUN, "--light-rule", "thesis", "--dump", "dump.csv", says=says,
                       environment={"RC2_TEST_FAULT": fault})
        self.assertEqual(self.files(), [])

    def test_a_lost_target(self):
        self.break_a_law("target", "conservation is broken")

    def test_a_target_counted_twice(self):
        self.break_a_law("count", "conservation is broken")

    def test_an_unknown_owner(self):
        self.break_a_law("unknown owner", "facet 1048575")

    def test_jobs_too_large_for_the_machine(self):
        for option, value, limit in (("--fraction-bits", 5, 4), ("--target-distance", 33, 32),
                                     ("--fa", 33, 32)):
            message = self.refuse(*RUN, option, value, says=f"{option} {value}")
            self.assertIn(f"at most {limit}", message)
            self.assertIn("make rtl N=8", message)
        self.succeed(*RUN, "--fraction-bits", 4, "--target-distance", 32, "--fa", 32)

    def test_a_size_that_was_not_built(self):
        self.refuse("run", "ball:3", "--machine", "rtl", "--n", 9, says="make rtl N=9")

    def test_waves(self):
        self.succeed(*RUN, "--waves", "waves.fst")
        self.assertEqual(self.report()["files"]["waves"], "waves.fst")
        self.assertIn("waves.fst", self.files())

    def test_a_failed_run_leaves_no_waves(self):
        self.fail_with(BROKEN, *RUN, "--waves", "waves.fst",
                       environment={"RC2_TEST_FAULT": "target"})
        self.assertEqual(self.files(), [])
        self.refuse(*RUN, "--waves", "no/waves.fst", says="no/waves.fst")

    def test_waves_that_start_too_late(self):
        result = self.rc2(*RUN, "--waves", "waves.fst", "--waves-from", 1000)
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"\Arc2: there is no waveform[^\n]* 1000\n\Z")
        self.assertNotIn("waves", self.report()["files"])

    def test_a_long_step_shows_its_progress_on_a_terminal(self):
        ours, theirs = pty.openpty()
        done = subprocess.run([self.program, *map(str, RUN)], cwd=self.folder, stderr=theirs,
                              stdout=subprocess.DEVNULL, timeout=60,
                              env={**os.environ, "RC2_TEST_FAULT": "slow"})
        os.close(theirs)
        self.assertEqual(done.returncode, 0)
        shown = os.read(ours, 4096).decode()
        os.close(ours)
        self.assertRegex(shown, r"\[#{10}-{10}\] light 1 of 1 on rtl: 50 %, 5000 cycles, \d+ cycles/s"
                                r", \d+ s left")
        self.assertTrue(shown.endswith("\r\033[K"), shown)

    def test_no_memory(self):
        self.refuse(*RUN, says="--n 8: there is not enough memory",
                    environment={"RC2_TEST_FAULT": "no memory"})


if __name__ == "__main__":
    unittest.main()
