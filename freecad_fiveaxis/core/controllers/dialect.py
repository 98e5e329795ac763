# SPDX-License-Identifier: LGPL-2.1-or-later
"""A controller dialect is a table; the writer, the reader and the feeds take from it all that differs between
controllers.

head, tail   template lines before and after the blocks. Each template gives exactly one line, whatever its
             slots hold, so that the line of every block is known before anything is written.
slots        see :mod:`~freecad_fiveaxis.core.nc.head`.
block        one line: block number, motion word, axis words, F word. The motion word stands in every block.
guide        the controller guides the tip (RTCP, TCPC, TCPM, TRAORI): X Y Z are then the tip's place on the
             part, and the tool axis is given by the rotary words (``angles``) or by its vector (``vectors``).
joint output the words are where the axes stand; the controller moves all of them evenly.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.rapids import UNKNOWN
from freecad_fiveaxis.core.base.sentences import Choice, Option, Sentence, say

if TYPE_CHECKING:
    from freecad_fiveaxis.core.base.records import Floats

ANGLES, VECTORS = "angles", "vectors"
INCH = 25.4
"""mm."""


@dataclass(frozen=True)
class Guide:
    """How one controller is told to guide the tip. ``on``, ``off``: the lines that switch it, templates as in
    the head.

    ``vector``: the three words of the tool axis, tip to holder, in the work frame; None where the rotary
    words give it. ``vector_decimals`` of them. ``straight``: the motion word of all blocks, "" the dialect's
    own. ``rotary_in_feed``: as in Dialect, but over the tip's way. ``needs_tool``: the switch names the
    number of the length offset. ``retract_first``: Z retracts before the guide is switched off, because that
    may drive Z by the tool's length.
    """

    on: tuple[str, ...]
    off: tuple[str, ...]
    vector: tuple[str, str, str] | None = None
    vector_decimals: int = 7
    straight: str = ""
    rotary_in_feed: bool = False
    needs_tool: bool = False
    retract_first: bool = False


@dataclass(frozen=True)
class Dialect:
    """One controller. ``description`` is one line for lists; ``convention`` says in prose how words and F are
    meant.

    ``language``: whose grammar the text follows: ``iso``, ``siemens`` or ``heidenhain``.
    ``head``, ``tail``: joint output. ``guided_head``, ``guided_tail``: with the tip guided; the lines
    ``{guide}`` stand for the guide's. ``guides``: by name, :data:`ANGLES` or :data:`VECTORS`; ``guide``: the
    one in force, None for joint output. ``linear_decimals``, ``rotary_decimals``: the step of a word, mm and
    degrees. ``feed_decimals``, ``inverse_decimals``: of F under G94 and under G93. ``largest_feed``,
    ``largest_inverse``: the largest F that the controller takes (mm/min or deg/min, 1/min); a block that
    would need more takes longer. ``rotary_in_feed``: how F is meant under G94 where linear and rotary axes
    move together: True: over all axes, a degree counted as a millimetre; False: over X Y Z alone. Where only
    rotary axes move, F is in degrees a minute in both. ``inverse_time``: "" where the controller has none.
    ``rapid_end``: what ends a block in rapid (Heidenhain's FMAX). ``plus``: positive numbers have their sign.
    ``modal``: words that do not change are left out (never the motion word). ``order``: the order of the axis
    words. ``work_offsets``: the work offsets that the controller has, as a regular expression and in words
    for messages; the default is Fanuc's, whose basic machines have 48 of the additional ones.
    ``number_step``: blocks are numbered by this step, after ``number_letter``, 0 for none, starting again
    after ``number_most``; ``number_all``: every line is, head and tail too, from 0 on. ``least_increment``: a
    word without a decimal point counts the least increment, if the controller is set so. ``shorter_way``: the
    controller takes a rotary word of 0 to 360 by the shorter way, where the machine file says ``modulo``;
    ``shorter_on``, ``shorter_off``: the line that tells it so, or not; ``shorter_word``: what stands before
    and after the number. ``high_speed``: lines that switch the high-speed mode on and off, empty where there
    is none. ``metric``, ``absolute``: the words of the head for its units, mm, and for absolute words;
    ``inch``: for inches, "" where such programs are not written, and ``inch_decimals`` of their linear words.
    ``unit``: the mm that linear words and F count. In inches a degree counts in F, where it is measured over
    all axes, as much as ``inch_degree`` mm (Fanuc: as an inch), and F of rotary axes alone is in inches too
    where ``inch_turns`` (grbl), else in degrees.
    ``machine_retract``: the lines that drive Z to the machine coordinate ``{z}``; ``reference_return``: those
    that drive it to its reference point (:mod:`~freecad_fiveaxis.core.nc.start`). ``speed_call``: the line
    that sets the speed where no tool is called, if it is not the spindle's. ``suffix``: how the names of its
    NC files end. ``rapids``: how it drives its axes in a rapid, one of
    :data:`~freecad_fiveaxis.core.base.rapids.RAPIDS`; the module of each controller names its source.
    """

    name: str
    description: str
    convention: str
    head: tuple[str, ...]
    tail: tuple[str, ...]
    suffix: str = ".nc"
    guided_head: tuple[str, ...] = ()
    guided_tail: tuple[str, ...] = ()
    guides: Mapping[str, Guide] = field(default_factory=dict)
    guide: Guide | None = None
    language: str = "iso"
    rapid: str = "G0"
    straight: str = "G1"
    rapid_end: str = ""
    rapids: str = UNKNOWN
    inverse_time: str = "G93"
    per_minute: str = "G94"
    metric: str = "G21"
    inch: str = "G20"
    inch_decimals: int = 5
    inch_degree: float = 1.0
    inch_turns: bool = False
    unit: float = 1.0
    absolute: str = "G90"
    linear_decimals: int = 4
    rotary_decimals: int = 4
    feed_decimals: int = 4
    inverse_decimals: int = 4
    largest_feed: float = 1e9
    largest_inverse: float = 1e9
    rotary_in_feed: bool = False
    plus: bool = False
    modal: bool = True
    order: str = "XYZABC"
    number_step: int = 0
    number_most: int = 99_999_999
    number_letter: str = "N"
    number_all: bool = False
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
    least_increment: bool = False
    shorter_way: bool = False
    shorter_on: str = ""
    shorter_off: str = ""
    shorter_word: tuple[str, str] = ("", "")
    high_speed: tuple[tuple[str, ...], tuple[str, ...]] = ((), ())
    machine_retract: tuple[str, ...] = ("G53 G0 Z{z}",)
    reference_return: tuple[str, ...] = ("G28 G91 Z0", "G90")
    tool_call: str = "T{tool} M6"
    tool_length: str = "G43 H{tool}"
    speed_call: str = ""
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

    def round_word(self, values: Floats, column: int) -> Floats:
        """Return the words nearest to ``values`` of ``column``, mm or degrees, that the controller can be
        given."""
        from freecad_fiveaxis.core.base.number_text import round_as_printed

        return round_as_printed(values, self.decimals(column), self.unit if column < 3 else 1.0)

    def length_text(self, value: float, decimals: int) -> str:
        """Return a length, mm, as a number of the program: in mm with ``decimals``, in inches with one
        more."""
        return f"{value / self.unit:.{decimals + (self.unit != 1.0)}f}"

    def in_inches(self) -> Dialect:
        """Return the same controller with programs in inches. Raises SettingsError where none are written for
        it."""
        if not self.inch:
            raise SettingsError(
                say(
                    "programs for {name} are in mm, also on a control that shows inches; leave {option} out",
                    name=self.name,
                    option=Option("nc_units"),
                ),
                self.name,
            )
        head, tail, guided_head, guided_tail = (
            tuple(re.sub(rf"\b{self.metric}\b", self.inch, line) for line in lines)
            for lines in (self.head, self.tail, self.guided_head, self.guided_tail)
        )
        return replace(
            self, head=head, tail=tail, guided_head=guided_head, guided_tail=guided_tail, metric=self.inch,
            linear_decimals=self.inch_decimals, unit=INCH, largest_feed=self.largest_feed / INCH,
        )  # fmt: skip

    def find_feed_units(self, change: Floats) -> Floats:
        """Return the mm (n,) that F counts in blocks that change the words by ``change`` (n, 5), 1.0 where it
        counts degrees."""
        import numpy as np

        turns_alone = ~change[:, :3].any(axis=1) & (not self.inch_turns)
        return np.where(turns_alone, 1.0, self.unit)

    def guide_by(self, how: str) -> Dialect:
        """Return the same controller with the tip guided by it, ``how`` one of the names of ``guides``.
        Raises SettingsError."""
        if how not in self.guides:
            raise SettingsError(self._no_guide(how), how)
        guide = self.guides[how]
        return replace(
            self, guide=guide, head=_with(_with(self.guided_head, guide.off, "{guide_off}"), guide.on),
            tail=_with(self.guided_tail, guide.off),
            rotary_in_feed=guide.rotary_in_feed, rapid=guide.straight or self.rapid,
            straight=guide.straight or self.straight,
        )  # fmt: skip

    def _no_guide(self, how: str) -> Sentence:
        if not self.guides:
            return say(
                "{name} does not guide the tip itself (no RTCP): leave {rtcp} out, and use {linearize}",
                name=self.name,
                rtcp=Option("rtcp"),
                linearize=Choice("linearize", ("on",), flag=True),
            )
        return say(
            "{name} has no RTCP by {how}; give {guides}",
            name=self.name,
            how=how,
            guides=" or ".join(self.guides),
        )

    def fast(self) -> Dialect:
        """Return the same controller in its high-speed mode, which stands before a guide. Raises
        SettingsError where it has none."""
        on, off = self.high_speed
        if not on:
            raise SettingsError(
                say(
                    "{name} has no high-speed mode to switch; leave {high_speed} out, or give {blend}",
                    name=self.name,
                    high_speed=Option("high_speed"),
                    blend=Option("blend"),
                ),
                self.name,
            )
        at, end = (lines.index("{guide}") if lines else 0 for lines in (self.guided_head, self.guided_tail))
        return replace(
            self, head=self.head + on, tail=off + self.tail,
            guided_head=self.guided_head[:at] + on + self.guided_head[at:],
            guided_tail=self.guided_tail[: end + 1] + off + self.guided_tail[end + 1 :],
        )  # fmt: skip

    def check_offset(self, offset: str) -> None:
        """Raise SettingsError, with those on offer, where the controller has no such work offset."""
        pattern, words = self.work_offsets
        if not re.fullmatch(pattern, offset):
            raise SettingsError(
                say(
                    "work offset {offset} is unknown to {name}; give {words}",
                    offset=repr(offset),
                    name=self.name,
                    words=words,
                ),
                offset,
            )

    def remark(self, text: str) -> str:
        """Return a comment of printable ASCII that no controller takes for an instruction: no brackets, no
        ``;`` ``%`` or comma.

        (LinuxCNC acts on comments as ``(LOGOPEN,file)``.) Accents are dropped, other characters become ``-``.
        """
        plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode() or "-"
        plain = re.sub(r"[^A-Za-z0-9 .+=_/-]", "-", plain)[: self.line_length - 20]
        return self.comment[0] + (plain.upper() if self.upper_case else plain) + self.comment[1]


def _with(lines: tuple[str, ...], guide: tuple[str, ...], slot: str = "{guide}") -> tuple[str, ...]:
    """Return the lines with those of a guide for ``slot``."""
    return tuple(one for line in lines for one in (guide if line == slot else (line,)))


def feed_distance(dialect: Dialect | None, change: Floats) -> Floats:
    """Return what F measures in each block under G94, mm or degrees, for ``change`` (n, 5) of the words, mm
    and degrees.

    Without a dialect: over X Y Z alone. NIST RS274NGC 3, 2.1.2.5, and LinuxCNC; Fanuc B-63324EN, 4.3 (see
    ``rotary_in_feed``).
    """
    import numpy as np

    square: Floats = change[:, 0] * change[:, 0]
    for k in (1, 2):
        square += change[:, k] * change[:, k]
    rows = slice(None) if dialect is not None and dialect.rotary_in_feed else np.flatnonzero(square == 0.0)
    turn = (change[rows, 3:] ** 2).sum(axis=1)
    if dialect is not None and dialect.unit != 1.0:
        turn *= np.where(square[rows] > 0.0, dialect.inch_degree**2, 1.0)
    square[rows] += turn
    return np.sqrt(square, out=square)
