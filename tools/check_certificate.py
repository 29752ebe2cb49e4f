#!/usr/bin/env python3
"""Proves or refuses the claims of a certificate/1 (docs/certificate.md), with integers alone.

What is proved: the angle theta(t) between a reference frame and the rotation-minimizing frame of a PH curve
lies within `radius` of the number `theta` of each claim; and what kind of curve it is. How: the curve is
read, sigma, h, g and the hodograph are computed again; theta' = -2h/sigma = N/D and F' = N/D are identities
of rational functions; the roots of the logarithms are enclosed in discs by an inequality between exact
integers, so are the residues; the angle is then a sum of logarithms and arctangents, whose intervals come
from power series in integers with proved remainders. Decisions are proved by gcds, ranks, exact division and
Descartes' rule of signs.

There is no floating point. Every rounding is in the direction that makes an accepted inequality true. The
letters are those of docs/certificate.md. Exit status: 0 all is proved, 1 something is not, 2 this is no
certificate.
"""
import argparse
import json
import re
import sys
from fractions import Fraction
from functools import reduce
from itertools import accumulate, combinations
from math import gcd, isqrt
from types import SimpleNamespace

MAX_EXPONENT, MAX_BITS = 100000, 1000000


class Malformed(Exception):
    """This is no certificate: where, and what is wrong."""


class NotProved(Exception):
    """The statement at hand is not proved, and why."""


def require(condition, why):
    """Every step of every proof goes through here."""
    if not condition:
        raise NotProved(why)


# ---- Integer polynomials: lists of coefficients from the constant term up, the last not 0, [] for 0. -------


def stripped(a):
    """Without the zeros at the end."""
    n = len(a)
    while n and a[n - 1] == 0:
        n -= 1
    return a[:n]


def primitive(a):
    """Divided by the gcd of the coefficients, a positive number: no sign of a value changes."""
    g = reduce(gcd, a, 0)
    return a if g in (0, 1) else [x // g for x in a]


def derived(a):
    """The derivative."""
    return [k * x for k, x in enumerate(a)][1:]


def remainder(a, b):
    """(r, m) with m*a = (something)*b + r, deg r < deg b, m > 0."""
    a, m = a[:], 1
    while len(a) >= len(b):
        g = gcd(a[-1], b[-1])
        f, k, low = abs(b[-1]) // g, a[-1] // g, len(a) - len(b)
        k = k if b[-1] > 0 else -k
        m *= f
        a = [f * x for x in a] if f != 1 else a
        for i, x in enumerate(b, low):
            a[i] -= k * x
        a = stripped(a)
    return a, m


def quotient(a, b):
    """a/b for a primitive b, or None if b does not divide a (by Gauss's lemma the quotient has integer
    coefficients)."""
    a, q = a[:], []
    while len(a) >= len(b):
        k, rest = divmod(a[-1], b[-1])
        if rest:
            return None
        for i, x in enumerate(b, len(a) - len(b)):
            a[i] -= k * x
        a.pop()
        q.append(k)
    return None if any(a) else q[::-1]


def gcd_modulo(a, b, p):
    """Euclid modulo p, ending with a monic polynomial. ValueError: some number has no inverse, p is no
    prime."""
    a, b = stripped([x % p for x in a]), stripped([x % p for x in b])
    while b:
        inverse = pow(b[-1], -1, p)
        b = [x * inverse % p for x in b]
        while len(a) >= len(b):
            k, low = a[-1], len(a) - len(b)
            if k:
                a[low:] = [(x - k * y) % p for x, y in zip(a[low:], b)]
            a.pop()
        a, b = b, stripped(a)
    return [x * pow(a[-1], -1, p) % p for x in a]


MERSENNE = (61, 127, 521, 1279, 2203, 4423, 9689, 19937, 44497, 86243, 216091)  # 2^e - 1 is prime


def common_divisor(a, b):
    """The primitive gcd over Q. Modulo a p that divides neither leading coefficient the gcd has at least the
    degree of the gcd over Q; so a common divisor of the degree found modulo p is the gcd. How it was guessed
    is no matter."""
    if not a or not b:
        return primitive(a or b)
    short, long = sorted((primitive(a), primitive(b)), key=len)
    if quotient(long, short) is not None:
        return short
    for p in ((1 << e) - 1 for e in MERSENNE):
        if a[-1] % p and b[-1] % p:
            guess = [gcd(a[-1], b[-1]) * x % p for x in gcd_modulo(long, short, p)]
            if len(guess) == 1:
                return [1]
            guess = primitive([x - p if 2 * x > p else x for x in guess])
            if quotient(short, guess) is not None and quotient(long, guess) is not None:
                return guess
    raise NotProved("a greatest common divisor is too large for this checker")


def squarefree(a):
    """a/gcd(a, a'): the same zeros, all simple."""
    return quotient(primitive(a), common_divisor(a, derived(a)))


def translated(a, shift):
    """a(t + shift), by repeated synthetic division."""
    rest, out = a[::-1], []
    while rest:
        rest = list(accumulate(rest, lambda s, x: s * shift + x))
        out.append(rest.pop())
    return out


def sign_changes(values):
    """The number of sign changes, zeros skipped."""
    signs = [x > 0 for x in values if x]
    return sum(x != y for x, y in zip(signs, signs[1:]))


def zeros_between(a, low, high):
    """The number of zeros of a squarefree a in the open interval (low, high), by Descartes' rule of signs:
    the zeros of a(t) in (0, 1) are the positive ones of (1+s)^n a(1/(1+s)); with 0 or 1 sign changes their
    number is just that. Else the interval is halved. For simple zeros this ends, by Vincent's theorem."""
    den = low.denominator * high.denominator
    l, n = int(low * den), len(a) - 1
    a = translated([x * den ** (n - k) for k, x in enumerate(a)], l)
    todo, count = [[x * (int(high * den) - l) ** k for k, x in enumerate(a)]], 0
    while todo:
        a = todo.pop()
        changes = sign_changes(translated(a[::-1], 1))
        if changes == 1:
            count += 1
        elif changes > 1:
            left = primitive([x << (n - k) for k, x in enumerate(a)])
            right = translated(left, 1)
            count += right[0] == 0
            todo += [left, right]
    return count


def scaled_value(a, t):
    """den(t)^n a(t), an integer of the sign of a(t)."""
    value, power = 0, 1
    for x in reversed(a):
        value = value * t.numerator + x * power
        power *= t.denominator
    return value


def zeros_within(a, low, high):
    """The number of zeros of a squarefree a in the closed interval [low, high]."""
    ends = {low, high}
    return sum(scaled_value(a, t) == 0 for t in ends) + (zeros_between(a, low, high) if low < high else 0)


# ---- Polynomials over Q: integer coefficients over a common denominator, in lowest terms. ------------------


class Poly:
    """The polynomial sum c[k] t^k / d, d > 0. The form is unique, so equality is equality of c and d."""

    def __init__(self, c, d=1):
        c = stripped(c)
        g = reduce(gcd, c, d)
        self.c, self.d = [x // g for x in c], d // g

    def __add__(self, b):
        n = max(len(self.c), len(b.c))
        c, e = self.c + [0] * (n - len(self.c)), b.c + [0] * (n - len(b.c))
        return Poly([x * b.d + y * self.d for x, y in zip(c, e)], self.d * b.d)

    def __sub__(self, b):
        return self + b * -1

    def __mul__(self, b):
        if isinstance(b, (int, Fraction)):
            return Poly([x * b.numerator for x in self.c], self.d * b.denominator)
        c = [0] * (len(self.c) + len(b.c))
        for k, x in enumerate(self.c):
            if x:
                for i, y in enumerate(b.c, k):
                    c[i] += x * y
        return Poly(c, self.d * b.d)

    def __eq__(self, b):
        return (self.c, self.d) == (b.c, b.d)

    def __bool__(self):
        return bool(self.c)

    def __call__(self, t):
        return Fraction(scaled_value(self.c, t), self.d * t.denominator ** max(0, len(self.c) - 1))

    def derivative(self):
        return Poly(derived(self.c), self.d)

    def is_constant(self):
        return len(self.c) <= 1

    def over(self, b):
        """self/b where b is known or required to divide it."""
        b_primitive = primitive(b.c)
        q = quotient(self.c, b_primitive)
        require(q is not None, "a polynomial is not divisible by another")
        return Poly(q) * Fraction(b_primitive[-1] * b.d, b.c[-1] * self.d)


def common(polys):
    """The gcd of some polynomials, primitive; 0 if all are 0."""
    return Poly(reduce(common_divisor, (p.c for p in polys), []))


def rank(polys):
    """The dimension of the span: eliminate the highest coefficient, again and again."""
    rows, n = [p.c for p in polys if p], 0
    while rows:
        rows.sort(key=len)
        top, n = rows.pop(), n + 1
        k = len(top)
        rows = [primitive(stripped([x * top[-1] - y * a[-1] for x, y in zip(a, top)])) if len(a) == k else a
                for a in rows]
        rows = [a for a in rows if a]
    return n


# ---- Logarithm and arctangent in fixed point: n stands for n/2^P, a pair (low, high) for an interval. ---


def plus(a, b):
    return a[0] + b[0], a[1] + b[1]


def times(a, k):
    """An interval times an integer."""
    return (a[0] * k, a[1] * k) if k >= 0 else (a[1] * k, a[0] * k)


class Fixed:
    """ln and arctan with P bits after the point."""

    def __init__(self, P):
        self.P = P
        self.ln_table = {16: (0, 0)}  # ln(j/16), since ln(j/(j-1)) = 2 artanh(1/(2j-1))
        for j in range(17, 33):
            self.ln_table[j] = plus(self.ln_table[j - 1], times(self.series(1, 2 * j - 1, 1), 2))
        self.arctan_table = [(0, 0)]  # arctan(j/8), since tan(a - b) = (tan a - tan b)/(1 + tan a tan b)
        for j in range(1, 9):
            self.arctan_table.append(plus(self.arctan_table[-1], self.series(8, 64 + j * (j - 1), -1)))
        self.pi = times(self.arctan_table[8], 4)

    def series(self, a, b, sign):
        """The sum of sign^k e^(2k+1)/(2k+1) for e = a/b, 0 <= e <= 1/8: artanh (sign 1) or arctan (sign -1).
        `power` is below e^(2k+1) 2^P by less than 2: less than 2/64 + 1/8 comes from the factors, less than 1
        from the last rounding. So each term is wrong by less than 3, and when `power` is 0 the terms left out
        sum to less than 2/(1 - 1/64) < 3. After k terms the error is less than 3k + 3."""
        if a == 0:
            return 0, 0
        power, square = (a << self.P) // b, (a * a << self.P) // (b * b)
        total, k = 0, 0
        while power:
            term = power // (2 * k + 1)
            total += -term if sign < 0 and k % 2 else term
            power = power * square >> self.P
            k += 1
        return total - 3 * k - 3, total + 3 * k + 3

    def ln(self, a, b):
        """ln(a/b), a, b > 0: a/b = 2^k m with 1 <= m < 2, j = [16 m], ln(16m/j) = 2 artanh((16m - j)/(16m +
        j))."""
        k = a.bit_length() - b.bit_length()
        a, b = (a, b << k) if k >= 0 else (a << -k, b)
        if a < b:
            a, k = 2 * a, k - 1
        j = 16 * a // b
        small = times(self.series(16 * a - j * b, 16 * a + j * b, 1), 2)
        return plus(plus(times(self.ln_table[32], k), self.ln_table[j]), small)

    def arctan(self, a, b):
        """arctan(a/b), b != 0; for 0 <= v <= 1, j = [8 v], it is arctan(j/8) + arctan((8v - j)/(8 + jv))."""
        if b < 0:
            a, b = -a, -b
        if a < 0:
            return times(self.arctan(-a, b), -1)
        if a > b:
            return plus(times(self.arctan_table[8], 2), times(self.arctan(b, a), -1))
        j = 8 * a // b
        return plus(self.arctan_table[j], self.series(8 * a - j * b, 8 * b + j * a, -1))


# Square roots keep 128 bits, a relative error below 2^-126; distances get 64 bits more than the grid.
ROOT_BITS, FINE = 256, 64


def root_down(n):
    """At most the square root of n."""
    e = max(0, n.bit_length() - ROOT_BITS) // 2
    return isqrt(n >> 2 * e) << e


def root_up(n):
    """At least the square root of n; 0 for 0. For n < (m + 1) 4^e and [sqrt m] + 1 >= sqrt(m + 1)."""
    e = max(0, n.bit_length() - ROOT_BITS) // 2
    return (isqrt(n >> 2 * e) + 1) << e if n else 0


def at_grid_point(a, x, y, B):
    """2^(B n) a(z) for z = (x + iy)/2^B and a list a of n + 1 integers, exactly: (real part, imaginary
    part)."""
    re, im, shift = 0, 0, 0
    for c in reversed(a):
        re, im = re * x - im * y + (c << shift), re * y + im * x
        shift += B
    return re, im


# ---- Reading. Everything is read and checked for form before anything is proved. ---------------------------


class Object(dict):
    """A JSON object, which remembers a key that came twice."""

    def __init__(self, pairs):
        super().__init__(pairs)
        keys = [k for k, _ in pairs]
        self.twice = next((k for k in keys if keys.count(k) > 1), None) if len(keys) > len(self) else None


def fail(place, what, value):
    """The value at the place is not as it should be."""
    shown = json.dumps(value)
    raise Malformed("%s: %s: %s" % (place or "/", what, shown[:60] + ("..." if len(shown) > 60 else "")))


def read(form, value, place):
    """The value in the form wanted: {key: form} is an object with just these keys (those with a "?" may be
    missing, and give None), [form] a list, (form, form) a list of that length; a function reads all else."""
    if isinstance(form, dict):
        wanted = {key.rstrip("?"): inner for key, inner in form.items()}
        if not isinstance(value, dict):
            fail(place, "an object is wanted", value)
        if value.twice is not None:
            fail(place, "the key %s is there twice" % json.dumps(value.twice), value)
        for key in list(value) + [key for key in form if not key.endswith("?")]:
            if key not in wanted or key not in value:
                problem = "missing" if key in wanted else "unknown"
                fail(place, "the key %s is %s" % (json.dumps(key), problem), value)
        return SimpleNamespace(**{key: read(inner, value[key], place + "/" + key) if key in value else None
                                  for key, inner in wanted.items()})
    if isinstance(form, (list, tuple)):
        if not isinstance(value, list) or isinstance(form, tuple) and len(form) != len(value):
            length = "" if isinstance(form, list) else " of %d" % len(form)
            fail(place, "a list%s is wanted" % length, value)
        forms = form * len(value) if isinstance(form, list) else form
        return [read(inner, x, "%s/%d" % (place, k)) for k, (inner, x) in enumerate(zip(forms, value))]
    return form(value, place)


NUMBER = re.compile(r"(-?[0-9]+)(?:/([0-9]+)|(?:\.([0-9]+))?(?:[eE]([+-]?[0-9]+))?)\Z")


def rational(value, place):
    """A fraction, an integer or a decimal number, exactly."""
    is_number = isinstance(value, (str, int)) and not isinstance(value, bool)
    match = NUMBER.match(str(value)) if is_number else None
    if not match:
        fail(place, "a number is wanted, an integer, a fraction or a decimal number", value)
    head, below, digits, exponent = (x or "" for x in match.groups())
    if len(exponent) > 20 or abs(int(exponent or 0)) > MAX_EXPONENT:
        fail(place, "exponents are limited to %d" % MAX_EXPONENT, value)
    if below and int(below) == 0:
        fail(place, "the denominator is 0", value)
    return Fraction(int(head + digits), int(below or 1)) * Fraction(10) ** (int(exponent or 0) - len(digits))


def decimal(value, place):
    """A decimal number; its text is kept."""
    if "/" in str(value):
        fail(place, "a decimal number is wanted", value)
    return SimpleNamespace(value=rational(value, place), text=str(value))


def integer(value, place):
    """An integer in a string."""
    number = rational(value, place)
    if number.denominator != 1:
        fail(place, "an integer is wanted", value)
    return number.numerator


def count(value, place):
    """An integer that is no string."""
    if isinstance(value, bool) or not isinstance(value, int) or abs(value) > MAX_BITS:
        fail(place, "an integer is wanted, not above %d" % MAX_BITS, value)
    return value


def at_least(least, form):
    """A number that is not too small."""
    def leaf(value, place):
        number = read(form, value, place)
        if getattr(number, "value", number) < least:
            fail(place, "a number not less than %d is wanted" % least, value)
        return number
    return leaf


def one_of(*strings):
    """One of some strings, or with none given any string."""
    def leaf(value, place):
        if not isinstance(value, str) or strings and value not in strings:
            fail(place, "%s is wanted" % (" or ".join(map(json.dumps, strings)) or "a string"), value)
        return value
    return leaf


def boolean(value, place):
    if not isinstance(value, bool):
        fail(place, "true or false is wanted", value)
    return value


def signs(value, place):
    if not isinstance(value, str) or set(value) - set("+-0"):
        fail(place, "signs are wanted, each of them +, - or 0", value)
    return value


def poly(value, place):
    c = read([rational], value, place)
    d = reduce(lambda d, x: d * x.denominator // gcd(d, x.denominator), c, 1)
    return Poly([x.numerator * (d // x.denominator) for x in c], d)


def complex_poly(value, place):
    parts = read({"re": poly, "im": poly}, value, place)
    return parts.re, parts.im


def point(value, place):
    """The only zero of w in the open interval (low, high); a rational t is that of den(t)x - num(t) in (t -
    1, t + 1)."""
    is_object = isinstance(value, dict) and isinstance(value.get("t"), dict)
    form = {"polynomial": poly, "interval": (rational, rational)} if is_object else rational
    P = read({"t": form, "order": at_least(1, count)}, value, place)
    if not is_object:
        return SimpleNamespace(order=P.order, w=[-P.t.numerator, P.t.denominator], low=P.t - 1, high=P.t + 1)
    low, high = P.t.interval
    if P.t.polynomial.is_constant() or low >= high:
        fail(place + "/t", "a polynomial that is not constant and an interval a < b are wanted", value["t"])
    return SimpleNamespace(order=P.order, w=P.t.polynomial.c, low=low, high=high)


def decision(when_true, when_false):
    """The answer, true or false, with the witnesses that it needs."""
    def leaf(value, place):
        is_true = isinstance(value, dict) and value.get("answer") is True
        return read(dict(answer=boolean, **(when_true if is_true else when_false)), value, place)
    return leaf


VECTOR, COMPLEX = (rational,) * 3, (integer, integer)
CURVE = {"phrame": one_of("curve/1"), "name?": one_of(), "note?": one_of(), "family?": one_of(),
         "basis": one_of("power"), "start?": VECTOR, "preimage": {key: poly for key in "uvpq"},
         "multiplier?": poly}
ROOT = {"center": COMPLEX, "radius": at_least(0, integer),
        "residue": COMPLEX, "residue_radius": at_least(0, integer)}
DECISIONS = {
    "regular": decision({"cusps": [point]}, {"cusps": [point]}),
    "inflections": decision({"points": [point]}, {"points": [point]}),
    "line": decision({"direction": VECTOR}, {}),
    "planar": decision({"normal": VECTOR}, {}),
    "helical": decision({"axis": VECTOR, "cos_squared": rational}, {}),
    "double_ph": decision({"omega": poly, "constant": rational}, {}),
    "primitive": decision({"content": poly}, {"content": poly}),
    "erf_is_rmf": decision({}, {}),
    "rrmf": decision({"w": complex_poly}, {}),
    "erf_monotone": decision(*({"zeros_of_h": [point], "extrema": [point]},) * 2)}
TURN, BEND = {"index": count, "signs": (signs, signs)}, {"polynomial": complex_poly, "content": poly}
CERTIFICATE = {
    "phrame": one_of("certificate/1"), "curve": CURVE, "frame": one_of("erf", "frenet"),
    "hodograph": (poly,) * 3, "sigma": poly, "h": poly, "g": complex_poly,
    "rate": {"numerator": poly, "denominator": poly, "common": poly, "coprime_modulo": at_least(2, integer)},
    "antiderivative": {"rational": {"numerator": poly, "denominator": poly},
                       "logs": [{"index": poly, "residue": poly, "roots": [ROOT]}]},
    "bits": at_least(0, count), "decisions": DECISIONS}
CLAIM = {"t": lambda value, place: SimpleNamespace(value=rational(value, place), text=str(value)),
         "theta": decimal, "radius": at_least(0, decimal)}


def refuse(text):
    raise ValueError("%s is no number" % text)


def read_certificate(data):
    """All that is in the file. The Frenet frame has `bend` and the turns of the claims, the other has not."""
    try:
        value = json.loads(data.decode("utf-8"), object_pairs_hook=Object, parse_float=str,
                           parse_constant=refuse)
        frenet = isinstance(value, dict) and value.get("frame") == "frenet"
        C = read(dict(CERTIFICATE, claims=[dict(CLAIM, turn=TURN)], bend=BEND) if frenet else
                 dict(CERTIFICATE, claims=[CLAIM]), value, "")
    except (ValueError, RecursionError) as error:
        raise Malformed("/: this is no JSON: %s" % str(error)[:200].replace("\n", " "))
    if C.curve.multiplier is None:
        C.curve.multiplier = Poly([1])
    if not C.curve.multiplier or not any(vars(C.curve.preimage).values()):
        fail("/curve", "a curve with a preimage and a multiplier that are not 0 is wanted", value["curve"])
    return C


# ---- The proof. --------------------------------------------------------------------------------------------


def bend_of(A):
    """g = alpha beta' - alpha' beta for alpha = u + iv, beta = q + ip."""
    u, v, p, q = A
    du, dv, dp, dq = (a.derivative() for a in A)
    return u * dq - v * dp - du * q + dv * p, u * dp + v * dq - du * p - dv * q


def norm(a):
    """|a|^2 of a complex polynomial."""
    return a[0] * a[0] + a[1] * a[1]


def spin(a):
    """Im(a' conj a)."""
    return a[1].derivative() * a[0] - a[0].derivative() * a[1]


class Zeros:
    """The zeros of P on [0, 1] with their orders. A zero of order k of P is one of order k - 1 of gcd(P, P'):
    levels[j] has the zeros of P of order greater than j, with the order less j."""

    def __init__(self, P):
        self.levels = [primitive(P.c)]
        while len(self.levels[-1]) > 1:
            self.levels.append(common_divisor(self.levels[-1], derived(self.levels[-1])))

    def level(self, j):
        return self.levels[min(j, len(self.levels) - 1)]

    def number(self, odd_only):
        """How many zeros there are: those of order > 0, less those of order > 1, plus those of order > 2 ...
        are the odd ones."""
        numbers = [zeros_within(quotient(a, b), Fraction(0), Fraction(1))
                   for a, b in zip(self.levels, self.levels[1:])]
        return sum(numbers[0::2]) - sum(numbers[1::2]) if odd_only else sum(numbers[:1])

    def check(self, point, name):
        """The point is in [0, 1] and is a zero of exactly the order claimed."""
        at_least, more = self.level(point.order - 1), self.level(point.order)
        low, high, w = point.low, point.high, squarefree(point.w)
        require(scaled_value(w, low) and scaled_value(w, high) and zeros_between(w, low, high) == 1,
                "%s: an interval does not hold exactly one zero of its polynomial" % name)
        a, b = max(low, Fraction(0)), min(high, Fraction(1))
        require(a <= b and zeros_within(w, a, b) == 1, "%s: a point is not in [0, 1]" % name)
        at_least, more = (common_divisor(w, self.level(k)) for k in (point.order - 1, point.order))
        require(zeros_between(at_least, low, high) == 1 and zeros_between(more, low, high) == 0,
                "%s: a point is no zero of order %d" % (name, point.order))


def are_distinct(a, b):
    """Whether two points differ: no common zero of their polynomials is in both intervals."""
    low, high = max(a.low, b.low), min(a.high, b.high)
    return low >= high or zeros_between(squarefree(common_divisor(a.w, b.w)), low, high) == 0


def is_inside(point):
    """Whether the point, which is in [0, 1], is neither 0 nor 1."""
    ends = Fraction(0), Fraction(1)
    return not any(point.low < t < point.high and scaled_value(point.w, t) == 0 for t in ends)


def check_points(P, points, name, odd_only=False):
    """The points are all the zeros of P on [0, 1], or all of odd order, each once; for P = 0 there are
    none."""
    if not P:
        require(not points, "%s: there must be no points, the polynomial is 0" % name)
        return
    zeros = Zeros(P)
    for point in points:
        zeros.check(point, name)
        require(point.order % 2 or not odd_only, "%s: a point of even order is listed" % name)
    require(all(are_distinct(a, b) for a, b in combinations(points, 2)), "%s: two points are the same" % name)
    number = zeros.number(odd_only)
    require(number == len(points), "%s: there are %d points, not %d" % (name, number, len(points)))


def sturm_sequence(x, y):
    """s0 = x, s1 = y, s2 = -rem(s0, s1), ... to the last that is not 0, each up to a positive factor."""
    s = [x] + ([y] if y else [])
    while len(s) > 1:
        rest = remainder(s[-2], s[-1])[0]
        if not rest:
            break
        s.append(primitive([-c for c in rest]))
    require(len(s[-1]) == 1, "the Sturm sequence does not end with a constant")
    return s


def apart(z, w):
    """Whether two closed discs do not meet."""
    return (z.x - w.x) ** 2 + (z.y - w.y) ** 2 > (z.r + w.r) ** 2


class Proof:
    """All statements of one certificate C, in the order of the page. The letters are those of the page."""

    def __init__(self, C):
        self.C, self.lines, self.proved, self.fixed, self.sturm = C, [], set(), {}, {}
        self.frenet, self.B, self.f = C.frame == "frenet", C.bits, C.curve.multiplier
        self.A = u, v, p, q = [getattr(C.curve.preimage, key) for key in "uvpq"]
        du, dv, dp, dq = (a.derivative() for a in self.A)
        self.sigma = u * u + v * v + p * p + q * q
        self.xyz = [u * u + v * v - p * p - q * q, (u * q + v * p) * 2, (v * q - u * p) * 2]
        self.hodograph = [self.f * a for a in self.xyz]
        self.h = u * dv - du * v - p * dq + dp * q
        self.g = bend_of(self.A)
        self.N, self.D = C.rate.numerator, C.rate.denominator
        self.P, self.Q = C.antiderivative.rational.numerator, C.antiderivative.rational.denominator
        self.logs = C.antiderivative.logs
        for log in self.logs:
            log.q, log.c = log.index, log.residue
            for z in log.roots:
                (z.x, z.y), (z.re, z.im), z.r, z.s = z.center, z.residue, z.radius, z.residue_radius

    def state(self, what, law, rests=(), *arguments):
        """One statement: proved, unless something it rests on is not, or the law says why not."""
        try:
            self.rest_on(rests)
            law(*arguments)
            self.proved.add(what)
            self.lines.append((True, "proved      " + what))
        except NotProved as why:
            self.lines.append((False, "not proved  %s: %s" % (what, why)))

    def rest_on(self, names):
        """The other statements a proof needs."""
        for name in names:
            require(name in self.proved, "rests on the %s" % name)

    def run(self):
        """All statements: a list of (is proved, line)."""
        self.state("invariants", self.invariants)
        self.state("rate", self.rate)
        self.state("antiderivative", self.antiderivative)
        self.needed = ["rate", "antiderivative"]  # what the angle rests on
        for k, log in enumerate(self.logs):
            roots, residues = "roots of log %d" % k, "residues of log %d" % k
            self.state(roots, self.roots, (), log)
            self.state(residues, self.residues, [roots], log)
            self.needed += [roots, residues]
        if self.frenet:
            self.state("bend", self.bend)
        for claim in self.C.claims:
            what = "|theta(%s) - %s| <= %s" % (claim.t.text, claim.theta.text, claim.radius.text)
            self.state(what, self.claim, ["bend"] if self.frenet else [], claim)
        for name in DECISIONS:
            self.state("decision " + name, getattr(self, name), (), getattr(self.C.decisions, name))
        return self.lines

    def invariants(self):
        """What is written is what follows from the curve. Nothing rests on this: all else uses what is
        computed."""
        C = self.C
        for name in ("hodograph", "sigma", "h", "g"):
            require(getattr(C, name) == getattr(self, name), "%s is not that of the curve" % name)

    def rate(self):
        """-2h = NK and sigma = DK; N and D are coprime modulo p, so they are coprime."""
        K, p = self.C.rate.common, self.C.rate.coprime_modulo
        require(self.h * -2 == self.N * K, "-2h is not numerator times common")
        require(self.sigma == self.D * K, "sigma is not denominator times common")
        if not self.N:
            require(self.D.is_constant(), "the numerator is 0 and the denominator is not constant")
            return
        N, D = primitive(self.N.c), primitive(self.D.c)
        require(N[-1] % p and D[-1] % p, "the modulus divides a leading coefficient")
        try:
            require(len(gcd_modulo(N, D, p)) == 1, "Euclid's algorithm modulo p does not end with a constant")
        except ValueError:
            raise NotProved("the modulus is no prime")

    @staticmethod
    def numerator(log):
        """n = c q' mod q."""
        product = log.c * log.q.derivative()
        rest, factor = remainder(product.c, log.q.c)
        return Poly(rest, factor * product.d)

    def antiderivative(self):
        """R' + sum n/q = N/D for R = P/Q."""
        require(self.Q and all(log.q for log in self.logs), "a denominator is 0")
        num, den = self.P.derivative() * self.Q - self.P * self.Q.derivative(), self.Q * self.Q
        for log in self.logs:
            num, den = num * log.q + self.numerator(log) * den, den * log.q
        require(num * self.D == self.N * den, "its derivative is not numerator/denominator")

    def roots(self, log):
        """Half as many discs as the degree d, disjoint, above the axis, and d |q(z)| <= r |q'(z)|: one root
        in each."""
        q, d = log.q.c, len(log.q.c) - 1
        require(2 * len(log.roots) == d, "the degree is %d, the number of roots %d" % (d, len(log.roots)))
        for k, z in enumerate(log.roots):
            require(z.r < z.y, "disc %d is not above the real axis" % k)
            q_z, slope = at_grid_point(q, z.x, z.y, self.B), at_grid_point(derived(q), z.x, z.y, self.B)
            require(d * d * (q_z[0] ** 2 + q_z[1] ** 2) <= z.r ** 2 * (slope[0] ** 2 + slope[1] ** 2),
                    "no root is proved to be in disc %d" % k)
        for (i, z), (k, w) in combinations(enumerate(log.roots), 2):
            require(apart(z, w), "discs %d and %d meet" % (i, k))

    def residues(self, log):
        """|n(z) - w q'(z)| + r (n^'(rho) + |w| q^''(rho)) <= s (|q'(z)| - r q^''(rho)), rho = |z| + r. Both
        sides are multiplied by the denominators of n and q and by a power of 2. rho is rounded up, with FINE
        more bits. (Where s or the right side is 0, so is the left side; then r = 0 or n = w = 0, and w is
        exact.)"""
        B, d, n = self.B, len(log.q.c) - 1, self.numerator(log)
        b = [x * n.d for x in derived(log.q.c)]
        n = [x * log.q.d for x in n.c] + [0] * (d - len(n.c))
        n_hat, b_hat = ([abs(x) for x in derived(a)] for a in (n, b))
        for k, z in enumerate(log.roots):
            n_z, b_z = at_grid_point(n, z.x, z.y, B), at_grid_point(b, z.x, z.y, B)
            miss = root_up(((n_z[0] << B) - z.re * b_z[0] + z.im * b_z[1]) ** 2 +
                           ((n_z[1] << B) - z.re * b_z[1] - z.im * b_z[0]) ** 2)
            slope = root_down(b_z[0] ** 2 + b_z[1] ** 2)
            rho = root_up((z.x ** 2 + z.y ** 2) << 2 * FINE) + (z.r << FINE)
            n_rho, b_rho = (at_grid_point(a, rho, 0, B + FINE)[0] for a in (n_hat, b_hat))
            size, shift = root_up(z.re ** 2 + z.im ** 2), FINE * (d - 2)
            left = (miss << shift) + z.r * ((n_rho << B) + size * b_rho)
            right = z.s * ((slope << shift) - z.r * b_rho)
            require(left <= right, "the radius of residue %d is not proved" % k)

    def bend(self):
        """g = G gamma is not 0, and gamma has coprime parts, so no real zero."""
        gamma, G = self.C.bend.polynomial, self.C.bend.content
        require(any(self.g), "g is 0, there is no Frenet frame")
        require(self.g == tuple(G * a for a in gamma), "g is not content times polynomial")
        parts_gcd = common_divisor(gamma[0].c, gamma[1].c)
        require(len(parts_gcd) == 1, "the parts of the polynomial are not coprime")
        self.is_rmf = not self.h * -2 * norm(gamma) + self.sigma * spin(gamma)

    def turn(self, t, turn):
        """The signs and the index are right; returns y(t)/x(t) and y(0)/x(0)."""
        zero, (re, im) = Fraction(0), self.C.bend.polynomial
        x, y = re * re(zero) + im * im(zero), im * re(zero) - re * im(zero)
        turned = x(t) == 0
        x, y = (x - y, x + y) if turned else (x, y)
        if turned not in self.sturm:
            self.sturm[turned] = sturm_sequence(primitive(x.c), primitive(y.c))
        values = [[scaled_value(s, at) for s in self.sturm[turned]] for at in (zero, t)]
        signs_found = ["".join("+" if v > 0 else "-" if v < 0 else "0" for v in row) for row in values]
        require(signs_found == turn.signs, "the signs at 0 and t are %s and %s" % tuple(signs_found))
        index = sign_changes(values[0]) - sign_changes(values[1])
        require(index == turn.index, "the index is %d" % index)
        return y(t) / x(t), y(zero) / x(zero)

    def claim(self, claim):
        """|theta(t) - theta| <= radius. theta(0) = 0, and theta_Frenet = 0 everywhere if that frame
        minimizes."""
        t, theta, radius, zero = claim.t.value, claim.theta.value, claim.radius.value, Fraction(0)
        slopes = self.turn(t, claim.turn) if self.frenet else (zero, zero)
        index = claim.turn.index if self.frenet else 0
        if t == 0 or self.frenet and self.is_rmf:
            require(abs(theta) <= radius, "the angle is 0")
            return
        self.rest_on(self.needed)
        require(self.Q(t) and self.Q(zero), "the denominator of the rational part is 0 at t or at 0")
        # The rational part of theta(t) - theta:
        distance = self.P(t) / self.Q(t) - self.P(zero) / self.Q(zero) - theta
        roots = [z for log in self.logs for z in log.roots]
        require(radius > 0 or not roots, "the radius is 0, and there are logarithms")
        ask = max(0, radius.denominator.bit_length() - radius.numerator.bit_length()) + 64
        ask += max(0, sum(abs(z.re) + abs(z.im) for z in roots).bit_length() - self.B)
        bits, most = min(ask, 4096), ask + 256
        while True:  # ends, since bits grows to most
            (low, high), error = self.angle(t, roots, slopes, index, bits)
            unit = Fraction(1, 1 << (bits + self.B))
            least, greatest = distance + (low - error) * unit, distance + (high + error) * unit
            if -radius <= least and greatest <= radius:
                return
            require(-radius <= greatest and least <= radius, "the angle is not that")
            require(high - low > error >> 16, "the discs are too large")
            require(bits < most, "the angle is too close to the end of the interval")
            bits = min(2 * bits, most)

    def angle(self, t, roots, slopes, index, bits):
        """(interval, error): theta(t) - R(t) + R(0) computed at the centres is in the interval, and differs
        from the true one by at most error; all times 2^(bits + B). With L = log(1 - t/zeta) a root adds 2
        Re(c L), and |dL/dzeta| = |t|/|zeta (t - zeta)|. So the disc of the root is worth 2 (|w| + s) r
        |t|/((|z| - r)(|t - z| - r)) and that of the residue 2 s |L| <= s (|ln| + 2 |arctans|)."""
        if bits not in self.fixed:
            self.fixed[bits] = Fixed(bits)
        fixed, total, error = self.fixed[bits], (0, 0), 0
        for z in roots:
            a, b = (t.numerator << self.B) - t.denominator * z.x, t.denominator * z.y  # t - x, y, scaled
            far, near = a * a + b * b, z.x ** 2 + z.y ** 2
            logarithm = fixed.ln(far, near * t.denominator ** 2)
            arctans = plus(fixed.arctan(a, b), fixed.arctan(z.x, z.y))
            total = plus(total, plus(times(logarithm, z.re), times(arctans, -2 * z.im)))
            to_t = root_down(far << 2 * FINE) - (z.r * t.denominator << FINE)
            to_0 = root_down(near << 2 * FINE) - (z.r << FINE)
            require(to_t > 0 and to_0 > 0, "the discs are too large")
            worth = 2 * (root_up(z.re ** 2 + z.im ** 2) + z.s) * z.r * abs(t.numerator)
            error += -(-(worth << (2 * FINE + bits + self.B)) // (to_t * to_0))  # rounded up
            error += z.s * (max(map(abs, logarithm)) + 2 * max(map(abs, arctans)))
        end, start = (fixed.arctan(slope.numerator, slope.denominator) for slope in slopes)
        arg = plus(plus(end, times(start, -1)), times(fixed.pi, -index))
        return plus(total, times(arg, 1 << self.B)), error

    # The decisions: x, y, z stand for A i A*, and each law is that of the page's table.

    def regular(self, decision):
        K = common(self.A)
        check_points(self.f * K * K, decision.cusps, "cusps")
        require(decision.answer == (not decision.cusps), "cusps and answer contradict each other")

    def inflections(self, decision):
        K = common(self.A)
        check_points(common(bend_of([a.over(K) for a in self.A])), decision.points, "points")
        require(decision.answer == bool(decision.points), "points and answer contradict each other")

    def line(self, decision):
        if not decision.answer:
            require(rank(self.xyz) >= 2, "no two of x, y, z are independent")
            return
        require(any(decision.direction), "the direction is 0")
        for (a, k), (b, l) in combinations(zip(self.xyz, decision.direction), 2):
            require(a * l == b * k, "x, y, z are not multiples of the direction")

    def dot(self, vector):
        """vector . (x, y, z)"""
        return reduce(Poly.__add__, (a * k for a, k in zip(self.xyz, vector)))

    def planar(self, decision):
        if not decision.answer:
            require(rank(self.xyz) == 3, "x, y, z are dependent")
            return
        require(any(decision.normal), "the normal is 0")
        require(not self.dot(decision.normal), "the normal is not orthogonal to (x, y, z)")

    def helical(self, decision):
        if not decision.answer:
            require(rank(self.xyz) < 3 or rank(self.xyz + [self.sigma]) == 4, "sigma depends on x, y, z")
            return
        require(rank(self.xyz) == 3, "x, y, z are dependent")
        require(any(decision.axis), "the axis is 0")
        along, square = self.dot(decision.axis), decision.cos_squared * sum(a * a for a in decision.axis)
        require(along * along == self.sigma * self.sigma * square, "the angle to the axis is another")

    def double_ph(self, decision):
        square = norm(self.g) * 4
        if decision.answer:
            square_wanted = decision.omega * decision.omega * decision.constant
            require(square == square_wanted, "4|g|^2 is not constant omega^2")
            return
        # If a = constant s^2, a(k) times the leading coefficient is a square for each k. (If it is one for
        # all k, then a is a constant times a square, so this search finds what there is.)
        a = square.c
        values = (a[-1] * scaled_value(a, Fraction(k)) for k in range(1000 if a else 0))
        require(any(x < 0 or isqrt(x) ** 2 != x for x in values), "4|g|^2 seems a constant times a square")

    def primitive(self, decision):
        require(decision.content, "the content is 0")
        parts = [a.over(decision.content) for a in self.hodograph]
        require(common(parts).is_constant(), "the content is not the greatest common divisor")
        require(decision.answer == decision.content.is_constant(), "content and answer contradict each other")

    def erf_is_rmf(self, decision):
        require(decision.answer == (not self.h), "h is %s" % ("not 0" if self.h else "0"))

    def rrmf(self, decision):
        """False: the roots being simple, poles of theta' of order 2 or more come from R alone; where a disc
        meets none of another log, the residue at its root is that of its log. But 2 arg w has only residues
        in iZ, at poles of order 1, and no polynomial part."""
        if decision.answer:
            require(any(decision.w), "w is 0")
            is_angle = spin(decision.w) * self.sigma == self.h * norm(decision.w) * -1
            require(is_angle, "2 arg w is not the angle")
            return
        self.rest_on(self.needed)
        if self.P.derivative() * self.Q != self.P * self.Q.derivative():
            return
        one = 1 << self.B
        for log in self.logs:
            others = [z for other in self.logs if other is not log for z in other.roots]
            for z in log.roots:
                above = z.im % one  # the height of the centre above the next lower point of iZ
                off = z.re ** 2 + min(above, one - above) ** 2 > z.s ** 2
                if off and all(apart(z, w) for w in others):
                    return
        raise NotProved("the rational part is constant, and no residue is proved to be outside iZ")

    def erf_monotone(self, decision):
        """(H/E)' has the numerator (H'E - HE')/gcd(E, E') in lowest terms, if H/E is so: at a zero of E of
        order k the order of H'E - HE' is k - 1."""
        self.rest_on(["rate"])
        check_points(self.N, decision.zeros_of_h, "zeros_of_h")
        turns = any(point.order % 2 and is_inside(point) for point in decision.zeros_of_h)
        require(decision.answer == (not turns), "zeros_of_h and answer contradict each other")
        E = self.f * self.sigma * self.sigma
        K = common([self.h, E])
        H, E = self.h.over(K), E.over(K)
        P = H.derivative() * E - H * E.derivative()
        check_points(P.over(common([E, E.derivative()])), decision.extrema, "extrema", odd_only=True)


def check(name, show_name, quiet):
    """Checks one file and prints what is proved; returns the exit status."""
    try:
        if name == "-":
            data = sys.stdin.buffer.read()
        else:
            with open(name, "rb") as file:
                data = file.read()
        certificate = read_certificate(data)
    except OSError as error:
        print("check_certificate.py: %s: %s" % (name, error.strerror), file=sys.stderr)
        return 2
    except Malformed as error:
        print("check_certificate.py: %s:%s" % (name, error), file=sys.stderr)
        return 2
    lines = Proof(certificate).run()
    if show_name:
        print("%s:" % name)
    for is_proved, line in lines:
        if not (quiet and is_proved):
            print(line)
    failures = sum(not is_proved for is_proved, _ in lines)
    print("%d of %d statements are not proved" % (failures, len(lines)) if failures else
          "all %d statements are proved" % len(lines))
    return 1 if failures else 0


def main():
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)
    parser = argparse.ArgumentParser(description="Checks certificates of rotation-minimizing frames.")
    parser.add_argument("files", nargs="+", metavar="CERT", help='a certificate, "-" for standard input')
    parser.add_argument("-q", "--quiet", action="store_true",
                        help="print only what is not proved, and the last line")
    options = parser.parse_args()
    sys.stdout.reconfigure(errors="backslashreplace")
    sys.exit(max(check(name, len(options.files) > 1, options.quiet) for name in options.files))


if __name__ == "__main__":
    main()
