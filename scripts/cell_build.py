"""What a cell is built for, in scripts/area and all that reads what it writes."""

import dataclasses
import os

from synthesis import Design

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
CELLS = {"fast": "rc2_cell", "thesis": "rc2_cell_thesis"}
SIDE, QUEUE, REACH, FRACTION = 64, 8, 2, 4  # where one is varied the others are these; L = REACH sides


@dataclasses.dataclass(frozen=True)
class Build:
    """What a cell is built for."""

    mode: str
    n: int = SIDE
    fa: int = QUEUE
    reach: int = REACH
    f: int = FRACTION
    layers: int = 0
    skips: int = 1
    rays: int = 0

    def design(self, folder, top, apart=()):
        return Design(ROOT, folder, top, {
            "N": self.n, "F": self.f, "LMAX": self.reach * self.n, "FAMAX": self.fa, "THESIS": int(self.mode == "thesis"),
            "LAYERS": self.layers, "COUNTS": 0, **({} if self.skips else {"SKIPS": 0}), **({"RAYS": 1} if self.rays else {})}, apart)

    @property
    def shared(self):
        """Of the column and the axes, which are the same in both cells and for all queues."""
        return dataclasses.replace(self, mode="fast", fa=QUEUE)
