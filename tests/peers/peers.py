"""What the tests with other systems have in common: the integrands, and what phrame prints of them.

A test runs `phrame integrate … --print SYSTEM`, gives the output to the system, and has the system differentiate
`antiderivative` and compare it with `integrand`; and evaluate it on a grid, for differences.py. It exits with 0, with 1
after naming what failed, or with SKIP where the system is not installed. First it checks antiderivatives that are wrong,
BROKEN: each must fail.

The selection, for every day, is the integrals of IDS, differentiated in the first form and one of the others (but those
of SLOW) and evaluated in the first, and the angles of CURVES, each to one of the frames. With PHRAME_PEERS=corpus (./dev test --peers) it is tests/data/integrals.jsonl and unbounded.jsonl,
differentiated in all forms and evaluated in those that phrame does not say may jump, and the angles of all of
tests/data/curves.jsonl in both frames; on a grid twice as dense, by all processors.
"""
import functools
import json
import multiprocessing
import os
import pathlib
import re
import signal
import subprocess
import sys
from typing import NamedTuple

import differences

SKIP = 77

# Of every kind that is printed differently: residues in Q, Q(i), quadratic and biquadratic fields and beyond, multiple poles, no pole, 0.
IDS = """
    sympy-25896 sympy-8246-atan-4 sympy-28657 sympy-28186 sympy-5907 sympy-6828 sympy-12305 sympy-ratint-doc
    sympy-ratint-zero sympy-ratint-improper fricas-198 maxima-1778796 maxima-2907727 angourimath-1284 gcl-x3-x-1 gcl-x2-2
    rioboo hardy-1916 leibniz-1702 wang-59 timofeev-18 hearn-04 con-sqrt2-a con-cubic-a con-qi-b con-irrational-pv
    con-real-quintic binomial-plus-12 con-swinnerton-dyer-3
""".split()
# Over biquadratic fields of degree 8 SymPy takes seconds to differentiate them; they are evaluated only.
SLOW = {"binomial-plus-12", "con-swinnerton-dyer-3"}
# Of degree 3 to 11, of each way that the angle is printed: by arctangents, by one sum over roots, by several.
CURVES = """
    gen-m01-0 gen-m02-0 gen-m04-0 coi-rrmf5-0 coi-planar-2_2 coi-right-2_1 coi-right-2_3 coi-reparam-1_5 coi-reparam-2_2
    deg-nearcusp deg-line fac-lin-m03 fac-mix-2_3 fac-rep-1_3 fac-gcd-2_2 dbl-m02 seed-farouki2003
""".split()
FORMS = ["auto", "partial-fractions", "rothstein-trager", "lazard-rioboo-trager", "real", "radicals"]
UNDEFINED = 3  # phrame's exit status for radicals, or a Frenet frame, that do not exist
IS_CORPUS = os.environ.get("PHRAME_PEERS") == "corpus"
LIMIT = 600  # seconds for an antiderivative
MAY_JUMP = "the logarithms may cross their cut"  # a comment of phrame's: the form asked for is not continuous

TESTS = pathlib.Path(__file__).parent.parent


class Job(NamedTuple):
    """An integral, as phrame's arguments but for the form."""
    name: str
    arguments: list
    text: str = ""
    differentiated: list = []  # the forms
    evaluated: list = []

    def print_for(self, system, form="auto"):
        """Nothing where it does not exist."""
        command, *rest = self.arguments
        result = subprocess.run([os.environ["PHRAME_PROGRAM"], command, "--print", system, "--form", form, *rest],
                                input=self.text, capture_output=True, text=True)
        if result.returncode == UNDEFINED and (command == "angle" or form == "radicals"):
            return ""
        result.check_returncode()
        return result.stdout

    def scripts(self, system):
        """What phrame prints for the system, by form; the same text once, under the first of its forms."""
        forms = {}
        for form in [f for f in FORMS if f in self.differentiated + self.evaluated]:
            text = self.print_for(system, form)
            if text:
                forms.setdefault(text, form)
        return {form: text for text, form in forms.items()}

    def integrand(self):
        return differences.Integrand(json.loads(self.print_for("json"))["integrand"])


class Found(NamedTuple):
    """What a check of a job has found."""
    antiderivatives: int = 0
    differences: int = 0
    largest: float = 0  # difference of a difference from the integral
    failures: list = []
    skipped: list = []

    def __add__(self, other):
        return Found(self.antiderivatives + other.antiderivatives, self.differences + other.differences,
                     max(self.largest, other.largest), self.failures + other.failures, self.skipped + other.skipped)


def read(name):
    """The objects of a file of tests/data."""
    return [json.loads(line) for line in (TESTS / "data" / name).read_text(encoding="utf-8").splitlines()]


def jobs():
    for k, entry in enumerate(read("integrals.jsonl") + (read("unbounded.jsonl") if IS_CORPUS else [])):
        if IS_CORPUS or entry["id"] in IDS:
            differentiated = FORMS
            if not IS_CORPUS:
                differentiated = [] if entry["id"] in SLOW else [FORMS[0], FORMS[1 + k % 5]]
            yield Job(entry["id"], ["integrate", "--", entry["integrand"]], "", differentiated,
                      FORMS if IS_CORPUS else FORMS[:1])
    curve = TESTS.parent / "examples" / "curves" / "farouki-2003-quintic.json"
    yield Job("Frenet angle", ["angle", "--frame", "frenet", str(curve)], "", FORMS if IS_CORPUS else FORMS[:-1])
    for k, curve in enumerate(read("curves.jsonl")):
        if IS_CORPUS or curve["name"] in CURVES:
            # The real form of the others takes up to megabytes.
            is_short = len(curve["preimage"]["u"]) < 10 and len(json.dumps(curve["preimage"])) < 1000
            for frame in ["erf", "frenet"] if IS_CORPUS else [("erf", "frenet")[k % 2]]:
                yield Job(f"{curve['name']}, {frame}", ["angle", "--frame", frame, "-"], json.dumps(curve), [],
                          ["auto", "real"] if IS_CORPUS and is_short else ["auto"])


def differs(text, f, evaluate, precisions=(60, 240, 960)):
    """Found, of differences(). For want of digits they may be wrong at first, and are right with more; a jump stays."""
    for digits in precisions:
        count, largest, wrong = differences.compare(f, evaluate(text, digits))
        if not wrong:
            break
    return Found(differences=count, largest=largest, failures=wrong)


class TooLong(Exception):
    pass


def too_long(*_):
    raise TooLong


def check(job, system, derives, evaluate):
    """Found, by derives(text): is the derivative the integrand? and evaluate(text, digits): the differences."""
    f, found = None, Found()
    for form, text in job.scripts(system).items():
        name = f"{job.name}, {form}"
        found += Found(1)
        signal.signal(signal.SIGALRM, too_long)
        signal.alarm(LIMIT)
        try:
            if form in job.differentiated and not derives(text):
                found += Found(failures=[f"{name}: derivative"])
            if form in job.evaluated and MAY_JUMP not in text:
                f = f or job.integrand()
                new = differs(text, f, evaluate)
                found += new._replace(failures=[f"{name}, {jump}" for jump in new.failures])
        except TooLong:
            found += Found(skipped=[name])
        except Exception as error:  # with its name, for the others go on
            found += Found(failures=[f"{name}: {type(error).__name__} {error}"])
        finally:
            signal.alarm(0)
    return found


def main(system, derives, evaluate, more_failures=lambda: []):
    """Checks all jobs, reports, and exits."""
    found = Found(failures=[f"{name} is not noticed" for name in unnoticed(system, derives, evaluate)])
    found += Found(failures=list(more_failures()))
    work = functools.partial(check, system=system, derives=derives, evaluate=evaluate)
    if IS_CORPUS:
        with multiprocessing.Pool() as pool:
            for one in pool.imap_unordered(work, jobs()):
                for line in one.failures + one.skipped:
                    print(line, flush=True)
                found += one
    else:
        for job in jobs():
            found += work(job)
    print(f"{found.differences} differences; at most {found.largest:.1e} from the integral")
    for name in found.skipped:
        print(f"skipped, as it takes {system} more than {LIMIT} s: {name}")
    finish(found.antiderivatives, found.failures)


# Antiderivatives that are wrong: the integrand, the form, what is replaced by what, and whether the derivative is wrong.
BROKEN = {
    "an argument that crosses the cut": (
        "(x^4-3*x^2+6)/(x^6-5*x^4+5*x^2+4)", "lazard-rioboo-trager", MAY_JUMP, "", False),
    "a wrong residue": ("1/(x^5-x+1)", "auto", "400", "401", True),
    "a wrong sign": ("1/(x^4+1)", "auto", r"(antiderivative\S* = )", r"\1-", True),
}


def unnoticed(system, derives, evaluate):
    """The names of those that pass."""
    for name, (integrand, form, pattern, replacement, is_derivative_wrong) in BROKEN.items():
        job = Job(name, ["integrate", "--", integrand])
        text, count = re.subn(pattern, replacement, job.print_for(system, form))
        assert count == 1, f"{name}: {text}"
        if derives(text) == is_derivative_wrong or not differs(text, job.integrand(), evaluate, (60, 240)).failures:
            yield name


def finish(count, failures):
    """Reports and exits."""
    for failure in failures:
        print("failed:", failure)
    print(f"{count} antiderivatives, {len(failures)} failures")
    sys.exit(1 if failures or count == 0 else 0)


def missing(system):
    """Exits where a system is not installed."""
    print(system, "is not installed")
    sys.exit(SKIP)
