# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC text into words: a letter, a number and the line it stands in, as whole columns.

word      a letter with its number (ISO 6983-1): X-12.5. Blanks may stand anywhere in it, capitals do not
          matter.
comment   text in brackets, or from a semicolon to the end of the line (Siemens: only the latter; Heidenhain:
          that, up to the ~ that goes on with the next line, or a star at the start or the end of a line).
block skip  a slash at the start of a line: the operator may switch such lines off; between words, the rest.
%         the first ends the leader of the tape, the next one ends the program.
//, $H    what Mach3 and grbl take for themselves: :mod:`.control_lines`.
language  ISO; Siemens' and Heidenhain's text is brought to plain words first (:mod:`.siemens`,
          :mod:`.heidenhain`).

Nothing but whole-text operations: comments and everything else that is not a word is first overwritten with
blanks of the same length, so that lines and columns of the file stay known for the messages.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints, freeze
from freecad_fiveaxis.core.base.sentences import Template, say

from . import codes, corners, interpreter
from .called_files import with_called_files
from .control_lines import without_control_lines
from .expressions import Unread
from .feed_groups import FeedGroup
from .heidenhain import with_unit
from .no_motion import pass_over
from .of_machine import NO_MACHINE, OfMachine
from .plain_words import Plain, not_run, plain_words, relocate_finding
from .plane_calls import Tilt
from .preface import (
    between_marks,
    finding_at,
    with_line_feeds,
    without_end_sign,
    without_preface,
)
from .siemens_cycles import Drill
from .word_columns import find_column, split_words

BRACKETS, SEMICOLON, STAR = (
    (b"(", rb"\((?:[^()\n]|\((?:[^()\n]|\([^()\n]*\))*\))*\)"),
    (b";", rb";[^\n]*"),
    (b"*", rb"(?m:^) *(?:[0-9]+ +)?\*[^\n]*|\* *(?m:$)"),
)
OUTSIDE = (b";", rb'(?P<text>"[^"\n]*")|;[^\n]*')
"""Siemens: a semicolon in a string begins no comment."""
NOTE = (b";", rb";(?:[^\n~]|~(?! *(?:\n|$)))*")
COMMENTS = {"iso": (BRACKETS, SEMICOLON), "siemens": (OUTSIDE,), "heidenhain": (NOTE, STAR)}
SLASH = re.compile(rb"^ *(/[0-9]?)", re.MULTILINE)
WITHIN = re.compile(rb"^[^\n#\[=/]*[0-9.] *(/[1-9]?)(?= *[A-Z] *[-+.0-9])", re.MULTILINE)
"""Block skip between the words of a line: the rest of it may be switched off (Fanuc, B-63324EN, 13.2)."""
COLON = re.compile(rb"^ *(:)(?= *[0-9])", re.MULTILINE)
OF_MACHINE = re.compile(rb"\$ *-?[0-9]+|(?<=M66) *E *[0-9.]+")
"""LinuxCNC's number of a spindle, and of the input that M66 waits for."""
SYMBOLS = {
    "iso": (b"@", b"^", b"#", b"[", b"]", b"=", b"<", b">"),
    "siemens": (b"=", b"[", b"]", b"<", b">", b"$", b"(", b")", b"#", b'"', b"{", b"}"),
    "heidenhain": (),
}
KEYWORDS = tuple(b"GOTO WHILE CALL SUB RETURN REPEAT BREAK CONTINUE THEN IF ELSE DO END1 END2 END3".split())
"""These show that a line is macro language (Fanuc custom macro B, LinuxCNC O-codes)."""
O_LINE = re.compile(rb" *O *[0-9]+ *[A-Z]{2}")
CALLS, MACRO_CALL = (97, 98), 65
STATES = (71, 72, 73)
"""LinuxCNC's modes kept and restored, which Fanuc's and Haas' M codes are not."""
FANUC = ("fanuc", "haas")
"""Whose variables and jumps are Fanuc's; all others' are LinuxCNC's."""
TAPE = b"\t\v\f\x11\x12\x13\x14\x1a"
"""Control characters that old files hold between the words: tabs, reader control, end of file."""
TEXT = bytes({*range(32, 256), *TAPE, *b"\n\r"} - {127})
CLEAN = bytes.maketrans(bytes(range(97, 123)) + TAPE, bytes(range(65, 91)) + b" " * len(TAPE))
SKIPPED = Template("{count} lines begin with a slash (block skip); they are read as if the switch were off.")
SKIPPED_WITHIN = Template(
    "{count} lines have a slash (block skip) between their words; what stands behind it is read as if the "
    "switch were off."
)
MACROS = Template(
    "{count} lines hold variables, expressions or jumps, which are not interpreted; their words are missing "
    "here. Post without them. The first: {shown}."
)
NOT_CALLED = Template(
    "Subprograms are not interpreted, because of this line: {reason}. Post one program without them."
)
HEIDENHAIN_SIGN = re.compile(
    rb"^ *(?:(?:[0-9]+ +)?BEGIN +PGM\b|%[^\n%]*? +G7[01] *\* *$)", re.MULTILINE | re.IGNORECASE
)
DIN_END = re.compile(rb"^ *N[0-9]+ *%[^\n%]*? +G7[01] *\*[\s]*\Z", re.MULTILINE | re.IGNORECASE)
"""The last line of Heidenhain's DIN/ISO; posts leave out the star of the lines before."""
SIEMENS_SIGN = re.compile(
    rb"\b(?:TRAORI|TRAFOOF|CYCLE832|FGROUP|ORIWKS|ORIMKS)\b|[ABC]3=|%_N_", re.IGNORECASE
)
LOOKED_AT, LAST = 20_000, 200
"""Bytes at the start and at the end of a text that tell whose language it is."""


@dataclass(frozen=True, eq=False)
class Words:
    """``letter`` (w,) ASCII code, ``value`` (w,), ``line`` (w,) counted from 1, in the order of the file;
    ``text``: what was left of the file when they were read, ``start`` (w,) where they stand in it without its
    blanks. ``source``: where lines of the file were written out as several, ``line`` counts those; ``source``
    (lines + 1,) are the lines of the file that they come from. ``tilts``, ``drills``: what the lines with the
    private words of a tilted plane and of a drilling cycle say; ``groups``: over which axes F is measured.
    ``cause``: of the ``findings``, why it was not run."""

    letter: Bytes
    value: Floats
    line: Ints
    findings: tuple[Finding, ...] = ()
    text: bytes = b""
    start: Ints | None = None
    source: Ints | None = None
    tilts: tuple[Tilt, ...] = ()
    drills: tuple[Drill, ...] = ()
    groups: tuple[FeedGroup, ...] = ()
    cause: Finding | None = None

    def place(self, word: int) -> str:
        """Where a word stands, as "line 3, column 7"."""
        line = int(self.line[word])
        if self.start is None or self.source is not None:
            return f"line {int(self.in_file(self.line[word]))}"
        compact = self.text.translate(None, b" ")
        begin = compact.rfind(b"\n", 0, int(self.start[word])) + 1
        return f"line {line}, column {find_column(self.text, line, int(self.start[word]) - begin)}"

    def in_file(self, line: Ints) -> Ints:
        """Return the lines of the file for some of ``line``."""
        return line if self.source is None else self.source[line]

    def bare(self) -> Bools:
        """Which words (w,) have no decimal point."""
        if self.start is None:
            return np.zeros(len(self.letter), np.bool_)
        code = np.frombuffer(self.text.translate(None, b" ") + b"\n", np.uint8)
        every = np.flatnonzero(code >= ord("A"))
        return np.asarray(
            np.add.reduceat(code == ord("."), every, dtype=np.int32)[np.searchsorted(every, self.start)] == 0
        )

    def __post_init__(self) -> None:
        freeze(self, None, letter="m", value="f", line="i")


def language_of(text: bytes, expected: str) -> str:
    """Whose language a text is in: what its first lines, or its last one, show without doubt, or else
    ``expected``."""
    start = text[:LOOKED_AT]
    if HEIDENHAIN_SIGN.search(start) or DIN_END.search(text[-LAST:].replace(b"\r", b"\n")):
        return "heidenhain"
    return "siemens" if expected == "iso" and SIEMENS_SIGN.search(start) else expected


def read_words(
    text: bytes,
    language: str = "iso",
    controller: str = "",
    progress: Progress = silent,
    of_machine: OfMachine = NO_MACHINE,
) -> Words:
    """All words of an NC text up to the closing ``%``, as the control of the name ``controller`` (LinuxCNC
    where there is none) of that machine comes to them. Raises ProgramError, naming line and column, for what
    is no word, and for what does not end."""
    text, findings, plain = _blank_non_words(text, language, controller, progress, of_machine)
    source, tilts, drills = plain.source, plain.tilts, plain.drills
    marks, fanuc = _marks(text, language), controller in FANUC
    folders = () if fanuc else of_machine.search
    expanded = text, source
    if marks:
        expanded = _run(text, marks, language, fanuc, findings, progress, folders, source)
    words = _words_of(*expanded)
    if not marks and language == "iso" and _calls(words, fanuc):
        words = _words_of(*_run(text, marks, language, fanuc, findings, progress))
    cause = plain.cause or next(
        (found for found in findings if found.code == codes.MACRO[0] and language == "iso"), None
    )
    return replace(
        words, findings=tuple(findings), tilts=tilts, drills=drills, groups=plain.groups, cause=cause
    )


def _words_of(text: bytes, source: Ints | None) -> Words:
    """Return the words of a text that holds nothing else."""
    letter, value, line, start = split_words(text, source)
    return Words(letter, value, line, (), text, start, source)


def _blank_non_words(
    text: bytes, language: str, controller: str, progress: Progress, of_machine: OfMachine
) -> tuple[bytes, list[Finding], Plain]:
    """Return the text in capitals, lines ending in LF, with blanks for all that is no word; what was passed
    over; what the text's own language brought."""
    findings: list[Finding] = []
    text = with_line_feeds(text.removeprefix(b"\xef\xbb\xbf"))
    text = without_end_sign(text, findings)
    if control := text.translate(None, TEXT):
        at = text.index(control[:1])
        line, column = text.count(b"\n", 0, at) + 1, at - text.rfind(b"\n", 0, at)
        raise ProgramError(
            say(
                "line {line}, column {column}: byte {control}: this is no NC text; give a plain text file",
                line=line,
                column=column,
                control=control[0],
            ),
            control[0],
        )
    text = _blank_comments(text, language)
    whole = without_preface(text.translate(CLEAN), language, findings)
    text = between_marks(whole, findings, language)
    if language == "heidenhain":
        text = with_unit(whole, text)
    text, passed = pass_over(text, language, of_machine.no_motion)
    findings += passed
    plain = Plain(text, None, (), ())
    if language != "iso":
        plain = plain_words(text, language, progress, of_machine)
        text = plain.text
        findings += plain.findings
    if language == "iso":
        text, noted = without_control_lines(text, controller)
        findings += noted
        text = corners.mark_corners(text)
    if language == "iso" and (b"$" in text or b"M66" in text):
        text = OF_MACHINE.sub(lambda found: b" " * len(found[0]), text)
    for pattern, sentence in ((SLASH, SKIPPED), (WITHIN, SKIPPED_WITHIN)):
        text, lines = _overwritten(text, pattern, b" ") if b"/" in text else (text, [])
        if lines:
            found = finding_at(Code.BLOCK_SKIP, sentence.say(count=len(lines)), text, lines[0])
            findings.append(relocate_finding(found, plain.source))
    if b":" in text:
        text, _ = _overwritten(text, COLON, b"O")
    return text, findings, plain


def _overwritten(text: bytes, pattern: re.Pattern[bytes], by: bytes) -> tuple[bytes, list[int]]:
    """Return the text with each group 1 of the pattern replaced at equal length, and where that was."""
    spans = [found.span(1) for found in pattern.finditer(text)]
    buffer = bytearray(text)
    for first, last in spans:
        buffer[first:last] = by.ljust(last - first)
    return bytes(buffer), [first for first, _ in spans]


def _marks(text: bytes, language: str) -> list[bytes]:
    """Return what shows that a text has variables, expressions or jumps."""
    known = KEYWORDS if language == "iso" and _has_adjacent_letters(text) else ()
    return [mark for mark in (*SYMBOLS[language], *known) if mark in text]


def _calls(words: Words, fanuc: bool) -> bool:
    """Whether a program of plain words calls subprograms, or keeps and restores modes."""
    m_codes = words.value[words.letter == ord("M")]
    called = np.isin(m_codes, CALLS if fanuc else CALLS + STATES).any() or _jumps_by_m99(words)
    return bool(called or (words.value[words.letter == ord("G")] == MACRO_CALL).any())


def _jumps_by_m99(words: Words) -> bool:
    """Whether an M99 says by P where to go on."""
    line = words.line[(words.letter == ord("M")) & (words.value == 99)]
    return bool(np.isin(line, words.line[words.letter == ord("P")]).any())


def _run(
    text: bytes, marks: list[bytes], language: str, fanuc: bool, findings: list[Finding], progress: Progress,
    folders: Sequence[str] = (), source: Ints | None = None,
) -> tuple[bytes, Ints | None]:  # fmt: skip
    """Return the text as the control comes to its lines, and the lines of the file that these are; where they
    are not understood, blanks for the lines that hold one of the ``marks``, with a finding. ``folders``:
    where LinuxCNC's subprograms lie; ``source``: the lines of the file, where the text was written out."""
    if language == "iso":
        expanded = _run_with_files(text, fanuc, progress, folders)
        if isinstance(expanded, interpreter.Written):
            return expanded.text, expanded.source
        if not marks:
            findings.append(
                report_finding(codes.CALL[0], NOT_CALLED.say(reason=expanded.reason), line=expanded.line)
            )
            return text, None
        findings.append(not_run(expanded))
        return _blank_lines(text, _lines_with(text, marks)), None
    hit = _lines_with(text, marks)
    shown = b" ".join(text.split(b"\n")[hit[0]].split())[:40].decode("latin-1")
    sentence = MACROS.say(count=len(hit), shown=repr(shown))
    found = report_finding(codes.MACRO[0], sentence, float(len(hit)), line=hit[0] + 1, unit="")
    findings.append(relocate_finding(found, source))
    return _blank_lines(text, hit), source


def _run_with_files(
    text: bytes, fanuc: bool, progress: Progress, folders: Sequence[str]
) -> interpreter.Written | interpreter.Refused:
    try:
        whole, origin = with_called_files(text, folders, _clean_called)
    except Unread as refused:
        return interpreter.Refused(refused.at + 1, refused.reason)
    return interpreter.run_program(whole, fanuc, progress, origin=origin)


def _clean_called(text: bytes) -> bytes:
    """Return the text of a called file in capitals, lines ending in LF, with blanks for its comments."""
    text = with_line_feeds(text.removeprefix(b"\xef\xbb\xbf"))
    return _blank_comments(text, "iso").translate(CLEAN)


def _blank_comments(text: bytes, language: str) -> bytes:
    forms = [
        form for begin, form in COMMENTS[language] if begin in text
    ]  # a pattern of one form alone is searched faster
    return re.sub(b"|".join(forms), _blank_comment, text) if forms else text


def _blank_comment(found: re.Match[bytes]) -> bytes:
    return found[0] if found.lastgroup == "text" else b" " * len(found[0])


def _lines_with(text: bytes, marks: list[bytes]) -> list[int]:
    """Return the lines, counted from 0, with one of the marks."""
    lines = text.split(b"\n")
    return [k for k, line in enumerate(lines) if any(mark in line for mark in marks) or O_LINE.match(line)]


def _blank_lines(text: bytes, chosen: list[int]) -> bytes:
    lines = text.split(b"\n")
    for k in chosen:
        lines[k] = b" " * len(lines[k])
    return b"\n".join(lines)


def _has_adjacent_letters(text: bytes) -> bool:
    letter = np.frombuffer(text, np.uint8) - np.uint8(ord("A")) < 26
    return bool((letter[1:] & letter[:-1]).any())
