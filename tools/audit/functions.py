"""The 500 rational functions of docs/audit.md: (name, family, f) as text in x, with integers, always the same ones.

Those of books and papers are of tests/data/integrals.jsonl, without those that come from the tests and trackers of the systems that
are asked, which would be unfair either way. The others are made by chance from a fixed seed, in families by what an integral meets:

    angle        -2h/sigma of PH curves of degree 3 to 13, what phrame integrates itself
    arctangents  the derivative of a sum of arctangents of rational functions, as Rioboo's example is one: who answers by one
                 arctangent of a quotient jumps at its poles
    factors      linear and quadratic factors over Q: what is done by hand
    repeated     the same with powers, and powers of a cubic
    irreducible  a denominator of degree 3 to 8 that does not split
    high-degree  denominators of degree 10 to 40: products of small factors, and irreducible ones
    long         numbers of 20 digits
"""
import hashlib
import json
import random
from fractions import Fraction
from pathlib import Path

from flint import fmpq, fmpq_poly, fmpz_poly

CORPUS = Path(__file__).resolve().parents[2] / "tests/data/integrals.jsonl"
COUNT = 500
# Names in the corpus of what is from books, theses and papers.
BOOKS = """timofeev stewart rubi binomial apostol hearn demidovich spivak hardy wang moses reduce gcl rt dst ahlfors gr tobey rioboo
bronstein leibniz dalzell lucas backhouse bbp brown""".split()


def text(p):
    """A polynomial with integer coefficients."""
    terms = []
    for k in reversed(range(p.degree() + 1)):
        c = int(p[k])
        power = "" if k == 0 else "x" if k == 1 else "x^%d" % k
        if c:
            terms.append(("-" if c < 0 else "+") + (str(abs(c)) if not power else power if abs(c) == 1 else "%d*%s" % (abs(c), power)))
    return "".join(terms).removeprefix("+") or "0"


def fraction(n, d):
    """n/d with integers and without a common factor; a zero is none of our functions."""
    g = n.gcd(d)
    n, d = n // g, d // g
    n = n * int(d.denom())
    d = d * int(d.denom())
    d = d * int(n.denom())
    n = n * int(n.denom())
    common = abs(int(fmpz_poly([int(c) for c in n.coeffs()]).content()))
    other = abs(int(fmpz_poly([int(c) for c in d.coeffs()]).content()))
    shared = fmpq(common, other)
    n, d = n / common * int(shared.p), d / other * int(shared.q)
    return "(%s)/(%s)" % (text(n), text(d)) if d.degree() > 0 and n.degree() >= 0 else None


class Chance:
    def __init__(self, family):
        self.random = random.Random("500 rational functions, " + family)

    def integer(self, most):
        return self.random.randint(-most, most)

    def polynomial(self, degree, most=9):
        """Of that degree."""
        return fmpq_poly([self.integer(most) for _ in range(degree)] + [self.random.choice([-1, 1]) * self.random.randint(1, most)])

    def quadratic(self, most=9):
        """Without a real root, and not a square."""
        while True:
            p = self.polynomial(2, most)
            if p[1] ** 2 - 4 * p[0] * p[2] < 0:
                return p

    def factor(self):
        return self.polynomial(1) if self.random.random() < 0.5 else self.quadratic()

    def irreducible(self, degree, most=9):
        while True:
            p = self.polynomial(degree, most)
            if len(fmpz_poly([int(c) for c in p.coeffs()]).factor()[1]) == 1 and p.gcd(p.derivative()).degree() == 0:
                return p


def product(polynomials):
    out = fmpq_poly([1])
    for p in polynomials:
        out = out * p
    return out


def angle(chance, k):
    m = 1 + k % 6
    u, v, p, q = (fmpq_poly([chance.integer(9) for _ in range(m + 1)]) for _ in range(4))
    h = u * v.derivative() - u.derivative() * v - p * q.derivative() + p.derivative() * q
    return -2 * h, u * u + v * v + p * p + q * q


def arctangents(chance, k):
    n, d = fmpq_poly([0]), fmpq_poly([1])
    for _ in range(1 + k % 3):
        degree = chance.random.randint(1, 3)
        p, q = chance.polynomial(degree, 5), chance.polynomial(chance.random.randint(0, degree), 5)
        c = chance.random.randint(1, 4)
        a, b = c * (p.derivative() * q - p * q.derivative()), p * p + q * q
        n, d = n * b + a * d, d * b
    return n, d


def factors(chance, k):
    d = product(chance.factor() for _ in range(2 + k % 4))
    return chance.polynomial(d.degree() - 1), d


def repeated(chance, k):
    if k % 5 == 4:
        d = chance.irreducible(3) ** chance.random.randint(2, 4)
    else:
        d = product(chance.factor() ** chance.random.randint(1, 4) for _ in range(2 + k % 2))
    return chance.polynomial(chance.random.randint(0, d.degree())), d


def irreducible(chance, k):
    degree = 3 + k % 6
    return chance.polynomial(chance.random.randint(0, degree - 1)), chance.irreducible(degree)


def high_degree(chance, k):
    degree = 10 + k
    if k % 3 == 2:
        return chance.polynomial(degree - 1), chance.irreducible(degree)
    d = fmpq_poly([1])
    while d.degree() < degree:
        d = d * chance.factor()
    return chance.polynomial(degree - 1), d


def long(chance, k):
    most = 10 ** 20
    d = product([chance.polynomial(1 + k % 2, most), chance.quadratic(most)])
    return chance.polynomial(d.degree() - 1, most), d


FAMILIES = {"angle": (angle, 90), "arctangents": (arctangents, 60), "factors": (factors, 50), "repeated": (repeated, 50),
            "irreducible": (irreducible, 42), "high-degree": (high_degree, 31), "long": (long, 17)}


def books():
    for line in CORPUS.read_text(encoding="utf-8").splitlines():
        entry = json.loads(line)
        is_a_fraction = "/" in entry["integrand"] and "." not in entry["integrand"]
        if entry["id"].split("-")[0] in BOOKS and is_a_fraction:
            yield entry["id"], "books", entry["integrand"].replace(entry["variable"], "x")


def functions():
    out = list(books())
    for family, (make, count) in FAMILIES.items():
        chance, found = Chance(family), []
        for k in range(10 * count):
            f = fraction(*make(chance, k)) if len(found) < count else None
            if f and f not in found:
                found.append(f)
        out += [("%s-%02d" % (family, k + 1), family, f) for k, f in enumerate(found)]
    return out


def digest():
    return hashlib.sha256(json.dumps(functions()).encode()).hexdigest()[:16]


if __name__ == "__main__":
    for row in functions():
        print("\t".join(row))
