"""The notebooks of examples/, whose cells compare their numbers with those of papers: run here one after the other in this
process, what they show being made, too; where PHRAME_TEST_MULTIPLIER is 2 or more as Jupyter runs them."""

import ast
import contextlib
import importlib
import io
import json

import pytest

from common import MULTIPLIER, ROOT

NOTEBOOKS = sorted((ROOT / "examples/notebooks").glob("*.ipynb"))


def shown(value):
    """What a notebook shows of a value: its richest form, as a text."""
    for name in ("_repr_html_", "_repr_latex_"):
        form = getattr(value, name, None)
        text = form() if form else None
        if text is not None:
            return text
    return "" if value is None else repr(value)


def run(cell, names):
    """What a cell prints and shows: as in Jupyter, the value of a last expression without a semicolon."""
    tree = ast.parse(cell)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) and not cell.rstrip().endswith(";") else None
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(compile(tree, "a cell", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "a cell", "eval"), names) if last else None
    return printed.getvalue() + shown(value)


def code_cells(path):
    return ["".join(cell["source"]) for cell in json.loads(path.read_text())["cells"] if cell["cell_type"] == "code"]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    pyplot = pytest.importorskip("matplotlib.pyplot")
    names = {"__name__": "__main__"}
    output = [run(cell, names) for cell in code_cells(path)]
    assert "".join(output)
    for number in pyplot.get_fignums():  # Jupyter draws what a cell leaves open
        pyplot.figure(number).canvas.draw()
    pyplot.close("all")


def test_the_first_page_runs():
    text = (ROOT / "docs/site/index.md").read_text()
    program = text.split("```python\n")[1].split("```")[0]
    assert len([line for line in program.splitlines() if line]) <= 11  # imports and ten lines
    pytest.importorskip("matplotlib").use("agg")
    names = {}
    printed = run(program, names)
    assert names["frames"].shape == (1000, 3, 3) and names["poses"].shape == (1000, 4, 4) and printed
    importlib.import_module("matplotlib.pyplot").close("all")


def test_there_are_no_outputs_in_git():
    assert len(NOTEBOOKS) >= 4
    for path in NOTEBOOKS:
        cells = json.loads(path.read_text())["cells"]
        assert not any(cell.get("outputs") or cell.get("execution_count") for cell in cells), path


@pytest.mark.skipif(MULTIPLIER == 1, reason="kernels take seconds: PHRAME_TEST_MULTIPLIER=2")
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_in_jupyter(path):
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    nbclient.NotebookClient(nbformat.read(path, as_version=4), timeout=120).execute()
