# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is left: a map of the machined surface against the way of the cutter.

height    of a point of the part's surface: how far the cutter stays away from it all along its way, mm. Above 0 so much is left
          on it, below 0 so much is taken off too deep.
sample    the middle of a facet, or of a part of it, with the area that it stands for.

The way is sampled, the poses nearest to each point are looked up in a k-d tree, and between those poses and their neighbours the
height is followed to its minimum. Every height found is that of a real pose, so it is never too small.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.spatial import cKDTree

from freecad_fiveaxis.core.errors import SettingsError
from freecad_fiveaxis.core.findings import Finding, Severity
from freecad_fiveaxis.core.mesh import Mesh
from freecad_fiveaxis.core.progress import Progress, silent
from freecad_fiveaxis.core.records import Bools, Floats, Ints

from .body import Body, off_piece
from .course import Course, Poses

NEAREST = 12
"""Sampled poses that are looked at for each point."""

FOLLOWED = 2
"""Of these, as many as come nearest are followed."""

STEPS = 9
"""Golden sections of the way between neighbouring samples: to a hundredth of it, and the height there is flat."""

CLOSE = 0.25
"""Distance of samples on the way, as a share of the cutter's thickness."""

LONGEST = 1.5
"""Times the spacing: no part's side is longer, and most parts' middles then lie about the spacing apart."""

MOST_HALVINGS = 16
"""A facet is halved at most so often."""

MOST_SAMPLES = 4_000_000
"""Sampled poses; a longer way is sampled more widely."""

CHUNK = 32768
"""Points at a time."""

GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)


@dataclass(frozen=True, eq=False)
class Remainder:
    """``point`` (k, 3) mm on the surface; ``facet`` (k,); ``area`` (k,) mm2; ``height`` (k,) mm; ``block`` (k,) of the course
    that comes nearest; ``spacing`` mm of the samples."""

    point: Floats
    facet: Ints
    area: Floats
    height: Floats
    block: Ints
    spacing: float

    def left(self, above: float) -> tuple[float, float]:
        """The area (mm2) on which more than ``above`` mm is left, and how much more there is on it (mm3)."""
        more = self.height > above
        return float(self.area[more].sum()), float(((self.height - above) * self.area)[more].sum())

    def taken(self, below: float) -> tuple[float, float]:
        """The area (mm2) on which more than ``below`` mm is taken off too deep, and how much more there is on it (mm3)."""
        more = self.height < -below
        return float(self.area[more].sum()), float(((-self.height - below) * self.area)[more].sum())


def find_remainder(
    mesh: Mesh, body: Body, course: Course, blocks: Ints, spacing: float, facets: Bools | None = None, progress: Progress = silent
) -> Remainder:
    """The heights over samples at most about ``spacing`` mm apart, of these ``facets`` (f,) of the mesh (None: all).

    ``body``: the cutter; ``blocks`` (b,): those of the course that cut. Raises SettingsError where none does.
    """
    if not len(blocks):
        raise SettingsError("no block cuts, so nothing can be said of what is left", 0)
    point, facet, area = surface_samples(mesh, spacing, facets)
    block, u, step = _way_samples(body, course, blocks)
    centres = _centres(body, course.pose(block, u))
    tree = cKDTree(centres.T)
    height, nearest = np.empty(len(point)), np.empty(len(point), np.int64)
    for first in range(0, len(point), CHUNK):
        progress("what is left", first / len(point))
        rows = slice(first, first + CHUNK)
        height[rows], nearest[rows] = _lowest(body, course, tree, block, u, step, point[rows])
    progress("what is left", 1.0)
    return Remainder(point, facet, area, height, nearest, spacing)


def surface_parts(mesh: Mesh, spacing: float, facets: Bools | None = None) -> tuple[Floats, Ints]:
    """Triangles (k, 3, 3) mm that together cover these facets, in the facets' own sense, and the facet (k,) of each.

    None has a side much longer than ``spacing`` mm: what is longer is halved across its longest side, again and again.
    """
    facet = np.arange(len(mesh.face)) if facets is None else np.flatnonzero(facets)
    corner, done = mesh.vertex[mesh.face[facet]], []
    for _ in range(MOST_HALVINGS):
        side = np.linalg.norm(np.roll(corner, 1, axis=1) - np.roll(corner, -1, axis=1), axis=2)  # that opposite each corner
        apex, long = side.argmax(axis=1), side.max(axis=1) > LONGEST * spacing
        done.append((corner[~long], facet[~long]))
        corner, facet = _halved(corner[long], apex[long]), np.repeat(facet[long], 2)
        if not len(facet):
            break
    corners, of = (np.concatenate(column) for column in zip(*done, (corner, facet), strict=True))
    order = np.argsort(of, kind="stable")
    return corners[order], of[order]


def _halved(corner: Floats, apex: Ints) -> Floats:
    """Both halves (2 k, 3, 3), in turn, of triangles (k, 3, 3): from ``apex`` (k,) to the middle of the side opposite."""
    row = np.arange(len(corner))
    a, b, c = (corner[row, (apex + k) % 3] for k in range(3))
    middle = 0.5 * (b + c)
    return np.stack([np.stack([a, b, middle], axis=1), np.stack([a, middle, c], axis=1)], axis=1).reshape(-1, 3, 3)


def surface_samples(mesh: Mesh, spacing: float, facets: Bools | None = None) -> tuple[Floats, Ints, Floats]:
    """The middles (k, 3) of the surface's parts, their facets (k,) and areas (k,) mm2."""
    corner, facet = surface_parts(mesh, spacing, facets)
    area = 0.5 * np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
    return corner.mean(axis=1), facet, area


def _way_samples(body: Body, course: Course, blocks: Ints) -> tuple[Ints, Floats, Floats]:
    """Blocks (s,), the u of the samples in them, and half the way to the next one, by u (s,)."""
    ends = [_centres(body, course.pose(blocks, np.full(len(blocks), u))) for u in (0.0, 0.5, 1.0)]
    length = sum(np.linalg.norm(q - p, axis=0) for p, q in pairwise(ends))
    spacing = max(CLOSE * max(piece.most for piece in body.pieces), float(np.sum(length)) / MOST_SAMPLES)
    count = np.ceil(np.asarray(length) / spacing).astype(np.int64) + 1
    block, share = np.repeat(blocks, count), np.repeat(1.0 / count, count)
    part = np.arange(len(block)) - np.repeat(np.cumsum(count) - count, count)
    return block, (part + 0.5) * share, 0.5 * share


def _centres(body: Body, pose: Poses) -> Floats:
    """A point of each pose (3, n) that lies in the lowest piece: where the cutter is looked for."""
    lowest = min(body.pieces, key=lambda piece: piece.low - piece.round)
    return np.asarray(pose.tip + lowest.low * pose.axis)


def _lowest(
    body: Body, course: Course, tree: cKDTree, block: Ints, u: Floats, step: Floats, point: Floats
) -> tuple[Floats, Ints]:  # fmt: skip
    """The least height (n,) of points, and the block where it is."""
    k = min(NEAREST, len(block))
    near = tree.query(point, k=k)[1].reshape(len(point), k)
    there, place = near.ravel(), np.repeat(point, k, axis=0).T
    first = _height(body, course.pose(block[there], u[there]), place).reshape(len(point), k)
    k = min(FOLLOWED, k)
    near = np.take_along_axis(near, np.argpartition(first, k - 1, axis=1)[:, :k], axis=1)
    there, place = near.ravel(), np.repeat(point, k, axis=0).T
    blocks, low, high = block[there], np.maximum(u[there] - step[there], 0.0), np.minimum(u[there] + step[there], 1.0)

    def height(at: Floats) -> Floats:
        return _height(body, course.pose(blocks, at), place)

    one, two = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    first, second = height(one), height(two)
    for _ in range(STEPS):
        left = first < second
        low, high = np.where(left, low, one), np.where(left, two, high)
        one, two = np.where(left, high - GOLDEN * (high - low), two), np.where(left, one, low + GOLDEN * (high - low))
        fresh = height(np.where(left, one, two))
        first, second = np.where(left, fresh, second), np.where(left, first, fresh)
    found = np.minimum(np.minimum(first, second), np.minimum(height(low), height(high))).reshape(len(point), k)
    best = found.argmin(axis=1)
    rows = np.arange(len(point))
    return found[rows, best], block[near[rows, best]]


def _height(body: Body, pose: Poses, place: Floats) -> Floats:
    arm = place - pose.tip
    along = (arm * pose.axis).sum(axis=0)
    out = arm - along * pose.axis
    across = np.sqrt((out * out).sum(axis=0))
    return np.asarray(np.min([off_piece(piece, across, along).distance for piece in body.pieces], axis=0))


def uncut_finding(remainder: Remainder, above: float) -> tuple[Finding, ...]:
    """A finding where more than ``above`` mm is left somewhere: area, largest height and its place."""
    area, volume = remainder.left(above)
    if area == 0.0:
        return ()
    worst = int(remainder.height.argmax())
    x, y, z = remainder.point[worst].tolist()
    text = (
        f"On {area:.4g} mm2 of the machined surface more than {above:.3g} mm is left, most at ({x:.6g}, {y:.6g}, {z:.6g}) mm: "
        f"{remainder.height[worst]:.4g} mm; {volume:.4g} mm3 in all. Cut these places with a smaller cutter or another tool axis."
    )
    return (Finding(Severity.WARNING, "uncut", text, area, 0.0, "mm2", place=(x, y, z)),)


def too_deep_finding(remainder: Remainder, tolerance: float) -> tuple[Finding, ...]:
    """A finding where the cutter takes off more than ``tolerance`` mm too much somewhere: area, depth and its place."""
    area, volume = remainder.taken(tolerance)
    if area == 0.0:
        return ()
    worst = int(remainder.height.argmin())
    x, y, z = remainder.point[worst].tolist()
    text = (
        f"On {area:.4g} mm2 of the machined surface more than {tolerance:.3g} mm is cut too deep, most at ({x:.6g}, {y:.6g}, "
        f"{z:.6g}) mm: {-remainder.height[worst]:.4g} mm; {volume:.4g} mm3 in all. Use --gouge lift or leave-out, or a smaller "
        "cutter."
    )
    return (Finding(Severity.ERROR, "cut-too-deep", text, -float(remainder.height[worst]), tolerance, "mm", place=(x, y, z)),)
