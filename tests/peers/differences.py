"""Does F(b) − F(a), computed by another system from what phrame prints, equal the integral from a to b?

A logarithm that crosses its cut makes F jump, which no derivative shows. So F is evaluated on a dense grid, and each
difference is compared with Gauss's quadrature of the integrand, whose values are computed exactly and rounded once.
"""
import functools
import math
import os
import sys

from gauss import legendre

# Sets how many decimal digits the integers have that Python reads; 0 is no limit.
limit_integers = getattr(sys, "set_int_max_str_digits", lambda digits: None)
limit_integers(0)

# sinh spreads the grid: fine near 0, and out to ±1400. 1/7 keeps it off the poles that people choose.
FINENESS = 16 if os.environ.get("PHRAME_PEERS") == "corpus" else 5
GRID = [round(math.sinh(k / FINENESS), 6) + 1 / 7 for k in range(-8 * FINENESS, 8 * FINENESS + 1)]


RULE = legendre(10)


def integers(coefficients):
    """A list of fractions as integers and one denominator."""
    pairs = [tuple(map(int, (c + "/1").split("/")[:2])) for c in coefficients] or [(0, 1)]
    common = math.lcm(*(d for _, d in pairs))
    return [n * (common // d) for n, d in pairs], common


class Integrand:
    """n/d, as phrame's JSON has it."""

    def __init__(self, data):
        self.numerator, n_scale = integers(data["numerator"])
        self.denominator, d_scale = integers(data["denominator"])
        self.scale = d_scale, n_scale

    @staticmethod
    def homogeneous(c, t, shift):
        """sᵏ·p(t/s), k the degree, s = 2 to the `shift`."""
        value, bits = 0, 0
        for a in reversed(c):
            value = value * t + (a << bits)
            bits += shift
        return value

    def __call__(self, x):
        t, s = x.as_integer_ratio()  # s is a power of 2
        shift = s.bit_length() - 1
        n = self.homogeneous(self.numerator, t, shift) * self.scale[0]
        d = self.homogeneous(self.denominator, t, shift) * self.scale[1]
        excess = shift * (len(self.denominator) - len(self.numerator))
        return (n << excess) / d if excess >= 0 else n / (d << -excess)

    @functools.cached_property
    def integrals(self):
        return [self.integral(a, b) for a, b in zip(GRID, GRID[1:])]

    def gauss(self, a, b):
        middle, half = (a + b) / 2, (b - a) / 2
        return half * sum(w * self(middle + half * x) for x, w in RULE)

    def integral(self, a, b, whole=None, depth=30):
        """None where bisection does not converge: there is a pole. Infinite beyond the floating-point numbers. The whole is gauss(a, b)."""
        middle = (a + b) / 2
        try:
            if whole is None:
                whole = self.gauss(a, b)
            left, right = self.gauss(a, middle), self.gauss(middle, b)
        except OverflowError:
            return math.inf
        except ZeroDivisionError:
            return None
        if abs(left + right - whole) <= 1e-11 * max(abs(whole), 1e-3):
            return left + right
        if depth == 0:
            return None
        left = self.integral(a, middle, left, depth - 1)
        right = None if left is None else self.integral(middle, b, right, depth - 1)
        return None if right is None else left + right


def compare(f, differences):
    """How many F(b) − F(a), as the other system computes them on the grid, have been compared with the integrals of f;
    how far they are from them at most; and those that are wrong."""
    count, largest, wrong = 0, 0.0, []
    for a, b, exact, difference in zip(GRID[:-1], GRID[1:], f.integrals, differences, strict=True):
        if exact is None or not math.isfinite(exact):
            continue
        count += 1
        error = abs(difference - exact) / max(1, abs(exact))
        if not error <= 1e-7:
            wrong.append(f"[{a:.4f}, {b:.4f}]: {difference:.6g}, not {exact:.6g}")
        largest = max(largest, error)
    poles, degree = f.integrals.count(None), len(f.denominator) - 1
    if poles > degree:
        wrong.append(f"{poles} intervals with a pole for {degree} poles")
    return count, largest, wrong
