# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a vismach model in their places with every joint at zero, each with the joints that carry it.

pin      a part that moves by a pin moves with a joint, with the tool's length, or stands where the pin's
         number has it: :class:`Meaning` says which.
place    4x4, in the model's own units and frame.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Number, say

from .vismach_file import Model
from .vismach_parts import Listing, Part, Unread

MOST = 20_000
"""Parts that are looked at, one that stands in several places in each of them."""
GROUPS = ("Collection", "Color")
SAME = 1e-6
"""How far a number may be from the one that it should be."""


class Meaning(NamedTuple):
    """What a pin says: the ``letter`` of its axis; else ``tool``: whether it is the tool's length; else its
    ``number``, or the ``problem`` why that is not known."""

    letter: str = ""
    tool: bool = False
    number: float = 0.0
    problem: str = ""


@dataclass(frozen=True, eq=False)
class Joint:
    """``direction`` (3,) unit, in which a positive joint moves what it carries or about which it turns that;
    ``point`` (3,) of a rotary one's line."""

    letter: str
    line: int
    direction: Floats
    point: Floats


class Placed(NamedTuple):
    """A part, the ``name`` that the script gives it or what holds it, its ``place`` 4x4, the ``path`` of
    joints from the base, and whether it is part of the ``tool``."""

    part: Any
    name: str
    place: Floats
    path: tuple[Joint, ...]
    tool: bool = False
    line: int = 1
    """Of the script, where what holds it is made."""


@dataclass
class Tree:
    """All that the model shows: its ``shapes``, the captures, and why what is ``left`` out is."""

    shapes: list[Placed] = field(default_factory=list)
    tip: Placed | None = None
    work: Placed | None = None
    left: list[tuple[int, str]] = field(default_factory=list)
    """Lines of the script, and why."""
    full: bool = False
    """Whether it has more parts than are looked at."""


def grow(model: Model, meaning: Callable[[str], Meaning], degrees: float) -> Tree:
    """Walk the model; ``meaning`` of a pin by its whole name; ``degrees``: how many a rotary joint's unit
    has."""
    tree, waiting = Tree(), [Placed(model.root, "", np.eye(4), ())]
    for _ in range(MOST):
        if not waiting:
            return tree
        one = waiting.pop()
        waiting += list(_inside(tree, one, model, meaning, degrees))[::-1]
    tree.full = True
    return tree


def _inside(
    tree: Tree, one: Placed, model: Model, meaning: Callable[[str], Meaning], degrees: float
) -> Iterator[Placed]:
    """Give what stands in a part, each in its place; a shape or a capture goes into the tree, and what cannot
    be read into what is left out."""
    part = one.part
    if not isinstance(part, Part):
        line, text = (part.line, part.text) if isinstance(part, Unread) else (one.line, repr(part)[:40])
        tree.left.append((line, text))
        return
    if spoilt := part.spoilt or _spoilt(part.given.get("parts")):
        tree.left.append(
            (part.line, say("{text}, which line {line} may have changed", text=part.text, line=spoilt))
        )
        return
    one = one._replace(name=part.label or one.name)
    if part is model.tip or part is model.work:
        tree.tip, tree.work = (
            (one if part is model.tip else tree.tip),
            (one if part is model.work else tree.work),
        )
    elif "parts" in part.given:
        moved = _place_moved(one, meaning, degrees)
        if isinstance(moved, Placed):
            yield from (moved._replace(part=item, line=part.line) for item in part.given["parts"].items)
        else:
            tree.left.append((part.line, moved))
    elif part.kind != "Capture":
        tree.shapes.append(one)


def _spoilt(parts: Any) -> int:
    return parts.spoilt if isinstance(parts, Listing) else 0


def _place_moved(one: Placed, meaning: Callable[[str], Meaning], degrees: float) -> Placed | str:
    """Return what is in a part as that places and carries it, or why that cannot be said."""
    part: Part = one.part
    if part.kind in GROUPS:
        return one
    if part.kind == "Translate":
        return _set(one, shift(part.numbers("x", "y", "z")))
    if part.kind == "Rotate":
        return _turn_part(one, part.given["th"])
    if part.kind == "HalVectorTranslate":
        return _by_pins(one, meaning)
    pin = meaning(part.given["var"])
    if pin.problem:
        return say("{text}: {problem}", text=part.text, problem=pin.problem)
    if pin.letter:
        return _carry_by_axis(one, pin.letter, degrees)
    if part.kind == "HalRotate":
        return _turn_part(one, part.given["th"] * pin.number)
    by = [pin.number * number for number in part.numbers("x", "y", "z")]
    return _set(one, shift(by))._replace(tool=one.tool or pin.tool)


def _by_pins(one: Placed, meaning: Callable[[str], Meaning]) -> Placed | str:
    part: Part = one.part
    pins = [part.given[name] for name in ("xvar", "yvar", "zvar")]
    found = [meaning(pin) if isinstance(pin, str) else Meaning() for pin in pins]
    if bad := next((pin for pin in found if pin.problem or pin.letter or pin.tool), None):
        return say("{text}: {problem}", text=part.text, problem=bad.problem or bad.letter or say("tool"))
    return _set(one, shift([part.given["scale"] * pin.number for pin in found]))


def _carry_by_axis(one: Placed, letter: str, degrees: float) -> Placed | str:
    """Add the joint of a part that moves by an axis, where it moves as much as the axis does."""
    part: Part = one.part
    vector, rotary = np.array(part.numbers("x", "y", "z")), part.kind == "HalRotate"
    length = float(np.linalg.norm(vector))
    gain = part.given["th"] / degrees if rotary else length
    if rotary != (letter in "ABC") or not abs(abs(gain) - 1.0) <= SAME or not SAME < length < math.inf:
        return say("{text} moves by {gain} times {letter}", text=part.text, gain=Number(gain), letter=letter)
    direction = one.place[:3, :3] @ vector * (math.copysign(1.0, gain) / length)
    joint = Joint(letter, part.line, direction + 0.0, one.place[:3, 3])
    return one._replace(path=(*one.path, joint))


def _turn_part(one: Placed, degrees: float) -> Placed | str:
    part: Part = one.part
    axis = np.array(part.numbers("x", "y", "z"))
    length = float(np.linalg.norm(axis))
    if not SAME < length < math.inf or not math.isfinite(degrees):
        return say("{text} turns about no direction, or by no angle", text=part.text)
    return _set(one, turn(axis / length, degrees))


def _set(one: Placed, by: Floats) -> Placed:
    return one._replace(place=one.place @ by)


def shift(by: Sequence[float]) -> Floats:
    """Return the 4x4 of a shift."""
    found = np.eye(4)
    found[:3, 3] = by
    return found


def turn(axis: Floats, degrees: float) -> Floats:
    """Return the 4x4 of a right-handed turn about a unit ``axis`` (3,), exact for quarters."""
    quarters, found = degrees / 90.0, np.eye(4)
    cos, sin = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    if quarters == round(quarters):
        cos, sin = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(quarters) % 4]
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    found[:3, :3] = cos * np.eye(3) + sin * cross + (1.0 - cos) * np.outer(axis, axis)
    return found
