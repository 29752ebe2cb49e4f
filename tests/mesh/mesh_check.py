"""Bodies far from the origin, as files have them: `phrame sweep` read by code of its own, in fractions of the numbers in
the files.

A tube of radius R around Farouki's quintic of 2003: no point of the mesh may be farther from the curve than R and the
bound that was printed, no corner nearer than R less it; that is seen of corners and middles of triangles, by Newton's
method from many t, of the curve where it starts at 0. Of all corners: they are apart, each side of a triangle lies
opposite to just one other, with corners told by their numbers alone, and no triangle is without an area. STL's normals
are those of its triangles. What cannot be so in floats must be refused with status 4 and the way out.
"""
import json
import math
import os
import re
import struct
import subprocess
import tempfile
from fractions import Fraction
from pathlib import Path

from program import PROGRAM

ROOT = Path(__file__).resolve().parent.parent.parent
CURVE = json.loads((ROOT / "examples/curves/farouki-2003-quintic.json").read_text())
RADIUS = Fraction(1, 10)
FEW = 25 * int(os.environ.get("PHRAME_TEST_MULTIPLIER", "1"))


def position(preimage):
    """r with r(0) = 0, from Bernstein coefficients of degree 2."""
    u, v, p, q = ([b[0], 2 * (b[1] - b[0]), b[0] - 2 * b[1] + b[2]] for b in (preimage[k] for k in "uvpq"))

    def times(a, b):
        return [sum(a[i] * b[k - i] for i in range(3) if 0 <= k - i < 3) for k in range(5)]
    uu, vv, pp, qq, uq, vp, vq, up = map(times, (u, v, p, q, u, v, v, u), (u, v, p, q, q, p, q, p))
    rate = ([a + b - c - d for a, b, c, d in zip(uu, vv, pp, qq)], [2 * (a + b) for a, b in zip(uq, vp)],
            [2 * (a - b) for a, b in zip(vq, up)])
    return [[0.0] + [c / (k + 1) for k, c in enumerate(part)] for part in rate]


R = [position(CURVE["preimage"])]
for _ in range(2):
    R.append([[k * x for k, x in enumerate(c)][1:] for c in R[-1]])


def at(t, order):
    return [sum(x * t ** k for k, x in enumerate(c)) for c in R[order]]


SAMPLES = [(k / 50, at(k / 50, 0)) for k in range(51)]


def nearest(p):
    """The t of the curve's point next to it."""
    t = min(SAMPLES, key=lambda sample: math.dist(sample[1], p))[0]
    for _ in range(6):
        off = [a - b for a, b in zip(at(t, 0), p)]
        d1, d2 = at(t, 1), at(t, 2)
        slope = sum(x * y for x, y in zip(off, d1))
        t = min(1.0, max(0.0, t - slope / sum(x * x + y * z for x, y, z in zip(d1, off, d2))))
    return t


def distance(p):
    """From the curve, of a point given as fractions: to 10^-15 or so."""
    p = [float(x) for x in p]
    return math.dist(at(nearest(p), 0), p)


def read_obj(data):
    lines = [line.split() for line in data.decode().splitlines()]
    points = [tuple(map(float, line[1:])) for line in lines if line[0] == "v"]
    origin = next((line[2:] for line in lines if line[:2] == ["#", "origin"]), [0, 0, 0])
    return points, [tuple(int(k) - 1 for k in line[1:]) for line in lines if line[0] == "f"], origin


def read_ply(data):
    header, _, body = data.partition(b"end_header\n")
    lines = header.decode().splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"]
    n, m = (int(re.search(r"element %s (\d+)" % name, header.decode())[1]) for name in ("vertex", "face"))
    points = list(struct.iter_unpack("<3d", body[:24 * n]))
    triangles = [row[1:] for row in struct.iter_unpack("<B3I", body[24 * n:])]
    assert len(triangles) == m
    origin = next((line.split()[2:] for line in lines if line.startswith("comment origin ")), [0, 0, 0])
    return points, triangles, origin


def read_stl(data):
    """Corners that have the same numbers are one, as readers of STL have it."""
    count, = struct.unpack_from("<I", data, 80)
    numbers, triangles = {}, []
    for row in struct.iter_unpack("<12fH", data[84:]):
        corners = [row[k:k + 3] for k in (3, 6, 9)]
        triangles.append(tuple(numbers.setdefault(corner, len(numbers)) for corner in corners))
        a, b, c = corners
        u, v = ([x - y for x, y in zip(end, a)] for end in (b, c))
        normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        size = math.hypot(*normal)
        assert all(abs(x / size - y) < 1e-6 for x, y in zip(normal, row[:3])), (row, normal)
    assert len(triangles) == count
    origin = re.search(rb"; origin (\S+) (\S+) (\S+)", data[:80])
    return list(numbers), triangles, [x.decode() for x in origin.groups()] if origin else [0, 0, 0]


def read_glb(data):
    size, = struct.unpack_from("<I", data, 12)
    document, buffer = json.loads(data[20:20 + size]), data[28 + size:]
    node, = document["nodes"]
    views, accessors = document["bufferViews"], document["accessors"]
    points = list(struct.iter_unpack("<3f", buffer[:views[0]["byteLength"]]))
    start = views[1]["byteOffset"]
    triangles = list(struct.iter_unpack("<3I", buffer[start:start + views[1]["byteLength"]]))
    for k in range(3):
        low, high = (struct.unpack("<f", struct.pack("<f", accessors[0][key][k]))[0] for key in ("min", "max"))
        assert (low, high) == (min(p[k] for p in points), max(p[k] for p in points))
    return points, triangles, node.get("translation", [0, 0, 0])


READ = {"obj": read_obj, "ply": read_ply, "stl": read_stl, "glb": read_glb}


def has_area(a, b, c):
    """In doubles where these are sure, else in fractions."""
    for number, slack in ((float, 1e-12), (Fraction, 0)):
        u, v = ([number(x) - number(y) for x, y in zip(end, a)] for end in (b, c))
        if any(abs(u[i] * v[j] - u[j] * v[i]) > slack * (abs(u[i] * v[j]) + abs(u[j] * v[i]))
               for i, j in ((0, 1), (1, 2), (2, 0))):
            return True
    return False


def check_body(name, points, triangles):
    assert len(set(points)) == len(points), "%s: %d of %d points are distinct" % (name, len(set(points)), len(points))
    sides = {side for i, j, k in triangles for side in ((i, j), (j, k), (k, i))}
    assert len(sides) == 3 * len(triangles) and all((j, i) in sides for i, j in sides), name
    for i, j, k in triangles:
        assert has_area(points[i], points[j], points[k]), (name, i, j, k)


def sweep(place, suffix, *options):
    with tempfile.TemporaryDirectory() as folder:
        curve, file = Path(folder) / "curve.json", Path(folder) / ("body." + suffix)
        curve.write_text(json.dumps({**CURVE, "start": [str(x) for x in place]}))
        run = subprocess.run([PROGRAM, "sweep", curve, "--profile", "circle:%s" % RADIUS, "-o", file, *options],
                             capture_output=True, text=True)
        assert (run.returncode == 0) == file.exists()
        return run, file.read_bytes() if file.exists() else b""


def check(place, suffix, *options, tolerance=Fraction(1, 40)):
    """Is a file written, and as it was said to be? None where it was refused, else the bound."""
    name = (suffix, [str(x) for x in place], options)
    run, data = sweep(place, suffix, "--tolerance", str(tolerance), *options)
    if run.returncode != 0:
        assert run.returncode == 4 and "PLY" in run.stderr and "--origin auto" in run.stderr, (name, run.stderr)
        return None
    bound = Fraction(re.search(r"within (\S+) of", run.stdout)[1])
    assert bound <= tolerance * Fraction(51, 50), name  # which is printed rounded up
    points, triangles, origin = READ[suffix](data)
    assert (suffix == "glb") or ("coordinates are from %s,%s,%s" % tuple(origin) in run.stdout) == any(origin)
    check_body(name, points, triangles)
    shift = [Fraction(x) - y for x, y in zip(origin, place)]

    def local(k):
        return [Fraction(x) + y for x, y in zip(points[k], shift)]
    for k in range(0, len(points), len(points) // FEW):
        off = distance(local(k))
        assert abs(off - RADIUS) <= bound + 1e-13, (name, float(off - RADIUS), float(bound))
    for corners in triangles[::len(triangles) // FEW]:
        middle = [sum(xs) / 3 for xs in zip(*map(local, corners))]
        assert distance(middle) <= RADIUS + bound + 1e-13, name
    return bound


def check_normals(place, suffix):
    """From those of triangles to the directions from the curve to their corners."""
    run, data = sweep(place, suffix, "--tolerance", "1", "--normal-tolerance", "10deg")
    assert run.returncode == 0, run.stderr
    bound = float(re.search(r"normals within (\S+) rad", run.stdout)[1])
    assert bound <= 0.18  # 10 degrees, rounded up
    points, triangles, origin = READ[suffix](data)
    greatest = 0
    for corners in triangles[::len(triangles) // FEW]:
        p = [[float(Fraction(x) + Fraction(o) - y) for x, o, y in zip(points[k], origin, place)] for k in corners]
        u, v = ([x - y for x, y in zip(end, p[0])] for end in p[1:])
        normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        ts = [nearest(corner) for corner in p]
        if max(ts) - min(ts) < 1e-3:
            continue  # a cap: all of it is in one section
        out = [[x - y for x, y in zip(corner, at(t, 0))] for corner, t in zip(p, ts)]
        for d in out:
            cosine = sum(x * y for x, y in zip(d, normal)) / math.hypot(*d) / math.hypot(*normal)
            greatest = max(greatest, math.acos(min(1, cosine)))
    assert bound / 4 < greatest <= bound, (place, suffix, greatest, bound)


def main():
    count = refused = 0
    for power in (None, 3, 6, 9):
        offset = Fraction(0 if power is None else 10 ** power)
        places = [(offset, offset, offset)] + [(offset, 0, -offset / 7)] * (power == 6)
        for place in places:
            for suffix in READ:
                for options in [()] + [("--origin", "auto")] * (suffix == "stl"):
                    found = check(place, suffix, *options)
                    count += 1
                    refused += found is None
                    # Only floats far from their origin are too coarse.
                    assert (found is None) == (suffix == "stl" and not options and offset >= 10 ** 6), (place, suffix)
    # An origin that is no double, and one that is far away.
    assert check((1000, 1000, 0), "stl", "--origin", "2999/3,1000,0") is not None
    assert check((1000, 1000, 0), "glb", "--origin", "2999/3,1000,0") is not None
    assert check((0, 0, 0), "stl", "--origin", "1e7,0,0") is None
    assert check((0, 0, 0), "ply", "--origin", "1e7,0,0") is not None
    # Floats at 1000 are 3e-5 off.
    assert check((1000, 1000, 0), "stl", tolerance=Fraction(3, 100000)) is None
    assert check((1000, 1000, 0), "glb", tolerance=Fraction(1, 500)) is not None
    for place, suffix in (((0, 0, 0), "stl"), ((300, 0, -300), "stl"), ((10 ** 6, 0, 0), "glb"), ((10 ** 9, 0, 1), "ply")):
        check_normals(place, suffix)
    print("%d meshes, %d of them refused" % (count, refused))


main()
