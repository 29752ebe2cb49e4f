#!/usr/bin/env python3
"""Makes reference/*.jsonl: curves of all kinds with values to 50 digits (docs/reference.md), found by phrame and by
tools/foreign_frames.py, which share nothing; a value on which they do not agree stops it. Needs python-flint.

    PHRAME_PROGRAM=build/dev/bin/phrame tools/make_reference.py [--check [--every N]]

With --check the files stay, and their values are computed anew by the foreign way alone, of every Nth curve.
"""
import argparse
import json
import os
import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

try:
    import foreign_frames as foreign
except ImportError:
    print("python-flint is not installed")
    sys.exit(77)

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "reference"
DIGITS = 50
AGREEMENT = Fraction(1, 10 ** 49)  # of the two ways, relative to 1 or to the value if that is greater
CHANCE = random.Random(2026)


def some(n, most=9, below=1):
    return [str(Fraction(CHANCE.randint(-most, most), below)) for _ in range(n)]


def ph(m, most=9, below=1, **more):
    return {"phrame": "curve/1", "basis": "power", "preimage": {key: some(m + 1, most, below) for key in "uvpq"}, **more}


def quaternion(**parts):
    return {"phrame": "curve/1", "basis": "power", "preimage": {key: [str(Fraction(x)) for x in parts[key]] for key in "uvpq"}}


def points(n, below=7):
    return [some(3, 30, below) for _ in range(n)]


def near_cusp(epsilon, c):
    """A = (t - c) B + epsilon C."""
    B, C = {"u": (2, -1), "v": (1, 4), "p": (-3, 1), "q": (5, -2)}, {"u": 3, "v": -2, "p": 1, "q": 4}
    return quaternion(**{key: (-c * b[0] + epsilon * C[key], b[0] - c * b[1], b[1]) for key, b in B.items()})


def formula(x, y, z, end):
    return {"phrame": "curve/1", "expressions": {"x": x, "y": y, "z": z}, "variable": "s", "from": "0", "to": end}


def spline(corners):
    """Cubic segments; without corners the tangent goes on."""
    last, tangent, segments = [Fraction(0)] * 3, [Fraction(x) for x in (1, 1, 1)], []
    for _ in range(3):
        p = [[Fraction(x) for x in q] for q in points(3)]
        if not corners:
            p[0] = [a + b for a, b in zip(last, tangent)]
        segments.append({"control_points": [[str(x) for x in q] for q in [last, *p]]})
        last, tangent = p[2], [a - b for a, b in zip(p[2], p[1])]
    return {"phrame": "spline/1", "segments": segments}


def polyline(n):
    corner = [[Fraction(x) for x in q] for q in points(n)]
    return {"phrame": "spline/1", "segments": [{"control_points": [[str(x) for x in p] for p in pair]}
                                               for pair in zip(corner, corner[1:] + corner[:1])]}


def groups():
    """{group: curves}"""
    yield "tame", [ph(m, below=b) for m in (1, 2, 3, 4) for b in (1, 3, 7)]
    yield "high-degree", [ph(m, below=5) for m in (6, 8)]
    yield "near-cusp", [near_cusp(Fraction(1, 10 ** k), c) for k in (1, 2) for c in (Fraction(1, 3), Fraction(1))]
    yield "turning-multiplier", [ph(2, below=3, multiplier=["1", "-1/2"]), ph(1, below=3, multiplier=["-2", "1/3"]),
                                 ph(2, multiplier=["3", "1", "1/7"])]
    yield "long-numbers", [ph(2, 10 ** 15, 10 ** 14), ph(3, 10 ** 15, 10 ** 15), ph(2, 10 ** 60, 10 ** 59)]
    yield "inflections", [quaternion(u=[1], v=[0], p=[0, Fraction(1, 3)], q=[0, 0, 1, -1]),
                          quaternion(u=[1, 2], v=[0, 1], p=[0, 0, 1], q=[0, 0, Fraction(-1, 7)]),
                          {"phrame": "curve/1", "control_points": [["0", "0", "0"], ["1", "2", "0"], ["2", "-2", "1/3"], ["3", "1/7", "1"]]}]
    yield "plane", [quaternion(u=[1], v=[0], p=[0], q=[1, 3, Fraction(1, 3)]),
                    {"phrame": "curve/1", "control_points": [["0", "0", "0"], ["1/3", "2", "0"], ["2", "2", "0"], ["3", "1/7", "0"]]},
                    quaternion(u=[1, 2], v=[0], p=[0], q=[0])]
    yield "rational-frames", [quaternion(u=[1, 0, -6], v=[0, 4, 3], p=[0, -2, -12], q=[0, 6, -4]),
                              quaternion(u=[1], v=[0, 1], p=[0, 1], q=[0, 0, 1])]
    yield "bezier", [{"phrame": "curve/1", "control_points": points(n)} for n in (4, 4, 4, 5, 6, 8)]
    yield "rational", [{"phrame": "curve/1", "control_points": points(n), "weights": [str(Fraction(CHANCE.randint(3, 12), 7)) for _ in range(n)]}
                       for n in (3, 4, 4, 5)]
    yield "formulas", [formula("3*cos(s)", "3*sin(s)", "4*s/7", "5"), formula("s", "sin(s)", "cos(2*s)/3", "3"),
                       formula("exp(s)", "s^2", "s/3", "1"), formula("s", "s^2/2", "sqrt(1+s^2)", "2")]
    yield "closed", [formula("sin(s)+2*sin(2*s)", "cos(s)-2*cos(2*s)", "-sin(3*s)", "2*pi"),
                     formula("(3+cos(3*s))*cos(2*s)", "(3+cos(3*s))*sin(2*s)", "sin(3*s)/3", "2*pi"),
                     formula("2*cos(s)", "sin(s)", "cos(2*s)/7", "2*pi"), formula("cos(s)", "2*sin(s)", "sin(2*s)/3", "2*pi")]
    yield "splines", [spline(corners=False) for _ in range(4)]
    yield "corners", [spline(corners=True) for _ in range(2)] + [polyline(n) for n in (3, 5)]


def rounded(value):
    """With the nearest double in place of each number, exactly."""
    if isinstance(value, dict):
        return {key: x if key in ("phrame", "basis", "expressions", "variable", "from", "to") else rounded(x) for key, x in value.items()}
    return [rounded(x) for x in value] if isinstance(value, list) else str(Fraction(float(Fraction(value))))


def named():
    for group, curves in groups():
        for k, curve in enumerate(curves):
            name, note = "%s-%02d" % (group, k + 1), {"family": group}
            yield group, {"phrame": curve["phrame"], "name": name, **note, **curve}
            near = rounded(curve)
            if near != curve and not (group in ("splines", "corners")):
                yield group, {"phrame": curve["phrame"], "name": name + "-doubles", **note, "note": "the numbers of %s as doubles" % name, **near}


def parameters(curve):
    n = len(curve.get("segments", [1]))
    return [Fraction(0), Fraction(n, 3), Fraction(n, 2), Fraction(n)]


def asked(curves):
    """What phrame answers: {name: (frames, totals, angles)}."""
    lines = []
    for _, curve in curves:
        at = [str(t) for t in parameters(curve)]
        for question, more in (("frames", {"at": at}), ("totals", {}), ("angle", {"at": at, "values_only": True})):
            if question != "angle" or "preimage" in curve:
                lines.append({"id": "%s %s" % (question, curve["name"]), "question": question, "curve": curve, "digits": DIGITS, **more})
    run = subprocess.run([os.environ["PHRAME_PROGRAM"], "batch", "--threads", "1"], input="".join(json.dumps(x) + "\n" for x in lines),
                         capture_output=True, text=True)
    answers = {}
    for line in run.stdout.splitlines():
        answer = json.loads(line)
        question, name = answer["id"].split()
        if "error" in answer:
            sys.exit("%s: %s" % (answer["id"], answer["error"]))
        answers.setdefault(name, {})[question] = answer
    return answers


def value_of(x):
    return x["value"] if isinstance(x, dict) else x


def expected(curve, answers):
    total = answers["totals"]
    out = {"at": [str(t) for t in parameters(curve)], "frames": [row[1:] for row in answers["frames"]["rows"]]}
    if "angle" in answers:
        out["theta_erf"] = [v["theta"] for v in answers["angle"]["values"]]
    out["length"] = value_of(total["length"])
    if total.get("holonomy"):
        out["holonomy"] = value_of(total["holonomy"])
    return out


def disagreements(curve):
    """Of what is expected with what is found here: texts. Only values within AGREEMENT are none."""
    path, want = foreign.Path(curve), curve["expected"]
    found, length, _ = path.frames(parameters(curve))
    pairs = [("length", want["length"], length)]
    for t, row, (r, e1, f2, f3) in zip(want["at"], want["frames"], found):
        pairs += [("frame at %s, %d" % (t, k), x, y) for k, (x, y) in enumerate(zip(row, [*r, *e1, *f2, *f3]))]
    if len(want["frames"]) != len(found):
        yield "%d frames" % len(found)
    if "theta_erf" in want:
        pairs += [("theta at %s" % t, x, foreign.angle_to_erf(path.segments[0], Fraction(t))) for t, x in zip(want["at"], want["theta_erf"])]
    if "holonomy" in want:
        pairs.append(("holonomy", want["holonomy"], path.holonomy()))
    for what, text, x in pairs:
        y = foreign.number(text)
        most = foreign.number(AGREEMENT) * max(1.0, float(abs(y).mid()))
        if not abs(foreign.middle(y - x)) <= most:
            yield "%s: %s, here %s" % (what, text, x.str(DIGITS, radius=False))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--every", type=int, default=1, metavar="N")
    parser.add_argument("--group", help="this one only")
    options = parser.parse_args()
    if options.check:
        curves = [json.loads(line) for file in sorted(FOLDER.glob("*.jsonl")) for line in file.read_text().splitlines()][::options.every]
    else:
        pairs = [pair for pair in named() if options.group in (None, pair[0])]
        answers = asked(pairs)
        curves = [{**curve, "expected": expected(curve, answers[curve["name"]])} for _, curve in pairs]
    wrong = []
    for curve in curves:
        for problem in disagreements(curve):
            wrong.append("%s: %s" % (curve["name"], problem))
            print(wrong[-1], flush=True)
    print("%d curves, %d values differ" % (len(curves), len(wrong)))
    if wrong or not curves:
        sys.exit(1)
    if not options.check:
        for group in dict.fromkeys(group for group, _ in pairs):
            lines = [json.dumps(c) for c in curves if c["family"] == group]
            (FOLDER / ("%s.jsonl" % group)).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
