"""Everything public, with arguments that it takes; and what the stub, which is made of what there is, says that there is."""

import ast
import inspect
from importlib import import_module
from pathlib import Path as File

import sympy
from matplotlib.figure import Figure

import phrame
import phrame.dask
import phrame.spark
import phrame.sympy
from common import QUINTIC



class Rdd:
    """As much of an RDD of Spark as phrame.spark takes."""

    def __init__(self, *partitions):
        self.partitions = partitions

    def mapPartitions(self, of_partition):  # noqa: N802
        return [answer for part in self.partitions for answer in of_partition(iter(part))]


CUBIC = phrame.Curve.bezier([[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]])
PLANE_CUBIC = phrame.Curve([1], [0], [0], [0, 1])
CIRCLE = phrame.Path.polynomial([1, 0, -1], [0, 2], [], [1, 0, 1])
AXIS = [[0, 0, 1], ["3/2", 0, 1], [3, 1, 2]]
RING, OTHER_RING = (phrame.Path.expressions(*r, 0, "2*pi") for r in (("cos(s)", "sin(s)", "0"), ("1 + cos(s)", "0", "sin(s)")))
POSED = phrame.Path.through([[0, 0, 0], [1, 0, 0]], orientations=[[0, 0, 0, 1], [1, 0, 0, 5]])
THETA = QUINTIC.angle()
REAL = THETA.value(1)
POINTS = [[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2]]
LISTS = {name: [1, 2] for name in "uvpq"}
START = {"start": 0, "start_normal": None}
LIMITS = {"max_normal_acceleration": None, "max_tangential_acceleration": None, "start_speed": None, "end_speed": None}
ARRAY = {"ts": [0, 1], **START, "up": None, "kind": "rmf", "by": "t", "roll": None, "progress": None}
CHECK = {"ts": [0, 1], "f2": [[0, 1, 0], [0, 0, 1]], "f3": None, "tangents": None, "tolerance": 1, **START, "up": None}
CURVE = {"multiplier": None, "start": None, "name": "", "basis": "power"}
X = sympy.Symbol("x")
SPACE, PLANE = Figure().add_subplot(projection="3d"), Figure().add_subplot()
INTEGRAL = {"expr": 1 / X, "x": X, "principal_value": False, "style": "textbook", "form": "auto"}
CHOICE = {"kind": "cubic", "exact": False, "tolerance": None, "solution": 1, "select": None, "angles": None, "name": ""}
# The objects that a method is asked of, and arguments; those of START exclude each other.
API = {
    "Polynomial": (phrame.Polynomial, {"coefficients": [1]}),
    "Polynomial.__call__": (QUINTIC.sigma, {"t": 1}),
    "Polynomial.derivative": (QUINTIC.sigma.derivative, {}),
    "Polynomial.sympy": (QUINTIC.sigma.sympy, {"symbol": "t"}),
    "Polynomial.flint": (QUINTIC.sigma.flint, {}),
    "RationalFunction": (phrame.RationalFunction, {"numerator": [1], "denominator": [2, 1]}),
    "RationalFunction.__call__": (QUINTIC.torsion_function, {"t": 1}),
    "RationalFunction.sympy": (QUINTIC.torsion_function.sympy, {"symbol": "t"}),
    "Real.digits": (REAL.digits, {"n": 5}),
    "Real.ball": (REAL.ball, {"bits": 50}),
    "Real.mpmath": (REAL.mpmath, {"bits": 50}),
    "Real.sympy": (REAL.sympy, {"digits": 15}),
    "Real.flint": (REAL.flint, {"bits": 50}),
    "Real.arctan2": (REAL.arctan2, {"x": 2}),
    "Real.conjugate": (REAL.conjugate, {}),
    **{f"Real.{name}": (getattr(REAL / 2 if name == "arctanh" else 2 * REAL + 1 if name == "arccosh" else REAL, name), {})
       for name in ("sqrt", "exp", "expm1", "log", "log1p", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh",
                    "arcsinh", "arccosh", "arctanh")},
    "Path": (phrame.Path, {"curves": [QUINTIC], "name": ""}),
    "Path.json": (QUINTIC.json, {}),
    "Path.plot": (QUINTIC.plot, {"ts": [0, 1], "ax": SPACE, "kind": "rmf", "ribbon": 0.1, "f2": None, **START}),
    "Path.plot_offset": (PLANE_CUBIC.plot_offset, {"distance": 1, "join": "round", "trim": False, "ax": PLANE}),
    "Path.point": (QUINTIC.point, {"t": 1, "by": "t"}),
    "Path.nearest": (QUINTIC.nearest, {"point": [1, 2, 3]}),
    "Path.domain": (QUINTIC.domain, {"by": "t"}),
    "Path.curvature": (QUINTIC.curvature, {"t": 1, "by": "t"}),
    "Path.derivative": (QUINTIC.derivative, {"t": 1, "order": 2, "by": "t"}),
    "Path.arc_length": (QUINTIC.arc_length, {"t": 1, "by": "t"}),
    "Path.parameter_at": (QUINTIC.parameter_at, {"s": 1}),
    "Path.torsion": (QUINTIC.torsion, {"t": 1, "by": "t"}),
    "Path.frames": (QUINTIC.frames, ARRAY),
    "Path.quaternions": (QUINTIC.quaternions, ARRAY),
    "Path.matrices": (QUINTIC.matrices, ARRAY),
    "Path.points": (QUINTIC.points, {k: ARRAY[k] for k in ("ts", "by", "progress")}),
    "Path.read": (phrame.Path.read, {"file": "none", "near": None, "skip_invalid": False, "pick": ""}),
    "Path.from_json": (phrame.Path.from_json, {"text": QUINTIC.json(), "near": None, "skip_invalid": False, "pick": ""}),
    "Path.angle": (QUINTIC.angle, {"frame": "erf", **START, "form": "auto", "up": None}),
    "Path.classify": (QUINTIC.classify, {}),
    "Path.minimal_twist": (QUINTIC.minimal_twist, {"start": 0, "end": 0, "extra_turns": 0, "up": None}),
    "Path.check": (QUINTIC.check, CHECK),
    "Path.interpolate": (QUINTIC.interpolate, {"feed": 1, "period": 1, **LIMITS}),
    "Path.offset": (PLANE_CUBIC.offset, {"distance": 1, "join": "round", "trim": False, "pocket": False, "gauge": None}),
    "Path.near_ph": (PLANE_CUBIC.near_ph, {"epsilon": 1}),
    "Path.check_offset": (PLANE_CUBIC.check_offset, {"given": PLANE_CUBIC.offset(1)[0], "distance": 1, "join": "round", "trim": False, "tolerance": 1}),
    **{f"Offset.{name}": (getattr(PLANE_CUBIC.offset(1), name), {}) for name in ("text", "latex", "json", "outlines", "marks")},
    "Offset.plot": (PLANE_CUBIC.offset(1).plot, {"ax": PLANE}),
    **{f"OffsetCheck.{name}": (getattr(PLANE_CUBIC.check_offset(PLANE_CUBIC.offset(1)[0], 1), name), {}) for name in ("text", "json")},
    "Gauge.of": (phrame.Gauge.of, {"path": CIRCLE}),
    **{f"Envelope.{name}": (getattr(phrame.envelope(AXIS), name), {}) for name in ("text", "latex", "json", "outlines")},
    "Envelope.plot": (phrame.envelope(AXIS).plot, {"ax": PLANE}),
    "Path.compile": (QUINTIC.compile, {"prefix": None, "frame": "erf", **START, "lower": 0, "upper": 1, "up": None}),
    "Path.page": (QUINTIC.page, {"file": "", "ts": None, "f2": None, "samples": 3, **START, "up": None}),
    "Path.from_preimage": (phrame.Path.from_preimage, {**LISTS, **CURVE}),
    "Path.segment": (QUINTIC.segment, {"a": 0, "b": 1}),
    "Path.reversed": (QUINTIC.reversed, {}),
    "Path.whole_line": (CIRCLE.whole_line, {}),
    "Path.translated": (QUINTIC.translated, {"v": [1, 2, 3]}),
    "Path.scaled": (QUINTIC.scaled, {"c": 1}),
    "Path.rotated": (QUINTIC.rotated, {"u": [1, 2, 3, 4]}),
    "Path.transformed": (QUINTIC.transformed, {"matrix": [[1, 2, 3], [0, 1, 0], [0, 0, 1]]}),
    "Path.split": (QUINTIC.split, {"ts": ["1/3"], "by": "t"}),
    "Path.from_quaternions": (phrame.Curve.from_quaternions, {"quaternions": [[1, 2, 3, 4]], **CURVE}),
    "Path.from_hopf": (phrame.Curve.from_hopf, {"alpha": [1j], "beta": [(1, 2)], **CURVE}),
    "Path.from_complex": (phrame.Path.from_complex, {"w": [1, 1j], **CURVE}),
    "Path.from_control_points": (phrame.Curve.from_control_points, {"points": QUINTIC.control_points, "name": ""}),
    "Path.helicity": (RING.helicity, {"about": [1, 1, 5]}),
    "Path.linking_number": (RING.linking_number, {"other": OTHER_RING}),
    "Path.of": (phrame.Path.of, {"curve": ([0, 0, 1, 1], [[0, 1], [0, 2], [0, 2]], 1)}),
    "Path.polyline": (phrame.Path.polyline, {"points": POINTS, "closed": False, "name": ""}),
    "Path.from_scipy": (phrame.Path.from_scipy, {"curve": ([0, 0, 1, 1], [[0, 1], [0, 2], [0, 2]], 1)}),
    "Path.near": (phrame.Curve.near, {"points": QUINTIC.control_points, "eps": 1, "name": ""}),
    "Path.hermite": (phrame.Curve.hermite, {"p0": [0, 0, 0], "d0": [1, 0, 0], "p1": [1, 1, 1], "d1": [0, 1, 1],
                                             "a0": None, "a1": None, **CHOICE, "length": None}),
    "Path.through": (phrame.Curve.through, {
        "points": [[0, 0, 0], [1, 1, 1]], "derivatives": None, "tangents": None, "accelerations": None,
        "parameters": None, "closed": False, **CHOICE, "orientations": None, "tangent_axis": "x", "smooth_twist": False, "turns": None,
        "lengths": None}),
    "Path.bezier": (phrame.Curve.bezier, {"points": POINTS, "weights": None, "name": ""}),
    "Path.nurbs": (phrame.Curve.nurbs, {"points": POINTS, "weights": None, "knots": None, "degree": 2, "name": ""}),
    "Path.polynomial": (phrame.Curve.polynomial, {"x": [0, 1], "y": [0, 0, 1], "z": [0, 1, 1], "w": None, "name": "", "basis": "power"}),
    "Path.expressions": (phrame.Curve.expressions, {
        "x": "s", "y": "s^2", "z": "s^3", "lower": 0, "upper": 1, "variable": None, "name": ""}),
    "Path.cubic_spline": (phrame.Curve.cubic_spline, {
        "points": POINTS, "parameters": None, "ends": "natural", "spacing": "uniform", "start_derivative": None,
        "end_derivative": None, "name": ""}),
    "Path.certify": (QUINTIC.certify, {"at": [1], "digits": 10, "frame": "erf", "up": None, "length": False, "holonomy": False, "writhe": False}),
    "Angle.value": (THETA.value, {"t": 1, "digits": None}),
    "Angle.digits": (THETA.digits, {"t": 1, "n": 5}),
    "Angle.__call__": (THETA, {"ts": [0], "by": "t", "progress": None}),
    "Angle.rate": (THETA.rate, {"segment": 0}),
    "Angle.poles": (THETA.poles, {"segment": 0}),
    "Angle.text": (THETA.text, {"style": "logarithms"}),
    "Angle.latex": (THETA.latex, {"style": "logarithms"}),
    "Angle.json": (THETA.json, {"style": "logarithms"}),
    "Angle.sympy": (THETA.sympy, {"symbol": None, "style": "textbook"}),
    "Angle.plot": (THETA.plot, {"ts": [0, 1], "ax": PLANE}),
    "Integral.value": (phrame.integrate("x", 0, 1).value, {"digits": None}),
    "Integral.poles": (phrame.integrate("x").poles, {}),
    "Integral.text": (phrame.integrate("x").text, {}),
    "Integral.latex": (phrame.integrate("x").latex, {}),
    "Integral.json": (phrame.integrate("x").json, {}),
    "Integral.sympy": (phrame.integrate("x").sympy, {"symbol": None}),
    "Classification.text": (QUINTIC.classify().text, {}),
    "Classification.latex": (QUINTIC.classify().latex, {}),
    "Classification.json": (QUINTIC.classify().json, {}),
    "MinimalTwist.rational": (QUINTIC.minimal_twist(0, 1).rational, {"degree": 2, "free_ends": False, "subdivide": (),
                                                                     "gamma": None, "proved": False}),
    "MinimalTwist.frames": (QUINTIC.minimal_twist(0, 1).frames, {"ts": [0], "progress": None}),
    "Path.twist": (POSED.twist, {"up": None}),
    "PathTwist.frames": (POSED.twist().frames, {"ts": [0], "progress": None}),
    "PathTwist.rate": (POSED.twist().rate, {"t": 1}),
    "RationalTwist.value": (QUINTIC.minimal_twist(0, 1).rational(proved=False).value, {"t": 1, "digits": None}),
    "RationalTwist.digits": (QUINTIC.minimal_twist(0, 1).rational(proved=False).digits, {"t": 1, "n": 5}),
    "MinimalTwist.digits": (QUINTIC.minimal_twist(0, 1).digits, {"t": 1, "n": 5}),
    "MinimalTwist.value": (QUINTIC.minimal_twist(0, 1).value, {"t": 1, "digits": None}),
    "CheckResult.text": (QUINTIC.check([0], [[0, 0, 1]]).text, {}),
    "CheckResult.json": (QUINTIC.check([0], [[0, 0, 1]]).json, {}),
    "Certificate.from_json": (phrame.Certificate.from_json, {"text": QUINTIC.certify(digits=5).json()}),
    "Certificate.json": (QUINTIC.certify(digits=5).json, {}),
    "Certificate.objections": (QUINTIC.certify(digits=5).objections, {}),
    "Certificate.is_proved": (QUINTIC.certify(digits=5).is_proved, {}),
    "SweptBody.volume": (phrame.sweep(QUINTIC, "polygon:3,1/9", sections=3).volume, {}),
    "SweptBody.save": (phrame.sweep(QUINTIC, "polygon:3,1/9", sections=3).save, {"file": ""}),
    "SweptBody.plot": (phrame.sweep(QUINTIC, "polygon:3,1/9", sections=3).plot, {"ax": SPACE}),
    "digits": (phrame.digits, {"x": REAL, "n": 5}),
    "root": (phrame.root, {"polynomial": [-2, 0, 1], "lower": 1, "upper": 2}),
    "read": (phrame.read, {"file": "none", "near": None, "skip_invalid": False, "pick": ""}),
    "parse": (phrame.parse, {"text": QUINTIC.json(), "near": None, "skip_invalid": False, "pick": ""}),
    "integrate": (phrame.integrate, {"f": "1/x", "lower": 1, "upper": 2, "variable": None, "principal_value": False,
                                     "style": "textbook", "form": "auto"}),
    "envelope": (phrame.envelope, {"axis": AXIS, "trim": False}),
    "ask": (phrame.ask, {"question": "info", "path": QUINTIC}),
    "sweep": (phrame.sweep, {"path": QUINTIC, "profile": "polygon:3,1/9", **START, "end_normal": None, "twist": 0,
                             "scale": 1, "roll": None, "tolerance": None, "normal_tolerance": None, "sections": 3,
                             "origin": None}),
    "map": (phrame.map, {"curves": [QUINTIC], "question": lambda curve: 0, "threads": None, "errors": "raise"}),
    "set_threads": (phrame.set_threads, {"n": None}),
    "set_time_limit": (phrame.set_time_limit, {"seconds": None}),
    "sympy.integrate": (phrame.sympy.integrate, INTEGRAL),
    "sympy.integral": (phrame.sympy.integral, INTEGRAL),
    "sympy.rational_function": (phrame.sympy.rational_function, {"expr": X, "x": X}),
    "dask.map": (phrame.dask.map, {"curves": [QUINTIC], "question": lambda curve: 0, "partitions": None, "errors": "raise", "column": "curve"}),
    **{f"dask.{name}": (getattr(phrame.dask, name), {"path": QUINTIC, "ts": [0, 1]})
       for name in ("frames", "quaternions", "matrices", "points")},
    "dask.angles": (phrame.dask.angles, {"angle": THETA, "ts": [0, 1]}),
    "spark.map": (phrame.spark.map, {"curves": Rdd([QUINTIC]), "question": lambda curve: 0, "errors": "raise", "column": "curve",
                              "returns": "answer string"}),
}
# The same methods of a path and of an angle that are not PH.
OF_ANY_KIND = {
    "Path.segment": (CUBIC.segment, {"a": 0, "b": 1}),
    "Path.reversed": (CUBIC.reversed, {}),
    "Path.translated": (CUBIC.translated, {"v": [1, 2, 3]}),
    "Path.scaled": (CUBIC.scaled, {"c": 1}),
    "Path.rotated": (CUBIC.rotated, {"u": [1, 2, 3, 4]}),
    "Path": (phrame.Path, {"curves": [CUBIC], "name": ""}),
    "Path.curvature": (CUBIC.curvature, {"t": 1, "by": "t"}),
    "Path.derivative": (CUBIC.derivative, {"t": 1, "order": 2, "by": "t"}),
    "Path.transformed": (CUBIC.transformed, {"matrix": [[1, 2, 3], [0, 1, 0], [0, 0, 1]]}),
    "Path.split": (CUBIC.split, {"ts": ["1/3"], "by": "t"}),
    "Path.torsion": (CUBIC.torsion, {"t": 1, "by": "t"}),
    "Path.arc_length": (CUBIC.arc_length, {"t": 1, "by": "t"}),
    "Path.parameter_at": (CUBIC.parameter_at, {"s": 1}),
    "Path.point": (CUBIC.point, {"t": 1, "by": "t"}),
    "Path.plot": (CUBIC.plot, {"ts": [0, 1], "ax": SPACE, "kind": "rmf", "ribbon": 0.1, "f2": None, **START}),
    "Path.frames": (CUBIC.frames, ARRAY),
    "Path.quaternions": (CUBIC.quaternions, ARRAY),
    "Path.matrices": (CUBIC.matrices, ARRAY),
    "Path.points": (CUBIC.points, {k: ARRAY[k] for k in ("ts", "by", "progress")}),
    "Path.angle": (CUBIC.angle, {"frame": "up", **START, "form": "auto", "up": None}),
    "Path.check": (CUBIC.check, CHECK),
    "Path.minimal_twist": (CUBIC.minimal_twist, {"start": 0, "end": 0, "extra_turns": 0, "up": None}),
    "Path.interpolate": (CUBIC.interpolate, {"feed": 1, "period": 1, **LIMITS}),
    "Path.compile": (CUBIC.compile, {"prefix": None, "frame": "up", **START, "lower": 0, "upper": 1, "up": None}),
    "Path.page": (CUBIC.page, {"file": "", "ts": None, "f2": None, "samples": 3, **START, "up": None}),
    "Angle.value": (CUBIC.angle().value, {"t": 1, "digits": None}),
    "Angle.digits": (CUBIC.angle().digits, {"t": 1, "n": 5}),
    "Angle.__call__": (CUBIC.angle(), {"ts": [0], "by": "t", "progress": None}),
    "Angle.text": (CUBIC.angle().text, {"style": "logarithms"}),
    "Angle.latex": (CUBIC.angle().latex, {"style": "logarithms"}),
    "Angle.json": (CUBIC.angle().json, {"style": "logarithms"}),
    "Angle.plot": (CUBIC.angle().plot, {"ts": [0, 1], "ax": PLANE}),
}
ALL = {**API, **{f"{name} of any kind": call for name, call in OF_ANY_KIND.items()}}



def public_functions():
    """The names of arguments of each: of the stub, and of what is written in Python."""
    tree = ast.parse(File(phrame._phrame.__file__).with_name("_phrame.pyi").read_text(encoding="utf-8"))
    functions = {}
    for node in tree.body:
        parts = node.body if isinstance(node, ast.ClassDef) else [node]
        for f in parts:
            if not isinstance(f, ast.FunctionDef) or any(getattr(d, "id", "") == "property" for d in f.decorator_list):
                continue
            name = f"{node.name}.{f.name}" if isinstance(node, ast.ClassDef) else f.name
            name = name.replace(".__init__", "")
            if f.name not in ("__init__", "__call__") and f.name.startswith("_"):
                continue
            functions.setdefault(name, {a.arg for a in f.args.args + f.args.kwonlyargs} - {"self"})  # of the first overload
    for name in ("set_threads", "set_time_limit", "map", "ask"):
        functions[name] = set(inspect.signature(getattr(phrame, name)).parameters) - {"options"}
    for module in phrame._BRIDGES:
        for name in import_module(f"phrame.{module}").__all__:
            signature = inspect.signature(getattr(getattr(phrame, module), name))
            functions[f"{module}.{name}"] = set(signature.parameters) - {"options"}
    return functions
