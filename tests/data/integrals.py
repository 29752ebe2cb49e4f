#!/usr/bin/env python3
"""Recomputes the definite values in integrals.jsonl and compares them with what is written there.

    python3 tests/data/integrals.py [id ...]

Needs SymPy, which brings mpmath; nothing of phrame. The tests do not run it: it is here so that anybody can check the
values, or compute the value of a new entry. Every value is computed twice, in two ways that share only the polynomials:
  poles       Laurent expansions at the poles, which are found to 400 digits, integrated term by term;
  quadrature  tanh-sinh to 100 digits, the interval cut at the real parts of near poles, infinite ends mapped by x = 1/t,
              a principal value taken over t > 0 of f(p + t) + f(p - t).
The two must agree to 60 digits, the value must be their rounding to 50 significant digits, and a closed form given under
"exact" must agree too. Prints one line for each failure, then the totals; the status is 1 if anything failed.
"""
import json
import pathlib
import sys

import sympy
from mpmath import mp, mpc, mpf
from sympy.parsing.sympy_parser import convert_xor, parse_expr, rationalize, standard_transformations

DIGITS, AGREE, QUADRATURE, WORKING = 50, 60, 100, 400
RULES = standard_transformations + (convert_xor, rationalize)


def read(text, variable):
    """Coprime polynomials N, D over Q with N/D the integrand."""
    x = sympy.Symbol(variable)
    n, d = sympy.fraction(sympy.together(parse_expr(text, {variable: x}, RULES)))
    n, d = sympy.Poly(n, x, domain="QQ"), sympy.Poly(d, x, domain="QQ")
    g = n.gcd(d)
    return n.quo(g), d.quo(g)


def number(q):
    return mpf(int(q.p)) / int(q.q)


def coefficients(p):
    return [number(c) for c in p.all_coeffs()]


def poles(d):
    """Pairs (pole, multiplicity); a pole is real exactly if its imaginary part is 0."""
    found = []
    for factor, multiplicity in d.factor_list()[1]:
        c = coefficients(factor)
        roots = mp.polyroots(c, maxsteps=2000, extraprec=2 * mp.prec) if len(c) > 2 else [-c[1] / c[0]]
        roots.sort(key=lambda r: abs(mp.im(r)))
        reals = factor.count_roots()
        found += [(mp.re(r) if i < reals else mpc(r), multiplicity) for i, r in enumerate(roots)]
    return found


def taylor(c, at, length):
    """The first Taylor coefficients at a point of the polynomial with coefficients c, by repeated division."""
    c, out = list(c), []
    while c and len(out) < length:
        for i in range(1, len(c)):
            c[i] += at * c[i - 1]
        out.append(c.pop())
    return out + [mpf(0)] * (length - len(out))


def by_poles(n, d, a, b, found):
    """Sum over the poles of the integrated principal parts, plus the integral of the polynomial part."""
    quotient, rest = n.div(d)
    total = mpf(0)
    if not quotient.is_zero:
        q = coefficients(quotient.integrate())
        total += mp.polyval(q, b) - mp.polyval(q, a)
    nc, dc = coefficients(rest), coefficients(d)
    for r, k in found:
        top, bottom = taylor(nc, r, k), taylor(dc, r, 2 * k)[k:]
        series = []
        for i in range(k):
            series.append((top[i] - sum(series[j] * bottom[i - j] for j in range(i))) / bottom[0])

        def primitive(x, left):
            if mp.isinf(x):
                return mpf(0)  # the logarithms of |x| cancel, since the residues add up to 0
            power = sum(c * (x - r) ** (i - k + 1) / (i - k + 1) for i, c in enumerate(series[:-1]))
            shift = r - x if left else x - r  # from -inf the logarithm of r - x is the continuous one
            return power + series[-1] * mp.log(abs(shift) if mp.im(r) == 0 else shift)

        if mp.isinf(a) and mp.isinf(b):
            total += primitive(mpf(0), True) - primitive(mpf(0), False) if r != 0 else 0
        else:
            total += primitive(b, mp.isinf(a)) - primitive(a, mp.isinf(a))
    return mp.re(total)


def pieces(a, b, found, pv):
    """The interval in pieces (kind, left, right): "f" as it is, "tail" in t = 1/x, a pole p in t = |x - p|."""
    real = sorted(r for r, _ in found if mp.im(r) == 0 and a < r < b)
    if bool(real) != pv:
        raise ValueError("a pole in the interval" if real else "no pole in the interval")
    out = []
    size = 1 + max([abs(r) for r, _ in found] + [abs(e) for e in (a, b) if not mp.isinf(e)])
    if mp.isinf(a):
        out, a = out + [("tail", -1 / size, mpf(0))], -size
    if mp.isinf(b):
        out, b = out + [("tail", mpf(0), 1 / size)], size
    cuts = [a]
    for x in sorted(mp.re(r) for r, _ in found if a < mp.re(r) < b and 0 < abs(mp.im(r)) < 1):
        if x - cuts[-1] > (b - a) / 1000 and b - x > (b - a) / 1000:
            cuts.append(x)
    cuts.append(b)
    for p in real:
        h = min(abs(p - e) for e in [a, b] + [s for s in real if s != p]) / 3
        out.append((p, mpf(0), h))
        cuts = sorted([c for c in cuts if abs(c - p) > h] + [p - h, p + h])
    return out + [("f", l, r) for l, r in zip(cuts, cuts[1:]) if not any(l < p < r for p in real)]


def by_quadrature(n, d, parts):
    nc, dc = coefficients(n), coefficients(d)
    gap = len(dc) - len(nc) - 2

    def f(x):
        return mp.polyval(nc, x) / mp.polyval(dc, x)

    def integrand(kind, x):
        with mp.workdps(WORKING):
            if kind == "f":
                return f(x)
            if kind == "tail":
                return x**gap * mp.polyval(nc[::-1], x) / mp.polyval(dc[::-1], x)
            t = max(x, mpf(10) ** -90)  # at 0 itself the two infinite terms cannot be added
            return f(kind + t) + f(kind - t)

    return sum(mp.quad(lambda x, k=k: integrand(k, x), [l, r], maxdegree=12) for k, l, r in parts)


def end(text):
    return {"inf": mp.inf, "-inf": -mp.inf}.get(text) or number(sympy.Rational(text))


def is_zero(x):
    return abs(x) < mpf(10) ** -95


def agree(x, y):
    return abs(x - y) <= mpf(10) ** -AGREE * max(abs(x), abs(y)) or is_zero(x) and is_zero(y)


def rounded(x):
    return "0" if is_zero(x) else mp.nstr(x, DIGITS, strip_zeros=False, min_fixed=-6, max_fixed=DIGITS)


def compute(entry):
    """For each definite integral of an entry: the two values."""
    n, d = read(entry["integrand"], entry["variable"])
    with mp.workdps(WORKING):
        found = poles(d)
        for item in entry.get("definite", []):
            a, b = end(item["from"]), end(item["to"])
            first = by_poles(n, d, a, b, found)
            parts = pieces(a, b, found, item.get("pv", False))
            with mp.workdps(QUADRATURE):
                second = by_quadrature(n, d, parts)
            yield item, first, second


def closed_form(text):
    return mpf(str(sympy.N(parse_expr(text, transformations=RULES), QUADRATURE)))


def main(ids):
    lines = pathlib.Path(__file__).with_name("integrals.jsonl").read_text(encoding="utf-8").splitlines()
    entries = [json.loads(line) for line in lines]
    values = failures = 0
    for entry in entries:
        if ids and entry["id"] not in ids:
            continue
        for item, first, second in compute(entry):
            values += 1
            where = f'{entry["id"]} from {item["from"]} to {item["to"]}'
            with mp.workdps(QUADRATURE):
                if not agree(first, second):
                    print(where, "the two methods differ:", mp.nstr(first, 70), mp.nstr(second, 70))
                elif rounded(first) != item["value"]:
                    print(where, "written", item["value"], "computed", rounded(first))
                elif "exact" in item and not agree(first, closed_form(item["exact"])):
                    print(where, "differs from", item["exact"])
                else:
                    continue
            failures += 1
    print(f"{len(entries)} integrands, {values} definite values checked, {failures} wrong")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
