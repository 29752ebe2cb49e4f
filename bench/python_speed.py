"""The Python package beside those who do the same by hand: a million frames, a few, and angles with 50 digits of many quintics.

    pip install . python-flint mpmath sympy && python bench/python_speed.py

An angle is theta(1), the integral of -2h/sigma from 0 to 1, of curves whose preimages have coefficients of one digit. By
python-flint: the roots of sigma as balls, the residues, the logarithms, with more bits until 50 digits are certain. By mpmath:
Gauss-Legendre quadrature, of which nothing proves a digit. All three must agree. With --sympy also integrals of rational
functions by phrame.sympy.integrate and by sympy.integrate, which is stopped after 15 s.
"""
import argparse
import os
import random
import signal
import statistics
import time

import flint
import mpmath
import numpy as np

import phrame

DIGITS = 50


def preimages(n):
    rng = random.Random(2003)
    return [[[rng.randint(-9, 9) for _ in range(3)] for _ in range(4)] for _ in range(n)]


def by_phrame(parts):
    return str(phrame.Curve(*parts).angle().value(1, digits=DIGITS))


def rate(parts):
    """h and sigma, as python-flint's polynomials."""
    u, v, p, q = map(flint.fmpz_poly, parts)
    h = u * v.derivative() - u.derivative() * v - p * q.derivative() + p.derivative() * q
    return h, u * u + v * v + p * p + q * q


def by_flint(parts):
    """The sum over the roots z of sigma of -2h(z)/sigma'(z)·(log(1 - z) - log(-z)): z is not real, so no cut is met."""
    h, sigma = rate(parts)
    common = h.gcd(sigma)
    h, sigma = h // common, sigma // common
    slope = sigma.derivative()
    bits = 192
    while True:
        flint.ctx.prec = bits
        theta = flint.arb(0)
        for z, multiplicity in sigma.complex_roots():
            assert multiplicity == 1
            if z.imag > 0:
                theta += 2 * (-2 * h(z) / slope(z) * ((1 - z).log() - (-z).log())).real
        text = theta.str(DIGITS, radius=False)
        if theta.rel_accuracy_bits() > 3.33 * DIGITS + 8:
            return text
        bits *= 2


def by_mpmath(parts):
    u, v, p, q = (part[::-1] for part in parts)

    def at(t):
        (a, da), (b, db), (c, dc), (d, dd) = (mpmath.polyval(f, t, derivative=True) for f in (u, v, p, q))
        return -2 * (a * db - da * b - c * dd + dc * d) / (a * a + b * b + c * c + d * d)

    with mpmath.workdps(DIGITS + 10):
        return mpmath.nstr(mpmath.quad(at, mpmath.linspace(0, 1, 5), method="gauss-legendre", maxdegree=9), DIGITS)


def milliseconds(ask, curves):
    """CPU time of one: the median of five rounds; and the answers."""
    rounds = []
    for _ in range(5):
        begin = time.process_time()
        found = [ask(parts) for parts in curves]
        rounds.append((time.process_time() - begin) / len(curves) * 1e3)
    return statistics.median(rounds), found


def agree(a, b, digits=DIGITS - 2):
    with mpmath.workdps(DIGITS + 10):
        a, b = mpmath.mpf(a), mpmath.mpf(b)
        return abs(a - b) <= abs(a) * mpmath.mpf(10) ** -digits


def frames(n):
    """Seconds for n frames of a quintic: (elapsed, CPU), the best of seven."""
    curve = phrame.Curve([2, -4, 4], [1, 0, -1], [0, -4, 4], [1, 2, -2])
    ts = np.random.default_rng(1).random(n)
    best = []
    for _ in range(7):
        elapsed, cpu = time.perf_counter(), time.process_time()
        curve.frames(ts)
        best.append((time.perf_counter() - elapsed, time.process_time() - cpu))
    return min(best)


def few_frames(n):
    """Microseconds for n frames of a quintic, where they are the first of it and where others were asked for before: the least of five
    rounds of twenty curves, elapsed, since another thread may help."""
    ts = np.linspace(0, 1, n) if n > 1 else np.array([0.3])
    first, again = [], []
    for _ in range(5):
        curves = [phrame.Curve(*parts) for parts in preimages(20)]
        begin = time.perf_counter()
        for curve in curves:
            curve.frames(ts)
        first.append((time.perf_counter() - begin) / len(curves))
        curve = curves[0]
        curve.frames(np.linspace(0, 1, 5000))  # so it is compiled
        begin = time.perf_counter()
        for _ in range(100):
            curve.frames(ts)
        again.append((time.perf_counter() - begin) / 100)
    return min(first) * 1e6, min(again) * 1e6


def stopped(signal_number, frame):
    raise TimeoutError


def integrals():
    """phrame's with SymPy's caches filled, the median of nine; SymPy's own with empty ones, once."""
    import sympy
    from sympy.core.cache import clear_cache

    from phrame.sympy import integrate

    x = sympy.Symbol("x")
    signal.signal(signal.SIGALRM, stopped)
    for f in (1 / (x**5 + 1), 1 / (x**5 + x + 1), (3 * x**4 - x + 7) / ((x**2 + 1) * (x**3 - 2 * x + 5)), (x**3 + 2 * x) / (x**6 + x**3 + 2),
              (x + 1) / (x**5 - 3 * x**2 + 2) ** 2, 1 / (x**7 - x + 3), 1 / (x**8 + x**3 + 1)):
        rounds = []
        for _ in range(9):
            begin = time.process_time()
            integrate(f, x)
            rounds.append((time.process_time() - begin) * 1e3)
        clear_cache()
        begin = time.process_time()
        signal.alarm(15)
        try:
            sympy.integrate(f, x)
            theirs = f"{(time.process_time() - begin) * 1e3:.0f} ms"
        except TimeoutError:
            theirs = "stopped"
        signal.alarm(0)
        print(f"  {str(f):50} phrame {statistics.median(rounds):.2f} ms, SymPy {theirs}")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--curves", type=int, default=1000)
    options.add_argument("--frames", type=int, default=1_000_000)
    options.add_argument("--sympy", action="store_true")
    given = options.parse_args()
    if given.sympy:
        integrals()
        return
    elapsed, cpu = frames(given.frames)
    print(f"{given.frames} frames of a quintic on {len(os.sched_getaffinity(0))} cores: {elapsed:.3f} s, of CPU time {cpu:.3f} s")
    for n in 1, 10, 100:
        first, again = few_frames(n)
        print(f"{n} frames: {first:.0f} µs for the first of a quintic, {again:.1f} µs where it is compiled")
    many = preimages(given.curves)
    few = many[: max(1, given.curves // 50)]  # quadrature is slow
    ours, values = milliseconds(by_phrame, many)
    flints, by_hand = milliseconds(by_flint, many)
    quadratures, summed = milliseconds(by_mpmath, few)
    assert all(map(agree, values, by_hand))
    wrong = sum(not agree(a, b) for a, b in zip(values, summed))
    print(f"curve and theta(1) to {DIGITS} digits, milliseconds of CPU time for one of {given.curves} quintics:")
    print(f"  phrame        {ours:8.3f}")
    print(f"  python-flint  {flints:8.3f}")
    print(f"  mpmath        {quadratures:8.3f}   ({len(few)} curves, {wrong} of them wrong within {DIGITS - 2} digits)")


if __name__ == "__main__":
    main()
