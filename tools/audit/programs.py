"""What other programs answer: a function for each, from the samples of a curve to its first normals f2, one a sample. A program that
takes points gets those of the table; one that takes a curve gets its control points, in doubles, as far as it has any.

Each is asked by what its documents recommend for the purpose (docs/audit.md).
"""
import contextlib
import importlib.metadata
import io
import math
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples/kit"))
import double_reflection


class NoAnswer(Exception):
    """The program has none for curves like this one."""


class Sampled:
    """A curve of the collection, and its table."""

    def __init__(self, curve, table):
        self.curve = curve
        self.t, self.points, self.tangents, self.start = table[:, 0], table[:, 1:4], table[:, 4:7], table[0, 7:10]

    def bezier(self):
        """(control points, weights or None) of a single polynomial or rational curve."""
        curve = self.curve
        if "control_points" in curve:
            weights = curve.get("weights")
            return (np.array([[float(Fraction(x)) for x in p] for p in curve["control_points"]]),
                    None if weights is None else np.array([float(Fraction(w)) for w in weights]))
        if "preimage" in curve:
            import foreign_frames
            return np.array([bernstein(c) for c in padded(foreign_frames.Segment(curve).lists)]).T, None
        if "position" in curve:
            import foreign_frames
            lists = padded([foreign_frames.power_basis(curve["position"].get(key, [int(key == "w")]), curve["basis"]) for key in "xyzw"])
            *columns, weights = (np.array(bernstein(c)) for c in lists)
            return np.array(columns).T / weights[:, None], weights if "w" in curve["position"] else None
        raise NoAnswer("not one Bézier curve")


def padded(lists):
    n = max(map(len, lists))
    return [list(c) + [Fraction(0)] * (n - len(c)) for c in lists]


def bernstein(c):
    n = len(c) - 1
    return [float(sum(Fraction(math.comb(k, i), math.comb(n, i)) * c[i] for i in range(k + 1))) for k in range(n + 1)]


def numpy_double_reflection(s):
    """Double reflection, as the paper of 2008 has it: examples/kit."""
    f2 = [list(s.start)]
    for k in range(1, len(s.t)):
        f2.append(double_reflection.next_normal(list(s.points[k - 1]), list(s.tangents[k - 1]), f2[-1], list(s.points[k]), list(s.tangents[k])))
    return f2


def vtk_tube_filter(s):
    """vtkTubeFilter of a polyline without normals: the first corner of the tube's cross-section at each point."""
    import vtk
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for p in s.points:
        points.InsertNextPoint(p)
    lines = vtk.vtkCellArray()
    lines.InsertNextCell(len(s.points))
    for k in range(len(s.points)):
        lines.InsertCellPoint(k)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    tube = vtk.vtkTubeFilter()
    tube.SetInputData(data)
    tube.SetRadius(1)
    tube.SetNumberOfSides(4)
    tube.SetCapping(False)
    tube.SetOutputPointsPrecision(vtk.vtkAlgorithm.DOUBLE_PRECISION)
    tube.Update()
    out = tube.GetOutput().GetPoints()
    if out is None or out.GetNumberOfPoints() != 4 * len(s.points):
        raise NoAnswer("the tube has not four points for each point of the line")
    return [np.array(out.GetPoint(4 * k)) - p for k, p in enumerate(s.points)]


def trimesh_sweep(s):
    """trimesh.creation.sweep_polygon: a corner of the polygon at each point."""
    import shapely
    import trimesh
    size = 1.0
    corners = [(size, 0), (0, size), (-size, 0), (0, -size)]
    mesh = trimesh.creation.sweep_polygon(shapely.Polygon(corners), s.points, cap=False, connect=False, kwargs={"process": False})
    rings = np.asarray(mesh.vertices)[:4 * len(s.points)].reshape(-1, 4, 3)
    return rings[:, 0] - s.points


def splipy_normal(s):
    """Curve.normal(), by which surface_factory.sweep() turns the shape."""
    import splipy
    points, weights = s.bezier()
    basis = splipy.BSplineBasis(len(points), [0] * len(points) + [1] * len(points))
    if weights is None:
        curve = splipy.Curve(basis, points)
    else:
        curve = splipy.Curve(basis, np.hstack([points * weights[:, None], weights[:, None]]), rational=True)
    return curve.normal(np.clip(s.t, 0, 1))


def occ_pipe(trihedron):
    def ask(s):
        from OCP.Geom import Geom_BezierCurve
        from OCP.GeomAdaptor import GeomAdaptor_Curve
        from OCP.gp import gp_Pnt, gp_Vec
        from OCP.collections import Array1_double, Array1_gp_Pnt
        import OCP.GeomFill as fill
        points, weights = s.bezier()
        poles = Array1_gp_Pnt(1, len(points))
        for k, p in enumerate(points):
            poles.SetValue(k + 1, gp_Pnt(*map(float, p)))
        if weights is None:
            curve = Geom_BezierCurve(poles)
        else:
            array = Array1_double(1, len(points))
            for k, w in enumerate(weights):
                array.SetValue(k + 1, float(w))
            curve = Geom_BezierCurve(poles, array)
        law = fill.GeomFill_CorrectedFrenet() if trihedron == "corrected-frenet" else fill.GeomFill_DiscreteTrihedron()
        law.SetCurve(GeomAdaptor_Curve(curve))  # which says whether it is the Frenet trihedron
        f2 = []
        for t in s.t:
            tangent, normal, binormal = gp_Vec(), gp_Vec(), gp_Vec()
            if not law.D0(float(min(max(t, 0), 1)), tangent, normal, binormal):
                raise NoAnswer("D0() says no at t = %s" % t)
            f2.append([normal.X(), normal.Y(), normal.Z()])
        return f2
    return ask


def blender_minimum(s):
    """A poly curve with twist_mode 'MINIMUM', the default, and a round bevel: the first corner of the tube at each point."""
    import bpy
    data = bpy.data.curves.new("c", "CURVE")
    data.dimensions, data.twist_mode, data.bevel_resolution, data.bevel_depth, data.use_fill_caps = "3D", "MINIMUM", 0, 1.0, False
    spline = data.splines.new("POLY")
    spline.points.add(len(s.points) - 1)
    for point, p in zip(spline.points, s.points):
        point.co = (*p, 1)
    thing = bpy.data.objects.new("o", data)
    mesh = thing.to_mesh()
    vertices = np.array([v.co[:] for v in mesh.vertices])
    thing.to_mesh_clear()
    bpy.data.objects.remove(thing)
    bpy.data.curves.remove(data)
    if len(vertices) % len(s.points) or len(vertices) == 0:
        raise NoAnswer("the tube has %d points for %d of the line" % (len(vertices), len(s.points)))
    return vertices.reshape(len(s.points), -1, 3)[:, 0] - s.points


PROGRAMS = {
    "double-reflection": (None, numpy_double_reflection),
    "vtk": ("vtk", vtk_tube_filter),
    "trimesh": ("trimesh", trimesh_sweep),
    "splipy": ("splipy", splipy_normal),
    "occ-corrected-frenet": ("cadquery-ocp", occ_pipe("corrected-frenet")),
    "occ-discrete": ("cadquery-ocp", occ_pipe("discrete")),
    "blender": ("bpy", blender_minimum),
}


def version_of(name):
    package = PROGRAMS[name][0]
    return "" if package is None else importlib.metadata.version(package)


def answer(name, sampled):
    """f2 at each sample. Throws NoAnswer."""
    try:
        with contextlib.redirect_stdout(io.StringIO()), np.errstate(all="ignore"):
            f2 = np.asarray(PROGRAMS[name][1](sampled), dtype=float)
    except NoAnswer:
        raise
    except Exception as error:
        raise NoAnswer("%s: %s" % (type(error).__name__, str(error).strip().splitlines()[:1])) from None
    if f2.shape != sampled.points.shape or not np.all(np.isfinite(f2)):
        raise NoAnswer("numbers that are none")
    return f2
