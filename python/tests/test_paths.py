"""One class for a path of segments of every kind, and one for its angle."""

import json
import math
import pathlib
import pickle
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest

import phrame
from phrame import Polynomial, RationalFunction
from common import QUINTIC, ROOT

SPLINE = phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)], "spline")
LINE = phrame.Curve([1], [0], [0], [0])
CUBIC = phrame.Path.bezier([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]])
CONIC = phrame.Path.bezier([[1, 0, 0], [1, 1, 0], [0, 1, 0]], [1, 1, 2])
HELIX = phrame.Path.expressions("cos(s)", "sin(s)", "s", 0, "2*pi")
MIXED = phrame.Path([LINE, phrame.Path.bezier([[1, 0, 0], [2, 0, 0], [4, 0, 5]])], "mixed")
KINDS = {"ph": [QUINTIC, SPLINE, LINE], "polynomial": [CUBIC], "rational": [CONIC], "expressions": [HELIX], "mixed": [MIXED]}
OF_POLYNOMIAL = ("hodograph", "position", "control_points")
OF_ONE = ("preimage", "multiplier", "weight", "numerator", "start", "degree", "sigma", "h", "g", "rho", "squared_curvature",
          "torsion_function")
OF_PH = ("erf_twist",)


METHODS = ("json",)


def asked(path, name):
    return getattr(path, name)() if name in METHODS else getattr(path, name)


def test_there_is_one_class():
    assert phrame.Curve is phrame.Path
    for kind, paths in KINDS.items():
        for path in paths:
            assert type(path) is phrame.Path and path.kind == kind and path.is_ph == (kind == "ph")
            assert type(path.angle()) is phrame.Angle and path.angle().reference == ("erf" if path.is_ph else "up")
            assert [type(segment) for segment in path.segments] == [phrame.Path] * path.end
    assert MIXED.segments[0] == LINE and MIXED.segments[0].is_ph and MIXED.segments[1].kind == "polynomial"
    lists = [2, -4, 4], [1, 0, -1], [0, -4, 4], [1, 2, -2]
    more = {"multiplier": [1, 1], "start": [1, 2, 3], "name": "a"}
    again = phrame.Path.from_preimage(*lists, **more)
    assert again == phrame.Curve(*lists, **more) == phrame.Path(**dict(zip("uvpq", lists)), **more) != QUINTIC
    assert again.preimage == QUINTIC.preimage and again.point(0) == (1, 2, 3) and again.name == "a"
    assert phrame.Path.bezier(QUINTIC.control_points) == phrame.Path.from_control_points(QUINTIC.control_points)


@pytest.mark.parametrize("name", OF_POLYNOMIAL + OF_ONE + OF_PH)
def test_what_needs_ph_curves_names_the_segment_that_is_none(name):
    for path, segment in ((CUBIC, 0), (HELIX, 0), (MIXED, 1)) + (() if name in OF_ONE else ((CONIC, 0),)):
        with pytest.raises(phrame.DomainError, match=rf"^{name}: segments\[{segment}\] is no (polynomial )?Pythagorean-hodograph curve$"):
            asked(path, name)
    asked(QUINTIC, name)
    if name in OF_PH:
        asked(SPLINE, name)
    else:
        with pytest.raises(phrame.DomainError, match=rf"^{name}: of one curve; there are 2, each in path.segments$"):
            asked(SPLINE, name)


def test_what_a_rational_ph_curve_is_made_of():
    a = (Polynomial([1]), Polynomial([0, 1]), Polynomial([0]), Polynomial([0, 0, 1]))
    w = phrame.Path.from_preimage(*a, multiplier=RationalFunction([3, 0, -10, 0, 3], [1, 0, 5, 0, 10, 0, 10, 0, 5, 0, 1]), start=[1, 2, 3])
    assert w.preimage == a and w.start == w.point(0) == (1, 2, 3)
    assert w.sigma == Polynomial([1, 0, 1, 0, 1]) and w.h == QUINTIC.from_preimage(*a).h and w.rho == QUINTIC.from_preimage(*a).rho
    x, y, z = w.numerator
    for t in (0, Fraction(1, 3), 1):
        assert (x(t) / w.weight(t), y(t) / w.weight(t), z(t) / w.weight(t)) == w.point(t)
        # |r'| = f sigma/W^2, and r' by the quotient rule.
        slopes = [(p.derivative()(t) * w.weight(t) - p(t) * w.weight.derivative()(t)) for p in w.numerator]
        assert sum(slope**2 for slope in slopes) == (w.multiplier(t) * w.sigma(t)) ** 2
        assert w.squared_curvature(t) == w.rho(t) * w.weight(t) ** 4 / (w.multiplier(t) ** 2 * w.sigma(t) ** 4)


@pytest.mark.parametrize("kind", KINDS)
def test_a_path_of_any_kind_is_written_as_a_file(kind):
    for path in KINDS[kind]:
        again = phrame.parse(path.json())
        assert again == path and again.name == path.name and again.kind == path.kind


def test_files_of_paths_are_valid_by_the_schema():
    jsonschema, referencing = pytest.importorskip("jsonschema"), pytest.importorskip("referencing")
    schemas = {file.name: json.loads(file.read_text()) for file in (ROOT / "docs/schema").glob("*.json")}
    registry = referencing.Registry().with_resources((name, referencing.Resource.from_contents(schema)) for name, schema in schemas.items())
    validator = jsonschema.Draft202012Validator({"$ref": "path.json"}, registry=registry)
    for paths in KINDS.values():
        for path in paths:
            validator.validate(json.loads(path.json()))


def test_frames_that_only_ph_curves_have():
    for ask in (lambda: MIXED.angle("erf"), lambda: MIXED.compile(frame="erf"), lambda: CUBIC.frames([0], kind="erf")):
        with pytest.raises(phrame.InputError, match=r'^(frame|kind): "erf" is of PH curves, and segments\[[01]\] is no Pyth'):
            ask()
    # In a path of several kinds PH segments keep theirs.
    at = [0, 0.25, "3/4"]
    assert (MIXED.frames(at, kind="erf") == LINE.frames(at, kind="erf")).all()
    assert (MIXED.quaternions(at, kind="erf") == LINE.quaternions(at, kind="erf")).all()
    with pytest.raises(phrame.DomainError, match="segment 2 is no Pythagorean-hodograph curve"):
        MIXED.frames([0.5, 1.5], kind="erf")
    for ask in (lambda: QUINTIC.angle("erf", up=[0, 0, 1]), lambda: QUINTIC.frames([0], kind="erf", up=[0, 0, 1]), lambda: CUBIC.angle("frenet", up=[0, 0, 1])):
        with pytest.raises(phrame.InputError, match="^up: "):
            ask()


def test_digits_of_rational_and_other_values():
    """θ(0) is rational, and θ of a plane curve; θ(1) of others by quadrature elsewhere."""
    for angle in (QUINTIC.angle(start="1/3"), CUBIC.angle(start="1/3"), CONIC.angle(start="1/3"), HELIX.angle("frenet", start="1/3")):
        assert angle.value(0) == Fraction(1, 3) and angle.digits(0, 12) == Decimal("0.333333333333") == angle.value(0, 12)
        assert angle.digits(1, 30) == angle.value(1, digits=30) == phrame.digits(angle.value(1), 30)
    assert CONIC.angle().digits(1, 20) == 0 and CONIC.angle().is_zero and not CUBIC.angle().is_zero
    assert QUINTIC.angle().digits(1, 20) == Decimal("0.28585653009834106200") and not QUINTIC.angle().is_zero  # [Farouki 2003]
    assert LINE.angle().is_zero and QUINTIC.minimal_twist(0, "pi/3").digits(0, 9) == 0
    assert phrame.Curve([1, 1], [0], [0], [0, 2]).angle().is_zero  # a plane curve, whose h is 0


def test_where_there_is_no_closed_form():
    for name in ("rate", "poles", "sympy"):
        with pytest.raises(phrame.DomainError, match=rf"^{name}: the angle has no closed form: segments\[1\] is no Pyth"):
            getattr(MIXED.angle(), name)()
    # To the frame of a vector PH curves have one, whose derivative is the rate.
    to_up = QUINTIC.angle(up=[0, 0, 1])
    step = Fraction(1, 10**9)
    slope = (to_up.digits(Fraction(1, 2) + step, 40) - to_up.digits(Fraction(1, 2) - step, 40)) / Decimal("2e-9")
    assert abs(slope - Decimal(float(to_up.rate()(Fraction(1, 2))))) < Decimal("1e-14") and len(to_up.poles()) == 4 + 8  # of σ and of |g|²
    formula = to_up.sympy()
    value = formula.subs(formula.free_symbols.pop(), 1).evalf(30).as_real_imag()[0]
    assert abs(Decimal(str(value)) - to_up.digits(1, 30)) < Decimal("1e-25")
    assert QUINTIC.angle(up=[0, 0, 1]).up == (0, 0, 1) and QUINTIC.angle().up is None and QUINTIC.angle("frenet").up is None
    assert "no closed form" in CUBIC.angle().text(style="textbook")
    with pytest.raises(phrame.InputError, match="^style: "):
        CUBIC.angle().text(style="new")


def test_ph_curves_have_the_frame_of_a_vector_too():
    """f₂ = cos θ e₂ + sin θ e₃ with v × e₁ by NumPy; the same curve by points that are rounded is not PH."""
    ts, v = np.linspace(0, 1, 33), [0, 0, 1]
    for path in (QUINTIC, SPLINE):
        at = ts * path.end
        e1, f2, _ = path.frames(at, start="up", up=v).transpose(1, 0, 2)
        e2 = np.cross(v, e1)
        e2 /= np.linalg.norm(e2, axis=1)[:, None]
        assert np.abs(path.frames(at, kind="up", up=v)[:, 1] - e2).max() < 1e-15
        theta = path.angle(up=v)(at)
        assert np.abs(np.cos(theta)[:, None] * e2 + np.sin(theta)[:, None] * np.cross(e1, e2) - f2).max() < 1e-14
        assert np.abs(path.frames(at, up=v) - path.frames(at)).max() < 1e-14  # both start by the least rotation
        assert path.check(at, f2, start="up", up=v, tolerance="1e-12") and path.check(at, f2, tolerance="1e-12")
    near = phrame.Path.bezier([[float(x) for x in point] for point in QUINTIC.control_points])
    assert not near.is_ph and abs(near.angle(up=v)(1) - QUINTIC.angle(up=v)(1)) < 1e-13
    vectors = [path.minimal_twist([0, 0, 1], [0, 1, 1]).twist for path in (QUINTIC, near)]
    assert abs(float(vectors[0]) - float(vectors[1])) < 1e-13
    assert QUINTIC.compile("a", frame="up") != QUINTIC.compile("a")
    for path in (QUINTIC, SPLINE, CUBIC):
        assert abs(float(path.up_twist) + path.angle(up=path.up)(path.end)) < 1e-15


def test_a_total_curvature_without_a_closed_form():
    """∫ 2|g|/σ dt, which is of no rational function, as 4|g|² is no square."""
    with mpmath.workdps(30):
        rho, sigma = ([mpmath.mpf(c.numerator) / c.denominator for c in p.coefficients][::-1] for p in (QUINTIC.rho, QUINTIC.sigma))
        exact = mpmath.quad(lambda t: mpmath.sqrt(mpmath.polyval(rho, t)) / mpmath.polyval(sigma, t), mpmath.linspace(0, 1, 9))
        for path in (QUINTIC, SPLINE):
            assert abs(mpmath.mpf(str(path.total_curvature.digits(25))) - exact) < 1e-20


def test_torsion_is_asked_for_in_one_way():
    for t in (0, "1/3", 1):
        assert QUINTIC.torsion(t) == QUINTIC.torsion_function(t) and SPLINE.torsion(t) == SPLINE.segments[int(Fraction(t))].torsion(Fraction(t) % 1)
    near = phrame.Path.bezier([[float(x) for x in point] for point in QUINTIC.control_points])
    assert abs(float(near.torsion("1/3")) - float(QUINTIC.torsion("1/3"))) < 1e-12


@pytest.mark.parametrize("path", [path for paths in KINDS.values() for path in paths], ids=repr)
def test_transformations(path):
    """Of every kind, by what they do to its points."""
    ts = np.linspace(0, path.end, 4 * path.end + 1)
    r = path.points(ts)
    near = lambda other, expected: np.abs(other.points(ts) - expected).max() < 1e-13
    assert near(path.translated([1, "1/2", -3]), r + [1, 0.5, -3]) and near(path.scaled("-3/2"), -1.5 * r)
    assert near(path.rotated([1, 1, 1, 1]), 4 * r[:, [2, 0, 1]]) and near(path.reversed(), r[::-1])
    for other in (path.translated([1, 0, 0]), path.scaled(-2), path.rotated([2, 0, 0, 1]), path.reversed()):
        assert other.kind == path.kind and other.name == path.name and phrame.Path(other.segments) == other
    part = path.segment("1/4", Fraction(path.end) - Fraction(1, 2))
    assert np.abs(part.points([0, part.end]) - path.points([0.25, path.end - 0.5])).max() < 1e-13 and part.end == path.end
    assert (path.segment("1/2", "1/4").points([0, 1]) == path.points([0.5, 0.25])).all()
    angle, turned = path.angle(up=[0, 1, 3])(ts) if path is not LINE else 0 * ts, path.rotated([0, 0, 0, 1])  # half a turn about z
    if path is not LINE:
        assert np.abs(turned.angle(up=[0, -1, 3])(ts) - angle).max() < 1e-13
    if path is not QUINTIC and path is not LINE:  # a PH curve goes on
        with pytest.raises(phrame.DomainError, match="is outside"):
            path.segment(0, 9)
    for wrong in (lambda: path.segment(1, 1), lambda: path.scaled(0), lambda: path.rotated([0, 0, 0, 0])):
        with pytest.raises(phrame.DomainError):
            wrong()


def test_parts_and_matrices():
    """A point p comes to M·p + v; the parts join to the path again."""
    matrix = [[0, -3, 0, 1], [3, 0, 0, 2], [0, 0, 3, 3]]
    for path in (QUINTIC, CUBIC, phrame.Path([CUBIC, phrame.Path.bezier([[4, 1, 2], [5, 2, 3]])])):
        moved = path.transformed(matrix)
        assert moved.is_ph == path.is_ph
        x, y, z = path.point("1/3")
        assert moved.point("1/3") == (1 - 3 * y, 2 + 3 * x, 3 + 3 * z)
        assert path.transformed(np.eye(4)) == path
        sheared = path.transformed([[1, 1, 0], [0, 1, 0], [0, 0, 1]])
        assert sheared.point("1/3") == (x + y, y, z)
        parts = path.split(["1/4", "1/2"])
        assert [part.point(0) for part in parts] == [path.point(t) for t in (0, "1/4", "1/2")]
        assert parts[-1].point(parts[-1].end) == path.point(path.end)
    half, rest = QUINTIC.split([0.5], by="fraction")
    assert abs(float(half.length) - 71 / 30) < 1e-15
    assert half.length + rest.length == Fraction(71, 15)
    with pytest.raises(phrame.InputError, match="matrix"):
        QUINTIC.transformed([[1, 2], [3, 4]])
    with pytest.raises(phrame.DomainError):
        QUINTIC.split([0])


def test_files_of_what_was_rounded():
    points = [[str(Fraction(float(x)) + Fraction(1, 10**17)) for x in point] for point in QUINTIC.control_points]
    points[2][0] = str(Fraction(points[2][0]) + Fraction(1, 10**16))
    file = '{"phrame": "curve/1", "control_points": %s}' % str(points).replace("'", '"')
    read, near = phrame.Path.from_json(file), phrame.parse(file, near="1e-9")
    assert read == phrame.parse(file) and not read.is_ph and near.is_ph
    off = max(abs(x - y) for k in range(9) for x, y in zip(read.point(Fraction(k, 8)), near.point(Fraction(k, 8))))
    assert 0 < off < Fraction(1, 10**9)


def test_paths_that_do_not_join():
    for second, reason in ((CUBIC, "it starts at"), (phrame.Path.bezier([[4, 1, 2], [3, 0, 1]]), "the tangent turns back")):
        with pytest.raises(phrame.InputError, match=rf"^curves\[1\]: {reason}"):
            phrame.Path([CUBIC, second])
    assert phrame.Path([CUBIC, phrame.Path.bezier([[4, 1, 2], [5, 2, 3]])]).kind == "polynomial"  # a line of length √3
    with pytest.raises(TypeError, match=r"^curves\[1\]: a Path is wanted, not int$"):
        phrame.Path([CUBIC, 3])


def test_paths_of_several_kinds_are_classified_as_a_whole():
    found = MIXED.classify()
    assert found.is_regular and found.line is None and not found.erf_is_rotation_minimizing
    assert found.normal in ((0, 1, 0), (0, -1, 0))
    with pytest.raises(phrame.DomainError, match="classify path.segments"):
        found.cusps


def test_a_path_with_corners():
    cube = phrame.read(pathlib.Path(__file__).parents[2] / "examples/any/cube-edges.json")
    assert cube.corners == (1, 2, 3, 4, 5, 0)
    assert all(abs(float(angle) - math.pi / 2) < 1e-15 for angle in cube.corner_angles)
    assert pickle.loads(pickle.dumps(cube.corner_angles[2])) == cube.corner_angles[2]
    assert cube.holonomy == 0 and cube.self_linking_number is None
    f2 = cube.frames([0.5, 1.5, 2.5])[:, 1]  # along x, y and z: the least rotations are quarter turns
    assert np.array_equal(f2, [[0, 1, 0], [-1, 0, 0], [-1, 0, 0]])
    assert CUBIC.corners == () and CUBIC.corner_angles == ()


def test_two_rings_are_linked():
    a, b = (phrame.Path.expressions(x, y, z, 0, "2*pi") for x, y, z in (("cos(s)", "sin(s)", "0"), ("1 + cos(s)", "0", "sin(s)")))
    assert a.linking_number(b) == b.linking_number(a) == -1
    with pytest.raises(phrame.DomainError, match="the second curve is not closed"):
        a.linking_number(CUBIC)


def test_what_a_path_does_not_have_is_no_attribute_of_it():
    assert hasattr(QUINTIC, "preimage") and not hasattr(CUBIC, "preimage") and not hasattr(SPLINE, "preimage")
    assert getattr(CUBIC, "sigma", None) is None
    with pytest.raises(phrame.DomainError, match="no Pythagorean-hodograph curve"):
        CUBIC.preimage


def test_a_rational_multiplier():
    f = phrame.RationalFunction([1], [64, 192, 240, 160, 60, 12, 1])
    path = phrame.Path.from_preimage([1], [0, 1], [0], [0, 0, 1], multiplier=f)
    assert path.kind == "rational" and not path.is_ph and pickle.loads(pickle.dumps(path)) == path
    assert path.point(0) == (0, 0, 0) and path.length == Fraction(29, 4320)
    with pytest.raises(phrame.InputError, match="^multiplier: x has a logarithm: its residues at the roots of t \\+ 2 are not 0"):
        phrame.Path.from_preimage([1], [0, 1], [0], [0, 0, 1], multiplier=phrame.RationalFunction([1], [16, 32, 24, 8, 1]))


def test_a_whole_curve_through_infinity():
    """A quarter is a part of its circle; holonomy by parallel transport elsewhere (tests/ph/curve/whole_line_test.cpp)."""
    circle = CONIC.whole_line()
    assert circle.end == 2 and circle.is_closed and abs(float(circle.length) - 2 * np.pi) < 1e-15
    assert circle.segments[1].point("1/2") == (-1, 0, 0)
    f = phrame.RationalFunction([1], [1, 0, 3, 0, 3, 0, 1])
    whole = phrame.Path.from_preimage([1], [-1, -1, 1], [-1, 1], [0, 1, -1], multiplier=f).whole_line()
    assert whole.kind == "rational" and abs(float(whole.holonomy) - 2.48851339537653) < 1e-12
    with pytest.raises(phrame.DomainError, match="whole line: the curve is polynomial"):
        QUINTIC.whole_line()
