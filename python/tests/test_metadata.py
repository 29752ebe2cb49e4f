"""What pyproject.toml, CITATION.cff, LICENSE and CMake say of the project is the same."""

import re
import subprocess
import sys

import pytest

import phrame
from common import ROOT


def text(name):
    return (ROOT / name).read_text(encoding="utf-8")


def test_one_version_and_one_licence():
    version = re.search(r"project\(phrame VERSION ([0-9.]+)", text("CMakeLists.txt")).group(1)
    assert phrame.__version__ == version and f"\nversion: {version}\n" in text("CITATION.cff")
    assert "license: MIT" in text("CITATION.cff") and "MIT License" in text("LICENSE")
    for name in ("CITATION.cff", "pyproject.toml", "LICENSE"):
        assert re.search("[Tt]he phrame authors", text(name)), name


def test_the_tables_can_be_read():
    project = pytest.importorskip("tomllib").loads(text("pyproject.toml"))["project"]
    assert project["authors"] and "Typing :: Typed" in project["classifiers"]
    assert set(project["classifiers"]) <= getattr(pytest.importorskip("trove_classifiers"), "classifiers")


def test_the_citation_can_be_read():
    citation = pytest.importorskip("yaml").safe_load(text("CITATION.cff"))
    assert citation["cff-version"] == "1.2.0" and citation["authors"] and citation["title"] == "phrame"


def test_the_package_is_imported_where_numpy_is_not():
    """As it is when its stub is made for a wheel."""
    program = "import sys; sys.modules['numpy'] = None; import phrame; print(phrame.__version__)"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert run.stdout.strip() == phrame.__version__, run.stderr
