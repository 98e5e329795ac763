# SPDX-License-Identifier: LGPL-2.1-or-later
"""A controller dialect is a table; the writer, the reader and the feeds take from it all that differs between controllers.

head, tail   template lines before and after the blocks. Each template gives exactly one line, whatever its slots hold, so
             that the line of every block is known before anything is written.
slots        ``{title}`` a comment: what it is for; ``{program}`` the program number; ``{path}`` the path control mode;
             ``{offset}`` the work offset; ``{tool}``, ``{length}``, ``{spindle}``, ``{coolant}``; ``{feed_mode}``.
block        one line: block number, motion word, axis words, F word. The motion word stands in every block.
"""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass

from freecad_fiveaxis.core.errors import SettingsError
from freecad_fiveaxis.core.records import Bools, Floats

SLOTS = ("title", "program", "path", "offset", "tool", "length", "spindle", "coolant", "feed_mode")


@dataclass(frozen=True)
class Dialect:
    """One controller. ``description`` is one line for lists; ``convention`` says in prose how words and F are meant.

    ``linear_decimals``, ``rotary_decimals``: the step of a word, mm and degrees. ``feed_decimals``, ``inverse_decimals``: of
    F under G94 and under G93. ``largest_feed``, ``largest_inverse``: the largest F that the controller takes (mm/min or
    deg/min, 1/min); a block that would need more takes longer. ``rotary_in_feed``: how F is meant under G94 where linear and
    rotary axes move together: True: over all axes, a degree counted as a millimetre; False: over X Y Z alone. Where
    only rotary axes move, F is in degrees a minute in both.
    ``modal``: words that do not change are left out (never the motion word). ``order``: the order of the axis words.
    ``work_offsets``: the work offsets that the controller has, as a regular expression and in words for messages; the
    default is Fanuc's, whose basic machines have 48 of the additional ones.
    ``number_step``: blocks are numbered N10 N20 ... by this step, 0 for none, starting again after ``number_most``.
    """

    name: str
    description: str
    convention: str
    head: tuple[str, ...]
    tail: tuple[str, ...]
    rapid: str = "G0"
    straight: str = "G1"
    inverse_time: str = "G93"
    per_minute: str = "G94"
    linear_decimals: int = 4
    rotary_decimals: int = 4
    feed_decimals: int = 4
    inverse_decimals: int = 4
    largest_feed: float = 1e9
    largest_inverse: float = 1e9
    rotary_in_feed: bool = False
    modal: bool = True
    order: str = "XYZABC"
    number_step: int = 0
    number_most: int = 99_999_999
    comment: tuple[str, str] = ("(", ")")
    upper_case: bool = False
    line_length: int = 255
    newline: str = "\n"
    exact_path: str = ""
    blend_path: str = ""
    work_offset: str = "{offset}"
    work_offsets: tuple[str, str] = (
        r"G5[4-9]|G54\.1 ?P([1-9][0-9]?|[12][0-9]{2}|300)",
        "G54 to G59, or G54.1 P1 to G54.1 P300",
    )
    tool_call: str = "T{tool} M6"
    tool_length: str = "G43 H{tool}"
    spindle_on: str = "S{speed:.0f} M3"
    spindle_off: str = "M5"
    coolant_on: str = "M8"
    coolant_off: str = "M9"

    @property
    def first_line(self) -> int:
        """The line of block 0, counted from 1."""
        return len(self.head) + 1

    def decimals(self, column: int) -> int:
        """Decimals of word ``column`` (0 to 2 linear, 3 and 4 rotary)."""
        return self.linear_decimals if column < 3 else self.rotary_decimals

    def check_offset(self, offset: str) -> None:
        """Raises SettingsError, with those on offer, where the controller has no such work offset."""
        pattern, words = self.work_offsets
        if not re.fullmatch(pattern, offset):
            raise SettingsError(f"work offset {offset!r} is unknown to {self.name}; give {words}", offset)

    def remark(self, text: str) -> str:
        """A comment of printable ASCII that no controller takes for an instruction: no brackets, no ``;`` ``%`` or comma.

        (LinuxCNC acts on comments as ``(LOGOPEN,file)``.) Accents are dropped, other characters become ``-``.
        """
        plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode() or "-"
        plain = re.sub(r"[^A-Za-z0-9 .+=_/-]", "-", plain)[: self.line_length - 20]
        return self.comment[0] + (plain.upper() if self.upper_case else plain) + self.comment[1]


@dataclass(frozen=True)
class PostOptions:
    """What the head of a program says. ``tool`` number, None: the operator has set tool and length; ``speed`` of the spindle
    1/min, 0: off; ``coolant``; ``offset`` one of the dialect's ``work_offsets``; ``program`` number; ``blend`` mm: how far
    corners may be rounded, 0: exact path (where the controller has the choice)."""

    tool: int | None = None
    speed: float = 0.0
    coolant: bool = False
    offset: str = "G54"
    program: int = 1
    blend: float = 0.0

    def __post_init__(self) -> None:
        if self.tool is not None and not 0 < self.tool < 100_000:
            raise SettingsError(f"tool number is {self.tool}; give 1 to 99999", self.tool)
        if not 0.0 <= self.speed < 1e6:
            raise SettingsError(f"spindle speed is {self.speed:g} 1/min; give 0 to 999999", self.speed)
        if not re.fullmatch(r"G5[4-9](\.[1-9])?( ?P[0-9]{1,3})?", self.offset):
            raise SettingsError(
                f"work offset is {self.offset!r}; give G54 to G59, or another that the controller has", self.offset
            )
        if not 0 < self.program < 10_000:
            raise SettingsError(f"program number is {self.program}; give 1 to 9999", self.program)
        if not 0.0 <= self.blend < 1000.0:
            raise SettingsError(f"blend tolerance is {self.blend:g} mm; give 0 (exact path) to 999", self.blend)


def slot_texts(dialect: Dialect, title: str, options: PostOptions, inverse_time: bool) -> dict[str, str]:
    """The text of every slot. Raises SettingsError where the controller has no such work offset."""
    dialect.check_offset(options.offset)
    no_tool = dialect.remark("tool and length offset as the operator has set them")
    return {
        "title": dialect.remark(f"for {title}"),
        "program": f"{options.program:04d}",
        "path": dialect.blend_path.format(blend=f"{options.blend:.4f}") if options.blend > 0.0 else dialect.exact_path,
        "offset": dialect.work_offset.format(offset=options.offset),
        "tool": no_tool if options.tool is None else dialect.tool_call.format(tool=options.tool),
        "length": dialect.remark("no tool call") if options.tool is None else dialect.tool_length.format(tool=options.tool),
        "spindle": dialect.spindle_on.format(speed=options.speed) if options.speed > 0.0 else dialect.spindle_off,
        "coolant": dialect.coolant_on if options.coolant else dialect.coolant_off,
        "feed_mode": dialect.inverse_time if inverse_time else dialect.per_minute,
    }


def feed_distance(dialect: Dialect | None, change: Floats) -> Floats:
    """What F measures in each block under G94, mm or degrees, for ``change`` (n, 5) of the words, mm and degrees.

    Without a dialect: over X Y Z alone. NIST RS274NGC 3, 2.1.2.5, and LinuxCNC; Fanuc B-63324EN, 4.3 (see ``rotary_in_feed``).
    """
    linear = change[:, 0] ** 2 + change[:, 1] ** 2 + change[:, 2] ** 2
    rotary = change[:, 3] ** 2 + change[:, 4] ** 2
    if dialect is not None and dialect.rotary_in_feed:
        linear += rotary
    else:
        only_rotary: Bools = linear == 0.0
        linear[only_rotary] = rotary[only_rotary]
    distance: Floats = linear**0.5
    return distance
