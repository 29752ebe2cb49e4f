"""Integrals, minimal twist, checks and certificates."""

import json
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import phrame
from common import QUINTIC


def test_integrals():
    assert phrame.integrate("1/(x^2+1)", 0, "inf").exact == "π/2"
    assert phrame.integrate("1/(x^2+1)", 0, float("inf")).value(30) == Decimal("1.57079632679489661923132169164")
    assert phrame.integrate("x^2", 0, 3).value() == 9
    sympy = pytest.importorskip("sympy")
    found = phrame.integrate("1/(x^3 + x)")
    x = sympy.Symbol("x")
    difference = sympy.diff(found.sympy(), *found.sympy().free_symbols) - 1 / (x**3 + x)
    assert sympy.simplify(difference.subs({s: x for s in difference.free_symbols})) == 0
    with pytest.raises(phrame.DomainError, match="pole"):
        phrame.integrate("1/x", -1, 1)
    assert phrame.integrate("1/x", -1, 1, principal_value=True).value() == 0


def test_minimal_twist():
    twist = QUINTIC.minimal_twist(0, "pi/3")
    assert twist.length == QUINTIC.length and twist.value(0) == 0
    turn = (float(twist.value(1)) - np.pi / 3) / (2 * np.pi)
    assert abs(turn - round(turn)) < 1e-14
    assert float(twist.nominal_twist) == pytest.approx(float(twist.erf_twist) + np.pi / 3, abs=1e-14)


def test_check():
    ts = np.linspace(0, 1, 9)
    frames = QUINTIC.frames(ts)
    good = QUINTIC.check(ts, frames[:, 1], frames[:, 2], start=0)
    assert good and good.passes and good.max_error[1] < Fraction(1, 10**15)
    erf = QUINTIC.frames(ts, kind="erf")
    bad = QUINTIC.check(ts, erf[:, 1], start=0)
    assert not bad and "Euler" in bad.text()
    low, high = bad.max_error
    assert low <= Fraction(float(QUINTIC.angle().value(1))) + Fraction(1, 10**15) and high < 1


def test_certificates():
    certificate = QUINTIC.certify(at=[1], digits=30)
    assert certificate.is_proved() and certificate.objections() == []
    wrong = json.loads(certificate.json())
    value = wrong["claims"][0]["theta"] if "claims" in wrong else wrong["values"][0]["theta"]
    text = certificate.json().replace(value, value[:-3] + ("1" if value[-3] != "1" else "2") + value[-2:])
    assert not phrame.Certificate.from_json(text).is_proved()
