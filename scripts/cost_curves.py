"""What parameters do to a cell: plots."""

from cell_build import QUEUE, SIDE
from cost_record import MODES, cell_area, kilo_gates, pick
from panels import Panels


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
