# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a program ends, and what it leaves switched on there."""

from __future__ import annotations

import re

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools
from freecad_fiveaxis.core.base.sentences import Sentence, join_sentences, say
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.motion.program import feed_blocks
from freecad_fiveaxis.core.nc.reader import Reading

from .spindle import turns_at_end
from .states import TAIL, ends, first_unread, has_code, words_of

HOMES = {"iso": (280, 281, 300, 301, 530), "siemens": (530, 740, 750, 1530), "heidenhain": ()}
"""G codes of moves to machine positions."""
MACHINE_M = (91, 92)
MACHINE_WORD = "v"
"""The reader's word for SUPA and M91 (``nc/reader/codes.py``)."""
END_M = {"iso": (2, 30, 99), "siemens": (2, 17, 30), "heidenhain": (2, 30)}
OTHER_END = {
    "iso": re.compile(rb"O *<[^<>\n]*> *(?:ENDSUB|RETURN)|O *[0-9]+ *(?:ENDSUB|RETURN)", re.IGNORECASE),
    "siemens": re.compile(rb"(?<![A-Z0-9_])RET(?![A-Z0-9_])", re.IGNORECASE),
    "heidenhain": re.compile(rb"^ *[0-9]* *END +PGM\b|^ *N[0-9]+ *%", re.IGNORECASE | re.MULTILINE),
}
MARKS = re.compile(rb"^ *%", re.MULTILINE)
END_WORDS = {"iso": "M30", "siemens": "M30", "heidenhain": "END PGM"}
OFFSET_ON, OFFSET_OFF = 2540, 2550


def end_findings(text: bytes, reading: Reading, dialect: Dialect) -> tuple[Finding, ...]:
    """Say that nothing ends the program, or that the tip is guided, or the dynamic offset on, at its end."""
    if first_unread(reading) < reading.lines.count:
        return ()
    if not _has_end(text, reading, dialect):
        return (_report_no_end(text, reading),)
    if not ends(reading, text):  # a subprogram gives back what it was called with
        return ()
    return (*_guide_left_on(reading, dialect), *_offset_left_on(reading))


def _has_end(text: bytes, reading: Reading, dialect: Dialect) -> bool:
    _, number = words_of(reading, "M")
    language = reading.language
    if np.isin(number, END_M[language]).any() or OTHER_END[language].search(text[-TAIL:]):
        return True
    return dialect.name == "linuxcnc" and len(MARKS.findall(text)) > 1


def _report_no_end(text: bytes, reading: Reading) -> Finding:
    """Warn where the spindle is left turning: what comes then is the control's affair."""
    turning = turns_at_end(text, reading)
    sentence = say("The program has no end: give {word} in its last line.", word=END_WORDS[reading.language])
    also = (say("The spindle still turns there."),) if turning else ()
    return report_finding(
        Code.PROGRAM_WITHOUT_END, join_sentences((sentence, *also)), line=int(reading.in_file()[-1]),
        severity=Severity.WARNING if turning else None,
    )  # fmt: skip


def _guide_left_on(reading: Reading, dialect: Dialect) -> tuple[Finding, ...]:
    if not reading.guided[-1]:
        return ()
    off = next((guide.off for guide in dialect.guides.values() if guide.off), ())
    return (_report_left_on(reading, say("tool centre control"), " ".join(off) or _usual_off(reading)),)


def _usual_off(reading: Reading) -> str:
    return {"iso": "G49", "siemens": "TRAFOOF", "heidenhain": "M129"}[reading.language]


def _offset_left_on(reading: Reading) -> tuple[Finding, ...]:
    if reading.language != "iso" or not has_code(reading, (OFFSET_ON,)).any():
        return ()
    on = reading.lines.mode({OFFSET_ON: 1, OFFSET_OFF: 0}, 0)[-1]
    return (_report_left_on(reading, say("the dynamic work offset (G254)"), "G255"),) if on else ()


def _report_left_on(reading: Reading, what: Sentence, off: str) -> Finding:
    """Warn where an axis goes home under it; note it where the program only ends."""
    homes = np.flatnonzero(_goes_home(reading))
    if not len(homes):
        line = int(reading.in_file()[-1])
        text = say(
            "In NC line {line} the program ends, and {function} is still on: the next one may begin with it. "
            "Give {off} before the end.",
            line=line, function=what, off=off,
        )  # fmt: skip
        return report_finding(Code.GUIDE_NOT_ENDED, text, line=line, severity=Severity.NOTE)
    line = int(reading.in_file()[homes[0]])
    text = say(
        "From NC line {line} on axes go home, and {function} is still on: the control may refuse that, or "
        "move X Y Z beside the rotary axes to keep the tip. Retract Z, then give {off} before that line.",
        line=line, function=what, off=off,
    )  # fmt: skip
    return report_finding(Code.GUIDE_NOT_ENDED, text, line=line)


def _goes_home(reading: Reading) -> Bools:
    """Return the rows (rows,) behind the last feed that go to machine positions, or turn rotary axes alone to
    0. Z alone may: it retracts before the guide is switched off, which may drive it by the tool's length."""
    fed, lines = feed_blocks(reading.program), reading.lines
    home = has_code(reading, HOMES[reading.language])
    home[lines.m_line(MACHINE_M if reading.language == "heidenhain" else ())] = True
    if MACHINE_WORD in lines.letters:
        home[words_of(reading, MACHINE_WORD)[0]] = True
    rotary, across, elsewhere = np.zeros((3, lines.count), np.bool_)
    for letter in "ABC":
        row, number = words_of(reading, letter)
        rotary[row] = True
        elsewhere[row[number != 0.0]] = True
    for letter in "XY":
        across[words_of(reading, letter)[0]] = True
    elsewhere[words_of(reading, "Z")[0]] = True
    home &= rotary | across
    behind = np.arange(lines.count) > (int(reading.row[fed[-1]]) if len(fed) else 0)
    return np.asarray(behind & (home | (rotary & ~across & ~elsewhere)))
