# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a tool sticks out of its holder, and the same tool clamped shorter or longer.

stick-out   from the tip up to the lower face of the holder, mm: the length of the cutter, and of the shank
            that is given over it. Holder and spindle stand so far above the tip.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import Length, say

from .body import LARGEST, Body, body_of
from .cutter import LEAST, Cutter

Cylinder = tuple[float, float]
"""Diameter and length, mm."""

LONGER_BY = (10.0, 20.0, 40.0, 80.0)
"""mm by which a tool may stick out farther, the least first: what is tried where it is too short."""

SHORTEST_STEM = 0.1
"""mm that a cutter has at least over its rounded end, its largest diameter, or of its neck."""


class Stack(NamedTuple):
    """The tool as options state it: ``cutter``, and the cylinders of ``shank`` and ``holder`` over it."""

    cutter: Cutter
    shank: tuple[Cylinder, ...] = ()
    holder: tuple[Cylinder, ...] = ()

    @property
    def stick_out(self) -> float:
        """How far the tool sticks out of its holder, mm."""
        return max(self.cutter.length, self.cutter.corner) + sum(length for _, length in self.shank)

    @property
    def shortest(self) -> float:
        """It cannot be clamped shorter, mm: only its rounded end, its largest diameter or its ball would
        look out."""
        cutter = self.cutter
        ends = (cutter.corner, *(row[0] for row in cutter.stem))
        rise = 0.0 if cutter.barrel is None else cutter.barrel.rise
        return min(max(ends) + rise + SHORTEST_STEM, self.stick_out)

    @property
    def body(self) -> Body:
        """The pieces of all of it."""
        return body_of(self.cutter, self.shank, self.holder)


def clamp_tool(stack: Stack, length: float) -> Stack:
    """Let the tool stick out ``length`` mm of its holder. What is too much goes into the holder: of the shank
    from above, then of the cutter. What is wanting is shank, as wide as the uppermost there is, else as the
    cutter's upper end. Raises SettingsError for a length below its shortest one, or above LARGEST."""
    more = length - stack.stick_out
    if not stack.shortest - LEAST <= length <= LARGEST:
        text = say(
            "a stick-out of {length} is not between {least} and {most}",
            length=Length(length), least=Length(stack.shortest, bare=True), most=Length(LARGEST),
        )  # fmt: skip
        raise SettingsError(text, length)
    if more > 0.0:
        *below, top = stack.shank or ((2.0 * stack.cutter.top_radius, 0.0),)
        return stack._replace(shank=(*below, (top[0], top[1] + more)))
    shank, left = _shorten_shank(stack.shank, -more)
    cutter = stack.cutter if left <= 0.0 else replace(stack.cutter, length=stack.cutter.length - left)
    return stack._replace(cutter=cutter, shank=shank)


def _shorten_shank(shank: Iterable[Cylinder], by: float) -> tuple[tuple[Cylinder, ...], float]:
    """Return the shank without its upper ``by`` mm, and what of these it has not."""
    kept = list[Cylinder]()
    for diameter, length in reversed(tuple(shank)):
        off = min(by, length)
        by -= off
        if length - off > LEAST:
            kept.append((diameter, length - off))
    return tuple(reversed(kept)), by if math.fabs(by) > LEAST else 0.0
