"""Pickles, copies, texts."""

import copy
import doctest
import inspect
import pickle
import random
from fractions import Fraction

import numpy as np
import pytest

import phrame
from common import MULTIPLIER, QUINTIC, ROOT, random_curve
from values import VALUES, member, member_names, same


def test_no_type_is_forgotten():
    assert set(VALUES) == {x for x in vars(phrame).values() if inspect.isclass(x) and x.__module__.startswith("phrame")}
    assert {x for x in vars(phrame._phrame).values() if inspect.isclass(x)} <= set(VALUES)
    assert all(type(x) is kind for kind, examples in VALUES.items() for x in examples)


@pytest.mark.parametrize("kind", VALUES, ids=lambda kind: kind.__name__)
def test_values_are_pickled_and_copied(kind):
    for x in VALUES[kind]:
        for protocol in (2, pickle.HIGHEST_PROTOCOL):
            assert same(pickle.loads(pickle.dumps(x, protocol)), x)
        assert same(copy.copy(x), x) and same(copy.deepcopy([x])[0], x)
        if not isinstance(x, phrame.Error):
            assert copy.copy(x) is x and copy.deepcopy(x) is x
            with pytest.raises(AttributeError):
                x.name = "other"


@pytest.mark.parametrize("kind", VALUES, ids=lambda kind: kind.__name__)
def test_what_a_value_gives_outlives_it(kind):
    for x in VALUES[kind][: 2 * MULTIPLIER]:
        fresh = None
        for name in member_names(x):
            if fresh is None:
                fresh = pickle.loads(pickle.dumps(x))
            part = member(fresh, name)
            if type(part) in (bool, int, str, Fraction):  # Python's own, which refer to nothing, so that it can give the next one
                assert same(part, member(x, name))
                continue
            fresh = None
            rubbish = [random_curve(random.Random(k)) for k in range(10)]
            assert same(part, member(x, name)) and rubbish


def test_objects_outlive_what_they_came_from():
    theta = phrame.Curve([2, -4, 4], [1, 0, -1], [0, -4, 4], [1, 2, -2]).angle().value(1)
    frames = phrame.Curve([1, 1], [0], [0], [0, 2]).frames(np.linspace(0, 1, 1000))
    rubbish = [random_curve(random.Random(k)) for k in range(100)]
    assert theta.digits(20) == QUINTIC.angle().value(1, digits=20) and len(rubbish) == 100
    assert (frames[:, 2] == [0, 0, 1]).all()


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
    assert repr(QUINTIC).startswith("<Path") and "4*t^2" in repr(QUINTIC)
    assert repr(QUINTIC.angle().value(1)) == "Real('0.28585653009834106…')"
    assert r"\theta" in QUINTIC.angle()._repr_latex_() and "θ′" in str(QUINTIC.angle())
    assert "Classification" in repr(QUINTIC.classify()) and "2π" not in repr(QUINTIC.minimal_twist(0, 1))
    assert phrame.integrate("1/(x^2+1)")._repr_latex_() == r"$\displaystyle \arctan x$" or \
        "arctan" in phrame.integrate("1/(x^2+1)")._repr_latex_()


def test_hashes_are_of_all_that_is_compared():
    """Copies that only a translation, one coefficient or a later segment tells apart."""
    families = [
        [QUINTIC.translated([k, 0, 0]) for k in range(400)],
        [phrame.Curve([1, 2], [0, 1], [0], [1], multiplier=[1 + k]) for k in range(400)],
        [phrame.Path([QUINTIC.segment(0, 1), QUINTIC.segment(1, k)]) for k in range(2, 100)],
        [phrame.Curve.bezier([[0, 0, k], [1, 2, 0], [3, 0, 1]]) for k in range(400)],
        [phrame.Curve.cubic_spline([[0, 0, 0], [1, 2, 0], [3, 0, k]], ends="natural") for k in range(400)],
        [phrame.Curve.expressions("cos(s)", "sin(s)", f"{k}*s", 0, 1) for k in range(1, 400)],
    ]
    for family in families:
        assert len({hash(path) for path in family}) == len(set(family)) == len(family)
    same = [phrame.Curve.expressions(f"cos({s})", f"sin({s})", s, 0, 1) for s in "st"]
    assert same[0] == same[1] and hash(same[0]) == hash(same[1])
    assert phrame.Path([QUINTIC], name="other") == QUINTIC and hash(phrame.Path([QUINTIC], name="other")) == hash(QUINTIC)
