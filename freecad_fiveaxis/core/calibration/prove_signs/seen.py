# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves in the words of somebody who stands in front of the machine.

right  +X of the machine; back  +Y, away from the operator; up  +Z. A machine that stands otherwise is looked
       at from where this is so; the sheet says it at its head.
turn   a positive rotary word turns the **tool relative to the work** right-handed about the axis' direction
       (ISO 841). A head does that itself; a table turns the part the other way.
size   of a turn: what a place 100 mm away from the axis, square to it, moves in the direction that is told.
       Of an axis that leans the tip is not as far off as it is below the pivot.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Angle, Length, Sentence, join_sentences, say
from freecad_fiveaxis.core.machine import Axis

VIEWS = (
    ((0.0, 0.0, 1.0), say("from above")),
    ((0.0, -1.0, 0.0), say("from the front")),
    ((1.0, 0.0, 0.0), say("from the right")),
)
EDGES = (((0.0, -1.0, 0.0), say("front")), ((1.0, 0.0, 0.0), say("right")))
WAYS = (
    (say("to the left"), say("to the right")),
    (say("to the front"), say("to the back")),
    (say("down"), say("up")),
)
ARM = 100.0
"""mm from the axis where the size of a turn is said."""
BELOW = np.array([0.0, 0.0, -1.0])
NEAR = 10.0
"""mm: nearer than that to the axis nobody sees the tip swing; then the way is told of one straight below."""


def linear_seen(axis: Axis, travel: float) -> tuple[str, str]:
    """Return what must be seen when the word of a linear axis grows by ``travel`` mm, and what a wrong sign
    looks like."""
    moved = np.array(axis.direction) * travel
    right, wrong = _way(moved), _way(-moved)
    if axis.side == "head":
        text = say(
            "Only {letter} moves: the tool goes {right} by {travel}, the table rests.",
            letter=axis.letter,
            right=right,
            travel=Length(abs(travel)),
        )
        return text, say(
            "The tool goes {wrong}: {letter} has the wrong sign.", wrong=wrong, letter=axis.letter
        )
    text = say(
        "Only {letter} moves: the table goes {wrong} by {travel}; the tool, seen from the part, goes "
        "{right}.",
        letter=axis.letter,
        wrong=wrong,
        travel=Length(abs(travel)),
        right=right,
    )
    return text, say("The table goes {right}: {letter} has the wrong sign.", right=right, letter=axis.letter)


def rotary_seen(axis: Axis, other: str, angle: float, hanging: Floats = BELOW) -> tuple[str, str]:
    """Return the same for the word of a rotary axis turned to ``angle`` rad; ``other``: the letter of the
    other rotary axis; ``hanging`` (3,) mm: the tip of a head, tool upright, from a point of the
    axis."""
    spin = np.array(axis.direction) * math.copysign(1.0, angle) * (1.0 if axis.side == "head" else -1.0)
    degrees = Angle(math.degrees(abs(angle)))
    view, right, wrong = _view(spin)
    what = say("table") if axis.side == "table" else say("head")
    mark, opposite = _mark(spin, abs(angle), axis.side, hanging)
    text = say(
        "Only {letter} turns: the {what} turns {right} by {degrees}, seen {view}; {mark}.",
        letter=axis.letter,
        what=what,
        right=right,
        degrees=degrees,
        view=view,
        mark=mark,
    )
    bad = say(
        "The {what} turns {wrong}, {opposite}: {letter} has the wrong sign. Another axis turns: it is not "
        "{letter} (if it is {other}, the two letters are exchanged).",
        what=what,
        wrong=wrong,
        opposite=opposite,
        letter=axis.letter,
        other=other,
    )
    return text, bad


def _way(moved: Floats) -> Sentence:
    """Return the directions of a move, the largest first, small ones left out."""
    size = np.abs(moved)
    parts = [k for k in np.argsort(-size, kind="stable").tolist() if size[k] > 0.1 * size.max()]
    ways = [WAYS[k][int(moved[k] > 0.0)] for k in parts]
    return (
        say("{one} and {other}", one=join_sentences(ways[:-1], ", "), other=ways[-1])
        if len(ways) > 1
        else ways[0]
    )


def _view(spin: Floats) -> tuple[Sentence, Sentence, Sentence]:
    """From where to look, and the sense of the turn seen from there, right and wrong."""
    along = [abs(float(spin @ np.array(view))) for view, _ in VIEWS]
    best = int(np.argmax(along))
    towards = float(spin @ np.array(VIEWS[best][0])) > 0.0
    senses = (say("clockwise"), say("counter-clockwise"))
    lean = "" if along[best] > 0.999 else say(" (along the axis, which leans)")
    return VIEWS[best][1] + lean, senses[int(towards)], senses[int(not towards)]


def _swing(spin: Floats, hanging: Floats) -> Floats | None:
    """Return where the tip goes (3,), of any length, as it hangs (3,) mm from a point of the axis; None where
    the tool turns about itself."""
    moved = np.cross(spin, hanging)
    if np.linalg.norm(moved) < NEAR:
        moved = np.cross(spin, BELOW)
    return None if np.linalg.norm(moved) < 0.1 else np.asarray(moved)


def _mark(spin: Floats, angle: float, side: str, hanging: Floats) -> tuple[Sentence, Sentence]:
    """Return a place to watch and where it goes, by how much; and where it goes with the wrong sign."""
    arc = ARM * math.sin(angle)
    if side == "head":
        moved = _swing(spin, hanging)
        if moved is None:
            return say("the tool turns about itself"), say("the tool turning about itself the other way")
        return say("the tip swings {way}, {size}", way=_way(moved), size=_size(arc)), say(
            "the tip swinging {way}", way=_way(-moved)
        )
    moves = [(np.cross(spin, np.array(edge)), name) for edge, name in EDGES]
    upright = [move for move in moves if abs(move[0][2]) > 0.5]
    moved, name = upright[0] if upright else moves[0]
    flat = np.where(np.arange(3) == 2, moved, 0.0) if upright else moved
    size = _size(arc * float(np.abs(flat).max() / np.linalg.norm(moved)))
    return (
        say("its {edge} edge goes {way}, {size}", edge=name, way=_way(flat), size=size),
        say("its {edge} edge going {way}", edge=name, way=_way(-flat)),
    )


def _size(travel: float) -> Sentence:
    return say("{travel} for each {arm} from the axis", travel=Length(travel, ".1f"), arm=Length(ARM))
