"""phrame beside the integrators of SymPy, Maxima, FriCAS and Giac and the quadratures of PARI/GP, python-flint, SciPy and Numba, on the
curves of curves.cpp.

`./dev bench --peers` runs it with the program that it has built. It prints two tables: the CPU time to a closed form of the
Euler-Rodrigues angle, the antiderivative of -2h/sigma, and that to its value at 1, with the digits that are those of phrame.
A system that is not installed has no column.
"""
import argparse
import datetime
import decimal
import json
import math
import os
import pathlib
import re
import resource
import shutil
import signal
import statistics
import subprocess
import sys

DIGITS = 50
MEMORY = 4 << 30  # bytes of address space; Lisp takes the limit for the size of the machine, and collects garbage in time
ENOUGH = 0.3  # seconds: a shorter task is repeated, as some of the clocks count hundredths
START = 3  # seconds on top of the time-out, for a system to start
NO_FORM, NO_VALUE = "no closed form", "no value"


def preimage(m):
    """u, v, p, q of `random_curve(m)`: Knuth's linear congruential generator, its upper bits."""
    state, coefficients = 2003 + m, []
    for _ in range(4 * (m + 1)):
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        coefficients.append((state >> 33) % 19 - 9)
    polynomials = [coefficients[k:k + m + 1] for k in range(0, len(coefficients), m + 1)]
    return [[*a[:-1], a[-1] or 1] for a in polynomials]


def product(a, b):
    result = [0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            result[i + j] += x * y
    return result


def integrand(m):
    """-2h/sigma as text, h = uv' - u'v - pq' + p'q and sigma = u^2 + v^2 + p^2 + q^2, by lists of ascending coefficients."""
    def wronskian(a, b):
        da, db = ([k * x for k, x in enumerate(c)][1:] for c in (a, b))
        return [x - y for x, y in zip(product(a, db), product(da, b))]

    def text(a):
        return "(" + " + ".join(f"({x})*t^{k}" for k, x in enumerate(a) if x) + ")"

    u, v, p, q = preimage(m)
    minus_2h = [-2 * (x - y) for x, y in zip(wronskian(u, v), wronskian(p, q))]
    return text(minus_2h) + "/" + text([sum(x) for x in zip(*(product(a, a) for a in (u, v, p, q)))])


class System:
    """A task is a pair: the work that is repeated and timed, and what is said of its last result: `@closed` of an antiderivative
    without an integral in it, `@value` with the real part and, where there can be one, the imaginary part. The script puts the
    work into a loop, after it has integrated 1/(t^4 + t + 1), for which a system loads what it needs, and prints `@time`.
    """
    variant = ""
    closed = None  # F, the antiderivative of f
    value = None  # G = F(1) - F(0), or where there is no `closed` by a numerical rule, from f: to find F is part of the work
    quadrature = None  # G by a numerical rule, shown with a mark where there is no value
    refusal = None  # what it says when it stops because it cannot evaluate F

    def version(self):
        """None if it is not installed."""
        if not shutil.which(self.command[0]):
            return None
        command = [self.command[0], self.version_option]
        return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True).stdout


class OfPython(System):
    """A package of the system's Python, or of the one that runs this."""

    def version(self):
        for python in filter(None, (shutil.which("python3", path=os.defpath), sys.executable)):
            self.command = [python, "-"]
            asked = f"print(__import__('{self.package}').__version__)"
            result = subprocess.run(self.command, input=asked, capture_output=True, text=True)
            if result.returncode == 0:
                return result.stdout
        return None


class SymPy(OfPython):
    """With an empty cache before each repetition."""
    name, package = "SymPy", "sympy"
    closed = "F = ratint(f, t)", "print('' if F.has(Integral) else '@closed')"
    value = "F = ratint(f, t); G = (F.subs(t, 1) - F.subs(t, 0)).evalf(50)", "print('@value', *G.as_real_imag())"
    quadrature = "G = Integral(f, (t, 0, 1)).evalf(50)", "print('@value', *G.as_real_imag())"
    script = """
import time
from sympy import Integral, symbols, sympify
from sympy.core.cache import clear_cache
from sympy.integrals.rationaltools import ratint
t = symbols("t")
f = sympify("%(f)s")
ratint(1 / (t**4 + t + 1), t)
spent = 0
for _ in range(%(count)d):
    clear_cache()
    start = time.process_time()
    %(work)s
    spent += time.process_time() - start
print("@time", spent / %(count)d)
%(report)s
"""


class ComplexSymPy(SymPy):
    """Does not look for real logarithms and arctangents, which is what takes the time."""
    variant = ", real=False"
    closed, value = ((work.replace("(f, t)", "(f, t, real=False)"), report) for work, report in (SymPy.closed, SymPy.value))
    quadrature = None


class Maxima(System):
    """Its sums over rootsof have values where rootsof is given a definition. elapsed_run_time is CPU time, whatever its name, but
    in some Lisps without that of the kernel.
    """
    name, command, version_option = "Maxima", ["maxima", "--very-quiet"], "--version"
    closed = "F: integrate(f, t)", "if not freeof(t, F) and freeof(nounify('integrate), F) then print(\"@closed\")$"
    value = ("(F: integrate(f, t), G: rectform(bfloat(ev(subst(t = 1, F) - subst(t = 0, F), nouns))))",
             'print("@value", realpart(G), imagpart(G))$')
    quadrature = "G: first(quad_qags(f, t, 0, 1))", 'print("@value", G)$'
    script = """
display2d: false$ linel: 100000$ ratprint: false$ integrate_use_rootsof: true$ fpprec: 60$
rootsof(q, z) := map('rhs, bfallroots(q))$
f: %(f)s$
integrate(1/(t^4 + t + 1), t)$
start: elapsed_run_time()$
for k: 1 thru %(count)d do %(work)s$
print("@time", (elapsed_run_time() - start)/%(count)d)$
%(report)s
"""


class FriCAS(System):
    """It stops at the first error, lest it goes on with what it has not found."""
    name, command, version_option = "FriCAS", ["fricas", "-nosman"], "--version"
    closed = "F := integrate(f, t)", "if not member?('integral, [name k for k in tower F]) then output \"@closed\""
    value = ("(F := integrate(f, t); G := numeric(eval(F, t = 1) - eval(F, t = 0)))",
             'output concat("@value ", convert(G)@String)')
    quadrature = "G := romberg(g, 0.0, 1.0, 1.0e-50, 1.0e-50, 5, 20).value", 'output concat("@value ", convert(G)@String)'
    refusal = "Can only compute the numerical value of a constant"
    script = """
)set break quit
)set output algebra off
digits 60
outputSpacing 0
f := %(f)s
r: Fraction UP('t, Fraction Integer) := f
g(t: Float): Float == %(f)s
g(0.5)
integrate(1/(t^4 + t + 1), t)
)lisp (setq phrame-start (get-internal-run-time))
for k in 1..%(count)d repeat %(work)s
)lisp (format t "~%%@time ~f~%%" (/ (- (get-internal-run-time) phrame-start) internal-time-units-per-second %(count)d))
%(report)s
"""


class SummingFriCAS(FriCAS):
    """The function that `integrate` calls before it writes the sum over roots by real functions; it leaves that sum as it is."""
    variant = ", root sum"
    closed = ("F := integrate(r)$RationalIntegration(Fraction Integer, UP('t, Fraction Integer))",
              'if elem? F then output "@closed"')
    value, quadrature = None, None


class Giac(System):
    name, command, version_option = "Giac", ["giac"], "--version"
    closed = "F:=integrate(f,t)", 'if (inString(string(F),"integrate")<0) print("@closed"); else print("");'
    value = "F:=integrate(f,t); G:=evalf(subst(F,t=1)-subst(F,t=0))", 'print("@value "+re(G)+" "+im(G));'
    quadrature = "G:=integrate(f,t,0.0,1.0)", 'print("@value "+re(G)+" "+im(G));'
    script = """
Digits:=50;
f:=%(f)s:;
integrate(1/(t^4+t+1),t):;
T:=time(for(k:=0;k<%(count)d;k++){ %(work)s; })[0]:;
print("@time "+T/%(count)d);
%(report)s
"""


class PARI(System):
    """57 digits are three words of 64 bits. It has no integrator: the value is that of its quadrature, and not marked."""
    name, command, version_option = "PARI/GP", ["gp", "-q", "-f"], "--version-short"
    value = "v = intnum(x = 0, 1, subst(P, t, x)/subst(Q, t, x))", 'print("@value ", v);'
    script = """
default(realprecision, 57); default(parisizemax, "4G");
f = %(f)s; P = numerator(f); Q = denominator(f);
gettime();
for(k = 1, %(count)d, %(work)s);
print("@time ", strprintf("%%.9f", gettime()/1000./%(count)d));
%(report)s
"""


class RothsteinTragerPARI(PARI):
    """The residues are the roots z of the resultant of n - zd' and d, and of each factor of it the logarithm is of a gcd over ℚ[z]."""
    variant = ", Rothstein–Trager"
    closed = ("R = polresultant(P - z*Q', Q, t); F = [gcd(Q*Mod(1, s), P - Mod(z, s)*Q') | s <- factor(R)[, 1]~]",
              'if(vecmin(apply(poldegree, F)) > 0, print("@closed"))')
    value = None


class OfPolynomials(OfPython):
    """A quadrature of n/d, whose coefficients the script has, ascending; the value is that of it, and not marked."""
    script = """
import re
import time
%(imports)s
parts = ([(int(k), int(c)) for c, k in re.findall(r"\\((-?\\d+)\\)\\*t\\^(\\d+)", part)] for part in "%%(f)s".split(")/("))
n, d = ([dict(part).get(k, 0) for k in range(part[-1][0] + 1)] for part in parts)
%(setup)s
start = time.process_time()
for _ in range(%%(count)d):
    %%(work)s
print("@time", (time.process_time() - start) / %%(count)d)
%%(report)s
"""


class PythonFlint(OfPolynomials):
    """Arb's quadrature by balls, which proves what it finds."""
    name, package = "python-flint", "flint"
    value = "G = acb.integral(lambda t, _: n(t) / d(t), 0, 1).real", "print('@value', G.str(50, radius=False))"
    script = OfPolynomials.script % {"imports": "from flint import acb, ctx, fmpz_poly",
                                     "setup": "ctx.dps, n, d = 57, fmpz_poly(n), fmpz_poly(d)"}


class SciPy(OfPolynomials):
    """In doubles, to the least error that it takes."""
    name, package = "SciPy", "scipy"
    value = "G = quad(lambda t: polyval(t, n) / polyval(t, d), 0, 1, epsabs=0, epsrel=1e-13)[0]", "print('@value', repr(float(G)))"
    script = OfPolynomials.script % {"imports": "from numpy.polynomial.polynomial import polyval\nfrom scipy.integrate import quad",
                                     "setup": "quad(lambda t: t, 0, 1)"}


class Numba(OfPolynomials):
    """In doubles, what a program of one's own does: Gauss's rule of seven points on 1, 2, 4, … parts, compiled, until two sums agree."""
    name, package = "Numba", "numba"
    value = "G = integral(n, d)", "print('@value', repr(float(G)))"
    script = OfPolynomials.script % {"imports": "import numpy as np\nfrom numba import njit", "setup": """
nodes, weights = np.polynomial.legendre.leggauss(7)
n, d = np.array(n, dtype=float), np.array(d, dtype=float)

@njit
def at(p, t):
    value = 0.0
    for c in p[::-1]:
        value = value * t + c
    return value

@njit
def integral(n, d):
    last, parts = np.inf, 1
    while parts < 2 ** 20:
        total = 0.0
        for k in range(parts):
            for j in range(len(nodes)):
                t = (k + 0.5 + 0.5 * nodes[j]) / parts
                total += weights[j] * at(n, t) / at(d, t)
        total /= 2 * parts
        if abs(total - last) <= 1e-13 * abs(total):
            break
        last, parts = total, 2 * parts
    return total

integral(n, d)
"""}


SYSTEMS = {"sympy": SymPy, "sympy-complex": ComplexSymPy, "maxima": Maxima, "fricas": FriCAS, "fricas-sum": SummingFriCAS,
           "giac": Giac, "pari": PARI, "pari-rothstein-trager": RothsteinTragerPARI, "python-flint": PythonFlint, "scipy": SciPy, "numba": Numba}


class Failed(Exception):
    """Its text is what the table shows."""


def spent():
    """CPU seconds, user and system, of all processes that have been started and have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(command, script, seconds):
    """What a system prints that reads the script. It is killed with its children after that many CPU seconds, which other work
    on the machine does not shorten, or, should it wait for something, after ten times as many by the clock.
    """
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(seconds + START),) * 2)

    before = spent()
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               errors="replace", start_new_session=True, preexec_fn=limit)
    try:
        text = process.communicate(script, timeout=10 * (seconds + START))[0]
    except subprocess.TimeoutExpired:
        raise Failed(f"> {seconds:g} s") from None
    finally:
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()
    if said(text, "time") is None and spent() - before >= seconds:  # PARI ends by itself then
        raise Failed(f"> {seconds:g} s")
    return text


def said(text, what):
    """What follows @what where it begins a line, or stands behind FriCAS's prompt; the echo of a script has it elsewhere."""
    found = re.search(rf"^(?:\(\d+\) -> *)*\s*@{what}\b *(.*)$", text, re.MULTILINE)
    return found and found[1].strip()


def measure(system, f, task, timeout):
    """CPU seconds of one repetition, and what the system said. Repeats as often as its clock needs."""
    (work, report), count = task, 1
    while True:
        text = run(system.command, system.script % {"f": f, "work": work, "report": report, "count": count}, timeout)
        time = said(text, "time")
        if time is None:
            if system.refusal and system.refusal in text:
                raise Failed(NO_VALUE)
            raise Failed("out of memory" if re.search("[Mm]emory|bad_alloc|exhausted|stack overflow", text) else "failed")
        seconds = float(time)
        if seconds * count >= ENOUGH or count >= 10000:
            return seconds, text
        count = min(20 * count, math.ceil(1.2 * ENOUGH / seconds)) if seconds else 20 * count


def agreement(text, reference):
    """How many digits are those of phrame, to a unit of the last, or by what the value is off."""
    try:
        value, *imaginary = (decimal.Decimal(part.replace("b", "e")) for part in text.split())
    except (decimal.InvalidOperation, ValueError, AttributeError):
        raise Failed(NO_VALUE) from None
    if not value.is_finite() or any(not abs(part) < 1e-10 for part in imaginary):
        return "wrong"
    error, leading = value - reference, reference.adjusted() + 1
    for digits in range(DIGITS, 2, -1):
        if abs(error) <= decimal.Decimal(10) ** (leading - digits):
            return f"{digits} digits"
    turns = round(float(error) / math.pi)
    return f"off by {turns}π" if turns and abs(float(error) - turns * math.pi) < 1e-8 else "wrong"


def duration(seconds):
    """Two significant digits."""
    number, unit = (seconds, "s") if seconds >= 0.995 else (1000 * seconds, "ms")
    if number < 0.001:
        return "< 0.001 ms"
    number = float(f"{number:.1e}")
    return f"{number:.{max(0, 1 - math.floor(math.log10(number)))}f} {unit}"


class Column:
    """The cells of a system, from top to bottom. What fails once for want of time or memory is not tried again."""

    def __init__(self, system, timeout):
        self.system, self.timeout, self.failures = system, timeout, set()

    def attempt(self, task, f, reference):
        """The cell of a task, and whether it is a result."""
        if task in self.failures:
            return "not tried", False
        try:
            seconds, text = measure(self.system, f, getattr(self.system, task), self.timeout)
            if task != "closed":
                return f"{duration(seconds)}, {agreement(said(text, 'value'), reference)}", True
            return (NO_FORM, False) if said(text, "closed") is None else (duration(seconds), True)
        except Failed as failure:
            if str(failure) != NO_VALUE:
                self.failures.add(task)
            return str(failure), False

    def cells(self, m, reference):
        """A value that is to come from a closed form needs one; without it, or without a value, a quadrature is shown."""
        f = integrand(m)
        closed, found = self.attempt("closed", f, reference) if self.system.closed else ("—", True)
        if not self.system.value:
            return closed, "—"
        if found:
            value, found = self.attempt("value", f, reference)
        else:
            value = NO_VALUE if closed == NO_FORM else closed
        if not found and self.system.quadrature:
            value += f"; † {self.attempt('quadrature', f, reference)[0]}"
        return closed, value


def phrame(program, *arguments, text=""):
    """The median of the CPU seconds, user and system, of five runs of the program, and its output."""
    times = []
    for _ in range(5):
        before = spent()
        output = subprocess.run([program, *arguments], input=text, check=True, stdout=subprocess.PIPE, text=True).stdout
        times.append(spent() - before)
    return statistics.median(times), output


def options():
    """The arguments; what is wrong with them is said in one line."""
    parser = argparse.ArgumentParser(description="phrame beside computer-algebra systems: two tables in Markdown")
    parser.error = lambda message: parser.exit(2, f"{parser.prog}: {message}\n")
    parser.add_argument("program", metavar="PROGRAM", help="phrame")
    parser.add_argument("--timeout", metavar="SECONDS", type=float, default=60, help="for each task (default 60)")
    parser.add_argument("--m", metavar="M,...", default="1,2,3,5,10,20,40", help="degrees of the preimages (default %(default)s)")
    parser.add_argument("--systems", metavar="NAME,...", default=",".join(SYSTEMS), help="default %(default)s")
    chosen = parser.parse_args()
    if not shutil.which(chosen.program):
        parser.error(f"not a program: {chosen.program}")
    if not 0 < chosen.timeout < 1e6:
        parser.error(f"--timeout: not a number of seconds: {chosen.timeout}")
    if not re.fullmatch(r"[1-9]\d{0,3}(,[1-9]\d{0,3})*", chosen.m):
        parser.error(f"--m: not a list of positive integers: {chosen.m}")
    for key in chosen.systems.split(","):
        if key not in SYSTEMS:
            parser.error(f"--systems: no such system: {key}")
    return chosen


def main():
    chosen = options()
    start, version = phrame(chosen.program, "--version")
    rothstein_trager = "--form", "rothstein-trager"
    heads, columns, missing = ["degree / m", version.strip(), " ".join(rothstein_trager)], [], []
    for system in (SYSTEMS[key]() for key in dict.fromkeys(chosen.systems.split(","))):
        version = system.version()
        if version is None:
            missing.append(system.name)
        else:
            columns.append(Column(system, chosen.timeout))
            heads.append(f"{system.name} {re.search('[0-9]+([.][0-9]+)+', version)[0]}{system.variant}")

    rows = {"Closed form of θ": [], "Value of θ(1), from the curve": []}
    for m in map(int, chosen.m.split(",")):
        text = json.dumps({"phrame": "curve/1", "basis": "power", "preimage": dict(zip("uvpq", preimage(m)))})
        form, _ = phrame(chosen.program, "angle", "-", text=text)
        value, answer = phrame(chosen.program, "angle", "-", "--at", "1", "--digits", str(DIGITS), "--print", "json", text=text)
        sums, _ = phrame(chosen.program, "angle", "-", *rothstein_trager, text=text)
        pairs = [(duration(form), duration(value)), (duration(sums), "—")]
        for column in columns:
            if sys.stderr.isatty():
                print(f"m = {m}: {column.system.name}{column.system.variant}", file=sys.stderr)
            pairs.append(column.cells(m, decimal.Decimal(json.loads(answer)["values"][0]["theta"])))
        for table, cells in zip(rows.values(), zip(*pairs)):
            table.append([f"{2 * m + 1} / {m}", *cells])

    model = re.search(r"^model name\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.MULTILINE)
    print(f"""\
CPU time on {model[1] if model else 'a nameless processor'}, {datetime.date.today()}; again by `./dev bench --peers`.
That of phrame is of the whole program, of which {duration(start)} are its start; that of the others is inside the system.""")
    if missing:
        print(f"Not installed: {', '.join(missing)}.")
    for title, table in rows.items():
        print(f"\n{title}:\n")
        for row in (heads, ["---"] * len(heads), *table):
            print(f"| {' | '.join(row)} |")
    print(f"""
Of {DIGITS} digits those are counted that are phrame's, to a unit of the last. The value is F(1) − F(0) from the closed form F,
which is found anew; † is a quadrature by the system, where F has not been found or has no value; the values of PARI, python-flint,
SciPy and Numba are always one. In Maxima rootsof is defined by bfallroots.""")


if __name__ == "__main__":
    decimal.getcontext().prec = DIGITS + 30
    main()
