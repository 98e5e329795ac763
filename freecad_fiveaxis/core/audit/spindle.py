# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the spindle turns, and the right way round, where a program feeds."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Sentence, plural, say
from freecad_fiveaxis.core.nc.reader import Reading

from .states import (
    NOTHING,
    UNKNOWN,
    before,
    clean_text,
    cutting_rows,
    ends,
    events,
    hold,
    mark_file_lines,
    words_of,
)

OFF, RIGHT, LEFT = 0, 1, 2
TURNS: dict[float, int] = {3: RIGHT, 13: RIGHT, 4: LEFT, 14: LEFT, 5: OFF}
"""M words; M13 and M14 start the coolant too."""
STARTS = frozenset(TURNS) - {5}
CLAMP = 14
"""On ISO controls M14 may as well clamp a rotary axis: then it says nothing of the spindle's turn."""
OWN_MOTION = {
    "iso": re.compile(rb"G0*[78]4(?:\.[0-9])?(?![0-9.])"),
    "siemens": re.compile(rb"CYCLE840?(?![0-9])|SPOSA?(?![A-Z0-9_])|G0*33[12](?![0-9.])"),
    "heidenhain": re.compile(rb"CYCL DEF (?:2|17|18|206|207|209)(?![0-9])"),
}
"""Tapping drives the spindle itself, and an oriented one may be meant to stand (scribing): no claim."""
RIGID = 29
NUMBERED = re.compile(rb"\$ *-?[0-9]")
"""LinuxCNC's number of one spindle of several."""
SIEMENS_SPINDLE = re.compile(
    rb"(?<![A-Z0-9_$])(?P<letter>[MS]) *(?P<spindle>[0-9]*) *= *(?P<number>[0-9.]+(?![0-9. ]*[-+*/(\[]))?"
)
"""M1=3 and S1=8000, of one spindle of several; S=R1 says no number."""
TOOL_CALL = re.compile(rb"^[ 0-9/]*TOOL CALL[^\n]*?\bS *(?P<number>[0-9.]+)?(?=[^A-Z0-9.]|Q|$)", re.MULTILINE)


def spindle_findings(text: bytes, reading: Reading) -> tuple[Finding, ...]:
    """Say where the program feeds while the spindle stands still, has no speed, or turns to the left. What is
    told by a variable, and several spindles, are not judged; what may stand outside the ``text`` is left to a
    part of a program."""
    whole = ends(reading, text)
    text = clean_text(text, reading.language)
    if reading.language == "iso" and b"$" in text and NUMBERED.search(text):
        return ()
    block, row = cutting_rows(reading)
    turn, speed = _find_turns(text, reading)[row], _find_speeds(text, reading)[row]
    turns = (turn == RIGHT) | (turn == LEFT)
    still = turns & ((speed == 0.0) | (whole & (speed == NOTHING)))
    if reading.language == "iso" and _is_laser(reading):
        still &= False
    left = (turn == LEFT) & ~still
    return (
        *_report(Code.SPINDLE_OFF, _say_never, whole & (turn == NOTHING), block, reading),
        *_report(Code.SPINDLE_OFF, _say_stopped, turn == OFF, block, reading),
        *_report(Code.SPINDLE_WITHOUT_SPEED, _say_no_speed, still, block, reading),
        *_report(Code.SPINDLE_REVERSED, _say_reversed, left, block, reading),
    )


def turns_at_end(text: bytes, reading: Reading) -> bool:
    """Whether the spindle turns where the program ends, as far as that is known."""
    return bool(_find_turns(clean_text(text, reading.language), reading)[-1] in (RIGHT, LEFT))


def _is_laser(reading: Reading) -> bool:
    """Whether S goes between 0 and more in the feed lines themselves, as it does for a laser's power."""
    rows, number = words_of(reading, "S")
    fed = np.isin(rows, reading.row)
    return bool((number[fed] == 0.0).any() and (number[fed] > 0.0).any())


def _report(
    code: Code, sentence: Callable[[int, int], Sentence], where: Bools, block: Ints, reading: Reading
) -> tuple[Finding, ...]:
    """Report the first of the feed blocks ``where`` (k,) it is so, and their count."""
    count = int(where.sum())
    if not count:
        return ()
    first = int(block[np.argmax(where)])
    line = int(reading.program.line[first])
    return (report_finding(code, sentence(count, line), float(count), block=first, line=line),)


def _say_never(count: int, line: int) -> Sentence:
    return say(
        "The spindle stays off: nothing before NC line {line}, the first that feeds, starts it. Give M3 "
        "with S before the tool gets to the part.",
        line=line,
    )


def _say_stopped(count: int, line: int) -> Sentence:
    return plural(
        count,
        "The spindle stands still in {count} feed block, NC line {line}: M5 is in force there. Give M3 "
        "before it, or delete the M5.",
        "The spindle stands still in {count} feed blocks, from NC line {line} on: M5 is in force there. "
        "Give M3 before them, or delete the M5.",
        line=line,
    )


def _say_no_speed(count: int, line: int) -> Sentence:
    return plural(
        count,
        "The spindle has no speed in {count} feed block, NC line {line}: it is started, but no S above 0 is "
        "in force there. Give S with M3.",
        "The spindle has no speed in {count} feed blocks, from NC line {line} on: it is started, but no S "
        "above 0 is in force there. Give S with M3.",
        line=line,
    )


def _say_reversed(count: int, line: int) -> Sentence:
    return plural(
        count,
        "The spindle turns to the left (M4) in {count} feed block, NC line {line}. That is right for "
        "left-hand tools alone: give M3 for any other.",
        "The spindle turns to the left (M4) in {count} feed blocks, from NC line {line} on. That is right "
        "for left-hand tools alone: give M3 for any other.",
        line=line,
    )


def _find_turns(text: bytes, reading: Reading) -> Floats:
    """Return how the spindle turns in each row (rows,). What starts it does so before the row moves, M5 stops
    it behind: a control may do either, and nothing is claimed of that row."""
    rows, number = words_of(reading, "M")
    event = events(reading)
    known = np.isin(number, list(TURNS))
    event[rows[known]] = [TURNS[one] for one in number[known].tolist()]
    event[rows[number == RIGID]] = UNKNOWN
    if reading.language == "iso":
        event[rows[number == CLAMP]] = UNKNOWN
    if reading.language == "siemens":
        plain = np.isin(number, list(STARTS)).any()
        mark_file_lines(reading, event, text, _find_numbered_turns(text, bool(plain)))
    own = OWN_MOTION[reading.language].finditer(text)
    mark_file_lines(reading, event, text, ((one.start(), UNKNOWN) for one in own))
    state = hold(event)
    return np.where(event == OFF, before(state), state)


def _find_numbered_turns(text: bytes, plain: bool) -> list[tuple[int, float]]:
    """Return where a numbered spindle of Siemens starts or stops, as M1=3. A stop counts where no other is
    started, ``plain``: by M3 alone; which of several cuts is not known."""
    numbered = [one for one in SIEMENS_SPINDLE.finditer(text) if one["letter"] == b"M"]
    turns = [(one, TURNS.get(_number(one["number"])) if one["number"] else None) for one in numbered]
    started = {one["spindle"] for one, turn in turns if turn in (RIGHT, LEFT)} | ({b""} if plain else set())
    found = []
    for one, turn in turns:
        if turn == OFF and one["spindle"] in started:
            found.append((one.start(), float(OFF if len(started) == 1 else UNKNOWN)))
        elif turn is not None and turn != OFF:
            found.append((one.start(), float(turn)))
    return found


def _find_speeds(text: bytes, reading: Reading) -> Floats:
    """Return S in force in each row (rows,)."""
    rows, number = words_of(reading, "S")
    event = events(reading)
    event[rows] = np.abs(number)
    if reading.language == "siemens":
        mark_file_lines(reading, event, text, _numbers_in(SIEMENS_SPINDLE, text, b"S"))
    elif reading.language == "heidenhain":
        mark_file_lines(reading, event, text, _numbers_in(TOOL_CALL, text))
    return hold(event)


def _numbers_in(pattern: re.Pattern[bytes], text: bytes, letter: bytes = b"") -> list[tuple[int, float]]:
    """Return where the words of a pattern stand, and their numbers, :data:`UNKNOWN` where they say none."""
    found = []
    for one in pattern.finditer(text):
        if not letter or one["letter"] == letter:
            number = one["number"]
            found.append((one.start("letter") if letter else one.start(), _number(number)))
    return found


def _number(text: bytes | None) -> float:
    try:
        return float(text or b"inf")
    except ValueError:
        return float(UNKNOWN)
