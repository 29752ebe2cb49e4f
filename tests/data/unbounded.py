#!/usr/bin/env python3
"""Writes unbounded.jsonl: integrals of rational functions over unbounded intervals, with exact values.

    python3 tests/data/unbounded.py > tests/data/unbounded.jsonl

Needs SymPy, which brings mpmath; nothing of phrame. The tests do not run it. Every value is c*pi + d with an algebraic
number c and a rational combination d of logarithms of rational numbers and of 1, stated by a formula that was
published or is derived below, none of which is a sum over the roots of the denominator. It is compared with tanh-sinh
quadrature of the integrand to 60 digits, which knows neither formula nor pole but for a principal value; over the whole
line the integrand is folded, f(x) + f(-x) from 0, which is the limit from -R to R. SymPy finds the polynomial of c.

The sources:
  GR       I. S. Gradshteyn, I. M. Ryzhik, Table of Integrals, Series, and Products: 3.241.2, 3.241.3, 3.241.4, 3.249.1
  beta     Euler's integral: x^(m-1)/(1+x^n) over x > 0 is pi/n/sin(m pi/n), and sums of such
  quartic  with s^2 = a + 2 sqrt(b): 1/(x^4+a x^2+b) over the line is pi/(sqrt(b) s), x^2/(x^4+a x^2+b) is pi/s, by
           x -> sqrt(b)/x and u = x - sqrt(b)/x
  cosines  x^2 + 2x cos t + 1 over x > 0: t/sin t for 1/that; Euler
  parseval for D(s) = sum d_k s^k with all zeros in the left half plane, the integral of |C(iw)/D(iw)|^2 over the line is
           2 pi c P c, where A P + P A' + b b' = 0 (Lyapunov) for the companion matrix A of D: linear equations
  parts    partial fractions of linear factors and of x^2 + b, each integrated by hand
  odd      odd under x -> -x, x -> 1/x or x -> -1/x: 0
"""
import json
import sys

import integrals
import sympy
from mpmath import mp, mpf
from sympy import Rational, cos, log, pi, sin, sqrt

X = sympy.Symbol("x")
ENTRIES = []


def add(name, integrand, start, end, multiple, rest, source, pv=False):
    """The integral is multiple * pi + rest."""
    ENTRIES.append((name, str(integrand).replace("**", "^").replace(" ", ""), start, end, pv, sympy.sympify(multiple),
                    sympy.sympify(rest), source))


def cosecant(m, n):
    return 1 / (n * sin(pi * Rational(m, n)))


def parseval(c, d):
    """1/pi of the integral of |C(iw)/D(iw)|^2, C and D ascending, and the integrand as text."""
    n = len(d) - 1
    d = [Rational(k) / d[-1] for k in d]
    c = [Rational(k) for k in c] + [Rational(0)] * (n - len(c))
    a = sympy.zeros(n, n)
    for k in range(n - 1):
        a[k, k + 1] = 1
    for k in range(n):
        a[n - 1, k] = -d[k]
    unknown = sympy.symbols(f"p:{n * n}")
    p = sympy.Matrix(n, n, unknown)
    b = sympy.zeros(n, n)
    b[n - 1, n - 1] = 1
    solution = sympy.solve(list(a * p + p * a.T + b), unknown, dict=True)[0]
    row = sympy.Matrix([c])
    return 2 * (row * p.subs(solution) * row.T)[0, 0]


def squared(coefficients):
    """|P(ix)|^2."""
    p = sum(Rational(c) * (sympy.I * X) ** k for k, c in enumerate(coefficients))
    return sympy.expand(sympy.expand(p) * sympy.expand(p.subs(X, -X)))


def fill():
    for n in range(2, 17):
        add(f"beta-1-{n}", f"1/(1+x^{n})", "0", "inf", cosecant(1, n), 0, "GR 3.241.2")
    for m, n in [(2, 3), (3, 4), (2, 5), (3, 5), (3, 7), (5, 8), (2, 9), (7, 10), (5, 12), (7, 18), (3, 20), (11, 24)]:
        add(f"beta-{m}-{n}", f"x^{m - 1}/(1+x^{n})", "0", "inf", cosecant(m, n), 0, "GR 3.241.2")
    for n in (4, 6, 8, 10, 12):
        add(f"line-{n}", f"1/(1+x^{n})", "-inf", "inf", 2 * cosecant(1, n), 0, "GR 3.241.2, even")
    for m, n in [(3, 6), (3, 8), (5, 8), (3, 10), (5, 12)]:
        add(f"line-{m}-{n}", f"x^{m - 1}/(1+x^{n})", "-inf", "inf", 2 * cosecant(m, n), 0, "GR 3.241.2, even")
    for m, n in [(1, 3), (2, 3), (1, 4), (1, 5), (3, 5), (1, 6), (3, 8), (2, 7)]:
        add(f"cotangent-{m}-{n}", f"x^{m - 1}/(1-x^{n})", "0", "inf", cos(pi * Rational(m, n)) * cosecant(m, n), 0, "GR 3.241.3", True)
    for m, n, p, q, k in [(1, 2, 2, 3, 1), (1, 4, 1, 1, 1), (3, 4, 1, 2, 1), (1, 3, 1, 1, 1), (2, 3, 8, 1, 2),
                          (1, 3, 2, 1, 0), (1, 4, 3, 1, 0), (2, 5, 1, 1, 1), (1, 6, 1, 1, 2), (1, 2, 1, 1, 4)]:
        s = Rational(m, n)
        # gamma(s) gamma(1 + k - s) = pi/sin(pi s) * (1 - s)(2 - s)...(k - s)
        product = sympy.prod([j - s for j in range(1, k + 1)])
        value = product / (sympy.factorial(k) * n * Rational(p) ** (k + 1) * sin(pi * s)) * Rational(p, q) ** s
        add(f"power-{m}-{n}-{p}-{q}-{k + 1}", f"x^{m - 1}/({p}+{q}*x^{n})^{k + 1}", "0", "inf", value, 0, "GR 3.241.4")
    for n, a2 in [(1, 2), (2, 1), (2, 3), (3, 5), (5, 2)]:
        value = Rational(sympy.factorial2(2 * n - 3), 2 * sympy.factorial2(2 * n - 2)) / sqrt(a2) ** (2 * n - 1)
        add(f"square-{n}-{a2}", f"1/(x^2+{a2})^{n}", "0", "inf", value, 0, "GR 3.249.1")
    for a, b in [(1, 1), (0, 4), (3, 1), (-1, 1), (1, 2), (0, 3), (2, 5), (-2, 3)]:
        s = sqrt(a + 2 * sqrt(b))
        d = str(X**4 + a * X**2 + b)
        add(f"quartic-1-{a}-{b}", f"1/({d})", "-inf", "inf", 1 / (sqrt(b) * s), 0, "quartic")
        if b != 4:
            add(f"quartic-x2-{a}-{b}", f"x^2/({d})", "-inf", "inf", 1 / s, 0, "quartic")
    for t, twice_cos in [(Rational(1, 3), 1), (Rational(2, 3), -1)]:
        add(f"cosines-{twice_cos}", f"1/(x^2+({twice_cos})*x+1)", "0", "inf", t / sin(pi * t), 0, "cosines")
    for c, d in [([1], [1, 1, 1]), ([1, 2], [3, 2, 1]), ([1], [1, 2, 3, 1]), ([2, 0, 1], [1, 3, 2, 1]),
                 ([1], [1, 3, 4, 2, 1]), ([1, 1, 0, 1], [2, 4, 5, 2, 1]), ([1, 0, 2], [1, 3, 5, 6, 3, 1])]:
        top, bottom = squared(c), squared(d)
        add(f"parseval-{len(d) - 1}-{len(c) - 1}", f"({top})/({bottom})", "-inf", "inf", parseval(c, d), 0, "parseval")
    for name, f, start, end, multiple, rest in [
            ("log-1", "1/((x+2)*(x+5))", "0", "inf", 0, log(Rational(5, 2)) / 3),
            ("log-2", "1/(x*(1+x^5))", "1", "inf", 0, log(2) / 5),
            ("log-3", "1/((x+1)*(x+2)*(x+3))", "0", "inf", 0, log(Rational(4, 3)) / 2),
            ("log-4", "1/(x^2-1)", "2", "inf", 0, log(3) / 2),
            ("log-5", "1/(x^2*(x+1))", "1", "inf", 0, 1 - log(2)),
            ("log-6", "1/((x+1)*(x^2+1))", "0", "inf", Rational(1, 4), 0),
            ("log-7", "1/((x+1)*(x^2+2))", "0", "inf", sqrt(2) / 12, log(2) / 6),
            ("log-8", "1/((x+2)*(x^2+3))", "0", "inf", 2 * sqrt(3) / 42, (log(3) - 2 * log(2)) / 14),
            ("log-9", "1/(1+x^3)", "1", "inf", sqrt(3) / 9, -log(2) / 3),
            ("power", "5/x^4", "-inf", "-2", 0, Rational(5, 24))]:
        add(name, f, start, end, multiple, rest, "parts")
    add("pv-1", "1/((x-1)*(x^2+1))", "-inf", "inf", Rational(-1, 2), 0, "parts", True)
    add("pv-2", "(x+1)/(x^2+3)", "-inf", "inf", 1 / sqrt(3), 0, "parts", True)
    add("pv-3", "x+1/(x^2+2)", "-inf", "inf", 1 / sqrt(2), 0, "parts", True)
    add("pv-4", "1/(x^3-1)", "-inf", "inf", -1 / sqrt(3), 0, "parts", True)
    add("odd-1", "x", "-inf", "inf", 0, 0, "odd", True)
    add("odd-2", "-2*(1-x^2)/(1+x^4)", "-inf", "inf", 0, 0, "odd")
    add("odd-3", "(1-x^2)/(1+x^2+x^4)", "0", "inf", 0, 0, "odd")
    add("odd-4", "(1-x^4)/(1+x^6)", "-inf", "inf", 0, 0, "odd")
    add("odd-5", "(x^2-x^4)/(2+x^2+x^6+2*x^8)", "-inf", "inf", 0, 0, "odd")
    add("odd-6", "(1-x)*x/(1+x^5)", "0", "inf", 0, 0, "odd")


def quadrature(n, d, start, end, pv):
    if (start, end) == ("-inf", "inf"):
        minus = sympy.Poly(-X, X, domain="QQ")
        n, d = n * d.compose(minus) + n.compose(minus) * d, d * d.compose(minus)
        g = n.gcd(d)
        n, d, start = n.quo(g), d.quo(g), "0"
    if n.is_zero:
        return mpf(0)
    with mp.workdps(integrals.WORKING):
        parts = integrals.pieces(integrals.end(start), integrals.end(end), integrals.poles(d), pv and d.count_roots(0) > 0)
    with mp.workdps(integrals.QUADRATURE):
        return integrals.by_quadrature(n, d, parts)


def main():
    fill()
    t = sympy.Symbol("t")
    for name, f, start, end, pv, multiple, rest, source in ENTRIES:
        with mp.workdps(integrals.QUADRATURE):
            value = mpf(str(sympy.N(multiple * pi + rest, integrals.QUADRATURE)))
            found = quadrature(*integrals.read(f, "x"), start, end, pv)
            if not integrals.agree(value, found):
                sys.exit(f"{name}: {mp.nstr(value, 70)}, but the quadrature is {mp.nstr(found, 70)}")
        polynomial = sympy.Poly(sympy.minimal_polynomial(multiple, t), t).primitive()[1]
        entry = {"id": name, "integrand": f, "from": start, "to": end}
        if pv:
            entry["pv"] = True
        entry["value"] = integrals.rounded(value)
        entry["pi"] = [str(c) for c in reversed(polynomial.all_coeffs())]
        entry["exact"] = str(multiple * pi + rest)
        entry["source"] = source
        print(json.dumps(entry))
    print(len(ENTRIES), file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
