"""The G-code of `phrame interpolate`, read word by word and put through the kinematics of a machine: C turns A turns the tool.

What comes out are points and tools of `phrame frames` at the t of `phrame interpolate`, to within half a unit of the
last decimal. Angles must go the nearest way, and stand still at a pole.
"""
import csv
import io
import re
import tempfile
from math import atan2, cos, degrees, hypot, pi, sin
from pathlib import Path

from program import phrame

ROOT = Path(__file__).resolve().parent.parent.parent


def table(*arguments):
    return [{k: float(x) for k, x in row.items()} for row in csv.DictReader(io.StringIO(phrame(*arguments)))]


def moves(program, places):
    """[(X, Y, Z, A, C, F or None, is there a word of a pole?)], after the rules of the language are seen to hold."""
    lines = program.splitlines()
    assert lines[0] == "%" and lines[-1] == "%"
    assert all(ord(c) < 128 for c in program)
    found, number, motion, modes = [], 0, None, set()
    for line in lines[1:-1]:
        comments = re.findall(r"\(([^()]*)\)", line)
        code = re.sub(r"\([^()]*\)", "", line)
        assert "(" not in code and ")" not in code
        words = re.findall(r"([A-Z])(-?[0-9]+(?:\.[0-9]+)?)", code)
        assert "".join(a + b for a, b in words) == code.replace(" ", "")
        if not words:
            continue
        number += 1
        assert words[0] == ("N", str(number))
        letters = {}
        for letter, value in words[1:]:
            if letter == "G":
                if value in ("0", "1"):
                    motion = value
                else:
                    modes -= {"93", "94"} if value in ("93", "94") else set()
                    modes.add(value)
                continue
            assert letter not in letters
            letters[letter] = value
        if "X" not in letters:
            continue
        assert "90" in modes and ("93" in modes) == (motion == "1") == ("F" in letters)
        for value in letters.values():
            assert len(value.split(".")[1]) == places and not re.fullmatch(r"-0\.0*", value)
        units = {k: int(v.replace(".", "")) for k, v in letters.items()}
        found.append(([units[k] for k in "XYZ"], units["A"], units["C"], units.get("F"), comments))
    assert "94" in modes and letters == {"M": "30"}
    assert found[0][3] is None and all(f > 0 for _, _, _, f, _ in found[1:])
    return found


def check_angles(path, rows, tool, places):
    """Of the tools of the rows."""
    unit, half_turn, poles = 10 ** places, 180 * 10 ** places, 0
    last, has_turned = None, False
    for (_, a, c, _, comments), row in zip(path, rows):
        x, y, z = (row[tool + k] for k in "xyz")
        tilt, turn = degrees(atan2(hypot(x, y), z)) * unit, degrees(atan2(x, -y)) * unit
        is_pole = a % half_turn == 0
        assert bool(comments) == is_pole
        if is_pole:
            poles += 1
            assert abs(abs(a) - tilt) < 0.5 + 1e-4 and (last is None or c == last[1])
        else:
            if a < 0:
                turn += half_turn
            assert abs(abs(a) - tilt) < 0.5 + 1e-4, (a, tilt)
            off = (c - turn) % (2 * half_turn)
            assert min(off, 2 * half_turn - off) < 0.5 + 1e-4 + 1e-13 * unit / hypot(x, y), (c, turn)
            way = lambda b, d: max(abs(b - last[0]), abs(d - last[1]))
            if not has_turned:
                assert a > 0 and -half_turn < c <= half_turn and (last is None or c == last[1])
            else:
                others = [(b, d + 2 * half_turn * k) for b, d in ((a, c), (-a, c + half_turn)) for k in range(-3, 4)]
                assert all(way(a, c) <= way(*other) for other in others), (last, a, c)
            has_turned = True
        last = a, c
    return poles


def check(curve, feed, period, tool="f3", places=4, poles=0, frame=()):
    motion = table("interpolate", curve, "--feed", feed, "--period", period)
    choice = ["--feed", feed, "--period", period, "--places", places, *frame] + (["--tool", tool] if tool != "f3" else [])
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "path.nc"
        phrame("interpolate", curve, *choice, "-o", file)
        program = file.read_text(encoding="ascii")
    assert "(phrame: a motion with the tool along %s of" % tool in program
    assert tool == "e1" or re.search(r"\n\((at the start the|f2 at the start is) [^()]+\)\n", program)
    path = moves(program, places)
    assert len(path) == len(motion)
    rows = table("frames", curve, "--at", ",".join(repr(row["t"]) for row in motion), *frame)
    unit = 10 ** places
    for (tip, _, _, feed_units, _), row, before in zip(path, motion, [None] + motion):
        for n, k in zip(tip, "xyz"):
            assert abs(n - row[k] * unit) <= 0.5 + 1e-4, (n, row[k])
        if before:
            exact = 60 / (row["time"] - before["time"]) * unit
            assert abs(feed_units - exact) <= 0.5 + 1e-9 * exact, (feed_units, exact)
    found = check_angles(path, rows, tool, places)
    assert found == poles, (found, poles)
    return len(path)


QUINTIC = ROOT / "examples/curves/farouki-2003-quintic.json"
CLOSED = ROOT / "examples/curves/closed-spline.json"
count = 0
for tool in ("f3", "f2", "e1"):
    count += check(QUINTIC, "1 + s/2", "1/20", tool)
    count += check(CLOSED, "2", "1/4", tool, places=3, poles=int(tool == "f3"))  # where it starts
    count += check(ROOT / "examples/any/helix.json", "3", "1/2", tool, places=5)
count += check(QUINTIC, "1", "1/3", "f2", places=6, frame=("--start-normal", "1,2,3"))
count += check(ROOT / "examples/any/helix.json", "3 + s", "1", "f2", frame=("--start", "up", "--theta0", "45deg", "--up", "1,2,3"))
count += check(QUINTIC, "50", "100", "e1")  # one move
plane = ROOT / "examples/curves/plane-cubic.json"
count += check(plane, "1", "1/10", poles=15)
with tempfile.TemporaryDirectory() as folder:
    # e1 is along (1 - 4t^2, 0, 4t), or its opposite in z, and |r'| is 1 + 4t^2, so that t is the time: at t = 1/2 it is
    # at a pole, and beyond it A goes on.
    for sign in "-", "":
        curve = Path(folder) / "over.json"
        curve.write_text('{"phrame": "curve/1", "basis": "power", "preimage": {"u": [1], "v": [0], "p": [0, %s2], "q": [0]}}'
                         % sign)
        count += check(curve, "1 + 4*t^2", "1/8", "e1", poles=1)
        turns = [c for _, _, c, _, _ in moves(phrame("interpolate", curve, "--feed", "1+4*t^2", "--period", "1/8", "--tool",
                                                     "e1", "--format", "gcode"), 4)]
        assert sign == "" or set(turns) == {900000}
        count += check(curve, "1 + 4*t^2", "1/7", "e1")
    # A turn about z, twice: C goes on beyond 180 degrees.
    points = Path(folder) / "circle.csv"
    points.write_text("".join("%r,%r,%r\n" % (cos(k * pi / 4), sin(k * pi / 4), k / 10) for k in range(17)))
    coil = Path(folder) / "coil.json"
    phrame("construct", points, "-o", coil)
    count += check(coil, "1", "1/4", "e1")
    last = moves(phrame("interpolate", coil, "--feed", "1", "--period", "1/4", "--tool", "e1", "--format", "gcode"), 4)
    assert abs(last[-1][2] - last[0][2]) > 6500000
print("%d moves" % count)
