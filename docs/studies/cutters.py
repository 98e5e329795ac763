# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the picture of docs/cutters.md: ``.venv/bin/python docs/studies/cutters.py``, from the project's
folder."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from freecad_fiveaxis.core.orientation.strategies import lean_axis
from freecad_fiveaxis.core.tool import Cutter, cutter_name, parse_cutter

PICTURE = Path(__file__).resolve().parents[1] / "images" / "cutters.png"
SHAPES = ("ball:10:16", "flat:10:16", "bull:10:2:16", "taperball:6:8deg:16", "taperbull:8:1.5:8deg:16",
    "lollipop:10:5:16",
          "barrel:8:30:1.5:16")  # fmt: skip
BODY, PART, MARK = "#c9d4e3", "#e9dfcf", "#c8442a"
X, Z = np.array([[1.0, 0.0, 0.0]]), np.array([[0.0, 0.0, 1.0]])


def outline(cutter: Cutter) -> np.ndarray:
    """The section (n, 2) through the axis, tip at zero."""
    (ring, corner, height), last = cutter.profile().rounds[0], cutter.undercut - cutter.taper
    angle = np.linspace(-np.pi / 2, last, 90)
    half = np.stack([ring + corner * np.cos(angle), height + corner * np.sin(angle)], axis=1)
    if cutter.barrel is not None:
        half = np.concatenate(
            [half[angle < cutter.barrel.begins - np.pi / 2], cutter.profile().flanks[:, 1::-1]]
        )
    half = np.concatenate([half, [(cutter.top_radius, cutter.length)]])
    return np.concatenate([half, half[::-1] * (-1.0, 1.0)])


def shape(axes: Any, text: str) -> None:
    """A cutter with its sizes."""
    cutter = parse_cutter(text)
    axes.fill(*outline(cutter).T, color=BODY, ec="black", lw=1)
    axes.plot([0, 0], [-2, cutter.length + 2], "-.", color="gray", lw=0.8)
    axes.plot([-cutter.ring, cutter.ring], [cutter.corner] * 2, "o", color=MARK, ms=4)
    axes.plot([0], [cutter.corner], "x", color=MARK)
    axes.plot([0], [0], "k.", ms=6)
    axes.set_title(
        text.rpartition(":")[0] + "\n" + cutter_name(cutter).replace(", flank", ",\nflank"), fontsize=8
    )
    axes.set(xlim=(-9, 9), ylim=(-3, 19), aspect="equal")
    axes.axis("off")


def stand(axes: Any, text: str, lead: float, title: str) -> None:
    """A cutter that leans forward over its facet; the feed goes to the right. Where the cutter leans below it
    the facet ends."""
    cutter = parse_cutter(text)
    axis = lean_axis(Z, X, np.radians(lead), 0.0)
    tip = cutter.tip_from_contact(0.0 * Z, Z, axis, X)[0]
    hub, side = tip + cutter.corner * axis[0], np.array([axis[0, 2], 0.0, -axis[0, 0]])
    points = tip + outline(cutter) @ np.stack([side, axis[0]])
    end = 14.0 if axis[0, 2] > 0.0 else 1.0
    axes.fill([-14, end, end, -14], [0, 0, -3, -3], color=PART, ec="black", lw=0.8)
    axes.fill(points[:, 0], points[:, 2], color=BODY, ec="black", lw=1)
    axes.plot([0, 0, hub[0], tip[0]], [0, cutter.corner, hub[2], tip[2]], "-", color=MARK, lw=1.5)
    axes.plot([0], [0], "o", color=MARK, ms=5)
    axes.plot([hub[0]], [hub[2]], "x", color=MARK)
    axes.plot([tip[0]], [tip[2]], "k.", ms=6)
    axes.annotate("feed", (-8, 16), (-13, 16), arrowprops={"arrowstyle": "->"}, fontsize=7, va="center")
    axes.set_title(title, fontsize=8)
    axes.set(xlim=(-14, 14), ylim=(-3, 19), aspect="equal")
    axes.axis("off")


def main() -> None:
    """Seven shapes above, seven stands below."""
    figure, axes = plt.subplots(2, 7, figsize=(14.0, 6.2), constrained_layout=True)
    for place, text in zip(axes[0], SHAPES, strict=True):
        shape(place, text)
    stand(axes[1, 0], "bull:10:2:16", 15.0, "lead 15 deg: contact, corner centre,\nhub (x), tip (dot)")
    stand(axes[1, 1], "bull:10:2:16", 0.0, "square: the foremost point touches")
    stand(axes[1, 2], "flat:10:16", 15.0, "flat, lead 15 deg")
    stand(axes[1, 3], "flat:10:16", -15.0, "flat, lead -15 deg: touches behind")
    stand(axes[1, 4], "taperball:6:8deg:16", 30.0, "taper ball, lead 30 deg")
    stand(
        axes[1, 5],
        "lollipop:10:5:16",
        105.0,
        "lollipop, below the surface: the ball\ntouches, the neck clears the edge",
    )
    stand(
        axes[1, 6],
        "barrel:8:30:1.5:16",
        78.0,
        "barrel, 78 deg: its flank touches,\nthe hub (x) is far from the contact",
    )
    figure.savefig(PICTURE, dpi=73, metadata={"Software": None})


if __name__ == "__main__":
    main()
