"""Scene files with nasty numbers, and what the program has to make of them.

Each is loaded and lit by the cycle model, which `rc2 run` compares with golden and holds against the
laws (exit codes 3 and 4), or refused with one sentence (exit code 2). Anything else is wrong.
"""

import pathlib
import re
import struct
import subprocess
import tempfile

DONE, REFUSED = 0, 2


def obj(*vertices, faces=("1 2 3",)):
    return "".join(f"v {v}\n" for v in vertices) + "".join(f"f {f}\n" for f in faces)


def stl_with(bits):
    """A binary STL whose first coordinate has these bits."""
    corners = struct.pack("<12f", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0)
    return b"\0" * 80 + struct.pack("<I", 1) + corners[:12] + struct.pack("<I", bits) + corners[16:] + b"\0\0"


FIT, NONE = ("--fit", "cube"), ("--fit", "none")

# name, file, exit code, options
FILES = [
    ("a coordinate that is NaN", obj("nan 0 0", "1 0 0", "0 1 0"), REFUSED, FIT),
    ("minus NaN, not fitted", obj("-nan 0 0", "1 0 0", "0 1 0"), REFUSED, NONE),
    ("infinite", obj("inf 0 0", "1 0 0", "0 1 0"), REFUSED, FIT),
    ("minus infinite, not fitted", obj("-inf 0 0", "1 0 0", "0 1 0"), REFUSED, NONE),
    ("1e39, beyond single precision", obj("1e39 0 0", "1 0 0", "0 1 0"), REFUSED, FIT),
    ("binary STL, signalling NaN", stl_with(0x7FA00000), REFUSED, FIT),
    ("binary STL, infinite", stl_with(0x7F800000), REFUSED, FIT),
    ("binary STL, least denormal", stl_with(1), DONE, FIT),
    ("a triangle of 1e38", obj("1e38 0 0", "0 1e38 0", "0 0 1e38"), DONE, FIT),
    ("the whole range of single precision", obj("3.4e38 0 0", "-3.4e38 0 0", "0 3.4e38 0"), DONE, FIT),
    ("1e38 beside 1", obj("1e38 0 0", "0 1e38 0", "0 0 1e38", "0 0 0", "1 0 0", "0 1 0", faces=("1 2 3", "4 5 6")),
     DONE, FIT),
    ("1e38, not fitted, outside", obj("1e38 1e38 0", "1e38 0 0", "1e38 0 1e38"), DONE, NONE),
    ("1e38, not fitted, through the cube", obj("1e38 4 4", "-1e38 4 4", "4 1e38 5"), REFUSED, NONE),
    ("a triangle of 1e-38", obj("1e-38 0 0", "0 1e-38 0", "0 0 1e-38"), DONE, FIT),
    ("a triangle of denormal numbers", obj("1e-44 0 0", "0 1e-44 0", "0 0 1e-44"), DONE, FIT),
    ("1e-320, which is 0", obj("1e-320 0 0", "0 1e-320 0", "0 0 1e-320"), REFUSED, FIT),
    ("size 1 at 1e7, where single precision ends", obj("1e7 0 0", "10000001 0 0", "1e7 1 0"), DONE, FIT),
    ("size 1 at 1e30, where it is a point", obj("1e30 1e30 1e30", "1e30 1e30 1e30", "1e30 1e30 1e30"), REFUSED, FIT),
    ("length / width 10^6", obj("0 0 0", "1e6 1 0", "1e6 0 0"), DONE, FIT),
    ("length / width 10^30", obj("0 0 0", "1e15 1e-15 0", "1e15 0 0"), DONE, FIT),
    ("minus 0", obj("-0 -0 -0", "5 -0 -0", "-0 5 -0"), DONE, NONE),
    ("on the border of the cube", obj("-0.5 -0.5 -0.5", "7.5 -0.5 -0.5", "-0.5 7.5 7.5"), DONE, NONE),
    ("a quarter beyond the border", obj("-0.75 -0.5 -0.5", "7.5 -0.5 -0.5", "-0.5 7.5 7.5"), REFUSED, NONE),
    ("n - 1/2 and 2^-20 more, which rounds to it", obj("0 0 0", "7.50000095 0 0", "0 5 5"), DONE, NONE),
    ("a point three times", obj("1 1 1", "1 1 1", "1 1 1"), REFUSED, FIT),
    ("a point three times, not fitted", obj("1 1 1", "1 1 1", "1 1 1"), DONE, NONE),
    ("a line", obj("0 0 0", "1 1 1", "2 2 2"), DONE, FIT),
    ("a bow tie", obj("0 0 0", "1 1 0", "1 0 0", "0 1 0", faces=("1 2 3 4",)), DONE, FIT),
    ("a concave polygon, not planar", obj("0 0 0", "4 0 1", "1 1 0", "0 4 1", faces=("1 2 3 4",)), DONE, FIT),
    ("one vertex a hundred times in a face", obj("0 0 0", "1 0 0", "0 1 0", faces=("1 2 3" + " 3" * 100,)), DONE, FIT),
    ("the same face a hundred times", obj("0 0 0", "1 0 0", "0 1 0", faces=("1 2 3",) * 100), DONE, FIT),
    ("faces of one and two vertices", obj("0 0 0", "1 0 0", "0 1 0", faces=("1", "1 2", "1 2 3")), DONE, FIT),
    ("only faces of two vertices", obj("0 0 0", "1 0 0", faces=("1 2",)), REFUSED, FIT),
    ("a vertex that is not there", obj("0 0 0", "1 0 0", "0 1 0", faces=("1 2 9",)), REFUSED, FIT),
    ("no vertex", "f 1 2 3\n", REFUSED, FIT),
]

FINE = ("--fraction-bits", "8", "--fa", "1", "--target-distance", "151")
FITTED_MACHINES = [("--n", "8"), ("--n", "3", "--fraction-bits", "0"), ("--n", "17", *FINE)]
# What is not fitted was made for this cube.
OTHER_MACHINES = [("--n", "8"), ("--n", "8", *FINE)]


def try_file(rc2, folder, content, expected, options):
    """(what the program said, what is wrong about it) in a folder without other files."""
    path = pathlib.Path(folder) / ("scene.obj" if isinstance(content, str) else "scene.stl")
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    ran = subprocess.run([rc2, "run", str(path), "--out", f"{folder}/out", *options],
                         capture_output=True, text=True, timeout=60, check=False)
    path.unlink()
    said = ran.stderr.strip().replace(str(path), path.name)
    if ran.returncode != expected:
        return said, f"exit code {ran.returncode}, not {expected}"
    if expected == REFUSED and not re.fullmatch(r"rc2: [^\n]{10,}", said):
        return said, "not one sentence"
    return said, ""


def try_all(rc2):
    """Yields (name, machine, what is expected, what the program said, what is wrong about it)."""
    for name, content, expected, fit in FILES:
        for machine in FITTED_MACHINES if fit == FIT else OTHER_MACHINES:
            with tempfile.TemporaryDirectory(prefix="rc2-stress-") as folder:
                yield (name, " ".join(machine), expected, *try_file(rc2, folder, content, expected, [*machine, *fit]))
