"""What checks the report sees what would be wrong with it."""

import os
import pathlib
import shutil
import subprocess
import unittest

from host import HostTest

CHECK = pathlib.Path(os.environ["RC2_SOURCE_DIR"]) / "scripts/report/check"
PAGE = """<!doctype html><meta charset="utf-8"><body data-pixels="{pixels}" data-waving="20000">{body}
<script>{script}; document.body.dataset.ready = "yes"</script></html>"""


@unittest.skipIf(shutil.which("chromium") is None, "make report installs chromium")
class Check(HostTest):
    def check(self, pixels=20000, body="", script="0"):
        self.write("page.html", PAGE.format(pixels=pixels, body=body, script=script))
        ran = subprocess.run([CHECK, self.folder / "page.html"], capture_output=True, text=True, timeout=200)
        return ran.returncode, ran.stdout

    def test_a_good_page(self):
        self.assertEqual(self.check()[0], 0)

    def test_bad_pages(self):
        for words, says in (({"script": "console.error('no good')"}, "no good"), ({"script": "nothing.at.all"}, "end"),
                            ({"body": '<img src="http://localhost/picture.png" alt="">'}, "outside"),
                            ({"pixels": 7}, "drew 7 pixels")):
            with self.subTest(says):
                code, said = self.check(**words)
                self.assertEqual(code, 1)
                self.assertIn(says, said)


if __name__ == "__main__":
    unittest.main()
