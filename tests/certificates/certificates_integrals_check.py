"""Certificates of curves that are not PH, and of lengths: both checkers prove the honest ones, whose values are those of mpmath's
quadrature of e2'.e3 and |r'| as they are defined; they refuse forged ones, and say the same.
"""
import copy
import io
import json
import os
import re
import resource
import subprocess
import sys
import tempfile
from argparse import Namespace
from contextlib import redirect_stderr, redirect_stdout
from fractions import Fraction
from math import comb
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import check_certificate as checker

PROGRAM = os.environ["PHRAME_PROGRAM"]
ALL = int(os.environ.get("PHRAME_TEST_MULTIPLIER", 1)) > 1
SECONDS, BYTES = 5, 100000  # that a certificate of 30 digits of a quartic takes at most


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


def both(path, curve=None):
    """(status, lines) of the script, and of the program."""
    options = Namespace(quiet=False, curve=curve and str(curve), table=None, max_degree=1001, unlimited=False, files=[])
    out = io.StringIO()
    with redirect_stdout(out), redirect_stderr(io.StringIO()):
        status = checker.check(str(path), options)
    done = run("verify", path, *(["--curve", curve] if curve else []))
    return (status, out.getvalue().splitlines()), (done.returncode, done.stdout.splitlines())


def statements(lines):
    """Without the reasons, which each has in its own words."""
    return [re.sub(r"^(not proved  [^:]*): .*", r"\1", line) for line in lines]


def expect(status, what, path, curve=None, line=None):
    mine, other = both(path, curve)
    if mine[0] != status or other[0] != status or status < 2 and statements(mine[1]) != statements(other[1]):
        sys.exit("%s: the script %s, verify %s\n%s" % (what, mine[0], other[0], "\n".join(set(mine[1]) ^ set(other[1]))))
    if line and not any(text.startswith("not proved  " + line) for text in mine[1]):
        sys.exit("%s: it is not told that %s:\n%s" % (what, line, "\n".join(mine[1])))


# ---- honest ones

def product(a, b):
    c = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += Fraction(x) * Fraction(y)
    return c


def with_cusps(f):
    """r' = f H."""
    H = [1, 2, -1], [0, 1, 3], [2, -1, 1, 1]
    return {"phrame": "curve/1", "basis": "power",
            "position": {key: [0] + [str(x / (k + 1)) for k, x in enumerate(product(f, h))] for key, h in zip("xyz", H)}}


def power(x, y, z, w=(1,)):
    return {"phrame": "curve/1", "basis": "power", "position": {key: [str(c) for c in a] for key, a in zip("xyzw", (x, y, z, w))}}


def bezier(points, weights=None):
    return {"phrame": "curve/1", "control_points": points, **({"weights": weights} if weights else {})}


QUARTIC = bezier([[0, 0, 0], [1, 3, -2], [4, 1, 5], [2, -3, 1], [5, 2, 2]])
QUINTIC = {"phrame": "curve/1", "basis": "power", "preimage": {"u": [2, -4, 4], "v": [1, 0, -1], "p": [0, -4, 4], "q": [1, 2, -2]}}
FIRST, SECOND = [[0, 0, 0], [1, 2, 0], [2, 1, 3]], [[2, 1, 3], [3, 0, 6], [4, 1, 6], [5, 3, 5]]  # the tangent goes on
TURNED = with_cusps([-1, 2])  # at the end e1 is -r'/|r'|
END = [sum(map(Fraction, TURNED["position"][key])) for key in "xyz"]
CORNER = [[2, 1, 3], [0, 0, 0], [1, 7, 1]]
IN_PLANE = power([1, 1], [1, 0, 1], [1, -3, 3, 1])  # behind (t, t^2, t^3), with the same binormal
BEHIND = bezier([[str(a + k * b + c) for a, b, c in zip(END, (2, 4, 3), (k == 3, k * k - k, 5 * (k == 3)))] for k in range(4)])
SUBJECTS = [  # name, curve, arguments
    ("quartic", QUARTIC, ["--at", "1/3,1", "--digits", "30"]),
    ("quartic, Frenet", QUARTIC, ["--frame", "frenet"]),
    ("quartic, length", QUARTIC, ["--length", "--at", "0,1/3,1", "--digits", "30"]),
    ("PH to v", QUINTIC, ["--frame", "up", "--at", "1/2,1"]),
    ("PH length", QUINTIC, ["--length", "--at", "1/2,1"]),
    ("PH with a cusp, length", {**QUINTIC, "multiplier": [-1, 0, 3]}, ["--length", "--at", "1/2,1"]),
    ("rational", bezier([[0, 0, 1], [1, 2, 0], [2, 1, 3], [3, -1, 1]], [1, 2, 1, 3]), ["--at", "2/7,1"]),
    ("rational length", bezier([[0, 0, 1], [1, 2, 0], [2, 1, 3], [3, -1, 1]], [1, 2, 1, 3]), ["--length"]),
    ("inflection", power([0, 1], [0, 0, "-1/2", "1/3"], [0, 0, 0, "-1/6", "1/6"]), ["--frame", "frenet", "--at", "1/2,1"]),
    ("cusp at 1/2", with_cusps([-1, 2]), ["--length", "--at", "1/4,1/2,1"]),
    ("irrational cusp", with_cusps([-1, 0, 2]), ["--length", "--at", "1/3,1", "--digits", "25"]),
    ("double cusp", with_cusps([1, 0, -4, 0, 4]), ["--length", "--digits", "25"]),
    ("zero speed at the ends", with_cusps([0, 1, -1]), ["--length"]),
    ("cusp to v", with_cusps([-1, 0, 2]), ["--at", "1"]),
    ("near a cusp", power([0, "1e-9", 0, 1], [0, 0, 1], [0, 0, 0, 1, 1]), ["--at", "1"]),
    ("plane", power([0, 1, 1], [0, 0, 1, 4], [0]), ["--at", "1/2,1"]),
    ("line", power([0, 1, 1], [0, 2, 2], [0, -2, -2]), ["--length"]),
    ("path", {"phrame": "spline/1", "segments": [bezier(FIRST), bezier(SECOND)]}, ["--at", "0,1/2,1,7/4,2"]),
    ("path behind a cusp", {"phrame": "spline/1", "segments": [TURNED, BEHIND]}, ["--at", "1,2"]),
    ("path with corners", {"phrame": "spline/1", "segments": [bezier(FIRST), bezier(CORNER), bezier([[1, 7, 1], [3, 3, 3]])]},
     ["--at", "1/2,1,3/2,2,3"]),
    ("corner behind a cusp", {"phrame": "spline/1", "segments": [TURNED, bezier([[str(x + d) for x in END] for d in (0, 1)])]}, ["--at", "1,2"]),
    ("corner, Frenet", {"phrame": "spline/1", "segments": [power([0, 1], [0, 0, 1], [0, 0, 0, 1]), IN_PLANE]}, ["--frame", "frenet", "--at", "1,2"]),
    ("plane with a corner", {"phrame": "spline/1", "segments": [bezier([[0, 0, 0], [1, 3, 0], [2, 0, 0]]), bezier([[2, 0, 0], [0, 0, 0]])]}, []),
    ("path with a corner, length", {"phrame": "spline/1", "segments": [bezier(FIRST), bezier(CORNER)]}, ["--length", "--at", "1,3/2,2"])]


class Curves:
    """The segments of a file, as functions of mpmath; nothing of this is taken from the certificate."""

    def __init__(self, value, mp):
        self.mp = mp
        self.parts = []
        for part in value.get("segments", [value]):
            X, W = self.polynomials(part)
            self.parts.append(([self.slopes(c) for c in X], self.slopes(W)))

    def number(self, x):
        x = Fraction(str(x))
        return self.mp.mpf(x.numerator) / x.denominator

    def polynomials(self, part):
        """X and W of a segment, from the constant term up."""
        if "control_points" in part:
            points = part["control_points"]
            weights, n = part.get("weights", [1] * len(points)), len(points) - 1
            def of_bernstein(c):
                c = [Fraction(str(x)) for x in c]
                return [comb(n, k) * sum((-1) ** (k - i) * comb(k, i) * c[i] for i in range(k + 1)) for k in range(n + 1)]
            return [of_bernstein([w * x for w, x in zip(weights, c)]) for c in zip(*points)], of_bernstein(weights)
        if "position" in part:
            p = {key: [Fraction(x) for x in c] for key, c in part["position"].items()}
            return [p["x"], p["y"], p["z"]], p.get("w", [Fraction(1)])
        u, v, p, q = (part["preimage"][key] for key in "uvpq")
        sums = lambda *terms: [sum(t[k] for t in terms if k < len(t)) for k in range(max(map(len, terms)))]
        times = lambda c, a: [c * x for x in a]
        x = sums(product(u, u), product(v, v), times(-1, product(p, p)), times(-1, product(q, q)))
        y, z = times(2, sums(product(u, q), product(v, p))), times(2, sums(product(v, q), times(-1, product(u, p))))
        f = part.get("multiplier", [1])
        return [[0] + [Fraction(c) / (k + 1) for k, c in enumerate(product(f, a))] for a in (x, y, z)], [Fraction(1)]

    def slopes(self, c):
        """The coefficients of a polynomial and of its first three derivatives, from the highest down."""
        out = []
        for _ in range(4):
            out.append([self.number(x) for x in reversed(c)] or [self.mp.mpf(0)])
            c = [n * x for n, x in enumerate(c)][1:]
        return out

    def derivatives(self, k, t):
        """r', r'' and r''' there."""
        X, W = self.parts[k]
        jet = lambda c: [self.mp.polyval(slope, t) for slope in c]
        w, rows = jet(W), []
        for x in map(jet, X):
            r = []
            for n in range(4):
                r.append((x[n] - sum(comb(n, j) * w[j] * r[n - j] for j in range(1, n + 1))) / w[0])
            rows.append(r)
        return [[row[n] for row in rows] for n in (1, 2, 3)]


def rates(mp, frame, up):
    """-e2'.e3 and |r'| of the derivatives of r, by their definitions."""
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    def rate(d, e, f):
        if frame == "none":
            return mp.sqrt(dot(d, d))
        speed = mp.sqrt(dot(d, d))
        if frame == "frenet":
            b = cross(d, e)
            return -speed * dot(b, f) / dot(b, b)
        n, slope = cross(up, d), cross(up, e)
        size = mp.sqrt(dot(n, n))
        e2 = [x / size for x in n]
        e2_slope = [(x - y * dot(e2, slope)) / size for x, y in zip(slope, e2)]
        return -dot(e2_slope, cross([x / speed for x in d], e2))
    return rate


def turn_at_corner(mp, a, b, v):
    """About b, from v x b to what v x a becomes when it is turned about a x b by the angle between a and b (Rodrigues' formula)."""
    dot = lambda x, y: sum(i * j for i, j in zip(x, y))
    cross = lambda x, y: [x[i] * y[j] - x[j] * y[i] for i, j in ((1, 2), (2, 0), (0, 1))]
    unit = lambda x: [i / mp.sqrt(dot(x, x)) for i in x]
    a, b = unit(a), unit(b)
    k, x, n = unit(cross(a, b)), cross(v, a), unit(cross(v, b))
    angle = mp.acos(dot(a, b))
    carried = [i * mp.cos(angle) + j * mp.sin(angle) + l * dot(k, x) * (1 - mp.cos(angle)) for i, j, l in zip(x, cross(k, x), k)]
    return mp.atan2(dot(cross(b, n), carried), dot(n, carried))


def check_values(name, value, certificate, stops):
    """The last claim is that of Gauss's rule in doubles, to some 9 digits; the quartic's, and where there is time all, to 20."""
    try:
        import mpmath
        from mpmath.calculus.quadrature import GaussLegendre
    except ImportError:
        return
    mpmath.mp.dps, is_fine = 28, ALL or name == "quartic"
    mp = mpmath.mp if is_fine else mpmath.fp  # or doubles
    nodes = [(mp.mpf(x), mp.mpf(w)) for x, w in GaussLegendre(mpmath.mp).calc_nodes(5 if is_fine else 3, mpmath.mp.prec)]
    curves, frame = Curves(value, mp), certificate["frame"]
    rate = rates(mp, frame, [Curves.number(curves, x) for x in certificate.get("up", [])])
    for claim in certificate["claims"][0 if is_fine else -1:]:
        t, total, sign = Fraction(claim["t"]), mp.mpf(0), 1
        for k in range(len(curves.parts)):
            if 0 < k <= t and name in ("path with corners", "corner behind a cusp"):
                before, after = curves.derivatives(k - 1, mp.mpf(1))[0], curves.derivatives(k, mp.mpf(0))[0]
                total += turn_at_corner(mp, [sign * x for x in before], [sign * x for x in after], [curves.number(x) for x in certificate["up"]])
            end = min(max(t - k, Fraction(0)), Fraction(1))
            ends = [mp.mpf(0)] + [x for x in map(mp.mpf, stops) if x < curves.number(end)] + [curves.number(end)]
            for a, b in zip(ends, ends[1:]):
                if frame != "none" and k == 0 and a in map(mp.mpf, stops) and "cusp" in name and "near" not in name:
                    sign = -sign  # behind a cusp e1 is -r'/|r'|
                if a < b:
                    step = (b - a) / 32
                    middles = [a + (2 * j + 1) * step for j in range(16)]
                    total += sign * step * sum(w * rate(*curves.derivatives(k, c + step * x)) for c in middles for x, w in nodes)
        stated = mp.mpf(claim.get("theta", claim.get("length")))
        if abs(total - stated) > mp.mpf(10) ** -(20 if is_fine else 9) * max(1, abs(stated)) + mp.mpf(claim["radius"]) * (1 + mp.mpf(10) ** -6):
            sys.exit("%s: at %s quadrature finds %s, stated is %s" % (name, t, total, stated))


STOPS = {"cusp at 1/2": ["0.5"], "corner behind a cusp": ["0.5"], "inflection": [], "irrational cusp": ["0.70710678118654752440084436210484903929"],
         "double cusp": ["0.70710678118654752440084436210484903929"], "cusp to v": ["0.70710678118654752440084436210484903929"],
         "PH with a cusp, length": ["0.57735026918962576450914878050195745565"],
         "near a cusp": ["0.00000000001", "0.0000000001", "0.000000001", "0.00000001", "0.000001", "0.0001", "0.01"]}


def check_honest(here):
    for name, value, arguments in SUBJECTS:
        curve, certificate = here / "curve.json", here / "honest.cert"
        curve.write_text(json.dumps(value))
        done = run("certify", curve, *arguments, "-o", certificate)
        if done.returncode:
            sys.exit("%s: %s" % (name, done.stderr))
        expect(0, name, certificate, curve=curve)
        if name != "path behind a cusp" and (ALL or "near" not in name):
            check_values(name, value, json.loads(certificate.read_text()), STOPS.get(name, []))
        if name == "quartic":
            check_cost(certificate)


def check_cost(path):
    if path.stat().st_size > BYTES:
        sys.exit("30 digits of a quartic take %d bytes" % path.stat().st_size)
    for command in ([sys.executable, "-B", ROOT / "tools" / "check_certificate.py", path], [PROGRAM, "verify", path]):
        start = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run(command, capture_output=True, check=True)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - start
        if seconds > SECONDS:
            sys.exit("30 digits of a quartic take %.1f s" % seconds)


# ---- forged ones

def changed(honest, do):
    lie = copy.deepcopy(honest)
    do(lie)
    return lie


def forgeries(honest):
    """Of the quartic: (what is done, the status, which statement is told not to be proved, the file)."""
    first, last = honest["claims"][0], honest["claims"][-1]
    text = "|theta(1) - "
    pieces = lambda c: c["segments"][0]["pieces"]

    def of_claim(k=-1, **values):
        return changed(honest, lambda c: c["claims"][k].update(values))

    def of_piece(k, **values):
        return changed(honest, lambda c: pieces(c)[k].update(values))

    def of_segment(**values):
        return changed(honest, lambda c: c["segments"][0].update(values))

    def added(k, key, by):
        def do(c):
            piece = pieces(c)[k]
            piece[key][0] = str(int(piece[key][0]) + by(piece))
        return changed(honest, do)
    digit = last["theta"][:-1] + "05"[last["theta"][-1] == "0"]
    yield "another digit", 1, text, of_claim(theta=digit)
    yield "the other sign", 1, text, of_claim(theta="-" + last["theta"] if last["theta"][0] != "-" else last["theta"][1:])
    yield "a bound too small", 1, text, of_claim(radius="1e-36")
    yield "the bound 0", 1, text, of_claim(radius="0")
    yield "another t", 1, "|theta(1/2) - ", of_claim(t="1/2")
    yield "before the start", 1, "|theta(-1) - ", of_claim(t="-1")
    yield "beyond the end", 1, "|theta(2) - ", of_claim(t="2")
    yield "an angle at the start", 1, "|theta(0) - ", of_claim(0, t="0")
    yield "the last piece lost", 1, text, changed(honest, lambda c: pieces(c).pop())
    yield "no pieces", 1, text, changed(honest, lambda c: pieces(c).clear())
    yield "a gap", 1, text, changed(honest, lambda c: pieces(c).pop(1))
    yield "an overlap", 1, "pieces of segment 0", of_piece(0, to=pieces(honest)[1]["to"])
    yield "an overlap of parts", 1, text, of_piece(0, to=str((Fraction(pieces(honest)[0]["to"]) + Fraction(pieces(honest)[1]["to"])) / 2))
    yield "a piece twice", 1, "pieces of segment 0", changed(honest, lambda c: pieces(c).insert(0, copy.deepcopy(pieces(c)[0])))
    yield "back", 1, "pieces of segment 0", changed(honest, lambda c: pieces(c).reverse())
    yield "beyond 1", 1, "pieces of segment 0", of_piece(-1, to="9/8")
    yield "the negative root", 1, "pieces of segment 0", of_piece(1, root=["-" + x if x[0] != "-" else x[1:] for x in pieces(honest)[1]["root"]])
    yield "no root", 1, "pieces of segment 0", of_piece(1, root=[])
    yield "a root that is too great", 1, "pieces of segment 0", of_piece(1, root_bits=pieces(honest)[1]["root_bits"] - 1)
    yield "a root that is far off", 1, text, added(1, "root", lambda p: 1 << (p["root_bits"] // 2))
    yield "a rate that is off", 1, text, added(1, "rate", lambda p: 1 << (p["rate_bits"] // 2))
    yield "no rate", 1, text, of_piece(1, rate=[])
    yield "the opposite rate", 1, text, of_piece(1, rate=["-" + x if x[0] != "-" else x[1:] for x in pieces(honest)[1]["rate"]])
    yield "a rate that is off, and the angle too", 1, text, changed(
        added(1, "rate", lambda p: 1 << p["rate_bits"] - 20), lambda c: c["claims"][-1].update(theta=str(Fraction(0))))
    yield "root, rate and angle greater by a share", 1, "|theta(1) - ", changed(honest, lambda c: (
        [p.update({key: [str(int(x) + (int(x) >> 10)) for x in p[key]] for key in ("root", "rate")}) for p in pieces(c)],
        c.update(claims=[{"t": "1", "theta": "%.9f" % (float(last["theta"]) * (1 + 2 ** -10)), "radius": "1e-7"}])))
    yield "another v", 1, text, changed(honest, lambda c: c.update(up=["1", "2", "5"]))
    yield "no v", 1, "pieces of segment 0", changed(honest, lambda c: c.update(up=["0", "0", "0"]))
    yield "the opposite v", 0, None, changed(honest, lambda c: c.update(up=[str(-Fraction(x)) for x in c["up"]]))
    yield "a square that is none", 1, "rate of segment 0", of_segment(square=["1", "1"])
    yield "a square that is too great", 1, text, of_segment(square=["2"])
    yield "a negative square", 1, "rate of segment 0", of_segment(square=["-1"])
    yield "another curve", 1, "pieces of segment 0", of_segment(x=["0", "4", "7", "-20", "1"])
    yield "x and y swapped", 1, text, of_segment(x=honest["segments"][0]["y"], y=honest["segments"][0]["x"])
    yield "a weight with a zero", 1, "weight of segment 0", changed(honest, lambda c: c["segments"][0].update(
        {key: [str(x) for x in product(c["segments"][0][key], [-1, 2])] for key in "xyzw"}))
    yield "a weight without a zero", 0, None, changed(honest, lambda c: c["segments"][0].update(
        {key: [str(x) for x in product(c["segments"][0][key], [1, 2])] for key in "xyzw"}))
    frenet = changed(honest, lambda c: c.update(frame="frenet"))
    del frenet["up"]
    yield "the Frenet frame", 1, text, frenet
    # What is no certificate.
    yield "the frame of PH curves", 2, None, changed(honest, lambda c: c.update(frame="erf"))
    yield "v with the Frenet frame", 2, None, changed(honest, lambda c: c.update(frame="frenet"))
    yield "angles without a frame", 2, None, changed(frenet, lambda c: c.update(frame="none"))
    yield "no v at all", 2, None, changed(honest, lambda c: c.pop("up"))
    yield "no segments", 2, None, changed(honest, lambda c: c.update(segments=[]))
    yield "a point", 2, None, of_segment(x=["1"], y=["2"], z=[])
    yield "a weight that is 0 at the start", 2, None, of_segment(w=["0", "1"])
    yield "no square", 2, None, of_segment(square=[])
    yield "a fraction on the grid", 2, None, of_piece(0, root=["1/2"])
    yield "bits in quotes", 2, None, of_piece(0, root_bits="100")
    yield "negative bits", 2, None, of_piece(0, rate_bits=-1)
    yield "another key", 2, None, changed(honest, lambda c: c.update(note="?"))
    yield "a turn", 2, None, of_claim(turn={"index": 0, "signs": ["+", "+"]})
    yield "too much work", 2, None, of_piece(0, root=["1"] * 30000)
    yield "long bits", 2, None, of_piece(0, root_bits=1000000)
    yield "a negative radius", 2, None, of_claim(radius="-1")
    if first["t"] == last["t"]:
        sys.exit("there are two claims")


def forgeries_of_path(honest):
    text = "|theta(2) - "
    segment = lambda c, k: c["segments"][k]
    moved = changed(honest, lambda c: segment(c, 1)["x"].__setitem__(0, "5/2"))
    yield "moved", 1, "joint 1", moved
    yield "the other way round", 1, "joint 1", changed(honest, lambda c: c["segments"].reverse())
    yield "turned at the joint", 1, "|theta(1) - ", changed(honest, lambda c: segment(c, 1)["y"].__setitem__(1, "7"))
    yield "one twice", 1, "joint 1", changed(honest, lambda c: c["segments"].insert(0, copy.deepcopy(segment(c, 0))))
    yield "a segment lost", 1, text, changed(honest, lambda c: c["segments"].pop())
    yield "the pieces of another", 1, text, changed(honest, lambda c: segment(c, 1).update(pieces=segment(c, 0)["pieces"]))
    yield "claims about the first alone", 0, None, changed(honest, lambda c: c.update(claims=c["claims"][:3]))
    yield "these, where the second is elsewhere", 1, "joint 1", changed(moved, lambda c: c.update(claims=c["claims"][:3]))


def forgeries_of_corners(honest):
    text = "|theta(3) - "
    yield "before the corner, not behind it", 1, "|theta(1) - ", changed(honest, lambda c: c["claims"][1].update(
        theta=repr(float(c["claims"][0]["theta"])), radius="0.1"))
    yield "another v", 1, text, changed(honest, lambda c: c.update(up=["1", "2", "-5"]))
    yield "v along a tangent", 1, "joint 2", changed(honest, lambda c: c.update(up=["1", "-2", "1"]))
    yield "moved", 1, "joint 1", changed(honest, lambda c: c["segments"][1]["x"].__setitem__(0, "5/2"))
    yield "another corner", 1, text, changed(honest, lambda c: c["segments"][2].update(x=["1", "3"]))
    yield "a whole turn more", 1, text, changed(honest, lambda c: c["claims"][-1].update(
        theta=str(float(c["claims"][-1]["theta"]) + 6.283185307179586), radius="1e-9"))


def forgeries_of_length(honest):
    """Of a cusp that is irrational: one piece has it inside."""
    text = "|length(1) - "
    pieces = honest["segments"][0]["pieces"]
    narrow = min(range(1, len(pieces)), key=lambda k: Fraction(pieces[k]["to"]) - Fraction(pieces[k - 1]["to"]))

    def without(c):
        del c["segments"][0]["pieces"][narrow]
    yield "another digit", 1, text, changed(honest, lambda c: c["claims"][-1].update(length="1.9" + c["claims"][-1]["length"][3:]))
    yield "a negative length", 1, text, changed(honest, lambda c: c["claims"][-1].update(length="-" + c["claims"][-1]["length"]))
    yield "the cusp left out", 1, text, changed(honest, without)
    yield "an angle", 2, None, changed(honest, lambda c: c["claims"][-1].update(theta=c["claims"][-1].pop("length")))
    yield "the opposite rates", 1, text, changed(honest, lambda c: [p.update(
        rate=["-" + x if x[0] != "-" else x[1:] for x in p["rate"]]) for p in c["segments"][0]["pieces"]])


def by_hand():
    """Certificates without any of the program's: (what, status, file)."""
    def certificate(x, y, root, root_bits, rate, claim, to="1", **more):
        return {"phrame": "integral-certificate/1", "frame": "none", **more, "claims": [claim], "segments": [
            {"x": x, "y": y, "z": [], "w": ["1"], "square": ["1"],
             "pieces": [{"to": to, "root_bits": root_bits, "root": root, "rate_bits": 0, "rate": rate}]}]}
    # There and back again: x = t - t^2, of length 1/2; from z = 2t - 1 the rate is -z, with its sign.
    back = ["0", "1", "-1"], [], ["1"], 0, ["0", "-1"]
    yield "there and back, without signs", 1, certificate(*back, {"t": "1", "length": "0", "radius": "1e-9"})
    yield "there and back, at most 1", 0, certificate(*back, {"t": "1", "length": "0.5", "radius": "0.5"})
    yield "there and back, less", 1, certificate(*back, {"t": "1", "length": "0.5", "radius": "0.49"})
    yield "back from 1/4 on, without signs", 1, certificate(["0", "1", "-2"], [], ["1"], 0, ["-1", "-2"], {"t": "1", "length": "1", "radius": "1e-9"})
    line = ["0", "1"], [], ["1"], 0, ["1"], {"t": "1", "length": "1", "radius": "0"}
    yield "a line", 0, certificate(*line)
    yield "a line that goes on", 1, certificate(*line, to="2")
    # r' = (4, 2t - 1, 0) is along v = (1, 0, 0) at t = 1/2, where the frame of v turns over.
    plane = ["0", "4"], ["0", "-1", "1"], ["1"], 2, []
    angle = {"t": "1", "theta": "0", "radius": "0"}
    yield "v along the tangent on the way", 1, certificate(*plane, angle, frame="up", up=["1", "0", "0"])
    yield "v normal to the plane", 0, certificate(*plane, angle, frame="up", up=["0", "0", "1"])
    # From (1, 0, 0) to (-1, 1, 0), past v = (0, 1, 0): v x e1 is carried to the opposite of what that is behind it.
    def of_lines(v, radius, up):
        corner = certificate(["0", "1"], [], ["1"], 0, [], {"t": "1", "theta": v, "radius": radius}, frame="up", up=up)
        corner["segments"].append({**corner["segments"][0], "x": ["1", "-1"], "y": ["0", "1"], "pieces": []})
        return corner
    half_turn = "3.14159265358979323846", "4e-21"
    yield "a corner past v", 0, of_lines(*half_turn, ["0", "1", "0"])
    yield "a corner past v, exactly", 1, of_lines("3.1416", "0", ["0", "1", "0"])
    yield "a corner past v, the other way", 1, of_lines("-" + half_turn[0], half_turn[1], ["0", "1", "0"])
    yield "a corner in the plane of v, not past it", 0, of_lines("0", "0", ["-4", "1", "0"])
    yield "a corner about v", 0, of_lines("0", "0", ["0", "0", "1"])
    yield "a corner, v along the first tangent", 1, of_lines("0", "4", ["1", "0", "0"])
    yield "a corner, v along the second tangent", 1, of_lines("0", "4", ["1", "-1", "0"])


def check_forged(here):
    tried = 0
    for what, status, forged in by_hand():
        (here / "lie.cert").write_text(json.dumps(forged))
        expect(status, what, here / "lie.cert")
        tried += 1
    for name, forge in (("quartic", forgeries), ("path", forgeries_of_path), ("irrational cusp", forgeries_of_length), ("path with corners", forgeries_of_corners)):
        value, arguments = next((c, a) for n, c, a in SUBJECTS if n == name)
        curve, certificate, lie = here / "curve.json", here / "honest.cert", here / "lie.cert"
        curve.write_text(json.dumps(value))
        run("certify", curve, *arguments, "-o", certificate)
        other = here / "other.json"
        other.write_text(json.dumps(bezier([[0, 0, 0], [1, 3, -2], [4, 1, 5], [2, -3, 1], [5, 2, 3]])))
        expect(1, name + ": another curve", certificate, curve=other, line="curve of")
        for what, status, line, forged in forge(json.loads(certificate.read_text())):
            lie.write_text(json.dumps(forged))
            expect(status, "%s: %s" % (name, what), lie, line=line)
            tried += 1
    return tried


REFUSED = [  # curve, arguments, status, in the message
    (QUARTIC, ["--up", "1,3,-2"], 2, "along the tangent at t = 0"),
    (power([0, 1], [0, 2], [0, 3]), ["--frame", "frenet"], 3, "straight line"),
    (QUARTIC, ["--frame", "erf"], 2, "--frame"),
    (QUARTIC, ["--length", "--up", "0,0,1"], 2, "--up"),
    (QUARTIC, ["--at", "2"], 3, "t = 2 is outside")]


def check_refused(here):
    for value, arguments, status, words in REFUSED:
        curve = here / "curve.json"
        curve.write_text(json.dumps(value))
        done = run("certify", curve, *arguments)
        if done.returncode != status or words not in done.stderr.splitlines()[-1] or done.stdout:
            sys.exit("%s: status %d, %s" % (arguments, done.returncode, done.stderr))


def main():
    with tempfile.TemporaryDirectory() as name:
        check_refused(Path(name))
        check_honest(Path(name))
        print("%d forged certificates of integrals" % check_forged(Path(name)))


if __name__ == "__main__":
    main()
