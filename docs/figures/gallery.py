#!/usr/bin/env python3
"""Draws the figures of docs/gallery.md, and writes its tables of numbers.

NUMBERS has what the papers print beside what is asked of the package; python/tests/test_gallery.py holds it."""

import math
import re
from fractions import Fraction

import numpy as np
from draw import ROOT, fill, note, plt, save

import phrame

PAGE = ROOT / "docs/gallery.md"


def curve(name):
    return phrame.read(ROOT / f"examples/curves/{name}.json")


FAROUKI = curve("farouki-2003-quintic")
MOON = [curve(f"farouki-moon-{k}") for k in (1, 2, 3)]
# The differences of these are those with which the paper's results are found: docs/minimal-twist.md.
MOON_ENDS = [("pi/8", "-pi/2"), ("-5*pi/4", "-81*pi/40"), ("-pi/4", "5*pi/4")]
TWISTS = [c.minimal_twist(*ends) for c, ends in zip(MOON, MOON_ENDS)]
PENG = curve("peng-pang-pan-2023")
SEPTIC = curve("double-ph-septic")
# Bernstein coefficients of a and b, as printed: for the weight 1 and for |τκ|.
PENG_PAIRS = [
    ([6.5789, 3.1495, -2.1811, 15.3863, 17.1115], [-0.8943, 1.0685, -0.6119, 1.1118, 3.9292]),
    ([9.8125, 1.1353, -1.1893, 15.1672, 9.1231], [-1.4645, 0.8832, -0.4792, -0.0104, 2.7759]),
]


# ---- numbers: (what, as printed, what phrame has, how many units of the last printed digit they may differ)


def upper(poles):
    """Of conjugate pairs those with a positive imaginary part, from left to right."""
    return sorted(((z, c) for z, c in poles if z.imag > 0), key=lambda pair: pair[0].real)


def b_over_rho():
    """b of στ = a/σ + b/ρ, and its quotient by ρ."""
    g, i = FAROUKI.g
    b = phrame.Polynomial([4]) * (g.derivative() * i - i.derivative() * g)
    return b, phrame.RationalFunction(b, FAROUKI.rho)


def farouki():
    b, quotient = b_over_rho()
    yield "σ", "37t⁴ − 72t³ + 46t² − 12t + 6", FAROUKI.sigma
    yield "ρ", "80t⁴ − 544t³ + 3376t² − 2976t + 720", FAROUKI.rho
    yield "a", "8t² − 8t", phrame.Polynomial([2]) * FAROUKI.h
    yield "b", "416t² − 384t − 96", b
    printed = ["0.012018388019 + 0.394440354901i", "0.960954584954 + 0.343344423853i"]
    residues = ["−0.096099539514 − 0.030185214163i", "0.096099539514 − 0.014590334426i"]
    for k, (z, c) in enumerate(upper(FAROUKI.angle().poles())):
        yield f"z{'₁₂'[k]}", printed[k], z
        yield f"c{'₁₂'[k]}", residues[k], -c  # of a/σ, where θ′ has −a/σ
    printed = ["0.493692520439 + 0.069302855662i", "2.906307479561 + 5.269302855662i"]
    for k, (z, c) in enumerate(upper(phrame.integrate(quotient).poles())):
        yield f"w{'₁₂'[k]}", printed[k], z
        yield f"d{'₁₂'[k]}", ["0.5i", "−0.5i"][k], c


def extrema(c):
    """Where the rate 2h/σ² per length of the Euler–Rodrigues frame is greatest or least on [0, 1]."""
    slope = c.h.derivative() * c.sigma - phrame.Polynomial([2]) * c.h * c.sigma.derivative()
    return roots(slope)


def roots(p):
    """Of p in (0, 1), which are simple, from a grid that is fine enough for these."""
    ts = [Fraction(k, 64) for k in range(65)]
    return [phrame.root(p, a, b) for a, b in zip(ts, ts[1:]) if p(a) * p(b) < 0]


def moon():
    printed = [("−4.3703", "1.9129"), ("−3.6675", "2.6157"), ("2.2046", "2.2046")]
    # The printed coefficients have four decimals, so that the last of a twist is not theirs.
    for k, (twist, (nominal, least)) in enumerate(zip(TWISTS, printed), start=1):
        yield f"example {k}: T", nominal, twist.nominal_twist, 2
        yield f"example {k}: T_min", least, twist.twist, 2
    # The signs are other ones, for the whole turns in the angles: docs/minimal-twist.md.
    for k, (gamma, rms) in enumerate([("0.938", "0.168"), ("0.749", "0.112"), ("0.557", "0.555")], start=1):
        (piece,) = TWISTS[k - 1].rational().pieces
        yield f"example {k}: |γ|", gamma, piece.gamma
        yield f"example {k}: rms of Ω₁ − Ω̄₁ over |Ω̄₁|", rms, piece.rms
    yield "example 1: inflections of the ERF", "0", len(roots(MOON[0].h))
    yield "example 2: inflections of the ERF", "1", len(roots(MOON[1].h))
    (inflection,) = roots(MOON[2].h)
    mild, sharp = extrema(MOON[2])
    yield "example 3: inflection of the ERF", "0.2363", inflection
    yield "example 3: mild extremum of ω₁", "0.043205", mild, 5
    yield "example 3: sharp extremum of ω₁", "0.6735", sharp
    first, second = TWISTS[2].rational(subdivide=[sum(sharp.ball(100)) / 2]).pieces
    yield "example 3 in two pieces: γ₁", "1.351", first.gamma
    yield "example 3 in two pieces: γ₂", "0.563", second.gamma


def peng():
    yield "arc length", "17/3", PENG.length


def septic():
    """Beltran and Monterde's curve, in the slides: r′ = f·A i A* with f = 1/3, so that |r′ × r″| = f²σ√ρ."""
    f, (c, omega) = SEPTIC.multiplier(0), SEPTIC.classify().double_ph
    root = math.isqrt(int(c))
    assert root * root == c
    kappa = phrame.RationalFunction(phrame.Polynomial([root / f]) * omega, SEPTIC.sigma * SEPTIC.sigma)
    assert all(kappa(t) ** 2 == SEPTIC.squared_curvature(t) for t in range(9))
    tau = SEPTIC.torsion_function
    yield "|r′|", "(t⁶ + 3t⁴ + 9t² + 9)/3", phrame.Polynomial([f]) * SEPTIC.sigma
    yield "|r′ × r″|", "2(t² + 1)(t⁶ + 3t⁴ + 9t² + 9)", phrame.Polynomial([root * f * f]) * omega * SEPTIC.sigma
    ratio = phrame.RationalFunction(kappa.numerator * tau.denominator, kappa.denominator * tau.numerator)
    yield "κ/τ", "−9(t² + 1)²/(2t⁶ + 9t⁴ − 9)", ratio


NUMBERS = {"farouki-2003": farouki, "farouki-moon-2018": moon, "peng-pang-pan-2023": peng, "farouki-slides": septic}

POWERS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")


def as_function(text):
    """A rational function as the papers print it, read by phrame."""
    text = re.sub("[⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda power: "^" + power[0].translate(POWERS), text.replace("−", "-"))
    return phrame.integrate(re.sub(r"(?<=[0-9)])\s*(?=[t(])", "*", text), variable="t").integrand


def parts(text):
    """The real and the imaginary part of a printed number: its value as a fraction, its number of decimals."""
    found = {False: (Fraction(0), 99), True: (Fraction(0), 99)}
    for sign, digits, unit in re.findall(r"([+−]?)\s*([0-9.]+)(i?)", text):
        found[bool(unit)] = (-1 if sign == "−" else 1) * Fraction(digits), len(digits.partition(".")[2])
    return found[False], found[True]


def agrees(printed, found, units=1):
    """Is it what is printed? A number up to so many units of its last digit, all else exactly."""
    if isinstance(found, (phrame.Polynomial, phrame.RationalFunction)):
        return as_function(printed) == phrame.RationalFunction(*([found, [1]] if isinstance(found, phrame.Polynomial) else
                                                                 [found.numerator, found.denominator]))
    if isinstance(found, (int, Fraction)):
        return Fraction(printed) == found
    if isinstance(found, phrame.Real):
        found = sum(found.ball(100)) / 2
        (value, decimals), _ = parts(printed)
        return abs(found - value) <= Fraction(units, 10**decimals)
    return all(abs(Fraction(x) - value) <= Fraction(units, 10 ** min(decimals, 14))
               for x, (value, decimals) in zip((found.real, found.imag), parts(printed)))


def as_text(found):
    if isinstance(found, phrame.Real):
        text = str(found.digits(20))
    elif isinstance(found, complex):
        text = f"{found.imag:+.15g}i" if found.real == 0 else f"{found.real:.15g} {found.imag:+.15g}i"
        text = re.sub(r" ([+-])", r" \1 ", text).lstrip("+")
    else:
        text = str(found)
    text = re.sub(r"\^([0-9]+)", lambda power: power[1].translate({v: k for k, v in POWERS.items()}), text)
    return text.replace("*", "").replace("-", "−")


def table(rows):
    lines = ["| | paper | phrame |", "|---|---|---|"]
    for what, printed, found, *units in rows:
        if not agrees(printed, found, *units):
            raise SystemExit(f"gallery: {what}: {printed} in print, {as_text(found)} here")
        label = what.replace("|", "\\|")
        lines.append(f"| {label} | {printed} | {as_text(found)} |")
    return "\n".join(lines) + "\n"


def page(text):
    """The page with its tables as they are computed now."""
    for name, rows in NUMBERS.items():
        mark = f"<!-- {name}, by docs/figures/gallery.py -->\n"
        before, found, after = text.partition(mark)
        if not found:
            raise SystemExit(f"gallery: docs/gallery.md has no table {name}")
        text = before + mark + table(rows()) + re.sub(r"\A(\|.*\n)*", "", after)
    return text


# ---- figures


def panels(columns, rows=1):
    return plt.subplots(rows, columns, figsize=(2.6 * columns, 2.6 * rows), subplot_kw={"projection": "3d"})


def ribbon(ax, c, title, ts, view=(30, -60), **options):
    c.plot(ts, ax=ax, linewidth=1, linestyle="-", **options)
    points, normals = c.points(ts), options["f2"] if "f2" in options else c.frames(ts, kind=options.get("kind", "rmf"))[:, 1]
    note(points, normals)
    ax.set_title(title)
    width = np.linalg.norm(points.max(axis=0) - points.min(axis=0)) / 10  # that of plot()
    fill(ax, np.concatenate([points + width / 2 * normals, points - width / 2 * normals]), view)


def turned(c, theta, ts):
    """The Euler–Rodrigues frame's e₂ turned by θ about the tangent."""
    _, e2, e3 = np.moveaxis(c.frames(ts, kind="erf"), 1, 0)
    return np.cos(theta)[:, None] * e2 + np.sin(theta)[:, None] * e3


def minimizing(c, ts):
    """f₂ of the rotation-minimizing frame that starts as the Euler–Rodrigues frame, as papers have it."""
    return turned(c, c.angle()(ts), ts)


def farouki_frames():
    """Figure 1: the curve with its control polygon, the Frenet and the rotation-minimizing frame."""
    figure, axes = panels(3)
    ts = np.linspace(0, 1, 49)
    ribbon(axes[0], FAROUKI, "control polygon", ts, ribbon=0)
    corners = np.array(FAROUKI.control_points, dtype=float)
    axes[0].plot(*corners.T, "o-", markersize=2, linewidth=0.6, color="gray")
    fill(axes[0], corners, (30, -60))
    ribbon(axes[1], FAROUKI, "Frenet", ts, kind="frenet")
    ribbon(axes[2], FAROUKI, "rotation-minimizing", ts, f2=minimizing(FAROUKI, ts))
    save(figure, "farouki-2003-frames.svg")


def farouki_rates():
    """Figure 2."""
    figure, ax = plt.subplots(figsize=(4, 2.6))
    ts = np.linspace(0, 1, 129)
    kappa = np.sqrt([float(FAROUKI.squared_curvature(t)) for t in ts])
    tau = np.array([float(FAROUKI.torsion(t)) for t in ts])
    note(kappa, tau)
    ax.plot(ts, np.hypot(kappa, tau), label="Frenet, √(κ² + τ²)")
    ax.plot(ts, kappa, label="rotation-minimizing, κ")
    ax.set(xlabel="t", ylabel="rate of rotation")
    ax.legend(fontsize=7)
    save(figure, "farouki-2003-rates.svg")


def moon_frames():
    """Figures 1 (right), 5, 9 and 13: the frames of Euler and Rodrigues and of minimal twist, with the same start."""
    figure, axes = panels(3, 2)
    ts = np.linspace(0, 1, 41)
    for k, (c, twist) in enumerate(zip(MOON, TWISTS)):
        theta = np.array([float(twist.value(t)) for t in ts])
        ribbon(axes[0][k], c, f"example {k + 1}: Euler–Rodrigues", ts, f2=turned(c, np.full(len(ts), theta[0]), ts))
        ribbon(axes[1][k], c, "minimal twist", ts, f2=turned(c, theta, ts))
    save(figure, "farouki-moon-frames.svg")


def peng_frames():
    """Figures 1 (a) and 4 (a)."""
    figure, axes = panels(2)
    ts = np.linspace(0, 1, 49)
    ribbon(axes[0], PENG, "Euler–Rodrigues", ts, kind="erf")
    ribbon(axes[1], PENG, "rotation-minimizing", ts, f2=minimizing(PENG, ts))
    save(figure, "peng-pang-pan-frames.svg")


def printed_angle(a, b, ts):
    """θ = 2 arg(b + ia) of Bernstein coefficients, from 0 on."""
    w = sum(math.comb(4, k) * (y + 1j * x) * (1 - ts) ** (4 - k) * ts**k for k, (x, y) in enumerate(zip(a, b)))
    theta = 2 * np.unwrap(np.angle(w))
    return theta - theta[0]


def peng_angles():
    """Figure 5, and the exact angle."""
    figure, ax = plt.subplots(figsize=(4, 2.6))
    ts = np.linspace(0, 1, 129)
    PENG.angle().plot(ts, ax=ax, color="k", linestyle=":", label="rotation-minimizing")
    for (a, b), weight in zip(PENG_PAIRS, ("ρ = 1", "ρ = |τκ|")):
        ax.plot(ts, printed_angle(a, b, ts), label=weight + ", as printed")
    note(*(line.get_ydata() for line in ax.lines))
    ax.set(xlabel="t", ylabel="θ")
    ax.legend(fontsize=7)
    save(figure, "peng-pang-pan-angles.svg")


def septic_frames():
    """The Frenet frame is rational; it turns by τ about the tangent, the rotation-minimizing one does not."""
    figure, axes = panels(2)
    ts = np.linspace(0, 1, 49)
    view = (-35, 60)  # from where it bends most
    ribbon(axes[0], SEPTIC, "Frenet, rational", ts, view, kind="frenet")
    ribbon(axes[1], SEPTIC, "rotation-minimizing", ts, view, f2=minimizing(SEPTIC, ts))
    save(figure, "double-ph-septic-frames.svg")


def main():
    for draw_one in (farouki_frames, farouki_rates, moon_frames, peng_frames, peng_angles, septic_frames):
        draw_one()
    text = PAGE.read_text(encoding="utf-8")
    if page(text) != text:
        PAGE.write_text(page(text), encoding="utf-8")
        print("gallery.md: its numbers are new")


if __name__ == "__main__":
    main()
