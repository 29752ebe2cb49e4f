"""examples_of_documents.py FOLDER: the programs in documents, docstrings and notebooks as files for mypy, one for each document."""

import ast
import doctest
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]


def of_text(text: str) -> str:
    """What stands between >>> and its output, and whole programs."""
    lines = [example.source for example in doctest.DocTestParser().get_examples(text)]
    programs = [block for block in re.findall(r"```python\n(.*?)```", text, re.DOTALL) if ">>>" not in block]
    return "".join(lines) + "\n".join(programs)


def of_docstrings(text: str) -> str:
    nodes = [node for node in ast.walk(ast.parse(text)) if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef))]
    return "".join(of_text(ast.get_docstring(node) or "") for node in nodes)


def of_notebook(text: str) -> str:
    return "\n".join("".join(cell["source"]) for cell in json.loads(text)["cells"] if cell["cell_type"] == "code") + "\n"


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    documents = [(file, of_text) for file in (ROOT / "README.md", *(ROOT / "docs").glob("*.md"), *(ROOT / "docs/site").glob("*.md"))]
    documents += [(file, of_docstrings) for file in (ROOT / "python/phrame").glob("*.py")]
    documents += [(file, of_notebook) for file in (ROOT / "examples/notebooks").glob("*.ipynb")]
    for file, read in documents:
        program = read(file.read_text(encoding="utf-8"))
        name = "example_" + re.sub(r"\W", "_", str(file.relative_to(ROOT)))
        (folder / f"{name}.py").unlink(missing_ok=True)
        if program:
            (folder / f"{name}.py").write_text(program, encoding="utf-8")


main(Path(sys.argv[1]))
