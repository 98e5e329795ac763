# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext's mirror image, rotation and scalings (cycles 8, 10, 11, 26) as coordinates (:mod:`.planes`).

They turn no axes: X Y Z are the tip's where the control guides it, else those of the axes.

order    the shift of the zero (cycle 7), then in its coordinates the mirror image, in those the rotation,
         then the scalings; each refers to the active zero (Heidenhain TNC 640, cycle programming, coordinate
         transformation cycles). Not looked up in a manual: whether the order of the program counts instead.
named    therefore where the order in which a program writes them would say something else: a mirror image
         after a rotation that is on, a shift of the zero within (back to 0 is clear). Beside a tilted plane;
         tool vectors; an arc about a CC of other coordinates, or whose two axes have unlike factors.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say

from . import codes, corners
from .arcs import AXES
from .canned_cycles import NOT_IN_TEXT
from .codes import Grammar
from .findings import shift_finding
from .heidenhain_changes import ORDER, SCALE, TURN
from .lines import Lines, last_of
from .plane_calls import HEIDENHAIN, STAY, Change, Tilt, about
from .planes import report_change, tilts_of
from .positions import ABSOLUTE, axis_words
from .shifts import NAMES, SHIFT_LETTERS, find_shift_lines
from .words import Words

NEAR = 1e-9
"""Two ways to the same coordinates, of factors and mm."""
WHICH_ORDER = say("another of them is on, and which comes first is not known; end that one first")
SHIFTED_WITHIN = say(
    "a mirror image, rotation or scaling is on, and which comes first is not known; end it first"
)
IN_TILTED = say("a tilted plane is on; end it first")
OVER_FRAME = say("a mirror image, rotation or scaling is on; end it first")
OTHER_CENTRE = say("an arc goes about a CC that stands before it; give CC again")
VECTORS = say("tool axes are told by vectors in it")
UNLIKE = say("an arc or a rounding lies in a plane whose axes have unlike factors")


@dataclass(frozen=True, eq=False)
class _Map:
    """Coordinates ``turn`` (3, 3), which may mirror and scale, with their zero at ``origin`` (3,)."""

    turn: Floats = field(default_factory=lambda: np.eye(3))
    origin: Floats = field(default_factory=lambda: np.zeros(3))

    def on(self, other: _Map) -> _Map:
        """Coordinates ``other`` that stand in these."""
        return _Map(self.turn @ other.turn, self.origin + self.turn @ other.origin)

    def like(self, other: _Map) -> bool:
        """Whether both are the same."""
        return bool(
            np.allclose(self.turn, other.turn, atol=NEAR)
            and np.allclose(self.origin, other.origin, atol=NEAR)
        )


NOTHING = _Map()


@dataclass(eq=False)
class _State:
    """What is on: ``parts`` by cycle, ``angle`` deg of the rotation, whether a plane is ``tilted``; what was
    found of the lines: their new ``tilts`` (None: it does nothing), ``findings``, the ``dropped`` shifts."""

    parts: dict[str, _Map] = field(default_factory=lambda: dict.fromkeys(ORDER, NOTHING))
    angle: float = 0.0
    tilted: bool = False
    tilts: dict[int, Tilt | None] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)
    dropped: list[int] = field(default_factory=list)

    def whole(self) -> _Map:
        """All that is on, in the control's order."""
        whole = NOTHING
        for name in ORDER:
            whole = whole.on(self.parts[name])
        return whole

    def active(self) -> bool:
        """Whether anything is."""
        return any(not part.like(NOTHING) for part in self.parts.values())

    def frame(self) -> Tilt:
        """Return the plane that stands for it."""
        if not self.active():
            return Tilt(HEIDENHAIN, name="CYCL DEF")
        whole = self.whole()
        x, y, z = whole.origin.tolist()
        return Tilt(HEIDENHAIN, whole.turn, (x, y, z), name="CYCL DEF", frame=True)


def replace_changes(words: Words, lines: Lines, grammar: Grammar) -> tuple[Words, list[Finding]]:
    """Return the words with these cycles as planes; without any, the same object."""
    if not any(tilt.change for tilt in words.tilts):
        return words, []
    state, tilts, clear = _State(), tilts_of(lines, grammar), _find_clearing(lines)
    shifts = ~np.isnan(find_shift_lines(lines, grammar))
    normal = AXES[lines.mode(codes.PLANES, 0), 2]
    for row in sorted({*tilts, *np.flatnonzero(shifts).tolist()}):
        tilt = tilts.get(row)
        if tilt is None:
            _shift(state, row, bool(clear[row]))
        elif tilt.change is None:
            _plane(state, row, tilt)
        else:
            _change(state, row, tilt, tilt.change, int(normal[row]))
    now = _find_frames(state, lines.count)
    return _with_frames(words, state), [*state.findings, *_report_lost(lines, grammar, state, now)]


def _shift(state: _State, row: int, clear: bool) -> None:
    """Move the zero under what is on."""
    if not state.active():
        return
    if clear:
        state.tilts[row] = state.frame()
        return
    state.findings.append(shift_finding(NAMES["heidenhain"], SHIFTED_WITHIN, row))
    state.dropped.append(row)


def _plane(state: _State, row: int, tilt: Tilt) -> None:
    """Tilt a plane, or end it."""
    if tilt.refused:
        return
    if state.active() and tilt.turn is None and tilt.move == STAY and not tilt.away:
        state.tilts[row] = state.frame()
        return
    if state.active():
        state.findings.append(report_change(tilt.name, OVER_FRAME, row))
        state.parts = dict.fromkeys(ORDER, NOTHING)
    state.tilted = tilt.turn is not None


def _change(state: _State, row: int, tilt: Tilt, change: Change, normal: int) -> None:
    """Set one of them anew."""
    state.tilts[row] = None
    angle = change.angle + (state.angle if change.on else 0.0)
    part = _part(change, angle, normal)
    reason = tilt.refused or _refuse(state, change.cycle, part)
    if reason:
        state.findings.append(report_change(tilt.name, reason, row))
        return
    before = state.active()
    state.parts[change.cycle] = part
    state.angle = angle if change.cycle == TURN else state.angle
    if before or state.active():
        state.tilts[row] = state.frame()
    if change.cycle == SCALE and not part.like(NOTHING):
        state.findings.append(_note_height(tilt.name, row))


def _part(change: Change, angle: float, normal: int) -> _Map:
    """Return the coordinates of one of them."""
    turn = about(normal, angle) if change.cycle == TURN else np.diag(change.factors)
    centre = np.array(change.about)
    return _Map(turn, centre - turn @ centre)


def _refuse(state: _State, cycle: str, part: _Map) -> str:
    """Why the coordinates are not known with that part anew."""
    if part.like(NOTHING) and state.parts[cycle].like(NOTHING):
        return ""
    if state.tilted:
        return IN_TILTED
    later = [state.parts[name] for name in ORDER[ORDER.index(cycle) + 1 :]]
    return "" if all(part.on(one).like(one.on(part)) for one in later) else WHICH_ORDER


def _note_height(name: str, row: int) -> Finding:
    text = say(
        "{name} is taken for X, Y and Z, as a TNC 640 takes it; an iTNC 530 whose MP7410 says so scales the "
        "working plane alone. Check it on the control.",
        name=name,
    )
    return replace(report_finding(codes.SHIFT[0], text, line=row), severity=Severity.WARNING)


def _find_clearing(lines: Lines) -> Bools:
    """Whether the words of each line, as a shift, say nothing but zeros."""
    clear = np.ones(lines.count, np.bool_)
    for letter in "XYZABC":
        value, kind = axis_words(lines, letter)
        clear &= np.nan_to_num(value) == 0.0
        clear &= (kind == ABSOLUTE) | np.isnan(value)
    return clear


def _find_frames(state: _State, count: int) -> Ints:
    """Return the line (count,) that began the coordinates of each line, 0 where none are on."""
    framed = {row: tilt.turn is not None for row, tilt in state.tilts.items() if tilt is not None}
    row_of = np.zeros(count, np.int64)
    row_of[[row for row, on in framed.items() if on]] = [row for row, on in framed.items() if on]
    return row_of[last_of(np.array(list(framed), np.int64), count)]


def _report_lost(lines: Lines, grammar: Grammar, state: _State, now: Ints) -> list[Finding]:
    """Report the first line of each kind that these coordinates lead where nobody knows: an arc about another
    centre, an arc or a rounding that does not stay round, a tool vector."""
    moving = ~np.isnan(lines.columns("XYZ" + "xyz")).all(axis=1) & ~lines.any_of(grammar.no_move)
    arcs = moving & (lines.mode(grammar.motion, codes.NONE) == codes.ARC)
    by_centre = arcs & np.isnan(lines.columns("IJKR")).all(axis=1)
    centre = last_of(np.flatnonzero(~np.isnan(lines.columns(codes.CENTRE)).all(axis=1)), lines.count)
    other = np.flatnonzero(by_centre & (now[centre] != now))
    found = [report_change("CC", OTHER_CENTRE, int(other[0]))] if len(other) else []
    vectors = np.flatnonzero(~np.isnan(lines.columns(codes.VECTOR)).all(axis=1) & (now > 0))
    found += [report_change("LN", VECTORS, int(row)) for row in vectors[:1]]
    if corners.LETTER in lines.letters:
        arcs |= ~np.isnan(lines.column(corners.LETTER))
    rows, plane = np.flatnonzero(arcs & (now > 0)), lines.mode(codes.PLANES, 0)
    _, first = np.unique(3 * now[rows] + plane[rows], return_index=True)
    for row in rows[np.sort(first)].tolist():
        tilt = state.tilts[int(now[row])]
        if tilt is not None and tilt.turn is not None and not _is_even(tilt.turn[:, AXES[plane[row], :2]]):
            return [*found, report_change("CYCL DEF 26", UNLIKE, row)]
    return found


def _is_even(axes: Floats) -> bool:
    """Whether two axes (3, 2) keep circles round."""
    square = axes.T @ axes
    return bool(abs(square[0, 0] - square[1, 1]) < NEAR and abs(square[0, 1]) < NEAR)


def _with_frames(words: Words, state: _State) -> Words:
    """Return the words with the planes of the state, for those that stood in their lines, and without the
    shifts that were dropped."""
    plane = words.letter == ord(codes.PLANE)
    gone = plane & np.isin(words.line, list(state.tilts))
    shift = np.isin(words.letter, [ord(one) for one in SHIFT_LETTERS])
    gone |= (shift | _is_datum_code(words)) & np.isin(words.line, state.dropped)
    new = [(row, tilt) for row, tilt in sorted(state.tilts.items()) if tilt is not None]
    line = np.concatenate([words.line[~gone], np.array([row for row, _ in new], np.int64)])
    order = np.argsort(line, kind="stable")
    index = len(words.tilts) + np.arange(len(new), dtype=float)
    start = None if words.start is None else np.append(words.start[~gone], [NOT_IN_TEXT] * len(new))[order]
    return replace(
        words,
        letter=np.append(words.letter[~gone], np.full(len(new), ord(codes.PLANE), np.int8))[order],
        value=np.append(words.value[~gone], index)[order],
        line=line[order],
        start=start,
        tilts=(*words.tilts, *(tilt for _, tilt in new)),
    )


def _is_datum_code(words: Words) -> Bools:
    """Whether each word is the G54 of DIN/ISO."""
    return np.asarray((words.letter == ord("G")) & (words.value == codes.DATUM / 10.0))
