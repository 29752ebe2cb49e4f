"""Certificates under tools/check_certificate.py, which shares no code with what makes them.

Honest ones are proved. Then every kind of field is tampered with, a digit, a sign, an answer, a lost or
swapped entry, and nothing that became false is proved. What is still proved must be true: `phrame verify`
proves it by another route, and a claim about an angle is compared with the angle computed anew.
"""
import copy
import functools
import json
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
CHECKER = ROOT / "tools" / "check_certificate.py"
PROGRAM = os.environ["PHRAME_PROGRAM"]
VERIFY = (PROGRAM, "verify")
ALL = os.environ.get("PHRAME_CERTIFICATES") == "all"
MAX_PREIMAGE_DEGREE = 20 if ALL else 4  # with 5 there is no other kind of statement
CHANGES_A_KIND = 3 if ALL else 1  # places of each kind; every way to change it is tried there
NEAR_CUSPS = ("1e-3", "1e-6", "1e-9", "1e-12", "1e-20", "1e-30") if ALL else ("1e-3", "1e-30")


def phrame(*arguments, text=""):
    return subprocess.run([PROGRAM, *arguments], input=text, capture_output=True, text=True)


def proved(paths, command=(sys.executable, "-B", str(CHECKER), "-q")):
    """Those of several of which every statement is proved, by one run of the checker."""
    run = subprocess.run([*command, *paths], capture_output=True, text=True)
    if "Traceback" in run.stderr:
        sys.exit(run.stderr)
    lines = [line.rpartition(": ") for line in run.stdout.splitlines()]
    return {name for name, _, said in lines if said.startswith("all ") and said.endswith(" statements are proved")}


def curves():
    lines = (ROOT / "tests/data/curves.jsonl").read_text().splitlines()
    low = [curve for curve in map(json.loads, lines)
           if max(map(len, curve["preimage"].values())) <= MAX_PREIMAGE_DEGREE + 1]
    return low if ALL else low[::3]


def certificates(folder):
    """Both frames of all curves; a straight line has no Frenet frame."""
    for curve in curves():
        for frame in ("erf", "frenet"):
            path = folder / ("%s-%s.cert" % (curve["name"], frame))
            run = phrame("certify", "-", "--at", "1/2,1", "--digits", "40", "--frame", frame, "-o", str(path),
                         text=json.dumps(curve))
            if run.returncode == 3 and "straight line" in run.stderr and frame == "frenet":
                continue
            if run.returncode:
                sys.exit("%s, %s: %s" % (curve["name"], frame, run.stderr))
            yield path


def near_cusps(folder):
    """A = (t - c)B + epsilon*C: a cusp at c but for epsilon, inside and next to the ends."""
    B, C = {"u": (2, -1), "v": (1, 4), "p": (-3, 1), "q": (5, -2)}, {"u": 3, "v": -2, "p": 1, "q": 4}
    for epsilon in map(Fraction, NEAR_CUSPS):
        for place, c in (("start", Fraction(0)), ("first", epsilon), ("inside", Fraction(1, 3)),
                         ("middle", Fraction(1, 2)), ("last", 1 - epsilon), ("end", Fraction(1))):
            preimage = {key: [str(x) for x in (-c * b[0] + epsilon * C[key], b[0] - c * b[1], b[1])]
                        for key, b in B.items()}
            curve = {"phrame": "curve/1", "name": "near-cusp", "basis": "power", "preimage": preimage}
            path = folder / ("near-cusp-%.0e-%s.cert" % (epsilon, place))
            run = phrame("certify", "-", "--at", "1/2,1", "--digits", "25", "-o", str(path),
                         text=json.dumps(curve))
            if run.returncode:
                sys.exit(run.stderr)
            yield path


def check_words(path):
    """What is said of one statement that is not proved, in the words of `phrame verify`."""
    certificate = json.loads(Path(path).read_text())
    certificate["claims"][0]["theta"] = "1000"
    changed = Path(path).with_suffix(".changed")
    changed.write_text(json.dumps(certificate))
    run = subprocess.run([sys.executable, "-B", str(CHECKER), str(changed)], capture_output=True, text=True)
    number = len(run.stdout.splitlines()) - 4  # less the curve, its hash, the frame and the last line
    if run.returncode != 1 or run.stdout.splitlines()[-1] != "1 of %d statements is not proved" % number:
        sys.exit(run.stdout + run.stderr)


def check_several(good, folder):
    """Of several files both print the same line for each that is read, and their statuses are the worst of all."""
    bad, none = folder / "bad.cert", folder / "none.cert"
    bad.write_text(Path(good).read_text().replace('"theta": "', '"theta": "9', 1))
    none.write_text("{}")
    for status, paths in ((0, [good, good]), (1, [good, str(bad), good]), (2, [str(none), good, str(bad)]), (2, [good, str(folder / "nothing")])):
        mine = subprocess.run([sys.executable, "-B", str(CHECKER), *paths], capture_output=True, text=True)
        other = phrame("verify", *paths)
        alike = [[line for line in run.stdout.splitlines() if line.startswith((good, str(bad)))] for run in (mine, other)]
        if (mine.returncode, other.returncode) != (status, status) or alike[0] != alike[1] or len(other.stdout.splitlines()) != len(paths):
            sys.exit("several: %s, %s" % (mine, other))


def check_both(paths):
    """Both checkers prove them; for every day that of the program does so in tests/ph/proof."""
    failed = set(paths) - proved(paths)
    by_program = set(paths) - proved(paths, VERIFY) if ALL else set()
    print("%d near-cusps, not proved: %d by the script, %d by verify" % (len(paths), len(failed), len(by_program)))
    if failed or by_program or len(paths) < 6 * len(NEAR_CUSPS):
        sys.exit("not proved: %s; by verify: %s" % (sorted(failed), sorted(by_program)))


# ---- tampering

# Nothing is stated about these: the name and the place of a curve, and B where there are no discs.
REMARKS = ("/curve/name", "/curve/start/#", "/phrame", "/curve/phrame", "/curve/basis", "/frame")


def places(value, path=()):
    """The path of everything in a JSON value."""
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield from places(item, path + (key,))


def kind(path):
    return "".join("/#" if isinstance(key, int) else "/" + key for key in path)


def changed_digit(text, chance):
    digits = [k for k, c in enumerate(text) if c.isdigit()]
    k = chance.choice(digits)
    return text[:k] + chance.choice([d for d in "0123456789" if d != text[k]]) + text[k + 1:]


def changes(value, chance):
    """(what is done, the value instead), all the ways there are for a value of its type."""
    if isinstance(value, bool):
        yield "flip", not value
    elif isinstance(value, int):
        yield "one more", value + 1
        yield "one less", value - 1
    elif isinstance(value, str) and value and set(value) <= set("+-0"):
        k = chance.randrange(len(value))
        yield "sign", value[:k] + chance.choice([c for c in "+-0" if c != value[k]]) + value[k + 1:]
    elif isinstance(value, str) and any(c.isdigit() for c in value):
        yield "digit", changed_digit(value, chance)
        yield "minus", value[1:] if value[0] == "-" else "-" + value
    elif isinstance(value, list) and value:
        if value != ["0"]:  # the same polynomial as []
            yield "lost", value[:-1]
        pairs = [(i, k) for k in range(len(value)) for i in range(k) if value[i] != value[k]]
        if pairs:
            i, k = chance.choice(pairs)
            swapped = copy.copy(value)
            swapped[i], swapped[k] = value[k], value[i]
            yield "swapped", swapped


def put(certificate, path, value):
    """A copy with another value there."""
    result = copy.deepcopy(certificate)
    place = result
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    return result


def swapped_discs(certificate):
    """The centers of two discs swapped, the residues left in their places."""
    for k, log in enumerate(certificate["antiderivative"]["logs"]):
        if len(log["roots"]) > 1:
            result = copy.deepcopy(certificate)
            a, b = result["antiderivative"]["logs"][k]["roots"][:2]
            a["center"], b["center"] = b["center"], a["center"]
            yield "two centers swapped", "/antiderivative/logs/#/roots/#/center", result


def tampered(certificate, chance):
    """(what was done, kind of place, certificate)."""
    by_kind = {}
    for path in places(certificate):
        if path and not kind(path).startswith(REMARKS):
            by_kind.setdefault(kind(path), []).append(path)
    for name, paths in by_kind.items():
        for path in chance.sample(paths, min(CHANGES_A_KIND, len(paths))):
            value = certificate
            for key in path:
                value = value[key]
            for what, other in changes(value, chance):
                yield what, name, put(certificate, path, other)
    yield from swapped_discs(certificate)


@functools.cache
def angle(curve, frame, t):
    """theta(t) of a curve, to 60 digits, computed anew."""
    run = phrame("angle", "-", "--at", t, "--digits", "60", "--frame", frame, "--print", "json", text=curve)
    if run.returncode:
        sys.exit(run.stderr)
    value = json.loads(run.stdout)["values"][0]
    return Fraction(value["theta"]), Fraction(value["radius"])


def is_true(certificate):
    """What both checkers proved after a change: is it true?"""
    for claim in certificate["claims"]:
        theta, doubt = angle(json.dumps(certificate["curve"]), certificate["frame"], claim["t"])
        if abs(theta - Fraction(claim["theta"])) > Fraction(claim["radius"]) + doubt:
            return False
    return True


def subjects():
    """Curves of many kinds: (name, preimage and multiplier, frame)."""
    quintic = {"u": [2, -4, 4], "v": [1, 0, -1], "p": [0, -4, 4], "q": [1, 2, -2]}
    helix = {"u": [1], "v": [0, 1], "p": [0, 1], "q": [0]}
    plane = {"u": [1], "v": [0], "p": [0], "q": [1, 3, 1]}
    line = {"u": [1, 2], "v": [0], "p": [0], "q": [0]}
    rational = {"u": [0, 0, 1], "v": [0, 1], "p": [0, 1], "q": [1]}  # theta = -2t/(1 + t^2)
    rrmf = {"u": [1, 0, -6], "v": [0, 4, 3], "p": [0, -2, -12], "q": [0, 6, -4]}  # w is of degree 2
    twisted = {"u": [1], "v": [0, 1], "p": [0], "q": [0, 0, 1]}
    over = {"numerator": [1], "denominator": [64, 192, 240, 160, 60, 12, 1]}  # (t + 2)^6: r is rational
    inflected = {"u": [1], "v": [0], "p": [0, 1], "q": [0, 0, 1, -1]}
    return [("quintic", quintic, [1], "erf"), ("quintic", quintic, [1], "frenet"),
            ("cusp", quintic, [-1, 2, 1], "frenet"), ("helix", helix, [1], "frenet"),
            ("plane", plane, [1], "frenet"), ("line", line, [1], "erf"),
            ("rational", rational, [1], "erf"), ("rational curve", twisted, over, "erf"), ("rrmf", rrmf, [1], "erf"),
            ("inflected", inflected, [3], "frenet")]


def check_tampering(folder):
    chance = random.Random(2026)
    done = []
    for name, preimage, multiplier, frame in subjects():
        curve = {"phrame": "curve/1", "name": name, "basis": "power", "preimage": preimage,
                 "multiplier": multiplier}
        run = phrame("certify", "-", "--at", "1/3,1", "--digits", "20", "--frame", frame,
                     text=json.dumps(curve))
        if run.returncode:
            sys.exit(run.stderr)
        for what, place, certificate in tampered(json.loads(run.stdout), chance):
            path = folder / ("%d.cert" % len(done))
            path.write_text(json.dumps(certificate))
            done.append(("%s, %s: %s at %s" % (name, frame, what, place), place, certificate, path))
    accepted = proved([str(path) for _, _, _, path in done])
    by_program = proved(sorted(accepted), VERIFY)
    caught, still_true, wrong = [], [], []
    for what, place, certificate, path in done:
        if str(path) not in accepted:
            caught.append(place)
        elif str(path) in by_program and is_true(certificate):
            still_true.append(what)
        else:
            wrong.append("%s (%s)" % (what, path))
    never = sorted({place for _, place, _, _ in done} - set(caught) - {"/claims"})  # one less is no lie
    print("%d changes: %d not proved, %d still true and proved" % (len(done), len(caught), len(still_true)))
    if ALL:
        print("\n".join(["still true:"] + still_true))
    if wrong or never or len(caught) < 200:
        sys.exit("proved though false: %s\nkinds never caught: %s" % ("\n".join(wrong), never))


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        paths = [str(path) for path in certificates(folder)]
        failed = set(paths) - proved(paths)
        print("%d certificates, %d not proved" % (len(paths), len(failed)))
        if failed or len(paths) < 30:
            sys.exit("not proved: %s" % ", ".join(sorted(failed)))
        check_words(paths[0])
        check_several(next(path for path in paths if '"theta": "0.' in Path(path).read_text()), folder)
        check_both([str(path) for path in near_cusps(folder)])
        check_tampering(folder)


if __name__ == "__main__":
    main()
