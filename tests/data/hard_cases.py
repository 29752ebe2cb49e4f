#!/usr/bin/env python3
"""Finds numbers that are hard to round to a double, and writes hard-cases.csv.

    python3 tests/data/hard_cases.py > tests/data/hard-cases.csv

Needs mpmath; nothing of phrame. The tests do not run it. Curves are those of curves.jsonl. The angle is
theta(t) = - integral of 2h/sigma from 0 to t, the vectors are f2 = cos theta e2 + sin theta e3 and
f3 = -sin theta e2 + cos theta e3 with the Euler-Rodrigues frame (A i A*, A j A*, A k A*)/sigma. theta is computed from the
poles of 2h/sigma, and every theta that is written once more by quadrature; the two must agree to all digits but 30 bits.
What is rational, positions and the vectors of plane curves, is computed with fractions. Rounding is that of Python's
fractions: to nearest, ties to even. A number is rounded only where its error is far below its distance to the next tie.

The search is for t = k/2^20 in [-2, 2], from a fixed seed; it takes a minute or two. Other rows are made: t is solved for such
that the number lies 2^-n beside a tie.
"""
import csv
import json
import pathlib
import random
import sys
from fractions import Fraction

from mpmath import mp, mpf

SEARCHED = ["gen-m01-1", "gen-m02-0", "gen-m02-2", "gen-m03-1", "seed-farouki2003", "coi-rrmf5-2", "fac-lin-m02"]
ULP = Fraction(1, 2**52)  # of 1
TRIES = 60000  # for each curve, of seven numbers
VECTORS = [f + axis for f in ("f2", "f3") for axis in "xyz"]


def product(a, b):
    out = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            out[i + j] += x * y
    return out


def combine(*terms):
    """Sum of c*a*b over the terms (c, a, b), without zeros at the end."""
    out = [Fraction(0)] * max(len(a) + len(b) - 1 for _, a, b in terms)
    for c, a, b in terms:
        for i, x in enumerate(product(a, b)):
            out[i] += c * x
    while out and out[-1] == 0:
        out.pop()
    return out


def slope(a):
    return [k * x for k, x in enumerate(a)][1:]


def value(a, t):
    """At a fraction exactly, at a number of mpmath in its arithmetic."""
    out = t * 0
    for c in reversed(a):
        out = out * t + (c if isinstance(t, Fraction) else mpf(c.numerator) / c.denominator)
    return out


def remainder(a, b):
    a = list(a)
    while len(a) >= len(b):
        c = a[-1] / b[-1]
        for i in range(len(b)):
            a[len(a) - len(b) + i] -= c * b[i]
        a.pop()
        while a and a[-1] == 0:
            a.pop()
    return a


def gcd(a, b):
    while b:
        a, b = b, remainder(a, b)
    return a


def quotient(a, b):
    a, out = list(a), []
    while len(a) >= len(b):
        out.append(a[-1] / b[-1])
        for i in range(len(b)):
            a[len(a) - len(b) + i] -= out[-1] * b[i]
        a.pop()
    return out[::-1]


def number(x):
    return mpf(x.numerator) / x.denominator if isinstance(x, Fraction) else mpf(x)


class Curve:
    def __init__(self, entry):
        assert entry["basis"] == "power" and "multiplier" not in entry
        self.name = entry["name"]
        u, v, p, q = ([Fraction(c) for c in entry["preimage"][k]] for k in "uvpq")
        self.hodograph = [
            combine((1, u, u), (1, v, v), (-1, p, p), (-1, q, q)),
            combine((2, u, q), (2, v, p)),
            combine((2, v, q), (-2, u, p)),
        ]
        self.normals = [
            [
                combine((2, v, p), (-2, u, q)),
                combine((1, u, u), (-1, v, v), (1, p, p), (-1, q, q)),
                combine((2, u, v), (2, p, q)),
            ],
            [
                combine((2, u, p), (2, v, q)),
                combine((2, p, q), (-2, u, v)),
                combine((1, u, u), (-1, v, v), (-1, p, p), (1, q, q)),
            ],
        ]
        self.sigma = combine((1, u, u), (1, v, v), (1, p, p), (1, q, q))
        h = combine((1, u, slope(v)), (-1, slope(u), v), (-1, p, slope(q)), (1, slope(p), q))
        self.rate = ([], [Fraction(1)])  # 2h/sigma, in lowest terms
        if h:
            common = gcd(self.sigma, h)
            self.rate = ([2 * c for c in quotient(h, common)], quotient(self.sigma, common))
        assert len(gcd(self.rate[1], slope(self.rate[1]))) <= 1, "a multiple pole"
        self.poles = {}

    def residues(self):
        """The poles above the real axis with the residues of -2h/sigma, to the working precision."""
        if mp.prec not in self.poles:
            n, d = self.rate
            found = []
            if len(d) > 1:
                with mp.workprec(mp.prec + 40):
                    roots = mp.polyroots([number(c) for c in reversed(d)], maxsteps=500, extraprec=4 * mp.prec)
                    found = [(z, -value(n, z) / value(slope(d), z)) for z in roots if mp.im(z) > 0]
            self.poles[mp.prec] = found
        return self.poles[mp.prec]

    def theta(self, t):
        t = number(t)
        return 2 * sum((mp.re(c * mp.log((z - t) / z)) for z, c in self.residues()), mpf(0))

    def theta_by_quadrature(self, t):
        n, d = self.rate
        t = number(t)
        cuts = sorted(x for x in (mp.re(z) for z, _ in self.residues()) if 0 < x / t < 1)
        if t < 0:
            cuts.reverse()
        return mp.quad(lambda x: -value(n, x) / value(d, x), [mpf(0)] + cuts + [t])

    def vectors(self, t, theta):
        cos, sin, sigma = mp.cos(theta), mp.sin(theta), number(value(self.sigma, t))
        e2, e3 = ([number(value(x, t)) / sigma for x in e] for e in self.normals)
        f2 = [cos * x + sin * y for x, y in zip(e2, e3)]
        return f2 + [cos * y - sin * x for x, y in zip(e2, e3)]

    def at(self, t, quantity):
        theta = self.theta(t)
        return theta if quantity == "theta" else self.vectors(t, theta)[VECTORS.index(quantity)]

    def plane_vectors(self, t):
        """Those of a curve in the plane z = 0, exactly: with N = k x e1, f2 is N and k at a constant angle."""

        def frame(t):
            sigma = value(self.sigma, t)
            e1 = [value(x, t) / sigma for x in self.hodograph]
            assert e1[2] == 0
            return [-e1[1], e1[0], 0], [value(x, t) / sigma for x in self.normals[0]]

        start, e2 = frame(Fraction(0))
        cos, sin = sum(x * y for x, y in zip(start, e2)), e2[2]
        n, _ = frame(t)
        return [cos * x for x in n[:2]] + [sin] + [-sin * x for x in n[:2]] + [cos]

    def position(self, t):
        return [sum(c * t ** (k + 1) / (k + 1) for k, c in enumerate(x)) for x in self.hodograph]


def fraction(x):
    """The exact value of an mpf."""
    sign, man, exp, _ = x._mpf_
    out = Fraction(man) * Fraction(2) ** exp
    return -out if sign else out


def neighbours(x):
    """The nearest tie to a fraction x, and the nearest double."""
    unit = Fraction(2) ** (max(exponent(x) if x else 0, -1022) - 52)
    return (2 * (x / unit).__floor__() + 1) * unit / 2, round(x / unit) * unit


def exponent(x):
    """The e with 2^e <= |x| < 2^(e+1)."""
    e = abs(x.numerator).bit_length() - x.denominator.bit_length()
    return e if abs(x) >= Fraction(2) ** e else e - 1


def bits_to(x, mark):
    """The relative precision, in bits, that tells x from the mark."""
    return exponent(x) - exponent(x - mark)


def distances(x):
    """How far an mpf is from the nearest tie and the nearest double: -log2, in units of the last place."""
    man = x._mpf_[1]
    rest = man.bit_length() - 53
    low = man & ((1 << rest) - 1)
    tie = abs(low - (1 << (rest - 1)))
    return rest - tie.bit_length(), rest - min(low, (1 << rest) - low).bit_length()


def text_of(t):
    """A dyadic number as hexadecimal text where that is short."""
    n, d = t.numerator, t.denominator
    e = d.bit_length() - 1
    if d != 1 << e or e < 30:
        return str(t)
    return f"{'-' if n < 0 else ''}0x{abs(n):x}p-{e}"


class Rows:
    def __init__(self):
        self.rows = []

    def add(self, curve, t, quantity, x, note):
        tie = neighbours(x)[0]
        bits = "" if x in (0, tie) else max(bits_to(x, tie), 1)
        rounded = float(x) or 0.0  # one zero, the positive one
        self.rows.append([curve.name, text_of(t), quantity, rounded.hex(), bits, note])

    def exact(self, curve, t, quantity, x, note):
        x = Fraction(x)
        assert note.startswith("exact tie") == (neighbours(x)[0] == x)
        self.add(curve, t, quantity, x, note)

    def enclosed(self, curve, t, quantity, note):
        """Rounds with more and more precision until the tie is far away, and compares with quadrature."""
        working = 200
        while True:
            with mp.workprec(working):
                x = fraction(curve.at(t, quantity))
            # The error is about 2^-working, however small the number is.
            if x not in (0, neighbours(x)[0]) and exponent(x - neighbours(x)[0]) > 100 - working:
                break
            working += 200
        with mp.workprec(working):
            theta, again = curve.theta(t), curve.theta_by_quadrature(t)
            assert abs(theta - again) <= mpf(2) ** (30 - working), (curve.name, t)
        self.add(curve, t, quantity, x, note)


def search(curve, seed):
    """(bits, t, quantity) for ties, and for doubles."""
    generator = random.Random(seed)
    ties, doubles = [], []
    with mp.workprec(130):
        for _ in range(TRIES):
            t = Fraction(generator.randrange(-(2**21), 2**21), 2**20)
            if t == 0:
                continue
            theta = curve.theta(t)
            for quantity, x in zip(["theta"] + VECTORS, [theta] + curve.vectors(t, theta)):
                tie, double = distances(x)
                if tie > 11:
                    ties.append((tie, t, quantity))
                if double > 11:
                    doubles.append((double, t, quantity))
    return ties, doubles


def solve(curve, quantity, target, start, bits):
    """A dyadic t with so many bits behind the point where the number is the target, nearly."""
    with mp.workprec(bits + 100):
        x = number(target)
        root = mp.findroot(lambda t: curve.at(t, quantity) - x, number(start), tol=mpf(2) ** (-2 * bits))
        return Fraction(int(mp.nint(root * mpf(2) ** bits)), 2**bits)


def add_found(rows, curves):
    ties, doubles = [], []
    for seed, name in enumerate(SEARCHED):
        found = search(curves[name], seed)
        ties += [(bits, name, t, quantity) for bits, t, quantity in found[0]]
        doubles += [(bits, name, t, quantity) for bits, t, quantity in found[1]]
    for mark, chosen, count in [("tie", ties, 12), ("double", doubles, 4)]:
        for is_angle in (True, False):
            best = sorted((c for c in chosen if (c[3] == "theta") == is_angle), reverse=True)
            for bits, name, t, quantity in best[:count]:
                rows.enclosed(curves[name], t, quantity, f"found: 2^-{bits} ulp near a {mark}")


def add_solved(rows, curves):
    for name, quantity, at, bits in [
        ("seed-farouki2003", "theta", Fraction(7, 8), 300),
        ("gen-m02-0", "theta", Fraction(1, 3), 1000),
        ("seed-farouki2003", "f2x", Fraction(3, 4), 400),
        ("gen-m03-1", "f3z", Fraction(1, 5), 1000),
        ("coi-rrmf5-2", "f3y", Fraction(1, 2), 500),
    ]:
        with mp.workprec(100):
            tie, _ = neighbours(fraction(curves[name].at(at, quantity)))
        for target, where in [(tie + tie / 2**bits, "beyond"), (tie - tie / 2**bits, "before")]:
            t = solve(curves[name], quantity, target, at, bits + 60)
            rows.enclosed(curves[name], t, quantity, f"solved for: 2^-{bits} of itself {where} a tie")
    curve = curves["gen-m02-1"]
    for target, note in [(1 - ULP / 4, "1 - 2^-54: where the unit in the last place doubles"), (1 + ULP / 2, "1 + 2^-53")]:
        for side, where in [(1, "above"), (-1, "below")]:
            t = solve(curve, "theta", target + side * Fraction(1, 2**120), Fraction(1, 4), 180)
            rows.enclosed(curve, t, "theta", f"solved for: 2^-120 {where} {note}")


def add_tiny(rows, curves):
    for name in ("seed-farouki2003", "gen-m02-0", "coi-rrmf5-2"):
        for t in (Fraction(1, 2**60), Fraction(-3, 2**201)):
            rows.enclosed(curves[name], t, "theta", "tiny t")
    for name, quantity in [("coi-rrmf5-2", "f2x"), ("gen-m02-0", "f3y")]:
        rows.enclosed(curves[name], Fraction(1, 2**60), quantity, "tiny t")
    for k in (1, 5, 7):
        rows.enclosed(curves["gen-m02-0"], Fraction(k, 2**1076), "theta", "subnormal")
    rows.enclosed(curves["gen-m02-0"], Fraction(1, 2**1100), "theta", "below the smallest double")


def add_exact(rows, curves):
    flat, plane = curves["deg-hzero"], curves["coi-planar-1_1"]
    for curve, t in [(curves["gen-m02-0"], Fraction(0)), (flat, Fraction(1, 3))]:
        rows.exact(curve, t, "theta", 0, "exact zero")
    candidates = {Fraction(n, d) for d in range(1, 60) for n in range(-120, 121) if n}
    for t in sorted(t for t in candidates if value(plane.hodograph[1], t) == 0):
        for quantity, x in list(zip(VECTORS, plane.plane_vectors(t)))[:4]:
            rows.exact(plane, t, quantity, x, "exact zero of a rational frame" if x == 0 else "rational frame")
    for quantity in ("f2z", "f3z"):
        x = flat.plane_vectors(Fraction(1, 3))[VECTORS.index(quantity)]
        rows.exact(flat, Fraction(1, 3), quantity, x, "exact zero where h = 0" if x == 0 else "exact where h = 0")
    # f2y is 1 at a double root, near 0.3, of 1 - f2y: beside it, it comes near the tie below 1.
    f2y = lambda x: value(flat.hodograph[0], x) / value(flat.sigma, x)
    for side, where in [(1, "above"), (-1, "below")]:
        with mp.workprec(300):
            one = mp.findroot(lambda x: value(flat.hodograph[1], x), mpf("0.3"))
            target = number(1 - ULP / 4 + side * Fraction(1, 2**110))
            start = (one + mpf(2) ** -29, one + mpf(2) ** -28)
            root = mp.findroot(lambda x: f2y(x) - target, start, tol=mpf(2) ** -500)
            t = Fraction(int(mp.nint(root * mpf(2) ** 160)), 2**160)
        rows.exact(flat, t, "f2y", flat.plane_vectors(t)[1], f"2^-110 {where} 1 - 2^-54")


def add_positions(rows, curve):
    """Vectors have no ties (docs/algorithms.md, "The vectors round"). Positions have."""
    wanted = {0: 2, 1: 2}  # where the double towards 0 is even, and odd
    for n in range(15, 2**17, 30):
        t = Fraction(n, 2**10)
        for axis, x in zip("xyz", curve.position(t)):
            side = abs(x.numerator) // 2 % 2
            if x == neighbours(x)[0] and wanted[side] > 0:
                wanted[side] -= 1
                rows.exact(curve, t, axis, x, f"exact tie to even: {'away from' if side else 'towards'} 0")


def main():
    lines = pathlib.Path(__file__).with_name("curves.jsonl").read_text(encoding="utf-8").splitlines()
    entries = {entry["name"]: entry for entry in map(json.loads, lines)}
    curves = {name: Curve(entries[name]) for name in SEARCHED + ["coi-planar-1_1", "deg-hzero", "gen-m02-1"]}
    rows = Rows()
    for add in (add_found, add_solved, add_tiny, add_exact):
        add(rows, curves)
    add_positions(rows, curves["seed-farouki2003"])
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(["curve", "t", "quantity", "value", "bits", "note"])
    out.writerows(rows.rows)


if __name__ == "__main__":
    main()
