"""Area and clock of cells and units; how many cells fit a chip: tables."""

import math

from cell_build import QUEUE, SIDE
from cost_record import MODES, cell_area, kilo, light_area, path, pick, table
from synthesis import FLIP_FLOP, NAND2

DENSITY = 0.8  # share of a die that gates fill: an estimate
SHRINKS = {"0.5 µm (1992)": 9, "0.35 µm": 4, "0.18 µm": 1}  # OSU's own libraries are exactly that much larger
TODAY = 91.2e6 / 4  # GE per mm2 at 7 nm: 91.2 million transistors per mm2 as published, four a gate


def cells(found):
    def row(of):
        flip_flops = of["light"]["flip_flops"] + of["voxels"]["flip_flops"]
        bits = of["voxels"]["memory_bits"] + of["light"]["memory_bits"]
        return (MODES[of["mode"]], of["n"], of["fa"], f"{of['reach']}n", "yes" if of["layers"] else "no", kilo(light_area(of)), kilo(of["voxels"]["area"]), flip_flops, bits,
                kilo(cell_area(of)), path(of["light_path"])[0], *path(of["path"]))

    yield "## Whole cells"
    yield ""
    yield from table(
        ("mode", "n", "FA", "L up to", "layers", "light, kGE", "column, loading, readback, kGE", "flip-flops", "bits of memory", "cell, kGE",
         "light, ns", "cell, ns", "longest path of the cell"),
        map(row, sorted(found["cells"], key=lambda of: (of["mode"] == "fast", of["n"], of["layers"], of["reach"], of["fa"]))))


def units(found):
    def row(of):
        return (f"`{of['unit']}`", of["f"], kilo(of["area"]), of["flip_flops"],
                f"{100 * of['flip_flops'] * FLIP_FLOP / of['area']:.0f} %", of["memory_bits"], *path(of["path"]))

    names = {"fast": "Light in lanes", "thesis": "The thesis's light", "load": "Column, loading, readback: in both cells",
             "layers": "Column with layers, as accurate light wants it"}
    yield f"## Units alone, n = {SIDE}, FA = {QUEUE}"
    yield ""
    for part, title in names.items():
        yield f"### {title}"
        yield ""
        yield from table(("unit", "f", "kGE", "flip-flops", "their share of the area", "bits of memory", "ns", "longest path"),
                         (row(of) for of in found["units"] if of["of"] == part))


def rays(found):
    part, = found["rays"]
    units = part["units"]
    total = {name: sum(of["count"] * of[name] for of in units) for name in ("area", "flip_flops", "memory_bits")}

    def row(of):
        area = of["count"] * of["area"]
        return (f"`{of['unit']}`", of["count"], kilo(of["area"]), kilo(area), f"{100 * area / total['area']:.0f} %",
                of["count"] * of["flip_flops"], of["count"] * of["memory_bits"], *(path(of["path"]) if of["path"] else ("", "")))

    yield "## Rays"
    yield ""
    yield f"What a cell has for them, n = {part['n']}. Each unit without those in it that have a line of their own; its longest path is with them."
    yield ""
    yield from table(("unit", "in a cell", "kGE of one", "kGE", "share", "flip-flops", "bits of memory", "ns", "longest path"),
                     (*map(row, units), ("all of it", "", "", kilo(total["area"]), "", total["flip_flops"], total["memory_bits"], "", "")))


def dies(found):
    area = {of["n"]: cell_area(of) for of in pick(found["cells"], ("n",), mode="fast")}
    first, second = SIDE, max(area)
    growth = math.log(area[second] / area[first]) / math.log(second / first)
    for n in (512, 1024):
        area[n] = area[second] * (n / second) ** growth
    rows = []
    for n in sorted(area):
        held = {name: DENSITY * 1e8 / (area[n] * shrink) for name, shrink in SHRINKS.items()}
        rows.append((n, ("" if n <= second else "≈ ") + kilo(area[n]),
                     *(f"{of:.0f}" for of in held.values()), *(f"{math.ceil(n * n / of):,}" for of in held.values()),
                     f"{n * n * area[n] / NAND2 / TODAY / DENSITY:,.0f}"))
    yield f"## How large an array fits (lanes, FA = {QUEUE})"
    yield ""
    yield from table(("n", "kGE per cell", *(f"cells on 1 cm², {name}" for name in SHRINKS),
                      *(f"dies for n × n, {name}" for name in SHRINKS), "mm² at 7 nm"), rows)
