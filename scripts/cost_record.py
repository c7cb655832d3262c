"""What stands in docs/cost.json, as its tables and pictures want it."""

from cell_build import FRACTION, QUEUE, REACH, SIDE
from synthesis import NAND2

MODES = {"thesis": "thesis", "fast": "lanes"}
MEMORY_BIT = 1.0  # GE of a bit of a small memory with its share of decoders: an estimate
STANDARD = {"n": SIDE, "fa": QUEUE, "reach": REACH, "f": FRACTION, "layers": 0}


def table(head, rows):
    yield "| " + " | ".join(head) + " |"
    yield "|" + "---|" * len(head)
    for row in rows:
        yield "| " + " | ".join(str(of) for of in row) + " |"
    yield ""


def kilo_gates(area):
    return area / NAND2 / 1000


def kilo(area):
    return f"{kilo_gates(area):.2f}"


def light_area(of):
    return of["light"]["area"] + of["share"]


def cell_area(of):
    """um2 with memories."""
    bits = of["voxels"]["memory_bits"] + of["light"]["memory_bits"]
    return light_area(of) + of["voxels"]["area"] + bits * MEMORY_BIT * NAND2


def path(of):
    return f"{of['ns']:.2f}", f"`{of['from']}` → `{of['to']}`"


def pick(records, varied=(), **wanted):
    """Those that are as wanted, and for the rest, but for what is varied, as is standard."""
    wanted = {**{key: value for key, value in STANDARD.items() if key not in varied}, **wanted}
    return [of for of in records if all(of[key] == value for key, value in wanted.items())]
