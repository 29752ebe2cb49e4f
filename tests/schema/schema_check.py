"""All JSON of the program is what docs/schema says, and that says all keys there are: an object with one key more is
refused, wherever it is. What lines of a batch the program takes, the schema of lines that it writes takes, and no others.
"""
import itertools
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    from jsonschema import Draft202012Validator
    from referencing import Registry, Resource
except ImportError:
    print("the Python package jsonschema is not installed")
    sys.exit(77)

from program import PROGRAM, phrame

ROOT = Path(__file__).resolve().parents[2]
SCHEMAS = {file.name: json.loads(file.read_text()) for file in (ROOT / "docs" / "schema").glob("*.json")}
REGISTRY = Registry().with_resources((name, Resource.from_contents(schema)) for name, schema in SCHEMAS.items())
MIXED = json.dumps({"phrame": "spline/1", "name": "mixed", "segments": [
    {"basis": "power", "preimage": {"u": [1], "v": [0, "1/2"], "p": [0], "q": ["1/2"]}},
    {"control_points": [["5/4", "1/4", 0], ["5/3", "1/2", 0], [2, 1, 1]]}]})
CORNER = json.dumps({"phrame": "spline/1", "segments": [
    {"control_points": [[0, 0, 0], [1, 0, 0]]}, {"control_points": [[1, 0, 0], [1, 1, 0]]}]})
PLANE = json.dumps({"phrame": "curve/1", "basis": "power", "preimage": {"u": ["-1/2", 1], "v": [0], "p": [0], "q": ["1/100"]}})
TURN = json.dumps({"phrame": "curve/1", "basis": "power", "preimage": {"u": [1], "v": [0], "p": [0], "q": [0, 1]}})
PARABOLA = json.dumps({"phrame": "curve/1", "control_points": [[0, 0, 0], ["1/2", 0, 0], [1, 1, 0]]})
RADII = json.dumps({"phrame": "points/1", "points": [[0, 0, 1], [1, 1, 1], [2, 0, 1]]})
ELLIPSE = json.dumps({"phrame": "curve/1", "basis": "power", "position": {"x": [3, 0, -3], "y": [0, 4], "w": [1, 0, 1]}})
SLANT = json.dumps({"phrame": "spline/1", "segments": [
    {"control_points": [[0, 0, 0], [1, 0, 0]]}, {"control_points": [[1, 0, 0], [2, 1, 0]]}]})
THERE_AND_BACK = json.dumps({"phrame": "curve/1", "basis": "power", "multiplier": [1, -2],
                             "preimage": {"u": [1], "v": [0], "p": [0], "q": [0]}})
NOT_PH = json.dumps({"phrame": "curve/1", "control_points": [[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]]})
CUSP = json.dumps({"phrame": "curve/1", "basis": "power", "preimage": {"u": ["-1/2", 1], "v": [0], "p": [0], "q": [0]}})


def validator(schema):
    Draft202012Validator.check_schema(schema)
    return Draft202012Validator(schema, registry=REGISTRY)


def formats_of(schema):
    """The values that "phrame" may have."""
    if isinstance(schema, list):
        return {name for part in schema for name in formats_of(part)}
    if not isinstance(schema, dict):
        return set()
    stated = schema.get("properties", {}).get("phrame", {})
    return set(stated.get("enum", [])) | ({stated["const"]} if "const" in stated else set()) | {
        name for part in schema.get("anyOf", []) for name in formats_of(part)}


VALIDATORS = {name: validator({"$ref": name}) for name in SCHEMAS}
AXES = (  # a leaf, and a strip that ends in points; one that is lightlike, with a side that is a point
    '{"phrame": "mph/1", "basis": "power", "preimage": {"u": [2], "v": [0, 1], "p": [0, 1], "q": [1]}, "start": [0, 0, 1]}',
    '{"phrame": "mph/1", "name": "strip", "segments": [{"control_points": [[0, 0, 0], [1, 1, 1]]}, {"control_points": [[1, 1, 1], [3, 1, 1]]}]}',
    '{"phrame": "mph/1", "basis": "power", "x": [-1, 2], "y": ["1/2", -2, 2], "r": [1, -2, 2]}',
    '{"phrame": "mph/1", "basis": "power", "preimage": {"u": [2], "v": [0, 2], "p": [1], "q": [0, 1]}, "start": [0, 0, 2]}')
FILE_OF = {name: file for file, schema in SCHEMAS.items() for name in formats_of(schema)}
FILE_OF["curve/1"] = FILE_OF["spline/1"] = "path.json"
EVERYTHING = int(os.environ.get("PHRAME_TEST_MULTIPLIER", 1)) > 1
seen = {file: 0 for file in SCHEMAS if file != "common.json"}
extended = set()


def objects(value, place=()):
    if isinstance(value, dict):
        yield place, value
    for key, part in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
        yield from objects(part, (*place, key))


def fail(*what):
    sys.exit(": ".join(map(str, what)))


def thinned(value):
    """Of long lists of lists or objects the first four and the last two: those between are made as these are."""
    if isinstance(value, dict):
        return {key: thinned(part) for key, part in value.items()}
    if not isinstance(value, list):
        return value
    long = len(value) > 6 and all(isinstance(part, (dict, list)) for part in value)
    return [thinned(part) for part in (value[:4] + value[-2:] if long and not EVERYTHING else value)]


def require_valid(answer, told):
    answer = thinned(answer)
    file = FILE_OF.get(answer.get("phrame"), "text.json")
    for error in VALIDATORS[file].iter_errors(answer):
        fail(told, file, error.json_path, error.message[:400])
    seen[file] += 1
    for place, part in objects(answer):
        shape = (file, answer.get("phrame"), tuple(0 if isinstance(key, int) else key for key in place))
        if shape in extended or not part:
            continue
        extended.add(shape)
        part["unknown"] = 1
        if VALIDATORS[file].is_valid(answer):
            fail(told, file, place, "one key more is no error")
        del part["unknown"]


def ask(*arguments):
    """Where there is no answer, there is no JSON."""
    run = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    if run.stdout.startswith("{"):
        require_valid(json.loads(run.stdout), arguments)
    elif run.returncode == 0:
        fail(arguments, "no JSON")
    return run.stdout


def check_command_line(folder):
    here = Path(folder)
    for name, text in (("mixed", MIXED), ("not-ph", NOT_PH), ("cusp", CUSP)):
        (here / f"{name}.json").write_text(text)
    examples = sorted([*(ROOT / "examples" / "curves").iterdir(), *(ROOT / "examples" / "any").iterdir()])
    every = 1 if EVERYTHING else 8  # of them, every day
    for curve in [*sorted(here.glob("*.json")), *examples[::every]]:
        for call in (["angle", curve, "--at", "0,1/2,1"], ["angle", curve, "--frame", "frenet", "--at", "1/3"],
                     ["angle", curve, "--up", "1,2,3", "--at", "1", "--theta0", "pi/4"], ["angle", curve, "--form", "real"],
                     ["angle", curve, "--form", "radicals", "--start-normal", "1,2,3", "--at", "1"],
                     ["angle", curve, "--start", "least", "--values-only", "--near", "1e-9", "--at", "1"],
                     ["info", curve], ["info", curve, "--near", "1e-9"], ["totals", curve], ["classify", curve],
                     ["mtf", curve, "--from", "pi/8", "--to", "1", "--at", "1/2", "--samples", "2"],
                     ["mtf", curve, "--from", "0", "--to", "3", "--degree", "3", "--unproved"],
                     ["mtf", curve, "--from", "0", "--closed"],
                     ["mtf", curve, "--wronskian"], ["identify", curve], ["identify", curve, "--near", "1e-9"]):
            ask(*call, "--print", "json")
        ask("identify", curve, "--near", "1e-6", "--print", "curve")
        ask("frames", curve, "--samples", "4", "--frame", "rmf", "--start", "least", "--format", "json")
        ask("frames", curve, "--samples", "4", "--frame", "frenet,rmf", "--skip-undefined", "--format", "json")
        ask("interpolate", curve, "--period", "1/4", "--feed", "1", "--format", "json")
        ask("sweep", curve, "--profile", "polygon:3,1/9", "--exact", "--format", "json")
        for frame in (["--frame", "erf"], ["--frame", "frenet"], ["--frame", "up"], ["--length"]):
            ask("certify", curve, "--digits", "9", *frame)
    ask("certify", ROOT / "examples/curves/closed-spline.json", "--at", "1/2,3")
    ask("certify", ROOT / "tests/data/rational-path.json", "--at", "1/2,3")
    ask("certify", ROOT / "examples/any/trefoil.json", "--digits", "9")
    for name, text in (("corner", CORNER), ("plane", PLANE), ("turn", TURN), ("there", THERE_AND_BACK)):
        curve = here / f"{name}.offset"
        curve.write_text(text)
        for join in ("round", "mitre", "open"):
            ask("offset", curve, "--distance", "-1,1/2", "--join", join, "--print", "json")
            if (join == "round" or EVERYTHING) and name != "there":
                ask("offset", curve, "--distance", "-1,1/2", "--join", join, "--trim", "--print", "json")
            if join != "open":
                ask("offset", curve, "--distance", "1/2", "--join", join, "--print", "curve")
    (here / "radii.points").write_text(RADII)
    ask("construct", here / "radii.points", "--kind", "minkowski", "--print", "json")
    for k, text in enumerate(AXES):
        axis = here / f"{k}.axis"
        axis.write_text(text)
        ask("envelope", axis, "--print", "json")
        ask("envelope", axis, "--trim", "--print", "json")
    ask("envelope", here / "0.axis", "--trim", "--print", "curve")
    (here / "parabola.offset").write_text(PARABOLA)
    ask("offset", here / "parabola.offset", "--distance", "1/2", "--print", "json")
    ask("info", here / "parabola.offset", "--print", "json")
    (here / "ellipse").write_text(ELLIPSE)
    (here / "slant.offset").write_text(SLANT)
    ask("offset", here / "slant.offset", "--distance", "1/2", "--gauge", here / "ellipse", "--print", "json")
    ask("offset", here / "parabola.offset", "--distance", "1/2", "--gauge", here / "ellipse", "--print", "json")
    ask("offset", here / "corner.offset", "--distance", "1/2", "--trim", "--gauge", here / "ellipse", "--print", "json")
    ask("offset", here / "corner.offset", "--distance", "1/2", "--check", here / "turn.offset", "--print", "json")
    quintic = ROOT / "examples" / "curves" / "farouki-2003-quintic.json"
    rational = ROOT / "examples" / "curves" / "rational-frame-quintic.json"
    ask("sweep", rational, "--profile", "rectangle:1/9,1/7", "--exact", "--format", "json")
    ask("sweep", quintic, "--profile", "polygon:3,1/9", "--exact", "--degree", "2", "--end-normal", "0,0,1", "--format", "json")
    for frame in ("rmf", "frenet", "erf"):
        table = here / f"{frame}.csv"
        table.write_text(phrame("frames", quintic, "--samples", "9", "--frame", frame))
        ask("check", quintic, table, "--print", "json")
        ask("check", quintic, table, "--start-normal", "0,0,1", "--print", "json")
    for name, end in (("tame-01", 1), ("corners-03", 3), ("plane-01", 1)):  # and a table without frames
        for n in (3, 5):
            (here / f"tables{n}").mkdir(exist_ok=True)
            rows = [f"{end * k / (n - 1)},{k % 2},1,1" for k in range(n)] if name != "plane-01" else []
            (here / f"tables{n}" / f"{name}.csv").write_text("\n".join(["t,f2x,f2y,f2z", *rows]))
    (here / "tables3").rename(here / "tables5" / "tables3")
    (here / "tables5" / "times.csv").write_text("name,seconds\ntame-01,0.25\ntables3/tame-01,1e-3\n")
    ask("check", "--suite", here / "tables5", "--print", "json")
    for table in [*(here / "tables5").rglob("plane-01.csv"), *(here / "tables5").rglob("corners-03.csv")]:
        table.unlink()
    ask("check", quintic, here / "tables5", "--order", "--print", "json")
    kinds = ("quintic", "planar", "cubic", "helical", "rrmf", "rmf", "c2", "c2-hermite")
    for k, points in enumerate(sorted((ROOT / "examples" / "paths").iterdir())):
        for n, kind in enumerate(kinds):  # every day one of the two, now of these points and now of those
            for form in ("json", "curve") if EVERYTHING else (("json", "curve")[(k + n) % 2],):
                ask("construct", points, "--kind", kind, "--print", form)
    for twist in ([], ["--smooth-twist"]):
        posed = here / "posed.json"
        weld = ROOT / "examples" / "paths" / "weld.csv"
        ask("construct", weld, "--tangent-axis=-y", *twist, "--print", "json")
        posed.write_text(ask("construct", weld, "--tangent-axis=-y", *twist, "--turns", "0,1,0,0,0,-1", "--print", "curve"))
        for more in ([], ["--at", "1/2,3"], ["--up", "1,2,9"]):
            ask("mtf", posed, *more, "--print", "json")
        ask("frames", posed, "--frame", "mtf-exact", "--samples", "3", "--columns", "quaternion,twist_alpha", "--format", "json")
    for call in (["1/(x^4+1)", "--from", "0", "--to", "inf"], ["1/(x^4-2)", "--form", "radicals"], ["1/x", "--form", "real"],
                 ["(x^3+1)/(x^2-x-1)", "--form", "real", "--from", "2", "--to", "root(x^2-7, 2, 3)"],
                 ["1/(x^4-10*x^2+1)", "--form", "real"], ["1/(x^2+1)", "--from", "0", "--to", "pi/2"], ["1/(x^5-x-1)"],
                 ["1/(x-1)", "--from", "0", "--to", "3", "--principal-value"], ["x"]):
        ask("integrate", *call, "--print", "json")


def commands():
    listed = json.loads(ask("help", "--json"))["commands"]
    for command in listed:
        for option in command["options"]:
            told = re.search(r"\(default ([^ ,;)]+)\)|([^ ,]+) \(default\)", option["what"])
            if told and option["default"] is not None and str(option["default"]) != (told[1] or told[2]):
                fail(command["command"], option["names"], f"{told[0]} in the help, {option['default']!r} in the table")
    return [command for command in listed if command["question"]]


def answers(lines):
    text = "".join(json.dumps(line) + "\n" for line in lines)
    run = subprocess.run([PROGRAM, "batch"], input=text, capture_output=True, text=True)
    found = [json.loads(line) for line in run.stdout.splitlines()]
    if len(found) != len(lines):
        fail("batch", run.stderr)
    return found


def check_lines():
    """Each question about each curve, and those of the examples."""
    takes_line = validator(json.loads(phrame("help", "--schema"))).is_valid
    lines = [json.loads(line) for name in ("curves.jsonl", "questions.jsonl") for line in open(ROOT / "examples" / name)]
    extra = {"frames": {"samples": 3}, "mtf": {"from": "pi/8", "to": 1, "at": [0, 1]}, "sweep": {"profile": "polygon:3,1/9"},
             "offset": {"distance": ["1/2", -1]},
             "interpolate": {"feed": "1", "period": "1/2"}, "angle": {"at": [0, "1/2"], "digits": 20}}
    curves = [json.loads(file.read_text()) for file in sorted((ROOT / "examples" / "curves").iterdir())]
    for command in commands():
        if command["options"][0]["key"] == "curve" and command["command"] not in ("check", "page"):
            lines += [{"id": k, "question": command["command"], "curve": curve, **extra.get(command["command"], {})}
                      for k, curve in enumerate([*curves, json.loads(MIXED), json.loads(NOT_PH)])]
    for line, answer in zip(lines, answers(lines)):
        of_line = ("id", "notes") if FILE_OF.get(answer.get("phrame")) == "path.json" else ()  # not of the file
        require_valid({key: value for key, value in answer.items() if key not in of_line}, line)
        if "error" not in answer and not takes_line(line):
            fail("the schema of lines does not take", line)
    check_conditions(takes_line)


def value_of(option):
    if option["kind"] == "flag":
        return True
    if option["kind"] == "name":
        return option["choices"][-1:] if option["list"] else option["choices"][-1]
    if option["kind"] == "number":
        return option["range"][0]
    return [1, 2, 3] if option["value"] == "X,Y,Z" else "1"


def check_conditions(takes_line):
    """Any two options, with a curve that is none: what is refused before is refused by the schema, too, and nothing else."""
    lines = []
    for command in commands():
        base = {"question": command["command"]}
        rest = []
        for option in command["options"]:
            if option["required"]:
                base[option["key"]] = {} if option["key"] == "curve" else value_of(option)
            elif option["key"] and option["key"] != "time_limit":
                rest.append({option["key"]: value_of(option)})
        pairs = [{**base, **first, **second} for first, second in itertools.combinations_with_replacement(rest, 2)]
        lines += pairs[:: 1 if EVERYTHING else 7]
        lines.append({**base, "unknown": 1})
        lines.append({key: value for key, value in base.items() if key != command["options"][0]["key"]})
    refused = 0
    for line, answer in zip(lines, answers(lines)):
        message = answer.get("error", {}).get("message", "")
        is_refused = re.search(r": needs --|does not apply with|exclude each other|^/: unknown key|^/: the key", message) is not None
        refused += is_refused
        if takes_line(line) == is_refused:
            fail("the schema of lines", line, message or answer)
    print(f"{len(lines)} lines, {refused} of them refused, by the program and by the schema")


with tempfile.TemporaryDirectory() as folder:
    check_command_line(folder)
check_lines()
for file, count in sorted(seen.items()):
    if count == 0:
        fail(file, "no output was tried")
print(f"{sum(seen.values())} outputs are as docs/schema says: "
      + ", ".join(f"{count} {file[:-5]}" for file, count in sorted(seen.items())))
