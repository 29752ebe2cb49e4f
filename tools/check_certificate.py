#!/usr/bin/env python3
"""Proves or refuses the claims of a certificate (docs/certificate.md), with integers alone.

Everything is computed again from the curve. Identities of rational functions are checked as such; roots and
residues are in discs by inequalities between integers; logarithms and arctangents come from power series in
integers with proved remainders; decisions rest on gcds, ranks and Descartes' rule of signs. There is no
floating point, and every rounding is in the direction that makes an accepted inequality true. The letters are
those of the page. Exit status: 0 all is proved, 1 something is not, 2 this is no certificate, or one beyond
the limits of the page.
"""
import argparse
import hashlib
import json
import re
import sys
from fractions import Fraction
from functools import cache, cached_property, reduce
from itertools import accumulate, combinations, combinations_with_replacement, takewhile
from math import comb, gcd, isqrt
from operator import mul
from types import SimpleNamespace

MAX_EXPONENT, MAX_COUNT, MAX_LENGTH = 10000, 1000000, 100000  # of decimals, of counts, of the text of a number
MAX_DEGREE, MAX_WORK, FULL_SIZE = 1001, 2000000000, 100000  # of the curve; as the page says; bytes
MAX_ZEROS = 20000000000  # the work of counting zeros, ten of it about a nanosecond
MAX_SYMMETRY = 4000000000  # the work of sums of trigonometric functions, in units of the page
MAX_PARTS, MAX_HALVINGS = 2000000000, 40  # the work of telling crossings, in nanoseconds; of a segment
PRIMES = [(1 << 127) - 1]  # for gcds; the next ones are found as they are needed
TAKEN = SimpleNamespace(volume=0, zeros=0)  # of this file: what was read, and the work of counting zeros
MAX_FORMULA, MAX_DEPTH, MAX_DIGITS, MAX_POWER, MAX_FOLDED, MAX_PIECES = 10000, 60, 5000, 1000, 4096, 1 << 30  # of
# formulas: characters, parentheses, digits of a number, exponents, bits of numbers that make a number; so many pieces fit
ROOT_BITS, FINE = 256, 64  # square roots keep 128 bits; distances get 64 bits more than the grid


class Malformed(Exception):
    """This is no certificate: where, and what is wrong."""


class NotProved(Exception):
    """The statement at hand is not proved, and why."""


def require(condition, why):
    """Every step of every proof goes through here."""
    if not condition:
        raise NotProved(why)


# Polynomials. Lists of integers are coefficients from the constant term up, the last not 0, [] for 0.

def stripped(a):
    """Without the zeros at the end."""
    n = len(a)
    while n and a[n - 1] == 0:
        n -= 1
    return a[:n]


def derived(a):
    """The derivative."""
    return [k * x for k, x in enumerate(a)][1:]


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


class Poly:
    """The polynomial sum c[k] t^k / d over Q, d > 0, in lowest terms: equality is equality of c and d."""

    def __init__(self, c, d=1):
        c = stripped(c)
        g = reduce(gcd, c, d) if d > 1 else 1
        self.c, self.d = ([x // g for x in c], d // g) if g > 1 else (c, d)

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
            for i, y in enumerate(b.c if x else (), k):
                c[i] += x * y
        return Poly(c, self.d * b.d)

    def __divmod__(self, b):
        """(q, r) with self = q b + r, deg r < deg b. In the loop m self = q b.c + a, m > 0, in integers."""
        a, m, q = self.c, self.d, [0] * len(self.c)
        while len(a) >= len(b.c):
            g, low = gcd(a[-1], b.c[-1]) * (1 if b.c[-1] > 0 else -1), len(a) - len(b.c)
            f, k = b.c[-1] // g, a[-1] // g
            m, q, a = m * f, [f * x for x in q], [f * x for x in a]
            q[low] = k
            a = stripped(a[:low] + [x - k * y for x, y in zip(a[low:], b.c)])
        return Poly(q, m) * b.d, Poly(a, m)

    def __eq__(self, b):
        return (self.c, self.d) == (b.c, b.d)

    def __bool__(self):
        return bool(self.c)

    def __call__(self, t):
        value, power = 0, 1
        for x in reversed(self.c):
            value, power = value * t.numerator + x * power, power * t.denominator
        return Fraction(value * t.denominator, self.d * power)

    def sign(self, t):
        """-1, 0 or 1: the sign of self(t), without a fraction."""
        value, power = 0, 1
        for x in reversed(self.c):
            value, power = value * t.numerator + x * power, power * t.denominator
        return (value > 0) - (value < 0)

    def bits(self):
        """Of the longest of the coefficients and the denominator."""
        return max(map(int.bit_length, self.c + [self.d]))

    def derivative(self):
        return Poly(derived(self.c), self.d)

    def primitive(self):
        """Coprime integers, by a positive factor, so that no sign of a value changes."""
        return Poly(self.c, reduce(gcd, self.c, 0) or 1)

    def is_constant(self):
        return len(self.c) <= 1

    def over(self, b):
        """self/b where b, not 0, is known or required to divide it."""
        q, r = divmod(self, b)
        require(not r, "a polynomial is not divisible by another")
        return q

    def zeros(self, low, high):
        """How many zeros a squarefree polynomial has in [low, high], inside by Descartes' rule: those
        of a(t) in (0, 1) are the positive ones of (1+s)^n a(1/(1+s)); with 0 or 1 sign changes their number
        is just that. Else the interval is halved. For simple zeros this ends, by Vincent's theorem, unless
        they are so close to each other that it takes more than MAX_ZEROS."""
        if low >= high:
            return int(low == high and self.sign(low) == 0)
        n, den = len(self.c) - 1, low.denominator * high.denominator
        number = (self.sign(low) == 0) + (self.sign(high) == 0)
        a = translated([x * den ** (n - k) for k, x in enumerate(self.c)], int(low * den))
        todo = [[x * int((high - low) * den) ** k for k, x in enumerate(a)]]  # low is at 0 and high at 1
        while todo:
            a = todo.pop()
            TAKEN.zeros += (n + 4) ** 2 * (max(map(int.bit_length, a)) + 1000)
            require(TAKEN.zeros <= MAX_ZEROS, "zeros of a polynomial are too close to each other to be counted")
            changes = sign_changes(translated(a[::-1], 1))
            number += changes == 1
            if changes > 1:
                left = [x << (n - k) for k, x in enumerate(a)]
                right = translated(left, 1)
                number += right[0] == 0
                todo += [left, right]
        return number


def are_coprime_modulo(a, b, p):
    """Whether Euclid's algorithm modulo p ends with a constant, for lists whose last coefficients p does not
    divide. Then they are coprime over Q, even if p is no prime: b[-1] has an inverse, so the last coefficient
    of a common factor over Z has one; so that keeps its degree modulo p, where it divides the constant."""
    a, b = [x % p for x in a], [x % p for x in b]
    while b:
        require(gcd(b[-1], p) == 1, "the modulus is no prime")
        inverse = pow(b[-1], -1, p)
        b = [x * inverse % p for x in b]
        while len(a) >= len(b):
            k, low = a[-1], len(a) - len(b)
            a = a[:low] + [(x - k * y) % p for x, y in zip(a[low:-1], b)]
        a, b = b, stripped(a)
    return len(a) == 1


def primes():
    """Odd numbers from 2^127 - 1 downwards, all but surely primes: nothing rests on that."""
    yield from PRIMES
    while True:
        n = PRIMES[-1] - 2
        while pow(3, n - 1, n) != 1:
            n -= 2
        PRIMES.append(n)
        yield n


def gcd_modulo(a, b, p):
    """The monic gcd modulo the prime p; None where p turns out to be none."""
    a, b = stripped([x % p for x in a]), stripped([x % p for x in b])
    while b:
        if gcd(b[-1], p) > 1:
            return None
        inverse = pow(b[-1], -1, p)
        b = [x * inverse % p for x in b]
        while len(a) >= len(b):
            k, low = a[-1], len(a) - len(b)
            a = stripped(a[:low] + [(x - k * y) % p for x, y in zip(a[low:-1], b)])
        a, b = b, a
    return a


def common_of_two(a, b):
    """The primitive gcd of primitive a, b != 0: from gcds modulo primes by the Chinese remainder theorem, as
    soon as what comes out divides both. A gcd modulo p, which divides neither leading coefficient, has no lower
    degree than the true one; so a common factor of that degree is it."""
    lead, found, modulus, last = gcd(a.c[-1], b.c[-1]), [], 1, Poly([])
    for p in primes():
        g = gcd_modulo(a.c, b.c, p) if a.c[-1] % p and b.c[-1] % p else None
        if g is None or found and len(g) > len(found):
            continue
        if len(g) == 1:
            return Poly([1])
        g = [x * lead % p for x in g]
        if found and len(g) == len(found):
            k = pow(modulus, -1, p)
            found = [x + modulus * ((y - x) * k % p) for x, y in zip(found, g)]
            modulus *= p
        else:
            found, modulus = g, p
        candidate = Poly([x - modulus if 2 * x > modulus else x for x in found]).primitive()
        if candidate == last and not divmod(a, candidate)[1] and not divmod(b, candidate)[1]:
            return candidate
        last = candidate


def common(*polys):
    """The primitive gcd, 0 if all are 0."""
    a = Poly([])
    for b in polys:
        b = b.primitive()
        a = common_of_two(a, b) if a and b else a or b
    return a


def cross(a, b):
    """a x b"""
    return [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]


def dot(a, b):
    """a . b"""
    return reduce(lambda x, y: x + y, (x * y for x, y in zip(a, b)))


def size(a):
    """The sum of the absolute values of the coefficients, no less than |a(z)| for |z| <= 1."""
    return Fraction(sum(map(abs, a.c)), a.d)


def on_piece(a, m, h):
    """a(m + hz)"""
    n, den = len(a.c) - 1, m.denominator * h.denominator
    c = translated([x * den ** (n - k) for k, x in enumerate(a.c)], int(m * den))
    return Poly([x * int(h * den) ** k for k, x in enumerate(c)], a.d * den ** max(n, 0))


def sign_on_piece(a, m, h):
    """1 or -1 where a >= 0 or a <= 0 from m - h to m + h by its Bernstein coefficients, else 0: those of a(x) in [0, 1]
    are, but for positive factors, the coefficients of (1+s)^n a(1/(1+s))."""
    c = translated(on_piece(a, m - h, 2 * h).c[::-1], 1)
    return 1 if min(c) >= 0 else -1 if max(c) <= 0 else 0


def sign_before_one(a):
    """The sign of a(t) for t < 1 next to 1."""
    return next(x if k % 2 == 0 else -x for k, x in enumerate(translated(a.c, 1)) if x)


def rank(polys):
    """The dimension of the span: one of the highest degree n, and all others without their t^n."""
    polys = sorted(filter(None, polys), key=lambda a: len(a.c))
    if not polys:
        return 0
    top = polys.pop()
    return 1 + rank([divmod(a, top)[1] for a in polys])


def norm(a):
    """|a|^2 of a pair a, the real and the imaginary part."""
    return a[0] * a[0] + a[1] * a[1]


def spin(a):
    """Im(a' conj a)."""
    return a[1].derivative() * a[0] - a[0].derivative() * a[1]


def invariants_of(A):
    """sigma, h and g."""
    u, v, p, q = A
    du, dv, dp, dq = (a.derivative() for a in A)
    g = u * dq - v * dp - du * q + dv * p, u * dp + v * dq - du * p - dv * q
    return u * u + v * v + p * p + q * q, u * dv - du * v - p * dq + dp * q, g


def root(n, up):
    """At most, or if up at least, the square root of n: n < (m + 1) 4^e and [sqrt m] + 1 >= sqrt(m + 1)."""
    e = max(0, n.bit_length() - ROOT_BITS) // 2
    m = isqrt(n >> 2 * e)
    return (m + (up and m * m << 2 * e < n)) << e


def at_grid_point(a, x, y, B):
    """2^(B n) a(z) for z = (x + iy)/2^B and a list a of n + 1 integers, exactly: (real, imaginary part)."""
    re, im, shift = 0, 0, 0
    for c in reversed(a):
        re, im = re * x - im * y + (c << shift), re * y + im * x
        shift += B
    return re, im


def apart(z, w):
    """Whether two closed discs do not meet."""
    return norm((z.x - w.x, z.y - w.y)) > (z.r + w.r) ** 2


class Fixed:
    """ln and arctan with P >= 64 bits after the point: n stands for n/2^P, and so do the errors."""

    def __init__(self, P):
        self.P = P
        self.ln_table = {16: 0}  # ln(j/16) within 2P(j - 16), since ln(j/(j-1)) = 2 artanh(1/(2j-1))
        for j in range(17, 33):
            self.ln_table[j] = self.ln_table[j - 1] + 2 * self.series(1, 2 * j - 1, 1)
        self.arctan_table = [0]  # arctan(j/8) within Pj, since tan(a - b) = (tan a - tan b)/(1 + tan a tan b)
        for j in range(1, 9):
            self.arctan_table.append(self.arctan_table[-1] + self.series(8, 64 + j * (j - 1), -1))

    def series(self, a, b, sign):
        """The sum of sign^k e^(2k+1)/(2k+1), 0 <= e = a/b <= 1/8: artanh (sign 1) or arctan (-1), within P.
        `power` is below e^(2k+1) 2^P by less than 2: less than 2/64 + 1/8 comes from the factors, less than 1
        from the last rounding. So each term is wrong by less than 3, and when `power` is 0 the terms left out
        sum to less than 2/(1 - 1/64) < 3. After k < P/6 + 1 terms the error is below 3k + 3 < P."""
        power, square = (a << self.P) // b, (a * a << self.P) // (b * b)
        total, k = 0, 0
        while power:
            total += sign ** k * (power // (2 * k + 1))
            power = power * square >> self.P
            k += 1
        return total

    def ln(self, a, b):
        """(n, error), ln(a/b) being within error of n, for a, b > 0: a/b = 2^k m with 1 <= m < 2, j = [16m],
        ln(16m/j) = 2 artanh((16m - j)/(16m + j)). The error is 32P|k| + 2P(j - 16) + 2P, with j < 32."""
        k = a.bit_length() - b.bit_length()
        a, b = (a, b << k) if k >= 0 else (a << -k, b)
        if a < b:
            a, k = 2 * a, k - 1
        j = 16 * a // b
        n = k * self.ln_table[32] + self.ln_table[j] + 2 * self.series(16 * a - j * b, 16 * a + j * b, 1)
        return n, 32 * self.P * (abs(k) + 1)

    def arctan(self, a, b):
        """arctan(a/b) within 25P, b > 0. For v = a/b in [0, 1] it is arctan(j/8) + arctan((8v - j)/(8 + jv)),
        j = [8v], within 9P; above 1 it is 2 arctan(1) - arctan(b/a)."""
        if a < 0:
            return -self.arctan(-a, b)
        if a > b:
            return 2 * self.arctan_table[8] - self.arctan(b, a)
        j = 8 * a // b
        return self.arctan_table[j] + self.series(8 * a - j * b, 8 * b + j * a, -1)


def turn_at_corner(v, a, b):
    """How far v x b is behind what the least rotation that takes the direction of a to that of b makes of v x a: bounds, as
    a function of the bits. The axis a x b is at rest. From it to v x b, about b, is the argument of p + |b| d i, and to v x
    a, about a, that of q + |a| d i, with d = det(v, a, b): both are above the real axis, or both below it."""
    d, va, vb = dot(v, cross(a, b)), dot(v, a), dot(v, b)
    p, q = va * dot(b, b) - vb * dot(a, b), va * dot(a, b) - vb * dot(a, a)

    def turn(bits):
        fixed = Fixed(bits)
        if d:
            slopes = [(over_root(x / d, dot(c, c), bits), sign) for x, c, sign in ((q, a, 1), (p, b, -1))]
        else:
            is_opposite = dot(cross(v, a), cross(v, b)) < 0
            slopes = [((1, 1), 4)] if is_opposite else []
        low, high = 0, 0
        for (least, most), sign in slopes:
            ends = sorted(sign * fixed.arctan(x.numerator, x.denominator) for x in (least, most))
            off = 25 * bits * abs(sign) if least or most else 0
            low, high = low + ends[0] - off, high + ends[1] + off
        return Fraction(low, 1 << bits), Fraction(high, 1 << bits)
    return turn


def over_root(x, square, bits):
    """Bounds of x/sqrt(square), relative to it within 2^-bits: [sqrt n] <= sqrt n < [sqrt n] + 1."""
    unit = 1 << bits + square.denominator.bit_length()
    below = isqrt(square.numerator * unit * unit // square.denominator)
    return sorted((x * unit / below, x * unit / (below + 1)))


def cos_sin(x, P):
    """(n, m, error): cos x and sin x are within error of n and m, all in units of 2^-P. The angle is halved until
    it is below 1/2, of which Taylor's sums end when a term is 0. A term has half of the error of the one before
    and less than 3 more, so that none has 6, and there are fewer than P. With cos 2y = 2 cos^2 y - 1 and sin 2y
    = 2 sin y cos y an error e becomes at most 4e + 2e^2, and one rounding."""
    halvings = 1 + (abs(x.numerator) // x.denominator).bit_length()
    y = (x.numerator << P) // (x.denominator << halvings)
    sums, term, k = [0, 0, 0, 0], 1 << P, 0
    while term not in (0, -1):
        sums[k % 4] += term
        k += 1
        term = (term * y >> P) // k
    n, m, error = sums[0] - sums[2], sums[1] - sums[3], 6 * P + 12
    for _ in range(halvings):
        n, m = (n * n >> (P - 1)) - (1 << P), n * m >> (P - 1)
        error = 4 * error + 2 + (error * error >> (P - 1))
    return n, m, error


def require_double(entry, low, high, what):
    """The double next to the decimal number is that next to each number in [low, high], ties to even. With u = 2^e,
    the unit in its last place, it is mu, m < 2^53; where m is 2^52 the next one below is half as far away."""
    size, e = abs(entry), -1074
    if size:
        e = max(e, size.numerator.bit_length() - size.denominator.bit_length() - 53)
        while round(size / Fraction(2) ** e) >= 1 << 53:
            e += 1
    u = Fraction(2) ** e
    m = round(entry / u)
    below, above = (u / 4 if m == side << 52 and e > -1074 else u / 2 for side in (1, -1))
    low, high = low - m * u + below, high - m * u - above
    is_next = (low > 0 or low == 0 and m % 2 == 0) and (high < 0 or high == 0 and m % 2 == 0)
    require(is_next, "%s is not proved to be the double next to the exact number" % what)


# Formulas: steps (operation, left, right), each the number of an earlier step, a number where that is one, or an exponent.

FUNCTIONS = ("sin", "cos", "exp", "log", "sqrt", "atan")
LETTER = "A-Za-z_\u00c0-\u00d6\u00d8-\u00f6\u00f8-\u024f\u0370-\u03ff"  # Latin and Greek ones
TOKEN = re.compile(r"[ \t\r\n]*(?:([0-9]+(?:\.[0-9]*)?(?:[eE][-+]?[0-9]+)?|\.[0-9]+(?:[eE][-+]?[0-9]+)?)|([%s][%s0-9]*)|(\*\*|[-+*/^()\u2212\u00b7\u22c5\u00d7\u00f7])"
                   r"|([\u207b\u2070\u00b9\u00b2\u00b3\u2074-\u2079]+))" % (LETTER, LETTER))
PLAIN = str.maketrans("\u2212\u00b7\u22c5\u00d7\u00f7", "-***/")
RAISED = str.maketrans("\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079", "-0123456789")


class Formula:
    """A function of one variable: its steps, and for each its rational number, where it is one by numbers alone."""

    def __init__(self):
        self.steps, self.numbers, self.known = [], [], {}

    def step(self, *step):
        """The number of the step, a new one where there is none."""
        step += (None,) * (3 - len(step))
        if step not in self.known:
            self.known[step] = len(self.steps)
            self.steps.append(step)
            self.numbers.append(self.number_of(*step))
        return self.known[step]

    def number_of(self, operation, left, right):
        if operation == "number":
            return left
        a, b = (self.numbers[k] if isinstance(k, int) else None for k in (left, right))
        if a is None:
            return None
        if operation == "power":
            is_short = right.denominator == 1 and right >= 0 and right * bits_of(a) <= MAX_FOLDED
            return a ** int(right) if is_short else None
        if b is None or operation not in "+*/" or bits_of(a, b) > MAX_FOLDED:
            return None
        return a + b if operation == "+" else a * b if operation == "*" else a / b if b else None

    def negative(self, x):
        return self.step("*", self.step("number", Fraction(-1)), x)

    def texts(self):
        """What each step is written as, and how tightly its outermost operation binds: 1 a sum, 2 a product, 3 a power."""
        out = []

        def within(part, rank):
            text, own = part
            return "(%s)" % text if own < rank else text

        def number(x):
            return str(x), 1 if x < 0 else 2 if x.denominator > 1 else 4
        for operation, left, right in self.steps:
            if operation == "number":
                out.append(number(left))
            elif operation in ("pi", "s"):
                out.append((operation, 4))
            elif operation == "+":
                text = out[right][0]
                out.append((out[left][0] + (" - " + text[1:] if text[0] == "-" else " + " + text), 1))
            elif operation == "*" and out[left][0] == "-1":
                out.append(("-" + within(out[right], 3), 1))
            elif operation in "*/":
                out.append((within(out[left], 2) + operation + within(out[right], 3), 2))
            elif operation == "power":
                out.append((within(out[left], 4) + "^" + within(number(right), 4), 3))
            else:
                out.append(("%s(%s)" % (operation, out[left][0]), 4))
        return [text for text, _ in out]


class FormulaReader:
    """A text as steps of f: sums of products of signed powers. An exponent is a number, or f^g is exp(g log f)."""

    def __init__(self, text, f, place, variable=None):
        self.f, self.place, self.text, self.variable = f, place, text, variable
        self.tokens, at, self.depth = [], 0, 0
        while text[at:].strip(" \t\r\n"):
            match = TOKEN.match(text, at) or fail(place, "this is not understood", text[at:])
            number, name, sign, raised = match.groups()
            self.tokens.append((number, name, sign and sign.translate(PLAIN), raised))
            at = match.end()
        self.tokens.reverse()

    def take(self, *signs):
        return self.tokens.pop()[2] if self.tokens and self.tokens[-1][2] in signs else None

    def read(self):
        found = self.sum()
        return found if not self.tokens else fail(self.place, "this is no formula", self.text)

    def sum(self):
        a = self.product()
        while sign := self.take("+", "-"):
            b = self.product()
            a = self.f.step("+", a, self.f.negative(b) if sign == "-" else b)
        return a

    def product(self):
        a = self.signed()
        while sign := self.take("*", "/"):
            b = self.signed()
            if sign == "/" and self.f.numbers[b] == 0:
                fail(self.place, "a division by 0", self.text)
            a = self.f.step(sign, a, b)
        return a

    def signed(self, is_exponent=False):
        signs = ""
        while sign := self.take("+", "-"):
            signs += sign.replace("+", "")
        a = self.power(is_exponent and not signs)
        for _ in signs:
            a = self.f.negative(a)
        return a

    def power(self, is_exponent=False):
        """An exponent may be raised digits; of two, one after the other, it is not clear what they mean."""
        (a, is_e), f = self.whole(), self.f
        if self.tokens and self.tokens[-1][3]:
            digits = self.tokens.pop()[3].translate(RAISED)
            if is_exponent or self.take("^", "**") or self.tokens and self.tokens[-1][3] or not re.fullmatch("-?[0-9]+", digits):
                fail(self.place, "this exponent is not understood", self.text)
            b, k = None, Fraction(digits)
        elif self.take("^", "**"):
            self.enter()
            b = self.signed(True)
            self.depth -= 1
            k = f.numbers[b]
        else:
            return a
        if k is None:
            return f.step("exp", f.step("*", b, f.step("number", Fraction(1)) if is_e else f.step("log", a)))
        if max(abs(k.numerator), k.denominator) > MAX_COUNT:
            fail(self.place, "an exponent is too large", self.text)
        return f.step("power", a, k)

    def enter(self):
        self.depth += 1
        if self.depth > MAX_DEPTH:
            fail(self.place, "parentheses and exponents are more than %d deep" % MAX_DEPTH, self.text)

    def whole(self):
        """A number, a name, or what is in parentheses; and whether it is e."""
        number, name, sign, _ = self.tokens.pop() if self.tokens else (None,) * 4
        f = self.f
        if number:
            exponent = re.split("[eE]", number + "e0")[1]
            if len(exponent) > 5 or abs(int(exponent)) > MAX_DIGITS:
                fail(self.place, "exponents of numbers are limited to %d" % MAX_DIGITS, number)
            return f.step("number", Fraction(number)), False
        if name in ("pi", "\u03c0"):
            return f.step("pi"), False
        if name == "e" and self.variable != "e":
            return f.step("exp", f.step("number", Fraction(1))), True
        if sign == "(" or name in MEANINGS and self.take("("):
            self.enter()
            a = self.sum()
            self.depth -= 1
            if not self.take(")"):
                fail(self.place, "a parenthesis is not closed", self.text)
            return MEANINGS[name](f, a) if name else a, False
        if name and name not in MEANINGS and self.variable in (None, name):
            self.variable = name
            return f.step("s"), False
        return fail(self.place, "this is no formula", self.text)


def quotient_of(above, below):
    return lambda f, a: f.step("/", above(f, a), below(f, a))


def named(name):
    return lambda f, a: f.step(name, a)


def whole_number(n):
    return lambda f, a: f.step("number", Fraction(n))


def of_exp(sign):
    """exp a + exp -a or exp a - exp -a."""
    def read(f, a):
        up, down = f.step("exp", a), f.step("exp", f.negative(a))
        return f.step("+", up, down if sign > 0 else f.negative(down))
    return read


def asin(f, a):
    """atan(a/sqrt(1 - a^2))"""
    rest = f.step("+", f.step("number", Fraction(1)), f.negative(f.step("power", a, Fraction(2))))
    return f.step("atan", f.step("/", a, f.step("sqrt", rest)))


def acos(f, a):
    half = f.step("*", f.step("number", Fraction(1, 2)), f.step("pi"))
    return f.step("+", half, f.negative(asin(f, a)))


MEANINGS = {name: named(name) for name in FUNCTIONS}
MEANINGS.update(ln=named("log"), arctan=named("atan"), tan=quotient_of(named("sin"), named("cos")), cot=quotient_of(named("cos"), named("sin")),
                sec=quotient_of(whole_number(1), named("cos")), csc=quotient_of(whole_number(1), named("sin")),
                sinh=quotient_of(of_exp(-1), whole_number(2)), cosh=quotient_of(of_exp(1), whole_number(2)),
                tanh=quotient_of(of_exp(-1), of_exp(1)), asin=asin, acos=acos)


def canonical(text, place):
    """The text that is written of what is read of it, until it does not change any more."""
    for _ in range(6):
        reader = FormulaReader(text, Formula(), place, "s")
        step = reader.read()
        if reader.f.texts()[step] == text:
            return text
        text = reader.f.texts()[step]
    return fail(place, "this formula has no one form", text)


# Taylor models: a pair (P, r) of integers P[k], at most n, the last not 0, and r says that |f(z) - sum P[k] z^k/2^B| <= r/2^B for
# -1 <= z <= 1. Where a value is 0 exactly, it is ([], 0).

def lengths(P):
    """No less than |P(z)|."""
    return sum(map(abs, P))


def convolved(P, Q):
    """P Q, from the product of two long integers, in which each coefficient has its own bytes, and half of their range added."""
    if min(len(P), len(Q)) < 2:
        return [x * y for x in P for y in Q]
    width = (max(map(abs, P)).bit_length() + max(map(abs, Q)).bit_length() + min(len(P), len(Q)).bit_length()) // 8 + 1
    half, n = 1 << 8 * width - 1, len(P) + len(Q) - 1
    halves = half.to_bytes(width, "little") * n

    def packed(A):
        data = b"".join([(x + half).to_bytes(width, "little") for x in A])
        return int.from_bytes(data, "little") - int.from_bytes(halves[:len(data)], "little")
    p = packed(P)
    data = (p * (p if Q is P else packed(Q)) + int.from_bytes(halves, "little")).to_bytes(n * width, "little")
    return [int.from_bytes(data[k:k + width], "little") - half for k in range(0, n * width, width)]


def summed(P, Q, sign=1):
    """P + Q, or P - Q."""
    n = max(len(P), len(Q))
    return stripped([x + sign * y for x, y in zip(P + [0] * (n - len(P)), Q + [0] * (n - len(Q)))])


def floor_of(bounds, B):
    """[x 2^B] of an x that is no multiple of 2^-B, from bounds(P) = (a, b), a <= x 2^P <= b."""
    P = B + 64
    while True:
        low, high = (x >> P - B for x in bounds(P))
        if low == high:
            return low
        P += P


def exp_bounds(x, P):
    """Of exp(x): with |y| = |x|/2^h < 1/2 Taylor's terms, each half of the one before, are off by less than 6, and fewer than P."""
    h = 1 + (abs(x.numerator) // x.denominator).bit_length()
    y, total, term, k = (x.numerator << P) // (x.denominator << h), 0, 1 << P, 0
    while term not in (0, -1):
        total += term
        k += 1
        term = (term * y >> P) // k
    low, high = total - 6 * P - 12, total + 6 * P + 12
    for _ in range(h):
        low, high = low * low >> P, (high * high >> P) + 1
    return low, high


@cache
def fixed_point(P):
    return Fixed(P)


def logarithm_bounds(x, P):
    n, off = fixed_point(P).ln(x.numerator, x.denominator)
    return n - off, n + off


def arctan_bounds(x, P):
    n = fixed_point(P).arctan(x.numerator, x.denominator)
    return n - 25 * P, n + 25 * P


def pi_bounds(P):
    n = 4 * fixed_point(P).arctan_table[8]
    return n - 100 * P, n + 100 * P


def cos_sin_bounds(x, P, side):
    found = cos_sin(x, P)
    return found[side] - found[2], found[side] + found[2]


class Models:
    """Arithmetic of Taylor models with at most n integers in units of 2^-B. Each is no more than 2^1000."""

    def __init__(self, n, B):
        self.n, self.B = n, B

    def checked(self, P, r):
        require(lengths(P) + r <= 1 << self.B + 1000, "a value is greater than 2^1000")
        return stripped(P), r

    def number(self, x):
        n = (x.numerator << self.B) // x.denominator
        return self.checked([n], 0 if n * x.denominator == x.numerator << self.B else 1)

    def plus(self, a, b):
        return summed(a[0], b[0]), a[1] + b[1]

    def scaled(self, a, x):
        """x a for a rational number x."""
        P = [c * x.numerator // x.denominator for c in a[0]]
        return self.checked(P, -(-a[1] * abs(x.numerator) // x.denominator) + (len(P) if x.denominator > 1 else 0))

    def dot(self, a, b):
        return reduce(self.plus, map(self.times, a, b))

    def minus(self, a, b):
        return self.plus(a, self.scaled(b, Fraction(-1)))

    def cross(self, a, b):
        return [self.minus(self.times(a[i], b[j]), self.times(a[j], b[i])) for i, j in ((1, 2), (2, 0), (0, 1))]

    def times(self, a, b):
        """What is beyond n, and what the radii make of the other factor, is in the radius, and less than 1 for each rounding."""
        (P, r), (Q, s) = a, b
        if not P and not r or not Q and not s:
            return [], 0
        R = convolved(P, Q)
        kept = [x >> self.B for x in R[:self.n]]
        off = lengths(R[self.n:]) + lengths(P) * s + r * (lengths(Q) + s)
        return self.checked(kept, len(kept) + 1 + (off >> self.B))

    def least(self, a, what):
        """Twice P(0) less ||P|| and r: no more than the values, if it is positive."""
        m = (2 * a[0][0] if a[0] else 0) - lengths(a[0]) - a[1]
        require(m > 0, what)
        return m

    def series(self, P, first, term):
        """The integers first, term(1, so far), ..., n of them; of a constant the first alone."""
        out = [first]
        for k in range(1, self.n if len(P) > 1 else 1):
            out.append(term(k, out))
        return out

    def inverse(self, a):
        """I with |I - 1/f| = |If - 1|/|f|, If - 1 = (IP - 1) + I(f - P)."""
        P, r = a
        if P and P[0] < 0:
            I, off = self.inverse(([-x for x in P], r))
            return [-x for x in I], off
        m, one = self.least(a, "a divisor may be 0"), 1 << 2 * self.B
        I = self.series(P, one // P[0], lambda k, I: -sum(map(mul, P[1:k + 1], I[k - 1::-1])) // P[0])
        return self.checked(I, (lengths(summed(convolved(I, P), [one], -1)) + lengths(I) * r) // m + 1)

    def root(self, a):
        """R with |R - sqrt f| = |R^2 - f|/(R + sqrt f): R^2 > 0 all along and R(0) > 0, so R > 0."""
        (P, r), B = a, self.B
        m = self.least(a, "the square root of a number that may be negative or 0")
        first = isqrt(P[0] << B)
        R = self.series(P, first, lambda k, R: (((P[k] << B) if k < len(P) else 0) - sum(map(mul, R[1:], R[:0:-1]))) // (2 * first))
        off = lengths(summed(convolved(R, R), [x << B for x in P], -1)) + (r << B)
        require(off < m << B, "a square root is too inaccurate")
        return self.checked(R, off // isqrt(m << B) + 1)

    def exp(self, a):
        """With P = c + Q and (E e^-Q)' = (E' - Q'E)e^-Q the E of the series is E(0)e^Q but for ||E' - Q'E|| g^2, g >= e^||Q||."""
        (P, r), B = a, self.B
        c, slope = Fraction(P[0] if P else 0, 1 << B), derived(P)
        size = -(-lengths(P[1:]) >> B)
        require(abs(c) <= 700 and size <= 64 and r <= 1 << B, "an exponent is too great, or not known")
        first = floor_of(lambda p: exp_bounds(c, p), B) if c else 1 << B
        E = self.series(P, first, lambda k, E: sum(map(mul, slope, E[::-1])) // (k << B))
        g, off = 3 ** size, lengths(summed([x << B for x in derived(E)], convolved(slope, E), -1))
        off = (off * g * g >> B) + 1 + g
        return self.checked(E, off + (2 * r * (lengths(E) + off) >> B) + 1)

    def cos_sin(self, a):
        """Of P = c + Q both: E = C + iS has ((E e^-iQ)' = (E' - iQ'E)e^-iQ, and |e^-iQ| = 1."""
        (P, r), B = a, self.B
        c, slope = Fraction(P[0] if P else 0, 1 << B), derived(P)
        require(abs(c) <= 1 << 64, "an angle is too great")
        C, S = [floor_of(lambda p: cos_sin_bounds(c, p, side), B) for side in (0, 1)] if c else (1 << B, 0)
        C, S = [C], [S]
        for k in range(1, self.n if slope else 1):
            s = [sum(map(mul, slope, A[::-1])) for A in (S, C)]
            C.append(-s[0] // (k << B))
            S.append(s[1] // (k << B))
        off = (lengths(summed([x << B for x in derived(C)], convolved(slope, S)))
               + lengths(summed([x << B for x in derived(S)], convolved(slope, C), -1)))
        return [self.checked(A, (off >> B) + 3 + r) for A in (C, S)]

    def log(self, a):
        """L with |L - log P| <= ||L'P - P'||/m + 1 by the rounding of L(0), and |log f - log P| <= r/m."""
        (P, r), B = a, self.B
        m, c = self.least(a, "the logarithm of a number that may be negative or 0"), Fraction(P[0], 1 << B)
        first = floor_of(lambda p: logarithm_bounds(c, p), B) if c != 1 else 0

        def term(k, L):
            rest = sum(x * y * j for j, (x, y) in enumerate(zip(L, P[k::-1] if k < len(P) else [0] * (k - len(P) + 1) + P[::-1])))
            return (((k * P[k] << B) if k < len(P) else 0) - rest) // (k * P[0])
        L = self.series(P, first, term)
        off = lengths(summed(convolved(derived(L), P), [x << B for x in derived(P)], -1))
        return self.checked(L, (off + (r << B)) // m + 2)

    def atan(self, a):
        """A with A'W = P' but for a rest, W = 1 + P^2 >= 1."""
        (P, r), B = a, self.B
        c, W = Fraction(P[0] if P else 0, 1 << B), summed(convolved(P, P), [1 << 2 * B])
        first = floor_of(lambda p: arctan_bounds(c, p), B) if c else 0

        def term(k, A):
            rest = sum(x * y * j for j, (x, y) in enumerate(zip(A, W[k::-1] if k < len(W) else [0] * (k - len(W) + 1) + W[::-1])))
            return (((k * P[k] << 2 * B) if k < len(P) else 0) - rest) // (k * W[0])
        A = self.series(P, first, term)
        off = lengths(summed(convolved(derived(A), W), [x << 2 * B for x in derived(P)], -1))
        return self.checked(A, (off >> 2 * B) + 2 + r)


class Jets:
    """Arithmetic of jets: lists of J + 1 Taylor models f_j, of the function f(z, x) = sum f_j x^j, x a step of the parameter t."""

    def __init__(self, models, J):
        self.m, self.J = models, J

    def plus(self, a, b):
        return [self.m.plus(x, y) for x, y in zip(a, b)]

    def scaled(self, a, x):
        return [self.m.scaled(y, x) for y in a]

    def sum_of(self, k, a, b, weight=lambda j: 1):
        """The sum of weight(j) a_j b_(k-j)."""
        total = [], 0
        for j in range(k + 1):
            if weight(j):
                total = self.m.plus(total, self.m.scaled(self.m.times(a[j], b[k - j]), Fraction(weight(j))))
        return total

    def times(self, a, b):
        return [self.sum_of(k, a, b) for k in range(self.J + 1)]

    def recursive(self, first, next_one):
        """first, next_one(1, so far), ...; to what is not yet there the terms of the sums have the weight 0."""
        out = [first] + [([], 0)] * self.J
        for k in range(1, self.J + 1):
            out[k] = next_one(k, out)
        return out

    def over(self, a, b):
        """b q = a."""
        i = self.m.inverse(b[0])
        return self.recursive(self.m.times(a[0], i), lambda k, q: self.m.times(i, self.m.minus(
            a[k], self.sum_of(k, q, b, lambda j: j < k))))

    def root(self, a):
        """R R = a."""
        first = self.m.root(a[0])
        i = self.m.inverse(first)
        return self.recursive(first, lambda k, R: self.m.scaled(self.m.times(i, self.m.minus(
            a[k], self.sum_of(k, R, R, lambda j: 0 < j < k))), Fraction(1, 2)))

    def exp(self, a):
        """E' = a'E."""
        return self.recursive(self.m.exp(a[0]), lambda k, E: self.m.scaled(self.sum_of(k, a, E, lambda j: j), Fraction(1, k)))

    def cos_sin(self, a):
        """C' = -a'S, S' = a'C."""
        C, S = ([x] + [([], 0)] * self.J for x in self.m.cos_sin(a[0]))
        for k in range(1, self.J + 1):
            c, s = (self.sum_of(k, a, A, lambda j: j) for A in (S, C))
            C[k], S[k] = self.m.scaled(c, Fraction(-1, k)), self.m.scaled(s, Fraction(1, k))
        return C, S

    def of_slope(self, first, a, w):
        """L with L' w = a'."""
        i = self.m.inverse(w[0])
        return self.recursive(first, lambda k, L: self.m.times(i, self.m.minus(
            a[k], self.m.scaled(self.sum_of(k, L, w, lambda j: j if j < k else 0), Fraction(1, k)))))

    def log(self, a):
        return self.of_slope(self.m.log(a[0]), a, a)

    def atan(self, a):
        return self.of_slope(self.m.atan(a[0]), a, self.plus(self.times(a, a), self.number(Fraction(1))))

    def number(self, x):
        return [self.m.number(x)] + [([], 0)] * self.J

    def power(self, a, k):
        """By squares from the first bit on; with a fraction for exponent exp(k log a)."""
        if k.denominator > 1:
            return self.exp(self.scaled(self.log(a), k))
        product = a if k else self.number(Fraction(1))
        for bit in bin(abs(k.numerator))[3:]:
            product = self.times(product, product)
            if bit == "1":
                product = self.times(product, a)
        return product if k >= 0 else self.over(self.number(Fraction(1)), product)

    def values(self, f, variable):
        """Of all steps of f."""
        out, turned = [], {}
        for (operation, left, right), number in zip(f.steps, f.numbers):
            a, b = (out[k] if isinstance(k, int) else None for k in (left, right))
            if number is not None:
                value = self.number(number)
            elif operation == "pi":
                value = self.of_pi()
            elif operation == "s":
                value = variable
            elif operation == "*" and any(f.numbers[k] is not None for k in (left, right)):
                value = self.scaled(b, f.numbers[left]) if f.numbers[left] is not None else self.scaled(a, f.numbers[right])
            elif operation in ("sin", "cos"):
                if left not in turned:
                    turned[left] = self.cos_sin(a)
                value = turned[left][operation == "sin"]
            elif operation == "power":
                value = self.power(a, right)
            elif operation in "+*/":
                value = {"+": self.plus, "*": self.times, "/": self.over}[operation](a, b)
            else:
                value = {"exp": self.exp, "log": self.log, "sqrt": self.root, "atan": self.atan}[operation](a)
            out.append(value)
        return out

    def of_pi(self):
        return [([floor_of(pi_bounds, self.m.B)], 1)] + [([], 0)] * self.J


# Sums of c pi^j x^k e^(i(wx + rp + q)), p = pi, as {(j, k, w, r, q): c} with 0 <= r < 1, since half a turn is the factor -1, and
# no c = 0. Sums that are equal are equal functions of x.

UNIT, OF_PI, OF_X = (0, 0, 0, 0, 0), (1, 0, 0, 0, 0), (0, 1, 0, 0, 0)


def collected(terms):
    found = {}
    for (j, k, w, r, q), c in terms:
        key, c = (j, k, w, r - r // 1, q), -c if r // 1 % 2 else c
        found[key] = found.get(key, 0) + c
    return {key: c for key, c in found.items() if c}


def cosine(f, turned_back):
    """cos(f - turned_back pi) for f = wx + r pi + q: (e^i... + e^-i...)/2."""
    require(f.keys() <= {UNIT, OF_PI, OF_X}, "the symmetry is not seen: an angle is not linear in s")
    w, r, q = f.get(OF_X, 0), f.get(OF_PI, 0) - turned_back, f.get(UNIT, 0)
    return collected([((0, 0, w, r, q), Fraction(1, 2)), ((0, 0, -w, -r, -q), Fraction(1, 2))])


def slope_of(f):
    """The derivative; i is e^(i pi/2)."""
    turned = [((j, k, w, r + Fraction(1, 2), q), c * w) for (j, k, w, r, q), c in f.items()]
    return collected(turned + [((j, k - 1, w, r, q), c * k) for (j, k, w, r, q), c in f.items() if k])


class Waves:
    """Such sums, and what may still be spent on them."""

    def __init__(self, room):
        self.room = room

    def spend(self, count, f, g):
        bits = [max((bits_of(x) for key, c in sum_.items() for x in (c, *key[2:])), default=0) for sum_ in (f, g)]
        self.room -= count * (sum(bits) + 200) ** 2
        require(self.room >= 0, "to see the symmetry is too much work")

    def plus(self, f, g):
        self.spend(len(f) + len(g), f, g)
        return collected([*f.items(), *g.items()])

    def minus(self, f, g):
        return self.plus(f, {key: -c for key, c in g.items()})

    def times(self, f, g):
        self.spend(len(f) * len(g), f, g)
        return collected((tuple(x + y for x, y in zip(a, b)), c * d) for a, c in f.items() for b, d in g.items())

    def dot(self, f, g):
        return reduce(self.plus, map(self.times, f, g))

    def cross(self, f, g):
        return [self.minus(self.times(f[i], g[j]), self.times(f[j], g[i])) for i, j in ((1, 2), (2, 0), (0, 1))]

    def values(self, f, variable):
        """Of the steps of a formula."""
        out = []
        for (name, left, right), number in zip(f.steps, f.numbers):
            if number is not None:
                out.append({UNIT: number} if number else {})
            elif name in ("pi", "s"):
                out.append({OF_PI: 1} if name == "pi" else variable)
            elif name in "+*":
                out.append((self.plus if name == "+" else self.times)(out[left], out[right]))
            elif name == "/" and f.numbers[right]:
                out.append(self.times(out[left], {UNIT: 1 / Fraction(f.numbers[right])}))
            elif name == "power" and right.denominator == 1 and right >= 0:
                out.append(reduce(self.times, [out[left]] * int(right), {UNIT: 1}))
            else:
                require(name in ("sin", "cos"), "the symmetry is not seen: not all is a sum of products of s, sin and cos")
                out.append(cosine(out[left], Fraction(1, 2) if name == "sin" else 0))
        return out


# Reading. A form is {key: form} for an object, [form] for a list, (form, form) for a list of that length, or
# a function of a value and its place (a JSON pointer), which returns what it reads.

class Object(dict):
    """A JSON object, which remembers its keys as they are written."""

    def __init__(self, pairs):
        super().__init__(pairs)
        self.written = [key for key, _ in pairs]


def fail(place, what, value):
    """The value at the place is not as it should be."""
    shown = json.dumps(value)
    raise Malformed("%s: %s: %s" % (place or "/", what, shown[:60] + ("..." if len(shown) > 60 else "")))


def read(form, value, place):
    """What the value is in that form: an object has all the keys (but the OPTIONAL) and no others."""
    if isinstance(form, dict):
        if not isinstance(value, dict):
            fail(place, "an object is wanted", value)
        for key in value.written + list(form):
            is_there = key in value or key in OPTIONAL
            problem = ("there twice" if value.written.count(key) > 1 else
                       "unknown" if key not in form else "missing" if not is_there else None)
            if problem:
                fail(place, "the key %s is %s" % (json.dumps(key), problem), value)
        return SimpleNamespace(**{key: read(form[key], value[key], place + "/" + key) for key in form
                                  if key in value})
    if isinstance(form, (list, tuple)):
        length = " of %d" % len(form) if isinstance(form, tuple) else ""
        if not isinstance(value, list) or length and len(form) != len(value):
            fail(place, "a list%s is wanted" % length, value)
        forms = form if length else form * len(value)
        return [read(inner, x, "%s/%d" % (place, k)) for k, (inner, x) in enumerate(zip(forms, value))]
    return form(value, place)


def expect(test, what, form=lambda value, place: value):
    """The form, for what passes the test."""
    def leaf(value, place):
        found = read(form, value, place)
        return found if test(found) else fail(place, what, value)
    return leaf


def one_of(*strings):
    return expect(lambda x: x in strings, "%s is wanted" % " or ".join(map(json.dumps, strings)))


def at_least(least, form):
    return expect(lambda x: x >= least, "a number not less than %d is wanted" % least, form)


def bits_of(*numbers):
    """Of numerators and denominators together."""
    return sum(x.numerator.bit_length() + x.denominator.bit_length() for x in numbers)


EXACT = re.compile(r"(-?[0-9]+)(?:/([0-9]+))?\Z", re.ASCII)
DECIMAL = re.compile(r"(-?[0-9]+)(?:\.([0-9]+))?(?:e(-?[0-9]+))?\Z", re.ASCII)


def matched(pattern, what, value, place):
    match = pattern.match(value) if isinstance(value, str) and len(value) <= MAX_LENGTH else None
    return match or fail(place, what + " of at most %d characters is wanted, in quotes" % MAX_LENGTH, value)


def rational(value, place):
    """A fraction or an integer, exactly; an int if it is an integer."""
    head, below = matched(EXACT, "an integer or a fraction", value, place).groups()
    if below and int(below) == 0:
        fail(place, "the denominator is 0", value)
    x = Fraction(int(head), int(below)) if below else int(head)
    TAKEN.volume += bits_of(x)
    return x if x.denominator > 1 else x.numerator


def integer(value, place):
    return fail(place, "an integer is wanted", value) if "/" in str(value) else rational(value, place)


def decimal(value, place):
    head, digits, exponent = (x or "" for x in matched(DECIMAL, "a decimal number", value, place).groups())
    if len(exponent) > 10 or abs(int(exponent or 0)) > MAX_EXPONENT:
        fail(place, "exponents are limited to %d" % MAX_EXPONENT, value)
    return Fraction(int(head + digits)) * Fraction(10) ** (int(exponent or 0) - len(digits))


def bound(value, place):
    x = decimal(value, place)
    return fail(place, "a number without a sign is wanted", value) if value[0] == "-" else x


def over_one_denominator(c):
    d = reduce(lambda d, x: d * x.denominator // gcd(d, x.denominator), c, 1)
    return Poly([x.numerator * (d // x.denominator) for x in c], d)


def poly(most, least=0):
    """The form of a polynomial with at most, and at least, so many coefficients."""
    def leaf(value, place):
        if isinstance(value, list) and not least <= len(value) <= most:
            fail(place, "%d to %d coefficients are wanted" % (least, most), value)
        found = over_one_denominator(read([rational], value, place))
        TAKEN.volume += len(found.c) * found.bits()
        return found
    return leaf


def nonzero(form):
    return expect(bool, "a polynomial that is not 0 is wanted", form)


def complex_poly(most):
    def leaf(value, place):
        parts = read({"re": poly(most), "im": poly(most)}, value, place)
        return parts.re, parts.im
    return leaf


def point(most):
    """The only zero in (low, high) of w; a rational one is that of den t - num around it."""
    def leaf(value, place):
        is_object = isinstance(value, dict) and isinstance(value.get("t"), dict)
        form = {"polynomial": poly(most), "interval": (rational, rational)} if is_object else rational
        P = read({"t": form, "order": at_least(1, count)}, value, place)
        t = P.t
        P.w, (P.low, P.high) = ((t.polynomial, t.interval) if is_object else
                                (Poly([-t.numerator, t.denominator]), (t - 1, t + 1)))
        if P.w.is_constant() or P.low >= P.high:
            fail(place + "/t", "a polynomial that is not constant and an interval a < b are wanted", value["t"])
        return P
    return leaf


def decision(witnesses, always=False):
    """The answer, with its witnesses: always, or where it is true."""
    def leaf(value, place):
        is_wanted = always or isinstance(value, dict) and value.get("answer") is True
        return read({"answer": boolean, **(witnesses if is_wanted else {})}, value, place)
    return leaf


def is_text(value):
    """Half of a surrogate pair is in no text."""
    try:
        return isinstance(value, str) and bool(value.encode("utf-8") or True)
    except UnicodeEncodeError:
        return False


string = expect(is_text, "a string is wanted")
boolean = expect(lambda x: isinstance(x, bool), "true or false is wanted")
signs = expect(lambda x: isinstance(x, str) and set(x) <= set("+-0"),
               "signs are wanted, each of them +, - or 0")
count = expect(lambda x: type(x) is int and abs(x) <= MAX_COUNT,
               "an integer is wanted, without quotes and not above %d" % MAX_COUNT)
VECTOR, COMPLEX, SIZE = (rational,) * 3, (integer, integer), at_least(0, integer)
# Of a curve, of a path, and of a claim.
OPTIONAL = ("name", "note", "start", "multiplier", "closed", "holonomy", "writhe", "symmetry")
AXES = ("x", "y", "z")
ROOT = {"center": COMPLEX, "radius": SIZE, "residue": COMPLEX, "residue_radius": SIZE}
CLAIM, TURN = {"t": rational, "theta": decimal, "radius": bound}, {"index": count, "signs": (signs, signs)}
ARC = {"segment": at_least(0, count), "interval": (rational, rational)}
CROSSING = {"first": ARC, "second": ARC, "sign": expect(lambda x: x in (-1, 1), "1 or -1 is wanted", count)}
CLOSED = {"holonomy": {"turns": count, "value": decimal, "radius": bound},
          "writhe": {"projection": expect(any, "a vector that is not 0 is wanted", VECTOR), "crossings": [CROSSING],
                     "value": decimal, "radius": bound}}


def form_of_curve(most, is_rational):
    multiplier = ({"numerator": nonzero(poly(most)), "denominator": nonzero(poly(most))} if is_rational else
                  nonzero(poly(most, 1)))
    return {"phrame": one_of("curve/1"), "name": string, "note": string, "start": VECTOR, "basis": one_of("power"),
            "preimage": {key: poly(most, 1) for key in "uvpq"}, "multiplier": multiplier}


def form_of_position(most):
    weight = expect(lambda w: not w.is_constant() and w.c[0], "it is constant, or 0 at t = 0", poly(most))
    return {**{key: poly(most) for key in AXES}, "w": weight}


def form_of_decisions(most):
    points = [point(most)]
    return {"regular": decision({"cusps": points}, always=True),
            "inflections": decision({"points": points}, always=True),
            "line": decision({"direction": VECTOR}),
            "planar": decision({"normal": VECTOR}),
            "helical": decision({"axis": VECTOR, "cos_squared": rational}),
            "double_ph": decision({"omega": poly(most), "constant": rational}),
            "primitive": decision({"content": poly(most)}, always=True),
            "erf_is_rmf": decision({}),
            "rrmf": decision({"w": complex_poly(most)}),
            "erf_monotone": decision({"zeros_of_h": points, "extrema": points}, always=True)}


def form_of_certificate(most, frenet, is_rational):
    """Polynomials have at most so many coefficients. The Frenet frame has `bend` and the turns of the claims, a
    rational curve its `position`."""
    some, logs = poly(most), {"index": expect(lambda q: not q.is_constant(), "it is constant", poly(most)),
                              "residue": poly(most), "roots": [ROOT]}
    more = ({"claims": [{**CLAIM, "turn": TURN}], "bend": {"polynomial": complex_poly(most), "content": some}}
            if frenet else {"claims": [CLAIM]})
    if is_rational:
        more["position"] = lambda value, place: value
    return {"phrame": one_of("certificate/1"), "curve": lambda value, place: value, "frame": one_of("erf", "frenet"),
            "hodograph": (some,) * 3, "sigma": some, "h": some, "g": complex_poly(most),
            "rate": {"numerator": some, "denominator": some, "common": some,
                     "coprime_modulo": at_least(2, integer)},
            "antiderivative": {"rational": {"numerator": some, "denominator": nonzero(some)}, "logs": [logs]},
            "bits": at_least(0, count), "decisions": form_of_decisions(most), **more}


def work(C, D):
    """What it takes to check the certificate, in the units of the page: a nanosecond or less."""
    logs, claims, d, is_frenet = C.antiderivative.logs, C.claims, C.decisions, C.frame == "frenet"
    n = sum(len(log.roots) for log in logs)
    a = max(p.bits() for p in C.A + [C.n, C.d] + (C.r or []))
    C.D, C.a = D, a
    total = 50 * D ** 3 * (1 + a // 64) + D ** 2 * a ** 2 // 2 + TAKEN.volume ** 2 * (len(logs) + 1) // 63000
    total += D ** 4 * a ** 2 // 6000 if is_frenet else 0
    for log in logs:
        k, b = len(log.index.c), max(log.index.bits(), log.residue.bits())
        total += len(log.roots) * k ** 2 * (C.bits + b + 64) // 8 + k ** 3 * b ** 2 // 63000
    for claim in claims:
        k, t = bits_of(claim.radius), D * bits_of(claim.t)
        total += (n + 8) * k ** 2 + bits_of(claim.theta) ** 2 // 1000 + t ** 2 * (10 + (D if is_frenet else 0)) // 1000
    for points in (d.regular.cusps, d.inflections.points, d.erf_monotone.zeros_of_h, d.erf_monotone.extrema):
        total += sum(len(P.w.c) ** 3 * bits_of(P.low, P.high) ** 2 // 2000 for P in points)
        total += sum(200 * len(P.w.c) * len(Q.w.c) for P, Q in combinations(points, 2)
                     if max(P.low, Q.low) < min(P.high, Q.high))
    return total


def parsed(data):
    """The value of a JSON text, objects as Object. A long integer is none that is wanted anywhere."""
    def refuse(text):
        raise ValueError("%s is no number" % text)
    try:
        return json.loads(data.decode("utf-8-sig"), object_pairs_hook=Object, parse_constant=refuse,
                          parse_int=lambda text: int(text) if len(text) < 20 else float("inf"))
    except (ValueError, RecursionError) as error:
        raise Malformed("/: this is no JSON: %s" % str(error)[:200].replace("\n", " "))


def read_of_curve(value, place, limits):
    """(C, work): all that is in a certificate/1, and what it takes to check it."""
    TAKEN.volume = TAKEN.zeros = 0
    curve = value.get("curve") if isinstance(value, dict) else None
    frenet = isinstance(value, dict) and value.get("frame") == "frenet"
    is_rational = isinstance(curve, dict) and isinstance(curve.get("multiplier"), dict)
    most, m, f, r = limits.max_degree + 1, 0, 0, None
    has_curve = isinstance(value, dict) and "curve" in value
    K = read(form_of_curve(most, is_rational), curve, place + "/curve") if has_curve else None
    if K:
        n, d = getattr(K, "multiplier", Poly([1])), Poly([1])
        m, f = max(map(len, curve["preimage"].values())) - 1, len(curve.get("multiplier", "1")) - 1
    if is_rational and "position" in value:
        n, d, P = n.numerator, n.denominator, read(form_of_position(most), value["position"], place + "/position")
        r = [P.x, P.y, P.z, P.w]
        f = max(0, len(n.c) + 2 * len(P.w.c) - len(d.c) - 2) + len(P.w.c) - 1
    D = 4 * m + 2 * f + 2
    C = read(form_of_certificate(D + 1, frenet, is_rational), value, place)
    C.curve, C.n, C.d, C.r, C.A = K, n, d, r, [getattr(K.preimage, key) for key in "uvpq"]
    if not any(C.A):
        fail(place + "/curve", "a preimage that is not 0 is wanted", curve)
    degree = max(len(a.c) for a in r) - 1 if r else 2 * max(len(a.c) for a in C.A) + len(n.c) - 2
    if degree > limits.max_degree:
        fail(place + "/curve", "the degree is %d, beyond the limit %d (--max-degree)" % (degree, limits.max_degree), curve)
    name_claims(C.claims, value)
    return C, work(C, D)


def name_claims(claims, value):
    for claim, written in zip(claims, value["claims"]):
        claim.text = "|theta(%s) - %s| <= %s" % (claim.t, written["theta"], written["radius"])


def read_of_path(value, limits):
    """The same of a path-certificate/1."""
    P = read({"phrame": one_of("path-certificate/1"), "name": string, "segments": expect(
        bool, "a segment is wanted", [lambda value, place: value]), "claims": [CLAIM], "closed": CLOSED}, value, "")
    name_claims(P.claims, value)
    total = sum(bits_of(c.t, c.theta, c.radius) ** 2 // 1000 + 1000 for c in P.claims)
    parts = [read_of_curve(part, "/segments/%d" % k, limits) for k, part in enumerate(P.segments)]
    P.segments, works = zip(*parts)
    for k, C in enumerate(P.segments):
        if C.frame != "erf":
            fail("/segments/%d/frame" % k, '"erf" is wanted', C.frame)
    return P, total + sum(works) + work_of_closed(P, value)


def work_of_closed(P, value):
    """What it takes to check what is said of a closed path, but for the crossings."""
    P.values, total = vars(P.closed) if hasattr(P, "closed") else None, 0
    for name, x in (P.values or {}).items():
        written, e = value["closed"][name], bits_of(x.radius)
        x.text = "|%s - %s| <= %s" % (name, written["value"], written["radius"])
        total += 10 * e ** 2 * len(P.segments) + bits_of(x.value) ** 2 // 1000
    if P.values and "writhe" in P.values:
        v = bits_of(*P.values["writhe"].projection)
        for C in P.segments:
            total += C.D ** 4 * (C.a + v) ** 2 // 6000
        most = max(C.D for C in P.segments) ** 2
        arcs = [arc for c in P.values["writhe"].crossings for arc in (c.first, c.second)]
        total += sum(most * bits_of(*arc.interval) ** 2 // 100 for arc in arcs)
    return total


def formula(variable):
    """A text that is as it would be written again, with few parentheses and small exponents."""
    def leaf(value, place):
        is_short = isinstance(value, str) and len(value) <= MAX_FORMULA and value.isascii()
        if not is_short or max(accumulate((c == "(") - (c == ")") for c in value), default=0) > MAX_DEPTH:
            fail(place, "a formula of at most %d characters, %d parentheses deep, is wanted" % (MAX_FORMULA, MAX_DEPTH), value)
        if max(map(len, re.findall("[0-9]+", value)), default=0) > MAX_DIGITS:
            fail(place, "numbers of at most %d digits are wanted" % MAX_DIGITS, value)
        reader = FormulaReader(value, Formula(), place, variable)
        step = reader.read()
        if reader.f.texts()[step] != value:
            fail(place, "this formula is not written as it would be written again", value)
        if any(max(abs(x.numerator), x.denominator) > MAX_POWER for name, _, x in reader.f.steps if name == "power"):
            fail(place, "exponents are limited to %d" % MAX_POWER, value)
        return value
    return leaf


def symmetry(value, place):
    """None for that of a mirror, or a shift."""
    return None if value == "mirror" else expect(lambda x: x > 0, "a shift is positive", rational)(value, place)


ENDS, JETS = ("from", "to"), {"none": 1, "up": 2, "frenet": 3}  # which derivatives of r a rate has
EXPRESSIONS = {**{key: formula("s") for key in AXES}, **{key: formula("") for key in ENDS}}


def complete_formulas(C):
    """The steps of the coordinates and of the ends."""
    C.texts, C.f, C.ends = vars(C.expressions), Formula(), Formula()
    C.steps = {key: FormulaReader(text, C.ends if key in ENDS else C.f, "", "s").read() for key, text in C.texts.items()}


def is_rational(f):
    return all(name in ("number", "s", *"+*/") or name == "power" and x.denominator == 1 for name, _, x in f.steps)


def read_of_integral(value, limits):
    """The same of an integral-certificate/1."""
    TAKEN.volume = TAKEN.zeros = 0
    most, frame = limits.max_degree + 1, value.get("frame")
    some, name = poly(most), "length" if frame == "none" else "theta"
    piece = {"to": rational, "root": [integer], "rate": [integer], "root_bits": at_least(0, count), "rate_bits": at_least(0, count)}
    weight = expect(lambda w: w.c and w.c[0], "it is 0 at t = 0", some)
    quotient = {"x": some, "y": some, "z": some, "w": weight, "square": nonzero(some), "pieces": [piece]}
    formulas = {"expressions": EXPRESSIONS, "pieces": [{"to": rational, "order": at_least(2, count), "bits": at_least(0, count)}]}

    def segment(value, place):
        return read(formulas if isinstance(value, dict) and "expressions" in value else quotient, value, place)
    form = {"phrame": one_of("integral-certificate/1"), "name": string, "frame": one_of("up", "frenet", "none"),
            "segments": expect(bool, "a segment is wanted", [segment]),
            "claims": [{"t": rational, name: decimal, "radius": bound, **({} if frame == "none" else {"symmetry": symmetry})}]}
    P = read({**form, "up": VECTOR} if frame == "up" else form, value, "")
    for claim, written in zip(P.claims, value["claims"]):
        claim.value = getattr(claim, name)
        claim.text = "|%s(%s) - %s| <= %s" % (name, claim.t, written[name], written["radius"])
    return P, work_of_integral(P)


def work_of_integral(P):
    """What it takes to check it, in the units of the page."""
    total, longest = TAKEN.volume ** 2 // 63000, 0
    for C in P.segments:
        C.d = C.a = C.count = 0
        if hasattr(C, "expressions"):
            complete_formulas(C)
            C.count = len(C.f.steps) + len(C.ends.steps)
            total += work_of_models(C, P.frame, len(P.segments) > 1)
            longest = max([longest] + [piece.order for piece in C.pieces])
            continue
        lists = [C.x, C.y, C.z, C.w, C.square]
        d, a = C.d, C.a = max(len(p.c) for p in lists), max(p.bits() for p in lists)
        total += 3000 * d ** 3 * (1 + a // 64) + 2 * d ** 2 * a ** 2
        for piece in C.pieces:
            k, b = 6 * d + len(piece.root) + len(piece.rate), max(piece.root_bits, piece.rate_bits)
            b = max([b] + [x.bit_length() for x in piece.root + piece.rate]) + 4 * a + 3 * d * bits_of(piece.to)
            total += k ** 2 * (b + 2000) // 40 + k * b ** 2 // 2000
            longest = max(longest, len(piece.rate))
    for claim in P.claims:
        total += (bits_of(claim.t) * (1 + longest)) ** 2 // 500 + bits_of(claim.value, claim.radius) ** 2 // 1000
        total += 1000 * (1 + len(P.segments))
        if hasattr(claim, "symmetry"):
            d, t = P.segments[0].d, bits_of(claim.t)
            total += 20000 * P.segments[0].count + 5000 * d ** 2 * (1 + (P.segments[0].a + d * t) // 64)
        if P.frame == "up" and len(P.segments) > 1:  # there may be turns at the joints
            total += (2 * len(P.segments) + 8) * bits_of(claim.radius) ** 2
    return total


SERIES = {"/": (1, 1), "exp": (1, 1), "sqrt": (2, 1), "log": (2, 1), "sin": (2, 2), "cos": (2, 2), "atan": (4, 2)}


def work_of_steps(f):
    """How many series and how many products of jets there are; sine and cosine of one angle are one function."""
    series, products, angles = 0, 0, set()
    for (name, left, right), number in zip(f.steps, f.numbers):
        if number is not None or name in ("pi", "s", "+"):
            continue
        if name == "*":
            products += f.numbers[left] is None and f.numbers[right] is None
        elif name == "power":
            fraction, below = right.denominator > 1, right < 0
            series += 3 * fraction + below
            products += 2 * fraction + below + 2 * right.numerator.bit_length()
        elif name not in ("sin", "cos") or left not in angles:
            series += SERIES[name][0]
            products += SERIES[name][1]
            angles |= {left} if name in ("sin", "cos") else set()
    return series, products


def work_of_models(C, frame, is_joined):
    """The same of a curve by formulas. At the joints the models are constants."""
    (a, b), (c, d) = work_of_steps(C.f), work_of_steps(C.ends)
    J, steps = JETS[frame], len(C.f.steps) + len(C.ends.steps)
    series, products = a + c + 3, (J + 1) * (J + 2) // 2 * (b + d) + 20
    total = sum(6 * bits ** 2 for bits in {piece.bits for piece in C.pieces})
    parts = [(piece.order, piece.bits + bits_of(piece.to)) for piece in C.pieces]
    parts += [(1, max([piece.bits for piece in C.pieces], default=0))] * 2 * is_joined
    for n, b in parts:
        product = 2000 + 1000 * n + n * b * isqrt(n * b) // 18
        one = product + n * n * (300000 + b * b) // 7800 + 700 * n + 2000 + b * b // 10
        total += series * one + products * product + steps * J * (200 * n + 10000)
    return total


def complete_integral(P):
    """What is derived from X/W, and refused where that is a point."""
    for k, C in enumerate(P.segments):
        if hasattr(C, "expressions"):
            C.side = 1  # e1 is r'/|r'| times that
            if is_rational(C.f) and is_rational(C.ends):
                fail("/segments/%d/expressions" % k, "these are rational functions, for which x, y, z and w are", C.texts)
            continue
        C.X, C.W = [C.x, C.y, C.z], C.w
        slope = C.W.derivative()
        C.velocity = [x.derivative() * C.W - x * slope for x in C.X]  # W^2 r'
        if not any(C.velocity):
            fail("/segments/%d" % k, "the curve is a single point", None)
        C.f, C.H = direction_of(C.velocity)


def direction_of(velocity):
    """(f, H) with velocity = f H, H of integers without a common factor, and f > 0 for small t > 0."""
    f = common(*velocity)
    H = [a.over(f) for a in velocity]
    d = reduce(lambda n, a: n * a.d // gcd(n, a.d), H, 1)
    unit = Fraction(reduce(gcd, [x * (d // a.d) for a in H for x in a.c], 0), d)
    unit *= 1 if next(x for x in f.c if x) > 0 else -1
    return f * unit, [a * (1 / unit) for a in H]


def complete(C, place):
    """With f = n W^2/d and W, which is 1 of a polynomial curve: r' = f A i A*/W^2 and r(0) are those of r = X/W."""
    C.start = getattr(C.curve, "start", [0, 0, 0])
    if not C.r:
        C.f, C.W = C.n, Poly([1])
        return
    *X, C.W = C.r
    C.f, rest = divmod(C.n * C.W * C.W, C.d)
    slope = C.W.derivative()
    if rest or [x.derivative() * C.W - x * slope for x in X] != hodograph_of(C.f, C.A):
        raise Malformed("%s/position: its derivative is not that of the curve" % place)
    if [x(0) for x in X] != [s * C.W(0) for s in C.start]:
        raise Malformed("%s/position: it does not begin at the start" % place)


def read_certificate(data, limits):
    """All that is in the file."""
    value = parsed(data)
    kind = value.get("phrame") if isinstance(value, dict) else None
    is_path, is_integral = kind == "path-certificate/1", kind == "integral-certificate/1"
    C, total = (read_of_path(value, limits) if is_path else read_of_integral(value, limits) if is_integral else
                read_of_curve(value, "", limits))
    most = MAX_WORK * max(len(data), FULL_SIZE) ** 2 // FULL_SIZE ** 2
    if total > most and not limits.unlimited:
        raise Malformed("/: to check it is work of %d, beyond the limit %d (--unlimited)" % (total, most))
    if is_integral:
        complete_integral(C)
        return C
    for k, part in enumerate(C.segments if is_path else [C]):
        complete(part, "/segments/%d" % k if is_path else "")
    return C


# The curve: its exact form is a text, whose hash names it.

def hodograph_of(f, A):
    """f A i A*"""
    u, v, p, q = A
    return [f * a for a in (u * u + v * v - p * p - q * q, (u * q + v * p) * 2, (v * q - u * p) * 2)]


def integral_of(a):
    """From 0."""
    common = reduce(lambda n, k: n * k // gcd(n, k), range(1, len(a.c) + 1), 1)
    return Poly([0] + [x * (common // k) for k, x in enumerate(a.c, 1)], a.d * common)


def in_lowest_terms(hodograph, over):
    """The numerators and the denominator of hodograph/over without a common factor, the denominator 1 at t = 0."""
    K = common(over, *hodograph)
    *hodograph, over = [a.over(K) for a in (*hodograph, over)]
    scale = 1 / over(0)
    return [a * scale for a in hodograph], over * scale


def exact_form(hodograph, over, start):
    """The canonical text of a curve: r' and r(0) as the page says."""
    names = [("dx", hodograph[0]), ("dy", hodograph[1]), ("dz", hodograph[2])] + [("over", over)] * (not over.is_constant())
    lists = [(name, [Fraction(x, a.d) for x in a.c]) for name, a in names] + [("start", start)]
    return "".join(" ".join([name] + [str(x) for x in numbers]) + "\n" for name, numbers in lists)


def hash_of(curves):
    """Of r' and r(0) of each curve, one behind the other; of a curve by formulas of its texts."""
    forms = [curve if isinstance(curve, str) else exact_form(*curve[:3]) for curve in curves]
    return hashlib.sha256("".join(forms).encode("ascii")).hexdigest()


def form_of_texts(texts):
    """The exact form of a curve by formulas."""
    return "".join("%s %s\n" % (key, texts[key]) for key in (*AXES, *ENDS))


def from_bernstein(c):
    """sum c[k] B(k, n)(t), from the differences at 0: the coefficient of t^k is binomial(n, k) times the k-th."""
    n, binomial, out = len(c) - 1, 1, []
    for k in range(n + 1):
        out.append(Fraction(c[0]) * binomial)
        c, binomial = [b - a for a, b in zip(c, c[1:])], binomial * (n - k) // (k + 1)
    return over_one_denominator(out)


def position_of(hodograph, over, start):
    """(X, W) with r = X/W, from r' = hodograph/over in lowest terms: W = gcd(over, over'), since a pole of r' of order
    k + 1 is one of order k of r; and X is W times the Taylor series of r at 0."""
    W = common(over, over.derivative())
    n = max([len(W.c)] + [len(a.c) + len(W.c) - len(over.c) + 1 for a in hodograph])  # more than the degree of X
    X = []
    for a, x in zip(hodograph, start):
        r = [x]
        for k in range(n - 1):
            c = Fraction(a.c[k], a.d) if k < len(a.c) else 0
            c -= sum(Fraction(y, over.d) * r[k - j + 1] * (k - j + 1) for j, y in enumerate(over.c[1:k + 1], 1))
            r.append(c / over(0) / (k + 1))
        X.append(over_one_denominator([sum(y * z for y, z in zip(W.c, r[k::-1])) for k in range(n)]))
    slope = W.derivative()
    is_that = all((x.derivative() * W - x * slope) * over == a * W * W for x, a in zip(X, hodograph))
    return (X, W) if is_that else fail("", "the curve is not rational", None)


def texts_of(value, at):
    """Of a curve/1 with formulas, as a certificate has them."""
    given, variable = value["expressions"], None
    if not isinstance(given, dict) or not {"x", "y"} <= set(given) <= {*AXES, *ENDS, "variable"}:
        fail(at + "/expressions", "an object with x, y, perhaps z, from, to and variable is wanted", given)
    require_keys(value, at, "phrame", "expressions", "variable", *ENDS)
    every = {"z": 0, **value, **given}
    variable = every.get("variable")
    texts = {}
    for key in (*AXES, *ENDS):
        place, text = at + "/expressions/" + key, every.get(key)
        text = str(Fraction(str(text))) if type(text) in (int, float) else string(text, place)
        reader = FormulaReader(text, Formula(), place, "" if key in ENDS else variable)
        step = reader.read()
        variable = variable if key in ENDS else reader.variable
        texts[key] = canonical(reader.f.texts()[step], place)
    return texts


def read_curves(name, limits):
    """[(r', r(0), A or None)], r' in lowest terms, of a curve/1 or of a spline/1 of these, or of those by formulas the exact form;
    numbers as these files have them, but for hexadecimal ones. A segment without a start goes on where the one before ends."""
    value, curves, end = parsed(read_file(name)), [], [0, 0, 0]
    kind = one_of("curve/1", "spline/1")(value.get("phrame") if isinstance(value, dict) else None, "/phrame")
    is_spline = kind == "spline/1"
    if is_spline:
        require_keys(value, "", "phrame", "segments", "frame")
        expect(bool, "a segment is wanted", [lambda value, place: value])(value.get("segments"), "/segments")
    for k, part in enumerate(value["segments"] if is_spline else [value]):
        place = "/segments/%d" % k if is_spline else ""
        if isinstance(part, dict) and "expressions" in part:
            curve = curve_of_texts(texts_of(part, place), limits)
        else:
            curve = read_curve(part, place, limits, end)
        if isinstance(curve, str):
            end = None
            curves.append(curve)
            continue
        hodograph, over, start, A = curve
        if is_spline:
            if k > 0 and end is not None and list(start) != list(end):
                fail("/segments/%d" % k, "it starts at %s, but the spline ends at %s" % tuple(", ".join(map(str, p)) for p in (start, end)), part)
            X, W = position_of(hodograph, over, start)
            end = [x(1) / W(1) for x in X]
        curves.append((hodograph, over, start, A))
    return curves


def of_quotient(X, W, place, A=None):
    """The curve X/W as read_curve() has it."""
    if not W(0) or not W(1):
        fail(place, "the weight is 0 at an end", [str(x) for x in W.c])
    slope = W.derivative()
    hodograph = [x.derivative() * W - x * slope for x in X]
    return *in_lowest_terms(hodograph, W * W), [x(0) / W(0) for x in X], A


def values_of_rational(f, s, limits):
    """Numerator and denominator of each step, for s."""
    values, one = [], Poly([1])
    for (name, left, right), number in zip(f.steps, f.numbers):
        if number is not None:
            N, D = Poly([number.numerator], number.denominator), one
        elif name == "s":
            N, D = s, one
        elif name == "power":
            (N, D), k = values[left], int(right)
            if abs(k) * max(len(N.c), len(D.c), 2) > 2 * limits.max_degree + 2:
                fail("/expressions", "an exponent is too large for a rational curve", right)
            N, D = (N, D) if k >= 0 else (D, N)
            N, D = (reduce(Poly.__mul__, [p] * abs(k), one) for p in (N, D))
        else:
            (a, b), (c, d) = values[left], values[right]
            N, D = (a * d + c * b, b * d) if name == "+" else (a * c, b * d) if name == "*" else (a * d, b * c)
        if not D:
            fail("/expressions", "a division by 0", name)
        K = common(N, D)
        N, D = N.over(K), D.over(K)
        if max(len(N.c), len(D.c)) > limits.max_degree + 1:
            fail("/expressions", "the degree is too large for a rational curve", name)
        values.append((N, D))
    return values


def curve_of_texts(texts, limits):
    """The exact form of a curve by formulas; where they are rational functions, the curve X/W."""
    C = SimpleNamespace(expressions=SimpleNamespace(**texts))
    complete_formulas(C)
    if not (is_rational(C.f) and is_rational(C.ends)):
        return form_of_texts(texts)
    ends = values_of_rational(C.ends, Poly([]), limits)
    a, b = (N(0) / D(0) for N, D in (ends[C.steps[key]] for key in ENDS))
    values = values_of_rational(C.f, over_one_denominator([a, b - a]), limits)
    parts = [values[C.steps[key]] for key in AXES]
    X = [reduce(Poly.__mul__, [parts[k][0]] + [parts[j][1] for j in range(3) if j != k]) for k in range(3)]
    return of_quotient(X, reduce(Poly.__mul__, [D for _, D in parts]), "/expressions")


NUMBER_OF_CURVE = re.compile(r"[-+]?([0-9]+/0*[1-9][0-9]*|([0-9]+([.][0-9]*)?|[.][0-9]+)([eE][-+]?[0-9]{1,4})?)", re.ASCII)
FORMS = ("preimage", "quaternions", "hopf", "complex", "control_points", "position", "tangents")


def require_keys(value, place, *known):
    """The keys of the object are these, or remarks."""
    known += ("name", "note", "family", "expected")
    for key in value.written:
        if key not in known or value.written.count(key) > 1:
            fail(place, "the key %s is unknown or there twice" % json.dumps(key), value)
    string(value.get("name", ""), place + "/name")


def read_curve(value, at, limits, end):
    """At this place of a file; without a start it begins at `end`."""
    def number(x, place):
        text = str(x) if type(x) in (str, int, float) else ""
        if not NUMBER_OF_CURVE.fullmatch(text):
            fail(place, "a number is wanted", x)
        return Fraction(text)

    def numbers(x, place):
        c = read([number], x, place)
        return c if 0 < len(c) <= limits.max_degree + 1 else fail(place, "too many coefficients, or none", x)

    def polynomial(x, place):
        return (from_bernstein if basis == "bernstein" else over_one_denominator)(numbers(x, place))

    def columns(n):
        """The form of n polynomials, whose coefficients are rows."""
        def leaf(x, place):
            rows = read([(lambda x, _: x,) * n], x, place)
            return [polynomial(list(column), place) for column in zip(*rows)] or fail(place, "no coefficients", x)
        return leaf

    def fraction(x, place):
        parts = {"numerator": polynomial, "denominator": nonzero(polynomial)}
        found = read(parts if isinstance(x, dict) else polynomial, x, place)
        return (found.numerator, found.denominator) if isinstance(x, dict) else (found, Poly([1]))

    def require_equal_lengths(lists):
        if basis == "bernstein" and len(set(map(len, lists))) > 1:
            fail(at, "Bernstein lists of equal lengths are wanted", value)

    form = [key for key in FORMS if isinstance(value, dict) and key in value]
    if len(form) != 1:
        fail(at, "a curve/1 with one of %s is wanted (phrame identify --print curve)" % ", ".join(FORMS), value)
    of_preimage = ("start", "multiplier") if form[0] in FORMS[:4] else ()
    require_keys(value, at, "phrame", "basis", form[0], *("weights",) * (form[0] == "control_points"), *of_preimage)
    one_of("curve/1")(value.get("phrame", "curve/1"), at + "/phrame")
    if "control_points" in value:
        one_of("bernstein")(value.get("basis", "bernstein"), at + "/basis")
        points = read([(number,) * 3], value["control_points"], at + "/control_points")
        if not 1 < len(points) <= limits.max_degree + 1:
            fail(at + "/control_points", "2 to %d points are wanted" % (limits.max_degree + 1), len(points))
        weights = read((number,) * len(points), value.get("weights", [1] * len(points)), at + "/weights")
        X = [from_bernstein([w * x for w, x in zip(weights, c)]) for c in zip(*points)]
        return of_quotient(X, from_bernstein(weights), at + "/weights")
    basis = one_of("power", "bernstein")(value.get("basis"), at + "/basis")
    if "position" in value:
        place, given = at + "/position", value["position"]
        if not isinstance(given, dict) or not set(given) <= {*AXES, "w"}:
            fail(place, "an object with x, y, z and w is wanted", given)
        lists = {"z": [0], "w": [1], **given}
        *X, W = [polynomial(lists.get(key), "%s/%s" % (place, key)) for key in (*AXES, "w")]
        return of_quotient(X, W, place)
    given, place = value[form[0]], at + "/" + form[0]
    if "tangents" in value:  # n.r = p: r = p n + (p'/phi') n turned, n = (2ab, a^2 - b^2)/(a^2 + b^2), phi its angle
        lines = read({"a": polynomial, "b": polynomial, "support": fraction}, given, place)
        a, b, (p, over) = lines.a, lines.b, lines.support
        n, size, turn = (a * b * 2, a * a - b * b), a * a + b * b, (a.derivative() * b - a * b.derivative()) * 2
        slope = (p.derivative() * over - p * over.derivative()) * size
        X = [p * over * turn * n[0] - slope * n[1], p * over * turn * n[1] + slope * n[0], Poly([])]
        W = size * over * over * turn
        K = common(*X, W) if W else fail(place, "the normal does not turn", given)
        return of_quotient([x.over(K) for x in X], W.over(K), place, [b, Poly([]), Poly([]), a])
    if "preimage" in value:
        A = vars(read({key: polynomial for key in "uvpq"}, given, place))
        require_equal_lengths(given.values())
        A = [A[key] for key in "uvpq"]
    elif "quaternions" in value:
        A = columns(4)(given, place)
    elif "hopf" in value:
        hopf = read({"alpha": columns(2), "beta": columns(2)}, given, place)
        require_equal_lengths(given.values())
        A = [*hopf.alpha, *hopf.beta[::-1]]
    else:
        u, q = columns(2)(given, place)
        A = [u, Poly([]), Poly([]), q]
    f, over = fraction(value.get("multiplier", [1]), at + "/multiplier")
    if not any(A) or not f or not over(0):
        fail(at, "the preimage or the multiplier is 0, or has a pole at t = 0", value)
    first = next((x for x in f.c if x), 0) * next((x for x in over.c if x), 0)
    if first < 0:  # the program then takes A j and -f, so that e1 = r'/|r'|
        u, v, p, q = A
        A, f = [p * -1, q * -1, u, v], f * -1
    start = read((number,) * 3, value["start"], at + "/start") if "start" in value else end
    if start is None:
        fail(at, "a start is wanted behind a segment by formulas", value)
    return *in_lowest_terms(hodograph_of(f, A), over), start, A


# The proof.

def check_points(P, points, name, odd_only=False):
    """The points are all the zeros of P on [0, 1], or all of odd order, each once; none for P = 0. A zero of
    order k of P is one of order k - 1 of gcd(P, P'): levels[j] has the zeros of order greater than j."""
    if not P:
        return require(not points, "%s: there must be no points, the polynomial is 0" % name)
    levels = [P]
    while not levels[-1].is_constant():
        levels.append(common(levels[-1], levels[-1].derivative()))
    for point in points:
        low, high = point.low, point.high
        w = point.w = point.w.over(common(point.w, point.w.derivative()))
        require(w.sign(low) and w.sign(high) and w.zeros(low, high) == 1,
                "%s: an interval does not hold exactly one zero of its polynomial" % name)
        require(w.zeros(max(low, 0), min(high, 1)) == 1, "%s: a point is not in [0, 1]" % name)
        order = len(list(takewhile(lambda level: common(w, level).zeros(low, high), levels)))
        require(order == point.order, "%s: a point is no zero of order %d" % (name, point.order))
        require(order % 2 or not odd_only, "%s: a point of even order is listed" % name)
    for a, b in combinations(points, 2):
        low, high = max(a.low, b.low), min(a.high, b.high)
        require(low >= high or not common(a.w, b.w).zeros(low, high), "%s: two points are the same" % name)
    # Those of order > 0; less those of order > 1, plus those of order > 2 ... are those of odd order.
    numbers = [a.over(b).zeros(0, 1) for a, b in zip(levels, levels[1:])]
    number = sum(numbers[0::2]) - sum(numbers[1::2]) if odd_only else sum(numbers[:1])
    require(number == len(points), "%s: there are %d points, not %d" % (name, number, len(points)))


def sturm_sequence(x, y):
    """s0 = x, s1 = y, s2 = -rem(s0, s1), ... to the last that is not 0, each up to a positive factor."""
    s = [x]
    while y:
        s.append(y)
        y = divmod(s[-2], y)[1].primitive() * -1
    require(s[-1].is_constant(), "the Sturm sequence does not end with a constant")
    return s


def change_of_argument(re, im, t, sturm):
    """(signs, index, terms) of re + i im, which is not 0: the sum of k arctan(slope) over the terms (k, slope), for the
    slopes at t and 0, and for pi, is the change of its argument from 0 to t. `sturm` keeps the sequences."""
    x, y = re * re(0) + im * im(0), im * re(0) - re * im(0)
    turned = x.sign(t) == 0
    x, y = (x - y, x + y) if turned else (x, y)
    if turned not in sturm:
        sturm[turned] = sturm_sequence(x, y)
    values = [[s.sign(at) for s in sturm[turned]] for at in (0, t)]
    signs_found = ["".join("+" if v > 0 else "-" if v < 0 else "0" for v in row) for row in values]
    index = sign_changes(values[0]) - sign_changes(values[1])
    return signs_found, index, [(1, y(t) / x(t)), (-1, y(0) / x(0)), (-4 * index, 1)]


# Numbers that are known within an error: (x, e). What is exact has the error 0.

def plus(a, b):
    return a[0] + b[0], a[1] + b[1]


def times(a, b):
    return a[0] * b[0], abs(a[0]) * b[1] + abs(b[0]) * a[1] + a[1] * b[1]


def known_root(square, P):
    """The square root."""
    unit = 1 << P + square.denominator.bit_length()
    n = square.numerator * unit * unit // square.denominator
    m = isqrt(n)
    is_exact = Fraction(m * m, unit * unit) == square
    return (Fraction(m, unit), 0) if is_exact else (Fraction(2 * m + 1, 2 * unit), Fraction(1, 2 * unit))


def quotient(a, b):
    """a/b, b > 0: that of x differs by (e + |x/y| f)/(y - f)."""
    return a[0] / b[0], (a[1] + abs(a[0] / b[0]) * b[1]) / (b[0] - b[1])


def plus_root(p, q, square, P):
    """p + q sqrt(square); exact where it is 0, as the root is rational then, or p = q = 0."""
    return plus((p, 0), times((q, 0), known_root(square, P)))


def unit_vector(v, P):
    return [quotient((x, 0), known_root(dot(v, v), P)) for x in v]


class Statements:
    """What is stated, and whether it is proved."""

    def __init__(self, claims, prefix=""):
        self.claims, self.prefix, self.lines, self.proved = claims, prefix, [], set()

    def state(self, what, law, rests=(), *arguments):
        """One statement: proved, unless something it rests on is not, or the law says why not."""
        try:
            self.rest_on(rests)
            law(*arguments)
            self.proved.add(what)
            self.lines.append((True, "proved      " + self.prefix + what))
        except NotProved as why:
            self.lines.append((False, "not proved  %s%s: %s" % (self.prefix, what, why)))

    def rest_on(self, names):
        """The other statements a proof needs."""
        for name in names:
            require(name in self.proved, "rests on the %s" % name)

    def table(self, rows):
        """The rows are t, r, e1, f2, f3 at the t of the claims, in the doubles next to the exact numbers:
        f2 = cos(theta + phi) e2 + sin(theta + phi) e3, f3 = -sin(theta + phi) e2 + cos(theta + phi) e3."""
        require(not self.frenet, "the angles are those to the Frenet frame")
        wanted = len(self.claims)
        require(len(rows) == wanted, "it has %d rows, and there are %d angles" % (len(rows), wanted))
        require(next(c for c in self.f.c if c) > 0, "the multiplier is negative at the start")
        self.rest_on_weights()
        a, b = self.first_normal()
        for k, (row, claim) in enumerate(zip(rows, self.claims), 1):
            self.rest_on([claim.text])
            require(self.is_on(claim.t), "a t is not on the path")
            r, (e1, e2, e3) = self.place(claim.t)
            C, S, off = (1, 0, 0) if self.is_zero(claim.t) or not (claim.theta or claim.radius) else cos_sin_of(claim)
            C, S, off = C * a - S * b, S * a + C * b, off * (abs(a) + abs(b))
            values = [(x, 0) for x in (claim.t, *r, *e1)]
            values += [(C * x + S * y, off * (abs(x) + abs(y))) for x, y in zip(e2, e3)]
            values += [(C * y - S * x, off * (abs(x) + abs(y))) for x, y in zip(e2, e3)]
            require_doubles(row, values, k)


def require_doubles(row, values, k):
    for name, entry, (x, error) in zip(TABLE, row, values):
        require_double(entry, x - error, x + error, "row %d, %s" % (k, name))


def cos_sin_of(claim):
    """(C, S, off): those of theta are within off of C and S."""
    require(claim.radius < 1, "the angle is known to %s only" % claim.radius)
    P = 128 + min(4096, max(0, claim.radius.denominator.bit_length() - claim.radius.numerator.bit_length()))
    n, m, error = cos_sin(claim.theta, P)
    return Fraction(n, 1 << P), Fraction(m, 1 << P), Fraction(error, 1 << P) + claim.radius


class Proof(Statements):
    """All statements of one certificate C, in the order of the page. The letters are those of the page."""

    def __init__(self, C, prefix=""):
        super().__init__(C.claims, prefix)
        self.C, self.fixed, self.sturm = C, {}, {}
        self.start, self.f, self.W = C.start, C.f, C.W
        self.frenet, self.B = C.frame == "frenet", C.bits
        self.sigma, self.h, self.g = invariants_of(C.A)
        self.xyz, self.hodograph = hodograph_of(Poly([1]), C.A), hodograph_of(C.f, C.A)
        self.K0 = common(*C.A)
        self.sigma0, self.h0, self.g0 = invariants_of([a.over(self.K0) for a in C.A])
        self.N, self.D = C.rate.numerator, C.rate.denominator
        R = C.antiderivative.rational
        K = common(R.numerator, R.denominator)
        self.P, self.Q = R.numerator.over(K), R.denominator.over(K)
        self.dP = self.P.derivative() * self.Q - self.P * self.Q.derivative()  # R' = dP/Q^2
        self.logs = C.antiderivative.logs
        for log in self.logs:
            log.q, log.c = log.index, log.residue
            log.n = divmod(log.c * log.q.derivative(), log.q)[1]  # n = c q' mod q
            for z in log.roots:
                (z.x, z.y), (z.re, z.im), z.r, z.s = z.center, z.residue, z.radius, z.residue_radius

    def run(self):
        """All statements: a list of (is proved, line)."""
        self.state("invariants", self.invariants)
        if self.C.r:
            self.state("weight", self.weight)
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
            self.state(claim.text, self.claim, ["bend"] if self.frenet else [], claim)
        for name, decision in vars(self.C.decisions).items():
            answer = "yes" if decision.answer else "no"
            self.state("decision %s: %s" % (name, answer), getattr(self, name), (), decision)
        return self.lines

    @cached_property
    def derivative(self):
        """r' in lowest terms."""
        return in_lowest_terms(self.hodograph, self.W * self.W)

    def curves(self):
        return [(*self.derivative, self.start)]

    def is_of(self, curves):
        """The curve is that of a file. Euler-Rodrigues frames are the same but for a constant turn if h/sigma is."""
        require_same(self.curves(), curves)
        *_, A = curves[0]
        if A and not self.frenet:
            require(self.has_rate(A) > 0, "its preimage, and so its Euler-Rodrigues frame, is another one")

    def has_rate(self, A):
        """Is h/sigma that of A (1), or the opposite (-1)?"""
        sigma, h, _ = invariants_of(A)
        return 1 if h * self.sigma == self.h * sigma else -1 if h * self.sigma == self.h * sigma * -1 else 0

    def invariants(self):
        """What is written is what follows from the curve. All else uses what is computed."""
        for name in ("hodograph", "sigma", "h", "g"):
            require(getattr(self.C, name) == getattr(self, name), "%s is not that of the curve" % name)

    def weight(self):
        """r = X/W has no pole on [0, 1]."""
        W = self.W.over(common(self.W, self.W.derivative()))
        require(not W.zeros(Fraction(0), Fraction(1)), "w has a zero on [0, 1]")

    def rate(self):
        """-2h = NK and sigma = DK; N and D are coprime, since they are so modulo p."""
        K, p = self.C.rate.common, self.C.rate.coprime_modulo
        require(self.h * -2 == self.N * K, "-2h is not numerator times common")
        require(self.sigma == self.D * K, "sigma is not denominator times common")
        if not self.N:
            return require(self.D.is_constant(), "the numerator is 0 and the denominator is not constant")
        N, D = self.N.primitive().c, self.D.primitive().c
        require(N[-1] % p and D[-1] % p, "the modulus divides a leading coefficient")
        require(are_coprime_modulo(N, D, p), "Euclid's algorithm modulo p does not end with a constant")

    def antiderivative(self):
        """R' + sum n/q = N/D."""
        most = max(len(a.c) for a in self.C.A)
        require(all(len(log.q.c) < 2 * most for log in self.logs), "an index has a higher degree than |A|^2")
        num, den = self.dP, self.Q * self.Q
        for log in self.logs:
            num, den = num * log.q + log.n * den, den * log.q
        require(num * self.D == self.N * den, "its derivative is not numerator/denominator")

    def roots(self, log):
        """d/2 disjoint discs above the axis for the degree d, and d |q(z)| <= r |q'(z)|: a root in each."""
        q, b, d = log.q.c, derived(log.q.c), len(log.q.c) - 1
        require(2 * len(log.roots) == d, "the degree is %d, the number of roots %d" % (d, len(log.roots)))
        for k, z in enumerate(log.roots):
            require(z.r < z.y, "disc %d is not above the real axis" % k)
            q_z, b_z = at_grid_point(q, z.x, z.y, self.B), at_grid_point(b, z.x, z.y, self.B)
            require(d * d * norm(q_z) <= z.r ** 2 * norm(b_z), "no root is proved to be in disc %d" % k)
        for (i, z), (k, w) in combinations(enumerate(log.roots), 2):
            require(apart(z, w), "discs %d and %d meet" % (i, k))

    def residues(self, log):
        """|n(z) - w q'(z)| + r (n^'(rho) + |w| q^''(rho)) <= s (|q'(z)| - r q^''(rho)), rho = |z| + r. Both
        sides are multiplied by the denominators of n and q and by a power of 2; b is q'; rho is rounded up,
        with FINE more bits. (If the right side is 0, so is the left; then r = 0 or n = w = 0: w is exact.)"""
        B, d, n = self.B, len(log.q.c) - 1, log.n
        b = [x * n.d for x in derived(log.q.c)]
        n = [x * log.q.d for x in n.c] + [0] * (d - len(n.c))
        n_hat, b_hat = ([abs(x) for x in derived(a)] for a in (n, b))
        for k, z in enumerate(log.roots):
            n_z, b_z = (at_grid_point(a, z.x, z.y, B) for a in (n, b))
            miss = root(norm(((n_z[0] << B) - z.re * b_z[0] + z.im * b_z[1],
                              (n_z[1] << B) - z.re * b_z[1] - z.im * b_z[0])), up=True)
            rho = root(norm(z.center) << 2 * FINE, up=True) + (z.r << FINE)
            n_rho, b_rho = (at_grid_point(a, rho, 0, B + FINE)[0] for a in (n_hat, b_hat))
            size, slope, shift = root(norm(z.residue), up=True), root(norm(b_z), up=False), FINE * (d - 2)
            left = (miss << shift) + z.r * ((n_rho << B) + size * b_rho)
            right = z.s * ((slope << shift) - z.r * b_rho)
            require(left <= right, "the radius of residue %d is not proved" % k)

    def bend(self):
        """g = G gamma is not 0, and gamma has coprime parts, so no real zero."""
        gamma, G = self.C.bend.polynomial, self.C.bend.content
        require(any(self.g), "g is 0, there is no Frenet frame")
        require(self.g == tuple(G * a for a in gamma), "g is not content times polynomial")
        require(common(*gamma).is_constant(), "the parts of the polynomial are not coprime")
        self.is_rmf = not self.h * -2 * norm(gamma) + self.sigma * spin(gamma)

    def turn(self, t, turn):
        """The signs and the index are right. Returns pairs (k, slope): arg gamma(t) - arg gamma(0) is the sum
        of k arctan(slope), for the slopes y/x at t and 0, and for pi; those that are 0 are left out."""
        signs_found, index, terms = change_of_argument(*self.C.bend.polynomial, t, self.sturm)
        require(signs_found == turn.signs, "the signs at 0 and t are %s and %s" % tuple(signs_found))
        require(index == turn.index, "the index is %d" % index)
        return [(k, slope) for k, slope in terms if k and slope]

    def claim(self, claim):
        """|theta(t) - theta| <= radius. theta(0) = 0; theta_Frenet is 0 if that frame minimizes."""
        t, theta, radius = claim.t, claim.theta, claim.radius
        turn = self.turn(t, claim.turn) if self.frenet else []
        if t == 0 or self.frenet and self.is_rmf:
            return require(abs(theta) <= radius, "the angle is 0")
        self.rest_on(self.needed)
        require(self.Q(t) and self.Q(0), "the denominator of the rational part is 0 at t or at 0")
        distance = self.P(t) / self.Q(t) - self.P(0) / self.Q(0) - theta  # from theta, of the rational part
        roots = [z for log in self.logs for z in log.roots]
        require(radius > 0 or not roots, "the radius is 0, and there are logarithms")
        ask = max(0, radius.denominator.bit_length() - radius.numerator.bit_length()) + 64
        ask += max(0, sum(abs(z.re) + abs(z.im) for z in roots).bit_length() - self.B)
        for bits in (min(ask, 4096), ask + 256):
            n, rounding, error = self.angle(t, roots, turn, bits)
            unit = Fraction(1, 1 << (bits + self.B))
            least, greatest = (distance + x * unit for x in (n - rounding - error, n + rounding + error))
            if -radius <= least and greatest <= radius:
                return
            require(-radius <= greatest and least <= radius, "the angle is not that")
            require(2 * rounding > error >> 16, "the discs are too large")
        raise NotProved("the angle is too close to the end of the interval")

    def angle(self, t, roots, turn, bits):
        """(n, rounding, error): theta(t) - R(t) + R(0) computed at the centres is within rounding of n, and
        differs from the true one by at most error; all times 2^(bits + B). With L = log(1 - t/zeta) a root
        adds 2 Re(c L), and |dL/dzeta| = |t|/|zeta (t - zeta)|. So the disc of the root is worth 2 (|w| + s) r
        |t|/((|z| - r)(|t - z| - r)) and that of the residue 2 s |L| <= s (|ln| + 2 |arctans|)."""
        if bits not in self.fixed:
            self.fixed[bits] = Fixed(bits)
        fixed, n, rounding, error = self.fixed[bits], 0, 0, 0
        for z in roots:
            a, b = (t.numerator << self.B) - t.denominator * z.x, t.denominator * z.y  # t - x, y, scaled
            far, near = norm((a, b)), norm(z.center)
            logarithm, ln_error = fixed.ln(far, near * t.denominator ** 2)
            arctans, arctans_error = fixed.arctan(a, b) + fixed.arctan(z.x, z.y), 50 * bits
            n += z.re * logarithm - 2 * z.im * arctans
            rounding += abs(z.re) * ln_error + 2 * abs(z.im) * arctans_error
            to_t = root(far << 2 * FINE, up=False) - (z.r * t.denominator << FINE)
            to_0 = root(near << 2 * FINE, up=False) - (z.r << FINE)
            require(to_t > 0 and to_0 > 0, "the discs are too large")
            worth = 2 * (root(norm(z.residue), up=True) + z.s) * z.r * abs(t.numerator)
            error += -(-(worth << (2 * FINE + bits + self.B)) // (to_t * to_0))  # rounded up
            error += z.s * (abs(logarithm) + ln_error + 2 * (abs(arctans) + arctans_error))
        for k, slope in turn:
            n += k * fixed.arctan(slope.numerator, slope.denominator) << self.B
            rounding += abs(k) * 25 * bits << self.B
        return n, rounding, error

    def axes(self, t):
        """A i A*, A j A* and A k A* over |A|^2 at t, of A without its zeros."""
        u, v, p, q = (a.over(self.K0)(t) for a in self.C.A)
        uu, vv, pp, qq = u * u, v * v, p * p, q * q
        rows = ((uu + vv - pp - qq, 2 * (u * q + v * p), 2 * (v * q - u * p)),
                (2 * (v * p - u * q), uu - vv + pp - qq, 2 * (u * v + p * q)),
                (2 * (u * p + v * q), 2 * (p * q - u * v), uu - vv - pp + qq))
        return [[x / (uu + vv + pp + qq) for x in row] for row in rows]

    def first_normal(self):
        """(cos phi, sin phi) of the angle phi of f2(0) to e2(0). It is where the least rotation that takes the x
        axis to e1(0) = (a, b, c) takes the y axis: (-b, a + c^2/(1 + a), -bc/(1 + a))."""
        (a, b, c), e2, e3 = self.axes(Fraction(0))
        require(a != -1, "the tangent at the start is -x")
        f2 = -b, a + c * c / (1 + a), -b * c / (1 + a)
        return tuple(sum(x * y for x, y in zip(f2, e)) for e in (e2, e3))

    def place(self, t):
        """r and (e1, e2, e3) at t, where W is not 0."""
        if self.C.r:
            return [x(t) / self.W(t) for x in self.C.r[:3]], self.axes(t)
        return [x + a(t) for x, a in zip(self.start, self.integrals)], self.axes(t)

    @cached_property
    def integrals(self):
        return [integral_of(a) for a in self.hodograph]

    def is_zero(self, t):
        return t == 0 or not self.N

    def is_on(self, t):
        return not self.C.r or 0 <= t <= 1

    def rest_on_weights(self):
        self.rest_on(["weight"] if self.C.r else [])

    # The decisions: x, y, z stand for A i A*, and each law is that of the page's table.

    def regular(self, decision):
        check_points(self.f * self.K0 * self.K0, decision.cusps, "cusps")
        require(decision.answer == (not decision.cusps), "cusps and answer contradict each other")

    def inflections(self, decision):
        check_points(common(*self.g0), decision.points, "points")
        require(decision.answer == bool(decision.points), "points and answer contradict each other")

    def line(self, decision):
        if not decision.answer:
            return require(rank(self.xyz) >= 2, "no two of x, y, z are independent")
        require(any(decision.direction), "the direction is 0")
        pairs = combinations(zip(self.xyz, decision.direction), 2)
        require(all(a * l == b * k for (a, k), (b, l) in pairs), "x, y, z are not multiples of the direction")

    def dot(self, vector):
        """vector . (x, y, z)"""
        return reduce(Poly.__add__, (a * k for a, k in zip(self.xyz, vector)))

    def planar(self, decision):
        if not decision.answer:
            return require(rank(self.xyz) == 3, "x, y, z are dependent")
        require(any(decision.normal), "the normal is 0")
        require(not self.dot(decision.normal), "the normal is not orthogonal to (x, y, z)")

    def helical(self, decision):
        if not decision.answer:
            is_other = rank(self.xyz) < 3 or rank(self.xyz + [self.sigma]) == 4
            return require(is_other, "sigma depends on x, y, z")
        require(rank(self.xyz) == 3, "x, y, z are dependent")
        require(any(decision.axis), "the axis is 0")
        along, square = self.dot(decision.axis), decision.cos_squared * sum(a * a for a in decision.axis)
        require(along * along == self.sigma * self.sigma * square, "the angle to the axis is another")

    def double_ph(self, decision):
        """False: a = constant s^2 would make every a(k) a[-1] a square. (Where all are, a is such a one.)"""
        if decision.answer:
            is_square = norm(self.g) * 4 == decision.omega * decision.omega * decision.constant
            return require(is_square, "4|g|^2 is not constant omega^2")
        a = norm(self.g).primitive()
        values = (int(a(k)) * a.c[-1] for k in range(100 if a else 0))
        require(any(x < 0 or isqrt(x) ** 2 != x for x in values), "4|g|^2 seems a constant times a square")

    def primitive(self, decision):
        require(decision.content, "the content is 0")
        parts = [a.over(decision.content) for a in self.derivative[0]]
        require(common(*parts).is_constant(), "the content is not the greatest common divisor")
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
            return require(is_angle, "2 arg w is not the angle")
        self.rest_on(self.needed)
        is_found, one = bool(self.dP), 1 << self.B
        for log in self.logs:
            others = [z for other in self.logs if other is not log for z in other.roots]
            for z in log.roots:
                above = z.im % one  # the height of the centre above the next lower point of iZ
                is_off = norm((z.re, min(above, one - above))) > z.s ** 2
                is_found = is_found or is_off and all(apart(z, w) for w in others)
        require(is_found, "the rational part is constant, and no residue is proved to be outside iZ")

    def erf_monotone(self, decision):
        """The zeros of N, then the real ones of (h W^2/(f sigma^2))' = (h0 W^2/(f K0^2 sigma0^2))', where sigma0
        has none (u, v, p, q of A0 would be 0 there). With H/e = h0 W^2/(f K0^2) in lowest terms the derivative is
        (H' e sigma0 - H (e' sigma0 + 2 e sigma0'))/(e^2 sigma0^3). At a zero of e of order k the numerator
        has the order k - 1, as has gcd(e, e'), by which it is divided."""
        self.rest_on(["rate"])
        check_points(self.N, decision.zeros_of_h, "zeros_of_h")
        turns = any(a.order % 2 and not any(a.low < t < a.high and a.w(t) == 0 for t in (0, 1))
                    for a in decision.zeros_of_h)  # a zero of odd order, neither at 0 nor at 1
        require(decision.answer == (not turns), "zeros_of_h and answer contradict each other")
        e, sigma = self.f * self.K0 * self.K0, self.sigma0
        H = self.h0 * self.W * self.W
        K = common(H, e)
        H, e = H.over(K), e.over(K)
        P = H.derivative() * e * sigma - H * (e.derivative() * sigma + e * sigma.derivative() * 2)
        check_points(P.over(common(e, e.derivative())), decision.extrema, "extrema", odd_only=True)


def require_same(own, curves):
    """Both have the same r' and r(0)."""
    require(hash_of(own) == hash_of(curves), "that one has sha256 %s" % hash_of(curves))


class PathProof(Statements):
    """All statements of the certificate P of a path: those of its segments, its joints, and sums of angles."""

    frenet = False

    def __init__(self, P):
        super().__init__(P.claims)
        self.C, self.is_smooth = P, True
        self.parts = [Proof(C, "segment %d: " % k) for k, C in enumerate(P.segments)]
        self.f, self.first_normal = self.parts[0].f, self.parts[0].first_normal

    def curves(self):
        return [curve for part in self.parts for curve in part.curves()]

    def is_of(self, curves):
        """Behind a joint, where the frame goes on, it does not matter which way a preimage is turned over."""
        require_same(self.curves(), curves)
        found = [part.has_rate(A) if A else 1 for part, (*_, A) in zip(self.parts, curves)]
        require(all(found) and found[0] > 0, "its preimage, and so its Euler-Rodrigues frame, is another one")

    def run(self):
        """All statements: a list of (is proved, line)."""
        for part in self.parts:
            self.lines += part.run()
            part.has_angles = all(claim.text in part.proved for claim in part.claims)
        for k in range(1, len(self.parts)):
            self.state("joint %d" % k, self.joint, (), *self.parts[k - 1:k + 1])
        self.sums = self.sums_to_joints()
        for claim in self.claims:
            self.state(claim.text, self.claim, (), claim)
        if self.C.values is not None:
            self.lines += ClosedProof(self).run(**self.C.values)
        return self.lines

    def joint(self, before, after):
        """r goes on, and the rotation from the one frame to the other, A1 conj(A0) of the preimages without their zeros, has
        an axis normal to e1, so that it is the least one: conj(A0) A1 = c + yj + zk, c != 0."""
        require(before.W(1), "the weight of the segment before is 0 at its end")
        end, _ = before.place(Fraction(1))
        require(end == list(after.start), "the segment does not begin where the one before ends")
        (a, b, c, d), (u, v, p, q) = ([x.over(part.K0)(t) for x in part.C.A] for part, t in ((before, 1), (after, 0)))
        is_carried = a * v - b * u - c * q + d * p == 0 and a * u + b * v + c * p + d * q != 0
        require(is_carried, "the Euler-Rodrigues frame does not go on")
        if a * p + b * q != c * u + d * v or a * q + c * v != b * p + d * u:
            self.is_smooth = False
            sides = sign_before_one(before.f) * next(x for x in after.f.c if x)
            require(sides > 0, "the tangent changes its side at the corner")

    def is_joined(self, k):
        return all("joint %d" % j in self.proved for j in range(1, k + 1))

    def sums_to_joints(self):
        """(theta, radius) at 0, 1, ... up to where the segments claim them."""
        sums = [(0, 0)]
        for part in self.parts[:-1]:
            whole = next((claim for claim in part.claims if claim.t == 1), None)
            if whole is None:
                break
            sums.append((sums[-1][0] + whole.theta, sums[-1][1] + whole.radius))
        return sums

    def at(self, t):
        """The number of the segment, and t there."""
        k = min(len(self.parts) - 1, t.numerator // t.denominator)
        return k, t - k

    def claim(self, claim):
        """theta(t) is the sum of those of the segments up to there, its radius at least that of theirs."""
        require(0 <= claim.t <= len(self.parts), "t is not on the path")
        theta, radius = self.sum_to(*self.at(claim.t))
        require(abs(theta - claim.theta) + radius <= claim.radius, "it does not follow from the angles of the segments")

    def sum_to(self, k, t):
        """(theta, radius) at t of segment k."""
        require(self.is_joined(k), "rests on the joints")
        for j, part in enumerate(self.parts[:k + (t != 0)]):
            require(part.has_angles, "rests on the angles of segment %d" % j)
        last = next((c for c in self.parts[k].claims if c.t == t), None) if t else SimpleNamespace(theta=0, radius=0)
        require(last and k < len(self.sums), "the segments do not claim the angles that it is the sum of")
        theta, radius = self.sums[k]
        return theta + last.theta, radius + last.radius

    def place(self, t):
        k, t = self.at(t)
        return self.parts[k].place(Fraction(t))

    def is_on(self, t):
        return 0 <= t <= len(self.parts)

    def rest_on_weights(self):
        for part in self.parts:
            part.rest_on_weights()

    def is_zero(self, t):
        return t <= next((k for k, part in enumerate(self.parts) if part.N), len(self.parts))

    def table(self, rows):
        require(self.is_joined(len(self.parts) - 1), "rests on the joints")
        super().table(rows)


def halves(c):
    """The Bernstein coefficients on [0, 1/2] and [1/2, 1] of those on [0, 1], times 2^n."""
    n, left, right = len(c) - 1, [], []
    for k in range(n + 1):
        left.append(c[0] << (n - k))
        right.append(c[-1] << (n - k))
        c = [x + y for x, y in zip(c, c[1:])]
    return left, right[::-1]


def bernstein_of(polys, low, high):
    """The Bernstein coefficients on [low, high], times one positive number: integers."""
    n, lists = max(1, *(len(a.c) - 1 for a in polys)), []
    for a in polys:
        c = [x / a.d for x in translated([Fraction(x) for x in a.c], low)]
        c = [x * (high - low) ** k / comb(n, k) for k, x in enumerate(c)] + [Fraction(0)] * (n + 1 - len(c))
        b = []
        while c:
            b.append(c[0])
            c = [x + y for x, y in zip(c, c[1:])]
        lists.append(b)
    common = reduce(lambda d, x: d * x.denominator // gcd(d, x.denominator), (x for b in lists for x in b), 1)
    return [[x.numerator * (common // x.denominator) for x in b] for b in lists]


class Arc:
    """A part of a segment as it is seen along v: Bernstein coefficients of (x, y, z, w), where (x, y)/w is the place and
    z/w the height, and of (dx, dy), which is along the derivative; each up to a positive factor. While the w are
    positive, the part is in the convex hull of the (x, y)/w, and its direction in the cone of the (dx, dy)."""

    def __init__(self, place, slope):
        self.place, self.slope = place, slope

    @cached_property
    def points(self):
        """The x/w, y/w and z/w; none where a w is not positive."""
        *lists, w = self.place
        return [[Fraction(a, b) for a, b in zip(x, w)] for x in lists] if all(b > 0 for b in w) else None

    @cached_property
    def box(self):
        return [(min(x), max(x)) for x in self.points or ()]

    @cached_property
    def slopes(self):
        return list(zip(*self.slope))

    def halves(self):
        place, slope = (zip(*map(halves, lists)) for lists in (self.place, self.slope))
        return [Arc(*part) for part in zip(place, slope)]

    @cached_property
    def bits(self):
        return max(x.bit_length() for lists in self.place + self.slope for x in lists)


def cross_in_plane(a, b):
    return a[0] * b[1] - a[1] * b[0]


def is_forward(*arcs):
    """Do the arcs, each from the end of the one before, stay within a right angle of where they start?"""
    (x, y), slopes = arcs[0].slopes[0], [s for arc in arcs for s in arc.slopes]
    return all(x * dx + y * dy > 0 for dx, dy in slopes)


def are_apart(a, b):
    """Do the boxes around their places not meet?"""
    return any(p[1] < q[0] or q[1] < p[0] for p, q in zip(a.box[:2], b.box[:2]))


def is_between_ends(arc, other):
    """Is the arc strictly between the lines through the ends of the other one along the chord of this?"""
    places, ends = list(zip(*arc.points)), list(zip(*other.points))
    chord = [b - a for a, b in zip(places[0], places[-1])]
    sides = [{(s > 0) - (s < 0) for s in (cross_in_plane(chord, (p[0] - e[0], p[1] - e[1])) for p in places)}
             for e in (ends[0], ends[-1])]
    return sides in ([{1}, {-1}], [{-1}, {1}])


def gamma_of(A, k):
    """|A|^2 (k.e2 + i k.e3) for a vector k."""
    u, v, p, q = A
    e2 = (v * p - u * q) * 2, u * u - v * v + p * p - q * q, (u * v + p * q) * 2
    e3 = (u * p + v * q) * 2, (p * q - u * v) * 2, u * u - v * v - p * p + q * q
    return [reduce(Poly.__add__, (a * x for a, x in zip(e, k))) for e in (e2, e3)]


class ClosedProof(Statements):
    """What is said of a closed path: that it is closed, its holonomy and its writhe."""

    def __init__(self, path):
        super().__init__([])
        self.path, self.parts, self.work = path, path.parts, 0

    def run(self, holonomy=None, writhe=None):
        self.state("closed", self.closed)
        if holonomy:
            self.state(holonomy.text, self.holonomy, ["closed"], holonomy)
        if writhe:
            self.state("crossings", self.crossings, ["closed"], writhe)
            self.state(writhe.text, self.writhe, ["crossings"], writhe)
        return self.lines

    def closed(self):
        """The last segment ends where the first begins, and there the preimages without their zeros are the same but for
        a factor c + si, so that the frame of the last is that of the first, turned by 2 arg(c + si)."""
        first, last = self.parts[0], self.parts[-1]
        require(self.path.is_joined(len(self.parts) - 1), "rests on the joints")
        self.path.rest_on_weights()
        require(next(c for c in first.f.c if c) > 0, "the multiplier is negative at the start")
        require(last.place(Fraction(1))[0] == list(first.start), "the path does not end where it begins")
        (a, b, c, d), (u, v, p, q) = ([x.over(part.K0)(t) for x in part.C.A] for part, t in ((first, 0), (last, 1)))
        is_along = a * p + b * q == c * u + d * v and a * q + c * v == b * p + d * u
        require(is_along, "the tangent at the end is not that at the start")
        self.back = a * u + b * v + c * p + d * q, a * v - b * u - c * q + d * p

    def holonomy(self, holonomy):
        """theta(end) + 2 arg(c + si) + 2 pi turns, 2 arg(c + si) being 2 arctan(s/c), or pi."""
        (theta, P), (c, s) = self.path.sum_to(len(self.parts) - 1, 1), self.back
        terms = [(2, s / c) if c else (4, 1), (8 * holonomy.turns, 1)]
        self.require_within(holonomy.radius, [(theta - holonomy.value, terms, P - holonomy.radius)] * 2)

    def writhe(self, writhe):
        """linking + (theta(end) - the change of arg gamma)/2 pi, gamma = v.e2 + i v.e3."""
        (theta, P), terms = self.path.sum_to(len(self.parts) - 1, 1), []
        for part in self.parts:
            gamma = gamma_of([a.over(part.K0) for a in part.C.A], writhe.projection)
            K = common(*gamma)
            terms += [(-k, slope) for k, slope in change_of_argument(*(a.over(K) for a in gamma), Fraction(1), {})[2]]
        rest = sum(crossing.sign for crossing in writhe.crossings) - writhe.value
        self.require_within(writhe.radius, [(theta, terms + [(8 * (rest + r), 1)], P)
                                            for r in (-writhe.radius, writhe.radius)])

    def require_within(self, radius, sides):
        """x + P <= 0 for the first of (x, P), and x - P >= 0 for the second, where x = (rest, terms) is the sum of rest
        and k arctan(slope) of the terms (k, slope). Nothing is rounded where these cancel. At first all is known to a
        part of itself, which tells where a stated number is much too great."""
        ask = max(0, radius.denominator.bit_length() - radius.numerator.bit_length()) + 64
        for sign, (rest, terms, P) in zip((1, -1), sides):
            factors = {}
            for k, slope in terms:
                factors[abs(slope)] = factors.get(abs(slope), 0) + (k if slope >= 0 else -k)
            factors = {slope: k for slope, k in factors.items() if k and slope}
            size = sum(map(abs, factors.values()))
            for bits in (64, *(bits + int(size).bit_length() for bits in (min(ask, 4096), ask + 256))):
                n = sum(k * self.arctan(slope, bits) for slope, k in factors.items())
                value, off = sign * (rest + Fraction(n) / (1 << bits)) + P, 25 * bits * Fraction(size) / (1 << bits)
                require(value - off <= 0, "it is another one")
                if value + off <= 0:
                    break
            require(value + off <= 0, "it is too close to the end of the interval")

    @cache
    def arctan(self, slope, bits):
        return Fixed(bits).arctan(slope.numerator, slope.denominator)

    def spend(self, work):
        self.work += work
        require(self.work <= MAX_PARTS, "parts of the curve are too close to each other, as they are seen along v")

    def arc(self, k, v, low, high):
        """The part of segment k, seen along v."""
        part, m = self.parts[k], max(m for m in range(3) if v[m])
        X, W = part.C.r[:3] if part.C.r else [a + Poly([1]) * s for a, s in zip(part.integrals, part.start)], part.W

        def seen(a):
            return [(a[n] * v[m] - a[m] * v[n]) * (1 if v[m] > 0 else -1) for n in ((m + 1) % 3, (m + 2) % 3)]
        place = [*seen(X), reduce(Poly.__add__, (a * x for a, x in zip(X, v))), W]
        place, slope = [a * (1 if W(0) > 0 else -1) for a in place], seen(part.hodograph)
        self.spend(3000 * max(len(a.c) for a in place + slope) ** 2)
        return Arc(bernstein_of(place, low, high), bernstein_of(slope, low, high))

    def crossing(self, crossing, v):
        """In the box there is one crossing of the two arcs, and it has that sign. They turn one way everywhere, so that
        they cross once at most: else vectors in the two cones would be parallel. They do cross, by the theorem of
        Poincare and Miranda, since the ends of each are on both sides of the other."""
        arcs = crossing.first, crossing.second
        for arc in arcs:
            low, high = arc.interval
            require(arc.segment < len(self.parts) and 0 <= low < high <= 1, "a box is not on the curve")
        order = [(arc.segment, t) for arc in arcs for t in arc.interval]
        require(order == sorted(order), "the parts of a box are not one behind the other")
        a, b = (self.arc(arc.segment, v, *arc.interval) for arc in arcs)
        self.spend(1000 * len(a.slopes) * len(b.slopes))
        turns = {(s > 0) - (s < 0) for s in (cross_in_plane(x, y) for x in a.slopes for y in b.slopes)}
        require(turns in ({1}, {-1}), "the arcs of a box may be parallel")
        require(a.box and b.box and is_between_ends(a, b) and is_between_ends(b, a), "the arcs of a box may not cross")
        (low, high), (least, most) = a.box[2], b.box[2]
        require(low > most or high < least, "it is not told which arc of a box is above the other")
        require(crossing.sign == turns.pop() * (1 if low > most else -1), "a crossing has the other sign")

    def crossings(self, writhe):
        """All crossings are listed: each two parts are apart, or in a box, or go on for less than a right angle."""
        require(self.path.is_smooth, "the path has corners")
        v, boxes = writhe.projection, {}
        for crossing in writhe.crossings:
            self.crossing(crossing, v)
            box = [*crossing.first.interval, *crossing.second.interval]
            others = boxes.setdefault((crossing.first.segment, crossing.second.segment), [])
            self.spend(5000 * len(others))
            is_other = all(a >= other[1] or other[0] >= b or c >= other[3] or other[2] >= d
                           for a, b, c, d in [box] for other in others)
            require(is_other, "two boxes meet")
            others.append(box)
        arcs = {k: self.arc(k, v, 0, 1) for k in range(len(self.parts))}
        pairs, depth = list(combinations_with_replacement(arcs, 2)), 0
        while pairs:
            pairs = [pair for pair in pairs if not self.is_told(*pair, arcs, depth, boxes)]
            depth, numbers = depth + 1, sorted({k for pair in pairs for k in pair})
            require(depth <= MAX_HALVINGS or not pairs, "parts of the curve meet, as they are seen along v")
            for k in numbers:
                self.spend(100000 + 500 * len(arcs[k].slopes) ** 2 * (1 + arcs[k].bits // 256))
            arcs = {2 * k + side: arc for k in numbers for side, arc in enumerate(arcs[k].halves())}
            pairs = [(a, b) for i, j in pairs for a in (2 * i, 2 * i + 1) for b in (2 * j, 2 * j + 1) if a <= b]

    def is_told(self, i, j, arcs, depth, boxes):
        a, b, count = arcs[i], arcs[j], len(self.parts) << depth
        self.spend(10000)
        if i == j:
            return is_forward(a)
        if (i + 1) % count == j or (j + 1) % count == i:
            return is_forward(a, b) if i + 1 == j else is_forward(b, a)
        if are_apart(a, b):
            return True
        others = boxes.get((i >> depth, j >> depth), [])
        self.spend(4000 * len(others))
        (low, high), (least, most) = ((Fraction(k % (1 << depth), 1 << depth), Fraction(k % (1 << depth) + 1, 1 << depth))
                                      for k in (i, j))
        return any(x <= low and high <= y and z <= least and most <= w for x, y, z, w in others)


class IntegralProof(Statements):
    """All statements of the certificate P of a path of rational curves: that its segments are joined, and enclosures of
    the integral of a rate N/(D sqrt(S)) on pieces, added up to angles to a frame or to lengths."""

    def __init__(self, P):
        super().__init__(P.claims)
        self.C, self.parts, self.frame = P, P.segments, P.frame
        self.up = getattr(P, "up", None)

    def curves(self):
        return [form_of_texts(C.texts) if hasattr(C, "texts") else
                (*in_lowest_terms(C.velocity, C.W * C.W), [x(0) / C.W(0) for x in C.X]) for C in self.parts]

    def is_of(self, curves):
        require_same(self.curves(), curves)

    def run(self):
        """All statements: a list of (is proved, line)."""
        for k, C in enumerate(self.parts):
            if hasattr(C, "texts"):
                C.needed = ["pieces of segment %d" % k]
                self.state_joint(k)
                self.state(C.needed[0], self.pieces, (), C)
                continue
            names = ["%s of segment %d" % (what, k) for what in ("weight", "rate", "pieces")]
            C.needed = names[1:] if C.W.is_constant() else names
            if not C.W.is_constant():
                self.state(names[0], self.weight, (), C)
            self.state_joint(k)
            self.state(names[1], self.rate, (), C)
            self.state(names[2], self.pieces, names[1:2], C)
        for claim in self.claims:
            self.state(claim.text, self.claim, (), claim)
        return self.lines

    def weight(self, C):
        """r = X/W has no pole on [0, 1]."""
        W = C.W.over(common(C.W, C.W.derivative()))
        require(not W.zeros(Fraction(0), Fraction(1)), "w has a zero on [0, 1]")

    def state_joint(self, k):
        """Beside formulas its name says how near to each other the ends are told to be."""
        if k == 0:
            return
        before, after = self.parts[k - 1:k + 1]
        beside = [C.pieces[at].bits if C.pieces else 0 for C, at in ((before, -1), (after, 0)) if hasattr(C, "texts")]
        after.joint = "joint %d" % k + (", to 2^-%d" % (min(beside) // 2) if beside else "")
        law = (self.joint_of_formulas, before, after, min(beside)) if beside else (self.joint, before, after)
        self.state(after.joint, law[0], (), *law[1:])
        after.needed.append(after.joint)

    def joint_of_formulas(self, before, after, bits):
        """r and the frame of v go on, as far as models of that many bits tell. e1 has the side to r' that it had."""
        side = before.side if hasattr(before, "texts") else 1 if sign_before_one(before.f) > 0 else -1
        if hasattr(after, "texts"):
            after.side = side
        elif side < 0:
            after.f, after.H = after.f * -1, [a * -1 for a in after.H]
        models = Models(2, bits)
        (end, a, A), (start, b, B) = self.end(before, 1, models), self.end(after, 0, models)
        for P, r in map(models.minus, start, end):
            require(lengths(P) + r <= 1 << bits - bits // 2, "the segment does not begin where the one before ends")
        if self.frame != "none":
            P, r = self.turn_of_models(models, a, b) if self.frame == "up" else self.turn_of_frenet(models, a, b, A, B)
            n = P[0] if P else 0
            after.turn = lambda _: (Fraction(n - r, 1 << bits), Fraction(n + r, 1 << bits))

    def end(self, C, t, models):
        """r and a vector along e1 where a segment ends, for t = 1, or begins, for t = 0; with the Frenet frame one along the binormal, too."""
        is_frenet = self.frame == "frenet"
        if hasattr(C, "texts"):
            jets = Jets(models, 1)
            ends = jets.values(C.ends, None)
            a, b = (ends[C.steps[key]][0] for key in ENDS)
            jets.J += is_frenet
            values = jets.values(C.f, [b if t else a, models.minus(b, a)] + [([], 0)] * is_frenet)
            place, slope, *bend = ([values[C.steps[key]][j] for key in AXES] for j in range(jets.J + 1))
            slope = [models.scaled(x, Fraction(C.side)) for x in slope]
            return place, slope, models.cross(slope, bend[0]) if is_frenet else None
        require(C.W(t), "the weight of the segment before is 0 at its end")
        binormal = self.over_greatest([a(t) for a in self.binormal(C)[1]], models) if is_frenet else None
        return [models.number(x(t) / C.W(t)) for x in C.X], self.over_greatest([a(t) for a in C.H], models), binormal

    def over_greatest(self, vector, models):
        """The vector over the greatest absolute value of its components; 0 remains 0."""
        most = max(map(abs, vector)) or 1
        return [models.number(Fraction(x) / most) for x in vector]

    def turn_of_models(self, m, a, b):
        """By how much the angle to the frame of v grows where the least rotation takes e1 from along a to along b. Of unit vectors
        v x a becomes v x a - det(v, a, b)(a + b)/(1 + a.b), times 1 + a.b, whose components along v x b and b x (v x b) are C and -S."""
        a, b = self.units(m, a, b)
        v = self.over_greatest(self.up, m)
        d = m.dot(v, m.cross(a, b))
        C = m.plus(m.times(m.dot(m.cross(v, a), m.cross(v, b)), m.plus(m.number(Fraction(1)), m.dot(a, b))), m.times(d, d))
        S = m.times(d, m.plus(m.dot(v, a), m.dot(v, b)))
        size = m.root(m.plus(m.times(C, C), m.times(S, S)))
        return m.scaled(m.atan(m.times(S, m.inverse(m.plus(size, C)))), Fraction(-2))

    def units(self, m, *vectors):
        return [[m.times(x, size) for x in c] for c, size in ((c, m.inverse(m.root(m.dot(c, c)))) for c in vectors)]

    def turn_of_frenet(self, m, a, b, A, B):
        """The same of the Frenet frame with the binormals A and B, up to half a turn: A becomes A - (A.b)(a + b)/(1 + a.b), times 1 + a.b,
        whose components along B and b x B are C and S."""
        a, b, A, B = self.units(m, a, b, A, B)
        c, along = m.plus(m.number(Fraction(1)), m.dot(a, b)), m.dot(A, b)

        def part(w):
            return m.minus(m.times(c, m.dot(A, w)), m.times(along, m.plus(m.dot(a, w), m.dot(b, w))))
        m.least(c, "the tangent turns back")
        return m.atan(m.times(part(m.cross(b, B)), m.inverse(part(B))))

    def joint(self, before, after):
        """r goes on, and with an angle the frame, too; then e1 is H/|H| with the sign that goes on, at a corner with that
        which e1 has to r'. The frame of v turns there, and is nowhere undefined."""
        require(before.W(1), "the weight of the segment before is 0 at its end")
        end = [x(1) / before.W(1) for x in before.X]
        require(end == [x(0) / after.W(0) for x in after.X], "the segment does not begin where the one before ends")
        if self.frame == "none":
            return
        x, y = [a(1) for a in before.H], [a(0) for a in after.H]
        is_corner = any(cross(x, y))
        if (sign_before_one(before.f) if is_corner else dot(x, y)) < 0:
            after.f, after.H, y = after.f * -1, [a * -1 for a in after.H], [-a for a in y]
        if self.frame == "up":
            require(any(cross(self.up, x)) and any(cross(self.up, y)), "v is along the tangent")
            if is_corner:
                after.turn = turn_at_corner(self.up, x, y)
        else:
            x, y = ([a(t) for a in self.binormal(C)[1]] for C, t in ((before, 1), (after, 0)))
            require(not any(cross(x, y)), "the Frenet frame does not go on")

    def binormal(self, C):
        """(g, B) with H x H' = g B, the parts of B coprime; found once."""
        if not hasattr(C, "bend"):
            b = cross(C.H, [a.derivative() for a in C.H])
            g = common(*b)
            C.bend = g, [a.over(g) for a in b] if g else None
        require(C.bend[0], "a straight line has no Frenet frame")
        return C.bend

    def rate(self, C):
        """N/(D sqrt(S)) for |H|^2 = c^2 S."""
        H, c = C.H, C.square
        require(c(0) > 0, "square is not positive at t = 0")
        S = dot(H, H).over(c * c)
        if self.frame == "none":
            N, D = C.f * c * S, C.W * C.W
        elif self.frame == "up":
            v = [Poly([x.numerator], x.denominator) for x in map(Fraction, self.up)]
            across = cross(v, H)
            N, D = dot(v, H) * dot(across, [a.derivative() for a in H]) * -1, dot(across, across) * c
        else:
            g, B = self.binormal(C)
            N, D = dot(B, [a.derivative().derivative() for a in H]).over(g) * c * S * -1, dot(B, B)
        C.rate = N, D, S

    def pieces(self, C):
        """Bounds of the integral from 0 to the start of each, and from there to any t in it."""
        C.enclosed, start, low, high = [], Fraction(0), 0, 0
        for k, piece in enumerate(C.pieces):
            require(start < piece.to <= 1, "piece %d is empty, or ends beyond 1" % k)
            bounds = (self.enclosure_of_formulas if hasattr(C, "texts") else self.enclosure)(C, k, piece, start)
            C.enclosed.append((start, low, high, bounds))
            start, (low, high) = piece.to, (x + y for x, y in zip((low, high), bounds(piece.to)))
        require(start == 1 or not hasattr(C, "texts"), "the pieces end before 1")
        C.enclosed.append((start, low, high, None))

    def enclosure(self, C, k, piece, start):
        """With t = m + hz, u the root and p the rate, functions of z in [-1, 1]: |1 - S u^2| <= delta makes u sqrt(S) the
        root of a number between 1 - delta and 1 + delta, so that N/(D sqrt(S)) differs from N u/D by |N u/D| delta/(1 -
        delta) at most, and that from p by |N u - D p|/|D|."""
        m, h = (start + piece.to) / 2, (piece.to - start) / 2
        N, D, S = (on_piece(a, m, h) for a in C.rate)
        u, p = Poly(piece.root, 1 << piece.root_bits), Poly(piece.rate, 1 << piece.rate_bits)
        delta, least = size(Poly([1]) - S * u * u), 2 * D(0) - size(D)
        require(delta < 1 and u(0) > 0, "the root of piece %d is too far off" % k)
        require(least > 0, "the denominator is not proved to be positive on piece %d" % k)
        Nu = N * u
        error = (size(Nu - D * p) + size(Nu) * delta / (1 - delta)) / least
        sign = sign_on_piece(C.f, m, h) if self.frame == "none" else 1
        return self.integral_bounds(p, error, sign, m, h, piece.rate_bits)

    def integral_bounds(self, p, error, sign, m, h, bits):
        """Of the integral of the rate that p is within `error` but for its sign, from m - h to t, as a function of t."""
        F, grid = integral_of(p), 1 << bits + 64 + h.denominator.bit_length()

        def bounds(t):
            value, off = h * (F((t - m) / h) - F(Fraction(-1))) * sign, error * (t - m + h)
            low, high = (value - off, value + off) if sign else (0, (size(p) + error) * (t - m + h))
            return Fraction(low * grid // 1, grid), Fraction(-(-high * grid // 1), grid)
        return bounds

    def enclosure_of_formulas(self, C, k, piece, start):
        """The same of the rate that follows from the formulas, as a Taylor model: r_j is the j-th derivative of r over j!."""
        m, h, models = (start + piece.to) / 2, (piece.to - start) / 2, Models(piece.order, piece.bits)
        require(piece.to - start >= Fraction(1, MAX_PIECES), "piece %d is too short" % k)
        jets = Jets(models, JETS[self.frame])
        ends = jets.values(C.ends, None)
        a, b = (ends[C.steps[key]][0] for key in ENDS)
        t, span = models.plus(models.number(m), models.scaled(([0, 1 << piece.bits], 0), h)), models.minus(b, a)
        s = [models.plus(a, models.times(span, t)), span] + [([], 0)] * (jets.J - 1)
        values = jets.values(C.f, s)
        r = [[values[C.steps[key]][j] for key in AXES] for j in range(jets.J + 1)]
        S = models.dot(r[1], r[1])
        require(models.least(S, "r' may be 0 on piece %d" % k) << 1000 >= 1 << piece.bits, "r' is too small on piece %d" % k)
        root = models.root(S)
        if self.frame == "none":
            rate = root
        elif self.frame == "up":
            v = [models.number(Fraction(x)) for x in self.up]
            across = models.cross(v, r[1])
            N = models.scaled(models.times(models.dot(v, r[1]), models.dot(across, r[2])), Fraction(-2))
            rate = models.times(models.times(N, models.inverse(models.dot(across, across))), models.inverse(root))
            rate = models.scaled(rate, Fraction(C.side))
        else:
            bend = models.cross(r[1], r[2])
            N = models.scaled(models.dot(bend, r[3]), Fraction(-3))
            rate = models.times(models.times(N, models.inverse(models.dot(bend, bend))), root)
        P, off = rate
        return self.integral_bounds(Poly(P, 1 << piece.bits), Fraction(off, 1 << piece.bits), 1, m, h, piece.bits)

    def bounds(self, k, t):
        """Of the integral along segment k from 0 to t."""
        C = self.parts[k]
        self.rest_on(C.needed)
        require(t <= C.enclosed[-1][0], "the pieces of segment %d end before t" % k)
        start, low, high, more = next(piece for piece in reversed(C.enclosed) if piece[0] <= t)
        if start < t:
            low, high = (x + y for x, y in zip((low, high), more(t)))
        return low, high

    def claim(self, claim):
        """The integral from 0 to t is the sum of those along the segments, and of the turns of corners up to t."""
        t, ask = claim.t, claim.radius.denominator.bit_length() - claim.radius.numerator.bit_length()
        require(0 <= t <= len(self.parts), "t is not on the path")
        last = -(-t.numerator // t.denominator)  # so many segments, the last of them up to t
        low, high = (sum(x) for x in zip((0, 0), *(self.bounds(k, min(Fraction(1), t - k)) for k in range(last))))
        if hasattr(claim, "symmetry"):
            self.symmetry(t, claim.symmetry)
            low, high = 0, 0
        for k in range(1, min(t.numerator // t.denominator, len(self.parts) - 1) + 1):
            self.rest_on([self.parts[k].joint])
            low, high = (x + y for x, y in zip((low, high), self.turn(k, 128 + max(0, ask) * (claim.radius > 0))))
        is_known = -claim.radius <= low - claim.value and high - claim.value <= claim.radius
        require(is_known, "it does not follow from the pieces")

    def symmetry(self, t, shift):
        """The rate at t - x is the opposite of that at x, or that at x + shift, t being a multiple of twice the shift."""
        require(self.frame != "none" and 0 < t <= 1, "a symmetry is one of an angle in the first segment")
        require(shift is None or Fraction(t, 2) / shift % 1 == 0, "t is no multiple of twice the shift")
        C = self.parts[0]
        if hasattr(C, "texts"):
            return self.symmetry_of_formulas(C, t, shift)
        if C.rate[0]:
            require(shift is None, "the rate does not have that symmetry")
            turned = [on_piece(a, Fraction(t), Fraction(-1)) for a in C.rate]
            require(turned == [C.rate[0] * -1, *C.rate[1:]], "the rate does not have that symmetry")

    def symmetry_of_formulas(self, C, t, shift):
        """Of N/(D sqrt(S)) but for a constant, where s = from + x and there. Each derivative changes its sign where s falls with x,
        and there is an even number of them in N, D and S."""
        waves = Waves(MAX_SYMMETRY // len(self.claims))
        ends = waves.values(C.ends, {})
        start = ends[C.steps["from"]]
        end, way, side = ends[C.steps["to"]], Fraction(t if shift is None else shift), -1 if shift is None else 1
        there = [(key, c * x) for part, x in ((start, 1 - way), (end, way)) for key, c in part.items()]

        def rate(s):
            values = waves.values(C.f, s)
            r = [values[C.steps[key]] for key in AXES]
            r1, r2, r3 = [*accumulate(range(3), lambda r, _: [*map(slope_of, r)], initial=r)][1:]
            S = waves.dot(r1, r1)
            if self.frame == "frenet":
                bend = waves.cross(r1, r2)
                return waves.dot(bend, r3), waves.dot(bend, bend), S
            v = [{UNIT: Fraction(x)} if x else {} for x in self.up]
            across = waves.cross(v, r1)
            return waves.times(waves.dot(v, r1), waves.dot(across, r2)), waves.dot(across, across), S
        N, *one = rate(collected([*start.items(), (OF_X, 1)]))
        M, *other = rate(collected([*there, (OF_X, side)]))
        require(not N or N == {key: -c for key, c in M.items()} and one == other, "the rate does not have that symmetry")

    @cache
    def turn(self, k, bits):
        """Bounds of that at joint k."""
        return self.parts[k].turn(bits) if hasattr(self.parts[k], "turn") else (0, 0)

    def place(self, t):
        """(r, H) there, at a joint of the later segment."""
        k = min(len(self.parts) - 1, t.numerator // t.denominator)
        C, s = self.parts[k], Fraction(t - k)
        return [x(s) / C.W(s) for x in C.X], [a(s) for a in C.H]

    def is_zero(self, t):
        is_still = all(not C.rate[0] for k, C in enumerate(self.parts) if k < t)
        return is_still and all(self.turn(k, 64) == (0, 0) for k in range(1, len(self.parts)) if k <= t)

    def first_frame(self, H, P):
        """f2 and f3 where the least rotation takes the x axis to e1 = (a, b, c): (-b, a + c^2/(1 + a), -bc/(1 + a)) and (-c,
        -bc/(1 + a), a + b^2/(1 + a)), over the common denominator |H|(|H| + x) for H = (x, y, z)."""
        (x, y, z), square = H, dot(H, H)
        below = times(known_root(square, P), plus_root(x, 1, square, P))
        rows = (((-y * x, -y), (square - y * y, x), (-y * z, 0)), ((-z * x, -z), (-y * z, 0), (square - z * z, x)))
        return [[quotient(plus_root(p, q, square, P), below) for p, q in row] for row in rows]

    def frame_of_v(self, H, P):
        """e2 along v x H, and e3 along H x (v x H)."""
        across = cross(self.up, H)
        return unit_vector(across, P), unit_vector(cross(H, across), P)

    def table(self, rows):
        """As above, e2 and e3 being those of the frame of v. The first frame is cos phi e2 + sin phi e3, ...."""
        require(self.frame == "up", "the angles are not those to the frame of a vector")
        require(not any(hasattr(C, "texts") for C in self.parts), "there are none of curves by formulas")
        wanted = len(self.claims)
        require(len(rows) == wanted, "it has %d rows, and there are %d angles" % (len(rows), wanted))
        self.rest_on([name for C in self.parts for name in C.needed if name.startswith(("weight", "joint"))])
        _, first = self.place(Fraction(0))
        require(first[0] > 0 or any(first[1:]), "the tangent at the start is -x")
        for k, (row, claim) in enumerate(zip(rows, self.claims), 1):
            self.rest_on([claim.text])
            require(0 <= claim.t <= len(self.parts), "a t is not on the path")
            P = 128 + min(4096, max(0, claim.radius.denominator.bit_length() - claim.radius.numerator.bit_length()))
            (r, H), (f2, f3) = self.place(Fraction(claim.t)), self.first_frame(first, P)
            is_still = claim.t == 0 or self.is_zero(claim.t) or not (claim.theta or claim.radius)
            if not (is_still and not any(cross(H, first)) and dot(H, first) > 0):
                e2, e3 = self.frame_of_v(first, P)
                a, b = (reduce(plus, map(times, f2, e)) for e in (e2, e3))
                a, b = self.rounded_to_axis(first, a, b)
                C, S = [(1, 0), (0, 0)] if is_still else [(x, off) for *xs, off in [cos_sin_of(claim)] for x in xs]
                e2, e3 = self.frame_of_v(H, P)
                C, S = plus(times(C, a), times((-1, 0), times(S, b))), plus(times(S, a), times(C, b))
                f2, f3 = ([plus(times(x, y), times(z, w)) for y, w in zip(e2, e3)] for x, z in ((C, S), (times((-1, 0), S), C)))
            require_doubles(row, [(x, 0) for x in (claim.t, *r)] + unit_vector(H, P) + f2 + f3, k)

    def rounded_to_axis(self, H, a, b):
        """cos phi and sin phi, exactly where one of them is 0. With S = v x H and T = H x S they are (p + q|H|) times positive
        numbers for p = H_x S_y - H_y S_x and q = S_y, and likewise of T: (-H_y, |H| + H_x, 0) is along f2, but for what is along e1."""
        across, square = cross(self.up, H), dot(H, H)
        is_zero = [plus_root(H[0] * s[1] - H[1] * s[0], s[1], square, 64) == (0, 0) for s in (across, cross(H, across))]
        sign = [(1 if x > 0 else -1, 0) for x, _ in (a, b)]
        return ((0, 0), sign[1]) if is_zero[0] else (sign[0], (0, 0)) if is_zero[1] else (a, b)


def proof_of(C):
    if not hasattr(C, "segments"):
        return Proof(C)
    return IntegralProof(C) if hasattr(C, "frame") else PathProof(C)


def read_file(name):
    try:
        with open(0 if name == "-" else name, "rb", closefd=name != "-") as file:
            return file.read()
    except OSError as error:
        raise Malformed(" " + error.strerror)


NUMBER = re.compile(r"(?=.{1,400}$)-?[0-9]+([.][0-9]+)?(e[-+]?[0-9]{1,3})?")
TABLE = ["t"] + [v + axis for v in ("", "e1", "f2", "f3") for axis in "xyz"]


def read_table(name):
    """The rows of a table as phrame frames writes it."""
    try:
        lines = read_file(name).decode("ascii").split("\n")
    except UnicodeDecodeError:
        raise Malformed(" it is no text") from None
    lines = [line[:-1] if line[-1:] == "\r" else line for line in (lines if lines[-1] else lines[:-1])]
    if not lines or lines[0] != ",".join(TABLE):
        raise Malformed(" its first line is not %s" % ",".join(TABLE))
    rows = [line.split(",") for line in lines[1:]]
    for k, row in enumerate(rows):
        if len(row) != len(TABLE) or not all(map(NUMBER.fullmatch, row)):
            raise Malformed(" line %d: %d decimal numbers are wanted" % (k + 2, len(TABLE)))
    return [[Fraction(x) for x in row] for row in rows]


def check(name, options):
    """Checks one file and prints what is proved, of several in one line; returns the exit status."""
    at, is_one = name, len(options.files) < 2
    try:
        proof = proof_of(read_certificate(read_file(name), options))
        if options.curve:
            at = options.curve
            proof.state("curve of " + at, proof.is_of, (), read_curves(at, options))
        if options.table:
            at = options.table
            rows = read_table(at)
    except Malformed as error:
        print("%s%s:%s" % ("check_certificate.py: " if is_one else "", at, error), file=sys.stderr if is_one else sys.stdout)
        return 2
    lines = proof.run()
    if options.table:
        proof.state("table " + options.table, proof.table, (), rows)
    if is_one and not options.quiet:
        named = getattr(proof.C, "curve", proof.C)
        shown = "".join(c if c.isprintable() else "?" for c in getattr(named, "name", ""))  # no line of its own
        print("curve       %s" % (shown or "without a name"))
        print("sha256      %s" % hash_of(proof.curves()))
        up = " (%s)" % ", ".join(map(str, proof.C.up)) if hasattr(proof.C, "up") else ""
        print("frame       %s%s" % (getattr(proof.C, "frame", "erf"), up))
    for is_proved, line in lines:
        if is_one and not (options.quiet and is_proved):
            print(line)
    failures, number = sum(not is_proved for is_proved, _ in lines), len(lines)
    print(("" if is_one else name + ": ") + ("%d of %d statements %s not proved" % (
        failures, number, "is" if failures == 1 else "are") if failures else "all %d statements are proved" % number))
    return 1 if failures else 0


def main():
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)
    parser = argparse.ArgumentParser(description="Checks certificates of rotation-minimizing frames.")
    parser.add_argument("files", nargs="+", metavar="CERT", help='a certificate, "-" for standard input; of several there is one line for each')
    parser.add_argument("--curve", metavar="FILE",
                        help="the curve it must be of: a curve/1 or a spline/1")
    parser.add_argument("--table", metavar="FILE",
                        help="frames, as phrame frames writes them, at the t of the certificate: is each number the\n"
                             "double next to the exact one?")
    parser.add_argument("-q", "--quiet", action="store_true",
                        help="print only what is not proved, and the last line")
    parser.add_argument("--max-degree", type=int, default=MAX_DEGREE, metavar="N",
                        help="of the curve, else the file is refused (default %d)" % MAX_DEGREE)
    parser.add_argument("--unlimited", action="store_true",
                        help="check it even if that takes longer than the page promises")
    options = parser.parse_args()
    if options.table and len(options.files) > 1:
        parser.error("--table is for one certificate")
    sys.stdout.reconfigure(errors="backslashreplace")
    sys.exit(max(check(name, options) for name in options.files))


if __name__ == "__main__":
    main()
