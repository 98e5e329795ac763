# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens' programmable frame where a program turns it: TRANS, ATRANS, ROT, AROT and CYCLE800 as one chain of
coordinates.

TRANS, ROT     anew: all that was programmed before ends.  ATRANS, AROT: on from the frame that is on.
ROT X Y Z      about Z, then the Y so turned, then the X so turned (RPY, the usual setting); RPL=: about the
               normal of the plane.
CYCLE800       ends the programmed frame; one that is programmed after it stands in its plane.

A frame turns coordinates, no axes: X Y Z are the tip's where the control guides it (TRAORI), else those of
the axes.

Source: SINUMERIK ONE, NC programming, 12/2019, 6FC5398-2EP40-0BA0, 2.12 (order of the turns, p. 309; ROT, p.
316). Euler's order (a machine's setting) is not known to a program; that CYCLE800 ends a frame was not looked
up.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import say

from . import codes
from .arcs import AXES
from .codes import Grammar
from .findings import shift_finding
from .lines import Lines
from .plane_calls import SIEMENS, Tilt, about, beyond, one_by_one
from .planes import tilts_of
from .positions import axis_words
from .words import Words

SHIFTS_ON, ROTATED, ROTATED_ON = 3, 4, 5
"""What a line does (:data:`.codes.SHIFTED`)."""
NAMES = {2: "TRANS", SHIFTS_ON: "ATRANS", ROTATED: "ROT", ROTATED_ON: "AROT"}
ON_FRAME = say("it goes on from a plane in which TRANS or ROT is on; end that first")
OWN = (codes.SHIFTED, codes.IN_THE_PLANE, *"XYZABC", *codes.STEP_OF.values(), codes.ABSOLUTE)


@dataclass(eq=False)
class _Place:
    """Coordinates ``turn`` (3, 3) with their zero at ``origin`` (3,) mm."""

    origin: Floats = field(default_factory=lambda: np.zeros(3))
    turn: Floats = field(default_factory=lambda: np.eye(3))

    def on(self, other: _Place) -> _Place:
        """Coordinates that stand in these."""
        return _Place(self.origin + self.turn @ other.origin, self.turn @ other.turn)

    def nothing(self) -> bool:
        """Whether these are the work's own."""
        return not self.origin.any() and bool((self.turn == np.eye(3)).all())


def replace_frames(words: Words, lines: Lines, grammar: Grammar, kind: Floats) -> tuple[Words, list[Finding]]:
    """Return the words with the frames as planes (:mod:`.planes`), those of the lines that program them left
    out; ``kind`` (lines,) says what a line does, NaN where it programs no frame."""
    scale = lines.unit(grammar)
    programmed = np.stack([axis_words(lines, letter)[0] for letter in "XYZ"], axis=1)
    rotary = np.logical_or.reduce([np.nan_to_num(axis_words(lines, letter)[0]) != 0.0 for letter in "ABC"])
    normal = AXES[lines.mode(codes.PLANES, 0), 2]
    in_plane = lines.column(codes.IN_THE_PLANE)
    swivel, own, tilts, findings = None, _Place(), dict[int, Tilt](), list[Finding]()
    swivels, rows = tilts_of(lines, grammar), np.flatnonzero(~np.isnan(kind)).tolist()
    for row in sorted({*rows, *swivels}):
        if row in swivels:
            if not swivels[row].refused:
                if swivels[row].relative and not own.nothing():
                    findings.append(shift_finding("CYCLE800", ON_FRAME, row))
                swivel, own = _of_swivel(swivels[row], float(scale[row]), swivel), _Place()
            continue
        value, does = np.nan_to_num(programmed[row]), int(kind[row])
        reason = beyond(value.tolist()) or (say("it shifts a rotary axis") if rotary[row] else "")
        if reason:
            findings.append(shift_finding(NAMES.get(does, "TRANS"), reason, row))
        step = _step(does, value, float(scale[row]), int(normal[row]), float(in_plane[row]))
        own = own.on(step) if does in (SHIFTS_ON, ROTATED_ON) else step
        tilts[row] = _tilt(swivel, own, float(scale[row]))
    return _with_tilts(words, np.asarray(~np.isnan(kind)), tilts), findings


def _of_swivel(tilt: Tilt, scale: float, before: _Place | None) -> _Place | None:
    """Return the coordinates of CYCLE800 after those of the one ``before``; None where it ends."""
    if tilt.turn is None:
        return None
    place = _Place((np.array(tilt.origin) + tilt.turn @ np.array(tilt.shift)) * scale, tilt.turn)
    return before.on(place) if tilt.relative and before is not None else place


def _step(does: int, value: Floats, scale: float, normal: int, in_plane: float) -> _Place:
    """Return what a line tells: a shift, or a turn."""
    if does < ROTATED:
        return _Place(value * scale)
    if not np.isnan(in_plane):
        return _Place(turn=about(normal, in_plane))
    return _Place(turn=one_by_one((2, 1, 0), value[::-1].tolist()))


def _tilt(swivel: _Place | None, own: _Place, scale: float) -> Tilt:
    """Return the frame as a plane, which turns no axes."""
    if swivel is None and own.nothing():
        return Tilt(SIEMENS)
    place = own if swivel is None else swivel.on(own)
    x, y, z = (place.origin / scale).tolist()
    return Tilt(SIEMENS, place.turn, (x, y, z), frame=swivel is None)


def _with_tilts(words: Words, own: Bools, tilts: dict[int, Tilt]) -> Words:
    """Return the words with the private word of a plane in each line of a frame, for all others of that
    line."""
    keep = ~(own[words.line] & np.isin(words.letter, [ord(letter) for letter in OWN]))
    rows = np.array(list(tilts), np.int64)
    line = np.concatenate([words.line[keep], rows])
    order = np.argsort(line, kind="stable")
    start = (
        None if words.start is None else np.concatenate([words.start[keep], np.full(len(rows), -1)])[order]
    )
    return replace(
        words,
        letter=np.concatenate([words.letter[keep], np.full(len(rows), ord(codes.PLANE), np.int8)])[order],
        value=np.concatenate([words.value[keep], len(words.tilts) + np.arange(len(rows), dtype=float)])[
            order
        ],
        line=line[order],
        start=start,
        tilts=(*words.tilts, *tilts.values()),
    )
