"""Writes programs/ and programs.json: curves in files that other programs wrote, with points of them by those programs.

python3 programs.py, with ezdxf, splipy, geomdl, scipy, trimesh, svgwrite, fullcontrol, mecode, cadquery-ocp, pandas, polars, pyarrow,
numpy; the tests do not run it. Each entry of programs.json has the file, what wrote it, how it is read (`pick`, `kind`), by which parameter
(`by`) the points are at the numbers `at`, the length where a program or a formula gives it, and, of files in few digits, `within` what.
"""

import importlib.metadata
import json
import math
import pathlib

import numpy as np

HERE = pathlib.Path(__file__).parent
OUT = HERE / "programs"
ENTRIES = []


def version(package):
    return f"{package} {importlib.metadata.version(package)}"


def entry(file, program, points=(), at=(), by="t", **more):
    """Points of one coordinate less than three lie in the plane z = 0."""
    space = [[float(x) for x in p] + [0.0] * (3 - len(p)) for p in points]
    ENTRIES.append({"file": file, "program": program, "by": by, "at": [float(x) for x in at], "points": space, **more})


def with_ezdxf():
    """One file of each release, a layer for each curve."""
    import ezdxf
    from ezdxf.math import BSpline, ConstructionArc, bulge_to_arc

    program = version("ezdxf")
    points = [(0, 0, 0), (1, 2, 0), (3, 0, 1), (4, 1, 2), (5, 5, 5), (7, 5, 4)]
    splines = {"spline": BSpline(points, order=4), "nurbs": BSpline(points, order=4, weights=[1, 2, 1, 0.5, 1, 1])}
    vertices = [(0, 0, 0.5), (4, 0, 0), (4, 3, -0.25), (0, 3, 0)]
    for release in ("R12", "R2000", "R2018"):
        name = f"ezdxf-{release}.dxf"
        drawing = ezdxf.new(release)
        space = drawing.modelspace()

        def layer(layer):
            return {"dxfattribs": {"layer": layer}}

        space.add_arc((1, 2, 3), 2.5, 30, 200, **layer("arc"))
        shares = [0, 0.25, 0.5, 1]
        arc = ConstructionArc((1, 2), 2.5, 30, 200)
        entry(name, program, [(*v, 3.0) for v in arc.vertices([30 + 170 * x for x in shares])], shares, "fraction", pick="arc",
              length=2.5 * math.radians(170))
        (space.add_polyline2d if release == "R12" else space.add_lwpolyline)(vertices, format="xyb", **layer("bulges"))
        length = 0
        for (x, y, bulge), (u, v, _) in zip(vertices, vertices[1:]):
            if bulge:
                _, a, b, r = bulge_to_arc((x, y), (u, v), bulge)
                length += r * ((b - a) % (2 * math.pi))
            else:
                length += math.hypot(u - x, v - y)
        entry(name, program, [(0, 0), (0, 3)], [0, 1], "fraction", pick="bulges", length=length)
        space.add_polyline3d(points, **layer("polyline"))
        entry(name, program, points, range(6), pick="polyline")
        space.add_line((0, 0), (10, 0), **layer("pipe"))
        space.add_line((15, 20), (15, 5), **layer("pipe"))
        space.add_circle((0.1, 0.2), 3, **layer("hole"))
        space.add_arc((10, 5), 5, -90, 0, **layer("pipe"))
        space.add_text("pipe")
        entry(name, program, [(0, 0), (15, 20)], [0, 1], "fraction", pick="pipe", length=25 + 2.5 * math.pi)
        entry(name, program, [(0.1 + 3 * math.cos(2 * math.pi * x), 0.2 + 3 * math.sin(2 * math.pi * x)) for x in (0, 0.3, 0.5)],
              [0, 0.3, 0.5], "fraction", pick="hole", length=6 * math.pi)
        if release != "R12":
            ellipse = space.add_ellipse((1, 1, 2), (4, 1, 0), 0.5, 0.3, 2.1, **layer("ellipse"))
            entry(name, program, [tuple(v) for v in ellipse.vertices([0.3, 2.1])], [0, 1], "fraction", pick="ellipse")
            for kind, spline in splines.items():
                space.add_spline(**layer(kind)).apply_construction_tool(spline)
                us = np.linspace(0, spline.max_t, 7)
                entry(name, program, [tuple(p) for p in spline.points(us)], us, "native", pick=kind)
        drawing.saveas(OUT / name)


def with_splipy():
    import splipy.curve_factory as factory
    from splipy import BSplineBasis
    from splipy.io import G2

    points = np.array([[0, 0, 0], [1, 2, 0], [3, 1, 1], [4, 4, 2], [5, 5, 5]], dtype=float)
    curves = {"circle": factory.circle(2), "segment": factory.circle_segment(1.2, 3), "line": factory.line((0, 0, 1), (2, 3, 5)),
              "cubic": factory.cubic_curve(points), "polygon": factory.n_gon(5, 2),
              "interpolated": factory.interpolate(points, BSplineBasis(4, [0, 0, 0, 0, 0.4, 1, 1, 1, 1]))}
    for name, curve in curves.items():
        if curve.periodic():
            curve = curve.split(curve.start(0))
        file = f"splipy-{name}.g2"
        with G2(str(OUT / file)) as out:
            out.write(curve)
        us = np.linspace(curve.start(0), curve.end(0), 7)
        entry(file, version("splipy"), [curve(float(u)) for u in us], us, "native")


def with_geomdl():
    from geomdl import BSpline, NURBS, exchange

    for name, kind in (("bspline", BSpline), ("nurbs", NURBS)):
        curve = kind.Curve()
        curve.degree = 3
        curve.ctrlpts = [[0, 0, 0], [1, 2, 0], [3, 0, 1], [4, 1, 2], [5, 5, 5]]
        if name == "nurbs":
            curve.weights = [1, 2, 1, 0.5, 1]
        curve.knotvector = [0, 0, 0, 0, 0.3, 1, 1, 1, 1]
        exchange.export_json(curve, str(OUT / f"geomdl-{name}.json"))
        us = [0, 0.15, 0.3, 0.7, 1]
        entry(f"geomdl-{name}.json", version("geomdl"), curve.evaluate_list(us), us, "native")


def with_scipy():
    from scipy.interpolate import CubicSpline, make_interp_spline, splev, splprep

    ts = np.linspace(0, 5, 9)
    points = np.transpose([np.cos(ts), np.sin(2 * ts), 0.3 * ts])
    spline = make_interp_spline(ts, points, k=5)
    us = np.linspace(0, 5, 7)
    (OUT / "scipy-bspline.json").write_text(json.dumps({"t": spline.t.tolist(), "c": spline.c.tolist(), "k": int(spline.k)}))
    entry("scipy-bspline.json", version("scipy"), spline(us), us, "native")
    cubic = CubicSpline(ts, points)
    (OUT / "scipy-cubic.json").write_text(json.dumps({"c": cubic.c.tolist(), "x": cubic.x.tolist()}))
    entry("scipy-cubic.json", version("scipy"), cubic(us), us, "native")
    ring = np.linspace(0, 2 * np.pi, 13)
    (t, c, k), _ = splprep([np.cos(ring), np.sin(ring), 0.1 * np.cos(3 * ring)], s=0, per=True)
    (OUT / "scipy-periodic.json").write_text(json.dumps([t.tolist(), [x.tolist() for x in c], int(k)]))
    us = [0, 0.2, 0.5, 0.9]
    entry("scipy-periodic.json", version("scipy"), np.transpose(splev(us, (t, c, k))), us, "native", closed=True)


def with_tables():
    import pandas
    import polars
    import pyarrow as arrow
    import pyarrow.csv

    rows = {"x": [0.0, 1.5, 3.25, 4.0], "y": [0.0, 2.0, 0.5, 1e-3], "z": [1.0, 1.0, 2.0, 5.0]}
    points = list(zip(*rows.values()))
    pandas.DataFrame(rows).to_csv(OUT / "pandas.csv")
    pandas.DataFrame(rows).to_csv(OUT / "pandas-decimal-commas.csv", sep=";", decimal=",", index=False)
    (OUT / "pandas-records.json").write_text(pandas.DataFrame(rows).to_json(orient="records"))
    (OUT / "pandas-values.json").write_text(pandas.DataFrame(rows).to_json(orient="values"))
    for name in ("pandas.csv", "pandas-decimal-commas.csv", "pandas-records.json", "pandas-values.json"):
        entry(name, version("pandas"), points, range(4), kind="polyline")
    polars.DataFrame(rows).write_csv(OUT / "polars.csv")
    entry("polars.csv", version("polars"), points, range(4), kind="polyline")
    (OUT / "polars.json").write_text(polars.DataFrame(rows).write_json())
    entry("polars.json", version("polars"), points, range(4), kind="polyline")
    arrow.csv.write_csv(arrow.table(rows), OUT / "pyarrow.csv")
    entry("pyarrow.csv", version("pyarrow"), points, range(4), kind="polyline")
    array = np.array(points)
    np.save(OUT / "numpy.npy", array)
    np.savetxt(OUT / "numpy.txt", array)
    np.savetxt(OUT / "numpy-header.csv", array, delimiter=",", header="x,y,z")
    for name in ("numpy.npy", "numpy.txt", "numpy-header.csv"):
        entry(name, version("numpy"), points, range(4), kind="polyline")


def with_svgwrite():
    import svgwrite

    def save(name, *shapes):
        drawing = svgwrite.Drawing(str(OUT / name))
        for make in shapes:
            drawing.add(make(drawing))
        drawing.save()

    program = version("svgwrite")
    save("svgwrite-rect.svg", lambda d: d.rect((1, 2), (10, 6), rx=2, ry=1))
    entry("svgwrite-rect.svg", program, [(3, 2), (9, 2)], [0, 1])
    save("svgwrite-circle.svg", lambda d: d.circle((1, 2), 3))
    entry("svgwrite-circle.svg", program, [(4, 2), (1, 5)], [0, 1], length=6 * math.pi)
    save("svgwrite-polygon.svg", lambda d: d.polygon([(0, 0), (4, 0), (4, 3)]))
    entry("svgwrite-polygon.svg", program, [(4, 0), (4, 3), (0, 0)], [1, 2, 3], length=12)
    save("svgwrite-path.svg", lambda d: d.path(d=["M", 0, 0, "C", 1, 0, 2, 1, 2, 2], transform="rotate(90) translate(1,0)"))
    entry("svgwrite-path.svg", program, [(0, 1), (-2, 3)], [0, 1])
    save("svgwrite-two.svg", lambda d: d.line((0, 0), (1, 1), id="a"), lambda d: d.ellipse((0, 0), (2, 1), id="b"))
    entry("svgwrite-two.svg", program, [(2, 0), (0, 1)], [0, 1], pick="b")


def with_trimesh():
    import trimesh

    points = np.array([[0, 0], [1, 2], [3, 0], [4, 1]], dtype=float)
    path = trimesh.load_path(points)
    for kind in ("dxf", "svg"):
        (OUT / f"trimesh.{kind}").write_text(path.export(file_type=kind))
        entry(f"trimesh.{kind}", version("trimesh"), points, range(4))


def with_fullcontrol():
    import fullcontrol as fc

    steps = fc.helixZ(fc.Point(x=0, y=0, z=0), 5, 5, 0, 2, 0.5, 32) + [fc.Point(x=8, y=3, z=1)]
    controls = fc.GcodeControls(printer_name="generic", save_as=None)
    (OUT / "fullcontrol.gcode").write_text(fc.transform(steps, "gcode", controls, show_tips=False))
    at = [0, 1, 7, 32]
    entry("fullcontrol.gcode", version("fullcontrol"), [[round(x, 6) for x in (steps[k].x, steps[k].y, steps[k].z)] for k in at], at)


def with_mecode():
    from mecode import G

    with G(outfile=str(OUT / "mecode.nc"), print_lines=False, aerotech_include=False, setup=False) as g:
        g.absolute()
        g.feed(10)
        g.abs_move(x=0, y=0, z=0)
        g.abs_move(x=10)
        g.abs_arc(x=20, y=10, radius=10, direction="CCW")
        g.abs_move(y=30)
    entry("mecode.nc", version("mecode"), [(0, 0), (10, 0), (20, 10), (20, 30)], [0, 1, 2, 3], length=30 + 5 * math.pi)


def with_three():
    """Of the files that programs.mjs writes."""
    for kind in ("glb", "gltf"):
        entry(f"three-camera.{kind}", "three.js r187", [(0, 0, 0), (1, 2, 0), (2, 1, 0.5), (4, 1, 2)], [0, 1, 1.75, 4], "native")


def with_opencascade():
    """STEP and IGES, which Open CASCADE reads back: points are those of the edges that it finds, of splines at
    their parameter, of lines and circles, along which the parameter is in proportion to the length, at shares of that.

    STEP has 13 digits and IGES 9, and places of arcs are those of angles to so many digits.
    """
    from OCP.BRepAdaptor import BRepAdaptor_Curve
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeWire
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder
    from OCP.GC import GC_MakeArcOfCircle, GC_MakeSegment
    from OCP.GCPnts import GCPnts_AbscissaPoint
    from OCP.GeomAbs import GeomAbs_BSplineCurve
    from OCP.Geom import Geom_BSplineCurve, Geom_Circle, Geom_Ellipse, Geom_Hyperbola, Geom_Parabola
    from OCP.IGESControl import IGESControl_Reader, IGESControl_Writer
    from OCP.STEPControl import STEPControl_AsIs, STEPControl_Reader, STEPControl_Writer
    from OCP.TopAbs import TopAbs_EDGE
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS
    from OCP.collections import Array1_double, Array1_gp_Pnt, Array1_int
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt, gp_Vec

    program = "Open CASCADE by " + version("cadquery-ocp")

    def array(values, kind):
        a = kind(1, len(values))
        for k, x in enumerate(values):
            a.SetValue(k + 1, x)
        return a

    def edge(*arguments):
        return BRepBuilderAPI_MakeEdge(*arguments).Edge()

    def wire(*edges):
        maker = BRepBuilderAPI_MakeWire()
        for e in edges:
            maker.Add(e)
        return maker.Wire()

    def point(*xyz):
        return gp_Pnt(*map(float, xyz))

    def spline(weights=None):
        poles = array([point(0, 0, 0), point(1, 2, 0), point(3, 2, 1), point(4, 0, 2), point(6, 1, 0.1)], Array1_gp_Pnt)
        knots, multiplicities = array([0.0, 0.3, 1.0], Array1_double), array([4, 1, 4], Array1_int)
        return Geom_BSplineCurve(poles, *([array(weights, Array1_double)] if weights else []), knots, multiplicities, 3)

    def read_back(reader, file, at, which):
        reader.ReadFile(str(OUT / file))
        reader.TransferRoots()
        explorer, curves, lengths = TopExp_Explorer(reader.OneShape(), TopAbs_EDGE), [], []
        while explorer.More():
            curves.append(BRepAdaptor_Curve(TopoDS.Edge(explorer.Current())))
            explorer.Next()
        curves = curves if which is None else [curves[which]]
        lengths = [GCPnts_AbscissaPoint.Length_s(c, 1e-14) for c in curves]
        points = []
        for x in at:
            left, k = x * sum(lengths), 0
            while k + 1 < len(curves) and left > lengths[k]:
                left, k = left - lengths[k], k + 1
            first, last = curves[k].FirstParameter(), curves[k].LastParameter()
            is_spline = curves[k].GetType() == GeomAbs_BSplineCurve
            p = curves[k].Value(x if is_spline else first + left / lengths[k] * (last - first))
            points.append((p.X(), p.Y(), p.Z()))
        return points, sum(lengths)

    tilted = gp_Ax2(point(1, 2, 3), gp_Dir(1, 2, 2), gp_Dir(0, 1, -1))
    shapes = {
        "pipe": wire(edge(GC_MakeSegment(point(0, 0, 0), point(0, 0, 10)).Value()),
                     edge(GC_MakeArcOfCircle(point(0, 0, 10), gp_Vec(0, 0, 1), point(3, 4, 15)).Value()),
                     edge(GC_MakeSegment(point(3, 4, 15), point(9, 12, 15)).Value())),
        "nurbs": edge(spline([1.0, 2.0, 1.5, 1.0, 1.0])),
        "part": edge(spline(), 0.2, 0.9),
        "arc": edge(Geom_Circle(tilted, 5.0), 0.3, 2.1),
        "large": edge(Geom_Circle(tilted, 5.0), 0.3, 5.1),
        "circle": edge(Geom_Circle(tilted, 5.0)),
        "ellipse": edge(Geom_Ellipse(tilted, 5.0, 2.0), 0.3, 2.1),
        "parabola": edge(Geom_Parabola(tilted, 2.0), -1.0, 5.0),
        "hyperbola": edge(Geom_Hyperbola(tilted, 3.0, 2.0), -1.0, 1.5),
        "cylinder": BRepPrimAPI_MakeCylinder(3.0, 10.0).Shape(),
    }
    ways = {"nurbs": ("native", [0, 0.125, 0.3, 0.875, 1]), "part": ("native", [0.2, 0.25, 0.3, 0.75, 0.9]), **{conic: ("fraction", [0, 1]) for conic in ("ellipse", "parabola", "hyperbola")}}
    for name, shape in shapes.items():
        by, at = ways.get(name, ("fraction", [0, 0.125, 0.4375, 0.875, 1]))
        step = STEPControl_Writer()
        step.Transfer(shape, STEPControl_AsIs)
        step.Write(str(OUT / f"occ-{name}.step"))
        for pick, which in {"cylinder": [("#55", 1)]}.get(name, [(None, None)]):
            points, length = read_back(STEPControl_Reader(), f"occ-{name}.step", at, which)
            entry(f"occ-{name}.step", program, points, at, by, length=length, within=1e-11, **({"pick": pick} if pick else {}))
        if name == "cylinder":
            continue
        iges = IGESControl_Writer()
        iges.AddShape(shape)
        iges.ComputeModel()
        iges.Write(str(OUT / f"occ-{name}.igs"))
        points, length = read_back(IGESControl_Reader(), f"occ-{name}.igs", at, None)
        entry(f"occ-{name}.igs", program, points, at, by, length=length, within=2e-8, gap="1e-7")


if __name__ == "__main__":
    OUT.mkdir(exist_ok=True)
    for make in (with_ezdxf, with_splipy, with_geomdl, with_scipy, with_tables, with_svgwrite, with_trimesh, with_fullcontrol, with_mecode, with_opencascade, with_three):
        make()
    (HERE / "programs.json").write_text("[\n" + ",\n".join(json.dumps(e) for e in ENTRIES) + "\n]\n")
