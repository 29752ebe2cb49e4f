"""Pickles, copies, memory, texts."""

import copy
import doctest
import inspect
import os
import pickle
import random
import resource

import numpy as np
import pytest

import phrame
from common import MULTIPLIER, QUINTIC, random_curve, ROOT


def values():
    """Some of each type."""
    two = phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)], "two")
    cubic = phrame.Curve.bezier([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]])
    helix = phrame.Curve.expressions("cos(s)", "sin(s)", "s", 0, "2*pi", name="helix")
    theta = QUINTIC.angle("frenet", start="pi/4").value("1/3")
    twist = QUINTIC.minimal_twist(0, "pi/3")
    ts = [0, "1/2", 1]
    return {
        phrame.Polynomial: [QUINTIC.sigma, phrame.Polynomial([])],
        phrame.RationalFunction: [QUINTIC.torsion],
        phrame.Real: [theta, QUINTIC.erf_twist, 2 * theta, -theta, 1 / theta, theta - 1, abs(-theta), phrame.root([-2, 0, 1], 1, 2),
                      twist.twist, twist.value("1/2"), phrame.integrate("1/(x^2+1)", 0, 1).value(), cubic.length,
                      cubic.angle().value("1/3"), cubic.curvature("1/4"), cubic.parameter_at(1), QUINTIC.parameter_at(1),
                      *helix.point("1/7")],
        phrame.Curve: [QUINTIC, phrame.Curve([1, 2], [0, 1], [0], [1], multiplier=[1, 0, 1], start=[1, 2, 3], name="α")],
        phrame.Path: [two],
        phrame.SmoothPath: [cubic, helix, phrame.Curve.bezier([[1, 0, 0], [1, 1, 0], [0, 1, 0]], [1, 1, 2])],
        phrame.Angle: [QUINTIC.angle(), two.angle(start="pi/4"), QUINTIC.angle("frenet"), QUINTIC.angle(start_normal=[0, 0, 1])],
        phrame.SmoothAngle: [cubic.angle(start=1), cubic.angle("frenet"), cubic.angle(up=[0, 0, 1])],
        phrame.Integral: [phrame.integrate("1/(x^5+1)", variable="x"), phrame.integrate("1/y", 1, "sqrt(2)", style="real")],
        phrame.Classification: [QUINTIC.classify(), two.classify()],
        phrame.MinimalTwist: [twist, cubic.minimal_twist(0, 1, extra_turns=1)],
        phrame.CheckResult: [QUINTIC.check(ts, QUINTIC.frames(ts)[:, 1]), cubic.check(ts, cubic.frames(ts, kind="frenet")[:, 1])],
        phrame.Certificate: [QUINTIC.certify(at=["1/2"], digits=20)],
        phrame.SweptBody: [phrame.sweep(cubic, "polygon:3,1/9", sections=3)],
        phrame.InputError: [phrame.InputError("t: bad", "t", "bad", 3)],
        phrame.DomainError: [phrame.DomainError("a pole")],
        phrame.Undecided: [phrame.Undecided("t: 10 bits", "t", "10 bits", "x")],
        phrame.Error: [phrame.Error("e")],
    }


VALUES = values()


def members(x):
    """What a value says of itself: its attributes, texts and digits."""
    for name in sorted({name for kind in type(x).__mro__ for name, of in vars(kind).items() if isinstance(of, property)}):
        try:
            yield name, getattr(x, name)
        except phrame.Error as error:
            yield name, str(error)
    for name in ("json", "text", "latex", "volume"):
        if hasattr(x, name):
            yield name, getattr(x, name)()
    yield "repr", repr(x)
    if isinstance(x, phrame.Error):
        yield "error", (str(x), x.place, x.reason, x.value)


def same(a, b):
    if type(a) is not type(b):
        return False
    if isinstance(a, phrame.Real):
        return a.digits(40) == b.digits(40)
    if isinstance(a, np.ndarray):
        return bool((a == b).all())
    if isinstance(a, (tuple, list)):
        return len(a) == len(b) and all(map(same, a, b))
    if type(a) not in VALUES:
        return a == b
    if type(a).__eq__ is not object.__eq__:
        return a == b and hash(a) == hash(b)
    return all(map(same, *zip(*((x, y) for (_, x), (_, y) in zip(members(a), members(b))))))


def test_no_type_is_forgotten():
    assert set(VALUES) == {x for x in vars(phrame).values() if inspect.isclass(x) and x.__module__.startswith("phrame")}
    assert {x for x in vars(phrame._phrame).values() if inspect.isclass(x)} <= set(VALUES)
    assert all(type(x) is kind for kind, examples in VALUES.items() for x in examples)


@pytest.mark.parametrize("kind", VALUES, ids=lambda kind: kind.__name__)
def test_values_are_pickled_and_copied(kind):
    for x in VALUES[kind]:
        for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
            assert same(pickle.loads(pickle.dumps(x, protocol)), x)
        assert same(copy.copy(x), x) and same(copy.deepcopy([x])[0], x)
        if not isinstance(x, phrame.Error):
            assert copy.copy(x) is x and copy.deepcopy(x) is x
            with pytest.raises(AttributeError):
                x.name = "other"


@pytest.mark.parametrize("kind", VALUES, ids=lambda kind: kind.__name__)
def test_what_a_value_gives_outlives_it(kind):
    for x in VALUES[kind]:
        names = [name for name, _ in members(x)]
        for name in names:
            fresh = pickle.loads(pickle.dumps(x))
            part = dict(members(fresh))[name]
            del fresh
            rubbish = [random_curve(random.Random(k)) for k in range(20)]
            assert same(part, dict(members(x))[name]) and rubbish


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
    """100 000 curves where PHRAME_TEST_MULTIPLIER is 25, and what is made of them."""

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
