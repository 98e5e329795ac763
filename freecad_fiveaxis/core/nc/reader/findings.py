# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the reader says about a program: what it did not interpret, what it had to assume, and what the
controller guides."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Choice, Number, Option, Template, plural, say
from freecad_fiveaxis.core.controllers.dialect import Dialect
from freecad_fiveaxis.core.machine import find_physical_columns
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.motion.program.wrapping import CIRCLE

from . import codes
from .codes import Grammar
from .corners import LETTER
from .cycle_plan import PECKING
from .lines import Lines, tenfold
from .noted import MOST, kind_findings
from .positions import ABSOLUTE, Moves, find_wraps
from .words import Words

NAMES = {"siemens": "Siemens 840D", "heidenhain": "Heidenhain klartext", "iso": "ISO"}
LARGEST_CODE = 1e6
NEARLY_ROUND = 270.0
"""deg; a feed block that turns so far on purpose, while all words lie within one turn, is hardly met."""
LARGE_INCHES, FAST_INCHES = 40.0, 150.0
"""A part of less than 40 inches is milled at less than 150 inches a minute; one of 40 mm mostly faster than
150 mm."""
UNITS_TAKEN = Template(
    "The program says {units}; taken as mm: it then moves {size} mm at most, at F up to {feed}. Give "
    "{option}, mm or inch."
)
UNITS_WITHOUT_F = Template(
    "The program says {units}; taken as mm: it then moves {size} mm at most. No F is per minute (G93 and G95 "
    "are not), so none tells which unit is meant. Give {option}, mm or inch."
)
UNITS_DOUBTED = Template(
    "The program says {units}; taken as mm, but its size ({size}) and F (up to {feed}) are rather those of "
    "inches. Give {option}, mm or inch."
)
POINTS = Template(
    "{count} words have no decimal point; taken as they stand: {word} is {value}. If the control counts its "
    "least increment, it is {small} there: give {option}."
)
COUNTED_ON = Template(
    "The words of {letter} count their turns on, and {count} blocks turn by more than half a turn; the "
    "machine file says modulo, "
    "so the shorter way is taken. If the control counts turns, set wrap_strategy to unwound."
)
IF_SET = Template(
    "{count} blocks take the shorter way to {letter}, as the machine file says (modulo). "
    "{name} does so only if it is set to: check it."
)
WITHIN_A_TURN = Template(
    "{count} feed blocks turn {letter} by nearly a whole turn, and all its words lie within one: they seem "
    "meant by the shorter way. If the control takes it, set wrap_strategy to modulo."
)


def up_to_end(words: Words, grammar: Grammar) -> tuple[Words, tuple[Finding, ...]]:
    """Return the words up to the end of the program (M2, M30, M99 where it is one)."""
    ends = np.flatnonzero((words.letter == ord("M")) & np.isin(words.value, grammar.ends))
    if not len(ends):
        return words, ()
    last = int(words.line[ends[0]])
    keep = int(np.searchsorted(words.line, last, side="right"))
    findings: tuple[Finding, ...] = ()
    if keep < len(words.line):
        line = int(words.line[keep])
        text = say("The lines after the end of the program in line {last} are not read.", last=last)
        findings = (report_finding(Code.TEXT_AFTER_END, text, line=line),)
    start = None if words.start is None else words.start[:keep]
    return replace(
        words, letter=words.letter[:keep], value=words.value[:keep], line=words.line[:keep], start=start
    ), findings


def shift_finding(name: str, reason: str, row: int) -> Finding:
    """Return an error: the shift of the zero ``name`` in line ``row`` is not interpreted."""
    text = say(
        "{name}: this shift of the zero is not interpreted, and the coordinates after it are taken as they "
        "were before: {reason}. Post without it.",
        name=name,
        reason=reason,
    )
    return report_finding(codes.SHIFT[0], text, line=row)


def in_file(words: Words, findings: tuple[Finding, ...]) -> tuple[Finding, ...]:
    """Return the findings with the lines of the file for those of the words."""
    if words.source is None:
        return findings
    lines = words.in_file(np.array([found.line or 0 for found in findings], np.int64))
    return tuple(
        found if found.line is None else replace(found, line=line)
        for found, line in zip(findings, lines.tolist(), strict=True)
    )


def language_finding(language: str, expected: str) -> tuple[Finding, ...]:
    """Where the text shows another language than the controller's that was given."""
    if language == expected:
        return ()
    text = say(
        "The text is {language}, and read as such; give its {option}, so that feeds are taken as it takes "
        "them.",
        language=NAMES[language],
        option=Option("controller"),
    )
    return (report_finding(Code.OTHER_LANGUAGE, text),)


def read_as_finding(language: str, controller: str) -> Finding:
    """Return what a text was taken for that nobody has said the controller of."""
    text = say(
        "The text is {language}; it is read as a program of {controller}. If it is for another, give its "
        "{option}.",
        language=NAMES[language],
        controller=controller,
        option=Option("controller"),
    )
    return report_finding(Code.READ_AS, text)


def code_findings(words: Words, grammar: Grammar, at: Ints) -> tuple[list[Finding], list[Finding]]:
    """Return the codes that are not interpreted, each with its first line and its count; ``at`` (m,): the
    lines of the blocks. A retract to a machine position before the first of them, or after the last, is how a
    program should begin and end. The second of both have the lines of the file already."""
    found, known, ends = [], list[Finding](), (int(at[0]), int(at[-1]))
    for letter, table in (("G", grammar.codes), ("M", grammar.m_codes)):
        at = np.flatnonzero(words.letter == ord(letter))
        number = _numbers(words.value[at], letter)
        retract = [code for code, kind in table.items() if kind is codes.HOME]
        inside = (words.line[at] >= ends[0]) & (words.line[at] <= ends[1])
        keep = inside | ~np.isin(number, retract)
        if letter == "G":
            keep &= ~(np.isin(number, codes.SIDES) & np.isin(words.line[at], _without_radius(words)))
            keep &= ~((number == codes.PRESET_ZERO) & np.isin(words.line[at], _limiting_speed(words)))
        at, number = at[keep], number[keep]
        met: dict[codes.Kind, dict[str, tuple[int, int]]] = {}
        for value, first, count in zip(
            *np.unique(number, return_index=True, return_counts=True), strict=True
        ):
            line, name = int(words.line[at[first]]), f"{letter}{words.value[at[first]]:g}"
            if value in table:
                met.setdefault(table[int(value)], {})[name] = (
                    int(words.in_file(words.line[at[first : first + 1]])[0]),
                    int(count),
                )
            elif letter == "G" and int(value) not in grammar.harmless:
                text = plural(
                    count,
                    "{name} in NC line {line} is not known and not interpreted; its effect is missing here.",
                    "{name} is not known and not interpreted ({count} lines); what it does is missing here.",
                    name=name,
                    line=int(words.in_file(words.line[at[first]])),
                )
                found.append(report_finding(Code.UNKNOWN_CODE, text, float(count), line=line))
        known += [one for kind, named in met.items() for one in kind_findings(kind, named)]
    return found, known + _report_machine_words(words, ends, "$H" if grammar.name == "iso" else "SUPA")


def _report_machine_words(words: Words, ends: tuple[int, int], name: str) -> list[Finding]:
    """Report the machine positions that a word of that name tells (SUPA of Siemens) between the first block
    and the last, as :func:`code_findings` does those of codes."""
    at = np.flatnonzero(words.letter == ord(codes.MACHINE))
    line = words.in_file(words.line[at[(words.line[at] >= ends[0]) & (words.line[at] <= ends[1])]])
    return kind_findings(codes.HOME, {name: (int(line[0]), len(line))}) if len(line) else []


def _without_radius(words: Words) -> Ints:
    """Return the lines with D0: a compensation by nothing."""
    return np.asarray(words.line[(words.letter == ord("D")) & (words.value == 0.0)])


def _limiting_speed(words: Words) -> Ints:
    """Return the lines with S and no axis: there G92 limits the speed of the spindle."""
    axes = words.line[np.isin(words.letter, [ord(letter) for letter in codes.AXES])]
    return np.setdiff1d(words.line[words.letter == ord("S")], axes)


def _numbers(value: Floats, letter: str) -> Ints:
    """Return the codes as in the grammar's tables: G tenfold, M as they are."""
    if letter == "G":
        return tenfold(value)
    return np.asarray(np.where(np.abs(value) < LARGEST_CODE, value, -1.0).astype(np.int64))


def _belonging(lines: Lines) -> Bools:
    """Return which words (w,) belong to a code in their line (:data:`.codes.WORDS_OF`)."""
    words, found = lines.words, np.zeros(len(lines.words.letter), np.bool_)
    for code, letters in codes.WORDS_OF.items():
        if code in lines.code:
            found |= lines.any_of((code,))[words.line] & np.isin(words.letter, [ord(one) for one in letters])
    return found


def word_findings(lines: Lines, letters: str, guided: bool) -> list[Finding]:
    """Return the words that no axis of the machine and no function takes."""
    words = lines.words
    found, arcs = [], np.isin(lines.code, (codes.CLOCKWISE, codes.COUNTER)).any()
    tilts = np.isin(lines.code, codes.TILT).any()
    vectors = guided and np.isin(lines.code, codes.VECTORS_ON).any()
    at = np.flatnonzero(~_belonging(lines))
    for value, begin, count in zip(
        *np.unique(words.letter[at], return_index=True, return_counts=True), strict=True
    ):
        first = int(at[begin])
        letter, line = chr(value), int(words.line[first])
        if letter in letters or letter in codes.WORDS_IGNORED or letter.islower() or letter == LETTER:
            continue
        if letter in codes.AXES:
            text = say(
                "The machine has no axis {letter}: its {count} words are left out. Choose the program's own "
                "machine.",
                letter=letter,
                count=count,
            )
            found.append(report_finding(Code.UNKNOWN_AXIS, text, float(count), line=line))
        elif not ((letter in "IJKR" and arcs) or (letter in "IJK" and (vectors or tilts))):
            text = plural(
                count,
                "The word {letter} in NC line {line} is not interpreted: what it does is missing here. Post "
                "without it, or see that it moves nothing and changes no feed.",
                "{count} words {letter}, the first in NC line {line}, are not interpreted: what they do is "
                "missing here. Post without them, or see that they move nothing and change no feed.",
                letter=letter,
                line=int(words.in_file(words.line[first])),
            )
            found.append(report_finding(Code.WORD_NOT_INTERPRETED, text, float(count), line=line))
    return found


def start_findings(letters: str, motions: Moves, lines: Lines, grammar: Grammar) -> list[Finding]:
    """Return what had to be assumed: the first position, motion, units, offsets."""
    found, first = [], int(motions.at[0])
    by_vector = not np.isnan(motions.vector[0]).all()
    unknown = [
        letter
        for k, letter in enumerate(letters)
        if k in find_physical_columns(letters) and not (motions.named[0, k] or (by_vector and k >= 3))
    ]
    if unknown:
        text = say(
            "The first motion line does not say where {unknown} stand; they are taken as 0 there.",
            unknown=", ".join(sorted(unknown)),
        )
        found.append(report_finding(Code.POSITION_UNKNOWN, text, block=0, line=first))
    if (motions.mode == codes.NONE).any():
        block = int((motions.mode == codes.NONE).argmax())
        text = say("Axis words stand under no G0 or G1; they are taken as G1. Give a motion code.")
        found.append(report_finding(Code.NO_MOTION_CODE, text, block=block, line=int(motions.at[block])))
    if lines.assumed.units == "file" and not np.isin(lines.code, list(grammar.units)).any():
        found.append(_units_finding(motions, lines, grammar))
    found += _report_feeds_under_g70(lines, grammar)
    offsets = _find_offsets(lines, grammar)
    if len(offsets) > 1:
        text = say(
            "The program uses {count} work offsets: {names} (with their first lines). Their distance is not "
            "known, and the blocks between are not right. Audit each part on its own.",
            count=len(offsets),
            names=", ".join(f"{name} ({line})" for name, (_, line) in [*offsets.items()][:MOST]),
        )
        second = [row for row, _ in offsets.values()][1]
        found.append(report_finding(Code.WORK_OFFSET_CHANGE, text, line=second))
    found += _without_offset(motions, lines, grammar)
    return found


def _report_feeds_under_g70(lines: Lines, grammar: Grammar) -> list[Finding]:
    """Report that nobody has said what F counts under G70 (Siemens)."""
    if grammar.name != "siemens" or codes.LENGTHS_ALONE[0] not in lines.code or lines.assumed.units != "file":
        return []
    under = lines.mode({code: code for code in grammar.units}, 0) == codes.LENGTHS_ALONE[0]
    row = np.flatnonzero(under & ~np.isnan(lines.column("F")))
    if not len(row):
        return []
    text = say(
        "F under G70 counts in the control's basic system, mm or inches, which the program does not say; "
        "taken as inches. Give {option}, mm or inch, or post G700.",
        option=Option("units"),
    )
    return [report_finding(Code.UNITS_NOT_SAID, text, float(len(row)), line=int(row[0]), unit="")]


def _find_offsets(lines: Lines, grammar: Grammar) -> dict[str, tuple[int, int]]:
    """Return the work offsets of a program in the order of their first lines, here and in the file; of
    numbered ones each P is another."""
    at = np.flatnonzero(np.isin(lines.code, grammar.offsets))
    code, row, number = lines.code[at], lines.code_line[at], np.zeros(len(at))
    if grammar.name == "iso" and np.isin(code, codes.NUMBERED_OFFSETS).any():
        number = np.nan_to_num(lines.column("P"), nan=1.0)[row]
        number = np.where(np.isin(code, codes.NUMBERED_OFFSETS), number, 0.0)
    _, first = np.unique(np.column_stack([code, number]), axis=0, return_index=True)
    first.sort()
    names = [f"G{code[k] / 10:g}" + (f" P{number[k]:g}" if number[k] else "") for k in first.tolist()]
    places = zip(row[first].tolist(), lines.words.in_file(row[first]).tolist(), strict=True)
    return dict(zip(names, places, strict=True))


def _without_offset(motions: Moves, lines: Lines, grammar: Grammar) -> list[Finding]:
    """Report that blocks stand under G500 after the program has had a zero offset (Siemens)."""
    if grammar.name != "siemens" or codes.WITHOUT_OFFSET not in lines.code:
        return []
    state = lines.mode({**dict.fromkeys(grammar.offsets, 1), codes.WITHOUT_OFFSET: 2}, 0)[motions.at]
    rows = np.flatnonzero(np.logical_or.accumulate(state == 1) & (state == 2))
    if not len(rows):
        return []
    text = say(
        "{count} blocks stand under G500 after a work offset: where they lead only the machine knows, and "
        "they are not right here. Post them under the offset, or as machine positions (SUPA).",
        count=len(rows),
    )
    return [
        report_finding(
            codes.SHIFT[0], text, float(len(rows)), block=int(rows[0]), line=int(motions.at[rows[0]]), unit=""
        )
    ]


def _units_finding(motions: Moves, lines: Lines, grammar: Grammar) -> Finding:
    """Report that nobody has said the units; and whether sizes and feeds are rather those of a program in
    inches."""
    size = float(np.ptp(motions.programmed[:, :3], axis=0).max())
    feed = lines.column("F")[lines.mode(codes.FEED_MODE, 0) == codes.PER_MINUTE]
    fastest = float(np.nanmax(feed)) if not np.isnan(feed).all() else 0.0
    against = size < LARGE_INCHES and 0.0 < fastest < FAST_INCHES
    template = UNITS_DOUBTED if against else UNITS_TAKEN if fastest > 0.0 else UNITS_WITHOUT_F
    text = template.say(
        units=grammar.units_text, size=Number(size), feed=Number(fastest), option=Option("units")
    )
    return report_finding(Code.UNITS_NOT_SAID, text, line=int(motions.at[0]))


def point_findings(lines: Lines) -> tuple[Finding, ...]:
    """How many words of axes and depths of pecks have no decimal point, and are not 0."""
    words = lines.words
    counted = np.isin(words.letter, [ord(one) for one in codes.INCREMENTED]) & ~_belonging(lines)
    counted |= (words.letter == ord(codes.PECK)) & lines.any_of(PECKING)[words.line]
    at = np.flatnonzero(words.bare() & counted & (words.value != 0.0))
    if not len(at):
        return ()
    text = POINTS.say(
        count=len(at),
        word=f"{chr(words.letter[at[0]])}{words.value[at[0]]:g}",
        value=f"{words.value[at[0]]:g}",
        small=f"{words.value[at[0]] / 1000.0:g}",
        option=Choice("decimal", ("least-increment",), flag=True),
    )
    return (report_finding(Code.NO_DECIMAL_POINT, text, float(len(at)), line=int(words.line[at[0]])),)


def wrap_findings(kinematics: Chain, motions: Moves, dialect: Dialect | None) -> list[Finding]:
    """Where the rotary words and the machine file's ``wrap_strategy`` contradict each other, and where the
    controller does what the machine file says only if it is set so."""
    found, feeding = [], motions.mode != codes.RAPID
    for k, way in enumerate(find_wraps(kinematics), 3):
        value, kind = motions.words[k]
        rows = np.flatnonzero(kind == ABSOLUTE)
        step = np.abs(np.diff(value[rows]))
        one_turn = bool(len(rows)) and float(np.ptp(value[rows])) <= CIRCLE
        wide = (
            rows[1:][step > CIRCLE / 2]
            if way == "modulo"
            else rows[1:][(step > NEARLY_ROUND) & feeding[rows[1:]]]
        )
        sentence = None
        if way == "modulo" and len(wide) and not one_turn:
            sentence = COUNTED_ON
        elif way == "modulo" and len(wide) and not (dialect is not None and dialect.shorter_way):
            sentence = IF_SET
        elif way != "modulo" and len(wide) and one_turn:
            sentence = WITHIN_A_TURN
        if sentence is not None:
            severity = Severity.NOTE if sentence is IF_SET else Severity.WARNING
            text = sentence.say(
                letter=kinematics.letters[k], count=len(wide), name="ISO" if dialect is None else dialect.name
            )
            block = int(wide[0])
            found.append(
                report_finding(
                    Code.WRAP_CONTRADICTED,
                    text,
                    float(len(wide)),
                    line=int(motions.at[block]),
                    severity=severity,
                )
            )
    return found


def guide_findings(program: Program, motions: Moves) -> tuple[Finding, ...]:
    """Return what there is to say of blocks in which the controller guides the tip."""
    found = []
    if program.guided is not None:
        count, block = int(program.guided.on.sum()), int(program.guided.on.argmax())
        text = say(
            "In {count} blocks the controller guides the tip (RTCP): that it keeps to the segment is the "
            "controller's affair, and neither measured nor proven here. Limits and rates are those of the "
            "axes that this machine file needs for it.",
            count=count,
        )
        found.append(
            report_finding(
                Code.TIP_GUIDED_BY_CONTROLLER,
                text,
                float(count),
                block=block,
                line=int(program.line[block]),
                unit="",
            )
        )
    if len(motions.lost):
        line = int(motions.at[motions.lost[0]])
        text = say(
            "{count} tool axes cannot be taken up by this machine; the one before each is kept. Choose its "
            "own machine.",
            count=len(motions.lost),
        )
        found.append(report_finding(Code.AXIS_NOT_REACHABLE, text, float(len(motions.lost)), line=line))
    return tuple(found)
