"""What a cell takes of an FPGA, and what a light takes of energy: tables."""

from cost_record import MODES, cell_area, pick, table
from synthesis import NAND2

HX8K = (7680, 32)  # logic cells, blocks of memory


def fpga(found):
    counts = {(of["family"], of["mode"], of["n"], of["fa"]): of for of in found["fpga"]}
    nand2 = {(of["mode"], of["n"], of["fa"]): of["nand2"] for of in found["generic"]}
    families = list(dict.fromkeys(of["family"] for of in found["fpga"]))
    rows = []
    for mode, n, fa in dict.fromkeys(key[1:] for key in counts):
        def of(family):
            one = counts.get((family, mode, n, fa))
            return (one["tables"], one["flip_flops"], one["blocks"], one["multipliers"]) if one else ("",) * 4

        mapped = pick(found["cells"], mode=mode, n=n, fa=fa)[0]
        bits = mapped["voxels"]["memory_bits"]
        rows.append((MODES[mode], n, fa, nand2.get((mode, n, fa), ""), f"{cell_area(mapped) / NAND2 - bits:.0f}", bits,
                     *(number for family in families for number in of(family))))
    yield "## In gates of no library, and in FPGAs"
    yield ""
    yield ("A whole cell. NAND2 equivalents without memories, by Yosys's transistors of each gate and as the OSU library has it "
           "(with the axes' share); look-up tables (LUT), flip-flops (FF), blocks of memory (BRAM) and multipliers (DSP) with memories.")
    yield ""
    yield from table(("mode", "n", "FA", "NAND2 of no library", "NAND2 of OSU", "bits of memory",
                      *(f"{family}, {what}" for family in families for what in ("LUT", "FF", "BRAM", "DSP"))), rows)


def hx8k(found):
    def row(of):
        what = f"machine of {of['n']} × {of['n']}" if of["top"] == "rc2_machine" else f"one cell, n = {of['n']}"
        return (MODES[of["mode"]], what, of["f"], f"{of['reach']}n", of["fa"], "yes" if of["skips"] and of["mode"] == "fast" else "no",
                of["cells"], f"{100 * of['cells'] / HX8K[0]:.0f} %", of["blocks"], f"{of['mhz']:.1f}" if of["mhz"] else "does not fit")

    yield "## On an iCE40 HX8K"
    yield ""
    yield (f"As nextpnr places it; the chip has {HX8K[0]} logic cells and {HX8K[1]} blocks of memory. A machine is whole, with its "
           "host port. Inputs share pins and outputs are summed into one, or there were not pins enough; MHz are from register to register.")
    yield ""
    yield from table(("mode", "what", "f", "L up to", "FA", "skips", "logic cells", "of the chip", "blocks of memory", "MHz"),
                     map(row, found["hx8k"]))


def energy(found):
    cells = found["n"] ** 2
    rows = []
    for of in found["lights"]:
        ticks = (of["cycles"] + 1) * cells  # and the one that starts it
        data, clock = of["data_pj"] * ticks / 1e6, of["clock_pj"] * ticks / 1e6
        gated, by_unit = data + clock * of["duty"], data + clock * of["unit_duty"]
        rows.append((of["scene"], of["machine"], of["cycles"], f"{of['switches']:.1f}", f"{of['data_pj']:.2f}", f"{of['clock_pj']:.2f}",
                     f"{100 * of['duty']:.1f} %", f"{data + clock:.2f}", f"{gated:.2f}", f"{100 * (1 - gated / (data + clock)):.0f} %",
                     f"{100 * of['unit_duty']:.1f} %", f"{by_unit:.2f}", f"{100 * (1 - by_unit / (data + clock)):.0f} %", of["beams"], f"{1e6 * gated / of['beams']:.0f}" if of["beams"] else "–"))
    yield f"## Energy of one light, n = {found['n']}, L = {found['L']}, FA = {found['fa']}"
    yield ""
    yield from table(("scene", "light", "cycles", "switches a cell and cycle", "pJ a cell and cycle, all but the clock", "its clock, pJ",
                      "duty of a cell", "µJ, clock always on", "µJ, clock gated cell by cell", "saved by that",
                      "duty of a register's unit", "µJ, clock gated unit by unit", "saved by that", "beams served",
                      "pJ a beam, gated"), rows)
