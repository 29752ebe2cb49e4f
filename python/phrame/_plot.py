"""Pictures by Matplotlib, which is imported when one is asked for."""

from __future__ import annotations

import base64
import io
import sys
from fractions import Fraction
from importlib.util import find_spec
from typing import Any, Callable, Dict

import numpy as np

from . import _numbers
from ._errors import InputError
from ._phrame import Polynomial

_EXACTLY = Polynomial([0, 1])  # the number that is meant by "1/3", too
_SAMPLES = 96  # of a segment: enough for the eye


def _new_axes(**options: Any) -> Any:
    try:
        from matplotlib import pyplot
        from mpl_toolkits import mplot3d  # noqa: F401  (it makes the projection known)
    except ImportError as error:
        raise ImportError("plot() needs Matplotlib: pip install matplotlib") from error
    return pyplot.figure().add_subplot(**options)


def _parameters(path: Any, ts: Any) -> Any:
    return np.linspace(0.0, float(path.end), _SAMPLES * path.end + 1) if ts is None else ts


def _require_axes(ax: Any, method: str) -> None:
    if ax is not None and not hasattr(ax, method):
        raise TypeError(f"ax: {'axes in 3D' if method != 'plot' else 'axes'} of Matplotlib are wanted, not {type(ax).__name__}")


def _in_grey(ax: Any, style: Dict[str, Any]) -> Dict[str, Any]:
    """The style, with another line than those that are there: print is often grey."""
    return style if {"linestyle", "ls"} & set(style) else {**style, "linestyle": ("-", "--", "-.", ":")[len(ax.lines) % 4]}


def _width(ribbon: Any) -> float:
    if isinstance(ribbon, (bool, str)) or not hasattr(ribbon, "__float__") or np.ndim(ribbon):
        raise TypeError(f"ribbon: a number is wanted, not {type(ribbon).__name__}")
    try:
        width = float(ribbon)
    except OverflowError:
        width = np.inf
    if not 0 <= width < np.inf:
        raise InputError("ribbon: it is not a finite number >= 0", "ribbon", "it is not a finite number >= 0", ribbon)
    return width


def _normals(f2: Any, n: int) -> Any:
    """Somebody's vectors, as many as there are parameters."""
    rows = _numbers.rows(f2, "f2", ("x", "y", "z"))
    try:
        found = np.asarray(rows, dtype=float)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"f2: vectors are wanted, not {type(f2).__name__}") from None
    if found.shape != (n, 3) or not np.isfinite(found).all():
        reason = f"{n} finite vectors are wanted, its shape is {found.shape}"
        raise InputError(f"f2: {reason}", "f2", reason, f2)
    return found


def _add_ribbon(ax: Any, points: Any, normals: Any, width: float, color: Any) -> None:
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    near, far = points - width / 2 * normals, points + width / 2 * normals
    strips = np.stack([near[:-1], near[1:], far[1:], far[:-1]], axis=1)
    ax.add_collection3d(Poly3DCollection(strips, facecolor=color, alpha=0.35))


def _equalize(ax: Any, low: Any, high: Any) -> None:
    """A box in which lengths are the same in all directions; no side of it is 0."""
    from matplotlib.ticker import MaxNLocator

    least = max(float((high - low).max()), 1e-300) / 10
    margin = np.maximum(least - (high - low), 0) / 2
    low, high = low - margin, high + margin
    sides = high - low
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set_box_aspect(tuple(sides))
    for axis, side in zip((ax.xaxis, ax.yaxis, ax.zaxis), sides / sides.max()):
        axis.set_major_locator(MaxNLocator(max(1, round(5 * side)), steps=[1, 2, 2.5, 5, 10]))  # numbers along a short side have no room


def path(
    self: Any,
    ts: Any = None,
    *,
    ax: Any = None,
    kind: str = "rmf",
    ribbon: Any = None,
    start: Any = None,
    start_normal: Any = None,
    f2: Any = None,
    **style: Any,
) -> Any:
    """Path.plot"""
    _require_axes(ax, "add_collection3d")
    at = _parameters(self, ts)
    points = self.points(at)
    given = None if f2 is None else _normals(f2, len(points))
    low, high = points.min(axis=0), points.max(axis=0)
    width = float(np.linalg.norm(high - low)) / 10 if ribbon is None else _width(ribbon)
    normals = self.frames(at, kind=kind, start=start, start_normal=start_normal)[:, 1] if width and given is None else given
    if ax is None:
        ax = _new_axes(projection="3d", xlabel="x", ylabel="y", zlabel="z")
    (line,) = ax.plot(*points.T, **_in_grey(ax, style))
    if width:
        _add_ribbon(ax, points, normals, width, line.get_color())
    _equalize(ax, low - width / 2, high + width / 2)
    return ax


def _outline(path: Any) -> Any:
    """x and y of its points, the nearer to each other in t the faster it moves there: no step is a noticeable part of the whole."""
    ts = _parameters(path, None)
    for _ in range(8):
        points = path.points(ts)[:, :2]
        steps = np.hypot(*np.diff(points, axis=0).T)
        long = np.flatnonzero(steps > np.ptp(points, axis=0).max() / 150)
        if not len(long):
            break
        ts = np.insert(ts, long + 1, (ts[long] + ts[long + 1]) / 2)
    return path.points(ts).T[:2]


def outlines(self: Any) -> Any:
    """Offset.outlines, Envelope.outlines"""
    return tuple(_outline(path).T for path in self.paths)


def _cuts(branches: Any) -> Any:
    """Where parts end but not at a joint of the path, once where two do."""
    points = [
        point
        for branch in branches
        for part in branch.parts
        for t, point in ((part.start, part.start_point), (part.end, part.end_point))
        if not isinstance(t, Fraction) or t.denominator != 1
    ]
    return list(dict.fromkeys(points))


def marks(self: Any) -> Any:
    """Offset.marks"""
    found = {
        "cusps": [cusp.point for cusp in self.cusps],
        "self_intersections": [meeting.point for meeting in self.self_intersections],
        "cuts": _cuts(self.branches),
    }
    return {name: np.array(points, dtype=float).reshape(-1, 2) for name, points in found.items()}


def _plane_axes(ax: Any, *paths: Any) -> Any:
    _require_axes(ax, "plot")
    if ax is None:
        ax = _new_axes(xlabel="x", ylabel="y", aspect="equal")
        for path in paths:
            ax.plot(*_outline(path), color="0.6")
    return ax


def _draw(found: Any, ax: Any, style: Dict[str, Any]) -> Dict[str, Any]:
    """All paths of an offset or an envelope, alike; how they are drawn."""
    drawn = dict(style)
    for points in outlines(found):
        (line,) = ax.plot(*points.T, **_in_grey(ax, drawn))
        drawn.update(color=line.get_color(), linestyle=line.get_linestyle())
    return drawn


def one_offset(self: Any, *, ax: Any = None, **style: Any) -> Any:
    """Offset.plot"""
    ax = _plane_axes(ax, self.path)
    drawn = _draw(self, ax, style)
    for marker, points in zip("oxs", marks(self).values()):
        if len(points):
            ax.plot(*points.T, marker, color=drawn.get("color"), fillstyle="none", markersize=5)
    return ax


def offset(self: Any, distance: Any, join: str = "round", trim: bool = False, *, ax: Any = None, **style: Any) -> Any:
    """Path.plot_offset"""
    if distance is None:
        raise TypeError("distance: a number or a list of numbers is wanted, not NoneType")
    found = []
    for d in _numbers.numbers(distance, "distance") if np.ndim(distance) else [distance]:
        if isinstance(d, (int, Fraction)) and abs(Fraction(d)) > Fraction(sys.float_info.max):
            reason = "it is too large to be drawn"
            raise InputError(f"distance: {reason}", "distance", reason, d)
        found.append(self.offset(d, join, trim))
    ax = _plane_axes(ax, self)
    for each in found:
        try:
            each.plot(ax=ax, **style)
        except InputError as error:  # too large for a picture
            raise InputError(f"distance: {error}", "distance", str(error), distance) from None
    return ax


def envelope(self: Any, *, ax: Any = None, **style: Any) -> Any:
    """Envelope.plot"""
    ax = _plane_axes(ax)
    _draw(self, ax, style)
    return ax


def angle(self: Any, ts: Any = None, *, ax: Any = None, **style: Any) -> Any:
    """Angle.plot"""
    _require_axes(ax, "plot")
    at = _numbers.numbers(_parameters(self.path, ts), "ts")
    values = self(at)
    if not isinstance(values, np.ndarray):
        raise TypeError(f"ts: a list of parameters is wanted, not {type(ts).__name__}")
    if ax is None:
        ax = _new_axes(xlabel="t", ylabel="θ")
    ax.plot([float(_EXACTLY(t)) for t in at], values, **_in_grey(ax, style))
    return ax


def body(self: Any, *, ax: Any = None, **style: Any) -> Any:
    """SweptBody.plot"""
    _require_axes(ax, "add_collection3d")
    if ax is None:
        ax = _new_axes(projection="3d", xlabel="x", ylabel="y", zlabel="z")
    points = self.vertices
    ax.plot_trisurf(*points.T, triangles=self.triangles, **{"linewidth": 0, "antialiased": False, **style})
    _equalize(ax, points.min(axis=0), points.max(axis=0))
    return ax


def picture(draw: Callable[[Any], object], **options: Any) -> str:
    """A small picture for HTML, of the axes that `draw` is given; nothing without Matplotlib."""
    if find_spec("matplotlib") is None:
        return ""
    from matplotlib.figure import Figure
    from mpl_toolkits import mplot3d  # noqa: F401

    figure = Figure(figsize=(3.2, 2.4), layout="constrained")
    draw(figure.add_subplot(**options))
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=100)
    return f'<img alt="" src="data:image/png;base64,{base64.b64encode(file.getvalue()).decode()}">'
