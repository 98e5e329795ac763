# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of a draft's axes. Each gives a new draft; what depends on the change goes with it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from freecad_fiveaxis.core.machine import Vector
from freecad_fiveaxis.core.machine.model import LINEAR_LETTERS, ROTARY_LETTERS

from .draft import AxisDraft, MachineDraft

DIRECTIONS: dict[str, Vector] = {
    "X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0),
    "A": (1.0, 0.0, 0.0), "B": (0.0, 1.0, 0.0), "C": (0.0, 0.0, 1.0),
}  # fmt: skip
"""Along and about which the axes of these letters go."""
SIDES = ("table", "head")


def free_letters(draft: MachineDraft) -> tuple[str, ...]:
    """Return the letters that an axis to be added can have: no more than three linear and two rotary ones
    make a machine."""
    used = draft.letters()
    rotary = () if sum(letter in ROTARY_LETTERS for letter in used) > 1 else ROTARY_LETTERS
    return tuple(letter for letter in (*LINEAR_LETTERS, *rotary) if letter not in used)


def add_axis(draft: MachineDraft, letter: str) -> MachineDraft:
    """Add an axis without limits or rate: a rotary one next to the work, a linear one next to the tool."""
    rotary = letter in ROTARY_LETTERS
    new = AxisDraft(letter, rotary, "table" if rotary else "head", DIRECTIONS[letter])
    return replace(draft, axes=(new, *draft.axes) if rotary else (*draft.axes, new))


def remove_axis(draft: MachineDraft, at: int) -> MachineDraft:
    """Remove an axis; a body that it carried is an error until it gets another carrier."""
    return replace(draft, axes=(*draft.axes[:at], *draft.axes[at + 1 :]))


def move_axis(draft: MachineDraft, at: int, step: int) -> MachineDraft:
    """Move an axis by ``step`` (-1: towards the work, 1: towards the tool) past its neighbour on the same
    side; the same draft where there is none."""
    other = at + step
    if not 0 <= other < len(draft.axes) or draft.axes[at].side != draft.axes[other].side:
        return draft
    axes = list(draft.axes)
    axes[at], axes[other] = axes[other], axes[at]
    return replace(draft, axes=tuple(axes))


def change_axis(draft: MachineDraft, at: int, **changes: Any) -> MachineDraft:
    """Change values of an axis. A new letter says whether it is rotary, and bodies that it carries go with
    it; on a new side the axis stands next to the base."""
    before = draft.axes[at]
    after = replace(before, **changes)
    letter = after.letter
    if letter != before.letter:
        after = replace(after, rotary=letter in ROTARY_LETTERS)
    axes = (*draft.axes[:at], after, *draft.axes[at + 1 :])
    bodies = tuple(
        replace(body, carrier=letter) if body.carrier == before.letter else body for body in draft.bodies
    )
    return replace(draft, axes=tuple(sorted(axes, key=lambda axis: SIDES.index(axis.side))), bodies=bodies)
