"""SymPy reads what phrame prints for it and differentiates it: exactly, or what is too slow so
with 300 digits. The differences of its values are the integrals."""
import sys

import differences
import peers

try:
    import sympy
    from mpmath import mp
except ImportError:
    print("SymPy is not installed")
    sys.exit(peers.SKIP)


def root_sum(e, x):
    """What RootSum.doit() finds, a rational function, by traces in Q(x)[z]/(q), which takes a fraction of the time."""
    z, domain = e.poly.gen, sympy.QQ.frac_field(x)
    q = sympy.Poly(e.poly, z, domain=domain).monic()
    n, d = (sympy.Poly(p, z, domain=domain) for p in sympy.fraction(sympy.together(e.fun(z))))
    c = (n * sympy.invert(d, q)).rem(q).all_coeffs()[::-1]
    a, s = q.all_coeffs(), [sympy.Integer(q.degree())]  # s[k] is the sum of the k-th powers of the roots (Newton)
    for k in range(1, len(c)):
        s.append(-k * a[k] - sum(a[j] * s[k - j] for j in range(1, k)))
    return sum(ck * sk for ck, sk in zip(c, s))


def derivative(antiderivative, x):
    """With log|p| read as log(p), whose derivative is the same."""
    return sympy.diff(sympy.sympify(antiderivative).replace(sympy.Abs, lambda p: p), x)


def exactly(derivative, x):
    return derivative.replace(lambda e: isinstance(e, sympy.RootSum), lambda e: root_sum(e, x))


def function(f, x):
    """Of x, with the roots of each sum in the precision of mp."""
    sums = {e: sympy.Dummy() for e in f.atoms(sympy.RootSum)}
    terms = []
    for e in sums:
        coefficients = [mp.mpf(c.p) / c.q for c in e.poly.all_coeffs()]
        roots = mp.polyroots(coefficients, maxsteps=500, extraprec=1000)
        terms.append((roots, sympy.lambdify((x, e.poly.gen), e.fun(e.poly.gen), "mpmath")))
    rest = sympy.lambdify((x, *sums.values()), f.xreplace(sums), "mpmath")
    return lambda point: rest(point, *(mp.fsum(term(point, z) for z in roots) for roots, term in terms))


def is_close(f, g, x):
    """At three points. To simplify nested radicals, and functions of high degree, takes SymPy minutes."""
    with mp.workdps(300):
        points = [mp.mpf(n) / 11 for n in (37, -8, 29)]
        f, g = function(f, x), function(g, x)
        return all(abs(f(p) - g(p)) <= 1e-40 * abs(g(p)) for p in points)


def is_zero(f):
    numerator, _ = sympy.fraction(sympy.together(f))
    return sympy.expand(numerator) == 0


def read(text):
    """What the script defines, and its variable."""
    names = {}
    exec(text, names)
    return names, names[text.splitlines()[1].replace(",", " ").split()[0]]


count, failures = 0, []
for name, text in peers.scripts("sympy"):
    names, x = read(text)
    count += 1
    ours, f = derivative(names["antiderivative"], x), names["integrand"]
    is_slow = name.endswith("radicals") or sympy.degree(sympy.denom(f), x) > 12
    if not (is_close(ours, f, x) if is_slow else is_zero(exactly(ours, x) - f)):
        failures.append(name)
for name, text, f in peers.continuous("sympy"):
    names, x = read(text)
    count += 1
    with mp.workdps(60):
        F = function(sympy.sympify(names["antiderivative"]), x)
        values = [F(mp.mpf(t)) for t in differences.GRID]
        values = [complex(v - u) for u, v in zip(values, values[1:])]
    failures += [f"{name}, {jump}" for jump in differences.jumps(f, values)]
peers.finish(count, failures)
