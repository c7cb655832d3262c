"""rc2 lines and rc2 tunnels."""

import struct
import unittest

from host import HostTest


ALGORITHMS = ("bresenham", "dda", "dichotomic", "loceff", "amanatides-woo")


class Lines(HostTest):
    def test_each_algorithm_has_a_row(self):
        text = self.succeed("lines", "--from", "0,0,0", "--to", "9,4,7")
        rows = {row[0]: row[1:] for row in map(str.split, text.splitlines()) if len(row) == 6}
        self.assertLessEqual(set(ALGORITHMS), set(rows))
        for name in ALGORITHMS[:4]:
            self.assertEqual(rows[name][1:3], ["10", "26"])
        self.assertEqual(rows["amanatides-woo"][1:3], ["21", "6"])
        self.assertEqual(rows["dda"][3], "0")
        self.assertEqual(rows["loceff"][3], "0")
        self.assertEqual(self.files(), [])

    def test_a_single_voxel_is_a_segment(self):
        text = self.succeed("lines", "--from", "5,5,5", "--to", "5,5,5")
        self.assertEqual(text.count("nan"), 0)

    def test_the_picture_holds_every_algorithm(self):
        for end in ("20,3,5", "3,3,30", "1023,1023,0", "0,0,0"):
            self.succeed("lines", "--to", end, "--out", "lines.png")
            with open(self.folder / "lines.png", "rb") as file:
                head = file.read(24)
            self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
            width, height = struct.unpack(">II", head[16:])
            self.assertEqual(width * height % len(ALGORITHMS), 0)

    def test_bad_input(self):
        self.refuse("lines", "--from", "1,2", says="--from")
        self.refuse("lines", "--to", "1,2,1024", says="--to")
        self.refuse("lines", "--to", "a,b,c", says="--to")
        self.refuse("lines", "--out", "no/folder.png", says="no/folder.png")
        self.refuse("lines", "extra", says="extra")


class Tunnels(HostTest):
    def test_the_wrong_entries_are_marked(self):
        text = self.succeed("tunnels")
        marked = [line for line in text.splitlines() if "no <> yes" in line]
        self.assertEqual([line.split()[0] for line in marked], ["18", "26"] * 2)
        self.assertNotIn("yes <>", text)


if __name__ == "__main__":
    unittest.main()
