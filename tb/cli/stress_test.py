"""Files with nasty numbers: read or refused, never anything else."""

import os
import sys
import unittest

sys.path.insert(0, os.environ["RC2_SOURCE_DIR"] + "/scripts")
import stress_files
from host import RC2


class Files(unittest.TestCase):
    def test_all(self):
        tried = 0
        for name, machine, _, said, wrong in stress_files.try_all(RC2):
            tried += 1
            with self.subTest(name=name, machine=machine):
                self.assertEqual(wrong, "", said)
        self.assertGreater(tried, 80)


if __name__ == "__main__":
    unittest.main()
