"""Block diagrams of the two cells, in which each unit is as large as its share of the area."""

from cell_build import QUEUE, SIDE
from cost_record import MEMORY_BIT, MODES, cell_area, kilo_gates, light_area, pick
from synthesis import NAND2

# Title, the unit whose area it has, and what of it is a box of its own.
COLUMN = (("stage of the facet pipe", "rc2_facet_stage", None), ("dexel", "rc2_dexel", None), ("fill", "rc2_fill", None),
          ("voxels, readback", "rc2_column", None))
LIGHT = {
    "fast": (("what light can meet", "rc2_extents", None), ("stops of the side lane", "rc2_stops", None),
             ("side lane: queues, splitting", "rc2_side_lane", "rc2_stops"), ("z lanes", "rc2_z_lanes", None), ("lit", "rc2_lit", None)),
    "thesis": (("links", "rc2_router", None), ("queue, split, conflicts", "rc2_diffuser", "rc2_ymed"), ("Y_med", "rc2_ymed", None)),
}
# Of the light: what talks to the neighbours and what of it, what looks at the voxels, what they are told.
TALKS = {
    "fast": ((("what light can meet", "extents"), ("side lane: queues, splitting", "beams"), ("z lanes", "fronts")), "stops of the side lane", "lit"),
    "thesis": ((("links", "beams"),), "queue, split, conflicts", None),
}


class Blocks:
    """Stacks of boxes."""

    WIDTH, TOP, HEIGHT = 250, 70, 420

    def __init__(self, largest):
        self.scale, self.parts = self.HEIGHT / largest, []

    def text(self, x, y, words, anchor="start", size=12):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}">{words}</text>')

    def arrow(self, x, y, to_x, to_y, words):
        self.parts.append(f'<path d="M{x:.1f},{y:.1f} L{to_x:.1f},{to_y:.1f}" stroke="black" marker-end="url(#head)" fill="none"/>')
        self.text((x + to_x) / 2, (y + to_y) / 2 - 5, words, "middle")

    def stack(self, left, boxes, whole, colour):
        """Where the middle of each box is; a small one has its words beside it."""
        y, places = self.TOP, {}
        for name, area in boxes:
            height = self.scale * area
            self.parts.append(f'<rect x="{left}" y="{y:.1f}" width="{self.WIDTH}" height="{height:.1f}" fill="{colour}" stroke="black"/>')
            words = f"{name}: {100 * area / whole:.0f} %"
            if height < 12:
                self.text(left + self.WIDTH + 4, y + height / 2 + 3, words, size=9)
            else:
                self.text(left + 8, y + height / 2 + 4, words)
            places[name] = y + height / 2
            y += height
        return places

    def save(self, path_to):
        with open(path_to, "w") as file:
            file.write('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 880 510" font-family="sans-serif">\n'
                       '<defs><marker id="head" markerWidth="8" markerHeight="8" refX="7" refY="3" orient="auto">'
                       '<path d="M0,0 L7,3 L0,6 z"/></marker></defs>\n'
                       '<rect width="880" height="510" fill="white"/>\n' + "\n".join(self.parts) + "\n</svg>\n")


def boxes(units, area, whole, others):
    """What is in none of them, or was joined with its neighbours, is the rest."""
    found = [(title, area[unit] - area.get(apart, 0)) for title, unit, apart in units] + others
    rest = whole - sum(size for _, size in found)
    return [*found, ("the rest", rest)] if rest > 0 else found


def draw_blocks(found, mode, path_to):
    cell = pick(found["cells"], mode=mode)[0]
    area = {of["unit"]: of["area"] for part in (mode, "load") for of in pick(found["units"], of=part)}
    memory = cell["voxels"]["memory_bits"] * MEMORY_BIT * NAND2
    column = boxes(COLUMN, area, cell["voxels"]["area"] + memory, [("memory of owners", memory)])
    light = boxes(LIGHT[mode], area, light_area(cell), [("share of the axes", cell["share"])] if cell["share"] else [])
    whole = cell_area(cell)
    blocks = Blocks(max(sum(size for _, size in part) for part in (column, light)))
    blocks.text(20, 24, f"Cell of {MODES[mode]}, n = {SIDE}, FA = {QUEUE}: {kilo_gates(whole):.1f} kGE; shares of the area", size=15)
    blocks.text(110, 58, "column: loading, readback")
    blocks.text(480, 58, "light")
    left = blocks.stack(110, column, whole, "#e8f0e4")
    right = blocks.stack(480, light, whole, "#e4ecf4")
    blocks.arrow(20, left["stage of the facet pipe"], 110, left["stage of the facet pipe"], "words in")
    blocks.arrow(110, left["voxels, readback"], 20, left["voxels, readback"], "words out")
    talking, looking, told = TALKS[mode]
    blocks.arrow(360, left["voxels, readback"] - 8, 480, right[looking], "occupied")
    if told:
        blocks.arrow(480, right[told], 360, left["voxels, readback"] + 8, told)
    for name, words in talking:
        blocks.arrow(870, right[name] - 6, 730, right[name] - 6, f"{words} in")
        blocks.arrow(730, right[name] + 6, 870, right[name] + 6, "")
        blocks.text(800, right[name] + 18, f"{words} out", "middle")
    blocks.save(path_to)
