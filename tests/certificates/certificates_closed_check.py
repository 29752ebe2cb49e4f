"""Certificates of closed paths, their holonomy and writhe: both checkers say the same of those of the program and of forged ones. The values are
those of foreign computations: the holonomy that of double reflection [Wang et al. 2008] carried on to an infinite number of steps, the writhe that
of a closed polygon [Levitt 1983; Klenin, Langowski 2000], likewise.
"""
import copy
import json
import math
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from certificates_paths_check import ROOT, expect, phrame, product, run

def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def less(a, b):
    return [x - y for x, y in zip(a, b)]


def unit(a):
    size = math.sqrt(dot(a, a))
    return [x / size for x in a]


def places(certificate, steps):
    """r and the unit tangent at equal steps, in doubles, from preimage, multiplier and start alone."""
    out = []
    for segment in certificate["segments"]:
        curve = segment["curve"]
        A = [[Fraction(x) for x in curve["preimage"][k]] for k in "uvpq"]
        u, v, p, q = A
        f = [Fraction(x) for x in curve.get("multiplier", ["1"])]
        h = [times(f, c) for c in (plus(times(u, u), times(v, v), minus(times(p, p)), minus(times(q, q))),
                                   times([2], plus(times(u, q), times(v, p))), times([2], plus(times(v, q), minus(times(u, p)))))]
        start = [Fraction(x) for x in curve.get("start", ["0"] * 3)]
        r = [[float(s)] + [float(x / (k + 1)) for k, x in enumerate(c)] for s, c in zip(start, h)]
        for k in range(steps):
            t = k / steps
            out.append(([value(c, t) for c in r], unit([value([float(x) for x in c], t) for c in h])))
    return out


def times(a, b):
    c = [0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += x * y
    return c


def plus(*lists):
    return [sum(a[k] for a in lists if k < len(a)) for k in range(max(map(len, lists)))]


def minus(a):
    return [-x for x in a]


def value(c, t):
    total = 0.0
    for x in reversed(c):
        total = total * t + x
    return total


def holonomy_by_reflection(points):
    (r, T), n = points[0], len(points)
    first = f = unit(cross(T, [1, 0, 0] if abs(T[0]) < 0.5 else [0, 1, 0]))
    start = T
    for k in range(1, n + 1):
        s, U = points[k % n]
        for a in (less(s, r), None):
            if a is None:
                a = less(U, T)
                if dot(a, a) < 1e-30:
                    break
            c = dot(a, a)
            f, T = ([x - 2 * dot(a, y) / c * z for x, z in zip(y, a)] for y in (f, T))
        r, T = s, U
    return math.atan2(dot(f, cross(start, first)), dot(f, first))


def writhe_by_polygon(points):
    """The sum over pairs of edges of the signed area on the sphere of the directions in which one is seen from the other, two triangles
    [Van Oosterom, Strackee 1983]."""
    p, total = [r for r, _ in points], 0.0
    n = len(p)
    seen = [[unit(less(b, a)) if i < j else None for j, b in enumerate(p)] for i, a in enumerate(p)]

    def triangle(a, b, c):
        return 2 * math.atan2(dot(a, cross(b, c)), 1 + dot(a, b) + dot(b, c) + dot(c, a))

    for i in range(n):
        for j in range(i + 2, n - (i == 0)):
            k = (j + 1) % n
            a, b = seen[i][j], seen[i + 1][j]
            d, c = (seen[i][k], seen[i + 1][k]) if k else (unit(less(p[0], p[i])), unit(less(p[0], p[i + 1])))
            total += (triangle(a, b, c) + triangle(a, c, d)) / (2 * math.pi)
    return total


def at_infinity(find, order, certificate, steps):
    """Errors fall with that power of the step: (one step of Richardson's, what it may be off)."""
    a, b = find(places(certificate, steps)), find(places(certificate, 2 * steps))
    return b + (b - a) / (2 ** order - 1), abs(b - a) / 10 + 1e-9


def forgeries(honest):
    """(what is done, the status, which statement is told not to be proved, the forged certificate)"""
    def changed(do):
        lie = copy.deepcopy(honest)
        do(lie["closed"], lie)
        return lie

    def digit(name):
        x = honest["closed"][name]["value"]
        return lambda c, _: c[name].update(value=x[:-1] + "05"[x[-1] == "0"])

    for name in ("holonomy", "writhe"):
        text = "|%s - " % name
        yield "another digit", 1, text, changed(digit(name))
        yield "the other sign", 1, text, changed(lambda c, _, name=name: c[name].update(value="-" + c[name]["value"] if c[name]["value"][0] != "-" else c[name]["value"][1:]))
        yield "a small radius", 1, text, changed(lambda c, _, name=name: c[name].update(radius="1e-60"))
        yield "a negative radius", 2, None, changed(lambda c, _, name=name: c[name].update(radius="-1"))
        yield "an exact number", 2, None, changed(lambda c, _, name=name: c[name].update(value="1/3"))
        yield "no angle at the end", 1, text, changed(lambda _, lie: lie["segments"][-1].update(claims=[]))
    yield "beyond doubles", 1, "|holonomy - ", changed(lambda c, _: c["holonomy"].update(value="1e400"))
    yield "another turn", 1, "|holonomy - ", changed(lambda c, _: c["holonomy"].update(turns=c["holonomy"]["turns"] + 1))
    yield "a turn in quotes", 2, None, changed(lambda c, _: c["holonomy"].update(turns="0"))
    yield "open", 1, "closed: ", changed(lambda _, lie: (lie["segments"].pop(), lie.update(claims=[])))
    yield "begun elsewhere", 1, "closed: ", changed(lambda _, lie: lie["segments"][0]["curve"].update(start=["1", "0", "0"]))
    yield "its last segment stretched", 1, "closed: ", changed(lambda _, lie: stretch(lie["segments"][-1], 2))
    yield "not joined", 1, "closed: ", changed(lambda _, lie: lie["segments"][1]["curve"].update(start=["1", "0", "0"]))
    yield "mirrored", 1, "closed: the multiplier", changed(lambda _, lie: [stretch(segment, -1) for segment in lie["segments"]])
    yield "another key", 2, None, changed(lambda c, _: c.update(link={}))
    yield "no projection", 2, None, changed(lambda c, _: c["writhe"].update(projection=["0", "0", "0"]))
    if not honest["closed"]["writhe"]["crossings"]:
        return
    crossings = "crossings: "
    first = honest["closed"]["writhe"]["crossings"][0]

    def at_first(do):
        return changed(lambda c, _: do(c["writhe"]["crossings"]))
    yield "a crossing left out", 1, crossings, at_first(lambda c: c.pop())
    yield "a crossing twice", 1, crossings, at_first(lambda c: c.append(copy.deepcopy(first)))
    yield "the sign of a crossing", 1, crossings, at_first(lambda c: c[0].update(sign=-first["sign"]))
    yield "no sign", 2, None, at_first(lambda c: c[0].update(sign=0))
    yield "the arcs of a box swapped", 1, crossings, at_first(lambda c: c[0].update(first=first["second"], second=first["first"]))
    yield "the boxes of two crossings swapped", 1, crossings, at_first(lambda c: (c[0].update(second=c[1]["second"]), c[1].update(second=first["second"])))
    yield "a box beside", 1, crossings, at_first(lambda c: c[0]["first"].update(segment=first["first"]["segment"] + 1))
    yield "a segment that is not there", 1, crossings, at_first(lambda c: c[0]["second"].update(segment=10 ** 6))
    yield "a box turned round", 1, crossings, at_first(lambda c: c[0]["first"]["interval"].reverse())
    a, b = first["first"]["interval"]
    yield "a box beyond the end", 1, crossings, at_first(lambda c: c[0]["first"].update(interval=[a if Fraction(a) else "-1/1000000", b if not Fraction(a) else "1000001/1000000"]))
    yield "a crossing more, its arcs swapped", 1, crossings, at_first(lambda c: c.append({**first, "first": first["second"], "second": first["first"]}))
    yield "a box without a crossing", 1, crossings, at_first(lambda c: c.insert(0, beside(first)))
    yield "another projection", 1, crossings, changed(lambda c, _: c["writhe"].update(projection=["1", "0", "0"]))


def stretch(segment, c):
    """The segment c times as large, about the origin."""
    def scaled(x):
        return [str(c * Fraction(y)) for y in x]
    curve = segment["curve"]
    curve.update(multiplier=scaled(curve.get("multiplier", ["1"])))
    segment["hodograph"] = [scaled(x) for x in segment["hodograph"]]
    if c < 0:
        curve.update(start=scaled(curve.get("start", ["0"] * 3)))


def beside(crossing):
    """Its arcs without the middle of the first, where it crosses the second."""
    a, b = map(Fraction, crossing["first"]["interval"])
    return {**crossing, "first": {**crossing["first"], "interval": [str(b), str(b + (b - a) / 64)]}}


def main():
    tried = 0
    with tempfile.TemporaryDirectory() as folder:
        certificate, lie, points = (Path(folder) / name for name in ("path.cert", "lie.cert", "points.csv"))
        for path, steps in ((ROOT / "examples/curves/closed-spline.json", 40), (ROOT / "tests/data/closed-loops.json", 32)):
            phrame("certify", path, "--at", "1/2", "--digits", "25", "--holonomy", "--writhe", "-o", certificate)
            expect(0, path.name, certificate, curve=path)
            honest = json.loads(certificate.read_text())
            for name, find, order in (("holonomy", holonomy_by_reflection, 4), ("writhe", writhe_by_polygon, 2)):
                foreign, off = at_infinity(find, order, honest, steps)
                if not abs(foreign - float(honest["closed"][name]["value"])) < off < 1e-3:
                    sys.exit("%s of %s: %s, by another way %s" % (name, path.name, honest["closed"][name]["value"], foreign))
            for what, status, line, forged in forgeries(honest):
                lie.write_text(json.dumps(forged))
                expect(status, "%s: %s" % (path.name, what), lie, line=line)
                tried += 1
        tried += check_others(points, certificate, lie)
    print("%d forged certificates of closed paths" % tried)


def check_others(points, certificate, lie):
    """A circle of rational arcs; one with a weight that is 0 on the way; and a path that ends where it begins, with a corner."""
    sides = [([1, 0, -1], [0, 2]), ([0, -2], [1, 0, -1]), ([-1, 0, 1], [0, -2]), ([0, 2], [-1, 0, 1])]
    circle = {"phrame": "spline/1", "segments": [{"basis": "power", "position": {"x": x, "y": y, "w": [1, 0, 1]}} for x, y in sides]}
    points.write_text(json.dumps(circle))
    phrame("certify", points, "--holonomy", "--writhe", "-o", certificate)
    expect(0, "circle", certificate, curve=points)
    honest = json.loads(certificate.read_text())
    assert [float(honest["closed"][name]["value"]) for name in ("holonomy", "writhe")] == [0, 0]
    part = honest["segments"][2]
    part["position"] = {key: product(x, ["-1", "2"]) for key, x in part["position"].items()}
    part["hodograph"] = [product(x, ["1", "-4", "4"]) for x in part["hodograph"]]
    lie.write_text(json.dumps(honest))
    expect(1, "circle with a pole", lie, line="closed: ")
    points.write_text("0,0,0\n1,2,0\n3,2,1\n0,0,0\n")
    corner = points.with_name("corner.json")
    phrame("construct", points, "--exact-points", "--print", "curve", "-o", corner)
    phrame("certify", corner, "-o", certificate)
    for flag in ("--holonomy", "--writhe"):
        done = run("certify", corner, flag)
        assert done.returncode == 3 and "the tangent at the end is not that at the start" in done.stderr, done
    honest = json.loads(certificate.read_text())
    honest["closed"] = {"holonomy": {"turns": 0, "value": "0", "radius": "9"}}
    lie.write_text(json.dumps(honest))
    expect(1, "a corner", lie, line="closed: ")
    return 2


if __name__ == "__main__":
    main()
