# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners between two straight lines, rounded or chamfered (Fanuc 30i, user's manual, optional chamfering and corner R; Siemens
840D, Fundamentals, chamfer and rounding).

,R2  RND=2     an arc of that radius, tangent to both lines.
,C2  CHR=2     a chamfer that leaves and meets the lines so far from the corner.

Both lines must lie in the working plane and be long enough, with what the corners at their other ends take of them. Any other
corner is left sharp, with an error: its moves are missing.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say

from .arcs import ARC_TOLERANCE, AXES, Chords

ISO = re.compile(rb", *([RC]) *(?=\+?[0-9.])")
"""As Fanuc, Haas and others write them."""
SIEMENS = re.compile(rb"(?<![A-Z0-9_$])(RND|CHR) *= *(?=\+?[0-9.]+(?: |$))", re.MULTILINE)
LETTER = "\x7f"
"""Private: the radius, above 0, or less the chamfer's legs. No text has this character."""
STRAIGHT, BACK = 1e-6, 1e-3
"""rad: lines that go on in one direction have no corner; one that comes straight back has none that can be rounded."""


@dataclass(frozen=True, eq=False)
class Corners:
    """``size`` (m,) of each move's end, mm: radius, or less the legs; 0 for none. ``plane`` (m,) 0 XY, 1 ZX, 2 YZ; ``line`` (m,)
    whether it is a straight feed move."""

    size: Floats
    plane: Ints
    line: Bools


def marked(text: bytes, siemens: bool = False) -> bytes:
    """The text, in capitals, with the private word for each corner that has a plain number."""
    if siemens:
        return SIEMENS.sub(lambda found: (b"\x7f" if found[1] == b"RND" else b"\x7f-").ljust(len(found[0])), text)
    return ISO.sub(lambda found: (b"\x7f" if found[1] == b"R" else b"\x7f-").ljust(len(found[0])), text) if b"," in text else text


def with_corners(
    corners: Corners, before: Floats, said: Floats, chords: Chords | None, line: Ints
) -> tuple[Chords, list[Finding]]:
    """The chords with those of the corners between the moves ``before``, ``said`` (m, 5); ``line`` (m,) of the file."""
    if chords is None:
        chords = Chords(np.arange(len(said)), np.ones(len(said), np.int64), before.copy(), said.copy())
    put, lost = dict[int, Floats](), []
    at = np.flatnonzero(corners.size != 0.0).tolist()
    taken = np.zeros(len(said))
    for move in at:
        places = _corner(corners, before, said, move, float(taken[move]))
        if places is None:
            lost.append(move)
        elif len(places):
            put[move] = places
            taken[move + 1] = float(np.linalg.norm(places[-1] - said[move]))
    return _put(chords, put), _findings(lost, line)


def _corner(corners: Corners, before: Floats, said: Floats, move: int, taken: float) -> Floats | None:
    """The places (k, 5) from the corner's first to its last; none where the line goes on; None where there is no such corner.
    ``taken`` mm of the move by the corner before it."""
    if move + 1 >= len(said) or not (corners.line[move] and corners.line[move + 1]):
        return None
    u, v = AXES[corners.plane[move], :2]
    others = [axis for axis in range(5) if axis not in (u, v)]
    step = np.stack([before[move] - said[move], said[move + 1] - said[move]])
    length = np.hypot(step[:, u], step[:, v])
    if np.abs(step[:, others]).max() > 0.0 or not (length > 0.0).all():
        return None
    way = step[:, [u, v]] / length[:, None]
    angle = float(np.arccos(np.clip(way[0] @ way[1], -1.0, 1.0)))
    if angle < BACK:
        return None
    if np.pi - angle < STRAIGHT:
        return np.zeros((0, 5))
    size = float(corners.size[move])
    leg = -size if size < 0.0 else size / np.tan(angle / 2.0)
    if leg > length[0] - taken + ARC_TOLERANCE or leg > length[1] + ARC_TOLERANCE:
        return None
    flat = said[move, [u, v]] + (leg * way if size < 0.0 else _arc(way, size, angle))
    places = np.repeat(said[move][None], len(flat), axis=0)
    places[:, [u, v]] = flat
    return places


def _arc(way: Floats, radius: float, angle: float) -> Floats:
    """Places (k, 2), counted from the corner, of the arc tangent to both lines; ``angle`` rad between them."""
    half = angle / 2.0
    middle = way.sum(axis=0) / np.linalg.norm(way.sum(axis=0))
    centre = middle * radius / np.sin(half)
    first, last = (radius / np.tan(half) * way - centre) / radius
    sweep = np.pi - angle
    count = max(int(np.ceil(sweep / (2.0 * np.arccos(1.0 - min(ARC_TOLERANCE / radius, 1.0))))), 1)
    share = np.linspace(0.0, 1.0, count + 1)[:, None]
    return np.asarray(centre + radius * (np.sin((1.0 - share) * sweep) * first + np.sin(share * sweep) * last) / np.sin(sweep))


def _put(chords: Chords, put: dict[int, Floats]) -> Chords:
    """The chords with the places put in at the ends of their moves, instead of the corner itself; the next move goes on there."""
    if not put:
        return chords
    rows, count = [], chords.count.copy()
    first = np.cumsum(chords.count) - chords.count
    said, row, done = [], [], 0
    for move, places in put.items():
        end = int(first[move] + chords.count[move]) - 1
        said += [chords.said[done:end], places]
        row += [chords.row[done:end], np.full(len(places), move)]
        rows.append(move)
        count[move] += len(places) - 1
        done = end + 1
    said.append(chords.said[done:])
    row.append(chords.row[done:])
    places, of = np.concatenate(said), np.concatenate(row)
    before = np.empty_like(places)
    starts = np.flatnonzero(np.diff(of, prepend=-1))
    before[1:] = places[:-1]
    plain = starts[~np.isin(of[starts] - 1, rows)]
    before[plain] = chords.before[first[of[plain]]]
    return Chords(of, count, before, places)


def _findings(lost: list[int], line: Ints) -> list[Finding]:
    if not lost:
        return []
    text = say(
        "{count} corners (,R ,C, RND=, CHR=) are left sharp, first NC line {line}: they stand between other moves than two "
        "straight ones in the working plane, or these are too short. Post their arcs and lines.",
        count=len(lost),
        line=int(line[lost[0]]),
    )
    return [Finding(Severity.ERROR, "corner-not-interpreted", text, float(len(lost)), line=int(line[lost[0]]))]
