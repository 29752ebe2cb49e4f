"""Curves of other packages as paths, exactly: of each the numbers that it holds, which are doubles."""

from __future__ import annotations

import io
import json
from importlib import import_module
from typing import Any, Callable, Dict

from ._convert import scipy_text
from ._errors import InputError


def _refuse(curve: Any, reason: str) -> InputError:
    return InputError(f"curve: {reason}", "curve", reason, curve)


def _nurbs(points: Any, weights: Any, knots: Any, degree: int, name: str = "") -> Any:
    from ._phrame import Path

    return Path.nurbs(_in_space(points), None if weights is None or len(weights) == 0 else list(weights), list(knots), int(degree), name=name)


def _in_space(points: Any) -> Any:
    """Points with a third coordinate, 0 in the plane."""
    return [[*map(float, point), *([0.0] * (3 - len(point)))] for point in points]


def _polyline(curve: Any, points: Any) -> Any:
    from ._phrame import Path

    found = _in_space(points)
    found = [p for k, p in enumerate(found) if k == 0 or p != found[k - 1]]
    if len(found) < 2:
        raise _refuse(curve, "it has less than two points")
    return Path.polyline(found)


def _of_splipy(curve: Any) -> Any:
    """Control points of rational ones are multiplied by their weights; a periodic one is cut at its start."""
    if curve.periodic():
        curve = curve.split(curve.start(0))
    points = curve.controlpoints
    weights = None
    if curve.rational:
        weights = points[:, -1]
        points = [[_quotient(x, w) for x in row[:-1]] for row, w in zip(points, weights)]
        return _rational(points, weights, curve.bases[0].knots, curve.order(0) - 1)
    return _nurbs(points, weights, curve.bases[0].knots, curve.order(0) - 1)


def _quotient(x: Any, w: Any) -> Any:
    from fractions import Fraction

    return Fraction(float(x)) / Fraction(float(w))


def _rational(points: Any, weights: Any, knots: Any, degree: int) -> Any:
    from ._phrame import Path

    in_space = [[*point, *([0] * (3 - len(point)))] for point in points]
    return Path.nurbs(in_space, [float(w) for w in weights], [float(u) for u in knots], int(degree))


def _of_geomdl(curve: Any) -> Any:
    if not all(hasattr(curve, name) for name in ("degree", "ctrlpts", "knotvector")) or isinstance(curve.degree, (list, tuple)):
        raise _refuse(curve, f"a {type(curve).__name__} of geomdl is no curve")
    return _nurbs(curve.ctrlpts, getattr(curve, "weights", None), curve.knotvector, curve.degree, curve.name or "")


def _of_rhino3dm(curve: Any) -> Any:
    """Points of openNURBS are multiplied by their weights, and knots lack the outermost two."""
    if not hasattr(curve, "Points"):
        if not hasattr(curve, "ToNurbsCurve"):
            raise _refuse(curve, f"a {type(curve).__name__} of rhino3dm is no curve")
        curve = curve.ToNurbsCurve()
    points = [curve.Points[k] for k in range(len(curve.Points))]
    weights = [p.W for p in points] if curve.IsRational else None
    if weights is None:
        return _nurbs([[p.X, p.Y, p.Z] for p in points], None, [curve.Knots[k] for k in range(len(curve.Knots))], curve.Degree)
    return _rational([[_quotient(x, p.W) for x in (p.X, p.Y, p.Z)] for p in points], weights,
                     [curve.Knots[k] for k in range(len(curve.Knots))], curve.Degree)


def _of_ezdxf(curve: Any) -> Any:
    """A BSpline, an entity SPLINE, or others, as the file that has only them."""
    if hasattr(curve, "construction_tool") and curve.dxftype() == "SPLINE":
        curve = curve.construction_tool()
    if hasattr(curve, "control_points") and hasattr(curve, "knots"):
        return _nurbs(curve.control_points, curve.weights(), curve.knots(), curve.degree)
    if not hasattr(curve, "dxftype"):
        raise _refuse(curve, f"a {type(curve).__name__} of ezdxf is no curve")
    from ._phrame import parse

    drawing = import_module("ezdxf").new("R2010")
    drawing.modelspace().add_foreign_entity(curve)
    file = io.StringIO()
    drawing.write(file)
    return parse(file.getvalue())


def _of_shapely(curve: Any) -> Any:
    if curve.geom_type not in ("LineString", "LinearRing"):
        raise _refuse(curve, f"a {curve.geom_type} is no curve: a LineString or LinearRing is")
    return _polyline(curve, curve.coords)


def _of_trimesh(curve: Any) -> Any:
    paths = getattr(curve, "discrete", None)
    if paths is None:
        raise _refuse(curve, f"a {type(curve).__name__} of trimesh is no path")
    if len(paths) == 0 and len(curve.entities) == 1:  # without networkx, which finds what joins
        paths = [curve.entities[0].discrete(curve.vertices)]
    if len(paths) != 1:
        raise _refuse(curve, f"it has {len(paths)} paths; one is wanted, of split()")
    return _polyline(curve, paths[0])


def _of_pyvista(curve: Any) -> Any:
    lines = list(getattr(curve, "lines", []))
    if not lines or lines[0] + 1 != len(lines):
        raise _refuse(curve, "one polyline is wanted in it, in `lines`")
    return _polyline(curve, [curve.points[k] for k in lines[1:]])


def _of_occt(curve: Any) -> Any:
    """An edge or a wire of Open CASCADE, as cadquery and build123d have them: of each edge the B-spline that Open CASCADE
    makes of it, in its place and sense. Ends that are apart by rounding are joined, as those of files."""
    from ._phrame import parse

    shape = getattr(curve, "wrapped", curve)
    kind = str(getattr(shape, "ShapeType", lambda: None)()).rpartition(".")[2]
    if kind not in ("TopAbs_EDGE", "TopAbs_WIRE"):
        raise _refuse(curve, f"a {type(curve).__name__} is no curve: an edge or a wire is")
    edges = [shape]
    if kind == "TopAbs_WIRE":
        wire = _occt("TopoDS", "TopoDS", "Wire")(shape)
        explorer, edges = import_module("OCP.BRepTools").BRepTools_WireExplorer(wire), []
        while explorer.More():
            edges.append(explorer.Current())
            explorer.Next()
    if not edges:
        raise _refuse(curve, "the wire has no edges")
    return parse(json.dumps({"phrame": "spline/1", "segments": [_nurbs_of_edge(curve, edge) for edge in edges]}))


def _occt(module: str, kind: str, name: str) -> Any:
    """A static function, whose name ends with _s before release 8."""
    found = getattr(import_module("OCP." + module), kind)
    return getattr(found, name + "_s", None) or getattr(found, name)


def _nurbs_of_edge(curve: Any, edge: Any) -> Dict[str, Any]:
    edge = _occt("TopoDS", "TopoDS", "Edge")(edge)
    if _occt("BRep", "BRep_Tool", "Degenerated")(edge):
        raise _refuse(curve, "an edge of it is a point")
    adaptor = import_module("OCP.BRepAdaptor").BRepAdaptor_Curve(edge)
    trimmed = import_module("OCP.Geom").Geom_TrimmedCurve(adaptor.Curve().Curve(), adaptor.FirstParameter(), adaptor.LastParameter())
    spline = _occt("GeomConvert", "GeomConvert", "CurveToBSplineCurve")(trimmed)
    spline.Transform(adaptor.Trsf())
    if spline.IsPeriodic():
        spline.SetNotPeriodic()
    if edge.Orientation() == import_module("OCP.TopAbs").TopAbs_Orientation.TopAbs_REVERSED:
        spline.Reverse()
    points = [spline.Pole(k) for k in range(1, spline.NbPoles() + 1)]
    segment: Dict[str, Any] = {
        "phrame": "nurbs/1" if spline.IsRational() else "bspline/1",
        "degree": spline.Degree(),
        "knots": [float(spline.Knot(k)).hex() for k in range(1, spline.NbKnots() + 1)],
        "multiplicities": [spline.Multiplicity(k) for k in range(1, spline.NbKnots() + 1)],
        "control_points": [[float(x).hex() for x in (p.X(), p.Y(), p.Z())] for p in points],
    }
    if spline.IsRational():
        segment["weights"] = [float(spline.Weight(k)).hex() for k in range(1, spline.NbPoles() + 1)]
    return segment


_PACKAGES: Dict[str, Callable[[Any], Any]] = {
    "splipy": _of_splipy,
    "geomdl": _of_geomdl,
    "rhino3dm": _of_rhino3dm,
    "ezdxf": _of_ezdxf,
    "shapely": _of_shapely,
    "trimesh": _of_trimesh,
    "pyvista": _of_pyvista,
    "OCP": _of_occt,
    "cadquery": _of_occt,
    "build123d": _of_occt,
}


def path(curve: Any) -> Any:
    """The path that an object of another package is."""
    from ._phrame import parse

    for base in type(curve).__mro__:
        make = _PACKAGES.get(base.__module__.partition(".")[0])
        if make is not None:
            return make(curve)
    if isinstance(curve, (list, tuple)) or all(hasattr(curve, name) for name in ("t", "c", "k")) or all(
            hasattr(curve, name) for name in ("c", "x")):
        return parse(scipy_text(curve))
    known = ", ".join(["scipy.interpolate", *_PACKAGES])
    raise TypeError(f"curve: a curve of one of {known} is wanted, not {type(curve).__name__}; points are for Path.cubic_spline, "
                    "Path.polyline and Path.through")
