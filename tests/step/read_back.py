"""read_back.py STEP_READ: solids of `phrame sweep --exact -o body.step`, read back by Open CASCADE.

The area of the sides is compared with that of the exact surface of the JSON, whose patches are integrated here by Gauss's
rule with derivatives of the control points; that of the caps with the profile's, the volume with Pappus's.
"""
import json
import math
import shutil
import subprocess
import sys
import tempfile
from fractions import Fraction
from math import comb
from pathlib import Path

from gauss import legendre
from program import PROGRAM, phrame

ROOT = Path(__file__).resolve().parent.parent.parent
CURVES = ROOT / "examples/curves"
READER = sys.argv[1]
RULE = [((1 + x) / 2, w / 2) for x, w in legendre(32)]  # on [0, 1]


def bernstein(n, t):
    """The values and derivatives."""
    values = [comb(n, k) * t ** k * (1 - t) ** (n - k) for k in range(n + 1)]
    less = [comb(n - 1, k) * t ** k * (1 - t) ** (n - 1 - k) for k in range(n)]
    return values, [n * ((less[k - 1] if k else 0) - (less[k] if k < n else 0)) for k in range(n + 1)]


def area(patch):
    """And the integrals of x, y and z over it."""
    weights = [[float(Fraction(w)) for w in row] for row in patch["weights"]]
    points = [[[float(Fraction(x)) for x in p] + [1.0] for p in row] for row in patch["points"]]
    of_u = [(bernstein(patch["degree_u"], u), w) for u, w in RULE]
    total = [0.0] * 4
    for t, weight in RULE:
        values, rates = bernstein(patch["degree_t"], t)
        columns = [[[sum(b[k] * weights[k][l] * points[k][l][axis] for k in range(len(points))) for axis in range(4)]
                    for l in range(patch["degree_u"] + 1)] for b in (values, rates)]
        for (of, rate), weight_u in of_u:
            s, st = ([sum(b * c[axis] for b, c in zip(of, column)) for axis in range(4)] for column in columns)
            su = [sum(b * c[axis] for b, c in zip(rate, columns[0])) for axis in range(4)]
            a, b = ([(d[k] * s[3] - s[k] * d[3]) / s[3] ** 2 for k in range(3)] for d in (su, st))
            n = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
            part = weight * weight_u * math.sqrt(n[0] ** 2 + n[1] ** 2 + n[2] ** 2)
            total = [sum_ + part * x for sum_, x in zip(total, (1, *(s[k] / s[3] for k in range(3))))]
    return total


def check(name, profile, caps, *more, section=None, slack=1e-9):
    """`caps` are the areas of the ends, `section` one that is the same all along. No side is plane. Areas may be off by
    the slack, of themselves; volumes, which are integrated to 1e-9, by 100 times that.
    """
    options = ["sweep", CURVES / name, "--exact", "--profile", profile, *more]
    surface = json.loads(phrame(*options, "--format", "json"))
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "body.step"
        phrame(*options, "-o", file)
        assert file.read_text().startswith("ISO-10303-21;")
        read = subprocess.run([READER, file], capture_output=True, text=True, check=True)
        found = json.loads(read.stdout)
    assert found["solids"] == 1 and found["valid"], found
    assert found["faces"] == len(surface["patches"]) + len(caps), found
    sides, *moments = map(sum, zip(*map(area, surface["patches"])))
    assert abs(found["curved"] - sides) < slack * sides and abs(found["plane"] - sum(caps)) < slack, (found, sides)
    assert all(abs(x - moment / sides) < 1e-8 for x, moment in zip(found["center"], moments)), (found, moments)
    if section:
        along = json.loads(phrame("totals", CURVES / name, "--digits", 17, "--print", "json"))["length"]
        assert abs(found["volume"] - section * float(along["value"])) < 100 * slack * found["volume"], found
    print("%s, %s: %d faces, sides %.15g, read back %.15g" % (
        name, " ".join(map(str, options[3:])), found["faces"], sides, found["curved"]))


def check_without():
    """A program that stands alone names what it lacks, and writes nothing."""
    with tempfile.TemporaryDirectory() as folder:
        alone = Path(folder) / "bin/phrame"
        alone.parent.mkdir()
        shutil.copy(PROGRAM, alone)
        body = Path(folder) / "body.step"
        run = subprocess.run([alone, "sweep", CURVES / "plane-cubic.json", "--exact", "--profile", "circle:1", "-o", body],
                             capture_output=True, text=True)
        assert run.returncode == 2 and not body.exists()
        assert run.stderr == 'phrame: --format: "step" needs Open CASCADE, and this phrame was built without\n', run.stderr


check_without()
check("rational-frame-quintic.json", "circle:1/50", [math.pi / 2500] * 2, section=math.pi / 2500)
check("plane-cubic.json", "circle:1/3", [math.pi * 4 / 9, math.pi / 36], "--scale", "(2 - t)/(1 + t)")
check("septic-erf-is-rmf.json", "rectangle:1/5,1/10", [1 / 50] * 2, section=1 / 50)
check("farouki-2003-quintic.json", "rectangle:1/5,1/5", [1 / 25] * 2, "--end-normal", "0,0,1", section=1 / 25)
HOLLOW = "M 10 0 A 10 10 0 1 0 -10 0 A 10 10 0 1 0 10 0 M 2 0 H 5 V 4 H 2 Z M -2 0 h -3 v -4 h 3"  # two equal holes
with tempfile.TemporaryDirectory() as folder:
    hollow = Path(folder) / "hollow.svg"
    hollow.write_text(HOLLOW)
    area_of = (math.pi * 100 - 24) / 10000
    check("septic-erf-is-rmf.json", hollow, [area_of] * 2, "--scale", "1/100", section=area_of)
    check("farouki-2003-quintic.json", hollow, [area_of] * 2, "--scale", "1/100", "--end-normal", "0,0,1", section=area_of)
    check("plane-cubic.json", hollow, [area_of, area_of / 4], "--scale", "1/100 - t/200")
    check("closed-spline.json", hollow, [], "--degree", "2", "--scale", "1/100", section=area_of)  # with voids
check("closed-spline.json", "circle:1/8", [], "--degree", "2", section=math.pi / 64)
# Far from 0, where 13 digits, as Open CASCADE has by itself, are too few.
with tempfile.TemporaryDirectory() as folder:
    far = Path(folder) / "far.json"
    curve = json.loads((CURVES / "farouki-2003-quintic.json").read_text())
    for offset, slack in ((10 ** 3, 1e-9), (10 ** 6, 1e-7)):
        far.write_text(json.dumps({**curve, "start": [offset, -offset, offset]}))
        check(far, "rectangle:1/5,1/5", [1 / 25] * 2, "--end-normal", "0,0,1", section=1 / 25, slack=slack)
    far.write_text(json.dumps({**curve, "start": [10 ** 9, 0, 0]}))
    run = subprocess.run([PROGRAM, "sweep", far, "--exact", "--profile", "circle:1/10", "--end-normal", "0,0,1", "-o",
                          Path(folder) / "far.step"], capture_output=True, text=True)
    assert run.returncode == 3 and "too far from 0 for its size" in run.stderr, run.stderr
    assert not (Path(folder) / "far.step").exists()
