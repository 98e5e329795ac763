# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the statements between the moves say: each different text is read once, however often it stands in the
file.

meaning   what one such text says: a kind and its numbers. Meanings and where they stand make columns.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum, auto
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say

from . import vocabulary as words
from .arc_statements import circle_numbers
from .cycles import cycle_of
from .head import ClHead
from .source import SOFT, Source


class Kind(IntEnum):
    """Kinds of statements that are not moves."""

    NOTHING = 0
    LINK = auto()
    RAPID = auto()
    UNITS = auto()
    FEED = auto()
    SPINDLE = auto()
    COOLANT = auto()
    TOOL = auto()
    CUTTER = auto()
    NECK = auto()
    FLANK = auto()
    AXIS = auto()
    MULTAX = auto()
    FRAME = auto()
    CUTCOM = auto()
    LEAVING = auto()
    CIRCLE = auto()
    TANGENT = auto()
    CYCLE = auto()
    TOOLNO = auto()
    UNKNOWN = auto()


class Meaning(NamedTuple):
    """``value``: the number it says; ``unit``: mm of its unit, NaN the file's; ``more``: further numbers;
    ``turn``: a feed per turn of the spindle."""

    kind: Kind
    value: float = 0.0
    unit: float = np.nan
    more: tuple[float, ...] = ()
    turn: bool = False


@dataclass(frozen=True, eq=False)
class Statements:
    """One row a statement that is no move: ``statement`` its number, ``row`` the move that follows, ``which``
    text of ``texts`` (with ``meanings``) it is."""

    statement: Ints
    row: Ints
    which: Ints
    texts: list[str]
    meanings: list[Meaning]

    def of(self, kind: Kind) -> Ints:
        """Return the rows of that kind."""
        return np.flatnonzero(
            np.isin(self.which, [k for k, meaning in enumerate(self.meanings) if meaning.kind is kind])
        )

    def value(self, rows: Ints) -> Floats:
        """Return the numbers that these rows say."""
        return np.array([meaning.value for meaning in self.meanings] or [0.0])[self.which[rows]]

    def unit(self, rows: Ints) -> Floats:
        """Their units in mm, NaN where it is the file's."""
        return np.array([meaning.unit for meaning in self.meanings] or [0.0])[self.which[rows]]

    def turn(self, rows: Ints) -> Bools:
        """Which of them are feeds per turn."""
        return np.array([meaning.turn for meaning in self.meanings] or [False])[self.which[rows]]

    def first(self, rows: Ints) -> Meaning | None:
        """Return the meaning of the first of these rows."""
        return self.meanings[self.which[rows[0]]] if len(rows) else None


def read_statements(source: Source) -> Statements:
    """All statements that are no moves. Raises ProgramError, naming line and column, for one that must be
    known and is not."""
    at = np.flatnonzero(~source.moves)
    text = source.take_lines(source.begin[at], source.end[at]).tobytes().replace(SOFT, b"")
    every = text.split(b"\n")[: len(at)]
    number = {statement: k for k, statement in enumerate(dict.fromkeys(every))}
    which = np.fromiter(map(number.__getitem__, every), np.int64, len(every))
    texts, meanings = [statement.decode("latin-1") for statement in number], []
    for k, statement in enumerate(texts):
        meaning = meaning_of(statement)
        if isinstance(meaning, tuple) and not isinstance(meaning, Meaning):
            source.fail(int(at[which.tolist().index(k)]), *meaning)
        meanings.append(meaning)
    return Statements(at, source.moves_before[at], which, texts, meanings)


def meaning_of(statement: str) -> Meaning | tuple[str, str]:
    """Return what a statement says; or, where it cannot be read, the part that is wrong and why."""
    if statement.startswith("PPRINT/MOTION,"):
        return Meaning(Kind.LINK, float(statement == "PPRINT/MOTION,LINK"))
    for mark, kind in (("PPRINT/NECK,", Kind.NECK), ("PPRINT/FLANK,", Kind.FLANK)):
        if statement.startswith(mark):
            return _sizes(kind, statement.partition(",")[2])
    if statement.startswith(words.FREE_TEXT):
        return Meaning(Kind.NOTHING)
    name, _, rest = statement.partition("/")
    name = name.partition(",")[0]
    if name in READERS:
        return READERS[name](rest)
    if name in ("GOTO", "FROM", "GODLTA") or (name[:4] == "GOTO" and name[4:5] in "0123456789.+-"):
        return name[:4], say("a slash must follow the word, as in GOTO/1,2,3")
    if name in words.HARMLESS or statement in words.WITHOUT_EFFECT:
        return Meaning(Kind.NOTHING)
    if name in words.SHIFTS and not any(words.numbers_of(rest)):
        return Meaning(Kind.NOTHING)
    return Meaning(Kind.UNKNOWN)


def name_of(statement: str) -> str:
    """Return the word that a statement is called by in a finding."""
    if statement.startswith("CYCLE/"):
        return re.sub(r"(?<=/)([A-Z0-9]*).*", r"\1", statement)
    return re.sub(r"[^A-Z].*", "", statement) or statement[:20]


def _unit(rest: str) -> Meaning | tuple[str, str]:
    scale = words.UNITS.get(rest)
    return (
        (rest, say("unknown unit; known are MM and INCHES")) if scale is None else Meaning(Kind.UNITS, scale)
    )


def _feed(rest: str) -> Meaning | tuple[str, str]:
    """Return a unit of the statement's own goes before the file's."""
    parts = rest.split(",")
    numbers = words.numbers_of(rest)
    if len(numbers) != 1 or not 0.0 < numbers[0] < np.inf:
        return rest, say("FEDRAT needs one feed above 0")
    turn = next((part for part in parts if part in words.PER_TURN), None)
    own = (
        words.PER_TURN[turn]
        if turn
        else next((words.FEED_UNITS[part] for part in parts if part in words.FEED_UNITS), None)
    )
    return Meaning(Kind.FEED, numbers[0], np.nan if own is None else own, turn=turn is not None)


def _spindle(rest: str) -> Meaning:
    """Return turns a minute, 0 off; NaN where it goes on as before, or is said as a cutting speed."""
    numbers, parts = words.numbers_of(rest), rest.split(",")
    if "OFF" in parts:
        return Meaning(Kind.SPINDLE, 0.0)
    if not numbers or {"SFM", "SMM", "SURF", "MPM", "FPM"} & set(parts):
        return Meaning(Kind.SPINDLE, np.nan)
    return Meaning(Kind.SPINDLE, numbers[0])


def _coolant(rest: str) -> Meaning:
    return Meaning(Kind.COOLANT, float("OFF" not in rest.split(",")))


def _tool(rest: str) -> Meaning:
    numbers = words.numbers_of(rest)
    return Meaning(Kind.TOOL, numbers[0]) if numbers else Meaning(Kind.NOTHING)


def _load(rest: str) -> Meaning:
    return _tool(rest) if rest.startswith("TOOL") else Meaning(Kind.NOTHING)


def _cutter(rest: str) -> Meaning:
    numbers = words.numbers_of(rest)
    return Meaning(Kind.CUTTER, numbers[0], more=tuple(numbers[1:7])) if numbers else Meaning(Kind.NOTHING)


def _sizes(kind: Kind, rest: str) -> Meaning:
    """Read this program's marks: diameter and upper end of a lollipop's neck; radius and length of a barrel's
    flank. Anything else behind them is text."""
    numbers = words.numbers_of(rest)
    return Meaning(kind, more=tuple(numbers)) if len(numbers) == 2 else Meaning(Kind.NOTHING)


def _number_of_tool(rest: str) -> Meaning:
    return (
        _tool(rest)._replace(kind=Kind.TOOLNO)
        if words.NUMBER.fullmatch(rest.partition(",")[0])
        else Meaning(Kind.NOTHING)
    )


def _data(rest: str) -> Meaning:
    """NX: ``TLDATA/MILL, diameter, corner, length, taper, tip angle`` as the CUTTER statement of it; of a
    drill its diameter."""
    parts = rest.split(",")
    numbers = words.numbers_of(rest)
    if not numbers or parts[0] not in ("MILL", "DRILL"):
        return Meaning(Kind.NOTHING)
    if parts[0] == "DRILL" or len(numbers) < 5:
        return Meaning(Kind.CUTTER, numbers[0])
    diameter, corner, length, taper, tip = numbers[:5]
    return Meaning(Kind.CUTTER, diameter, more=(corner, np.nan, corner, tip, taper, length))


def _axis(rest: str) -> Meaning:
    parts = rest.split(",")
    if len(parts) == 3 and all(words.NUMBER.fullmatch(part) for part in parts):
        i, j, k = (float(part) for part in parts)
        if np.isfinite([i, j, k]).all():
            return Meaning(Kind.AXIS, more=(i, j, k))
    return Meaning(Kind.UNKNOWN)


def _work_plane(rest: str) -> Meaning:
    """CAMWorks: the rows of a matrix; its third column is the axis of the moves that follow, whose points it
    leaves alone."""
    parts = rest.split(",")
    if len(parts) != 12 or not all(words.NUMBER.fullmatch(part) for part in parts):
        return Meaning(Kind.UNKNOWN)
    i, j, k = (float(parts[at]) for at in (2, 6, 10))
    return (
        Meaning(Kind.AXIS, more=(i, j, k))
        if 0.0 < np.linalg.norm([i, j, k]) < np.inf
        else Meaning(Kind.UNKNOWN)
    )


def _circle(rest: str) -> Meaning:
    numbers = circle_numbers(rest)
    return Meaning(Kind.UNKNOWN) if numbers is None else Meaning(Kind.CIRCLE, more=numbers)


def _tangent(rest: str) -> Meaning:
    """Return what ``catia_arcs_apart`` has made."""
    numbers = words.numbers_of(rest)
    good = len(numbers) == 7 and float(np.abs(numbers).max()) <= words.LARGEST and numbers[6] > 0.0
    return Meaning(Kind.TANGENT, more=(*numbers, 0.0)) if good else Meaning(Kind.UNKNOWN)


def _cycle(rest: str) -> Meaning:
    if rest in ("OFF", "NOMORE"):
        return Meaning(Kind.NOTHING)
    if rest in words.LEAVING:
        return Meaning(Kind.LEAVING, words.LEAVING[rest])
    return Meaning(Kind.UNKNOWN if cycle_of(rest) is None else Kind.CYCLE)


def _compensation(rest: str) -> Meaning:
    side = rest.partition(",")[0]
    return Meaning(
        Kind.NOTHING if side == "OFF" else Kind.CUTCOM if side in ("LEFT", "RIGHT") else Kind.UNKNOWN
    )


READERS: dict[str, Callable[[str], Meaning | tuple[str, str]]] = {
    "UNITS": _unit,
    "UNIT": _unit,
    "FEDRAT": _feed,
    "SPINDL": _spindle,
    "COOLNT": _coolant,
    "LOADTL": _tool,
    "LOAD": _load,
    "TOOLNO": _number_of_tool,
    "TLDATA": _data,
    "CUTTER": _cutter,
    "TLAXIS": _axis,
    "CIRCLE": _circle,
    "TANGENT": _tangent,
    "CYCLE": _cycle,
    "RAPID": lambda rest: Meaning(Kind.RAPID),
    "MULTAX": lambda rest: Meaning(Kind.MULTAX, float(rest != "OFF")),
    "MSYS": lambda rest: Meaning(Kind.FRAME),
    "CSYS": _work_plane,
    "CUTCOM": _compensation,
}


def head_of(statements: Statements, source_scale: Floats) -> ClHead:
    """Return the first tool, speed and cutter, and whether coolant is ever on; ``source_scale`` mm of the
    unit at each statement."""
    tool, cutter = statements.first(statements.of(Kind.TOOL)), statements.of(Kind.CUTTER)
    speeds = statements.value(statements.of(Kind.SPINDLE))
    on = speeds[np.nan_to_num(speeds) > 0.0]
    size = statements.first(cutter)
    neck, flank = (statements.first(statements.of(kind)) for kind in (Kind.NECK, Kind.FLANK))
    scale = float(source_scale[cutter[0]]) if size else 1.0
    return ClHead(
        tool=int(tool.value) if tool and 0 < tool.value < 1e5 else None,
        speed=float(on[0]) if len(on) and on[0] < 1e6 else 0.0,
        coolant=bool(statements.value(statements.of(Kind.COOLANT)).any()),
        diameter=size.value * scale if size else 0.0,
        corner=size.more[0] * scale if size and size.more else 0.0,
        stated=_in_mm((size.value, *size.more), scale) if size else (),
        neck=tuple(scale * number for number in neck.more) if size and neck else (),
        flank=tuple(scale * number for number in flank.more) if size and flank else (),
    )


def _in_mm(numbers: tuple[float, ...], scale: float) -> tuple[float, ...]:
    """d, r, e, f, a, b, h of a CUTTER statement; a and b are degrees in every unit."""
    return tuple(number if k in (4, 5) else scale * number for k, number in enumerate(numbers))
