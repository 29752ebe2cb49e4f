"""Judges antiderivatives: F as text of any of the systems, f a rational function.

On each interval between real poles of f there are points a0 < a1 < …, and F(a[k+1]) - F(a[k]) is compared with the integral of f from a[k] to
a[k+1], enclosed by acb.integral of python-flint, which is proved. F is evaluated in balls too, by the principal values of log, atan and powers
that all of the systems have. The verdicts:

    right   all differences are within 10^-20, relative
    jump    some are not, and halving the interval finds one place where F jumps, so that F' = f but there
    wrong   some are not, and no jump is why
    none    there is no answer, an integral is left in it, or it has decimals
    unread  the text is too long to be judged, or the judge does not know what is in it

A sum over roots, and roots of polynomials that have names, are put in by the numbers; where a system does not say which root is meant, any choice that
makes it right will do.
"""
import ast
import re
import sys
from fractions import Fraction
from itertools import islice, permutations

from flint import acb, acb_poly, arb, ctx, fmpq, fmpq_poly, fmpz_poly

POINTS = 11  # of an interval between poles
INTERVALS = 5  # that many of them, the longest
LONGEST = 400000  # letters
BITS = (300, 1500)
ENOUGH = arb(10) ** -20
LEFT = re.compile(r"\b(integrate|Integral|integral|int)\b")


class Unread(Exception):
    pass


def number(x):
    return x if isinstance(x, acb) else acb(arb(x))


def snapped(z):
    """Real, if it may be: what is meant is on the axis, or far from it."""
    z = number(z)
    return acb(z.real) if z.imag.contains(0) else z


def power(a, b):
    if isinstance(b, fmpq) and b.q == 1 and not isinstance(a, int):
        b = int(b.p)
        if isinstance(a, (fmpq_poly, acb_poly)):
            return a ** b
        return a ** b if b >= 0 else 1 / a ** -b
    if isinstance(b, fmpq) and b == fmpq(1, 2):
        return snapped(a).sqrt()
    return snapped(a) ** number(b)


def roots_of(p):
    """Of a polynomial, the real ones with an imaginary part that is exactly 0, if its coefficients are rational."""
    if isinstance(p, fmpq_poly):
        q = p * int(p.denom())
        return [root for root, m in fmpz_poly([int(c) for c in q.coeffs()]).complex_roots() for _ in range(m)]
    if isinstance(p, acb_poly):
        return p.roots(tol=arb(2) ** -(ctx.prec * 2 // 3))
    raise Unread("roots of no polynomial")


class Evaluator:
    """Of one text, for x and some choice of roots; what does not depend on x is computed once."""

    def __init__(self, text, choice):
        self.choice, self.names, self.constants = choice, {}, {}
        body, *roots = text.split(" ; ")
        self.tree = parsed(body)
        self.hangs = {}
        self.mark(self.tree)
        for k in reversed(range(len(roots))):  # FriCAS: root1 is the outermost, of a polynomial in those behind it
            name = "root%d" % (k + 1)
            p = self.polynomial(parsed(roots[k]), name)
            found = roots_of(p)
            self.names[name] = found[choice[(len(roots) - 1 - k) % len(choice)] % len(found)]

    def mark(self, node):
        """Whether a node has x or a bound name in it."""
        names = isinstance(node, ast.Name) and not re.fullmatch(r"root\d+", node.id)
        stack = [self.mark(child) for child in ast.iter_child_nodes(node)]
        self.hangs[node] = names or any(stack)
        return self.hangs[node]

    def polynomial(self, tree, name):
        for make in (fmpq_poly, acb_poly):
            self.constants.clear()
            try:
                return self.value(tree, {**self.names, name: make([0, 1])})
            except TypeError:
                pass
        raise Unread("a polynomial")

    def value(self, node, names):
        if isinstance(node, ast.Constant):
            if isinstance(node.value, int):
                return fmpq(node.value)
            raise Unread(repr(node.value))
        if not self.hangs.get(node, True) and node in self.constants:
            return self.constants[node]
        out = self.computed(node, names)
        if not self.hangs.get(node, True):
            self.constants[node] = out
        return out

    def computed(self, node, names):
        if isinstance(node, ast.Name):
            if node.id in names:
                return names[node.id]
            if node.id in ("pi", "Pi"):
                return acb(arb.pi())
            if node.id in ("I", "i"):
                return acb(0, 1)
            if node.id in ("E", "e"):
                return acb(1).exp()
            raise Unread("the name " + node.id)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.UAdd)):
            a = self.value(node.operand, names)
            return -a if isinstance(node.op, ast.USub) else a
        if isinstance(node, ast.BinOp):
            a, b = self.value(node.left, names), self.value(node.right, names)
            if isinstance(node.op, ast.Pow):
                return power(a, b)
            if isinstance(a, fmpq) != isinstance(b, fmpq) and not any(isinstance(c, fmpq_poly) for c in (a, b)):
                a, b = (number(c) if isinstance(c, fmpq) else c for c in (a, b))
            if isinstance(node.op, ast.Add):
                return a + b
            if isinstance(node.op, ast.Sub):
                return a - b
            if isinstance(node.op, ast.Mult):
                return a * b
            if isinstance(node.op, ast.Div):
                return a * (1 / b) if isinstance(a, acb_poly) else a / b
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            return self.called(node.func.id, node.args, names)
        raise Unread(type(node).__name__)

    def called(self, name, arguments, names):
        if name in ("lsum", "RootSum"):
            if name == "lsum":
                summand, variable, roots = arguments
                polynomial, bound = roots.args
                variable = bound.id
            else:
                polynomial, function = arguments[:2]
                variable, summand = function.args[0].id, function.args[1]
                bound = ast.Name(id=variable)
            key = (id(polynomial), variable)
            if key not in self.constants:
                free = next(n.id for n in ast.walk(polynomial) if isinstance(n, ast.Name))
                self.constants[key] = roots_of(self.polynomial(polynomial, free))
            return sum((number(self.value(summand, {**names, variable: root})) for root in self.constants[key]), acb(0))
        if name == "rootof":
            lists = [fmpq_poly([int(ast.literal_eval(c)) for c in reversed(row.elts)]) for row in arguments[0].elts]
            found = roots_of(lists[1])
            root, value = found[self.choice[0] % len(found)], acb(0)
            for c in reversed(lists[0].coeffs()):
                value = value * root + number(c)
            return value
        if name == "pi":
            return acb(arb.pi())
        z = self.value(arguments[0], names)
        if name in ("log", "ln"):
            return snapped(z).log()
        if name in ("atan", "arctan"):
            return snapped(z).atan()
        if name == "sqrt":
            return power(z, fmpq(1, 2))
        if name == "abs":
            return acb(abs(number(z)))
        if name in ("atanh", "sin", "cos", "tan", "exp"):
            return getattr(snapped(z), name)()
        raise Unread("the function " + name)


def parsed(text):
    text = text.replace("'", "").replace("^", "**").replace("%r", "R").replace("%", "")
    return ast.parse(text.strip(), mode="eval").body


class Rational:
    """f, by its exact numerator and denominator."""

    def __init__(self, text):
        x = (fmpq_poly([0, 1]), fmpq_poly([1]))
        n, d = self.ratio(parsed(text), x)
        g = n.gcd(d)
        self.n, self.d, self.integrals = n // g, d // g, {}
        content, found = fmpz_poly([int(c) for c in (self.d * int(self.d.denom())).coeffs()]).factor()
        self.constant, self.factors = fmpq(int(content), int(self.d.denom())), found

    def ratio(self, node, x):
        if isinstance(node, ast.Constant):
            return fmpq_poly([node.value]), fmpq_poly([1])
        if isinstance(node, ast.Name):
            return x
        if isinstance(node, ast.UnaryOp):
            n, d = self.ratio(node.operand, x)
            return -n, d
        a, b = self.ratio(node.left, x)
        if isinstance(node.op, ast.Pow):
            return a ** node.right.value, b ** node.right.value
        c, d = self.ratio(node.right, x)
        if isinstance(node.op, ast.Mult):
            return a * c, b * d
        if isinstance(node.op, ast.Div):
            return a * d, b * c
        return a * d + (c if isinstance(node.op, ast.Add) else -c) * b, b * d

    def intervals(self):
        """Between the real poles, and a piece of the rays beyond them: (a, b), rational."""
        roots = roots_of(self.d) if self.d.degree() > 0 else []
        poles = sorted({float(z.real.mid()) for z in roots if z.imag == 0})
        reach = Fraction(max([1.0, *(abs(float(abs(z).mid())) for z in roots)])).limit_denominator(100) + 1
        ends = [-reach * 3, *(Fraction(p) for p in poles), reach * 3]
        found = []
        for a, b in zip(ends, ends[1:]):
            if b - a > Fraction(1, 10 ** 9):
                found.append((a, b))
        return sorted(sorted(found, key=lambda i: i[0] - i[1])[:INTERVALS])

    def points(self):
        """Lists of them, none at a place that anybody would choose."""
        for a, b in self.intervals():
            yield [(a + (b - a) * Fraction(97 * (2 * k + 1) + 5 * (k % 3), 97 * 2 * POINTS + 13)).limit_denominator(10 ** 12) for k in range(POINTS)]

    def integral(self, a, b):
        """From a to b, enclosed; kept, for the next answer."""
        if (a, b) not in self.integrals:
            bits, ctx.prec = ctx.prec, 160
            n, factors = acb_poly(self.n / self.constant), [(acb_poly(p), k) for p, k in self.factors]

            def f(z, _):  # by factors: near a multiple pole the product, expanded, has no digit
                value = n(z)
                for p, k in factors:
                    value = value / p(z) ** k
                return value
            ends = [number(fmpq(t.numerator, t.denominator)) for t in (a, b)]
            self.integrals[a, b] = acb.integral(f, *ends)
            ctx.prec = bits
        return self.integrals[a, b]


def at(evaluator, t):
    return number(evaluator.value(evaluator.tree, {**evaluator.names, "x": fmpq(t.numerator, t.denominator)}))


def difference_is(evaluator, integral, a, b):
    """None if it cannot be told at this precision, else the difference from the integral if there is one, else 0."""
    found = at(evaluator, b) - at(evaluator, a) - integral
    if not found.is_finite():
        return None
    most = ENOUGH * (abs(integral).mid() + arb(10) ** -60)
    if abs(found) < most:
        return 0
    return found if not abs(found).contains(0) and abs(found) > most else None


def jump_in(evaluator, f, a, b, error):
    """The place of (a, b) that has half of the error or more, or None."""
    for _ in range(60):
        c = (a + b) / 2
        parts = [(u, v, difference_is(evaluator, f.integral(u, v), u, v)) for u, v in ((a, c), (c, b))]
        if any(d is None for _, _, d in parts):  # at the place itself nothing is told
            return float(c) if b - a < Fraction(1, 10 ** 9) else None
        a, b, rest = max(parts, key=lambda part: 0.0 if isinstance(part[2], int) else float(abs(part[2]).mid()))
        if isinstance(rest, int):
            return None
    return None if abs(rest) < abs(error) / 2 else float(a)


def choices(text):
    if "rootof([[" in text:
        return [(k,) for k in range(12)]
    if " ; " in text:
        return list(islice(permutations(range(min(5, text.count(" ; ") + 1))), 24))
    return [(0,)]


def judged(f, answer):
    """One of the verdicts on an answer for the Rational f, and where the first jump is, or why it is wrong or unread."""
    if answer is None or LEFT.search(answer):
        return "none", None
    if re.search(r"\d\.\d", answer):
        return "none", "decimals"
    if len(answer) > LONGEST:
        return "unread", "%d letters" % len(answer)
    sys.setrecursionlimit(100000)
    best = None
    for choice in choices(answer):
        verdict = judged_with(f, answer, choice)
        if verdict[0] == "right":
            return verdict
        if best is None or verdict[0] == "jump" and best[0] != "jump":
            best = verdict
    return best


def judged_with(f, answer, choice):
    todo, reason = [(a, b) for row in f.points() for a, b in zip(row, row[1:])], "for want of digits"
    for bits in BITS:
        ctx.prec = bits
        try:
            verdict, todo = judged_at(f, answer, choice, todo)
        except (Unread, SyntaxError, ValueError, KeyError, IndexError, TypeError, ZeroDivisionError, RecursionError, MemoryError) as problem:
            reason = "%s %s" % (type(problem).__name__, str(problem)[:100])  # roots may be found with more digits
            continue
        if verdict is not None:
            return verdict
    return "unread", reason


def judged_at(f, answer, choice, todo):
    """(the verdict, or None; what could not be told)"""
    evaluator, rest, jump = Evaluator(answer, choice), [], None
    for a, b in todo:
        error = difference_is(evaluator, f.integral(a, b), a, b)
        if error is None:
            rest.append((a, b))
        elif not isinstance(error, int):
            place = jump_in(evaluator, f, a, b, error)
            if place is None:
                return ("wrong", "by %.2g from %.6g to %.6g" % (float(abs(error).mid()), float(a), float(b))), []
            jump = place if jump is None else jump
    if jump is not None:
        return ("jump", "at %.6g" % jump), []
    return (None if rest else ("right", None)), rest
