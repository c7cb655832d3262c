"""What the benchmark's table says: reading it, settings, their cost, the points of the plots."""

import collections
import csv
import json
import math

KINDS = ("false_dark", "false_lit", "false_dark_tolerant", "false_lit_tolerant")


def number(word):
    return float(word) if word else None


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    last = [(row["commit"], row["seed"], row["computer"]) for row in rows][-1]
    return [row for row in rows if (row["commit"], row["seed"], row["computer"]) == last]


def sweep(rows, *names):
    return [row for row in rows if row["job"].split("-")[0] in names]


def percent(row, population, *kinds):
    voxels = int(row[population] or 0)
    return 100 * sum(int(row[f"{population}_{kind}"]) for kind in kinds) / voxels if voxels else None


def mean(values):
    values = [value for value in values if value is not None]
    return sum(values) / len(values) if values else None


def grouped(rows, key):
    groups = collections.defaultdict(list)
    for row in rows:
        groups[key(row)].append(row)
    return groups


def by_scene(rows, value):
    """Mean over the scenes of the means over their lights."""
    return mean(mean(map(value, of)) for of in grouped(rows, lambda row: row["scene"]).values())


class Cost:
    """What a cell costs (docs/cost.json): clock and area, between the sizes measured by the power of n."""

    BUILD = {"fa": 8, "reach": 2, "f": 4, "layers": 0}

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.cells = json.load(file)["cells"]

    def _at(self, mode, n, value):
        known = {}
        for cell in self.cells:
            if {"mode": mode, **self.BUILD}.items() <= cell.items():
                known[cell["n"]] = value(cell)
        if n in known:
            return known[n]
        sides = sorted(known)
        low = max((side for side in sides if side < n), default=sides[0])
        high = min((side for side in sides if side > n), default=sides[-1])
        if low == high:
            return known[low]
        share = math.log(n / low) / math.log(high / low)
        return known[low] * (known[high] / known[low]) ** share

    def clock(self, mode, n):
        return 1e-9 * self._at(mode, n, lambda cell: cell["path"]["ns"])

    def area(self, mode, n):
        """Of a cell, in square millimetres of osu018."""
        return 1e-6 * self._at(mode, n, lambda cell: cell["voxels"]["area"] + cell["light"]["area"])


# One way to light scenes, by machine or peer, over all scenes that were lit so and all their lights.
Setting = collections.namedtuple("Setting", "method n rule reach mode rows")


class Bench:
    def __init__(self, rows, cost):
        self.rows, self.cost = rows, cost
        self.size = sweep(rows, "size")
        self.scenes = sorted({row["scene"] for row in self.size if row["n"] == "64"})
        golden = [of for of in self.settings(sweep(rows, "size", "reach")) if of.method == "golden"]
        # Those that every setting has, so that all means are over the same.
        self.common = sorted(set.intersection(*({row["scene"] for row in of.rows} for of in golden)))

    def reach(self, row):
        return int(row["L"]) / int(row["n"]) if row["L"] else None

    def settings(self, rows):
        def key(row):
            return row["method"], int(row["n"]), row["light_rule"], self.reach(row), row["mode"]

        lit = [row for row in rows if row["light_seconds"]]
        return [Setting(*of, group) for of, group in sorted(grouped(lit, key).items(), key=lambda item: str(item[0]))]

    def cycles_of(self, setting):
        """Mean cycles of the array, by the cycle model, preparing included."""
        like = [row for row in sweep(self.rows, "size", "reach")
                if row["method"] == "cycle" and int(row["n"]) == setting.n and row["light_rule"] == setting.rule
                and self.reach(row) == setting.reach and row["scene"] in {of["scene"] for of in setting.rows}]
        return by_scene(like, lambda row: number(row["light_cycles"]))

    def machine_settings(self):
        """Those of golden over the common scenes: (setting, cycles of the array)."""
        settings = [among(of, self.common) for of in self.settings(sweep(self.rows, "size", "reach")) if of.method == "golden"]
        return [(of, self.cycles_of(of)) for of in settings]


def name_of(setting):
    return f"n = {setting.n}, {setting.rule}, L = {setting.reach:g}n" if setting.reach else f"n = {setting.n}"


def raw(rows):
    return by_scene(rows, lambda row: percent(row, "facing", "false_dark", "false_lit"))


def pareto(points):
    """Indices of the points (time, error) that no other point beats in both."""
    best, front = math.inf, []
    for i in sorted(range(len(points)), key=lambda i: points[i]):
        if points[i][1] < best:
            best = points[i][1]
            front.append(i)
    return front


def among(setting, scenes):
    return setting._replace(rows=[row for row in setting.rows if row["scene"] in scenes])


# Points of the two plots and the tables of budgets: (name, family, time, error)
def cycle_points(bench):
    return [(name_of(of), of.rule, cycles, raw(of.rows)) for of, cycles in bench.machine_settings()]


def time_points(bench):
    points = [(f"array, {name_of(of)}", "array", cycles * bench.cost.clock("fast", of.n), raw(of.rows))
              for of, cycles in bench.machine_settings()]
    for setting in bench.settings(sweep(bench.rows, "size", "reach", "peers")):
        of = among(setting, bench.common)
        if of.method == "golden":
            name, family = f"golden, {name_of(of)}", "golden"
        else:
            name, family = f"{of.method}{', ' + of.rule if of.rule else ''}, n = {of.n}", of.method.split("-")[0]
        if of.method not in ("cycle", "rtl"):
            points.append((name, family, by_scene(of.rows, lambda row: number(row["light_seconds"])), raw(of.rows)))
    return [point for point in points if None not in point]
