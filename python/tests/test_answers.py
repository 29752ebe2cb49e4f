"""Integrals, minimal twist, checks and certificates."""

import json
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import phrame
from common import QUINTIC, ROOT


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


def test_ends_of_a_frame_of_minimal_twist():
    """An end that is left out is the least rotation; vectors are to the frame that angles are to."""
    for path in (QUINTIC, phrame.Curve.bezier([[0, 0, 0], [1, 2, 0], [2, 1, 3]])):
        e1 = path.frames([0.0, 1.0])[:, 0]
        vectors = [[-y, 1 + x, 0] for x, y, _ in e1.tolist()]
        assert abs(float(path.minimal_twist().twist) - float(path.minimal_twist(*vectors).twist)) < 1e-14
    twist = QUINTIC.minimal_twist([0, 0, 1], [0, 1, 1])
    assert float(twist.erf_twist) == float(QUINTIC.minimal_twist(0, 0).erf_twist)
    assert twist.rational(proved=False).pieces


def test_half_a_turn():
    """On a curve with a mirror symmetry, whose angle is exactly 0, ±π are as short."""
    mirrored = phrame.Curve.bezier([[-3, 0, 0], [-1, 2, 1], [0, 5, -2], [1, 2, 1], [3, 0, 0]])
    for end in ("pi", "-pi", "3*pi"):
        twist = mirrored.minimal_twist(0, end)
        assert float(twist.twist) == np.pi and twist.half_turn_within == 0
    assert mirrored.minimal_twist(0, 3).half_turn_within is None
    plane = phrame.read(ROOT / "examples/curves/plane-cubic.json").minimal_twist(0, "-pi")
    assert float(plane.twist) == np.pi and plane.half_turn_within == 0


def test_rational_frames_of_minimal_twist():
    """The error by Gauss's rule, of rates from h, sigma and the coefficients of w."""
    curve = phrame.read(ROOT / "examples/curves/farouki-moon-3.json")
    twist = curve.minimal_twist("-pi/4", "5*pi/4")
    frame = twist.rational(subdivide=[0.5])
    nodes, weights = np.polynomial.legendre.leggauss(40)
    mean, turn, square = float(twist.rate), 0.0, 0.0
    h, sigma = (np.polynomial.Polynomial([float(c) for c in p.coefficients]) for p in (curve.h, curve.sigma))
    assert [(p.start, p.end, p.degree, p.is_proved, p.doubt) for p in frame.pieces] == [(0, 0.5, 2, True, ""), (0.5, 1, 2, True, "")]
    for piece in frame.pieces:
        a, b, c = piece.coefficients
        w = np.polynomial.Polynomial([a, 2 * (b - a), a - 2 * b + c])
        tau = (nodes + 1) / 2
        rate = 2 * np.imag(np.conj(w(tau)) * w.deriv()(tau)) / np.abs(w(tau)) ** 2  # of 2 arg w, per tau
        t, width = float(piece.start) + tau / 2, 1 / 2
        speed = sigma(t) * width
        part = 2 * h(t) / sigma(t) * width + rate
        turn += float(weights @ part) / 2
        errors = float(weights @ ((part / speed - mean) ** 2 * speed)) / 2
        square += errors
        assert float(piece.rms) == pytest.approx(np.sqrt(errors / (weights @ speed / 2)) / mean, rel=1e-12)
        assert float(piece.greatest) == pytest.approx(np.abs(part / speed / mean - 1).max(), rel=0.1)
        assert piece.extra_turns == 0 and abs(c) == pytest.approx(abs(float(piece.gamma)), rel=1e-15)
        assert float(piece.other.gamma) * float(piece.gamma) < 0 and piece.other.rms.ball(60)[0] > piece.rms.ball(60)[1]
        assert np.exp(1j * float(frame.value(piece.start))) == pytest.approx((a / abs(a)) ** 2, abs=1e-14)
    assert turn == pytest.approx(float(twist.twist), rel=1e-12)
    assert float(frame.rms) == pytest.approx(np.sqrt(square / float(twist.length)) / mean, rel=1e-12)
    best = twist.rational().pieces[0]
    for gamma in (best.gamma.digits(3) + Decimal(step) for step in ("-0.1", "0.1", "-2")):
        other = twist.rational(gamma=gamma).pieces[0]
        assert float(other.gamma) == pytest.approx(float(gamma), rel=1e-15) and float(other.rms) > float(best.rms)
        assert not other.is_proved and other.other is None and "given" in other.doubt
    assert float(twist.rational(degree=3).rms) < float(best.rms) < float(twist.rational(degree=1, free_ends=True).rms)
    assert max(float(p.rms) for p in twist.rational(subdivide=["rms:1/100"]).pieces) <= 0.01
    with pytest.raises(phrame.InputError, match=r'^subdivide\[1\]: "foo" is none of inflections, extrema'):
        twist.rational(subdivide=["auto", "foo"])
    with pytest.raises(phrame.DomainError, match="PH curves only"):
        phrame.Curve.bezier([[1, 0, 0], [1, 1, 0], [0, 1, 0]], [1, 1, 2]).minimal_twist(0, 1).rational()


def test_check():
    ts = np.linspace(0, 1, 9)
    frames = QUINTIC.frames(ts)
    good = QUINTIC.check(ts, frames[:, 1], frames[:, 2], start=0)
    assert good and good.passes and good.max_error[1] < Fraction(1, 10**15)
    erf = QUINTIC.frames(ts, kind="erf")
    bad = QUINTIC.check(ts, erf[:, 1], start="erf")
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


def test_certificates_of_rational_curves():
    arc = phrame.Path.bezier([(1, 0, 0), (1, 1, 0), (0, 1, 0)], [1, 1, 2])
    certificate = arc.certify(at=[1], digits=30)
    assert certificate.is_proved() and certificate.claims == ((1, 0, 0),)
    assert json.loads(certificate.json())["position"]["w"] == ["1", "0", "1"]
    again = phrame.Certificate.from_json(certificate.json())
    assert again == certificate and again.curve == arc
    with pytest.raises(phrame.DomainError, match="^t = 2 is outside"):
        arc.certify(at=[2])
    half = phrame.Path.bezier([(0, 1, 0), (-1, 1, 0), (-1, 0, 0)], [1, 1, 2])
    assert phrame.Path([arc, half]).certify().is_proved()


def test_certificates_of_splines():
    spline = phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)], "spline")
    certificate = spline.certify(digits=30)
    assert certificate.is_proved() and certificate.curve == spline and certificate.curve.name == "spline"
    (one,), (both,) = QUINTIC.certify(digits=30).claims, certificate.claims  # one curve in two parts
    assert both[0] == 2 and both[1] == one[1]
    again = phrame.Certificate.from_json(certificate.json())
    assert again == certificate and hash(again) == hash(certificate) and "spline" in repr(again)
    apart = json.loads(certificate.json())
    apart["segments"].reverse()
    apart = phrame.Certificate.from_json(json.dumps(apart))
    assert not apart.is_proved()
    with pytest.raises(phrame.DomainError, match="^curve: the segments"):
        apart.curve
    assert spline.certify(frame="frenet", digits=20).is_proved()


def test_certificates_of_any_curve_and_of_lengths():
    cubic = phrame.Path.bezier([(0, 0, 0), (1, 3, -2), (4, 1, 5), (2, -3, 1)], name="cubic")
    certificate = cubic.certify(at=["1/3", 1], digits=30)
    assert certificate.is_proved() and not certificate.is_of_length and certificate.curve == cubic
    assert [c[1] for c in certificate.claims] == [cubic.angle().digits(t, 30) for t in ("1/3", 1)]
    again = phrame.Certificate.from_json(certificate.json())
    assert again == certificate and hash(again) == hash(certificate) and repr(again) == "<Certificate of 2 angles cubic>"
    value = json.loads(certificate.json())
    value["claims"][0]["theta"] = "0.5"
    (objection,) = phrame.Certificate.from_json(json.dumps(value)).objections()
    assert objection.startswith("angle at 1/3: ")
    assert json.loads(cubic.certify(digits=5, up=(1, 2, 3)).json())["up"] == ["1", "2", "3"]
    assert json.loads(cubic.certify(digits=5, frame="frenet").json())["frame"] == "frenet"
    for path in (cubic, QUINTIC):
        length = path.certify(digits=20, length=True)
        assert length.is_proved() and length.is_of_length and length.claims[0][1] == phrame.digits(path.length, 20)
    assert "length" in length._repr_html_() and repr(length).startswith("<Certificate of 1 length")
    value = json.loads(length.json())
    value["claims"][0]["length"] = "0.5"
    (objection,) = phrame.Certificate.from_json(json.dumps(value)).objections()
    assert objection.startswith("length at 1: ")
    value["segments"].append(value["segments"][0])
    with pytest.raises(phrame.DomainError, match="^curve: the segments"):
        phrame.Certificate.from_json(json.dumps(value)).curve
    with pytest.raises(phrame.InputError, match="^length: the length has no frame"):
        cubic.certify(length=True, frame="up")
    with pytest.raises(phrame.InputError, match="^frame: \"erf\" is of PH curves"):
        cubic.certify(frame="erf")


# A circle in quarters: the writhe of a plane curve is 0.
def test_a_certificate_of_a_closed_path():
    sides = [([1, 0, -1], [0, 2]), ([0, -2], [1, 0, -1]), ([-1, 0, 1], [0, -2]), ([0, 2], [-1, 0, 1])]
    quarters = [{"basis": "power", "position": {"x": x, "y": y, "w": [1, 0, 1]}} for x, y in sides]
    circle = phrame.Path.from_json(json.dumps({"phrame": "spline/1", "segments": quarters}))
    certificate = circle.certify(digits=20, holonomy=True, writhe=True)
    assert certificate.is_proved()
    closed = json.loads(certificate.json())["closed"]
    assert [float(closed[key]["value"]) for key in ("holonomy", "writhe")] == [0, 0]
    with pytest.raises(phrame.DomainError, match="does not end where it begins"):
        QUINTIC.certify(writhe=True)
    with pytest.raises(phrame.InputError, match="^writhe: .*Euler-Rodrigues"):
        circle.certify(frame="frenet", writhe=True)
