"""The benchmark's workflow hands its jobs to a cluster as the profile says: SLURM, played by a script."""

import csv
import os
import pathlib
import shutil
import subprocess
import unittest

from host import RC2, HostTest

BENCH = pathlib.Path(os.environ["RC2_SOURCE_DIR"]) / "scripts/bench"
SBATCH = """#!/bin/sh
echo "$@" >>submitted.txt
for script; do :; done
sh "$script" >job.log 2>&1
echo 17
"""


@unittest.skipIf(shutil.which("snakemake") is None, "make bench installs snakemake")
class Cluster(HostTest):
    def workflow(self, *words, full=0):
        path = f"{self.folder}:{os.environ['PATH']}"
        return subprocess.run(
            ["snakemake", "--snakefile", BENCH / "Snakefile", "--directory", self.folder, *words, "--config",
             f"out={self.folder}/out", "seed=7", f"full={full}", f"program={RC2}"],
            env={**os.environ, "PATH": path}, capture_output=True, text=True, timeout=200)

    def test_a_job_goes_through_sbatch_and_is_not_done_twice(self):
        self.write("sbatch", SBATCH)
        (self.folder / "sbatch").chmod(0o755)
        job = f"{self.folder}/out/jobs/peers-dust-16.csv"
        words = (job, "--profile", BENCH / "slurm", "--latency-wait", "5")
        ran = self.workflow(*words)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        submitted = (self.folder / "submitted.txt").read_text()
        self.assertEqual(submitted.count("--job-name=rc2-job"), 1)
        self.assertRegex(submitted, r"--cpus-per-task=1 --mem=\d+ --time=\d+ ")
        with open(job, newline="") as file:
            self.assertEqual({row["scene"] for row in csv.DictReader(file)}, {"dust:1:7"})
        again = self.workflow(*words)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual((self.folder / "submitted.txt").read_text(), submitted)

    def test_the_large_one_has_more_to_do(self):
        def jobs(full):
            ran = self.workflow("--dry-run", "--quiet", "--cores", "1", full=full)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            return int(ran.stdout.split("\ntotal")[1].split()[0])

        self.assertGreater(jobs(1), jobs(0))


if __name__ == "__main__":
    unittest.main()
