# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a program comes to its first block, and leaves the part at its end: never with all axes at once.

retract   Z up, as the machine file says (``safe_start``): to a machine coordinate, to its reference point, or
          to a plane above the part. The first two stand before the tool call, the plane after it, because it
          needs the tool's length.
rotaries  both rotary axes to where the first block wants them, the tip not yet guided.
over      X and Y to where the first block wants them. Block 0 then only drives Z.
tip       where all table axes turn about Z, X and Y of a guided program are told with the tip guided: they
          then do not depend on the tool's length. Elsewhere Z of the work leans with the table, so X and Y
          are driven before the switch.

Templates as in :mod:`.head`: ``{height}``, ``{rotaries}``, ``{over}``, ``{over_tip}``, ``{cutter}``;
``{guide_off}`` are the lines that end a guide, which may still be on from another program. Where the
controller may drive Z by the tool's length in them (Fanuc), Z retracts before and after.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.number_text import round_as_printed
from freecad_fiveaxis.core.controllers.dialect import Dialect
from freecad_fiveaxis.core.machine import (
    BY_CLEARANCE,
    BY_NOTHING,
    BY_REFERENCE,
    SafeStart,
    find_physical_columns,
)
from freecad_fiveaxis.core.motion.program import Program

UPRIGHT = 1e-9
"""A table axis whose direction is that near to Z keeps X and Y level."""


def with_start(dialect: Dialect, start: SafeStart, over_by_tip: bool = False, turns: bool = True) -> Dialect:
    """Return the dialect with the lines of a safe start and end, of joint output and of guided, and the line
    that names the cutter. ``turns``: the machine has rotary axes.

    ``over_by_tip``: as ``tip`` above. A guide that gives the tool's length itself leaves no way to a plane
    above the part before it: there the reference point is taken instead."""
    named = replace(dialect, head=_name_cutter(dialect.head), guided_head=_name_cutter(dialect.guided_head))
    if start.retract == BY_NOTHING:
        return named
    guided = SafeStart(BY_REFERENCE) if by_reference(dialect, start) else start
    return replace(
        named, head=_joint_head(named, start, turns), tail=(*_retract(dialect, start), *dialect.tail),
        guided_head=_build_guided_head(named, guided, over_by_tip),
        guided_tail=_build_guided_tail(dialect, guided),
    )  # fmt: skip


def by_reference(dialect: Dialect, start: SafeStart) -> bool:
    """Whether a guided program retracts to the reference point though a plane above the part is asked for."""
    return start.retract == BY_CLEARANCE and any(guide.needs_tool for guide in dialect.guides.values())


def _name_cutter(head: tuple[str, ...]) -> tuple[str, ...]:
    """Return the head with the line that names the cutter, after the title."""
    at = next((k for k, line in enumerate(head) if "{title}" in line), -1) + 1
    return (*head[:at], "{cutter}", *head[at:]) if head else head


def _rapid(dialect: Dialect, slot: str) -> str:
    return f"{dialect.rapid} {{{slot}}}{dialect.rapid_end}"


def _retract(dialect: Dialect, start: SafeStart) -> tuple[str, ...]:
    if start.retract == BY_REFERENCE:
        return dialect.reference_return
    if start.z is not None:
        z = _length(start.z, dialect)
        return tuple(line.format(z=z) for line in dialect.machine_retract)
    return (_rapid(dialect, "height"),)


def _before_tool(head: tuple[str, ...], lines: tuple[str, ...]) -> tuple[str, ...]:
    at = head.index("{tool}")
    return (*head[:at], *lines, *head[at:])


def _joint_head(dialect: Dialect, start: SafeStart, turns: bool) -> tuple[str, ...]:
    retract, turn = (
        _retract(dialect, start),
        (*((_rapid(dialect, "rotaries"),) if turns else ()), _rapid(dialect, "over")),
    )
    if start.retract == BY_CLEARANCE:
        return (*dialect.head, *retract, *turn)
    return (*_before_tool(dialect.head, retract), *turn)


def _build_guided_head(dialect: Dialect, start: SafeStart, over_by_tip: bool) -> tuple[str, ...]:
    head, retract = dialect.guided_head, _retract(dialect, start)
    if not head:
        return head
    early = () if start.retract == BY_CLEARANCE else retract
    head = _before_tool(head, (*_first_retract(dialect, early), "{guide_off}", *early))
    at = head.index("{guide}")
    offset = () if "{offset}" in head[:at] else ("{offset}",)
    before = (*offset, *(retract if start.retract == BY_CLEARANCE else ()), _rapid(dialect, "rotaries"))
    if over_by_tip:
        after = next((k for k, line in enumerate(head) if k > at and line == "{offset}"), at) + 1
        return (*head[:at], *before, *head[at:after], _rapid(dialect, "over_tip"), *head[after:])
    return (*head[:at], *before, _rapid(dialect, "over"), *head[at:])


def _build_guided_tail(dialect: Dialect, start: SafeStart) -> tuple[str, ...]:
    tail, retract = dialect.guided_tail, _retract(dialect, start)
    at = tail.index("{guide}") if tail else 0
    return (*tail[:at], *_first_retract(dialect, retract), *tail[at : at + 1], *retract, *tail[at + 1 :])


def _first_retract(dialect: Dialect, lines: tuple[str, ...]) -> tuple[str, ...]:
    """Return the lines of the retract where it comes before the guide is switched off, too."""
    return lines if any(guide.retract_first for guide in dialect.guides.values()) else ()


def start_words(program: Program, dialect: Dialect, height: float) -> dict[str, str]:
    """Return the words of the start's slots: those of block 0, and the ``height`` (mm, a word of Z) of the
    plane above the part."""
    first = program.words[0] if len(program.words) else np.zeros(5)
    tip = program.guided.tip[0] if len(program.words) and program.guided is not None else first
    order = sorted(
        find_physical_columns(program.letters)[3:],
        key=lambda column: dialect.order.index(program.letters[column]),
    )
    return {
        "height": "Z" + _length(height, dialect),
        "rotaries": " ".join(_rotary(program, dialect, column, float(first[column])) for column in order),
        "over": _level(dialect, float(first[0]), float(first[1])),
        "over_tip": _level(dialect, float(tip[0]), float(tip[1])),
    }


def _level(dialect: Dialect, x: float, y: float) -> str:
    return f"X{_length(x, dialect)} Y{_length(y, dialect)}"


def _rotary(program: Program, dialect: Dialect, column: int, value: float) -> str:
    fold = program.wrap[column - 3] == "modulo"
    before, after = dialect.shorter_word if fold else ("", "")
    number = _number(value % 360.0 if fold else value, dialect.rotary_decimals, dialect.plus)
    return f"{program.letters[column]}{before}{number}{after}"


def _length(value: float, dialect: Dialect) -> str:
    return _number(value / dialect.unit, dialect.linear_decimals, dialect.plus)


def _number(value: float, decimals: int, plus: bool) -> str:
    """As the writer prints it: never "-0.0000"."""
    near = float(round_as_printed(np.array([value]), decimals)[0]) + 0.0
    return f"{near:+.{decimals}f}" if plus else f"{near:.{decimals}f}"
