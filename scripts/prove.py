"""One proof of scripts/formal: a checker of tb/formal around units of rtl/. Nothing of a unit is changed
for its proof, but by the fault that the proof must find."""

import dataclasses
import shutil
import time

from solvers import ROOT, Disproved, ask_abc, ask_z3, read


@dataclasses.dataclass(frozen=True)
class Fault:
    """A text of a file of rtl/ that occurs there once, and what is put in its place."""

    file: str
    good: str
    bad: str


@dataclasses.dataclass(frozen=True)
class Proof:
    checker: str  # tb/formal/<checker>.sv, its top module
    says: str
    units: str
    method: str  # "induction", "bounded" or "all inputs" of a unit without state
    fault: Fault
    depth: int = 1  # of the induction, or cycles from reset
    reach: int = 12  # cycles from reset in which the fault of an induction must show
    params: tuple = ()  # of the checker
    macros: tuple = ()  # of rc2_pkg
    stubs: tuple = ()  # files of tb/formal that stand for units of rtl/
    abc: bool = False  # put to ABC, which bears more gates than z3; bounded only
    bits: bool = False  # put to z3 as gates
    fast: bool = True  # also a test of make test

    @property
    def sizes(self):
        return ", ".join(f"{name} = {value}" for name, value in (*self.macros, *self.params))

    @property
    def name(self):
        return "-".join((self.checker, *(f"{name.lower()}{value}" for name, value in (*self.macros, *self.params))))

    @property
    def how(self):
        return {"all inputs": "all inputs", "induction": f"induction, k = {self.depth}",
                "bounded": f"bounded, {self.depth} cycles{', ABC' if self.abc else ''}"}[self.method]


def broken_rtl(folder, fault):
    """A copy of rtl/ with the fault in it."""
    rtl = f"{folder}/rtl"
    shutil.rmtree(rtl, ignore_errors=True)
    shutil.copytree(f"{ROOT}/rtl", rtl)
    path = f"{rtl}/{fault.file}"
    with open(path) as file:
        text = file.read()
    if text.count(fault.good) != 1:
        raise SystemExit(f"scripts/formal: {fault.good!r} stands {text.count(fault.good)} times in rtl/{fault.file}, "
                         "not once; mend tb/formal/proofs.py")
    with open(path, "w") as file:
        file.write(text.replace(fault.good, fault.bad))
    return rtl


def follow(proof, folder, what, cycles):
    """From the reset on."""
    if proof.abc:
        ask_abc(folder, what, cycles)
    else:
        ask_z3(folder, what, "-t", str(cycles))


def prove(proof, folder):
    """Proves it and has it find its fault. Returns None or what stands against it, where the fault showed,
    and the seconds of the proof."""
    start = time.monotonic()
    sound, broken = f"{folder}/{proof.name}", f"{folder}/{proof.name}-broken"
    try:
        read(sound, f"{ROOT}/rtl", proof)
        follow(proof, sound, "base", proof.depth)
        if proof.method == "induction":
            ask_z3(sound, "step", "-i", "-t", str(proof.depth))
    except Disproved as against:
        return str(against), "", time.monotonic() - start
    seconds = time.monotonic() - start
    # Of gates ABC finds it much sooner.
    hunt = dataclasses.replace(proof, abc=proof.abc or proof.bits)
    try:
        read(broken, broken_rtl(broken, proof.fault), hunt)
        follow(hunt, broken, "fault", proof.reach if proof.method == "induction" else proof.depth)
    except Disproved as found:
        return ("its fault: " + str(found) if "no answer" in str(found) else None), str(found).split()[0], seconds
    return "its fault passes unnoticed", "", seconds
