"""Exceptions name the argument."""

import pickle
import time
from decimal import Decimal

import numpy as np
import pytest

import phrame
from common import QUINTIC


@pytest.mark.parametrize(
    "place, kind, ask",
    [
        ("u[1]", TypeError, lambda: phrame.Curve([1, None], [0], [0], [1])),
        ("u", TypeError, lambda: phrame.Curve(3, [0], [0], [1])),
        ("v[0]", phrame.InputError, lambda: phrame.Curve([1], [float("nan")], [0], [1])),
        ("v[0]", phrame.InputError, lambda: phrame.Curve([1], [Decimal("Infinity")], [0], [1])),
        ("v[0]", phrame.InputError, lambda: phrame.Curve([1], [Decimal("1e999999999")], [0], [1])),
        ("p[0]", phrame.InputError, lambda: phrame.Curve([1], [0], ["1/0"], [1])),
        ("q[0]", TypeError, lambda: phrame.Curve([1], [0], [0], [True])),
        ("q[0]", TypeError, lambda: phrame.Curve([1], [0], [0], [1j])),
        ("basis", phrame.InputError, lambda: phrame.Curve([1], [0], [0], [1], basis="bézier")),
        ("start", phrame.InputError, lambda: phrame.Curve([1], [0], [0], [1], start=[1, 2])),
        ("quaternions[1]", phrame.InputError, lambda: phrame.Curve.from_quaternions([[1, 0, 0, 0], [1]])),
        ("points", phrame.InputError, lambda: phrame.Curve.from_control_points([[0, 0, 0]])),
        ("points[1][2]", phrame.InputError, lambda: phrame.Curve.through([[0, 0, 0], [1, 1, "x"]])),
        ("tangents", phrame.InputError, lambda: phrame.Curve.through([[0, 0, 0], [1, 1, 1]], tangents=[[1, 0, 0]])),
        ("kind", phrame.InputError, lambda: phrame.Curve.through([[0, 0, 0], [1, 1, 1]], kind="septic")),
        ("eps", phrame.InputError, lambda: phrame.Curve.near([[0, 0, 0], [1, 1, 1]], 0)),
        ("digits", phrame.InputError, lambda: QUINTIC.angle().value(1, digits=-3)),
        ("digits", TypeError, lambda: QUINTIC.angle().value(1, digits=2.5)),
        ("n", phrame.InputError, lambda: QUINTIC.angle().value(1).digits(0)),
        ("bits", phrame.InputError, lambda: QUINTIC.angle().value(1).ball(10**100)),
        ("t", phrame.InputError, lambda: QUINTIC.angle().value("one")),
        ("frame", phrame.InputError, lambda: QUINTIC.angle("bishop")),
        ("start", phrame.InputError, lambda: QUINTIC.angle(start="pi/4/2")),
        ("start_normal", phrame.InputError, lambda: QUINTIC.frames([0], start_normal=[0, 0, 0])),
        ("ts", phrame.InputError, lambda: QUINTIC.frames([])),
        ("ts", phrame.InputError, lambda: QUINTIC.frames(np.array([]))),
        ("ts", phrame.InputError, lambda: QUINTIC.frames(np.zeros((2, 2)))),
        ("ts[1]", phrame.InputError, lambda: QUINTIC.frames(np.array([0, np.nan]))),
        ("ts", TypeError, lambda: QUINTIC.frames(0.5)),
        ("ts", TypeError, lambda: QUINTIC.points("0,1")),
        ("ts[1]", phrame.DomainError, lambda: phrame.Path([QUINTIC.segment(0, 1), QUINTIC.segment(1, 2)]).points([0, 3])),
        ("by", phrame.InputError, lambda: QUINTIC.frames([0], by="time")),
        ("f2", phrame.InputError, lambda: QUINTIC.check([0, 1], [[1, 0, 0]])),
        ("curves[0]", TypeError, lambda: phrame.Path([1])),
        ("curves", phrame.InputError, lambda: phrame.Path([])),
        ("lower", phrame.InputError, lambda: phrame.integrate("x", "one", 2)),
        ("f", phrame.InputError, lambda: phrame.integrate("x +")),
    ],
)
def test_an_exception_names_the_argument(place, kind, ask):
    with pytest.raises(kind) as raised:
        ask()
    message = str(raised.value)
    assert message.startswith(place + ":") and "\n" not in message
    if kind is phrame.InputError:
        assert raised.value.place == place and raised.value.reason in message
        assert isinstance(raised.value, (ValueError, phrame.Error))


def test_kinds_of_errors():
    line = phrame.Curve([1], [0], [0], [0])
    with pytest.raises(phrame.DomainError) as raised:
        line.angle("frenet")
    assert isinstance(raised.value, ArithmeticError) and isinstance(raised.value, phrame.Error)
    assert str(pickle.loads(pickle.dumps(raised.value))) == str(raised.value)
    with pytest.raises(phrame.DomainError):
        phrame.Curve([0], [0], [0], [0])
    with pytest.raises(phrame.InputError) as raised:
        phrame.Path.from_json('{"phrame": "curve/1", "basis": "power", "preimage": {"u": ["x"]}}')
    assert raised.value.place.startswith("/preimage")
    assert issubclass(phrame.Undecided, (ArithmeticError, phrame.Error))


@pytest.mark.parametrize("number, text", [(4.0000000001, "4.0000000001"), ("4.0000000001", "4.0000000001"), (Decimal("-0.1"), "-1/10"), (-1e-300, "-1e-300"),
                                          (1e22, "10000000000000000000000"), ("100/3", "100/3"), (np.float32(4.1), "4.099999904632568")])
def test_numbers_are_shown_as_they_were_written(number, text):
    path = phrame.Path([QUINTIC.segment(0, 1), QUINTIC.segment(1, 2)])
    smooth = phrame.Curve.bezier([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]])
    for place, ask in (("t", path.point), ("t", path.curvature), ("t", path.arc_length), ("t", path.angle().value), ("ts", path.angle()), ("t", smooth.point),
                       ("t", smooth.torsion), ("t", smooth.angle().value), ("t", smooth.arc_length),
                       ("ts[1]", lambda x: path.frames([0, x])), ("ts[1]", lambda x: smooth.points([0, x])), ("ts[1]", lambda x: smooth.angle()([0, x]))):
        with pytest.raises(phrame.Error) as raised:
            ask(number)
        message = str(raised.value)
        assert raised.value.place == place and message.startswith(place) and f" {text} is outside [0, " in message, message
    for place, ask in (("s", path.parameter_at), ("s", smooth.parameter_at), ("ts[1]", lambda x: path.points([0, x], by="arc-length")),
                       ("ts[1]", lambda x: smooth.frames([0, x], by="arc-length"))):
        with pytest.raises(phrame.DomainError) as raised:
            ask(100000 + number if isinstance(number, float) and number > 0 else "-100000.5")
        assert raised.value.place == place and str(raised.value).startswith(place + ": ") and " is outside [0, " in str(raised.value)
