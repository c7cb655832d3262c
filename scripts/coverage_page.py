"""docs/coverage.md from what scripts/coverage has counted."""

import collections
import json
import re

import verilated_coverage as verilated

HEAD = """# Coverage

What the tests go through, of RTL and of C++. `make coverage` builds all of it anew with counters in a folder of
its own, runs the tests that watch single units, the arrays of n = 4 and 5, that with rays of n = 4, the SystemC benches
and the software's own tests, and writes this page and `out/coverage/index.html`, where every line, branch, toggle and point can be looked at.
Coverage says what was never tried, not what is right; whether the tests would notice is
[what mutation tells](mutation.md).

- **Line**: a line of a procedural block, covered if all of its branches were; Verilator does not count continuous
  assignments as lines, but their signals as toggles. **Branch**: a way out of an `if`, a `case` or a `?:`.
- **Toggle**: a bit of a signal that has changed. Watched in the units that have a test of their own, in the thesis's cell
  in its SystemC bench (n = 8) and in the whole array in lanes of n = 4.
- **Functional point**: something that a test must have seen, one `cover` each in `tb/points`, bound to its unit. All are
  to be reached in these arrays and in the benches; `make test` checks it (`rtl.points`).

On the HTML page a functional point is a "function", and RTL's toggles count as branches.
"""


def share(counts):
    hit = sum(1 for count in counts if count > 0)
    return f"{hit} of {len(counts)} ({100 * hit / len(counts):.1f} %)" if counts else "–"


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head), *("| " + " | ".join(row) + " |" for row in rows)])


def short(name):
    return name.removeprefix("rtl/").removesuffix(".sv")


def holes(counts, root, reasons):
    """Rows of runs of lines that no test goes through; a reason that no hole needs is an error."""
    missed = collections.defaultdict(list)
    for (file, line), count in sorted(verilated.line_counts(counts).items()):
        if count == 0 and file.startswith("rtl/"):
            runs = missed[file]
            if runs and runs[-1][-1] == line - 1:
                runs[-1].append(line)
            else:
                runs.append([line])
    rows, unused = [], {(file, text) for file, texts in reasons.items() for text in texts}
    for file, runs in missed.items():
        source = (root / file).read_text().splitlines()
        for run in runs:
            text = source[run[0] - 1].strip()
            unused.discard((file, text))
            where = f"{file}:{run[0]}" + (f"–{run[-1]}" if len(run) > 1 else "")
            rows.append((where, "`" + text.replace("|", "\\|") + "`", reasons.get(file, {}).get(text, "**no reason given**")))
    if unused:
        raise SystemExit(f"tb/points/holes.json: these are no holes, take them out: {sorted(unused)}")
    return rows


def still(counts):
    """{file: signals that never change}, bits in a row as one."""
    bits = collections.defaultdict(lambda: collections.defaultdict(list))
    for counter, count in verilated.of_kind(counts, "toggle").items():
        if count == 0:
            name, bit = re.fullmatch(r"(.*?)(?:\[(\d+)\])?", counter.name).groups()
            bits[counter.file][name].append(-1 if bit is None else int(bit))
    found = {}
    for file, signals in bits.items():
        found[file] = []
        for name, numbers in sorted(signals.items()):
            parts = []
            for number in sorted(set(numbers)):
                if parts and parts[-1][1] == number - 1:
                    parts[-1][1] = number
                else:
                    parts.append([number, number])
            found[file] += [name if low < 0 else f"{name}[{high}:{low}]" if high > low else f"{name}[{low}]" for low, high in parts]
    return found


def rtl_rows(counts):
    kinds = collections.defaultdict(lambda: collections.defaultdict(list))
    for (file, _), count in verilated.line_counts(counts).items():
        kinds[file]["line"].append(count)
    for counter, count in counts.items():
        if counter.kind in ("branch", "toggle"):
            kinds[counter.file][counter.kind].append(count)
    of_rtl = {file: found for file, found in kinds.items() if file.startswith("rtl/")}
    rows = [(short(file), *(share(found[kind]) for kind in ("line", "branch", "toggle"))) for file, found in sorted(of_rtl.items())]
    total = [share([count for found in of_rtl.values() for count in found[kind]]) for kind in ("line", "branch", "toggle")]
    return rows + [("**all**", *total)]


def point_rows(points):
    units = collections.defaultdict(dict)
    for name, count in points.items():
        unit, point = name.split(".", 1)
        units[unit][point] = count
    return [(unit, share(found.values()), ", ".join(sorted(point for point, count in found.items() if count == 0)) or "–")
            for unit, found in sorted(units.items())]


def cpp_rows(summary):
    libraries = collections.defaultdict(lambda: [0, 0, 0, 0])
    for file in summary["files"]:
        if not file["filename"].startswith("sw/"):
            continue
        fields = ("line_covered", "line_total", "branch_covered", "branch_total")
        for name in ("/".join(file["filename"].split("/")[:2]), "**all**"):
            libraries[name] = [sum(pair) for pair in zip(libraries[name], (file[field] for field in fields))]
    percent = lambda hit, of: f"{hit} of {of} ({100 * hit / of:.1f} %)" if of else "–"
    return [(name, percent(*n[:2]), percent(*n[2:])) for name, n in sorted(libraries.items(), key=lambda pair: (pair[0][0] == "*", pair))]


def write(path, counts, summary, root, reasons):
    rows = holes(counts, root, json.loads(reasons.read_text()))
    quiet = still(counts)
    path.write_text("\n\n".join((
        HEAD.strip(),
        "## RTL", table(("module", "lines", "branches", "toggles"), rtl_rows(counts)),
        "## Lines that no test goes through", table(("where", "what", "why"), rows) if rows else "None.",
        "## Functional points", table(("unit", "reached", "not reached"), point_rows(verilated.points(counts))),
        "## Signals that never change",
        "At the sizes above; most are upper bits that a small machine does not need, and constants.",
        table(("module", "signals"), [(short(file), ", ".join(f"`{name}`" for name in names)) for file, names in sorted(quiet.items())]),
        "## C++", "Branches without those that only an exception takes. The program in `sim` is tested from outside and is not counted.",
        table(("library", "lines", "branches"), cpp_rows(summary)))) + "\n")
    for where, what, why in rows:
        print(f"hole: {where} {what} {why}")
