"""Pickles, copies, memory, texts."""

import copy
import doctest
import json
import os
import pickle
import random
import resource

import numpy as np
import pytest

import phrame
from common import MULTIPLIER, QUINTIC, random_curve, ROOT


def values():
    path = phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)], "two")
    return [QUINTIC, path, QUINTIC.sigma, QUINTIC.torsion, QUINTIC.certify(at=["1/2"], digits=20)]


def test_values_are_pickled_and_copied():
    for x in values():
        again = pickle.loads(pickle.dumps(x))
        assert again == x and hash(again) == hash(x) and type(again) is type(x)
        assert copy.copy(x) is x and copy.deepcopy(x) is x
    theta = QUINTIC.angle("frenet", start="pi/4").value("1/3")
    for x in (theta, QUINTIC.erf_twist, 2 * theta, -theta, theta - 1, phrame.root([-2, 0, 1], 1, 2),
              QUINTIC.minimal_twist(0, 1).twist, QUINTIC.minimal_twist(0, 1).value("1/2"),
              phrame.integrate("1/(x^2+1)", 0, 1).value()):
        assert pickle.loads(pickle.dumps(x)).digits(40) == x.digits(40)
        assert copy.deepcopy(x) is x
    ts = [0, "1/2", 1]
    check = QUINTIC.check(ts, QUINTIC.frames(ts)[:, 1])
    for x in (QUINTIC.angle(), QUINTIC.classify(), check, phrame.integrate("1/(x^5+1)", variable="x")):
        assert pickle.loads(pickle.dumps(x)).json() == x.json()
    with pytest.raises(AttributeError):
        QUINTIC.name = "other"


def test_objects_outlive_what_they_came_from():
    theta = phrame.Curve([2, -4, 4], [1, 0, -1], [0, -4, 4], [1, 2, -2]).angle().value(1)
    frames = phrame.Curve([1, 1], [0], [0], [0, 2]).frames(np.linspace(0, 1, 1000))
    rubbish = [random_curve(random.Random(k)) for k in range(100)]
    assert theta.digits(20) == QUINTIC.angle().value(1, digits=20) and len(rubbish) == 100
    assert (frames[:, 2] == [0, 0, 1]).all()


def resident():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="no /proc")
def test_no_memory_is_lost():
    def use(n):
        for k in range(n):
            curve = phrame.Curve([2, -4, 4], [1, k, -1], [0, -4, 4], [10**40 + k, 2, -2])
            curve.sigma, curve.control_points[1], pickle.dumps(curve.h)
        for _ in range(n // 100):
            curve.angle().value(1, digits=20), QUINTIC.frames([0.25, "1/3"])
            with pytest.raises(phrame.InputError):
                phrame.Curve([1], [0], ["x"], [0])

    n = 2000 * MULTIPLIER
    use(n)
    before = resident()
    use(2 * n)
    assert resident() - before < 4 << 20


def test_examples_in_documents_and_docstrings():
    assert doctest.testmod(phrame).failed == 0
    assert doctest.testmod(phrame._map).failed == 0
    found = doctest.testfile(str(ROOT / "docs/python.md"), module_relative=False, encoding="utf-8")
    assert found.failed == 0 and found.attempted > 20


def test_the_first_page_does_what_it_shows(capsys):
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    block = text.split("```python\n")[1].split("```")[0]
    names = {}
    exec(block, names)
    assert names["frames"].shape == (1000, 3, 3)
    assert capsys.readouterr().out.endswith("0.28585653009834106200165626280309220136381867044677\n")


def test_reprs():
    assert repr(QUINTIC).startswith("<Curve") and "4*t^2" in repr(QUINTIC)
    assert repr(QUINTIC.angle().value(1)) == "Real('0.28585653009834106…')"
    assert r"\theta" in QUINTIC.angle()._repr_latex_() and "θ′" in str(QUINTIC.angle())
    assert "Classification" in repr(QUINTIC.classify()) and "2π" not in repr(QUINTIC.minimal_twist(0, 1))
    assert phrame.integrate("1/(x^2+1)")._repr_latex_() == r"$\displaystyle \arctan x$" or \
        "arctan" in phrame.integrate("1/(x^2+1)")._repr_latex_()
