"""Somebody else's AXI4-Lite master and AXI4-Stream source and sink (cocotbext-axi) on the gates of the machine.

They do what the SystemC bench did (RC2_RECORD, of systemc_machine --record), in the same order and with stalls of their
own, so at other times: what is read back must be the same. cocotb runs this; scripts/bus calls it.
"""

import itertools
import os
import random

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles
from cocotbext.axi import AxiLiteBus, AxiLiteMaster, AxiStreamBus, AxiStreamFrame, AxiStreamSink, AxiStreamSource

STATUS, BUSY_CYCLES, COMMAND = 0x24, 0x28, 0x20
BUSY = 1
SETTLE = 8  # cycles after a command, or a word, until status says busy (docs/host-port.md)
LAST = 1 << 63  # tlast, in a recorded beat of the readback


def transfers(path):
    """(what, value) for all that was taken, in order: write (address, value), read (address, value), packet k,
    readback. A write counts when its answer is taken."""
    writes, reads = ([], []), []
    with open(path, encoding="ascii") as record:
        for line in record:
            words = [int(word, 16) for word in line.split()]
            (aw, w, ar, *packets), (b, r, readback) = [
                [words[i:i + 3] for i in range(*part)] for part in ((0, len(words) - 9, 3), (len(words) - 9, len(words), 3))]
            for k, (valid, beat, ready) in enumerate(packets):
                if valid and ready:
                    yield f"packet {k}", beat
            for queue, (valid, beat, ready) in ((writes[0], aw), (writes[1], w), (reads, ar)):
                if valid and ready:
                    queue.append(beat)
            if b[0] and b[1]:
                yield "write", (writes[0].pop(0), writes[1].pop(0))
            if r[0] and r[1]:
                yield "read", (reads.pop(0), r[2])
            if readback[0] and readback[1]:
                yield "readback", readback[2]


def stalls(seed):
    """True where an end of a stream holds still: never, seldom, mostly, a habit for some cycles at a time."""
    dice = random.Random(seed)
    while True:
        share = dice.choice((0, 0.1, 0.5, 0.9))
        for _ in range(dice.randint(20, 200)):
            yield dice.random() < share


@cocotb.test()
async def does_what_the_bench_saw(dut):
    cocotb.start_soon(Clock(dut.clk, 10, unit="ns").start())
    dut.rst_n.value = 0
    axil = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axil"), dut.clk, dut.rst_n, reset_active_level=False)
    sources = [AxiStreamSource(AxiStreamBus.from_prefix(dut, f"s_axis{k}"), dut.clk, dut.rst_n, reset_active_level=False)
               for k in range(2)]
    sink = AxiStreamSink(AxiStreamBus.from_prefix(dut, "m_axis"), dut.clk, dut.rst_n, reset_active_level=False)
    ends = [*sources, sink, axil.write_if.aw_channel, axil.write_if.w_channel, axil.write_if.b_channel,
            axil.read_if.ar_channel, axil.read_if.r_channel]
    for seed, end in enumerate(ends):
        end.set_pause_generator(stalls(seed))
    await ClockCycles(dut.clk, 3)
    dut.rst_n.value = 1
    await ClockCycles(dut.clk, 3)

    counts = dict.fromkeys(("write", "read", "packet", "readback"), 0)
    width = len(dut.m_axis_tdata) // 8
    frame = iter(())  # what is left of the readback that came last
    for what, group in itertools.groupby(transfers(os.environ["RC2_RECORD"]), lambda entry: entry[0].split()[0]):
        for name, value in group:
            counts[what] += 1
            if what == "packet":
                source = sources[int(name.split()[1])]
                await source.send(AxiStreamFrame(value.to_bytes(len(source.bus.tdata) // 8, "little")))
            elif what == "write":
                await axil.write_dword(*value)
                if value[0] == COMMAND:
                    await ClockCycles(dut.clk, SETTLE)
            elif what == "read":
                address, expected = value
                got = await axil.read_dword(address)
                while address == STATUS and got & BUSY:
                    got = await axil.read_dword(address)
                # How often a bench sees the machine busy, and for how long packets kept it so, depends on the stalls.
                if address == STATUS:
                    assert got == expected & ~BUSY or expected & BUSY, f"status {got:x}, expected {expected:x}"
                elif address != BUSY_CYCLES:
                    assert got == expected & 0xFFFFFFFF, f"register {address:x} is {got:x}, expected {expected:x}"
            else:
                beat = next(frame, None)
                if beat is None:
                    data = bytes((await sink.recv()).tdata)
                    frame = iter(int.from_bytes(data[i:i + width], "little") for i in range(0, len(data), width))
                    beat = next(frame)
                assert beat == value & (LAST - 1), f"readback {beat:x}, expected {value & (LAST - 1):x}"
        if what == "packet":
            for source in sources:
                await source.wait()
            await ClockCycles(dut.clk, SETTLE)
    assert all(counts.values()), counts
    dut._log.info("%d registers written, %d read, %d packet words, %d words read back, no difference", *counts.values())
