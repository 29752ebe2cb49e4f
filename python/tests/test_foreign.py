"""Numbers and tables of other packages: taken exactly, with their signs, or refused by name. Packages that are not here are skipped."""

import random
import warnings
from fractions import Fraction

import numpy as np
import pytest

import phrame
from common import MULTIPLIER, QUINTIC

LINE = phrame.Polynomial([0, 1])
TWO = phrame.root([-2, 0, 1], 1, 2)
HUGE = 2**900 + 2**850
NUMBERS = [Fraction(-1), Fraction(-3, 4), Fraction(1e-300), Fraction(-1e-300), Fraction(HUGE), Fraction(-HUGE), Fraction(0), Fraction(7, 8)]


def _numpy_kinds():
    for kind in (np.float16, np.float32, np.float64, np.longdouble):
        most = Fraction(float(min(np.finfo(kind).max, np.finfo(float).max)))
        yield kind.__name__, lambda x, kind=kind, most=most: kind(float(x)) if abs(x) <= most and float(kind(float(x))) == x else None
    for kind in (np.int8, np.int16, np.int32, np.int64, np.uint8, np.uint16, np.uint32, np.uint64):
        fits = np.iinfo(kind)
        yield kind.__name__, lambda x, kind=kind, fits=fits: kind(int(x)) if x.denominator == 1 and fits.min <= x <= fits.max else None


def _array(make):
    return lambda x: None if make(x) is None else np.array(make(x))


def kinds():
    """What makes an object of each type of a fraction, or None where it has none that is equal."""
    from decimal import Decimal, localcontext

    def decimal(x):
        with localcontext() as context:
            context.prec = 2000
            return Decimal(x.numerator) / Decimal(x.denominator)

    made = {"int": lambda x: int(x) if x.denominator == 1 else None, "float": float, "Fraction": lambda x: x, "str": str, "Decimal": decimal}
    made.update(_numpy_kinds())
    made.update({f"array of {name}": _array(make) for name, make in _numpy_kinds()})
    return made


def _mpmath(mpmath):
    return {"mpf": lambda x: mpmath.mpf(x.numerator) / x.denominator}


def _gmpy2(gmpy2):
    return {"mpz": lambda x: gmpy2.mpz(int(x)) if x.denominator == 1 else None, "xmpz": lambda x: gmpy2.xmpz(int(x)) if x.denominator == 1 else None,
            "mpq": lambda x: gmpy2.mpq(x.numerator, x.denominator), "mpfr": lambda x: gmpy2.mpfr(float(x))}


def _flint(flint):
    return {"fmpz": lambda x: flint.fmpz(int(x)) if x.denominator == 1 else None, "fmpq": lambda x: flint.fmpq(x.numerator, x.denominator),
            "arb": lambda x: flint.arb(float(x)), "arf": lambda x: flint.arf(float(x))}


def _sympy(sympy):
    return {"Integer": lambda x: sympy.Integer(int(x)) if x.denominator == 1 else None,
            "Rational": lambda x: sympy.Rational(x.numerator, x.denominator), "Float": lambda x: sympy.Float(float(x))}


PACKAGES = {"mpmath": _mpmath, "gmpy2": _gmpy2, "flint": _flint, "sympy": _sympy}


def kinds_of(package):
    return kinds() if package == "python" else PACKAGES[package](pytest.importorskip(package))


@pytest.mark.parametrize("package", ["python", *PACKAGES])
def test_numbers_of_all_kinds_keep_sign_and_size(package):
    tried = 0
    for name, make in kinds_of(package).items():
        for x in NUMBERS:
            given = make(x)
            if given is not None:
                tried += 1
                assert LINE(given) == x, (name, x)
                assert phrame.Polynomial([given]).coefficients == ((x,) if x else ()), (name, x)
    assert tried > 5


NOT_FINITE = {
    "numpy": lambda numpy: [kind(x) for kind in (np.float16, np.float32, np.longdouble) for x in ("nan", "inf", "-inf")],
    "mpmath": lambda mpmath: [mpmath.nan, mpmath.inf, -mpmath.inf],
    "gmpy2": lambda gmpy2: [gmpy2.nan(), gmpy2.inf(), -gmpy2.inf()],
    "flint": lambda flint: [flint.arb("nan"), flint.arb("inf"), flint.arf("nan"), flint.arf("inf")],
    "sympy": lambda sympy: [sympy.nan, sympy.oo, -sympy.oo, sympy.zoo],
}


@pytest.mark.parametrize("package", NOT_FINITE)
def test_what_is_not_finite_is_refused(package):
    for x in NOT_FINITE[package](pytest.importorskip(package)):
        with pytest.raises((phrame.InputError, TypeError), match="^t: "):
            LINE(x)


NO_NUMBERS = {
    "numpy": lambda numpy: [np.bool_(True), np.timedelta64(5, "s"), np.datetime64(1, "s"), np.complex64(1), np.array([1.0]), np.array(True), np.ma.masked,
                            np.array(1j), np.str_("x"), np.void(b"1")],
    "mpmath": lambda mpmath: [mpmath.mpc(1), mpmath.matrix([1]), mpmath.mpf("1e1000000000"), mpmath.mpf("-1e-1000000000"), mpmath.iv.mpf([1, 2])],
    "gmpy2": lambda gmpy2: [gmpy2.mpc(1)],
    "flint": lambda flint: [flint.arb(2).sqrt(), flint.acb(1), flint.nmod(3, 7), flint.arb((1, 2**30)), flint.fmpq_poly([1])],
    "sympy": lambda sympy: [sympy.pi, sympy.sqrt(2), sympy.I, sympy.Symbol("x"), sympy.true],
}


@pytest.mark.parametrize("package", NO_NUMBERS)
def test_what_is_no_number_is_refused(package):
    for x in NO_NUMBERS[package](pytest.importorskip(package)):
        with pytest.raises((phrame.InputError, TypeError), match="^t: "):
            LINE(x)


def test_the_sign_of_mpmath_in_calls():
    mpf = pytest.importorskip("mpmath").mpf
    assert QUINTIC.point(mpf(-0.75)) == QUINTIC.point("-3/4") != QUINTIC.point(0.75)
    assert phrame.integrate("x^2", mpf(-1), 0).value() == Fraction(1, 3)
    theta = QUINTIC.angle().value(1)
    assert theta > mpf(-1) and not theta < mpf(-1) and (theta + mpf(-1)).digits(20) == (theta - 1).digits(20)
    assert QUINTIC.angle(start=mpf(-1)).value(0) == -1
    assert phrame.Curve([mpf(-2), 4], [mpf(-1)], [0, 4], [1]) == phrame.Curve([-2, 4], [-1], [0, 4], [1])


RNG_CALLS = {
    "point": lambda x: (QUINTIC.point, (x,)),
    "polynomial": lambda x: (QUINTIC.sigma, (x,)),
    "torsion": lambda x: (QUINTIC.torsion, (x,)),
    "angle": lambda x: (lambda t: QUINTIC.angle().value(t, digits=25), (x,)),
    "start": lambda x: (lambda a: QUINTIC.angle(start=a).value(0), (x,)),
    "curve": lambda x: (lambda a: phrame.Curve([1, a], [a, 2], [0], [3]).position, (x,)),
    "points": lambda x: (lambda t: QUINTIC.points([t, 0]).tolist(), (x,)),
    "translated": lambda x: (lambda a: QUINTIC.translated([a, 0, a]).point(0), (x,)),
    "curvature": lambda x: (lambda t: phrame.Real.digits(QUINTIC.curvature(t), 20), (x,)),
    "bezier": lambda x: (lambda a: phrame.Curve.bezier([[0, 0, 0], [1, a, 0], [3, 0, a], [4, 1, 2]]).point("1/3"), (x,)),
    "integral": lambda x: (lambda a: phrame.integrate("x^2", a, 1).value(), (x,)),
    "compared": lambda x: (lambda a: QUINTIC.erf_twist < a, (x,)),
    "equal": lambda x: (lambda a: TWO == a or TWO * 8 > a, (x,)),
    "sum": lambda x: (lambda a: TWO + number(a), (x,)),
    "difference": lambda x: (lambda a: TWO - number(a), (x,)),
    "product": lambda x: (lambda a: TWO * number(a), (x,)),
    "quotient": lambda x: (lambda a: answer(lambda b: TWO / b, number(a)), (x,)),
    "remainder": lambda x: (lambda a: answer(lambda b: TWO % b, number(a)), (x,)),
    "arc length": lambda x: (lambda t: answer(QUINTIC.arc_length, t), (x,)),
    "parameter": lambda x: (lambda s: answer(QUINTIC.parameter_at, s), (x,)),
    "frames": lambda x: (lambda a: QUINTIC.frames([0, "1/2"], start=a).tolist(), (x,)),
    "root": lambda x: (lambda a: answer(phrame.root, [-2, 0, 1], 0, a), (x,)),
    "spline": lambda x: (lambda a: phrame.Curve.cubic_spline([[0, 0, 0], [1, a, 3], [2, 1, 5], [3, 3, a]]).point("1/2"), (x,)),
}


def number(a):
    """A text is no operand."""
    return Fraction(a) if isinstance(a, str) else a


def answer(f, *arguments):
    try:
        return f(*arguments)
    except (phrame.DomainError, ZeroDivisionError) as error:
        return type(error)


def test_random_calls_have_the_value_of_the_fraction():
    """3000 of them with the multiplier; some for every day."""
    rng = random.Random(41)
    makers = list(kinds().items())
    for name, of in PACKAGES.items():
        try:
            makers += of(__import__(name)).items()
        except ImportError:
            pass
    for _ in range(300 if MULTIPLIER == 1 else 3000):
        call, (kind, make) = rng.choice(list(RNG_CALLS)), rng.choice(makers)
        x = Fraction(rng.randint(-99, 99), 2 ** rng.randint(0, 4))
        given = make(x)
        if given is None:
            x = Fraction(abs(x.numerator))
            given = make(x)
        f, arguments = RNG_CALLS[call](given)
        assert f(*arguments) == RNG_CALLS[call](x)[0](x), (call, kind, x)


class LikeMpz:
    """What numbers of gmpy2 2.3 have."""

    def __init__(self, x):
        self.x = x

    def __index__(self):
        return self.x

    def __array__(self, *_, **__):
        return np.array(self.x)

    def __len__(self):
        return 1

    def __getitem__(self, k):
        raise IndexError


class LikeArf:
    """What an arf has of old releases of python-flint."""

    def man_exp(self):
        return 3, -1


def test_numbers_that_look_like_lists_or_like_none():
    angle = QUINTIC.angle()
    for package, make in {"flint": lambda flint: flint.arb(2).sqrt(), "mpmath": lambda mpmath: mpmath.iv.mpf([1, 2])}.items():
        try:
            ball = make(__import__(package))
        except ImportError:
            continue
        for f in (lambda x, y: x + y, lambda x, y: x * y, lambda x, y: x < y, lambda x, y: x // y):
            with pytest.raises((phrame.InputError, TypeError)):
                f(TWO, ball)
    assert angle(LikeMpz(1)) == angle(1) and QUINTIC.point(LikeMpz(1)) == QUINTIC.point(1) and TWO * LikeMpz(3) == 3 * TWO
    assert TWO + LikeArf() == TWO + Fraction(3, 2) == LikeArf() + TWO and TWO < LikeArf() and QUINTIC.point(LikeArf()) == QUINTIC.point("3/2")


# ---- units, masks, tables


class Quantity:
    """As much of a number with a unit as is asked for, as pint has it: it forwards what it has not."""

    ndim = 0

    def __init__(self, magnitude, units):
        self.magnitude, self.units = magnitude, units

    def __getattr__(self, name):
        return getattr(self.magnitude, name)


def quantities():
    """(package, function (number, name of the unit) → quantity) of those that are here."""
    yield "like pint", Quantity
    try:
        import pint

        yield "pint", pint.UnitRegistry().Quantity
    except ImportError:
        pass
    try:
        from astropy import units

        yield "astropy", lambda x, unit: x * units.Unit(unit)
    except ImportError:
        pass
    try:
        import unyt

        yield "unyt", lambda x, unit: (unyt.unyt_quantity if np.ndim(x) == 0 else unyt.unyt_array)(x, unit or "dimensionless")
    except ImportError:
        pass
    try:
        import quantities

        yield "quantities", lambda x, unit: quantities.Quantity(x, unit or "dimensionless")
    except ImportError:
        pass


@pytest.mark.parametrize("package, quantity", list(quantities()), ids=lambda x: x if isinstance(x, str) else "")
def test_units_are_read_or_refused(package, quantity):
    assert QUINTIC.angle(start=quantity(45.0, "degree")) .value(0).digits(30) == QUINTIC.angle(start="45deg").value(0).digits(30)
    assert QUINTIC.angle(start=quantity(-30.0, "arcmin" if package != "like pint" else "arcminute")).value(0).digits(30) \
        == QUINTIC.angle(start="-0.5deg").value(0).digits(30)
    assert QUINTIC.angle(start=quantity(0.5, "radian")).value(0) == Fraction(1, 2) == QUINTIC.angle(start=quantity(0.5, "")).value(0)
    assert LINE(quantity(-0.75, "")) == Fraction(-3, 4)
    for unit in ("mm", "degree"):
        with pytest.raises(phrame.InputError, match="^t: its unit is"):
            LINE(quantity(0.5, unit))
    with pytest.raises(phrame.InputError, match="^start: its unit, "):
        QUINTIC.angle(start=quantity(0.5, "mm"))
    with pytest.raises(phrame.InputError, match=r"^points\[1\]\[2\]: its unit is"):
        phrame.Curve.bezier([[0, 0, 0], [1, 2, quantity(3.0, "mm")]])
    if package != "like pint":
        with pytest.raises(phrame.InputError, match="^ts: its unit is"):
            QUINTIC.points(quantity(np.array([0.0, 0.5]), "mm"))
        with pytest.raises(phrame.InputError, match="^points: its unit is"):
            phrame.Curve.bezier(quantity(np.eye(4)[:, :3], "mm"))
        assert (QUINTIC.points(quantity(np.array([0.0, 0.5]), "")) == QUINTIC.points([0, 0.5])).all()


def test_masks_are_refused():
    for mask, ok in (([False, False], True), ([False, True], False)):
        ts = np.ma.array([0.0, 0.5], mask=mask)
        if ok:
            assert (QUINTIC.points(ts) == QUINTIC.points([0, 0.5])).all()
        else:
            for ask in (QUINTIC.points, QUINTIC.angle(), QUINTIC.frames):
                with pytest.raises(phrame.InputError, match=r"^ts\[1\]: it is masked"):
                    ask(ts)
            with pytest.raises(phrame.InputError, match=r"^u\[1\]: it is masked"):
                phrame.Curve(ts, [0], [0], [1])
            with pytest.raises(phrame.InputError, match=r"^u\[1\]: it is masked"):
                phrame.Curve(list(ts), [0], [0], [1])
    points = np.ma.array(np.eye(4)[:, :3], mask=False)
    assert phrame.Curve.bezier(points) == phrame.Curve.bezier(points.data.tolist())
    points.mask[2, 1] = True
    with pytest.raises(phrame.InputError, match=r"^points\[2\]\[1\]: it is masked"):
        phrame.Curve.bezier(points)
    with pytest.raises(phrame.InputError, match=r"^f2\[2\]\[1\]: it is masked"):
        QUINTIC.check([0, 0.5, 0.75, 1], points)
    with pytest.raises(phrame.InputError, match=r"^f2\[2\]\[1\]: it is masked"):
        QUINTIC.plot([0, 0.5, 0.75, 1], f2=points)


POINTS = [[0, 1, 2.5], [1, 2**60 + 1, 0], [3, 5, 1]]


def tables():
    """(package, function (list of columns, names) → table)."""
    yield "structured", lambda columns, names: np.array(list(zip(*columns)), dtype=[(n, object) for n in names])
    try:
        import pandas

        yield "pandas", lambda columns, names: pandas.DataFrame(dict(zip(names, columns)))
    except ImportError:
        pass
    try:
        import polars

        yield "polars", lambda columns, names: polars.DataFrame(dict(zip(names, columns)))
    except ImportError:
        pass
    try:
        import pyarrow

        yield "pyarrow", lambda columns, names: pyarrow.table(dict(zip(names, columns)))
    except ImportError:
        pass


@pytest.mark.parametrize("package, table", list(tables()), ids=lambda x: x if isinstance(x, str) else "")
def test_tables_are_read_by_rows_and_names(package, table):
    expected = phrame.Curve.bezier(POINTS)
    x, y, z = zip(*POINTS)
    assert phrame.Curve.bezier(table([x, y, z], "xyz")) == expected
    assert phrame.Curve.bezier(table([z, x, y], "ZXY")) == expected
    assert phrame.Curve.bezier(table([x, y, z], "abc")) == expected
    assert phrame.Curve.bezier(table([x, y], "xy")) == phrame.Curve.bezier([[a, b, 0] for a, b in zip(x, y)])
    for columns, names in (([x], "x"), ([x, x, y, z], "txyz"), ([x, y, z], "xyt")):
        with pytest.raises(phrame.InputError, match="^points: the columns x, y, z are wanted, not "):
            phrame.Curve.bezier(table(columns, names))
    ts = [0.0, 0.25, 1.0]
    assert (QUINTIC.points(table([ts], "t")) == QUINTIC.points(ts)).all()
    assert (QUINTIC.points(table([ts, x], "tx")["t"]) == QUINTIC.points(ts)).all()
    with pytest.raises(phrame.InputError, match="^ts: a list of numbers is wanted, not a table with the columns t, x"):
        QUINTIC.points(table([ts, x], "tx"))
    rows = [[1, 0, 2, 3], [4, 5, 6, 7]]
    u, v, p, q = zip(*rows)
    assert phrame.Curve.from_quaternions(table([q, u, v, p], "quvp")) == phrame.Curve.from_quaternions(rows)
    profile = [[0, 0], [1, 0], [0, 1]]
    body = [phrame.sweep(QUINTIC, given, sections=3).volume() for given in (profile, table(list(zip(*profile)), "xy"))]
    assert body[0] == body[1]


class Tensor:
    """As tensors are that NumPy does not read: on a GPU, with a gradient, of bfloat16. What is there is a list."""

    def __init__(self, numbers, dtype):
        self.numbers, self.dtype, self.shape, self.ndim = numbers, dtype, np.shape(numbers), np.ndim(numbers)

    def __len__(self):
        return len(self.numbers)

    def __getitem__(self, k):
        return Tensor(self.numbers[k], self.dtype)

    def __array__(self, *_, **__):
        raise TypeError("can't convert this tensor to numpy")

    def tolist(self):
        return self.numbers

    def item(self):
        return self.numbers


class Exported:
    """What gives its memory by DLPack, or by __array__, and has no elements of its own."""

    def __init__(self, array, way):
        self.dtype = array.dtype
        if way == "dlpack":
            self.__class__ = type("ByDlpack", (Exported,), {
                "__dlpack__": lambda self, **options: array.__dlpack__(), "__dlpack_device__": lambda self: array.__dlpack_device__()})
        elif way == "array":
            self.__class__ = type("ByArray", (Exported,), {"__array__": lambda self, dtype=None, copy=None: array})


@pytest.mark.parametrize("kind", ["float16", "float32", "float64", ">f8", "longdouble", "int8", "uint64"])
def test_arrays_of_all_kinds_are_read_exactly(kind):
    ts = np.array([0, 1, 2, 3] if "int" in kind else [0, 0.1, 0.75, 1]).astype(kind)
    exact = [Fraction(int(x)) if "int" in kind else Fraction(*x.as_integer_ratio()) for x in ts]
    assert phrame.Polynomial(ts).coefficients[1:] == tuple(exact[1:])
    found = QUINTIC.points(exact)
    for given in (ts, Exported(ts, "array"), Tensor([x.item() for x in ts], kind), ts[::-1][::-1], *([Exported(ts, "dlpack")] if kind[0] not in ">l" else [])):
        assert (QUINTIC.points(given) == found).all() and phrame.Polynomial(given) == phrame.Polynomial(exact)
    points = np.arange(12).reshape(4, 3).astype(kind) ** 2 if kind != "int8" else np.arange(12).reshape(4, 3).astype(kind)
    for given in (points, Exported(points, "array"), Tensor(points.tolist() if kind != "longdouble" else [list(row) for row in points], kind)):
        assert phrame.Curve.bezier(given) == phrame.Curve.bezier([[Fraction(float(x)) for x in row] for row in points])


def test_tensors_that_cannot_be_read_are_refused():
    with pytest.raises(phrame.InputError, match="^ts: a Unreadable that NumPy cannot read: "):
        QUINTIC.points(type("Unreadable", (), {"__dlpack__": lambda self: 1 / 0, "dtype": "bfloat16"})())
    for wrong in (np.array([0j, 1]), np.array(["2020-01-01"], dtype="M8[D]"), np.zeros(2, "V2"), np.array([True, False])):
        with pytest.raises((phrame.InputError, TypeError), match="^ts"):
            QUINTIC.points(wrong)


@pytest.mark.parametrize("package", ["torch", "jax.numpy", "tensorflow", "ml_dtypes"])
def test_tensors_of_packages(package):
    """Where the package is, its own tensors."""
    module = pytest.importorskip(package)
    ts = [0.0, 0.25, 0.75]
    kinds = [module.bfloat16, module.float8_e4m3fn] if package == "ml_dtypes" else [module.float16, module.float32, module.bfloat16]
    for kind in kinds:
        make = {"torch": "tensor", "jax.numpy": "array", "tensorflow": "constant"}.get(package)
        given = np.array(ts).astype(kind) if make is None else getattr(module, make)(ts, dtype=kind)
        assert (QUINTIC.points(given) == QUINTIC.points(ts)).all()


def test_curves_of_scipy_are_taken_exactly():
    """By their attributes: a B-spline with two spans, the same by its pieces, and as splprep has it."""
    from types import SimpleNamespace

    t, c = np.array([0, 0, 0, 0.1, 1, 1, 1]), np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 2.0]])
    spline = phrame.Path.from_scipy(SimpleNamespace(t=t, c=c, k=2))
    assert len(spline.segments) == 2
    # At the knot it is between the two points in the middle, in the ratio 1/10 of the double 0.1.
    ratio = Fraction(0.1)
    assert spline.segments[0].point(1) == (1, ratio, 0)
    assert phrame.Path.from_scipy((t, c.T, 2)) == spline
    assert phrame.Path.from_scipy(([t, list(c.T), 2], np.zeros(4))) == spline
    line = phrame.Path.from_scipy(SimpleNamespace(c=np.array([[[1.0, 2, 2]], [[0, 0, 0]]]), x=[0, 3]))
    assert line.length == 9
    with pytest.raises(TypeError, match="t, c and k or with c and x"):
        phrame.Path.from_scipy(3)
    with pytest.raises(TypeError, match="a BPoly is not read"):
        phrame.Path.from_scipy(type("BPoly", (), {"c": c, "x": t})())
    with pytest.raises(phrame.InputError):
        phrame.Path.from_scipy((t, c.T, 9))


def test_rows_without_numbers_are_skipped_and_curves_picked_on_request():
    text = "x,y\n0,0\n,\n1,2\n"
    with pytest.raises(phrame.InputError, match="line 3, x: the field is empty"):
        phrame.parse(text)
    with pytest.warns(UserWarning, match="left out is 1 row"):
        path = phrame.parse(text, skip_invalid=True)
    assert path.end == 1
    with pytest.warns(UserWarning, match="natural cubic spline"):
        picked = phrame.parse("v 0 0 0\nv 1 2 3\nv 5 5 5\no a\nl 1 2\no b\nl 2 3\n", pick="b")
    assert picked.name == "b"


def _same_points(path, points, at, by="native"):
    np.testing.assert_allclose(path.points(at, by=by), points, rtol=1e-14, atol=1e-14)


def test_curves_of_scipy():
    interpolate = pytest.importorskip("scipy.interpolate")
    ts = np.linspace(0, 5, 9)
    spline = interpolate.make_interp_spline(ts, np.transpose([np.cos(ts), np.sin(2 * ts), ts]), k=3)
    us = np.linspace(0, 5, 6)
    _same_points(phrame.Path.of(spline), spline(us), us)


def test_curves_of_splipy():
    factory = pytest.importorskip("splipy.curve_factory")
    for curve in (factory.circle(2), factory.circle_segment(1.2, 3), factory.cubic_curve(np.array([[0.0, 0, 0], [1, 2, 0], [3, 1, 1], [4, 4, 2]]))):
        path = phrame.Path.of(curve)
        us = np.linspace(curve.start(0), curve.end(0), 7)
        _same_points(path, [[*p, *[0] * (3 - len(p))] for p in (curve(float(u)) for u in us[:-1])], us[:-1])
        assert path.is_closed == bool(curve.periodic())


def test_curves_of_geomdl():
    geomdl = pytest.importorskip("geomdl.NURBS")
    curve = geomdl.Curve()
    curve.degree = 2
    curve.ctrlpts = [[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]]
    curve.weights = [1, 2, 1, 0.5]
    curve.knotvector = [0, 0, 0, 0.3, 1, 1, 1]
    _same_points(phrame.Path.of(curve), curve.evaluate_list([0, 0.1, 0.3, 0.7, 1]), [0, 0.1, 0.3, 0.7, 1])
    surfaces = pytest.importorskip("geomdl.BSpline")
    with pytest.raises(phrame.InputError, match="a Surface of geomdl is no curve"):
        phrame.Path.of(surfaces.Surface())


def test_curves_of_rhino3dm():
    rhino = pytest.importorskip("rhino3dm")
    for curve in (rhino.NurbsCurve.Create(False, 3, [rhino.Point3d(*p) for p in ([0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2], [5, 5, 5])]),
                  rhino.Circle(2).ToNurbsCurve(), rhino.LineCurve(rhino.Point3d(0, 0, 1), rhino.Point3d(1, 2, 3))):
        low, high = curve.Domain.T0, curve.Domain.T1
        us = np.linspace(low, high, 6)
        points = [(p.X, p.Y, p.Z) for p in (curve.PointAt(float(u)) for u in us)]
        np.testing.assert_allclose(phrame.Path.of(curve).points(us, by="native"), points, rtol=1e-12, atol=1e-12)


def test_edges_of_open_cascade():
    """Of cadquery and build123d, in their places and senses, with the points that Open CASCADE has."""
    ocp = pytest.importorskip("OCP.gp")
    from OCP.BRepAdaptor import BRepAdaptor_Curve
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeWire
    from OCP.GC import GC_MakeArcOfCircle
    from OCP.TopLoc import TopLoc_Location
    from OCP.TopoDS import TopoDS

    line = BRepBuilderAPI_MakeEdge(ocp.gp_Pnt(0, 0, 0), ocp.gp_Pnt(0, 10, 0)).Edge()
    arc = BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(ocp.gp_Pnt(0, 10, 0), ocp.gp_Pnt(3, 14, 0), ocp.gp_Pnt(10, 15, 2)).Value()).Edge()
    wire = BRepBuilderAPI_MakeWire(line, arc).Wire()
    turn = ocp.gp_Trsf()
    turn.SetRotation(ocp.gp_Ax1(ocp.gp_Pnt(1, 2, 3), ocp.gp_Dir(1, 1, 0)), 0.5)
    for edge in (line, arc, arc.Reversed(), arc.Moved(TopLoc_Location(turn))):
        path, adaptor = phrame.Path.of(edge), BRepAdaptor_Curve(TopoDS.Edge(edge))
        ends = [adaptor.Value(t) for t in (adaptor.FirstParameter(), adaptor.LastParameter())]
        if edge.Orientation() != line.Orientation():
            ends.reverse()
        assert np.abs(path.points([0, path.end]) - [[p.X(), p.Y(), p.Z()] for p in ends]).max() < 1e-14
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a gap that is closed, perhaps
        path = phrame.Path.of(wire)
    assert np.ptp(phrame.Path.of(arc).curvature([0, "1/3", "1/2"])) < 1e-14  # it is a circle
    assert abs(float(path.length) - 10 - float(phrame.Path.of(arc).length)) < 1e-13 and len(path.corners) == 1
    with pytest.raises(phrame.InputError, match="an edge or a wire"):
        phrame.Path.of(ocp.gp_Pnt(0, 0, 0))


def test_curves_of_ezdxf():
    ezdxf = pytest.importorskip("ezdxf")
    from ezdxf.math import BSpline

    spline = BSpline([(0, 0, 0), (1, 2, 0), (3, 0, 1), (4, 1, 2), (5, 5, 5)], order=4, weights=[1, 2, 1, 1, 1])
    space = ezdxf.new().modelspace()
    entity = space.add_spline()
    entity.apply_construction_tool(spline)
    us = np.linspace(0, spline.max_t, 6)
    for curve in (spline, entity):
        _same_points(phrame.Path.of(curve), [tuple(p) for p in spline.points(us)], us)
    half = phrame.Path.of(space.add_lwpolyline([(0, 0, 1), (4, 0, 0)], format="xyb"))
    assert half.points([1]).tolist() == [[2, -2, 0]] and float(half.length) == 2 * np.pi


def test_polylines_of_shapely_trimesh_and_pyvista():
    points = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, 0.0, 1.0], [4.0, 1.0, 2.0]]
    wanted = phrame.Path.polyline(points)
    assert wanted.corners == (1, 2) and wanted.end == 3
    geometry = pytest.importorskip("shapely.geometry")
    assert phrame.Path.of(geometry.LineString(points)) == wanted
    assert phrame.Path.of(geometry.LinearRing(points)) == phrame.Path.polyline(points, closed=True)
    with pytest.raises(phrame.InputError, match="a Polygon is no curve"):
        phrame.Path.of(geometry.Polygon(points))
    trimesh = pytest.importorskip("trimesh")
    assert phrame.Path.of(trimesh.load_path(np.array(points))) == wanted
    pyvista = pytest.importorskip("pyvista")
    assert phrame.Path.of(pyvista.lines_from_points(np.array(points)).strip()).points([0, 1, 2, 3]).tolist() == points


def test_tables_give_columns_by_name():
    """x, y and z in another order; never transposed."""
    rows = {"z": [0.0, 1.0, 2.0], "x": [0.0, 2.0, 5.0], "y": [0.0, 1.0, -1.0]}
    wanted = phrame.Path.polyline([[0, 0, 0], [2, 1, 1], [5, -1, 2]])
    pandas = pytest.importorskip("pandas")
    assert phrame.Path.polyline(pandas.DataFrame(rows)) == wanted
    polars = pytest.importorskip("polars")
    assert phrame.Path.polyline(polars.DataFrame(rows)) == wanted
    arrow = pytest.importorskip("pyarrow")
    assert phrame.Path.polyline(arrow.table(rows)) == wanted
    xarray = pytest.importorskip("xarray")
    assert phrame.Path.polyline(xarray.Dataset({name: ("k", column) for name, column in rows.items()})) == wanted
    assert phrame.Path.polyline(xarray.DataArray([[0.0, 0, 0], [2, 1, 1], [5, -1, 2]], dims=("k", "c"))) == wanted
    by_label = xarray.DataArray([[0.0, 1, 2], [0, 2, 5], [0, 1, -1]], dims=("axis", "k"), coords={"axis": ["z", "x", "y"]})
    assert phrame.Path.polyline(by_label) == wanted == phrame.Path.polyline(by_label.T)


def test_curves_with_units_are_refused():
    pint = pytest.importorskip("pint")
    with pytest.raises((phrame.InputError, TypeError)):
        phrame.Path.polyline(np.array([[0.0, 0, 0], [1, 2, 3]]) * pint.UnitRegistry().mm)
    units = pytest.importorskip("astropy.units")
    with pytest.raises((phrame.InputError, TypeError)):
        phrame.Path.polyline(np.array([[0.0, 0, 0], [1, 2, 3]]) * units.mm)


def test_what_is_no_curve_of_another_package_is_refused():
    with pytest.raises(TypeError, match="a curve of one of scipy.interpolate, splipy, .* is wanted, not int"):
        phrame.Path.of(3)
