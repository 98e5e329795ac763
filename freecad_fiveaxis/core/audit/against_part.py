# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deep the ball of the cutter enters the part (STL) along the feed blocks of a program, as the machine
really drives them.

overcut     the depth to which the ball is inside the part's surface: radius less the distance of the ball's
            centre from the mesh, the centre's distance counting below 0 where it is inside the part itself.
clearance   the same with the other sign; the largest is only a number.

**Proof.** d^2(p) - p^2 is concave, whatever the part: it is the least of functions that are linear in p.
Along a chord of length c between two places d0, d1 from the part, outside it, the centre is therefore nowhere
nearer than ``sqrt(min(d0, d1)^2 - c^2 / 4)``, and the real centre is within ``bend / 8`` of the chord.
Elsewhere the distance changes by no more than the way.

Only the ball is looked at, neither shank nor holder: :mod:`.tool_in_part` does that. Stock is not known:
whether the part is cut at all is not said.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats, Ints, freeze
from freecad_fiveaxis.core.base.sentences import Length, Option, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.geometry.nearest import Facets, Pieces, search
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program, feed_blocks

from .real_path import Ends, Peaks, RealPath, peaks

NEAR = 0.05
"""A ball that is clear by so many radii need not be measured exactly."""


@dataclass(frozen=True, eq=False)
class AgainstPart:
    """``block`` (n,) the feed blocks, rows of the Program; ``depth`` (n,) mm of the deepest overcut found
    (below 0: clear, by so much or more) at ``u`` (n,), the ball's centre then at ``place`` (n, 3); ``bound``
    (n,) proven; ``clearance`` mm the largest at a block's end, NaN where it is not known."""

    block: Ints
    depth: Floats
    u: Floats
    place: Floats
    bound: Floats
    clearance: float
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, None, block="i", depth="f", u="f", place="f3", bound="f")


def against_part(
    kinematics: Chain,
    program: Program,
    mesh: Mesh,
    radius: float,
    tolerance: float,
    progress: Progress = silent,
) -> AgainstPart:
    """Return the program's ball of ``radius`` mm against the part, in the work frame."""
    facets = Facets(np.ascontiguousarray(mesh.vertex[mesh.face.T]), mesh.normal)
    pieces, rows = facets.pieces(), feed_blocks(program)
    real = RealPath(kinematics, program, radius)

    def measure(place: Floats) -> Floats:
        return radius - _distance(place, facets, pieces, (1.0 + NEAR) * radius, progress)[:, None]

    if not len(rows):
        return AgainstPart(rows, np.zeros(0), np.zeros(0), np.zeros((0, 3)), np.zeros(0), 0.0)
    found = peaks(real, rows, measure, _bound_depth(radius), tolerance, progress)
    ends = real.places(rows, np.ones(len(rows)))
    clear = pieces.clear_by(ends)
    farthest = ends[clear >= clear.max() - 2.0 * pieces.reach]
    clearance = float(_exact(farthest, facets, pieces, progress).max()) - radius
    finding = _findings(program, rows, found, tolerance, radius)
    return AgainstPart(rows, found.value, found.u, found.place, found.bound, clearance, finding)


def _distance(
    place: Floats, facets: Facets, pieces: Pieces, enough: float, progress: Progress = silent
) -> Floats:
    """Distance (n,) mm of the places (n, 3), below 0 inside the part; where it is outside and at least
    ``enough``, something from there to the truth.

    About each place is a ball without any surface in it (``clear_by``); a place in another's ball is on the
    same side. So of a run of places one side is enough, and outside the part's box there is no question.
    """
    clear = pieces.clear_by(place)
    far = clear >= enough
    low, high = facets.corner.min(axis=(0, 1)), facets.corner.max(axis=(0, 1))
    known = ~far | ((place < low) | (place > high)).any(axis=1)
    distance = clear
    near = np.flatnonzero(~far)
    distance[near] = _exact(place[near], facets, pieces, progress)
    step = np.linalg.norm(np.diff(place, axis=0), axis=1)
    empty = np.where(far, clear, 0.0)
    run = np.append(0, np.cumsum(step >= np.maximum(empty[1:], empty[:-1])))
    side = np.zeros(run[-1] + 1)
    side[run[known]] = np.where(distance[known] < 0.0, -1.0, 1.0)
    first = np.flatnonzero(side[run] == 0.0)
    first = first[np.diff(run[first], prepend=-1) > 0]
    side[run[first]] = np.sign(_exact(place[first], facets, pieces, progress))
    deep = np.flatnonzero(far & ~known & (side[run] < 0.0))
    distance[deep] = _exact(place[deep], facets, pieces, progress)
    return distance


def _exact(place: Floats, facets: Facets, pieces: Pieces, progress: Progress) -> Floats:
    return search(place, pieces, facets.square_distances, facets.sign_distances, 2, progress=progress)[:, 0]


def _bound_depth(radius: float) -> Callable[[Ends], Floats]:
    def upper(ends: Ends) -> Floats:
        depth = ends.value[:, :, 0]
        nearest = radius - depth.max(axis=0)  # of the two ends
        by_way = (depth.sum(axis=0) + ends.travel) / 2.0
        inner = np.maximum(nearest, 0.0) ** 2 - ends.chord**2 / 4.0
        by_square = radius - np.sqrt(np.maximum(inner, 0.0)) + ends.bend / 8.0
        return np.asarray(np.where(inner > (ends.bend / 8.0) ** 2, np.minimum(by_way, by_square), by_way))

    return upper


def _findings(
    program: Program, rows: Ints, found: Peaks, tolerance: float, radius: float
) -> tuple[Finding, ...]:
    at = np.flatnonzero(found.value > tolerance)
    if not len(at):
        return ()
    worst = int(at[found.value[at].argmax()])
    row, depth = int(rows[worst]), float(found.value[worst])
    text = say(
        "In {count} of {all} feed blocks the ball of {diameter} enters the part by more than {tolerance}; "
        "deepest in NC line {line}, {depth}; first NC line {first}. Are {cutter}, {origin} and the "
        "machine those of the program, does the STL stand at the work zero? Else the part is spoilt.",
        count=len(at),
        all=len(rows),
        diameter=Length(2.0 * radius),
        tolerance=Length(tolerance),
        line=program.line[row],
        depth=Length(depth, ".5g"),
        first=program.line[rows[at[0]]],
        cutter=Option("cutter"),
        origin=Option("origin"),
    )
    x, y, z = found.place[worst].tolist()
    return (report_finding(Code.OVERCUT, text, depth, tolerance, row, int(program.line[row]), (x, y, z)),)
