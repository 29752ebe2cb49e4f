#!/usr/bin/env python3
"""Draws the figures of docs/offsets.md and docs/minkowski.md."""

import json

import draw
import numpy as np
import phrame
from draw import plt

WAVE = [[0, 0, 0], [2, 2, 0], [4, -1, 0], [6, 2, 0], [8, 1, 0]]
LEAF = [[[0, 0, 1], ["3/2", 0, 1], [3, 1, 2]]]
# The medial axis of the rectangle from (0, 0) to (4, 2).
RECTANGLE = [[[0, 0, 0], [1, 1, 1]], [[0, 2, 0], [1, 1, 1]], [[1, 1, 1], [3, 1, 1]], [[3, 1, 1], [4, 0, 0]], [[3, 1, 1], [4, 2, 0]]]


def outline(ax, curves, **style):
    for curve in curves:
        path = phrame.parse(json.dumps(curve))
        points = path.points(np.linspace(0, float(path.end), 96 * path.end + 1))
        draw.note(points[:, :2])
        ax.plot(*points.T[:2], **style)


def offsets():
    """Offsets with their cusps and crossings, what is left of them, and a pocket."""
    figure, (all_of_them, trimmed, pocket) = plt.subplots(1, 3, figsize=(9, 2.6), width_ratios=(3, 3, 2))
    wave = phrame.Path.through(WAVE, kind="planar")
    for ax, trim in ((all_of_them, False), (trimmed, True)):
        outline(ax, [json.loads(wave.json())], color="0.6", linestyle="-")
        for line in wave.plot_offset(["1/2", "1", "-1/2", "-1"], trim=trim, ax=ax, linestyle="-").lines[1:]:
            draw.note(line.get_data())
    corners = [[0, 0, 0], [6, 0, 0], [6, 2, 0], [3, 2, 0], [3, 4, 0], [0, 4, 0], [0, 0, 0]]
    room = phrame.Path([phrame.Path.from_control_points([a, b]) for a, b in zip(corners, corners[1:])])
    outline(pocket, [json.loads(room.json())], color="0.6", linestyle="-")
    outline(pocket, [json.loads(inner.json()) for inner in room.offset("-1/4", pocket=True)], color="C0", linestyle="-")
    for ax, title in ((all_of_them, "offsets"), (trimmed, "trimmed"), (pocket, "a pocket")):
        ax.set(title=title, aspect="equal")
        ax.set_axis_off()
    draw.save(figure, "offsets.svg")


def envelopes():
    """Discs along curves with radii, and what bounds their union."""
    figure, axes = plt.subplots(1, 2, figsize=(8, 3))
    for ax, pieces in zip(axes, (LEAF, RECTANGLE)):
        axis = {"phrame": "mph/1", "segments": [{"control_points": points} for points in pieces]}
        for points in pieces:
            along = phrame.parse(json.dumps({"phrame": "curve/1", "control_points": points})).points(np.linspace(0, 1, 9))  # x, y, and r for z
            draw.note(along)
            ax.plot(*along.T[:2], color="C1", linestyle="--")
            for x, y, r in along:
                ax.add_patch(plt.Circle((x, y), r, fill=False, color="0.75", linewidth=0.5))
        for boundary in phrame.ask("envelope", axis, trim=True)["branches"]:
            outline(ax, boundary["paths"], color="C0", linestyle="-")
        ax.set(aspect="equal")
        ax.autoscale_view()
        ax.set_axis_off()
    draw.save(figure, "minkowski.svg")


if __name__ == "__main__":
    offsets()
    envelopes()
