"""Area times time: tables and plot."""

from cell_build import QUEUE, SIDE
from cost_record import MODES, cell_area, kilo, light_area, pick, table
from plot import Plot
from synthesis import NAND2


def runs_of(found):
    """(scene, L, mode, FA) -> the run and the cell it ran on, both of side SIDE."""
    cells_of = {(of["mode"], of["fa"]): of for of in pick(found["cells"], ("fa",))}
    return {(of["scene"], of["L"], of["mode"], of["fa"]): (of, cells_of[of["mode"], of["fa"]]) for of in found["cycles"]}


class Merit:
    """us and mm2 us of one run: of light on the light part alone, of light and of light and loading on the cell."""

    def __init__(self, run, cell):
        self.run, self.cell = run, cell
        self.light_us = run["light"] * cell["light_path"]["ns"] / 1000
        self.cell_us = run["light"] * cell["path"]["ns"] / 1000
        self.all_us = (run["light"] + run["load"]) * cell["path"]["ns"] / 1000
        self.light = self.light_us * light_area(cell) / 1e6
        self.whole = self.cell_us * cell_area(cell) / 1e6
        self.all = self.all_us * cell_area(cell) / 1e6


def merits(found):
    """Scene by scene: what the thesis's cell does at its best depth of queue, and what ours does at QUEUE."""
    runs = runs_of(found)
    for scene, distance in dict.fromkeys((of["scene"], of["L"]) for of in found["cycles"]):
        def of(mode):
            return [Merit(*pair) for key, pair in runs.items() if key[:3] == (scene, distance, mode)]

        yield (min(of("thesis"), key=lambda merit: merit.light), min(of("thesis"), key=lambda merit: merit.whole),
               min(of("thesis"), key=lambda merit: merit.all),
               next(merit for merit in of("fast") if merit.run["fa"] == QUEUE))


def area_time(found):
    light, whole = [], []
    for best_light, best_whole, best_all, ours in merits(found):
        scene = (ours.run["scene"], ours.run["L"])
        for merit in (best_light, ours):
            run, cell = merit.run, merit.cell
            ns = cell["light_path"]["ns"]
            light.append((*scene, MODES[run["mode"]], run["fa"], run["light"], run["hop_stages"], f"{ns:.2f}",
                          f"{1000 / ns:.0f}", f"{run['hop_stages'] * ns:.1f}", f"{merit.light_us:.2f}",
                          kilo(light_area(cell)), f"{merit.light:.3f}",
                          "" if merit is not ours else f"**{best_light.light / ours.light:.1f}**"))
        whole.append((*scene, best_whole.run["fa"], best_whole.run["light"], ours.run["light"], ours.run["load"],
                      f"{best_whole.cell['path']['ns']:.2f}", f"{ours.cell['path']['ns']:.2f}",
                      kilo(cell_area(best_whole.cell)), kilo(cell_area(ours.cell)), f"{best_whole.whole:.2f}",
                      f"{ours.whole:.2f}", f"**{best_whole.whole / ours.whole:.1f}**",
                      f"{best_all.all / ours.all:.1f}"))
    yield f"## Area × time, n = {SIDE}"
    yield ""
    yield "Light alone: the part of the cell that light needs, at that part's own clock."
    yield ""
    yield from table(("scene", "L", "mode", "FA", "T", "P", "ns", "MHz", "ns per hop", "T, µs", "kGE", "mm² µs",
                      "thesis / lanes"), light)
    yield "The whole cell, at the whole cell's clock; in the last column with the cycles of loading, equal in both."
    yield ""
    yield from table(("scene", "L", "FA of thesis", "T thesis", "T lanes", "cycles to load", "ns thesis", "ns lanes",
                      "kGE thesis", "kGE lanes", "mm² µs thesis", "mm² µs lanes", "thesis / lanes, light",
                      "light and loading"), whole)


def cycles(found):
    queues = sorted({of["fa"] for of in found["cycles"]})
    of = {(run["scene"], run["L"], run["mode"], run["fa"]): run for run in found["cycles"]}
    rows = [(*key, MODES[mode], *(of[*key, mode, fa]["light"] for fa in queues))
            for key in dict.fromkeys((run["scene"], run["L"]) for run in found["cycles"]) for mode in MODES]
    yield f"## Cycles of one light by depth of queue, n = {SIDE}"
    yield ""
    yield from table(("scene", "L", "mode", *(f"FA = {fa}" for fa in queues)), rows)


def draw(found, path_to):
    runs = runs_of(found)
    curves = {}
    for (scene, distance, mode, _), pair in runs.items():
        if distance == 2 * SIDE:
            merit = Merit(*pair)
            curves.setdefault((scene, mode), {})[merit.light_us] = light_area(merit.cell) / NAND2 / 1000
    times = [time for points in curves.values() for time in points]
    plot = Plot(f"One light, n = {SIDE}, L = {2 * SIDE}, FA = 1 … 16", "T, µs", (min(times) / 1.3, max(times) * 1.3),
                (10, 50), "light part of a cell, kGE", legend_width=190)
    scenes = list(dict.fromkeys(scene for scene, _ in curves))
    for (scene, mode), points in curves.items():
        plot.curve(points, f"{scene}, {MODES[mode]}", scenes.index(scene), "none" if mode == "fast" else "5 3")
    plot.save(path_to)
