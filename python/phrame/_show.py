"""How objects show themselves in notebooks: LaTeX and HTML."""

from __future__ import annotations

from html import escape
from typing import Any, Iterable, List, Optional

import numpy as np

from ._errors import Error, InputError
from ._phrame import digits
from ._plot import picture

_LONGEST = 2000  # characters of a formula that somebody looks at
_MOST_TRIANGLES = 20_000  # of a picture that is there at once


def _table(rows: Iterable[Iterable[str]], head: Iterable[str] = ()) -> str:
    lines = ["<tr>" + "".join(f"<th>{x}</th>" for x in head) + "</tr>"] if head else []
    lines += ["<tr>" + "".join(f"<td>{x}</td>" for x in row) + "</tr>" for row in rows]
    return "<table>" + "".join(lines) + "</table>"


def _number(x: float) -> str:
    return f"{x:.12g}".replace("-", "−")


def _pair(z: complex) -> str:
    """z and its conjugate, or a real number."""
    if z.imag == 0:
        return _number(z.real)
    return f"{_number(z.real)} {'±' if z.imag > 0 else '∓'} {_number(abs(z.imag))}i"


def _poles(poles: Iterable[Any]) -> str:
    rows = [(_pair(z), _pair(c)) for z, c in poles if z.imag >= 0]
    return _table(rows, ("pole", "residue")) if rows else ""


def _formula(latex: Optional[str]) -> str:
    return "" if latex is None or len(latex) > _LONGEST else f"<p>{escape(latex)}</p>"


def path_latex(self: Any) -> Optional[str]:
    """Path._repr_latex_"""
    if self.end > 1 or not self.is_ph:
        return None
    hodograph: Any = self.hodograph
    rates = r" \\ ".join(part._repr_latex_().strip("$") for part in hodograph)
    latex = r"$\displaystyle \mathbf r'(t) = \begin{pmatrix} " + rates + r" \end{pmatrix}$"
    return latex if len(latex) <= _LONGEST else None


def _title(self: Any, what: str) -> str:
    name = f" <i>{escape(self.name)}</i>" if self.name else ""
    return f"<b>{what}{name}</b>"


def path_html(self: Any) -> str:
    """Path._repr_html_"""
    rows = [("length", escape(_number(float(self.length))))]
    if not self.is_ph:
        title = _title(self, "Curve" if self.end == 1 else f"Path of {self.end} curves,")
    elif self.end > 1:
        title = _title(self, f"PH spline of {self.end} curves,")
    else:
        title = _title(self, f"PH curve of degree {self.degree}")
    try:
        drawing = picture(lambda ax: self.plot(ax=ax), projection="3d")
    except (Error, OverflowError):  # a cusp without a tangent, numbers that no double holds
        drawing = ""
    return f"<div>{title}{_formula(path_latex(self))}{_table(rows)}{drawing}</div>"


def angle_html(self: Any) -> str:
    """Angle._repr_html_"""
    formula = self._repr_latex_()
    if formula is None:
        body = _table([("θ at the end", _number(float(self.value(self.path.end))))])
    else:
        body = _formula(formula) + _poles(self.poles())
    try:
        drawing = picture(lambda ax: self.plot(ax=ax))
    except (Error, OverflowError):
        drawing = ""
    return f"<div>{body}{drawing}</div>"


def integral_html(self: Any) -> str:
    """Integral._repr_html_"""
    try:
        rows = [("value", escape(str(self.value())))]
    except InputError:  # no ends were given
        rows = []
    return f"<div>{_formula(self._repr_latex_())}{_table(rows) if rows else ''}{_poles(self.poles())}</div>"


def _kinds(found: Any) -> List[str]:
    """What a path is, of that which not every path is."""
    of_all = [
        (not found.is_regular, "with cusps"),
        (found.line, "straight"),
        (found.normal and not found.line, "plane"),
        (found.helix and not found.line, "a helix"),
        (found.erf_is_rotation_minimizing, "its Euler–Rodrigues frame is rotation-minimizing"),
    ]
    if found.path.end == 1:
        of_all += [(found.double_ph, "double PH"), (found.rational_frame, "its rotation-minimizing frame is rational")]
    return [kind for is_so, kind in of_all if is_so]


def classification_repr(self: Any) -> str:
    """Classification.__repr__"""
    return f"<Classification of {repr(self.path)[1:-1]}; {', '.join(_kinds(self)) or 'of no special kind'}>"


def classification_html(self: Any) -> str:
    """Classification._repr_html_"""
    formulas = _formula(self._repr_latex_())
    return f"<div>{_title(self.path, 'Classification')}{formulas or '<pre>' + escape(self.text()) + '</pre>'}</div>"


def twist_html(self: Any) -> str:
    """MinimalTwist._repr_html_"""
    rows = [
        ("twist", f"{_number(float(self.twist))} rad"),
        ("with whole turns", f"{_number(float(self.nominal_twist))} rad"),
        ("per length", _number(float(self.rate))),
        ("length", _number(float(self.length))),
    ]
    return f"<div><b>Frame of minimal twist</b>{_table(rows)}</div>"


def check_html(self: Any) -> str:
    """CheckResult._repr_html_"""
    low, high = self.max_error
    rows = [("greatest error", f"{_number(float(low))} … {_number(float(high))} rad"), ("at sample", str(self.worst_sample))]
    errors = [np.nan if error is None else float(error[1]) for error in self.errors]

    def draw(ax: Any) -> None:
        ax.axhline(0, color="0.7", linewidth=0.8)
        ax.plot(errors, ".-", linewidth=1)
        ax.set(xlabel="sample", ylabel="error in rad")

    return f"<div><b>{escape(self.summary)}</b>{_table(rows)}{picture(draw)}</div>"


def certificate_html(self: Any) -> str:
    """Certificate._repr_html_"""
    rows = [(escape(str(t)), f"{theta} ± {radius}".replace("-", "−")) for t, theta, radius in self.claims]
    what = "length" if self.is_of_length else "θ(t)"
    return f"<div>{_title(self.curve, 'Certificate')}{_table(rows, ('t', what))}</div>"


def body_html(self: Any) -> str:
    """SweptBody._repr_html_"""
    rows = [
        ("points, triangles", f"{len(self.vertices)}, {len(self.triangles)}"),
        ("ends", "none" if self.is_closed else "capped"),
        ("distance from the surface", "not bounded" if self.error is None else f"≤ {self.error:.3g}, proved"),
        ("folds", str(self.folds)),
        ("volume", _number(self.volume())),
    ]
    is_small = len(self.triangles) <= _MOST_TRIANGLES
    drawing = picture(lambda ax: self.plot(ax=ax), projection="3d") if is_small else ""
    return f"<div><b>Swept body</b>{_table(rows)}{drawing}</div>"


def _drawing(self: Any) -> str:
    try:
        return picture(lambda ax: self.plot(ax=ax) and ax.set(aspect="equal"))
    except (Error, OverflowError):
        return ""


def offset_repr(self: Any) -> str:
    """Offset.__repr__: what takes no time."""
    d = str(self.distance) if abs(self.distance.numerator * self.distance.denominator) < 10**12 else str(digits(self.distance, 6))
    return f"<Offset by {d}: {_count(len(self.paths), 'path')}>"


def _count(n: int, one: str, many: str = "") -> str:
    return f"{n} {one if n == 1 else many or one + 's'}"


def offset_html(self: Any) -> str:
    """Offset._repr_html_"""
    rows = [("distance", str(self.distance))]
    if not self.two_sided:
        rows.append(("length", _number(float(self.length))))
        if self.area is not None:
            rows.append(("signed area", _number(float(self.area))))
    rows += [(f"cusp at t = {_number(float(cusp.t))}", _point(cusp.point)) for cusp in self.cusps]
    rows += [("touches itself" if meeting.touches else "meets itself", _point(meeting.point)) for meeting in self.self_intersections]
    rows += [("branch", f"{'closed' if branch.is_closed else 'open'}, {_number(float(branch.length))} long") for branch in self.branches]
    return f"<div>{_title(self.path, 'Offset of')}{_table(rows)}{_drawing(self)}</div>"


def _point(point: Any) -> str:
    return f"({_number(float(point[0]))}, {_number(float(point[1]))})"


def offset_check_html(self: Any) -> str:
    """OffsetCheck._repr_html_"""
    rows = [
        (name, f"{_number(float(side.distance[0]))} … {_number(float(side.distance[1]))} at {_point(side.farthest.point)}, {_count(side.number, 'stretch', 'stretches')}")
        for name, side in (("missing", self.missing), ("too much", self.too_much))
    ]
    return f"<div><b>{escape(repr(self)[1:-1])}</b>{_table(rows)}</div>"


def envelope_html(self: Any) -> str:
    """Envelope._repr_html_"""
    rows = [("segment", f"degree {segment.degree}") for segment in self.segments]
    return f"<div><b>{escape(repr(self)[1:-1])}</b>{_table(rows)}{_drawing(self)}</div>"
