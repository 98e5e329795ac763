# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners of a contour, rounded or chamfered (Fanuc 30i, user's manual, optional chamfering and corner R;
Siemens SINUMERIK ONE, NC programming, 6FC5398-2EP40, chamfer, rounding: CHR is the width in the direction of
motion, CHF the length of the chamfer).

,R2  RND=2     an arc of that radius, tangent to both pieces, which are lines or arcs (:mod:`.tangent`).
     RNDM=2    the same in every corner from here on, until RNDM=0; a corner that leaves the working plane has
               none.
,C2  CHR=2     a chamfer that leaves and meets two lines so far from the corner.
     CHF=2     a chamfer of that length between two lines, as far from the corner on both.

Both pieces must lie in the working plane and be long enough, with what the corners at their other ends take
of them. Any other corner is left sharp, with an error: its moves are missing. So is a chamfer beside an arc:
how far it goes there was not found.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say

from .arcs import ARC_TOLERANCE, AXES, Chords
from .codes import ANGLE
from .tangent import BACK, STRAIGHT, Piece, corner, rounding

ISO = re.compile(rb", *([RC]) *(?=\+?[0-9.])(?!\+?[0-9]{7})")
"""As Fanuc, Haas and others write them."""
SIEMENS = re.compile(rb"(?<![A-Z0-9_$])(RNDM?|CHR|CHF) *= *(\+?[0-9.]+)(?= |$)", re.MULTILINE)
ISO_ANGLE = re.compile(rb", *A *(?=[-+]?[0-9.])")
SIEMENS_ANGLE = re.compile(
    rb"(?<![A-Z0-9_$])ANG *= *(?=[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?: |$))", re.MULTILINE
)
"""Of a line (:mod:`.contour_angles`)."""
LETTER = "\x7f"
"""Private: the radius, above 0, or less the chamfer's legs, or less :data:`BEYOND` and its own length;
:data:`BEYOND` and the radius of every corner from here on. No text has it."""
BEYOND = 1_000_000
"""No leg or radius is as long as this, mm or inch."""


@dataclass(frozen=True, eq=False)
class Corners:
    """``size`` (m,) of each move's end, mm: radius, or less the chamfer's size; 0 for none. ``length`` (m,):
    the size is the chamfer's own length, not that of its legs; ``modal`` (m,): it is that of every corner
    (RNDM=). ``plane`` (m,) 0 XY, 1 ZX, 2 YZ; ``cut`` (m,) whether it is a feed move."""

    size: Floats
    length: Bools
    modal: Bools
    plane: Ints
    cut: Bools


def sizes(column: Floats, at: Ints) -> tuple[Floats, Bools, Bools]:
    """Read the private words ``column`` (n,) of all lines, NaN for none, at the lines ``at`` (m,) of the
    moves.

    Return the sizes (m,) in the program's unit, 0 for none, which of them are lengths of chamfers, and which
    are of all corners.
    """
    every = np.asarray(column >= BEYOND)
    last = np.maximum.accumulate(np.where(every, np.arange(len(column)), 0))
    held = np.where(every[last], column[last] - BEYOND, 0.0)
    modal = np.isnan(column) | every
    value = np.where(modal, held, column)
    length = np.asarray(value <= -BEYOND)
    return np.where(length, value + BEYOND, value)[at], length[at], modal[at]


def mark_corners(text: bytes, siemens: bool = False) -> bytes:
    """Return the text, in capitals, with the private words for each corner and angle that has a plain
    number."""
    mark = b"ANG" if siemens else b","
    if mark in text:
        text = (SIEMENS_ANGLE if siemens else ISO_ANGLE).sub(
            lambda found: ANGLE.encode().ljust(len(found[0])), text
        )
    if siemens:
        return SIEMENS.sub(_siemens, text)
    return (
        ISO.sub(lambda found: (b"\x7f" if found[1] == b"R" else b"\x7f-").ljust(len(found[0])), text)
        if b"," in text
        else text
    )


def _siemens(found: re.Match[bytes]) -> bytes:
    """Return the private word of RND=, RNDM=, CHR= or CHF=; as it stands where its number is none, or too
    large."""
    try:
        number = float(found[2])
    except ValueError:
        return found[0]
    if number >= BEYOND:
        return found[0]
    if found[1] in (b"CHF", b"RNDM"):
        return b"\x7f%s%.6f" % (b"-" if found[1] == b"CHF" else b"", BEYOND + number)
    sign = b"\x7f" if found[1] == b"RND" else b"\x7f-"
    return sign.ljust(found.start(2) - found.start()) + found[2].replace(b"+", b" ")


@dataclass(eq=False)
class _RoundedCorners:
    """By move: at its end, how many of its chords stay and the places (k, 5) after them; at its start, how
    many chords go, and mm that are taken; the moves whose corner is lost."""

    ends: dict[int, tuple[int, Floats]]
    heads: dict[int, int]
    taken: dict[int, float]
    lost: list[int]


def with_corners(
    corners: Corners, before: Floats, programmed: Floats, chords: Chords | None, line: Ints
) -> tuple[Chords, list[Finding]]:
    """Return the chords with those of the corners between the moves ``before``, ``programmed`` (m, 5);
    ``line`` (m,) of the file."""
    if chords is None:
        chords = Chords(
            np.arange(len(programmed)), np.ones(len(programmed), np.int64), before.copy(), programmed.copy()
        )
    contour, rounded = _Contour(corners, before, chords), _RoundedCorners({}, {}, {}, [])
    for move in np.flatnonzero(corners.size != 0.0).tolist():
        if not _corner(contour, rounded, move):
            rounded.lost.append(move)
    return _put(chords, contour.first, rounded), _findings(rounded.lost, line)


class _Contour:
    """The moves with their chords, by move."""

    def __init__(self, corners: Corners, before: Floats, chords: Chords) -> None:
        self.corners, self.before, self.chords = corners, before, chords
        self.first = np.cumsum(chords.count) - chords.count

    def places(self, move: int) -> Floats:
        """Start, ends of the chords and end of a move (n + 1, 5)."""
        rows = slice(int(self.first[move]), int(self.first[move] + self.chords.count[move]))
        return np.concatenate([self.before[move][None], self.chords.programmed[rows]])

    def lies_in(self, move: int, plane: int) -> bool:
        """Tell whether there is such a move, and it moves nothing but the two axes of the plane."""
        if move >= len(self.before):
            return False
        others = np.setdiff1d(np.arange(5), AXES[plane, :2])
        return not np.ptp(self.places(move)[:, others], axis=0).any()

    def piece(self, move: int, plane: int) -> Piece | None:
        """Return a move as a line or an arc in the plane; None where it is neither, or does not feed."""
        if not self.lies_in(move, plane) or not self.corners.cut[move]:
            return None
        places, axes = self.places(move), AXES[plane, :2]
        return _line(places[:, axes]) if len(places) == 2 else _arc(places[:, axes])


def _line(places: Floats) -> Piece | None:
    length = float(np.hypot(*(places[1] - places[0])))
    return Piece(places[0], places[1], None, 0.0, length) if length > 0.0 else None


def _arc(places: Floats) -> Piece | None:
    """Return the arc on which chords (n + 1, 2) end, by three of them; None where they lie on none."""
    count = len(places) - 1
    a, b, c = places[0], places[-(-count // 3)], places[-(-2 * count // 3)]
    (ux, uy), (vx, vy) = b - a, c - a
    cross = ux * vy - uy * vx
    if abs(cross) < 1e-12:
        return None
    u, v = ux * ux + uy * uy, vx * vx + vy * vy
    centre = a + np.array([vy * u - uy * v, ux * v - vx * u]) / (2.0 * cross)
    radii = np.hypot(*(places - centre).T)
    if np.ptp(radii) > ARC_TOLERANCE:
        return None
    chord = float(np.hypot(*(b - a)))
    sweep = 2.0 * np.arcsin(min(chord / (2.0 * float(radii[0])), 1.0)) / (-(-count // 3)) * count
    return Piece(a, places[-1], centre, 1.0 if cross > 0.0 else -1.0, float(radii[0]) * sweep)


def _corner(contour: _Contour, rounded: _RoundedCorners, move: int) -> bool:
    """Make the corner at the end of a move; False where there is no such corner."""
    plane, size = int(contour.corners.plane[move]), float(contour.corners.size[move])
    if contour.corners.modal[move] and not (
        contour.lies_in(move, plane) and contour.lies_in(move + 1, plane)
    ):
        return True  # 6FC5398: none is inserted where there is no contour in the plane
    one, two = contour.piece(move, plane), contour.piece(move + 1, plane)
    if one is None or two is None or (contour.places(move)[-1] != contour.before[move + 1]).any():
        return False  # the last: X Y Z mean something else from here on
    turn, _ = corner(one, two)
    if turn < STRAIGHT or turn > np.pi - BACK:
        return turn < STRAIGHT
    taken = rounded.taken.get(move, 0.0)
    flat = _flat(one, two, size, bool(contour.corners.length[move]), taken)
    if flat is None:
        return False
    places = np.repeat(contour.places(move)[-1:], len(flat), axis=0)
    places[:, AXES[plane, :2]] = flat
    stays = one.along(flat[0]) / one.length * contour.chords.count[move]
    rounded.ends[move] = max(int(np.ceil(stays - 1e-6)) - 1, 0), places
    rounded.taken[move + 1] = two.along(flat[-1])
    gone = int(rounded.taken[move + 1] / two.length * contour.chords.count[move + 1] + 1e-6)
    rounded.heads[move + 1] = min(gone, int(contour.chords.count[move + 1]) - 1)
    return True


def _flat(one: Piece, two: Piece, size: float, by_length: bool, taken: float) -> Floats | None:
    """Return the places (k, 2) from the corner's first to its last; None where the pieces are too short, or
    not of that kind."""
    if one.centre is not None or two.centre is not None:
        arc = rounding(one, two, size, taken) if size > 0.0 else None
        return None if arc is None else arc.places()
    way = np.stack([(one.start - one.end) / one.length, (two.end - two.start) / two.length])
    angle = float(np.arccos(np.clip(way[0] @ way[1], -1.0, 1.0)))
    leg = (
        size / np.tan(angle / 2.0)
        if size > 0.0
        else -size / (2.0 * np.sin(angle / 2.0) if by_length else 1.0)
    )
    if leg > one.length - taken + ARC_TOLERANCE or leg > two.length + ARC_TOLERANCE:
        return None
    return one.end + (leg * way if size < 0.0 else _round(way, size, angle))


def _round(way: Floats, radius: float, angle: float) -> Floats:
    """Places (k, 2), counted from the corner, of the arc tangent to both lines; ``angle`` rad between
    them."""
    half = angle / 2.0
    middle = way.sum(axis=0) / np.linalg.norm(way.sum(axis=0))
    centre = middle * radius / np.sin(half)
    first, last = (radius / np.tan(half) * way - centre) / radius
    sweep = np.pi - angle
    count = max(int(np.ceil(sweep / (2.0 * np.arccos(1.0 - min(ARC_TOLERANCE / radius, 1.0))))), 1)
    share = np.linspace(0.0, 1.0, count + 1)[:, None]
    return np.asarray(
        centre
        + radius * (np.sin((1.0 - share) * sweep) * first + np.sin(share * sweep) * last) / np.sin(sweep)
    )


def _put(chords: Chords, first: Ints, rounded: _RoundedCorners) -> Chords:
    """Return the chords with the corners' places at the ends of their moves; the next move goes on where they
    end."""
    if not rounded.ends:
        return chords
    none, count = np.zeros((0, 5)), chords.count.copy()
    pieces, row, done = list[Floats](), list[Ints](), 0
    for move in sorted({*rounded.ends, *rounded.heads}):
        begin, whole = int(first[move]), int(chords.count[move])
        stays, places = rounded.ends.get(move, (whole, none))
        gone = rounded.heads.get(move, 0)
        kept = chords.programmed[begin + gone : begin + max(stays, gone)]
        pieces += [chords.programmed[done:begin], kept, places]
        row += [chords.row[done:begin], np.full(len(kept) + len(places), move)]
        count[move], done = len(kept) + len(places), begin + whole
    places, of = (
        np.concatenate([*pieces, chords.programmed[done:]]),
        np.concatenate([*row, chords.row[done:]]),
    )
    before = np.empty_like(places)
    starts = np.flatnonzero(np.diff(of, prepend=-1))
    before[1:] = places[:-1]
    plain = starts[~np.isin(of[starts] - 1, list(rounded.ends))]
    before[plain] = chords.before[first[of[plain]]]
    return Chords(of, count, before, places)


def _findings(lost: list[int], line: Ints) -> list[Finding]:
    if not lost:
        return []
    text = say(
        "{count} corners (,R ,C, RND=, RNDM=, CHR=, CHF=) are left sharp, first NC line {line}: they stand "
        "between other moves than lines (of a rounding, arcs) in the working plane, or these are too short. "
        "Post their arcs and lines.",
        count=len(lost),
        line=int(line[lost[0]]),
    )
    return [report_finding(Code.CORNER_NOT_INTERPRETED, text, float(len(lost)), line=int(line[lost[0]]))]
