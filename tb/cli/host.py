"""The program under test, and the places where a test may write."""

import json
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import unittest

RC2 = os.environ["RC2"]
ROOM = os.environ["RC2_SOURCE_DIR"] + "/sw/scene/room.dae"
MODELS = pathlib.Path("/usr/share/assimp/models")
SANITIZED = os.environ["RC2_SANITIZE"] == "ON"

DONE, DIFFERENT, BAD_INPUT, DISAGREEMENT, BROKEN = range(5)


class HostTest(unittest.TestCase):
    """Runs every test in an empty folder of its own."""

    program = RC2

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="rc2-cli-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def rc2(self, *arguments, environment=None, **options):
        return subprocess.run(
            [self.program, *map(str, arguments)],
            cwd=self.folder,
            env={**os.environ, **(environment or {})},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=120,
            **options,
        )

    def succeed(self, *arguments, **options):
        result = self.rc2(*arguments, **options)
        self.assertEqual((result.returncode, result.stderr), (DONE, ""), arguments)
        return result.stdout

    def fail_with(self, code, *arguments, says="", **options):
        """One line on stderr that holds `says`, nothing on stdout."""
        result = self.rc2(*arguments, **options)
        self.assertEqual(result.returncode, code, (arguments, result.stderr))
        self.assertRegex(result.stderr, r"\Arc2: [^\n]{10,}\n\Z", arguments)
        self.assertIn(says, result.stderr)
        self.assertEqual(result.stdout, "", arguments)
        return result.stderr

    def refuse(self, *arguments, says="", **options):
        """Bad input: one line, and no file or folder that was not there before."""
        before = self.files()
        message = self.fail_with(BAD_INPUT, *arguments, says=says, **options)
        self.assertEqual(self.files(), before, arguments)
        return message

    def files(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def report(self, out="out"):
        return json.loads((self.folder / out / "report.json").read_text())

    def rows(self, name):
        """The header of a dump and its rows as tuples of integers."""
        lines = (self.folder / name).read_text().splitlines()
        return lines[0], [tuple(map(int, line.split(","))) for line in lines[1:]]


def exr_channels(path):
    """Names and pixel types (0 uint, 1 half, 2 float) from the header of an OpenEXR file."""
    data = path.read_bytes()
    assert struct.unpack_from("<I", data)[0] == 20000630

    def word(at):
        end = data.index(b"\0", at)
        return data[at:end].decode(), end + 1

    at, channels = 8, {}
    while data[at] != 0:
        name, at = word(at)
        _, at = word(at)
        size, at = struct.unpack_from("<I", data, at)[0], at + 4
        if name == "channels":
            inner = at
            while data[inner] != 0:
                channel, inner = word(inner)
                channels[channel] = struct.unpack_from("<I", data, inner)[0]
                inner += 16
        at += size
    return channels


def png_size(path):
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack_from(">II", data, 16)
