# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rest material: a map of the machined surface against the way of the cutter.

height    of a point of the part's surface: how far the cutter stays away from it all along its way, mm. Above
          0 so much is left on it, below 0 so much is taken off too deep.
sample    the middle of a facet, or of a part of it, with the area that it stands for.

way       the cuts one after the other, by the length that the cutter's bottom goes on them.

The way is sampled. The sampled poses whose middle is nearest to a point are looked up in a k-d tree: as many
as could touch it, for a wide cutter that leans touches with its rim, far from its middle. Those that come
nearest, each from another stretch of the way, are followed to their least height. Every height found is that
of a real pose, so it is never too small.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy

from freecad_fiveaxis.core.base.chunks import in_threads
from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.base.sentences import Area, Choice, Length, Point, Template, Volume, say
from freecad_fiveaxis.core.base.vectors import dot, length
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.tool.body import Body, Piece, distance_off

from .swept_motion import Poses, SweptMotion

NEAREST = 12
"""Sampled poses that are looked at for each point, at least."""

SOME = 1000
"""Points by which it is found how many could touch."""

MOST_NEAREST = 512
"""And at most; of a wide cutter on narrow passes the samples lie farther apart instead."""

FOLLOWED = 2
"""Of these, as many as come nearest are followed; of a cutter with a level bottom twice as many."""

STEPS = 8
"""Golden sections of the way between neighbouring samples: to a hundredth of it, and the height there is
flat."""

CLOSE = 0.25
"""Distance of samples on the way, as a share of the radius that it has at its bottom."""

LONGEST = 1.5
"""Times the spacing: no part's side is longer, and most parts' middles then lie about the spacing apart."""

MOST_HALVINGS = 16
"""A facet is halved at most so often."""

MOST_SAMPLES = 4_000_000
"""Sampled poses; a longer way is sampled more widely."""

CHUNK = 131_072
"""Points and samples near them that are looked at together."""

LITTLE = 1e-4
"""Of the surface: that more than may stays on so little of it, and nowhere twice as much, is told, and no
reason to check the program."""

MOST_OF = 0.5
"""Of what is left: where no pass touches so much, no other cutter helps."""

GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)


@dataclass(frozen=True, eq=False)
class RestMaterial:
    """``point`` (k, 3) mm on the surface; ``facet`` (k,); ``area`` (k,) mm2; ``height`` (k,) mm; ``block``
    (k,) of the swept motion that comes nearest; ``spacing`` mm of the samples. ``mesh`` and ``body``: the
    part and the cutter, where they are known."""

    point: Floats
    facet: Ints
    area: Floats
    height: Floats
    block: Ints
    spacing: float
    mesh: Mesh | None = None
    body: Body | None = None

    def uncut(self, above: float) -> tuple[float, float]:
        """Return the area (mm2) on which more than ``above`` mm is left, and how much more there is on it
        (mm3)."""
        more = self.height > above
        return float(self.area[more].sum()), float(((self.height - above) * self.area)[more].sum())

    def sum_overcut(self, below: float) -> tuple[float, float]:
        """Return the area (mm2) on which more than ``below`` mm is taken off too deep, and how much more
        there is on it (mm3)."""
        more = self.height < -below
        return float(self.area[more].sum()), float(((-self.height - below) * self.area)[more].sum())


def find_rest_material(
    mesh: Mesh,
    body: Body,
    swept: SweptMotion,
    blocks: Ints,
    spacing: float,
    facets: Bools | None = None,
    progress: Progress = silent,
    enough: float = -np.inf,
    counts: Callable[[Floats, Ints], Bools] | None = None,
) -> RestMaterial:
    """Find the heights over samples at most about ``spacing`` mm apart, of these ``facets`` (f,) of the mesh
    (None: all).

    ``body``: the cutter; ``blocks`` (b,): those of the swept motion that cut. A height of at most ``enough``
    mm may be smaller in truth: who asks only where more is left need not wait for the rest. ``counts``: which
    places (k, 3), of facets (k,), are looked at, None: all. Raises SettingsError where no block cuts.
    """
    if not len(blocks):
        raise SettingsError(say("no block cuts, so nothing can be said of what is left"), 0)
    point, facet, area = surface_samples(mesh, spacing, facets)
    if counts is not None:
        some = counts(point, facet)
        point, facet, area = point[some], facet[some], area[some]
    progress("what is left", 0.0)
    way, near = _sample_enough(body, swept, blocks, point)
    height, nearest = np.empty(len(point)), np.empty(len(point), np.int64)

    def work(first: int) -> None:
        rows = slice(first, first + CHUNK // near)
        height[rows], nearest[rows] = _screen_points(body, way, point[rows], near, enough)

    in_threads(work, range(0, len(point), CHUNK // near), lambda share: progress("what is left", share))
    progress("what is left", 1.0)
    return RestMaterial(point, facet, area, height, nearest, spacing, mesh, body)


def surface_parts(mesh: Mesh, spacing: float, facets: Bools | None = None) -> tuple[Floats, Ints]:
    """Triangles (k, 3, 3) mm that together cover these facets, in the facets' own sense, and the facet (k,)
    of each.

    None has a side much longer than ``spacing`` mm: what is longer is halved across its longest side, again
    and again.
    """
    facet = np.arange(len(mesh.face)) if facets is None else np.flatnonzero(facets)
    corner, done = mesh.vertex[mesh.face[facet]], []
    for _ in range(MOST_HALVINGS):
        side = np.linalg.norm(
            np.roll(corner, 1, axis=1) - np.roll(corner, -1, axis=1), axis=2
        )  # that opposite each corner
        apex, long = side.argmax(axis=1), side.max(axis=1) > LONGEST * spacing
        done.append((corner[~long], facet[~long]))
        corner, facet = _halve_triangles(corner[long], apex[long]), np.repeat(facet[long], 2)
        if not len(facet):
            break
    corners, of = (np.concatenate(column) for column in zip(*done, (corner, facet), strict=True))
    order = np.argsort(of, kind="stable")
    return corners[order], of[order]


def _halve_triangles(corner: Floats, apex: Ints) -> Floats:
    """Both halves (2 k, 3, 3), in turn, of triangles (k, 3, 3): from ``apex`` (k,) to the middle of the side
    opposite."""
    row = np.arange(len(corner))
    a, b, c = (corner[row, (apex + k) % 3] for k in range(3))
    middle = 0.5 * (b + c)
    return np.stack([np.stack([a, b, middle], axis=1), np.stack([a, middle, c], axis=1)], axis=1).reshape(
        -1, 3, 3
    )


def surface_samples(mesh: Mesh, spacing: float, facets: Bools | None = None) -> tuple[Floats, Ints, Floats]:
    """Return the middles (k, 3) of the surface's parts, their facets (k,) and areas (k,) mm2."""
    corner, facet = surface_parts(mesh, spacing, facets)
    area = 0.5 * np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
    return corner.mean(axis=1), facet, area


@dataclass(frozen=True, eq=False)
class _Samples:
    """The blocks (b,) that cut; ``length`` (b + 1,) mm of the way at their ends, ``low`` and ``high`` (b,) at
    the ends of the run of blocks that each is in. ``at`` (s,) mm: where the samples are, ``pose`` theirs,
    ``tree`` over their middles; ``spacing`` mm."""

    swept: SweptMotion
    block: Ints
    length: Floats
    low: Floats
    high: Floats
    at: Floats
    pose: Poses
    tree: scipy.spatial.cKDTree
    spacing: float

    def place(self, at: Floats) -> tuple[Ints, Floats]:
        """Return the rows of ``block`` and the u that the way has come to after so many mm (n,)."""
        return _place(self.length, at)


def _place(length: Floats, at: Floats) -> tuple[Ints, Floats]:
    row = np.clip(np.searchsorted(length, at, side="right") - 1, 0, len(length) - 2)
    whole = np.maximum(length[row + 1] - length[row], 1e-300)
    return row, np.clip((at - length[row]) / whole, 0.0, 1.0)


def _sample_way(lowest: Piece, swept: SweptMotion, blocks: Ints, spacing: float) -> _Samples:
    poses = [swept.pose(blocks, np.full(len(blocks), u)) for u in (0.0, 0.5, 1.0)]
    steps = [
        np.linalg.norm(_middle(lowest, q) - _middle(lowest, p), axis=0)
        + _wide(lowest)[0] * np.linalg.norm(q.axis - p.axis, axis=0)
        for p, q in pairwise(poses)
    ]
    length = np.append(0.0, np.cumsum(steps[0] + steps[1]))
    first = np.flatnonzero(np.diff(blocks, prepend=blocks[0] - 2) != 1)
    run = np.cumsum(np.diff(blocks, prepend=blocks[0] - 2) != 1) - 1
    ends = np.append(first[1:], len(blocks))
    spacing = max(spacing, float(length[-1]) / MOST_SAMPLES)
    size = length[ends] - length[first]
    count = np.maximum(np.ceil(size / spacing), 1).astype(np.int64)
    of, part = number_runs(count)
    at = length[first][of] + (part + 0.5) * (size / count)[of]
    row, u = _place(length, at)
    pose = swept.pose(blocks[row], u)
    tree = scipy.spatial.cKDTree(_middle(lowest, pose).T)
    return _Samples(swept, blocks, length, length[first][run], length[ends][run], at, pose, tree, spacing)


def _middle(piece: Piece, pose: Poses) -> Floats:
    """Return the middle of a piece's lower disc, of a bulge that between its ends, at each pose (3, n)."""
    height = piece.low if piece.bulge == 0.0 else 0.5 * (piece.low + piece.arc[1])
    return np.asarray(pose.tip + height * pose.axis)


def _wide(piece: Piece) -> tuple[float, float]:
    """How much, mm, of a piece is no ball: the radius of its lower disc, of a bulge how far its ends are from
    its middle; and how far what touches is from there."""
    flat = (
        piece.low_radius
        if piece.bulge == 0.0
        else math.hypot(piece.high_radius, 0.5 * (piece.arc[1] - piece.low))
    )
    return flat, flat + piece.round


def _sample_enough(body: Body, swept: SweptMotion, blocks: Ints, point: Floats) -> tuple[_Samples, int]:
    """Return the sampled way, and how many samples must be looked at for all that could touch one of some
    points (n,
    3) to be among them; where that is too many, the samples lie farther apart."""
    lowest = _lowest_piece(body)
    flat, wide = _wide(lowest)
    round_ = wide if lowest.bulge == 0.0 else lowest.widest  # a bulge is longer than it is wide
    way, count = _sample_way(lowest, swept, blocks, CLOSE * round_), NEAREST
    if flat > 0.0:
        some = point[:: max(len(point) // SOME, 1)]
        count = int(way.tree.query_ball_point(some, wide + way.spacing, return_length=True).max())
        if count > MOST_NEAREST:
            way = _sample_way(lowest, swept, blocks, way.spacing * count / MOST_NEAREST)
    return way, min(max(count, NEAREST), MOST_NEAREST, len(way.at))


def _lowest_piece(body: Body) -> Piece:
    return min(body.pieces, key=lambda piece: piece.low - piece.round)


def _starts(body: Body, way: _Samples, point: Floats, count: int) -> tuple[Ints, Floats]:
    """Return the samples (n, k) from which to follow: of so many the lowest, then the lowest away from that,
    and so on; and the height (n,) mm at the lowest."""
    near = np.asarray(way.tree.query(point, k=count)[1]).reshape(len(point), count)
    there, place = near.ravel(), np.repeat(point.T, near.shape[1], axis=1)
    pose = Poses(way.pose.tip.take(there, axis=1), way.pose.axis.take(there, axis=1))
    height, at = _height(body, pose, place).reshape(near.shape), way.at[near]
    level = any(piece.low_radius > 0.0 or piece.bulge > 0.0 for piece in body.pieces)
    rows, starts, least = np.arange(len(point)), [], height.min(axis=1)
    for _ in range(FOLLOWED * (1 + level)):
        best = height.argmin(axis=1)
        starts.append(near[rows, best])
        height[np.abs(at - at[rows, best][:, None]) < 1.5 * way.spacing] = np.inf
    return np.stack(starts, axis=1), least


def _screen_points(
    body: Body, way: _Samples, point: Floats, count: int, enough: float
) -> tuple[Floats, Ints]:
    """Return the least height (n,) of points and the block where it is; where a sample near it leaves no more
    than ``enough`` mm, the height there."""
    if enough == -np.inf:
        return _lowest(body, way, point, _starts(body, way, point, count)[0])
    near = np.asarray(way.tree.query(point)[1])
    pose = Poses(way.pose.tip.take(near, axis=1), way.pose.axis.take(near, axis=1))
    height, block = _height(body, pose, point.T), way.block[way.place(way.at[near])[0]]
    rows = np.flatnonzero(height > enough)
    if len(rows):
        starts, least = _starts(body, way, point[rows], count)
        height[rows], block[rows] = least, way.block[way.place(way.at[starts[:, 0]])[0]]
        more = np.flatnonzero(least > enough)
        rows = rows[more]
        if len(rows):
            height[rows], block[rows] = _lowest(body, way, point[rows], starts[more])
    return height, block


def _lowest(body: Body, way: _Samples, point: Floats, starts: Ints) -> tuple[Floats, Ints]:
    """Return the least height (n,) of points on the way about some samples (n, k) each, and the block where
    it is."""
    place, middle = np.repeat(point.T, starts.shape[1], axis=1), way.at[starts.ravel()]
    row, _ = way.place(middle)
    low, high = (
        np.maximum(middle - way.spacing, way.low[row]),
        np.minimum(middle + way.spacing, way.high[row]),
    )

    def height(at: Floats) -> Floats:
        row, u = way.place(at)
        return _height(body, way.swept.pose(way.block[row], u), place)

    one, two = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    first, second = height(one), height(two)
    for _ in range(STEPS):
        left = first < second
        low, high = np.where(left, low, one), np.where(left, two, high)
        one, two = (
            np.where(left, high - GOLDEN * (high - low), two),
            np.where(left, one, low + GOLDEN * (high - low)),
        )
        fresh = height(np.where(left, one, two))
        first, second = np.where(left, fresh, second), np.where(left, first, fresh)
    found, at = (
        np.where(first < second, *ends).reshape(starts.shape) for ends in ((first, second), (one, two))
    )
    least, rows = found.argmin(axis=1), np.arange(len(point))
    return found[rows, least], way.block[way.place(at[rows, least])[0]]


def _height(body: Body, pose: Poses, place: Floats) -> Floats:
    arm = place - pose.tip
    along = dot(arm, pose.axis)
    across = length(arm - along * pose.axis)
    return np.asarray(np.min([distance_off(piece, across, along) for piece in body.pieces], axis=0))


_UNCUT = Template(
    "On {area} of the machined surface more than {above} is left, most at {place}: {height}; {volume} in "
    "all. Cut these places with a smaller cutter or another tool axis."
)
_UNTOUCHED = Template(
    "On {area} of the machined surface more than {above} is left, most at {place}: {height}; {volume} in "
    "all. Most of that is what no pass touches: whatever the cutter, cut it with other passes."
)


def uncut_finding(remainder: RestMaterial, above: float, untouched: float = 0.0) -> tuple[Finding, ...]:
    """Return a finding where more than ``above`` mm is left somewhere: area, largest height and its place.
    ``untouched`` mm2 of the surface: so much no pass touches, by what is known of the passes; where the map
    finds less than half of it uncut, the cutter sweeps it from beside."""
    area, volume = remainder.uncut(above)
    if area == 0.0:
        return ()
    worst = int(remainder.height.argmax())
    x, y, z = remainder.point[worst].tolist()
    template = _UNTOUCHED if MOST_OF * area <= untouched <= area / MOST_OF else _UNCUT
    text = template.say(
        area=Area(area, ".4g"),
        above=Length(above, ".3g"),
        place=Point((x, y, z), ".6g"),
        height=Length(remainder.height[worst], ".4g"),
        volume=Volume(volume, ".4g"),
    )
    little = area <= LITTLE * remainder.area.sum() and remainder.height[worst] <= 2.0 * above
    severity = Severity.NOTE if little else Severity.WARNING
    return (report_finding(Code.UNCUT, text, area, 0.0, place=(x, y, z), unit="mm2", severity=severity),)


def too_deep_finding(remainder: RestMaterial, tolerance: float) -> tuple[Finding, ...]:
    """Return a finding where the cutter takes off more than ``tolerance`` mm too much somewhere: area, depth
    and its place."""
    area, volume = remainder.sum_overcut(tolerance)
    if area == 0.0:
        return ()
    worst = int(remainder.height.argmin())
    x, y, z = remainder.point[worst].tolist()
    text = say(
        "On {area} of the machined surface more than {tolerance} is cut too deep, most at {place}: {height}; "
        "{volume} in all. Let the tool be lifted there ({lift}), or use a smaller cutter.",
        lift=Choice("gouge", ("lift",)),
        area=Area(area, ".4g"),
        tolerance=Length(tolerance, ".3g"),
        place=Point((x, y, z), ".6g"),
        height=Length(-remainder.height[worst], ".4g"),
        volume=Volume(volume, ".4g"),
    )
    return (
        report_finding(Code.CUT_TOO_DEEP, text, -float(remainder.height[worst]), tolerance, place=(x, y, z)),
    )
