"""rc2 network."""

import json
import unittest

from host import HostTest


class Network(HostTest):
    def measures(self, *arguments):
        return dict(map(str.split, self.succeed("network", *arguments).splitlines()))

    def test_it_prints_measures_and_writes_nothing_unasked(self):
        found = self.measures("segments", 32, "tree")
        self.assertEqual((found["cells"], found["depth"]), ("561", "5"))
        self.assertNotIn("straight_crossings", found)
        self.assertEqual(self.files(), [])

    def test_planarity_is_counted_on_request(self):
        found = self.measures("circles", 32, "chain", "--planarity")
        self.assertEqual((found["straight_crossings"], found["page_crossed"]), ("0", "0"))

    def test_it_writes_hardware_and_description(self):
        for shape, scheme, name in (("circles", "star", "circles_star"), ("segments", "tree:3", "segments_tree_3")):
            found = self.measures(shape, 9, scheme, "--out", "deep/folder")
            text = (self.folder / "deep/folder" / f"{name}.v").read_text()
            self.assertIn(f"module {name} (", text)
            described = json.loads((self.folder / "deep/folder" / f"{name}.json").read_text())
            self.assertEqual(len(described["starts"]), 10)
            self.assertEqual(len(described["links"]), int(found["links"]))
            self.assertEqual(text.count("  wire c_"), len(described["cells"]))

    def test_bad_input(self):
        self.refuse("network", "ellipses", 8, "tree", says="ellipses")
        self.refuse("network", "circles", 0, "tree", says="size 0")
        self.refuse("network", "circles", 1025, "tree", says="1024")
        self.refuse("network", "segments", "many", "tree", says="size")
        self.refuse("network", "segments", 8, "tree:0", says="tree:0")
        self.refuse("network", "segments", 8, says="scheme")
        self.refuse("network", "segments", 8, "tree", "--out", "/proc/nowhere", says="/proc/nowhere")


if __name__ == "__main__":
    unittest.main()
