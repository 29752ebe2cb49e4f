"""Clipper2, an outside polygon clipper, makes the same offsets, of polygons next to the curve: their areas are between those
of the exact offsets at slightly other distances, which is proved.

Let no point of the polygon be farther than e from the curve, and none of the curve farther than e from the polygon. The
points inside of a curve that are farther from it than d + e are farther than d from the polygon, and inside of that, too. So
the area that Clipper2 finds lies between those at d − e and d + e. e is the chord error |r″|/(8N²), with |r″| from Bernstein
coefficients, and what Clipper2 adds: the sagitta of its arcs and the rounding of coordinates to integers. Of polygons with
rational edges and mitres, areas are equal but for the rounding.

With PHRAME_TEST_MULTIPLIER=m > 1 there are m random curves, at distances over four decades to both sides: one by 10^5 points,
which takes Clipper2 minutes, the others by 10^4.
"""
import cmath
import json
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction
from math import comb

try:
    import numpy
    import pyclipr
except ImportError:
    print("the Python package pyclipr is not installed")
    sys.exit(77)

from program import phrame

N = 500  # chords of a segment
SCALE = 10**8  # integers of Clipper2 in a unit
ARC = Fraction(1, 10**5)  # the sagitta of its arcs
POINTS = ["0,0,0 4,1,0 6,4,0 3,3,0 1,5,0 -2,2,0", "0,0,0 6,-1,0 7,3,0 4,4,0 4,7,0 0,6,0"]


def bernstein(power):
    """The Bernstein coefficients on [0, 1] of a polynomial of degree 2."""
    power = [Fraction(x) for x in power] + [Fraction(0)] * (3 - len(power))
    return [sum(Fraction(comb(r, k), comb(2, k)) * power[k] for k in range(r + 1)) for r in range(3)]


def greatest_second_derivative(segment):
    """A bound of |r″| = |f||2ww′| on a segment with r′ = f·w², w = u + iq."""
    u, q = (bernstein(segment["preimage"][key]) for key in "uq")
    size = max(abs(complex(a, b)) for a, b in zip(u, q))
    rate = max(abs(complex(u[k + 1] - u[k], q[k + 1] - q[k])) for k in range(2)) * 2
    f = abs(Fraction(segment.get("multiplier", ["1"])[0]))
    return 1.001 * float(f) * 2 * size * rate


def area_of(paths):
    area = 0
    for x, y in (numpy.asarray(path)[:, :2].T for path in paths):
        area += float(numpy.sum(x * numpy.roll(y, -1) - numpy.roll(x, -1) * y)) / 2
    return area


def polygon_area(polygon, delta, join, arc):
    """Of all that Clipper2 makes, holes counted as such."""
    clipper = pyclipr.ClipperOffset()
    clipper.scaleFactor = SCALE
    clipper.arcTolerance = float(arc) * SCALE
    clipper.miterLimit = 1000
    clipper.addPath(numpy.asarray(polygon), join, pyclipr.EndType.Polygon)
    return area_of(clipper.execute(delta))


def exact_area(file, d, join="round"):
    answer = json.loads(phrame("offset", file, "--distance", str(d), "--trim", "--join", join, "--print", "json"))
    branches = answer["trimmed"][0]["branches"]
    assert answer["trimmed"][0]["undecided"] == [], (file, d)
    return sum(float(branch["area"]["value"]) for branch in branches)


def check(condition, *what):
    if not condition:
        sys.exit("clipper: %s" % (what,))


def is_simple(polygon):
    """Has what is inside the area that the polygon goes around?"""
    clipper = pyclipr.Clipper()
    clipper.scaleFactor = SCALE
    clipper.addPath(numpy.asarray(polygon), pyclipr.Subject)
    inside = clipper.execute(pyclipr.Union, pyclipr.FillRule.NonZero)
    x, y = numpy.asarray(polygon).T
    around = float(numpy.sum(x * numpy.roll(y, -1) - numpy.roll(x, -1) * y)) / 2
    return len(inside) == 1 and around > 0 and abs(abs(area_of(inside)) - around) < 1e-5


def check_curve(folder, points, count=N, arc=ARC, distances=(Fraction(-3, 5), Fraction(7, 5))):
    """Whether it was compared: whether the curve does not meet itself."""
    data = os.path.join(folder, "points.csv")
    file = os.path.join(folder, "curve.json")
    with open(data, "w") as out:
        out.write("x,y,z\n" + points.replace(" ", "\n") + "\n")
    phrame("construct", data, "--kind", "planar", "--closed", "-o", file)
    with open(file) as text:
        segments = json.load(text)["segments"]
    table = phrame("frames", file, "--samples", len(segments) * count + 1).splitlines()
    polygon = [[float(x) for x in line.split(",")[1:3]] for line in table[1:-1]]
    if not is_simple(polygon):
        return False
    chord = max(map(greatest_second_derivative, segments)) / (8 * count * count)
    e = Fraction(chord) + arc + Fraction(4, SCALE)
    e = Fraction(round(e * 10**12), 10**12)
    for d in distances:
        found = polygon_area(polygon, float(d), pyclipr.JoinType.Round, arc)
        least, most = exact_area(file, d - e), exact_area(file, d + e)
        check(least <= found <= most, points, d, least, found, most)
        check(most - least < 1e-3 * max(most, 1), "the bounds are apart", least, most)
        check(found < 1 or not least <= found * (1 + 2e-4) <= most or not least <= found * (1 - 2e-4) <= most, "the bounds tell nothing")
    return True


def check_mitres(folder, corners):
    file = os.path.join(folder, "polygon.json")
    ends = corners[1:] + corners[:1]
    with open(file, "w") as out:
        json.dump({"phrame": "spline/1", "segments": [{"control_points": [[*a, 0], [*b, 0]]} for a, b in zip(corners, ends)]}, out)
    for d in (Fraction(-1, 3), Fraction(-1), Fraction(1, 2), Fraction(3)):
        found = polygon_area(corners, float(d), pyclipr.JoinType.Miter, ARC)
        exact = exact_area(file, d, "mitre")
        check(abs(found - exact) < 1e-5 * max(1, exact), "mitres", corners, d, found, exact)


with tempfile.TemporaryDirectory() as folder:
    for points in POINTS:
        check(check_curve(folder, points), "meets itself", points)
    check_mitres(folder, [[0, 0], [10, 0], [10, 4], [14, 4], [14, 0], [24, 0], [24, 10], [14, 10], [14, 6], [10, 6], [10, 10], [0, 10]])
    check_mitres(folder, [[0, 0], [12, 0], [12, 5], [8, 8], [12, 11], [12, 16], [0, 16], [3, 12], [0, 8]])
    count = int(os.environ.get("PHRAME_TEST_MULTIPLIER", "1"))
    seed = compared = 0
    while compared < (count if count > 1 else 0):
        seed += 1
        draw = random.Random(seed)
        n = draw.randint(5, 9)
        around = [cmath.rect(draw.uniform(1, 4), 2 * cmath.pi * (k + draw.uniform(-0.3, 0.3)) / n) for k in range(n)]
        points = " ".join("%.2f,%.2f,0" % (z.real, z.imag) for z in around)
        distances = [s * Fraction(draw.randint(10, 99)) / 10**draw.randint(1, 4) for s in (1, -1)]
        compared += check_curve(folder, points, (10**4 if compared else 10**5) // n, Fraction(1, 10**7), distances)
        print(seed, compared, points, distances, flush=True)
print("areas of Clipper2 are between those that are proved")
