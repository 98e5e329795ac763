# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines before and after the blocks, from a dialect's templates.

slot   ``{title}`` a comment: what it is for; ``{program}`` the program number; ``{path}`` the path control
       mode; ``{offset}`` the work offset; ``{tool}``, ``{length}``, ``{spindle}``, ``{coolant}``;
       ``{feed_mode}``; ``{axes}`` the letters of the words with commas; ``{shorter}`` how rotary words are
       taken; ``{cutter}`` tool, cutter and length; the words of a safe start (:mod:`.start`); in a guide's
       and a high-speed mode's lines ``{number}``, the tool's number, and ``{tolerance}``, mm.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import Length, Number, Option, say
from freecad_fiveaxis.core.controllers.dialect import Dialect
from freecad_fiveaxis.core.machine import find_physical_columns

SLOTS = (
    "title", "program", "path", "offset", "tool", "length", "spindle", "coolant", "feed_mode", "axes",
    "shorter", "number",
    "tolerance", "cutter", "height", "rotaries", "over", "over_tip",
)  # fmt: skip
NO_START: Mapping[str, str] = MappingProxyType(dict.fromkeys(("height", "rotaries", "over", "over_tip"), ""))
USUAL_TOLERANCE = 0.01
"""mm, of the high-speed mode where no blend tolerance is asked for."""


@dataclass(frozen=True)
class PostOptions:
    """What the head of a program says. ``tool`` number, None: the operator has set tool and length; ``speed``
    of the spindle 1/min, 0: off; ``coolant``; ``offset`` one of the dialect's ``work_offsets``; ``program``
    number; ``blend`` mm: how far corners may be rounded, 0: exact path (where the controller has the choice).
    What the head names: ``cutter``, and the tool's ``length`` mm, None where that is not known."""

    tool: int | None = None
    speed: float = 0.0
    coolant: bool = False
    offset: str = "G54"
    program: int = 1
    blend: float = 0.0
    cutter: str = ""
    length: float | None = None

    def __post_init__(self) -> None:
        if self.tool is not None and not 0 < self.tool < 100_000:
            raise SettingsError(say("tool number is {tool}; give 1 to 99999", tool=self.tool), self.tool)
        if not 0.0 <= self.speed < 1e6:
            raise SettingsError(
                say("spindle speed is {speed} 1/min; give 0 to 999999", speed=Number(self.speed)), self.speed
            )
        if not re.fullmatch(r"G(5[4-9]|[15][0-9]{2})(\.[1-9])?( ?P[0-9]{1,3})?", self.offset):
            raise SettingsError(
                say(
                    "work offset is {offset}; give G54 to G59, or another that the controller has",
                    offset=repr(self.offset),
                ),
                self.offset,
            )
        if not 0 < self.program < 10_000:
            raise SettingsError(
                say("program number is {program}; give 1 to 9999", program=self.program), self.program
            )
        if not 0.0 <= self.blend < 1000.0:
            raise SettingsError(
                say("blend tolerance is {blend}; give 0 (exact path) to 999", blend=Length(self.blend)),
                self.blend,
            )


def slot_texts(
    dialect: Dialect, title: str, options: PostOptions, inverse_time: bool, letters: str = "XYZAC",
    modulo: bool = False,
    start: Mapping[str, str] = NO_START,
) -> dict[str, str]:  # fmt: skip
    """Return the text of every slot. ``letters`` of the words; ``modulo``: some rotary word is taken by the
    shorter way; ``start``: the words of a safe start.

    Raises SettingsError where the controller has no such work offset, or needs a tool number and there is
    none.
    """
    dialect.check_offset(options.offset)
    if dialect.guide is not None and dialect.guide.needs_tool and options.tool is None:
        switch = dialect.guide.on[0].split()[0]
        raise SettingsError(
            say(
                "{name}'s {switch} names the tool's length offset: give {tool}, its number",
                name=dialect.name,
                switch=switch,
                tool=Option("tool"),
            ),
            None,
        )
    return {
        "title": dialect.remark(f"for {title}"),
        "program": f"{options.program:04d}",
        "path": dialect.blend_path.format(blend=dialect.length_text(options.blend, 4))
        if options.blend > 0.0
        else dialect.exact_path,
        "offset": dialect.work_offset.format(offset=options.offset),
        "tool": _tool(dialect, options),
        "length": dialect.remark("no tool call")
        if options.tool is None
        else dialect.tool_length.format(tool=options.tool),
        "spindle": dialect.spindle_on.format(speed=options.speed)
        if options.speed > 0.0
        else dialect.spindle_off,
        "coolant": dialect.coolant_on if options.coolant else dialect.coolant_off,
        "feed_mode": dialect.inverse_time if inverse_time else dialect.per_minute,
        "axes": ",".join(
            sorted((letters[k] for k in find_physical_columns(letters)), key=dialect.order.index)
        ),
        "shorter": dialect.shorter_on if modulo else dialect.shorter_off,
        "number": "" if options.tool is None else str(options.tool),
        "tolerance": dialect.length_text(options.blend or USUAL_TOLERANCE, 4),
        "cutter": _cutter(dialect, options),
        **start,
    }


def _cutter(dialect: Dialect, options: PostOptions) -> str:
    """Return a comment as ``(T3 BALL 10 MM, L 120.000)``. Its commas are harmless: no instruction begins with
    a tool or a cutter."""
    number = "" if options.tool is None else f"T{options.tool} "
    unit = "" if dialect.unit == 1.0 else " IN"
    length = "" if options.length is None else f", L {dialect.length_text(options.length, 3)}{unit}"
    text = (number + (options.cutter or "cutter as the operator has set it") + length).upper()
    return dialect.comment[0] + text + dialect.comment[1]


def _tool(dialect: Dialect, options: PostOptions) -> str:
    if options.tool is not None:
        return dialect.tool_call.format(tool=options.tool, speed=options.speed)
    if dialect.speed_call and options.speed > 0.0:
        return dialect.speed_call.format(speed=options.speed)
    return dialect.remark("tool and length offset as the operator has set them")


def write_head_and_tail(dialect: Dialect, slots: dict[str, str], blocks: int) -> tuple[bytes, bytes]:
    """Return the text before and after the ``blocks`` lines of motion."""
    head, tail = ([line.format(**slots) for line in lines] for lines in (dialect.head, dialect.tail))
    if dialect.number_all:
        after = len(head) + blocks
        head = [_number_line(dialect, at, line) for at, line in enumerate(head)]
        tail = [_number_line(dialect, after + at, line) for at, line in enumerate(tail)]
    before, behind = (
        "".join(line + dialect.newline for line in lines).encode("ascii") for lines in (head, tail)
    )
    return before, behind


def renumber_lines(dialect: Dialect, lines: list[str]) -> list[str]:
    """Return the lines of a whole program, to which some without a number were added, with the numbers that
    the dialect wants on all."""
    if not dialect.number_all:
        return lines
    bare = re.compile(rf"^{dialect.number_letter}[0-9]+ ")
    return [_number_line(dialect, at, bare.sub("", line)) if line else line for at, line in enumerate(lines)]


def _number_line(dialect: Dialect, at: int, line: str) -> str:
    return f"{dialect.number_letter}{at % dialect.number_most * dialect.number_step} {line}"
