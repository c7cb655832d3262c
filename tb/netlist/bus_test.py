"""Somebody else's AXI4-Lite master and AXI4-Stream source and sink (cocotbext-axi) on the gates of the machine.

They do what the SystemC bench did (RC2_RECORD, of systemc_machine --record), in the same order and with stalls of their
own, so at other times: what is read back must be the same. cocotb runs this; scripts/bus calls it.
"""

import collections
import itertools
import os
import random

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles
from cocotbext.axi import AxiLiteBus, AxiLiteMaster, AxiStreamBus, AxiStreamFrame, AxiStreamSink, AxiStreamSource

STATUS, BUSY_CYCLES = 0x24, 0x28
SETTLE = 8  # cycles after a command, or a word, until status says busy (docs/host-port.md)
LAST = 1 << 63  # tlast, in a recorded beat of the readback


def transfers(path):
    """(what, values...) for all that was taken, in order: write address value, read address value, packet k beat,
    readback beat. A write counts when its answer is taken."""
    writes, reads = ([], []), []
    with open(path, encoding="ascii") as record:
        for line in record:
            words = [int(word, 16) for word in line.split()]
            (aw, w, ar, *packets), (b, r, readback) = [
                [words[i:i + 3] for i in range(*part)] for part in ((0, len(words) - 9, 3), (len(words) - 9, len(words), 3))]
            for k, (valid, beat, ready) in enumerate(packets):
                if valid and ready:
                    yield "packet", k, beat
            for queue, (valid, beat, ready) in ((writes[0], aw), (writes[1], w), (reads, ar)):
                if valid and ready:
                    queue.append(beat)
            if b[0] and b[1]:
                yield "write", writes[0].pop(0), writes[1].pop(0)
            if r[0] and r[1]:
                yield "read", reads.pop(0), r[2]
            if readback[0] and readback[1]:
                yield "readback", readback[2]


def without_polls(entries):
    """Of status read again and again only the last: how often a bench sees the machine busy depends on the stalls."""
    for (what, *values), following in itertools.pairwise([*entries, ("end",)]):
        if not (what == following[0] == "read" and values[0] == following[1] == STATUS):
            yield what, *values


def stalls(seed):
    """True where an end of a stream holds still: never, seldom, mostly, a habit for some cycles at a time."""
    dice = random.Random(seed)
    while True:
        share = dice.choice((0, 0.1, 0.5, 0.9))
        for _ in range(dice.randint(20, 200)):
            yield dice.random() < share


class Host:
    """What drives the machine: one transfer after another, as the record has them."""

    def __init__(self, dut):
        self.dut = dut
        ends = dut.clk, dut.rst_n, False
        self.axil = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axil"), *ends)
        self.sources = [AxiStreamSource(AxiStreamBus.from_prefix(dut, f"s_axis{k}"), *ends) for k in range(2)]
        self.sink = AxiStreamSink(AxiStreamBus.from_prefix(dut, "m_axis"), *ends)
        channels = [*self.sources, self.sink, self.axil.write_if.aw_channel, self.axil.write_if.w_channel,
                    self.axil.write_if.b_channel, self.axil.read_if.ar_channel, self.axil.read_if.r_channel]
        for seed, channel in enumerate(channels):
            channel.set_pause_generator(stalls(seed))
        self.expected = []  # beats of the readback that is under way

    async def settle(self):
        await ClockCycles(self.dut.clk, SETTLE)

    async def read_back(self):
        """Waits for what the readback owes."""
        if not self.expected:
            return
        data = bytes((await self.sink.recv()).tdata)
        width = len(self.dut.m_axis_tdata) // 8
        got = [int.from_bytes(data[i:i + width], "little") for i in range(0, len(data), width)]
        # The beat with tlast carries nothing.
        assert got[:-1] == self.expected[:-1], f"readback {got}, expected {self.expected}"
        self.expected = []

    async def packet(self, k, beat):
        source = self.sources[k]
        if self.expected and self.expected[-1] & LAST:
            await self.read_back()
        await source.send(AxiStreamFrame(beat.to_bytes(len(source.bus.tdata) // 8, "little")))

    async def readback(self, beat):
        # A row may answer before the words of all feeders are sent, so this does not wait.
        self.expected.append(beat)

    async def finish(self):
        for source in self.sources:
            await source.wait()
        await self.read_back()
        await self.settle()

    async def write(self, address, value):
        await self.finish()
        await self.axil.write_dword(address, value)
        await self.settle()

    async def read(self, address, expected):
        await self.finish()
        got = await self.axil.read_dword(address)
        if address == STATUS:
            while got != expected:
                got = await self.axil.read_dword(address)
        # For how long packets kept the machine busy depends on the stalls.
        elif address != BUSY_CYCLES:
            assert got == expected & 0xFFFFFFFF, f"register {address:x} is {got:x}, expected {expected:x}"


@cocotb.test(timeout_time=1, timeout_unit="ms")
async def does_what_the_bench_saw(dut):
    cocotb.start_soon(Clock(dut.clk, 10, unit="ns").start())
    dut.rst_n.value = 0
    host = Host(dut)
    await ClockCycles(dut.clk, 3)
    dut.rst_n.value = 1
    await ClockCycles(dut.clk, 3)
    counts = collections.Counter()
    for what, *values in without_polls(transfers(os.environ["RC2_RECORD"])):
        counts[what] += 1
        await getattr(host, what)(*values)
    await host.finish()
    assert len(counts) == 4, counts
    dut._log.info("%d registers written, %d read, %d packet words, %d words read back, no difference", counts["write"],
                  counts["read"], counts["packet"], counts["readback"])
