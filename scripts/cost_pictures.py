"""What parameters do to a cell, and how much of it each unit is: pictures."""

from cost_record import MEMORY_BIT, MODES, QUEUE, SIDE, cell_area, light_area, pick
from panels import Panels
from synthesis import NAND2


def kilo_gates(area):
    return area / NAND2 / 1000


def draw_curves(found, path_to):
    """Area and clock against n, FA, L and f."""
    panels = Panels(4, 2, f"n = {SIDE}, FA = {QUEUE}, L = 2n, f = 4 but for what varies")
    for column, (key, name) in enumerate((("n", "n"), ("fa", "FA"), ("reach", "L / n"))):
        def curves(value):
            return {MODES[mode]: {of[key]: value(of) for of in pick(found["cells"], (key,), mode=mode)} for mode in MODES}

        panels.panel(column, 0, name, "cell, kGE", curves(lambda of: kilo_gates(cell_area(of))))
        panels.panel(column, 1, name, "cell, ns", curves(lambda of: of["path"]["ns"]))
    columns = pick(found["units"], ("f",), of="load", unit="rc2_voxels", mode="fast")
    panels.panel(3, 0, "f", "column, kGE", {"column": {of["f"]: kilo_gates(of["area"]) for of in columns}})
    panels.panel(3, 1, "f", "column, ns", {"column": {of["f"]: of["path"]["ns"] for of in columns}})
    panels.legend(MODES.values())
    panels.save(path_to)


# Block diagrams: title, units whose area it has, units that are inside them, apart.
LOADING = (("stage of the facet pipe", ("rc2_facet_stage",), ()), ("dexel", ("rc2_dexel",), ()), ("fill", ("rc2_fill",), ()),
           ("column, readback", ("rc2_column",), ()))
LIGHT = {
    "fast": (("what light can meet", ("rc2_extents",), ()), ("stops of the side lane", ("rc2_stops",), ()),
             ("side lane: queues, splitting", ("rc2_side_lane",), ("rc2_stops",)), ("z lanes", ("rc2_z_lanes",), ()), ("lit", ("rc2_lit",), ())),
    "thesis": (("links, slots", ("rc2_router",), ()), ("queue, split, conflicts", ("rc2_diffuser",), ("rc2_ymed",)), ("Y_med", ("rc2_ymed",), ())),
}
ARROWS = {"fast": "beams, fronts of eight neighbours", "thesis": "beams of eight neighbours"}


class Blocks:
    """A stack of boxes, each as high as its share of the cell."""

    WIDTH, TOP, HEIGHT = 250, 70, 520

    def __init__(self, whole):
        self.whole, self.parts = whole, []

    def text(self, x, y, words, anchor="start", size=12):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}">{words}</text>')

    def arrow(self, x, y, to_x, to_y):
        self.parts.append(f'<path d="M{x:.1f},{y:.1f} L{to_x:.1f},{to_y:.1f}" stroke="black" marker-end="url(#head)" fill="none"/>')

    def stack(self, left, boxes, colour):
        """Middle and half height of each box."""
        y, places = self.TOP, {}
        for name, area in boxes:
            height = self.HEIGHT * area / self.whole
            self.parts.append(f'<rect x="{left}" y="{y:.1f}" width="{self.WIDTH}" height="{height:.1f}" fill="{colour}" stroke="black"/>')
            self.text(left + 8, y + height / 2 + 4, f"{name}: {100 * area / self.whole:.0f} %", size=min(12, max(6, height - 1)))
            places[name] = y + height / 2
            y += height
        return places

    def save(self, path_to):
        with open(path_to, "w") as file:
            file.write('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 860 620" font-family="sans-serif">\n'
                       '<defs><marker id="head" markerWidth="8" markerHeight="8" refX="7" refY="3" orient="auto"><path d="M0,0 L7,3 L0,6 z"/></marker></defs>\n'
                       '<rect width="860" height="620" fill="white"/>\n' + "\n".join(self.parts) + "\n</svg>\n")


def draw_blocks(found, mode, path_to):
    """The cell of SIDE; what is in no unit of its own, or was joined with its neighbours, is the rest."""
    cell = pick(found["cells"], mode=mode)[0]
    area = {of["unit"]: of["area"] for of in pick(found["units"], mode=mode if mode == "thesis" else "fast")}
    area |= {of["unit"]: of["area"] for of in pick(found["units"], mode="fast", of="load")}

    def boxes(parts, whole, extra):
        found = [(name, sum(area[unit] for unit in units) - sum(area[unit] for unit in apart)) for name, units, apart in parts]
        found += extra
        rest = whole - sum(of for _, of in found)
        return [*found, ("the rest", rest)] if rest > 0 else found

    memory = cell["voxels"]["memory_bits"] * MEMORY_BIT * NAND2
    blocks = Blocks(cell_area(cell))
    blocks.text(20, 24, f"Cell of {MODES[mode]}, n = {SIDE}, FA = {QUEUE}: {kilo_gates(cell_area(cell)):.1f} kGE; heights are shares of the area", size=15)
    share = [("share of the axes", cell["share"])] if cell["share"] else []
    left = blocks.stack(110, boxes(LOADING, cell["voxels"]["area"] + memory, [("memory of owners", memory)]), "#e8f0e4")
    right = blocks.stack(490, boxes(LIGHT[mode], light_area(cell), share), "#e4ecf4")
    blocks.text(110, 58, "column of voxels: loading, readback")
    blocks.text(490, 58, "light")
    stage, column = left["stage of the facet pipe"], left["column, readback"]
    blocks.arrow(20, stage, 110, stage)
    blocks.text(14, stage - 8, "words in")
    blocks.arrow(110, column, 20, column)
    blocks.text(14, column - 8, "words out")
    first = list(right.values())
    blocks.arrow(360, column - 6, 490, first[1])
    blocks.text(370, (column + first[1]) / 2 - 16, "occupied")
    blocks.arrow(490, first[-1] - 4, 360, column + 6)
    blocks.text(390, first[-1] + 14, "lit")
    blocks.arrow(850, first[0] + 20, 740, first[0] + 20)
    blocks.arrow(740, first[2], 850, first[2])
    blocks.text(850, Blocks.TOP - 8, ARROWS[mode], "end")
    blocks.save(path_to)
