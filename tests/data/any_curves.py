"""Makes any_curves.jsonl: random Bezier, rational and B-spline curves and NURBS of degree 2 to 12
with the angle of the rotation-minimizing frame to the frame of v, and the length, by mpmath's
quadrature of
  theta' = -(v.r') det(v, r', r'') / (|r'| |v x r'|^2)
with 45 digits, on Bezier curves that this script finds by blossoms. Nothing of phrame is used.

  python3 any_curves.py > any_curves.jsonl        (mpmath; some minutes)
"""
import json
import random
from fractions import Fraction as F
from math import comb

from mpmath import linspace, mp, mpf, nstr, polyval, quad, sqrt

mp.dps = 45


def number(x):
    return mpf(x.numerator) / x.denominator


def power_form(bezier):
    n = len(bezier) - 1
    return [comb(n, k) * sum((-1) ** (k - j) * comb(k, j) * bezier[j] for j in range(k + 1))
            for k in range(n + 1)]


def blossom(degree, knots, values, span, at):
    d = [values[span - degree + j] for j in range(degree + 1)]
    for r, u in enumerate(at, 1):
        d = [((knots[span + 1 + j] - u) * d[j] + (u - knots[span - degree + r + j]) * d[j + 1])
             / (knots[span + 1 + j] - knots[span - degree + r + j]) for j in range(degree + 1 - r)]
    return d[0]


def bezier_pieces(degree, knots, homogeneous):
    """Lists of the power forms of wx, wy, wz, w on [0, 1]."""
    pieces = []
    for span in range(degree, len(knots) - degree - 1):
        a, b = knots[span], knots[span + 1]
        if a < b:
            pieces.append([power_form([blossom(degree, knots, c, span, [a] * (degree - j) + [b] * j)
                                       for j in range(degree + 1)]) for c in homogeneous])
    return pieces


class Piece:
    def __init__(self, forms):
        self.forms = []  # X and its first two derivatives, highest power first
        for _ in range(3):
            self.forms.append([[number(F(c)) for c in reversed(p)] for p in forms])
            forms = [[k * p[k] for k in range(1, len(p))] or [0] for p in forms]

    def rates(self, t, v):
        x, x1, x2 = ([polyval(p, t) for p in order] for order in self.forms)
        w, w1, w2 = x[3], x1[3], x2[3]
        r = [x[k] / w for k in range(3)]
        r1 = [(x1[k] - r[k] * w1) / w for k in range(3)]
        r2 = [(x2[k] - 2 * r1[k] * w1 - r[k] * w2) / w for k in range(3)]
        c = [v[1] * r1[2] - v[2] * r1[1], v[2] * r1[0] - v[0] * r1[2], v[0] * r1[1] - v[1] * r1[0]]
        dot = lambda a, b: sum(p * q for p, q in zip(a, b))
        speed = sqrt(dot(r1, r1))
        return -dot(v, r1) * dot(c, r2) / (speed * dot(c, c)), speed


def integral(piece, which, v, upper):
    """On more and more parts, until it does not change."""
    parts, before = 48, None
    while True:
        value = quad(lambda t: piece.rates(t, v)[which], linspace(0, upper, parts + 1))
        if before is not None and abs(value - before) < mpf(10) ** -36:
            return value
        parts, before = 2 * parts, value


def curve(index):
    draw = random.Random(index)
    degree, kind = 2 + index % 11, ("bezier", "rational", "bspline", "nurbs")[index // 11 % 4]
    inner = sorted(draw.sample(range(1, 9), 2)) if kind in ("bspline", "nurbs") else []
    knots = [F(0)] * (degree + 1) + [F(k) for k in inner] + [F(9)] * (degree + 1)
    count = len(knots) - degree - 1
    points = [[draw.randint(-9, 9) for _ in range(3)] for _ in range(count)]
    weights = [draw.randint(1, 9) if kind in ("rational", "nurbs") else 1 for _ in range(count)]
    file = {"phrame": "curve/1", "control_points": points}
    if inner:
        file = {"phrame": "nurbs/1" if kind == "nurbs" else "bspline/1", "degree": degree,
                "knots": [int(k) for k in knots], "control_points": points}
    if kind in ("rational", "nurbs"):
        file["weights"] = weights
    homogeneous = [[F(w * p[k]) for p, w in zip(points, weights)] for k in range(3)]
    return file, bezier_pieces(degree, knots, homogeneous + [[F(w) for w in weights]])


def main():
    v = (1, 2, 3)
    for index in range(44):
        file, forms = curve(index)
        pieces = [Piece(p) for p in forms]
        theta = sum(integral(p, 0, v, 1) for p in pieces)
        third = integral(pieces[0], 0, v, mpf(1) / 3)
        length = sum(integral(p, 1, v, 1) for p in pieces)
        print(json.dumps({"file": file, "up": v, "third": nstr(third, 36), "theta": nstr(theta, 36),
                          "length": nstr(length, 36)}), flush=True)


main()
