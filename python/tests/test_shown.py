"""What notebooks show: formulas, tables of poles, pictures."""

import base64
import re
import sys
from fractions import Fraction

import mpmath
import numpy as np
import pytest

import phrame
from common import QUINTIC

SPLINE = phrame.Path([QUINTIC.segment(0, "1/3"), QUINTIC.segment("1/3", 1)], "a <b>")


def test_formulas():
    assert r"\mathbf r'(t)" in QUINTIC._repr_latex_() and "-3t^{4} + 8t^{3} + 14t^{2} - 20t + 4" in QUINTIC._repr_latex_()
    assert SPLINE._repr_latex_() is None
    huge = phrame.Curve([10**1000, 1], [1], [0], [1])
    assert huge._repr_latex_() is None


def test_poles_are_those_of_the_rate():
    with mpmath.workdps(30):
        rate = QUINTIC.angle().rate()
        n, d = ([mpmath.mpf(c.numerator) / c.denominator for c in p.coefficients][::-1]
                for p in (rate.numerator, rate.denominator))
        roots = mpmath.polyroots(d)
        found = QUINTIC.angle().poles()
        assert len(found) == len(roots)
        for pole, residue in found:
            z = min(roots, key=lambda root: abs(root - pole))
            exact = mpmath.polyval(n, z) / mpmath.polyval(d, z, derivative=1)[1]
            assert abs(z - pole) < 1e-12 and abs(exact - residue) < 1e-12
    assert phrame.integrate("1/((x - 2)*(x^2 + 1))").poles()[:1] == ((2, 0.2),)
    assert phrame.integrate("x").poles() == ()
    # Residues that several poles share, for which the closed form is no sum over them: the paper's w and d [Farouki 2003].
    b_over_rho = phrame.RationalFunction([-96, -384, 416], QUINTIC.rho)
    printed = [(0.493692520439 + 0.069302855662j, 0.5j), (2.906307479561 + 5.269302855662j, -0.5j)]
    for poles in (phrame.integrate(b_over_rho).poles(), QUINTIC.angle("frenet").poles()):
        for z, c in printed:
            assert any(abs(z - pole) < 1e-12 and abs(abs(c) - abs(residue)) < 1e-12 and residue.real == 0 for pole, residue in poles)
    assert len(QUINTIC.angle("frenet").poles()) == 8
    with pytest.raises(phrame.InputError, match="segment"):
        QUINTIC.angle().poles(1)


@pytest.fixture(autouse=True)
def no_window(monkeypatch):
    monkeypatch.setenv("MPLBACKEND", "agg")


def test_html_has_formula_poles_and_a_picture():
    pytest.importorskip("matplotlib")
    html = QUINTIC.angle()._repr_html_()
    assert r"\theta(t)" in html and "0.0120183880193 ± 0.394440354901i" in html
    assert "−0.096099539514 ± 0.0145903344262i" in html
    for x in (QUINTIC, SPLINE, QUINTIC.angle(), SPLINE.angle()):
        image = base64.b64decode(re.search('base64,([^"]*)', x._repr_html_()).group(1))
        assert image.startswith(b"\x89PNG") and len(image) < 30_000
    assert "a &lt;b&gt;" in SPLINE._repr_html_()
    assert r"\arctan" in phrame.integrate("1/(x^2+1)")._repr_html_()
    assert "<table>" in phrame.integrate("1/(x^5+x+1)")._repr_html_()
    assert "length" in phrame.Curve([-1, 2], [0], [0], [0])._repr_html_()  # a cusp


def test_a_definite_integral_shows_its_value():
    half_pi = phrame.integrate("1/(x^2+1)", 0, "inf")
    latex = half_pi._repr_latex_()
    assert latex.startswith("$") and r"\int_{0}^{\infty}" in latex and r"\frac{\pi }{2}" in latex and "1.5707963" in latex
    assert "1.5707963" in half_pi._repr_html_() and repr(half_pi).endswith("from 0 to ∞>")
    deep = phrame.integrate("1/(x^5 - x - 1)", 2, 3)
    assert str(deep.value()) in deep._repr_latex_() and str(deep.value()) in deep._repr_html_()
    assert "value" not in phrame.integrate("x")._repr_html_()


def test_answers_show_themselves():
    pytest.importorskip("matplotlib")
    helix, line = phrame.Curve([1], [0, 1], [0], [1]), phrame.Curve([1], [0], [0], [0])
    for path, kinds in ((QUINTIC, "of no special kind"), (helix, "a helix"), (line, "straight"), (SPLINE, "of no special kind")):
        found = path.classify()
        assert kinds in repr(found) and found.path == path and "line" in found._repr_html_()
    assert r"\begin{aligned}" in QUINTIC.classify()._repr_latex_() and SPLINE.classify()._repr_latex_() is None
    twist = QUINTIC.minimal_twist(0, 1)
    assert f"{float(twist.twist):.10f}" in twist._repr_html_()
    ts = np.linspace(0, 1, 9)
    verdict = QUINTIC.check(ts, QUINTIC.frames(ts, kind="erf")[:, 1], start="erf")
    assert "0.285856530098" in verdict._repr_html_() and "base64" in verdict._repr_html_() and "fail" in verdict._repr_html_()
    certificate = QUINTIC.certify(at=[0, "1/2"], digits=20)
    assert [t for t, _, _ in certificate.claims] == [0, Fraction(1, 2)]
    for t, theta, radius in certificate.claims:
        assert abs(theta - QUINTIC.angle().value(t, 30)) <= radius if t else theta == 0
        assert str(theta) in certificate._repr_html_()
    assert "2 angles" in repr(certificate)
    body = phrame.sweep(QUINTIC, "polygon:3,1/9", sections=3)
    assert f"{body.volume():.12g}" in body._repr_html_() and "base64" in body._repr_html_()


def test_a_body_is_drawn():
    pyplot = pytest.importorskip("matplotlib.pyplot")
    body = phrame.sweep(QUINTIC, "polygon:3,1/9", sections=3)
    (mesh,) = body.plot(color="red").collections
    faces = mesh._faces[:, :3] if hasattr(mesh, "_faces") else mesh._vec.T[:, :3].reshape(len(body.triangles), -1, 3)[:, :3]
    assert np.array_equal(np.array(faces), body.vertices[body.triangles])
    pyplot.close("all")


def test_plots_show_the_numbers():
    pyplot = pytest.importorskip("matplotlib.pyplot")
    ts = np.linspace(0, 1, 9)
    ax = QUINTIC.plot(ts, start_normal=[0, 0, 1], color="red")
    points, frames = QUINTIC.points(ts), QUINTIC.frames(ts, start_normal=[0, 0, 1])
    (line,) = ax.lines
    assert np.array_equal(np.array(line.get_data_3d()).T, points) and line.get_color() == "red"
    (ribbon,) = ax.collections
    width = np.linalg.norm(points.max(axis=0) - points.min(axis=0)) / 10
    first = ribbon._faces[0] if hasattr(ribbon, "_faces") else ribbon._vec.T[:4, :3]
    assert np.allclose(first[0], points[0] - width / 2 * frames[0, 1])
    assert np.allclose(first[2], points[1] + width / 2 * frames[1, 1])
    erf = QUINTIC.frames(ts, kind="erf")[:, 1]
    (theirs,) = QUINTIC.plot(ts, f2=erf.tolist()).collections
    (ours,) = QUINTIC.plot(ts, kind="erf").collections
    vectors = [x._faces if hasattr(x, "_faces") else x._vec for x in (theirs, ours)]
    assert np.array_equal(*vectors) and not np.array_equal(vectors[0], ribbon._faces if hasattr(ribbon, "_faces") else ribbon._vec)
    with pytest.raises(phrame.InputError, match="^f2: 9 finite vectors"):
        QUINTIC.plot(ts, f2=erf[1:])
    assert len(QUINTIC.plot(ribbon=0).collections) == 0 and len(SPLINE.plot(ax=ax).lines) == 2
    theta = QUINTIC.angle().plot(ts).lines[0]
    assert np.array_equal(theta.get_ydata(), QUINTIC.angle()(ts)) and np.array_equal(theta.get_xdata(), ts)
    fractions = QUINTIC.angle().plot(["0", "1/3", 1]).lines[0]
    assert fractions.get_xdata().tolist() == [0, 1 / 3, 1] and len(QUINTIC.plot(["0", "1/3", 1]).lines[0].get_data_3d()[0]) == 3
    pyplot.close("all")


def test_without_matplotlib(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setattr("phrame._plot.find_spec", lambda name: None)
    assert "<img" not in QUINTIC._repr_html_() and "pole" in QUINTIC.angle()._repr_html_()
    with pytest.raises(ImportError, match="Matplotlib"):
        QUINTIC.plot()
