# SPDX-License-Identifier: LGPL-2.1-or-later
"""CL files in APT form (ISO 4343, ANSI X3.37): written, and read from any CAM system.

GOTO/     x, y, z of the driven point, and under MULTAX i, j, k of the tool axis (tip to holder).
RAPID     the next GOTO alone is a rapid.            FEDRAT/   the feed of those that follow, per minute.
$, $$     a statement goes on in the next line; the rest of the line is a comment.
PPRINT    free text; ``PPRINT/MOTION,LINK`` and ``PPRINT/MOTION,CUT`` are this program's marks for moves off and on the part.
"""

from __future__ import annotations

import re
import warnings
from dataclasses import dataclass, field
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from freecad_fiveaxis.core.cl_path import CLPath, Motion

from .cutter import Cutter
from .errors import ProgramError
from .findings import Finding, Severity
from .number_text import Choice, Column, table
from .progress import Progress, silent
from .records import Bools, Bytes, Floats, Ints

POSITION_DECIMALS, AXIS_DECIMALS, FEED_DECIMALS = 6, 9, 4
INCH = 25.4
NOT_UNIT = 1e-4
"""An axis whose length differs by more than this from 1 was not meant as a unit vector; four printed decimals stay below."""
_KNOWN = """MACHIN UNITS CUTTER LOADTL LOAD MULTAX SPINDL COOLNT TOOLNO INTOL OUTTOL TOLER END FINI STOP OPSTOP REWIND
CLEARP SEQNO LEADER AUXFUN PREFUN SELCTL TOOLPATH END-OF-PATH TLDATA PAINT FEDRAT RAPID"""
_SPOILING = "TLAXIS CIRCLE MOVARC CYCLE GODLTA TRACUT ORIGIN TRANS ROTATE COPY GOHOME CUTCOM INDEX CALL ARCSLP MSYS"
KNOWN, SPOILING = frozenset(_KNOWN.split()), frozenset(_SPOILING.split())
"""SPOILING: statements that move the tool or the coordinates, and are not interpreted."""
FREE_TEXT = ("PARTNO", "PPRINT", "INSERT", "REMARK", "DISPLY", "TPRINT")
TEXT = bytes({*range(32, 256), *b"\t\n\v\f\r"})
COMMENT = re.compile(rb"\$\$[^\n]*")
CONTINUED = re.compile(rb"\$[^\n]*\n")
SOFT = b"\x01"
"""Stands for the end of a line within a statement."""
NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:E[+-]?\d+)?")


def write_apt(path: CLPath, cutter: Cutter, title: str, progress: Progress = silent) -> bytes:
    """The CL file of a path: positions with 6 decimals, mm, axes with 9, feeds mm/min. ASCII, lines end in LF."""
    plain = re.sub(r"[^A-Za-z0-9 ._+-]", "-", title)[:60]
    head = f"PARTNO {plain}\nUNITS/MM\nCUTTER/{cutter.diameter:.4f},{cutter.radius:.4f}\nLOADTL/1\nMULTAX/ON\n"
    rapid, link = path.motion == Motion.RAPID, path.motion == Motion.LINK
    feed_said = _new_value(path.feed, ~rapid)
    link_said = _new_value(link.astype(np.float64), ~rapid)
    if len(link_said):
        link_said[:1] &= link[:1]
    axes = [Column(b",", path.axis[:, k], AXIS_DECIMALS) for k in range(3)]
    rows = table(
        [
            Choice(np.where(link_said, 1 + link, 0), (b"", b"PPRINT/MOTION,CUT\n", b"PPRINT/MOTION,LINK\n")),
            Column(b"FEDRAT/", path.feed, FEED_DECIMALS, feed_said),
            Choice(feed_said.view(np.int8), (b"", b",MMPM\n")),
            Choice(rapid.view(np.int8), (b"GOTO/", b"RAPID\nGOTO/")),
            *(Column(b"," if k else b"", path.tip[:, k], POSITION_DECIMALS) for k in range(3)),
            *axes,
        ],
        progress=progress,
    )
    return head.encode("ascii") + rows + b"END\nFINI\n"


def _new_value(value: Floats, rows: Bools) -> Bools:
    """Where, among the chosen rows, the value differs from that of the chosen row before."""
    at = np.flatnonzero(rows)
    said = np.zeros(len(value), np.bool_)
    said[at] = np.diff(value[at], prepend=np.nan) != 0.0
    return said


def read_apt(text: bytes | str, feed: float = 0.0, progress: Progress = silent) -> CLPath:
    """The CLPath of an APT text: a row for each GOTO (and FROM, a rapid). ``feed`` mm/min serves until the first FEDRAT.

    The contact is the tip and the normal the axis; face and co-edge are -1; ``pass_`` counts the runs of cutting moves. GOTO
    with three numbers keeps the axis (0, 0, 1 at first). Raises ProgramError, naming line and column.
    """
    source = _Source(text.encode("utf-8") if isinstance(text, str) else text)
    progress("reading CL", 0.2)
    point, axis = _poses(source)
    progress("reading CL", 0.7)
    said = _read_statements(source)
    rows = len(point)
    scale = _held([(0, 1.0), *said.scale], rows)
    rapid, link = np.zeros(rows, np.bool_), _held([(0, 0.0), *said.link], rows) > 0.0
    rapid[[row for row in said.rapid if row < rows]] = True
    rapid[source.goto_before[source.starts(b"FROM/")]] = True
    motion = np.where(rapid, Motion.RAPID, np.where(link, Motion.LINK, Motion.CUT)).astype(np.int8)
    speed = np.where(rapid, 0.0, _held([(0, feed), *said.feed], rows))
    tip, unit = point * scale[:, None], axis / _lengths(axis, source)[:, None]
    findings = (*said.findings(), *_row_findings(source, axis, motion, speed))
    none = np.full(rows, -1)
    return CLPath(tip, unit, motion, speed, tip, unit, none, none, _runs(motion), findings)


class _Source:
    """The statements of the text without blanks: where each begins and ends, its line, and which are GOTO (or FROM)."""

    def __init__(self, raw: bytes) -> None:
        raw = raw.rstrip(b"\x1a\0\r\n\t ").removeprefix(b"\xef\xbb\xbf")
        if control := raw.translate(None, TEXT):
            offset = raw.index(control[:1])
            raise ProgramError(f"this is no CL file: byte {control[0]} at offset {offset}; give a text file", control[0])
        self.plain = raw.replace(b"\r\n", b"\n").replace(b"\r", b"\n").upper()
        joined = COMMENT.sub(b"", self.plain) if b"$$" in self.plain else self.plain
        joined = CONTINUED.sub(SOFT, joined) if b"$" in joined else joined
        self.text = joined.translate(None, b" \t\v\f$") + b"\n"
        self.code = np.frombuffer(self.text, np.uint8)
        ends = np.flatnonzero(self.code == ord("\n"))
        self.line = np.arange(1, len(ends) + 1)
        soft = np.flatnonzero(self.code == SOFT[0])
        if len(soft):
            self.line += np.searchsorted(soft, np.concatenate([[0], ends[:-1]]))
        begins = np.concatenate([[0], ends[:-1] + 1])
        real = ends > begins
        self.begin, self.end, self.line = begins[real], ends[real], self.line[real]
        self._cut_at_end()
        self.goto = self.starts(b"GOTO/") | self.starts(b"FROM/")
        self.goto_before: Ints = np.cumsum(self.goto) - self.goto

    def starts(self, word: bytes) -> Bools:
        """Which statements start with the word."""
        found: Bools = self.end - self.begin >= len(word)
        for k, byte in enumerate(word):
            found &= self.code[np.minimum(self.begin + k, len(self.code) - 1)] == byte
        return found

    def goto_rows(self, word: bytes) -> Ints:
        """The rows of the path that come from statements with that word."""
        return self.goto_before[self.starts(word)]

    def statement(self, k: int) -> str:
        return self.text[self.begin[k] : self.end[k]].replace(SOFT, b"").decode("latin-1")

    def fail(self, k: int, part: str, reason: str) -> NoReturn:
        """Raise for statement k, pointing at ``part`` of it in the file."""
        lines = self.plain.split(b"\n")
        line = int(self.line[k])
        last = line + self.text.count(SOFT, int(self.begin[k]), int(self.end[k]))
        for number in range(line, last + 1):
            column = lines[number - 1].find(part.encode("latin-1")) if part else -1
            if column >= 0:
                break
        else:
            number, column = line, 0
        raise ProgramError(f"line {number}, column {column + 1}: {reason}: {self.statement(k)[:60]!r}", part)

    def _cut_at_end(self) -> None:
        last = np.flatnonzero(self.starts(b"FINI"))
        self.after_end = int(self.line[last[0] + 1]) if len(last) and last[0] + 1 < len(self.line) else 0
        if len(last):
            keep = slice(0, last[0] + 1)
            self.begin, self.end, self.line = self.begin[keep], self.end[keep], self.line[keep]


def _poses(source: _Source) -> tuple[Floats, Floats]:
    """Positions (n, 3) as printed, and axes (n, 3) as printed, carried on where a GOTO has none."""
    goto = np.flatnonzero(source.goto)
    if not len(goto):
        raise ProgramError("the CL file holds no GOTO statement", None)
    begin, end = source.begin[goto] + 5, source.end[goto]
    edge = np.zeros(len(source.code) + 1, np.int8)
    edge[begin] += 1
    edge[end + 1] -= 1  # the end of line goes along: it separates the last number from the next
    chosen = source.code[np.cumsum(edge[:-1], dtype=np.int8).view(np.bool_)]
    commas = np.searchsorted(np.flatnonzero(chosen == ord(",")), np.flatnonzero(chosen == ord("\n")))
    per_goto = np.diff(commas, prepend=0) + 1
    value = _floats(chosen)
    wrong = (per_goto != 3) & (per_goto != 6)
    if value is None or len(value) != per_goto.sum() or wrong.any():
        _explain(source, goto)
    first = np.cumsum(per_goto) - per_goto
    axis = np.zeros((len(goto) + 1, 3))
    axis[0, 2] = 1.0
    full = per_goto == 6
    axis[1:][full] = value[first[full][:, None] + (3, 4, 5)]
    last = np.maximum.accumulate(np.where(full, np.arange(1, len(goto) + 1), 0))
    return value[first[:, None] + (0, 1, 2)], axis[last]


def _floats(chosen: NDArray[Any]) -> Floats | None:
    """All numbers of the GOTO statements; None where there is something else among them."""
    text = chosen.tobytes().replace(SOFT, b"").replace(b"\n", b",")
    if text.translate(None, b"0123456789+-.E,"):
        return None
    code = np.frombuffer(text, np.uint8)
    after_comma = np.concatenate([[0], np.flatnonzero(code == ord(","))[:-1] + 1])
    if not np.add.reduceat(code - np.uint8(ord("0")) < 10, after_comma, dtype=np.int32).all():
        return None  # a field without a digit
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)  # numpy's way to say that it stopped early
        try:
            value = np.fromstring(text.replace(b",", b" "), np.float64, sep=" ")
        except (DeprecationWarning, ValueError):
            return None
    return value if np.isfinite(value).all() else None


def _explain(source: _Source, goto: Ints) -> NoReturn:
    """Find the GOTO that cannot be read, and say why."""
    for k in goto:
        parts = source.statement(k)[5:].split(",")
        for part in parts:
            if not NUMBER.fullmatch(part) or not np.isfinite(float(part)):
                source.fail(k, part, f"{part!r} is no number")
        if len(parts) not in (3, 6):
            source.fail(k, "", f"GOTO has {len(parts)} numbers; give 3 or 6")
    raise ProgramError("the GOTO statements cannot be read", None)


@dataclass
class _Said:
    """What the other statements say, with the row of the path from which on it holds."""

    feed: list[tuple[int, float]] = field(default_factory=list)
    link: list[tuple[int, float]] = field(default_factory=list)
    scale: list[tuple[int, float]] = field(default_factory=list)
    rapid: list[int] = field(default_factory=list)
    passed_over: dict[str, list[int]] = field(default_factory=dict)

    def findings(self) -> list[Finding]:
        found = []
        for name, lines in self.passed_over.items():
            severity = Severity.ERROR if name in SPOILING else Severity.WARNING
            text = f"{name} is not interpreted ({len(lines)} statements); what it does is missing in the path."
            found.append(Finding(severity, "statement-not-interpreted", text, float(len(lines)), line=lines[0]))
        return found


def _read_statements(source: _Source) -> _Said:
    said = _Said()
    for k in np.flatnonzero(~source.goto).tolist():
        statement, row = source.statement(k), int(source.goto_before[k])
        name, _, rest = statement.partition("/")
        if statement.startswith("PPRINT/MOTION,"):
            said.link.append((row, float(rest == "MOTION,LINK")))
        elif statement.startswith(FREE_TEXT):
            continue
        elif name == "RAPID":
            said.rapid.append(row)
        elif name == "UNITS":
            said.scale.append((row, _unit_scale(source, k, rest)))
        elif name == "FEDRAT":
            said.feed.append((row, _feed_rate(source, k, rest, said.scale[-1][1] if said.scale else 1.0)))
        elif name not in KNOWN:
            name = re.sub(r"[^A-Z].*", "", name) or name[:20]
            said.passed_over.setdefault(name, []).append(int(source.line[k]))
    return said


def _unit_scale(source: _Source, k: int, rest: str) -> float:
    scales = {"MM": 1.0, "INCHES": INCH, "INCH": INCH, "IN": INCH, "CM": 10.0}
    if rest not in scales:
        source.fail(k, rest, "unknown unit; known are MM and INCHES")
    return scales[rest]


def _feed_rate(source: _Source, k: int, rest: str, scale: float) -> float:
    """mm/min; a unit of the statement's own goes before the file's."""
    parts = rest.split(",")
    numbers = [part for part in parts if NUMBER.fullmatch(part)]
    if len(numbers) != 1 or not 0.0 < float(numbers[0]) < np.inf:
        source.fail(k, rest, "FEDRAT needs one feed above 0")
    if {"IPR", "MMPR", "PERREV"} & set(parts):
        source.fail(k, rest, "a feed per turn needs the spindle speed; give it per minute")
    own = {"IPM": INCH, "MMPM": 1.0}
    return float(numbers[0]) * next((own[part] for part in parts if part in own), scale)


def _held(events: list[tuple[int, float]], rows: int) -> Floats:
    """The last event's value at or before each row (the first event is at row 0)."""
    row = np.array([row for row, _ in events] + [rows])
    return np.repeat(np.array([value for _, value in events]), np.diff(row))


def _lengths(axis: Floats, source: _Source) -> Floats:
    length: Floats = np.linalg.norm(axis, axis=1)
    if not length.all():
        source.fail(int(np.flatnonzero(source.goto)[np.argmin(length)]), "", "the tool axis is 0, 0, 0")
    return length


def _row_findings(source: _Source, axis: Floats, motion: Bytes, speed: Floats) -> list[Finding]:
    line = source.line[source.goto]
    off = np.abs(np.linalg.norm(axis, axis=1) - 1.0)
    unfed = (motion != Motion.RAPID) & (speed <= 0.0)
    found = []
    if (off > NOT_UNIT).any():
        text = f"{int((off > NOT_UNIT).sum())} tool axes are no unit vectors; they are scaled to length 1."
        first = int((off > NOT_UNIT).argmax())
        found.append(Finding(Severity.WARNING, "axis-not-unit", text, float(off.max()), NOT_UNIT, "1", line=int(line[first])))
    if unfed.any():
        text = f"{int(unfed.sum())} moves come before any FEDRAT; give a feed."
        found.append(Finding(Severity.WARNING, "no-feed", text, line=int(line[unfed.argmax()])))
    if source.after_end:
        found.append(Finding(Severity.NOTE, "text-after-end", "The text after FINI is not read.", line=source.after_end))
    return found


def _runs(motion: Bytes) -> Ints:
    """Counts the runs of cutting moves; -1 in the others."""
    cut = motion == Motion.CUT
    begins = cut & ~np.concatenate([[False], cut[:-1]])
    return np.where(cut, np.cumsum(begins) - 1, -1)
