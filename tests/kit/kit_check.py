"""examples/kit: the program of each language that is there writes tables of frames for the collection, and phrame check --suite
finds that they are by a method of order 4, and what they took; frames that are wrong are told what is wrong.

The tables of docs/audit.md are those of its log. Rust is compiled with PHRAME_TEST_MULTIPLIER above 1 only.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
from fractions import Fraction
from pathlib import Path

PROGRAM = os.environ["PHRAME_PROGRAM"]
ROOT = Path(__file__).resolve().parents[2]
KIT = ROOT / "examples/kit"


def phrame(*arguments, status=0):
    run = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    if run.returncode != status:
        sys.exit("phrame %s: status %d\n%s%s" % (" ".join(map(str, arguments)), run.returncode, run.stdout, run.stderr))
    return run.stdout


def programs(folder):
    """{language: its command}"""
    yield "python", [sys.executable, KIT / "double_reflection.py"]
    if os.environ.get("PHRAME_KIT_CPP"):
        yield "c++", [os.environ["PHRAME_KIT_CPP"]]
    if shutil.which("node"):
        yield "javascript", ["node", KIT / "double_reflection.mjs"]
    if shutil.which("julia"):
        yield "julia", ["julia", KIT / "double_reflection.jl"]
    if shutil.which("rustc") and float(os.environ.get("PHRAME_TEST_MULTIPLIER", 1)) > 1:
        subprocess.run(["rustc", "-o", folder / "compiled", KIT / "double_reflection.rs"], check=True)
        yield "rust", [folder / "compiled"]


def suite(tables):
    found = json.loads(phrame("check", "--suite", tables, "--print", "json", status=1))  # not all curves have tables
    return {group["name"]: group for group in found["groups"]}, {row["name"]: row for row in found["curves"]}


def check_sums(tables, groups, curves):
    """The seconds of a group are the sum of those of its finest tables."""
    lines = (tables / "times.csv").read_text().splitlines()[1:]
    times = {name: Fraction(x) for name, x in (line.rsplit(",", 1) for line in lines)}
    assert len(times) == sum(1 for _ in tables.rglob("*.csv")) - 1, times
    for name, row in groups.items():
        finest = ["41/" + x for x in curves if name in ("", curves[x]["group"])]
        assert Fraction(row["seconds"]) == sum(map(times.get, finest)) and row["timed_samples"] == 41 * len(finest), row
    assert Fraction(curves["corners-01"]["steps"][0]["seconds"]) == times["21/corners-01"]


def some_of(tables, folder):
    """Those of three curves, which are sooner checked than all."""
    for n in ("21", "41"):
        (folder / n).mkdir(parents=True)
        for name in ("rational-frames-01", "rational-frames-02", "corners-01"):
            shutil.copy(tables / n / (name + ".csv"), folder / n)
    return folder


def check_times(tables):
    """Where none are told, there is no column."""
    assert "seconds" not in phrame("check", "--suite", tables, status=1)
    file = tables / "times.csv"
    file.write_text("name,seconds\n41/rational-frames-01,0.0041\n21/corners-01,7\n")  # one group is told, and a coarse table
    rows = [[cell.text for cell in row][-2:] for row in xml.etree.ElementTree.fromstring(phrame("check", "--suite", tables, "--print", "html", status=1)).iter("tr")]
    assert rows == [["seconds", "µs a row"], ["–", "–"], ["0.00410", "100"], ["0.00410", "100"]], rows
    assert "  seconds  µs a row\n" in phrame("check", "--suite", tables, status=1)
    assert "& seconds & $\\mu$s a row \\\\" in phrame("check", "--suite", tables, "--print", "latex", status=1)
    for line, reason in (("41/nobody,1", 'no table "41/nobody" is in the folder'), ("41/corners-01,-1", "-1 seconds are negative"), ("41/corners-01,fast", '"fast" is not')):
        file.write_text("name,seconds\n21/corners-01,1\n%s\n" % line)
        refused = subprocess.run([PROGRAM, "check", "--suite", tables], capture_output=True, text=True)
        assert refused.returncode == 2 and refused.stderr.startswith("phrame: %s:line 3: %s" % (file, reason)) and refused.stderr.count("\n") == 1, refused
    file.unlink()


def check_badge(folder, tables, every):
    """What it says in words is what the JSON of all says; -o NAME.svg is one."""
    badge = folder / "badge.svg"
    phrame("check", "--suite", tables, "-o", badge, status=1)
    root = xml.etree.ElementTree.fromstring(badge.read_text())
    title, *_, right = [x.text for x in root.iter() if x.tag.endswith(("}title", "}text"))]
    curves = len(phrame("reference", "--list").splitlines()) - 1
    assert right == "%d of %d, error %s" % (every["passed"], curves, every["max_error"]), right
    assert "%d of %d curves pass, to within 1/1000000;" % (every["passed"], curves) in title
    assert title.endswith("without a verdict: %d; without a table: %d" % (every["failures"], curves - every["curves"])), title
    assert badge.read_text() == phrame("check", "--suite", tables, "--print", "svg", status=1)
    phrame("check", ROOT / "examples/curves/plane-cubic.json", "frames.csv", "--print", "svg", status=2)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        phrame("reference", "--export", folder / "collection", "--group", "rational-frames,corners", "--samples", "21,41")
        first = None
        for language, command in programs(folder):
            subprocess.run([*command, folder / "collection/frames", folder / language], check=True)
            groups, curves = suite(folder / language)
            assert 3.9 < groups["rational-frames"]["order"] < 4.1, (language, groups)
            assert groups["corners"]["holonomy"] is not None and groups[""]["flips"] == 0
            errors = {name: float(row["max_error"]["upper"]) for name, row in curves.items()}
            first = first or errors
            assert errors.keys() == first.keys() and len(errors) > 15
            assert all(abs(errors[name] - first[name]) < 1e-6 * first[name] + 1e-13 for name in errors), (language, errors, first)
            check_sums(folder / language, groups, curves)
        mine, one = some_of(folder / "python", folder / "some"), "41/rational-frames-01.csv"
        check_times(mine)
        # A frame that turns over, and one with a NaN.
        lines = (mine / one).read_text().splitlines()
        turned = [lines[0], lines[1]]
        for line in lines[2:]:
            t, *f2 = line.split(",")
            turned.append(",".join([t, *(x[1:] if x.startswith("-") else "-" + x for x in f2)]))
        (mine / one).write_text("\n".join(turned) + "\n")
        (mine / "41/rational-frames-02.csv").write_text("t,f2x,f2y,f2z\n0,nan,0,0\n1,0,1,0\n")
        groups, curves = suite(mine)
        assert groups["rational-frames"]["flips"] == 1 and groups["rational-frames"]["failures"] == 1
        assert curves["rational-frames-01"]["verdict"] == "fail" and curves["rational-frames-01"]["max_error"]["lower"] > "3.14"
        assert "41/rational-frames-02.csv:line 2" in curves["rational-frames-02"]["failure"]
        text = phrame("check", "--suite", mine, status=1)
        assert "\n  rational-frames  " in text and "Without a verdict\n  rational-frames-02: " in text
        latex = phrame("check", "--suite", mine, "--print", "latex", status=1)
        html = xml.etree.ElementTree.fromstring(phrame("check", "--suite", mine, "--print", "html", status=1))
        rows = [[cell.text for cell in row] for row in html.iter("tr")]
        assert rows[0][:3] == ["group", "curves", "pass"] and rows[-1][:3] == ["all", *(str(groups[""][key]) for key in ("curves", "passed"))], rows
        check_badge(folder, mine, groups[""])
        assert latex.startswith("\\begin{tabular}{lrrrrrrr}\ngroup & ") and latex.isascii(), latex
        exact = folder / "collection/frames"
        assert json.loads(phrame("check", "--suite", exact, "--start", "least", "--tol", "1e-13", "--print", "json", status=1))["groups"][-1]["passed"] > 15
        phrame("check", "--suite", exact, "--start", "erf", status=2)
        (mine / "nobody.csv").write_text("t,f2x,f2y,f2z\n0,0,1,0\n1,0,1,0\n")
        phrame("check", "--suite", mine, status=2)


def check_audit():
    """The tables of docs/audit.md are those of its log."""
    sys.path.insert(0, str(ROOT / "tools/audit"))
    import audit
    page = audit.PAGE.read_text()
    for mark, table in audit.rendered(json.loads(audit.LOG.read_text())).items():
        assert "<!-- %s -->\n%s\n<!-- end -->" % (mark, table) in page, "docs/audit.md has another table %s than its log" % mark


if __name__ == "__main__":
    check_audit()
    main()
