#!/usr/bin/env python3
"""Draws the figures of docs/minimal-twist.md, after those of R. T. Farouki and H. P. Moon, Rational frames of minimal twist (2018)."""

import draw
import numpy as np
from draw import plt
from gallery import MOON, TWISTS, extrema
from numpy.polynomial.polynomial import polyval

plt.rcParams.update({"axes.grid": True, "grid.color": "#dddddd"})


def evaluated(p, ts):
    return polyval(ts, [float(c) for c in p.coefficients] or [0.0])


def turn_rate(piece, ts):
    """θ′ of θ = 2 arg w, per unit of t."""
    w = np.array(piece.coefficients)
    tau = (ts - float(piece.start)) / float(piece.end - piece.start)

    def de_casteljau(b):
        b = b[:, None] + 0 * tau
        while len(b) > 1:
            b = b[:-1] * (1 - tau) + b[1:] * tau
        return b[0]

    value, slope = de_casteljau(w), piece.degree * de_casteljau(np.diff(w))
    return 2 * np.imag(np.conj(value) * slope) / np.abs(value) ** 2 / float(piece.end - piece.start)


def rates_of(c, piece):
    """t, and the rates about the tangent per length of the Euler–Rodrigues frame, and of the rational frame against it."""
    ts = np.linspace(float(piece.start), float(piece.end), 201)
    speed = evaluated(c.sigma, ts)
    return ts, 2 * evaluated(c.h, ts) / speed**2, turn_rate(piece, ts) / speed


def errors():
    """Figures 3, 7 and 10: the error as a function of gamma."""
    figure, axes = plt.subplots(1, 3, figsize=(9, 2.6))
    for number, (axis, twist) in enumerate(zip(axes, TWISTS), start=1):
        for gammas in (range(-100, -2), range(3, 101)):
            found = [float(twist.rational(gamma=f"{g}/50").rms) for g in gammas]
            draw.note(found)
            axis.plot(np.array(gammas) / 50, found, "C0-")
        axis.set(title=f"example {number}", xlabel="γ", yscale="log", xlim=(-2, 2))
    axes[0].set_ylabel("rms of $\\Omega_1 - \\bar\\Omega_1$ over $|\\bar\\Omega_1|$")
    draw.save(figure, "minimal-twist-errors.svg")


def plot_rates(axis, c, frame, twist, title):
    columns = [rates_of(c, piece) for piece in frame.pieces]
    ts, erf, turn = (np.concatenate(column) for column in zip(*columns))
    draw.note(ts, erf, turn)
    axis.plot(ts, erf, label="$\\omega_1$, ERF")
    axis.plot(ts, turn, label="$\\theta'/\\sigma$, rotation")
    axis.plot(ts, erf + turn, label="$\\Omega_1$, rational frame")
    axis.plot(ts, np.full(len(ts), float(twist.rate)), "k:", linewidth=0.9, label="$\\bar\\Omega_1$")
    axis.set(title=title, xlabel="t", xlim=(0, 1))


def rates():
    """Figures 4, 8 and 11: the rates about the tangent, for the best gamma."""
    figure, axes = plt.subplots(1, 3, figsize=(9, 3))
    for number, (axis, c, twist) in enumerate(zip(axes, MOON, TWISTS), start=1):
        plot_rates(axis, c, twist.rational(), twist, f"example {number}")
    axes[0].set_ylabel("rates per length")
    draw.save(figure, "minimal-twist-rates.svg", axes[0])


def poor():
    """Figures 6 and 12: a poor choice of gamma, and a division at the sharp extremum."""
    figure, axes = plt.subplots(1, 2, figsize=(7, 3))
    plot_rates(axes[0], MOON[0], TWISTS[0].rational(gamma=-1), TWISTS[0], "example 1, γ = −1")
    sharp = sum(extrema(MOON[2])[-1].ball(100)) / 2
    plot_rates(axes[1], MOON[2], TWISTS[2].rational(subdivide=[sharp]), TWISTS[2], "example 3 in two pieces")
    axes[1].axvline(float(sharp), color="0.5", linestyle="-", linewidth=0.6)
    axes[0].set_ylabel("rates per length")
    draw.save(figure, "minimal-twist-choices.svg", axes[0])


def exact():
    """Figure 2: the exact frame turns evenly."""
    figure, axis = plt.subplots(figsize=(4, 2.6))
    ts = np.linspace(0, 1, 201)
    lengths = [float(MOON[0].arc_length(t)) for t in ts]
    erf = 2 * evaluated(MOON[0].h, ts) / evaluated(MOON[0].sigma, ts) ** 2
    draw.note(lengths, erf)
    axis.plot(lengths, erf, label="Euler–Rodrigues frame")
    axis.plot(lengths, np.full(len(ts), float(TWISTS[0].rate)), label="exact frame of minimal twist")
    axis.set(xlabel="arc length", ylabel="rate about the tangent")
    axis.legend(fontsize=7)
    draw.save(figure, "minimal-twist-exact.svg")


if __name__ == "__main__":
    for figure in (errors, rates, poor, exact):
        figure()
