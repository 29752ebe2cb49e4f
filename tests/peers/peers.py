"""What the tests with other systems have in common: the integrands, and what phrame prints of them.

A test runs `phrame integrate … --print SYSTEM`, gives the output to the system as it is, and has the system differentiate
`antiderivative` and compare it with `integrand`; and evaluate it on a grid, for differences.py. It exits with 0, with 1
after naming what failed, or with SKIP where the system is not installed. With PHRAME_PEERS=corpus it takes all of
tests/data/integrals.jsonl, and the angles of all curves of tests/data/curves.jsonl up to degree 25 that have short coefficients.
"""
import json
import os
import pathlib
import subprocess
import sys

import differences

SKIP = 77

# Of every kind that is printed differently: residues in Q, Q(i), quadratic fields and beyond, multiple poles, no pole, 0.
IDS = """
    sympy-25896 sympy-8246-atan-4 sympy-28657 sympy-28186 sympy-5907 sympy-6828 sympy-12305 sympy-ratint-doc
    sympy-ratint-zero sympy-ratint-improper fricas-198 maxima-1778796 maxima-2907727 angourimath-1284 gcl-x3-x-1 gcl-x2-2
    rioboo hardy-1916 leibniz-1702 wang-59 timofeev-18 hearn-04 con-sqrt2-a con-cubic-a con-qi-b con-irrational-pv
    con-real-quintic
""".split()
FORMS = ["auto", "partial-fractions", "rothstein-trager", "lazard-rioboo-trager", "real", "radicals"]
UNDEFINED = 3  # phrame's exit status for radicals that do not exist


TESTS = pathlib.Path(__file__).parent.parent


def read(name):
    """The objects of a file of tests/data."""
    return [json.loads(line) for line in (TESTS / "data" / name).read_text(encoding="utf-8").splitlines()]


def phrame(arguments, text=""):
    return subprocess.run([os.environ["PHRAME_PROGRAM"], *arguments], input=text, capture_output=True, text=True)


def arguments():
    """Pairs of a name and what phrame is to print: each integrand, and a Frenet angle, in each form."""
    entries = {e["id"]: e for e in read("integrals.jsonl")}
    curve = TESTS.parent / "examples" / "curves" / "farouki-2003-quintic.json"
    for form in FORMS:
        for name in entries if os.environ.get("PHRAME_PEERS") == "corpus" else IDS:
            yield f"{name}, {form}", ["integrate", "--form", form, "--", entries[name]["integrand"]]
        yield f"Frenet angle, {form}", ["angle", "--form", form, "--frame", "frenet", str(curve)]


def scripts(system):
    """Pairs of a name and the text that phrame prints for the system; the same text once."""
    seen = set()
    for name, (command, *options) in arguments():
        result = phrame([command, "--print", system, *options])
        if "radicals" in options and result.returncode == UNDEFINED:
            continue
        result.check_returncode()
        text = result.stdout
        if text not in seen:
            seen.add(text)
            yield name, text


def continuous(system):
    """Triples of a name, the text phrame prints for the system, and the integrand: what must be continuous."""
    everything = os.environ.get("PHRAME_PEERS") == "corpus"
    jobs = []
    for entry in read("integrals.jsonl"):
        if everything or entry["id"] in IDS:
            for form in ["auto", "real"] if everything else ["auto"]:
                jobs.append((f"{entry['id']}, {form}", ["integrate", "--form", form, "--", entry["integrand"]], ""))
    degrees = set()
    for curve in read("curves.jsonl"):
        degree = len(curve["preimage"]["u"])
        is_small = degree <= 13 and len(json.dumps(curve["preimage"])) < 1000
        if not is_small or (degree in degrees and not everything):
            continue
        degrees.add(degree)
        for frame in ["erf", "frenet"]:
            jobs.append((f"{curve['name']}, {frame}", ["angle", "--frame", frame, "-"], json.dumps(curve)))
    for name, (command, *options), text in jobs:
        result = phrame([command, "--print", system, *options], text)
        if result.returncode == UNDEFINED and command == "angle":
            continue  # no Frenet frame
        result.check_returncode()
        data = phrame([command, "--print", "json", *options], text)
        yield name, result.stdout, differences.Integrand(json.loads(data.stdout)["integrand"])


def finish(count, failures):
    """Reports and exits."""
    for failure in failures:
        print("failed:", failure)
    print(f"{count} antiderivatives, {len(failures)} failures")
    sys.exit(1 if failures or count == 0 else 0)


def run(command, text, missing):
    """The standard output of a system that reads `text`; SKIP where there is no such program."""
    try:
        return subprocess.run(command, input=text, check=True, capture_output=True, text=True).stdout
    except FileNotFoundError:
        print(missing, "is not installed")
        sys.exit(SKIP)
