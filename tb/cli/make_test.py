"""What `make help` promises, make knows; what it does not know it refuses."""

import os
import re
import subprocess
import unittest

ROOT = os.environ["RC2_SOURCE_DIR"]


def make(*words):
    # `make test` hands its own words on.
    alone = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    return subprocess.run(["make", "-C", ROOT, "--no-print-directory", *words], env=alone, capture_output=True, text=True,
                          timeout=60)


class Make(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.help = make("help").stdout

    def test_every_target_is_there(self):
        listed = self.help.split("Targets\n")[1].split("\n\n")[0]
        targets = re.findall(r"^  ([a-z0-9-]+)  ", listed, re.M)
        self.assertGreater(len(targets), 25)
        with open(f"{ROOT}/Makefile", encoding="utf-8") as file:
            phony = set(re.search(r"^\.PHONY: (.*)$", file.read(), re.M)[1].split())
        self.assertEqual(set(targets), phony)
        for target in targets:
            with self.subTest(target=target):
                self.assertEqual(make("-n", target, "RC2_SKIP_SETUP=1").returncode, 0)

    def test_every_word_is_taken(self):
        words = set(re.findall(r"\b([A-Z]+=[a-z0-9]*)", self.help.split("Words for sim")[1].split("Examples")[0]))
        self.assertGreater(len(words), 12)
        for word in words:
            with self.subTest(word=word):
                taken = make("-n", "help", word)
                self.assertEqual(taken.returncode, 0, taken.stderr)

    def test_a_word_that_is_not_known_is_refused(self):
        refused = make("-n", "help", "SCNEE=room")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("no word SCNEE", refused.stderr)


if __name__ == "__main__":
    unittest.main()
