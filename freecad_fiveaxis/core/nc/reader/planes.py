# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tilted working planes: which lines stand in one, and where their words lead.

in the plane   X Y Z are coordinates p of the plane: the tip, in the work, is ``origin + turn p``, wherever
               the rotary axes stand; they must stand so that the tool lies along the plane's normal,
               ``turn``'s third column.
turning line   G53.1, PLANE ... TURN or MOVE, CYCLE800: a block of its own in which the rotary axes turn
               there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine.kinematics import Chain

from . import codes, plane_calls
from .arcs import AXES
from .codes import Grammar
from .lines import Lines, last_of
from .old_working_plane import settle_meaning
from .plane_calls import FANUC, HAAS, MOVE, TURN, Tilt

WHICH_FIRST = say("P1 turns about more than one axis, and in which order is not known here")
NAMES = {FANUC: "G68.2", plane_calls.SIEMENS: "CYCLE800"}
JOINTS, GUIDED, IN_PLANE = 0, 1, 2
"""What X Y Z of a block mean: where the axes stand; the tip; from IN_PLANE on, the tip in that plane."""


@dataclass(eq=False)
class Planes:
    """``meaning`` (lines,): 0, or IN_PLANE + the index of the plane in which each line stands; ``origin`` (k,
    3) mm, ``turn`` (k, 3, 3) of the planes; ``turning``: what the turning lines say, with the plane (3, 3),
       its axes as columns, whose normal the
    tool shall take; ``frame`` (k,): programmed frames, which come twice: for the tip, and (``axes``) for the
    axes."""

    meaning: Ints
    origin: Floats
    turn: Floats
    turning: dict[int, tuple[Tilt, Floats]]
    findings: tuple[Finding, ...]
    frame: Bools
    axes: Bools

    def by_tip(self, meaning: Ints) -> Bools:
        """Which of ``meaning`` (m,) are planes whose coordinates are the tip's."""
        return self._of(~self.axes, meaning)

    def frames(self, meaning: Ints) -> Bools:
        """Which of ``meaning`` (m,) are programmed frames."""
        return self._of(self.frame, meaning)

    def _of(self, which: Bools, meaning: Ints) -> Bools:
        return np.asarray((meaning >= IN_PLANE) & np.append(which, False)[np.maximum(meaning - IN_PLANE, -1)])

    def modes(self, mode: Ints, on: Bools) -> tuple[Ints, Bools]:
        """Return the motion modes (lines,) and whether the control guides the tip, with those of the turning
        lines."""
        mode, on, lines = mode.copy(), on.copy(), list(self.turning)
        mode[lines] = codes.RAPID
        on[lines] = [tilt.move == MOVE for tilt, _ in self.turning.values()]
        return mode, on

    def of_blocks(self, at: Ints, on: Bools, words: list[tuple[Floats, Bytes]]) -> Ints:
        """Return what X Y Z mean in the blocks of the lines ``at`` (m,) with these words: rotary words alone
        turn the axes, and X Y Z stand, unless the control guides the tip (``on`` (m,))."""
        linear = np.logical_or.reduce([kind != 0 for _, kind in words[:3]])
        rotary = np.logical_or.reduce([kind != 0 for _, kind in words[3:]])
        now = self.meaning[at]
        frame = self.frames(now)
        meaning = np.where((now >= IN_PLANE) & (linear | ~rotary | on | frame), now + (frame & ~on), on)
        turning = np.searchsorted(at, list(self.turning))
        meaning[turning] = on[turning]
        return np.asarray(meaning, np.int64)

    def in_work(self, place: Floats, meaning: Ints) -> Floats:
        """Places (m, 3) mm of the tip in the work, for what the words say; those that stand in no plane as
        they are."""
        rows = np.flatnonzero(meaning >= IN_PLANE)
        which = meaning[rows] - IN_PLANE
        place = place.copy(order="K")
        place[rows] = self.origin[which] + np.einsum("nij,nj->ni", self.turn[which], place[rows])
        return place

    def vectors_in_work(self, vector: Floats, meaning: Ints) -> Floats:
        """Tool axes (m, 3) told in programmed frames, in the work; the others as they are."""
        rows = np.flatnonzero(self.frames(meaning))
        vector = vector.copy()
        vector[rows] = np.einsum("nij,nj->ni", self.turn[meaning[rows] - IN_PLANE], vector[rows])
        return vector

    def in_plane(self, place: Floats, meaning: int) -> Floats:
        """Return the other way round, for one place (3,)."""
        k = meaning - IN_PLANE
        if self.is_rigid()[k]:
            return np.asarray(self.turn[k].T @ (place - self.origin[k]))
        return np.asarray(np.linalg.solve(self.turn[k], place - self.origin[k]))

    def is_rigid(self) -> Bools:
        """Whether each plane (k,) is turned alone, neither mirrored nor scaled."""
        square = np.einsum("nji,njk->nik", self.turn, self.turn)
        kept = np.isclose(square, np.eye(3), atol=1e-9).all(axis=(1, 2))
        return np.asarray(kept & (np.linalg.det(self.turn) > 0.0))

    def scale_travel(self, travel: Floats, meaning: Ints) -> Floats:
        """Return the travel (m, 5) as it is in the work where X Y Z are scaled."""
        rows = np.flatnonzero(self._of(~self.is_rigid(), meaning))
        travel = travel.copy()
        travel[rows, :3] = np.einsum("nij,nj->ni", self.turn[meaning[rows] - IN_PLANE], travel[rows, :3])
        return travel


def planes_of(
    lines: Lines, grammar: Grammar, kinematics: Chain, dynamic: Mapping[int, Tilt] = MappingProxyType({})
) -> Planes | None:
    """Return the tilted planes of a program; None where it has none. ``dynamic``: those that
    :mod:`.dynamic_offset` knows better."""
    named = {row: settle_meaning(tilt, kinematics) for row, tilt in tilts_of(lines, grammar).items()}
    tilts = dict(sorted({**named, **dynamic}.items()))
    return _planes(tilts, lines, grammar) if tilts else None


def tilts_of(lines: Lines, grammar: Grammar) -> dict[int, Tilt]:
    """Return the lines that begin, turn to or end a tilted plane, in their order."""
    return dict(sorted((_by_codes(lines, grammar) if grammar.name == "iso" else _by_words(lines)).items()))


def _by_words(lines: Lines) -> dict[int, Tilt]:
    """Return what :mod:`.siemens` and :mod:`.heidenhain` found."""
    if codes.PLANE not in lines.letters:
        return {}
    number = lines.column(codes.PLANE)
    at = np.flatnonzero(~np.isnan(number))
    return {row: lines.words.tilts[int(number[row])] for row in at.tolist()}


def _by_codes(lines: Lines, grammar: Grammar) -> dict[int, Tilt]:
    tilts = dict[int, Tilt]()
    if codes.DYNAMIC[0] in lines.code:
        of_haas = np.isin(lines.code, codes.DYNAMIC)
        for row, code in zip(lines.code_line[of_haas].tolist(), lines.code[of_haas].tolist(), strict=True):
            tilts[row] = Tilt(HAAS, np.eye(3) if code == codes.DYNAMIC[0] else None)
    turns = codes.TURN not in grammar.codes and codes.TURN in lines.code
    if not turns and not np.isin(lines.code, codes.TILT).any():
        return tilts
    columns = {letter: lines.column(letter) for letter in "XYZIJKPR"}
    chosen = np.isin(lines.code, (*codes.TILT, codes.LEVEL, *([codes.TURN] if turns else [])))
    normal, steps = AXES[lines.mode(codes.PLANES, 0), 2], lines.mode(codes.DISTANCE, 0) == 1
    for row, code in zip(lines.code_line[chosen].tolist(), lines.code[chosen].tolist(), strict=True):
        given = {letter: float(one[row]) for letter, one in columns.items() if not np.isnan(one[row])}
        if code == codes.TILT[0]:
            tilts[row] = _euler(given)
        elif code == codes.TURN:
            tilts[row] = _turn_in_plane(given, int(normal[row]), bool(steps[row]))
        elif code == codes.TILT[1]:
            tilts[row] = Tilt(FANUC, move=TURN, name="G53.1")
        else:
            tilts[row] = Tilt(FANUC)
    return tilts


def _euler(given: dict[str, float]) -> Tilt:
    way = given.get("P", 0.0)
    known = way in (0.0, plane_calls.ROLL_PITCH_YAW)
    if not known or "R" in given:
        name = "R" if known else f"P{way:g}"
        return Tilt(FANUC, refused=say("{rest} is not known here", rest=name))
    x, y, z, i, j, k = (given.get(letter, 0.0) for letter in "XYZIJK")
    if why := plane_calls.beyond((x, y, z, i, j, k)):
        return Tilt(FANUC, refused=why)
    if way == plane_calls.ROLL_PITCH_YAW:
        turn = plane_calls.turn_about_one((i, j, k))
        return Tilt(FANUC, turn, (x, y, z)) if turn is not None else Tilt(FANUC, refused=WHICH_FIRST)
    return Tilt(FANUC, plane_calls.euler((i, j, k)), (x, y, z))


def _turn_in_plane(given: dict[str, float], normal: int, steps: bool) -> Tilt:
    """Return the coordinates that G68 turns about a place of the plane (Fanuc B-63324EN, 13.5, coordinate
    system rotation)."""
    axes = ["XYZ"[axis] for axis in range(3) if axis != normal]
    if steps:
        return Tilt(FANUC, refused=say("it stands under G91"), name="G68")
    if "R" not in given or not {*axes} <= given.keys():
        return Tilt(FANUC, refused=say("not all its values are given, or others"), name="G68")
    if why := plane_calls.beyond([given["R"], *(given[axis] for axis in axes)]):
        return Tilt(FANUC, refused=why, name="G68")
    turn = plane_calls.about(normal, given["R"])
    about = np.array([given[axis] if axis in axes else 0.0 for axis in "XYZ"])
    x, y, z = (about - turn @ about).tolist()
    return Tilt(FANUC, turn, (x, y, z), name="G68", frame=True)


def _planes(tilts: dict[int, Tilt], lines: Lines, grammar: Grammar) -> Planes:
    scale = lines.unit(grammar)
    origins, turns, turning, findings = (
        list[Floats](),
        list[Floats](),
        dict[int, tuple[Tilt, Floats]](),
        list[Finding](),
    )
    state, now, frames = np.zeros(lines.count, np.int64), 0, list[bool]()
    before = np.nan_to_num(lines.columns(codes.ORIGIN))
    for row, tilt in tilts.items():
        reason = _wrong(tilt, now) or _without_centres(tilt, lines)
        if reason:
            findings.append(report_refusal(tilt.name or NAMES[tilt.rule], reason, row))
        elif tilt.turn is not None:
            relative = tilt.relative and now
            zero = (np.array(tilt.origin) + tilt.turn @ tilt.shift) * scale[row]
            on = origins[now - IN_PLANE] + turns[now - IN_PLANE] @ zero if relative else before[row] + zero
            origins.append(on)
            turns.append(turns[now - IN_PLANE] @ tilt.turn if relative else tilt.turn)
            now = IN_PLANE + len(turns) - 1
            frames += [tilt.frame] * (1 + tilt.frame)
            if tilt.frame:
                origins.append(origins[-1])
                turns.append(turns[-1])
        elif not (tilt.rule == FANUC and tilt.move == TURN):
            now = 0
        if not reason and tilt.move != plane_calls.STAY:
            turning[row] = tilt, turns[now - IN_PLANE] if now else np.eye(3)
        if tilt.away and not reason:
            findings.append(_away(row))
        state[row] = now
    meaning = state[last_of(np.array(sorted(tilts)), lines.count)]
    return Planes(
        meaning,
        np.reshape(origins, (-1, 3)),
        np.reshape(turns, (-1, 3, 3)),
        turning,
        tuple(findings),
        *_kinds(frames),
    )


def _kinds(frames: list[bool]) -> tuple[Bools, Bools]:
    """Which planes are frames, and the second of each two of them."""
    frame = np.array(frames, np.bool_)
    return frame, np.asarray(frame & (np.cumsum(frame) % 2 == 0))


def _wrong(tilt: Tilt, now: int) -> str:
    """Why a line is not understood, where another plane (``now``) may be on."""
    if tilt.refused or tilt.rule != FANUC:
        return tilt.refused
    if tilt.turn is not None and now:
        return say("another plane is on; end it first")
    return say("no tilted plane is on") if tilt.move == TURN and not now else ""


def _without_centres(tilt: Tilt, lines: Lines) -> str:
    """Why nobody knows where the axes stand in a plane, for a machine that is still looked for."""
    known = (
        lines.assumed.centres or tilt.turn is None or tilt.frame
    )  # frames turn the words of the axes themselves
    return (
        ""
        if known
        else say("the machine's centres of rotation, about which it leads the axes, are not known")
    )


def report_refusal(name: str, reason: str, row: int) -> Finding:
    """Return what is not interpreted, in the line of index ``row``."""
    text = say(
        "{name}: this tilted plane is not interpreted, and the coordinates after it are taken as they were "
        "before: {reason}. Post it another way, or post without planes.",
        name=name,
        reason=reason,
    )
    return report_finding(codes.SHIFT[0], text, line=row)


def report_change(name: str, reason: str, row: int) -> Finding:
    """Return which change of the coordinates is not interpreted, in the line of index ``row``."""
    text = say(
        "{name}: this change of the coordinates is not interpreted, and those after it are taken as they "
        "were before: {reason}. Post without it.",
        name=name,
        reason=reason,
    )
    return report_finding(codes.SHIFT[0], text, line=row)


def _away(row: int) -> Finding:
    text = say(
        "Before it tilts the plane the control draws the tool back by a setting of the machine; that move is "
        "missing here."
    )
    return report_finding(codes.HOME[0], text, line=row)
