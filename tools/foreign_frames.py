"""Rotation-minimizing frames, lengths and angles by quadrature in multiprecision arithmetic, of a curve as its file says it,
and by no code of phrame: what the values of reference/ are checked against.

A curve is r(t) with its first two derivatives by arithmetic with jets. Along a segment the frame f2 = (v x e1)/|v x e1|,
f3 = e1 x f2 of a vector v turns about e1, and the rotation-minimizing one has the angle

    theta' = -(v.r') det(v, r', r'') / (|r'| |v x r'|^2)

to it; at a joint the frame is carried by the least rotation that takes one tangent to the next. Integrals are by Gauss-Legendre
quadrature on intervals that are halved until two rules agree. Of PH curves the angle from the Euler-Rodrigues frame is by -2h/sigma.
"""
import math
import re
from fractions import Fraction
from functools import cache

from flint import arb, ctx

BITS, ORDERS = 288, (24, 36)
TOLERANCE = arb(2) ** -200  # of two rules, for each interval
ctx.prec = BITS


@cache
def rule(n):
    return [arb.legendre_p_root(n, k, weight=True) for k in range(n)]


def middle(x):
    return x.mid()


def integral(functions, a, b, depth=0):
    """The integrals of a function t -> list over [a, b]."""
    sums = []
    for n in ORDERS:
        half, center = (b - a) / 2, (a + b) / 2
        values = [[w * half * y for y in functions(middle(center + half * x))] for x, w in rule(n)]
        sums.append([sum((middle(y) for y in column), arb(0)) for column in zip(*values)])
    if all(abs(middle(x - y)) <= TOLERANCE for x, y in zip(*sums)) or depth > 200:
        return [middle(x) for x in sums[1]]
    c = middle((a + b) / 2)
    return [middle(x + y) for x, y in zip(integral(functions, a, c, depth + 1), integral(functions, c, b, depth + 1))]


class Jet:
    """f, f', f'' at a point."""

    def __init__(self, f, d=0, dd=0):
        self.f, self.d, self.dd = arb(f), arb(d), arb(dd)

    def __add__(self, b):
        b = jet(b)
        return Jet(self.f + b.f, self.d + b.d, self.dd + b.dd)

    def __mul__(self, b):
        b = jet(b)
        return Jet(self.f * b.f, self.d * b.f + self.f * b.d, self.dd * b.f + 2 * self.d * b.d + self.f * b.dd)

    def of(self, g, dg, ddg):
        """g(f), from the derivatives of g at f."""
        return Jet(g, dg * self.d, ddg * self.d * self.d + dg * self.dd)

    def __truediv__(self, b):
        b = jet(b)
        return self * b.of(1 / b.f, -1 / b.f ** 2, 2 / b.f ** 3)

    def __pow__(self, k):
        out = Jet(1)
        for _ in range(k):
            out = out * self
        return out

    def __neg__(self):
        return self * -1

    def __sub__(self, b):
        return self + jet(b) * -1

    def __radd__(self, b):
        return self + b

    def __rmul__(self, b):
        return self * b

    def __rsub__(self, b):
        return jet(b) - self

    def __rtruediv__(self, b):
        return jet(b) / self


def jet(x):
    return x if isinstance(x, Jet) else Jet(number(x))


def number(x):
    """Exactly, of an int, a Fraction, an arb or the text of a number."""
    if isinstance(x, str):
        x = Fraction(x)
    return arb(x.numerator) / x.denominator if isinstance(x, Fraction) else arb(x)


def exponential(x, sign):
    return (jet(x).f.exp() + sign * (-jet(x).f).exp()) / 2


FUNCTIONS = {
    "log": lambda x: jet(x).of(jet(x).f.log(), 1 / jet(x).f, -1 / jet(x).f ** 2),
    "atan": lambda x: jet(x).of(jet(x).f.atan(), 1 / (1 + jet(x).f ** 2), -2 * jet(x).f / (1 + jet(x).f ** 2) ** 2),
    "tan": lambda x: FUNCTIONS["sin"](x) / FUNCTIONS["cos"](x),
    "cosh": lambda x: jet(x).of(exponential(x, 1), exponential(x, -1), exponential(x, 1)),
    "sinh": lambda x: jet(x).of(exponential(x, -1), exponential(x, 1), exponential(x, -1)),
    "tanh": lambda x: FUNCTIONS["sinh"](x) / FUNCTIONS["cosh"](x),
    "sin": lambda x: jet(x).of(jet(x).f.sin(), jet(x).f.cos(), -jet(x).f.sin()),
    "cos": lambda x: jet(x).of(jet(x).f.cos(), -jet(x).f.sin(), -jet(x).f.cos()),
    "exp": lambda x: jet(x).of(*[jet(x).f.exp()] * 3),
    "sqrt": lambda x: jet(x).of(jet(x).f.sqrt(), 1 / (2 * jet(x).f.sqrt()), -1 / (4 * jet(x).f.sqrt() ** 3))}


def formula(text, **names):
    """The value of a formula like "3*cos(s)", where ^ is a power with an integer."""
    text = re.sub(r"(?<![\w.])([0-9]+)(?![\w.])", r"N('\1')", text).replace("^", "**")
    text = re.sub(r"\*\*\s*N\('([0-9]+)'\)", r"**\1", text)
    return eval(text, {"__builtins__": {}, "N": lambda x: jet(x), "pi": Jet(arb.pi()), **FUNCTIONS}, names)


def horner(coefficients, t):
    t, f, d, dd = jet(t), arb(0), arb(0), arb(0)
    for c in reversed(coefficients):
        f, d, dd = f * t.f + number(c), d * t.f + f * t.d, dd * t.f + 2 * d * t.d + f * t.dd
    return Jet(f, d, dd)


def bezier(points, t):
    """By de Casteljau's algorithm."""
    points = [jet(p) for p in points]
    while len(points) > 1:
        points = [a + (b - a) * t for a, b in zip(points, points[1:])]
    return points[0]


def product(a, b):
    c = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += x * y
    return c


def power_basis(c, basis):
    """Of coefficients in a basis."""
    c = [Fraction(x) for x in c]
    if basis == "power":
        return c
    out, binomial, n = [], 1, len(c) - 1
    for k in range(n + 1):
        out.append(c[0] * binomial)
        c, binomial = [b - a for a, b in zip(c, c[1:])], binomial * (n - k) // (k + 1)
    return out


def padded_sum(*signed):
    n = max(len(a) for _, a in signed)
    return [sum((s * a[k] for s, a in signed if k < len(a)), Fraction(0)) for k in range(n)]


class Segment:
    """One curve of a file: jets(t) are x, y, z, on [0, 1]."""

    def __init__(self, curve):
        self.A = None
        if "preimage" in curve:
            basis = curve["basis"]
            u, v, p, q = self.A = [power_basis(curve["preimage"][key], basis) for key in "uvpq"]
            f = curve.get("multiplier", [1])
            over = [Fraction(1)]
            if isinstance(f, dict):
                f, over = f["numerator"], power_basis(f["denominator"], basis)
            f = power_basis(f, basis)
            x = padded_sum((1, product(u, u)), (1, product(v, v)), (-1, product(p, p)), (-1, product(q, q)))
            y = padded_sum((2, product(u, q)), (2, product(v, p)))
            z = padded_sum((2, product(v, q)), (-2, product(u, p)))
            start = [Fraction(c) for c in curve.get("start", [0, 0, 0])]
            self.lists = [[c] + [a / (k + 1) for k, a in enumerate(product(f, d))] for c, d in zip(start, (x, y, z))]
            if next((c for c in f if c), 1) < 0:  # e1 = r'/|r'| at the start, by A j and -f
                self.A = [[-c for c in p], [-c for c in q], u, v]
            self.jets = lambda t: [horner(c, t) for c in self.lists]
            if len(over) > 1:  # no polynomial: r is an integral
                self.rates, self.start = [product(f, d) for d in (x, y, z)], start
                self.at = lambda t: self.by_rates(over, t)
        elif "control_points" in curve:
            weights = [Fraction(w) for w in curve.get("weights", [1] * len(curve["control_points"]))]
            points = [[Fraction(c) for c in p] for p in curve["control_points"]]
            columns = [[w * p[k] for w, p in zip(weights, points)] for k in range(3)]
            self.jets = lambda t: [bezier(c, t) / bezier(weights, t) for c in columns]
        elif "position" in curve:
            lists = {key: power_basis(c, curve["basis"]) for key, c in curve["position"].items()}
            w = lists.get("w", [Fraction(1)])
            self.jets = lambda t: [horner(lists.get(key, [0]), t) / horner(w, t) for key in "xyz"]
        else:
            e, a, b = curve["expressions"], formula(str(curve["from"])), formula(str(curve["to"]))
            name = curve["variable"]
            self.jets = lambda t: [jet(formula(e[key], **{name: a + (b - a) * t})) for key in "xyz"]

    def at(self, t):
        """(r, r', r'')"""
        x = self.jets(Jet(t, 1))
        return [a.f for a in x], [a.d for a in x], [a.dd for a in x]

    def by_rates(self, over, t):
        """The same of r' = rates/over. r, which is dear, is made when it is looked at."""
        def rate(s):
            return [horner(c, Jet(s, 1)) / horner(over, Jet(s, 1)) for c in self.rates]
        x = rate(t)
        return Late(lambda: [number(a) + b for a, b in zip(self.start, integral(lambda s: [a.f for a in rate(s)], arb(0), t))]), [
            a.f for a in x], [a.d for a in x]

    def signed_frenet(self, ts, steps=600):
        """[(n, b, kappa)] of the Frenet frame that goes on through inflections, none of which is at 0 or at one of ts."""
        def normal(t):
            _, d, dd = self.at(t)
            e1 = unit(d)
            return e1, plus(dd, times(-dot(dd, e1), e1)), dot(d, d)
        found, last = [], unit(normal(arb(0))[1])
        for k in range(steps + 1):
            while len(found) < len(ts) and ts[len(found)] * steps <= k:  # between the two steps about it the normal turns little
                e1, w, square = normal(number(ts[len(found)]))
                n = unit(w)
                n = n if dot(n, last) > 0 else times(-1, n)
                found.append((n, cross(e1, n), dot(w, n) / square))
            _, w, _ = normal(arb(k) / steps)
            if dot(w, w) > arb(10) ** -12:
                n = unit(w)
                last = n if dot(n, last) > 0 else times(-1, n)
        return found

    def offset(self, d, cusps, ts):
        """Of a plane curve, at the distance d to the right: its length, given the t of its cusps to 16 digits, its points at ts,
        and the number of changes of the sign of 1 + d kappa between many t."""
        def growth(t):
            _, (x, y, _), (xx, yy, _) = self.at(t)
            square = x * x + y * y
            return square.sqrt() + number(d) * (x * yy - y * xx) / square

        def zero(t):
            a, b = t - arb(10) ** -16, t + arb(10) ** -16
            assert growth(a) * growth(b) < 0
            for _ in range(3):  # the secant method
                a, b = b, middle(b - growth(b) * (b - a) / (growth(b) - growth(a)))
            return b
        stops = [arb(0), *(zero(number(t)) for t in cusps), arb(1)]
        length = sum((abs(integral(lambda t: [growth(t)], a, b)[0]) for a, b in zip(stops, stops[1:])), arb(0))

        def point(t):
            (x, y, z), (dx, dy, _), _ = self.at(number(t))
            k = number(d) / (dx * dx + dy * dy).sqrt()
            return x + k * dy, y - k * dx, z
        signs = [growth(arb(k) / 1000) > 0 for k in range(1001)]
        return length, [point(t) for t in ts], sum(a != b for a, b in zip(signs, signs[1:]))


class Late:
    """A list that is made when it is looked at."""

    def __init__(self, make):
        self.make = make

    def __iter__(self):
        return iter(self.make())


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), arb(0))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def times(k, a):
    return [k * x for x in a]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def unit(a):
    return times(1 / dot(a, a).sqrt(), a)


def turned(f2, e1, angle):
    """f2 turned about e1."""
    return [middle(x) for x in plus(times(angle.cos(), f2), times(angle.sin(), cross(e1, f2)))]


def carried(f, a, b):
    """f by the least rotation that takes the unit vector a to b, not -a."""
    w = cross(a, b)
    return plus(plus(f, cross(w, f)), times(1 / (1 + dot(a, b)), cross(w, cross(w, f))))


VECTORS = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [3, 5, 7], [-7, 4, 5], [5, -9, 2], [2, 3, -11]]


def far_from(segment, a, b):
    """A vector that is nowhere near the tangent."""
    tangents = [unit(segment.at(middle(a + (b - a) * arb(k) / 32))[1]) for k in range(33)]
    return max(VECTORS, key=lambda v: min(float(dot(cross(unit(v), e), cross(unit(v), e)).mid()) for e in tangents))


def along(segment, f2, a, b):
    """(the rotation-minimizing f2 at b, the length) from f2 at a to b."""
    if float(abs(a - b).mid()) == 0:
        return f2, arb(0)
    v = [arb(x) for x in far_from(segment, a, b)]

    def rates(t):
        _, d, dd = segment.at(t)
        speed, w = dot(d, d).sqrt(), cross(v, d)
        return [dot(v, d) * dot(cross(d, dd), v) / (speed * dot(w, w)), speed]
    theta, length = integral(rates, a, b)

    def frame(t):
        e1 = unit(segment.at(t)[1])
        return e1, unit(cross(v, e1))
    (e1, g), (e1_b, g_b) = frame(a), frame(b)
    x, y = dot(f2, g), dot(f2, cross(e1, g))
    turned_by = turned(g_b, e1_b, -theta)  # g(a), carried along
    return [middle(c) for c in plus(times(x, turned_by), times(y, cross(e1_b, turned_by)))], length


class Path:
    """The segments of a curve/1 or spline/1 file."""

    def __init__(self, value):
        self.segments = [Segment(curve) for curve in value.get("segments", [value])]

    def first_frame(self):
        """f2(0): where the least rotation from the x axis to e1(0) takes the y axis."""
        e1 = unit(self.segments[0].at(arb(0))[1])
        one = [arb(1), arb(0), arb(0)]
        return carried([arb(0), arb(1), arb(0)], one, e1)

    def frames(self, ts, first=None):
        """[(r, e1, f2, f3, length up to there)] at ascending t, the length of the path and f2 at its end; t = 0 … number of
        segments; behind a corner. f2(0) is the first, or that of the least rotation."""
        f2, length, found, at = first or self.first_frame(), arb(0), [], 0
        for k, segment in enumerate(self.segments):
            if k:
                f2 = carried(f2, unit(self.segments[k - 1].at(arb(1))[1]), unit(segment.at(arb(0))[1]))
            t = arb(0)
            last = k + 1 == len(self.segments)
            while at < len(ts) and (ts[at] < k + 1 or last and ts[at] == k + 1):
                to = number(ts[at] - k)
                f2, more = along(segment, f2, t, to)
                t, length, at = to, length + more, at + 1
                r, d, _ = segment.at(t)
                e1 = unit(d)
                found.append((r, e1, f2, cross(e1, f2), length))
            f2, more = along(segment, f2, t, arb(1))
            length += more
        return found, length, f2

    def minimal_twist(self, start, end, ts):
        """The angle in (-pi, pi] by which the frame turns about e1 from the vector start, projected, to end, against the
        rotation-minimizing one, in proportion to arc length, and [(f2, f3)] at ts."""
        e1 = unit(self.segments[0].at(arb(0))[1])
        first = unit(plus(start, times(-dot(start, e1), e1)))
        found, length, last = self.frames(ts, first)
        e1 = unit(self.segments[-1].at(arb(1))[1])
        turn = middle(arb.atan2(dot(end, cross(e1, last)), dot(end, last)))
        frames = [turned(f2, e1, turn * s / length) for _, e1, f2, _, s in found]
        return turn, [(f2, cross(e1, f2)) for f2, (_, e1, _, _, _) in zip(frames, found)]

    def holonomy(self):
        """The angle in (-pi, pi] by which f2 has turned about e1 when it comes back to the start."""
        f2, (_, _, end) = self.first_frame(), self.frames([])
        first, last = (unit(self.segments[k].at(arb(t))[1]) for k, t in ((0, 0), (-1, 1)))
        end = carried(end, last, first)
        return arb.atan2(dot(end, cross(first, f2)), dot(end, f2))

    def writhe(self, steps=400):
        """Of one smooth closed curve: Fuller's formula gives it up to an integer, which Gauss's double integral tells, by sums of doubles."""
        part = middle(self.holonomy() / (2 * arb.pi()))
        points, rates = [], []
        for k in range(steps):
            r, d, _ = self.segments[0].at(arb(2 * k + 1) / (2 * steps))
            points.append([float(x.mid()) for x in r])
            rates.append([float(x.mid()) for x in d])
        total = 0.0
        for i in range(steps):
            (x, y, z), (a, b, c) = points[i], rates[i]
            for (x1, y1, z1), (d, e, f) in zip(points[:i], rates[:i]):
                u, v, w = x - x1, y - y1, z - z1
                total += (u * (b * f - c * e) + v * (c * d - a * f) + w * (a * e - b * d)) / (u * u + v * v + w * w) ** 1.5
        total = 2 * total / (4 * math.pi * steps * steps)
        whole = round(total - float(part.mid()))
        assert abs(total - float(part.mid()) - whole) < 0.1, "Gauss's sum %s is not near %s + n" % (total, part)
        return part + whole


def angle_to_erf(segment, t):
    """theta(t) of the rotation-minimizing frame to the Euler-Rodrigues frame of the preimage, by -2h/sigma."""
    def rate(x):
        u, v, p, q = (horner(c, Jet(x, 1)) for c in segment.A)
        return [-2 * (u.f * v.d - u.d * v.f - p.f * q.d + p.d * q.f) / (u.f ** 2 + v.f ** 2 + p.f ** 2 + q.f ** 2)]
    return integral(rate, arb(0), number(t))[0]
