"""rc2_platform writes what rc2 run writes, and its time is the machine's."""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

BUILD = pathlib.Path(os.environ["RC2_BUILD"])
ROOM = os.environ["RC2_SOURCE_DIR"] + "/sw/scene/room.dae"
FILES = ("picture.png", "picture.exr", "dump.csv")


class Platform(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="rc2-tlm-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, program, *arguments):
        return subprocess.run(
            [BUILD / program, *map(str, arguments)], cwd=self.folder, capture_output=True,
            text=True, timeout=120, env={**os.environ, "SYSTEMC_DISABLE_COPYRIGHT_MESSAGE": "1"})

    def output(self, program, machine, *arguments):
        out = self.folder / program / machine
        command = ("run",) if program == "rc2" else ()
        result = self.run_program(program, *command, *arguments, "--machine", machine, "--out", out,
                                  "--dump", out / "dump.csv")
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        return result.stdout, [(out / name).read_bytes() for name in FILES]

    def nanoseconds(self, said):
        number, unit = re.search(r", (\d+) ([nu]s) of simulated time", said).groups()
        return int(number) * {"ns": 1, "us": 1000}[unit]

    def test_it_renders_the_default_scene_as_the_program_does(self):
        times = {}
        for machine in ("golden", "cycle", "rtl"):
            said, files = self.output("rc2_platform", machine, ROOM, "--n", 16)
            _, expected = self.output("rc2", machine, ROOM, "--n", 16)
            for name, ours, theirs in zip(FILES, files, expected):
                self.assertEqual(ours, theirs, (machine, name))
            times[machine] = self.nanoseconds(said)
        # Golden takes no time of its own; the rest is the way to the machine and back.
        self.assertEqual(times["rtl"], times["cycle"])
        self.assertGreater(times["cycle"], times["golden"])

    def test_its_time_is_the_machine_s(self):
        scene = ("ball:3", "--n", 8, "--light", "0,0,0", "--light", "7,7,7")
        golden, _ = self.output("rc2_platform", "golden", *scene)
        cycle, _ = self.output("rc2_platform", "cycle", *scene)
        out = self.folder / "report"
        self.assertEqual(self.run_program("rc2", "run", *scene, "--out", out).returncode, 0)
        report = json.loads((out / "report.json").read_text())
        cycles = report["cycles"]["load"] + sum(
            one["prepare_cycles"] + one["cycles"] for one in report["sources"])
        self.assertEqual(self.nanoseconds(cycle) - self.nanoseconds(golden), 10 * cycles)

    def test_bad_input(self):
        for arguments, says in ((("nothing.obj",), "nothing.obj"),
                                (("ball:3", "--n", 8, "--light", "3,3,0"), "occupied"),
                                (("ball:3", "--wrong"), "--wrong")):
            result = self.run_program("rc2_platform", *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
            self.assertRegex(result.stderr, r"\Arc2_platform: [^\n]+\n\Z")
            self.assertIn(says, result.stderr)


if __name__ == "__main__":
    unittest.main()
