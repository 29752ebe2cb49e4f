"""Values of every type of the package, and what it means that two are the same."""

import numpy as np

import phrame
from common import QUINTIC


def values():
    """Some of each type."""
    two = phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)], "two")
    cubic = phrame.Curve.bezier([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]])
    helix = phrame.Curve.expressions("cos(s)", "sin(s)", "s", 0, "2*pi", name="helix")
    theta = QUINTIC.angle("frenet", start="pi/4").value("1/3")
    twist = QUINTIC.minimal_twist(0, "pi/3")
    ts = [0, "1/2", 1]
    posed = phrame.Path.through([[0, 0, 0], [1, 0, 0], [2, 1, 1]], orientations=[[0, 0, 0, 1], [1, 0, 0, 5], [0, 0, 1, 4]],
                                smooth_twist=True, turns=[0, 1])
    plane, circle = phrame.Curve([1], [0], [0], [0, 1]), phrame.Path.polynomial([1, 0, -1], [0, 2], [], [1, 0, 1])
    triangle = phrame.Path.polyline([[0, 0, 0], [4, 0, 0], [4, 3, 0]], closed=True)
    axis = [[0, 0, 1], ["3/2", 0, 1], [3, 1, 2]]
    return {
        phrame.Polynomial: [QUINTIC.sigma, phrame.Polynomial([])],
        phrame.RationalFunction: [QUINTIC.torsion_function],
        phrame.Real: [theta, QUINTIC.erf_twist, 2 * theta, -theta, 1 / theta, theta - 1, abs(-theta), phrame.root([-2, 0, 1], 1, 2),
                      twist.twist, twist.value("1/2"), phrame.integrate("1/(x^2+1)", 0, 1).value(), cubic.length,
                      cubic.angle().value("1/3"), cubic.curvature("1/4"), cubic.parameter_at(1), QUINTIC.parameter_at(1),
                      *helix.point("1/7")],
        phrame.Path: [QUINTIC, posed, phrame.Curve([1, 2], [0, 1], [0], [1], multiplier=[1, 0, 1], start=[1, 2, 3], name="α"), two, cubic, phrame.Curve.bezier([[1, 0, 0], [1, 1, 0], [0, 1, 0]], [1, 1, 2]), helix,
                      phrame.Path([phrame.Curve([1], [0], [0], [0]), phrame.Curve.bezier([[1, 0, 0], [2, 0, 0], [4, 0, 5]])], "both")],
        phrame.Angle: [QUINTIC.angle(), two.angle(start="pi/4"), QUINTIC.angle("frenet"), QUINTIC.angle(start_normal=[0, 0, 1]), QUINTIC.angle(up=[0, 0, 1]), cubic.angle(start=1), cubic.angle("frenet"), cubic.angle(up=[0, 0, 1])],
        phrame.Integral: [phrame.integrate("1/(x^5+1)", variable="x"), phrame.integrate("1/y", 1, "sqrt(2)", style="real")],
        phrame.Classification: [QUINTIC.classify(), two.classify()],
        phrame.MinimalTwist: [twist, cubic.minimal_twist(0, 1, extra_turns=1)],
        phrame.PathTwist: [posed.twist(), posed.twist(up=[1, 5, -2])],
        phrame.RationalTwist: [twist.rational(), twist.rational(gamma="3/4"), twist.rational(degree=1, free_ends=True)],
        phrame.RationalTwistPiece: [*twist.rational(subdivide=["inflections", "1/2"], proved=False).pieces, twist.rational().pieces[0].other],
        phrame.CheckResult: [QUINTIC.check(ts, QUINTIC.frames(ts)[:, 1]), cubic.check(ts, cubic.frames(ts, kind="frenet")[:, 1])],
        phrame.Offset: [plane.offset(-1), plane.offset(-1, trim=True), triangle.offset(-1, "mitre", pocket=True),
                        plane.offset("1/2", gauge=circle), phrame.Curve.bezier([[0, 0, 0], ["1/2", 0, 0], [1, 1, 0]]).offset("1/3")],
        phrame.OffsetCheck: [plane.check_offset(plane.offset(1)[0], 1), triangle.check_offset([[0, 1], [1, 2]], 1, trim=True)],
        phrame.Gauge: [phrame.Gauge.of(circle)],
        phrame.Envelope: [phrame.envelope(axis), phrame.envelope([axis], trim=True)],
        phrame.Certificate: [QUINTIC.certify(at=["1/2"], digits=20), two.certify(digits=5)],
        phrame.SweptBody: [phrame.sweep(cubic, "polygon:3,1/9", sections=3),
                           phrame.sweep(QUINTIC, "polygon:3,1/9", normal_tolerance="30deg")],
        phrame.ReferenceCurve: phrame.reference("plane")[:2],
        phrame.InputError: [phrame.InputError("t: bad", "t", "bad", 3)],
        phrame.DomainError: [phrame.DomainError("a pole")],
        phrame.Undecided: [phrame.Undecided("t: 10 bits", "t", "10 bits", "x")],
        phrame.Error: [phrame.Error("e")],
    }


VALUES = values()


def member_names(x):
    """What a value says of itself: its attributes, texts and digits."""
    attributes = {name for kind in type(x).__mro__ for name, of in vars(kind).items() if isinstance(of, property)}
    return sorted(attributes | {name for name in ("json", "text", "latex", "volume", "args", "reason") if hasattr(x, name)})


def member(x, name):
    try:
        found = getattr(x, name)
        return found() if callable(found) and type(found) not in VALUES else found
    except phrame.Error as error:
        return str(error)


def same(a, b):
    if type(a) is not type(b):
        return False
    if isinstance(a, phrame.Real):
        return a.digits(40) == b.digits(40)
    if isinstance(a, np.ndarray):
        return a.shape == b.shape and bool((a == b).all())
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key]) for key in a)
    if isinstance(a, (tuple, list)):
        return len(a) == len(b) and all(map(same, a, b))
    if type(a) not in VALUES:
        return a == b or repr(a) == repr(b)
    if type(a).__eq__ is not object.__eq__:
        return a == b and hash(a) == hash(b)
    return repr(a) == repr(b) and all(same(member(a, name), member(b, name)) for name in member_names(a))
