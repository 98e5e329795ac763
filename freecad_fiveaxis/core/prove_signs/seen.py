# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves in the words of somebody who stands in front of the machine.

right  +X of the machine; back  +Y, away from the operator; up  +Z. A machine that stands otherwise is looked at from where
       this is so; the sheet says it at its head.
turn   a positive rotary word turns the **tool relative to the work** right-handed about the axis' direction (ISO 841). A head
       does that itself; a table turns the part the other way.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.machine import Axis
from freecad_fiveaxis.core.records import Floats

VIEWS = (((0.0, 0.0, 1.0), "from above"), ((0.0, -1.0, 0.0), "from the front"), ((1.0, 0.0, 0.0), "from the right"))
EDGES = (((0.0, -1.0, 0.0), "front"), ((1.0, 0.0, 0.0), "right"))
WAYS = (("to the left", "to the right"), ("to the front", "to the back"), ("down", "up"))
ARM = 100.0
"""mm from the axis where the size of a turn is said."""


def linear_seen(axis: Axis, travel: float) -> tuple[str, str]:
    """What must be seen when the word of a linear axis grows by ``travel`` mm, and what a wrong sign looks like."""
    moved = np.array(axis.direction) * travel
    right, wrong = _way(moved), _way(-moved)
    if axis.side == "head":
        text = f"Only {axis.letter} moves: the tool goes {right} by {abs(travel):g} mm, the table rests."
        return text, f"The tool goes {wrong}: {axis.letter} has the wrong sign."
    text = f"Only {axis.letter} moves: the table goes {wrong} by {abs(travel):g} mm; the tool, seen from the part, goes {right}."
    return text, f"The table goes {right}: {axis.letter} has the wrong sign."


def rotary_seen(axis: Axis, other: str, angle: float) -> tuple[str, str]:
    """The same for the word of a rotary axis turned to ``angle`` rad; ``other``: the letter of the other rotary axis."""
    spin = np.array(axis.direction) * math.copysign(1.0, angle) * (1.0 if axis.side == "head" else -1.0)
    degrees = f"{math.degrees(abs(angle)):g} deg"
    view, right, wrong = _view(spin)
    what = "table" if axis.side == "table" else "head"
    mark, opposite = _mark(spin, abs(angle), axis.side)
    text = f"Only {axis.letter} turns: the {what} turns {right} by {degrees}, seen {view}; {mark}."
    bad = f"The {what} turns {wrong}, {opposite}: {axis.letter} has the wrong sign. Another axis turns: it is not {axis.letter}"
    return text, f"{bad} (if it is {other}, the two letters are exchanged)."


def _way(moved: Floats) -> str:
    """The directions of a move, the largest first, small ones left out."""
    size = np.abs(moved)
    parts = [k for k in np.argsort(-size, kind="stable").tolist() if size[k] > 0.1 * size.max()]
    return " and ".join(WAYS[k][int(moved[k] > 0.0)] for k in parts)


def _view(spin: Floats) -> tuple[str, str, str]:
    """From where to look, and the sense of the turn seen from there, right and wrong."""
    along = [abs(float(spin @ np.array(view))) for view, _ in VIEWS]
    best = int(np.argmax(along))
    towards = float(spin @ np.array(VIEWS[best][0])) > 0.0
    senses = ("clockwise", "counter-clockwise")
    lean = "" if along[best] > 0.999 else " (along the axis, which leans)"
    return VIEWS[best][1] + lean, senses[int(towards)], senses[int(not towards)]


def _mark(spin: Floats, angle: float, side: str) -> tuple[str, str]:
    """A place to watch and where it goes, by how much; and where it goes with the wrong sign."""
    size = "{:.1f} mm for each " + f"{ARM:g} mm from the axis"
    arc = ARM * math.sin(angle)
    if side == "head":
        moved = np.cross(spin, (0.0, 0.0, -1.0))
        if np.linalg.norm(moved) < 0.1:
            return "the tool turns about itself", "the tool turning about itself the other way"
        return (
            f"the tip swings {_way(moved)}, {size.format(arc * float(np.linalg.norm(moved)))}",
            f"the tip swinging {_way(-moved)}",
        )
    moves = [(np.cross(spin, np.array(edge)), name) for edge, name in EDGES]
    upright = [move for move in moves if abs(move[0][2]) > 0.5]
    moved, name = upright[0] if upright else moves[0]
    flat = np.where(np.arange(3) == 2, moved, 0.0) if upright else moved
    return (
        f"its {name} edge goes {_way(flat)}, {size.format(arc * float(np.abs(flat).max()))}",
        f"its {name} edge going {_way(-flat)}",
    )
