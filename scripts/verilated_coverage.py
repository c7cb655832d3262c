"""The counters that Verilated models hand in (sim/coverage.h), added up."""

import collections
import pathlib
import re

# What was counted: a run of lines, a way out of a branch, an edge of a bit, a functional point.
Counter = collections.namedtuple("Counter", "kind file line column name lines")
KINDS = {"v_line": "line", "v_branch": "branch", "v_toggle": "toggle", "v_user": "point"}


def lines_of(ranges):
    """The lines of "3,5-7"."""
    found = []
    for part in filter(None, ranges.split(",")):
        first, _, last = part.partition("-")
        found += range(int(first), int(last or first) + 1)
    return tuple(found)


def read(folder, root):
    """{Counter: count} of all files of a folder; instances and builds of a module are added up."""
    counts = collections.Counter()
    for path in pathlib.Path(folder).glob("*.dat"):
        for record, count in re.findall(r"^C '(.*)' (\d+)$", path.read_text(), re.MULTILINE):
            field = dict(part.split("\x02", 1) for part in record.split("\x01")[1:])
            kind = KINDS[field["page"].split("/")[0]]
            name = re.sub(r"__BRA__(\d+)__KET__", r"[\1]", field["h" if kind == "point" else "o"])
            if kind == "point":  # with the numbers of the generate loops it stands in
                *scopes, label = name.split(".u_points.")[1].split(".")
                name = ".".join([scope.removeprefix("g_") for scope in scopes if scope.endswith("]")] + [label])
            counter = Counter(kind, str(pathlib.Path(field["f"]).relative_to(root)),
                              int(field["l"]), int(field["n"]), name, lines_of(field.get("S", "")))
            counts[counter] += int(count)
    return counts


def of_kind(counts, kind):
    return {counter: count for counter, count in counts.items() if counter.kind == kind}


def line_counts(counts):
    """{(file, line): count} of procedural lines; a line counts as often as its rarest part."""
    found = {}
    for counter, count in counts.items():
        for line in counter.lines if counter.kind in ("line", "branch") else ():
            found[counter.file, line] = min(count, found.get((counter.file, line), count))
    return found


def points(counts):
    """{name: count} of the functional points, as unit.name."""
    found = collections.Counter()
    for counter, count in of_kind(counts, "point").items():
        found[f"{pathlib.Path(counter.file).stem.removesuffix('_points')}.{counter.name}"] += count
    return found
