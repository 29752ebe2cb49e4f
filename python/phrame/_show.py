"""How objects show themselves in notebooks: LaTeX and HTML."""

from __future__ import annotations

from html import escape
from typing import Any, Iterable, Optional

from ._errors import Error
from ._phrame import Path
from ._plot import picture

_LONGEST = 2000  # characters of a formula that somebody looks at


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
    if self.end > 1 or not isinstance(self, Path):
        return None
    hodograph: Any = self.segments[0].hodograph
    rates = r" \\ ".join(part._repr_latex_().strip("$") for part in hodograph)
    latex = r"$\displaystyle \mathbf r'(t) = \begin{pmatrix} " + rates + r" \end{pmatrix}$"
    return latex if len(latex) <= _LONGEST else None


def _title(self: Any, what: str) -> str:
    name = f" <i>{escape(self.name)}</i>" if self.name else ""
    return f"<b>{what}{name}</b>"


def path_html(self: Any) -> str:
    """Path._repr_html_"""
    rows = [("length", escape(_number(float(self.length))))]
    if not isinstance(self, Path):
        title = _title(self, "Curve" if self.end == 1 else f"Path of {self.end} curves,")
    elif self.end > 1:
        title = _title(self, f"PH spline of {self.end} curves,")
    else:
        title = _title(self, f"PH curve of degree {self.segments[0].degree}")
    try:
        drawing = picture(lambda ax: self.plot(ax=ax), projection="3d")
    except (Error, OverflowError):  # a cusp without a tangent, numbers that no double holds
        drawing = ""
    return f"<div>{title}{_formula(path_latex(self))}{_table(rows)}{drawing}</div>"


def angle_html(self: Any) -> str:
    """Angle._repr_html_"""
    if self.path.end > 1:
        theta = self.value(self.path.end)
        body = _table([("θ at the end", _number(float(theta)))])
    else:
        body = _formula(self._repr_latex_()) + _poles(self.poles())
    try:
        drawing = picture(lambda ax: self.plot(ax=ax))
    except (Error, OverflowError):
        drawing = ""
    return f"<div>{body}{drawing}</div>"


def smooth_angle_html(self: Any) -> str:
    """SmoothAngle._repr_html_"""
    body = _table([("θ at the end", _number(float(self.value(self.path.end))))])
    try:
        drawing = picture(lambda ax: self.plot(ax=ax))
    except (Error, OverflowError):
        drawing = ""
    return f"<div>{body}{drawing}</div>"


def integral_html(self: Any) -> str:
    """Integral._repr_html_"""
    return f"<div>{_formula(self._repr_latex_())}{_poles(self.poles())}</div>"
