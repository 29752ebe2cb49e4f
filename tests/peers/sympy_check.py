"""SymPy reads what phrame prints for it and differentiates it: exactly, or what is too slow so
with 300 digits. The differences of its values are the integrals.

SymPy's own evalf is too slow for a grid. So the expression it has read is evaluated at all points together by mpmath,
whose functions are those of SymPy's evalf, with the same cuts; what is free of the variable once.
"""
import cmath
import contextlib
import functools
import json
import math
import os
import subprocess
import sys

import differences
import peers

try:
    import sympy
    from mpmath import mp
except ImportError:
    peers.missing("SymPy")


def root_sum(e, field):
    """What RootSum.doit() finds, a rational function, by traces in Q(x)[z]/(q), which takes a fraction of the time."""
    z = e.poly.gen
    q = sympy.Poly(e.poly, z, domain=field).monic()
    n, d = (sympy.Poly(p, z, domain=field) for p in sympy.fraction(sympy.together(e.fun(z))))
    c = (n * sympy.invert(d, q)).rem(q).rep.all_coeffs()[::-1]
    a, s = q.rep.all_coeffs(), [field(q.degree())]  # s[k] is the sum of the k-th powers of the roots (Newton)
    for k in range(1, len(c)):
        s.append(-k * a[k] - sum(a[j] * s[k - j] for j in range(1, k)))
    return field.to_sympy(sum(ck * sk for ck, sk in zip(c, s)))


def derivative(antiderivative, x):
    """With log|p| read as log(p), whose derivative is the same."""
    return sympy.diff(antiderivative.replace(sympy.Abs, lambda p: p), x)


def is_zero(f, x):
    """In Q(x), and where it has radicals as an expression."""
    field = sympy.QQ.frac_field(x)
    f = f.replace(lambda e: isinstance(e, sympy.RootSum), lambda e: root_sum(e, field))
    try:
        return sum(map(field.from_sympy, sympy.Add.make_args(f))) == 0
    except (ValueError, sympy.CoercionFailed):
        numerator, _ = sympy.fraction(sympy.together(f))
        return sympy.expand(numerator) == 0


def roots(q):
    """Of a squarefree polynomial over the rationals, in the precision of mp: first in doubles."""
    integers = [int(c) for c in q.clear_denoms(convert=True)[1].all_coeffs()]
    largest, n = max(map(abs, integers)), q.degree()
    z = [cmath.rect(1 + 0.1 * math.sin(k), 0.4 + 2 * math.pi * k / n) for k in range(n)]
    with contextlib.suppress(ArithmeticError):
        z = ehrlich_aberth([c / largest for c in integers], z, 1e-13)
    with mp.workprec(2 * mp.prec):
        z = ehrlich_aberth(list(map(mp.mpf, integers)), list(map(mp.mpc, z)), mp.eps ** 0.75)
    return [r.real if abs(r.imag) <= mp.eps * abs(r) else r for r in z]


def ehrlich_aberth(c, z, accuracy):
    """The roots by the method of Ehrlich and Aberth from z, or what 200 steps have come to."""
    n = len(z)
    for _ in range(200):
        steps = []
        for k, r in enumerate(z):
            inside = abs(r) <= 1
            x, value, slope = r if inside else 1 / r, 0, 0
            for a in c if inside else reversed(c):
                value, slope = value * x + a, slope * x + value
            if value == 0:
                steps.append(0)
                continue
            ratio = slope / value if inside else (n - x * slope / value) * x  # p'/p at r, or of rⁿ·p(1/r)
            steps.append(1 / (ratio - sum(1 / (r - s) for s in z[:k] + z[k + 1:])))
        z = [r - step for r, step in zip(z, steps)]
        if all(abs(step) <= accuracy * abs(r) for r, step in zip(z, steps)):
            break
    return z


class Values:
    """The values of expressions at some points of x: a number where x is not in the expression, else a list."""

    FUNCTIONS = {sympy.Add: lambda *a: mp.fsum(a), sympy.Mul: lambda *a: mp.fprod(a), sympy.Abs: abs}

    def __init__(self, x, points, known=None):
        self.x, self.points = x, points
        self.known = known or {x: points}

    def __call__(self, e):
        if e not in self.known:
            self.known[e] = self.compute(e)
        return self.known[e]

    def compute(self, e):
        if isinstance(e, sympy.RootSum):
            # Over the rationals, the term of a conjugate root is conjugate.
            assert not e.fun.has(sympy.I)
            name, total = sympy.Dummy(), [0] * len(self.points)
            term = e.fun(name)
            for r in roots(e.poly):
                if mp.im(r) >= 0:
                    row = Values(self.x, self.points, {self.x: self.points, name: r})(term)
                    total = [t + (2 * v.real if mp.im(r) else v) for t, v in zip(total, row)]
            return total
        if e.is_Rational:
            return mp.mpf(e.p) / e.q
        if not e.args:
            return mp.mpmathify(e.evalf(mp.dps + 5))  # I, pi
        if e.is_Pow and e.exp.is_Integer:
            f, arguments = (lambda base: base ** int(e.exp)), [self(e.base)]
        elif e.is_Pow and e.exp == sympy.S.Half:
            f, arguments = mp.sqrt, [self(e.base)]
        else:
            f = self.FUNCTIONS.get(e.func) or getattr(mp, "power" if e.is_Pow else e.func.__name__)
            arguments = [self(a) for a in e.args]
        if e.is_Add or e.is_Mul:  # what is constant first
            constants = [a for a in arguments if not isinstance(a, list)]
            arguments = [a for a in arguments if isinstance(a, list)] + ([f(*constants)] if constants else [])
        if not any(isinstance(a, list) for a in arguments):
            return f(*arguments)
        return [f(*row) for row in zip(*(a if isinstance(a, list) else [a] * len(self.points) for a in arguments))]


def values(e, x, points):
    found = Values(x, points)(sympy.sympify(e))
    return found if isinstance(found, list) else [found] * len(points)


def is_close(f, g, x):
    """At three points. To simplify nested radicals, and functions of high degree, takes SymPy minutes."""
    with mp.workdps(300):
        points = [mp.mpf(n) / 11 for n in (37, -8, 29)]
        return all(abs(a - b) <= 1e-40 * abs(b) for a, b in zip(values(f, x, points), values(g, x, points)))


@functools.lru_cache(maxsize=1)  # what is differentiated is mostly evaluated next
def read(text):
    """What the script defines, and its variable. Python reads it with the limit for the digits of integers that its users
    have; SymPy, which factors what the coefficients of a RootSum have in common, has none."""
    names = {}
    differences.limit_integers(4300)
    try:
        code = compile(text, "script", "exec")
    finally:
        differences.limit_integers(0)
    exec(code, names)
    return sympy.sympify(names["antiderivative"]), names["integrand"], names[text.splitlines()[1].replace(",", " ").split()[0]]


def derives(text):
    F, f, x = read(text)
    ours = derivative(F, x)
    is_slow = F.has(sympy.I) or sympy.degree(sympy.denom(f), x) > 12
    return is_close(ours, f, x) if is_slow else is_zero(ours - f, x)


def evaluate(text, digits):
    F, _, x = read(text)
    with mp.workdps(digits):
        found = values(F, x, [mp.mpf(t) for t in differences.GRID])
        return [complex(v - u) for u, v in zip(found, found[1:])]


def check_long_numbers():
    """A value of more digits than Python takes in a string is read with the limit its users have."""
    integral = ["integrate", "1/(x^5-x+3)", "--from", "0", "--to", "1", "--digits", "5000", "--print"]

    def printed(system):
        return subprocess.run([os.environ["PHRAME_PROGRAM"], *integral, system], stdout=subprocess.PIPE, check=True).stdout
    names = {}
    differences.limit_integers(4300)
    try:
        exec(printed("sympy"), names)
    finally:
        differences.limit_integers(0)
    decimal = json.loads(printed("json"))["definite"]["value"]
    unit = sympy.Rational(1, 10 ** len(decimal.partition(".")[2]))
    if abs(sympy.Rational(names["definite"]) - sympy.Rational(decimal)) > unit / 2:
        sys.exit("FAILED: a value of 5000 digits")


if __name__ == "__main__":
    check_long_numbers()
    peers.main("sympy", derives, evaluate)
