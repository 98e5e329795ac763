# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool axis as a field: at every place of the surface a unit vector with which the tool is free, smooth
over it.

node        a place on the surface with its facet's normal; there the tool stands on the part, raised along
            the normal where the ball itself would enter (no axis helps there).
direction   one of many unit vectors, spread evenly; the same ones are tried at every node that they lean from
            by no more than WIDEST, a lollipop by its undercut more, and the node's own normal besides.
free        within the machine's limits, above the table, cutter, shank and holder out of the part, and no
            body of the machine in the way.
near        in (point, spacing x normal): places whose normals differ by 90 deg are as far apart as neighbours
            with the same one.

The field begins with the normals where these are free and with few directions that free the most of the rest
(a set cover). Then each node takes the mean of its neighbours, its own axis and a little of its normal,
pulled back to the nearest free direction, again and again: a turn is spread over the millimetres about an
edge. Last, what is not free takes a free direction.
"""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import scipy

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.obstacles import (
    Obstacle,
    Reacher,
    find_lower,
    obstacles,
    part_heights,
    stay_above,
    within_limits,
)
from freecad_fiveaxis.core.gouge.rest_material import surface_samples

from .raised_contacts import raise_contacts
from .rulings import find_rulings

NODES = 1300
"""Places on the surface, evenly by area."""

DIRECTIONS = 250
"""Unit vectors over the whole sphere; about 14 deg from one to the next."""

WIDEST = math.radians(88.0)
"""How far a direction may lean from the normal of the surface: in a deep pocket the tool stands nearly along
its walls."""

ALONG = math.radians(90.001)
"""How far it may lean where the tool may stand along walls: in a bore little wider than the tool no other
axis is free; with a hair more, for normals are rounded."""

MAIN = 8
"""Normals, at most, along which the part may have pockets and bores: those of most area."""

ASIDE, ABOUT = math.radians(3.0), 6
"""rad by which directions stand off a main one, and how many: so the tool gets along the walls of what stands
along it."""

ALIKE = 0.02
"""Of a unit vector: normals that differ by less in each coordinate are taken for one."""

MARGIN = 0.3
"""mm by which shank and holder are thicker at nodes: the field is to be free between them too."""

NEIGHBOURS = 12
ROUNDS = 75
"""Means taken before what is free is asked again, and once more after that."""

OWN, UPRIGHT = 1.0 / 1.5, 0.1
"""Weights of a node's own axis and of its normal beside the mean of its neighbours."""

OPPOSING = 0.3
"""Cosine by which normals may oppose before they have nothing to do with one another."""

FRAMES = 12
"""Directions of the set cover, at most."""

WELL = 0.35
"""Cosine to the normal of the directions that are taken into the set cover."""

FEW = 0.01
"""Of the nodes: a direction that frees fewer is not taken into the cover."""

CELL = 1.25
"""Times half the mean distance of directions: a mean so near to a free direction is taken for free until it
is asked."""

BATCH = 16384
"""Trials at a time: a stop is heard soon."""

IN_CACHE = 256
"""Places at a time whose cosines to all directions are compared."""

BARRED = -4.0
"""Stands for the cosine to what is not free: with any cosine added it stays below all of them."""


@dataclass(frozen=True, eq=False)
class Nodes:
    """``point`` (n, 3) mm on the surface, its ``facet`` (n,) and unit ``normal`` (n, 3), ``stand`` (n, 3) mm:
    where the tool's contact is, raised; ``fits`` (n,) whether the ball is out of the part there. ``spacing``
    mm between nodes."""

    point: Floats
    facet: Ints
    normal: Floats
    stand: Floats
    fits: Bools
    spacing: float

    def places(self) -> Floats:
        """Coordinates (n, 6) mm in which near is meant."""
        return near_places(self.point, self.normal, self.spacing)

    def take(self, rows: Ints) -> Nodes:
        """Pick these nodes (k,)."""
        return Nodes(
            self.point[rows], self.facet[rows], self.normal[rows], self.stand[rows], self.fits[rows],
            self.spacing
        )  # fmt: skip

    def join(self, more: Nodes) -> Nodes:
        """Append ``more`` nodes."""

        def both(name: str) -> Any:
            return np.concatenate([getattr(self, name), getattr(more, name)])

        return Nodes(both("point"), both("facet"), both("normal"), both("stand"), both("fits"), self.spacing)


@dataclass(frozen=True, eq=False)
class Freedom:
    """``direction`` (d, 3) unit; ``free`` (n, d) at each node; ``upright`` (n,) whether its own normal is
    free; ``met`` (n,) of :class:`Obstacle`: what is in the way of the direction that gets farthest."""

    direction: Floats
    free: Bools
    upright: Bools
    met: Ints

    @functools.cached_property
    def barred(self) -> Floats:
        """Summands (n, d) to cosines that leave none that is not free above BARRED / 2."""
        return np.where(self.free, 0.0, BARRED)

    @property
    def some(self) -> Bools:
        """Where any axis is free (n,)."""
        return np.asarray(self.free.any(axis=1) | self.upright)

    def join(self, more: Freedom) -> Freedom:
        """Append what is free at ``more`` nodes, where the same directions were tried."""
        free, upright = np.concatenate([self.free, more.free]), np.concatenate([self.upright, more.upright])
        return Freedom(self.direction, free, upright, np.concatenate([self.met, more.met]))

    def of(self, node: Ints) -> Freedom:
        """Return what is free at these nodes (k,)."""
        return Freedom(self.direction, self.free[node], self.upright[node], self.met[node])

    @property
    def cell(self) -> float:
        """Cosine of the angle within which a mean belongs to the nearest direction."""
        return math.cos(CELL * math.sqrt(4.0 / DIRECTIONS))


def even_directions(count: int = DIRECTIONS) -> Floats:
    """Spread unit vectors (count, 3) evenly over the sphere: a Fibonacci lattice."""
    row = np.arange(count) + 0.5
    z, turn = 1.0 - 2.0 * row / count, math.pi * (1.0 + math.sqrt(5.0)) * row
    out = np.sqrt(1.0 - z * z)
    return np.stack([out * np.cos(turn), out * np.sin(turn), z], axis=1)


def main_directions(mesh: Mesh) -> Floats:
    """Find the unit vectors (d, 3), both ways, along which pockets, bores and walls of a part most likely
    stand, and some a little aside: the axes of the work frame, the normals of most area, and the rulings of
    hollow walls."""
    key, group = np.unique(np.round(mesh.normal / ALIKE).astype(np.int64), axis=0, return_inverse=True)
    area = np.bincount(group.ravel(), mesh.area, len(key))
    most = np.argsort(-area, kind="stable")[:MAIN]
    first = np.unique(group.ravel(), return_index=True)[1][most]
    one = np.concatenate([np.eye(3), mesh.normal[first]])
    one = np.concatenate([one, find_rulings(mesh, one)])
    both = np.concatenate([one, -one])
    main = both[np.sort(np.unique(np.round(both, 6) + 0.0, axis=0, return_index=True)[1])]
    return np.concatenate([main, *(_leaning(main, 2.0 * math.pi * k / ABOUT) for k in range(ABOUT))])


def _leaning(main: Floats, turn: float) -> Floats:
    """Return unit vectors (d, 3) that stand ASIDE of others towards ``turn`` rad about them."""
    least = np.eye(3)[np.abs(main).argmin(axis=1)]
    across = unit(np.cross(main, least))
    towards = math.cos(turn) * across + math.sin(turn) * np.cross(main, across)
    return np.asarray(math.cos(ASIDE) * main + math.sin(ASIDE) * towards)


def surface_nodes(mesh: Mesh, facets: Bools, reacher: Reacher, tree: FacetTree, count: int = NODES) -> Nodes:
    """Choose ``count`` places, about, on these ``facets`` (f,), evenly by area."""
    area = float(mesh.area[facets].sum())
    spacing = math.sqrt(area / count)
    point, facet, part = surface_samples(mesh, spacing, facets)
    summed = np.cumsum(part)
    chosen = np.unique(np.searchsorted(summed, (np.arange(count) + 0.5) * (summed[-1] / count)))
    point, facet, normal = point[chosen], facet[chosen], mesh.normal[facet[chosen]]
    return Nodes(point, facet, normal, *raise_contacts(reacher, tree, point, normal), spacing)


def with_margin(reacher: Reacher, margin: float = MARGIN) -> Reacher:
    """Thicken shank, holder and a lollipop's neck by ``margin`` mm all round."""
    shank, holder = (
        tuple((wide + 2.0 * margin, long) for wide, long in rows) for rows in (reacher.shank, reacher.holder)
    )
    return replace(reacher, cutter=reacher.cutter.thicken_neck(margin), shank=shank, holder=holder)


def are_free(
    reacher: Reacher,
    tree: FacetTree,
    stand: Floats,
    normal: Floats,
    axis: Floats,
    progress: Progress = silent,
) -> Bools:
    """Ask whether (n,) the tool is free on these contacts ``stand`` (n, 3) mm with unit ``normal`` and
    ``axis`` (n, 3)."""
    return np.asarray(_find_obstacles(reacher, tree, stand, normal, axis, progress) == Obstacle.NONE)


def _find_obstacles(
    reacher: Reacher, tree: FacetTree, stand: Floats, normal: Floats, axis: Floats,
    progress: Progress = silent,
    height: Floats | None = None,
) -> Ints:  # fmt: skip
    """Return what is in the way (n,) of :class:`Obstacle` there."""
    met = np.empty(len(stand), np.int64)
    for first in range(0, len(stand), BATCH):
        progress("axis field", first / len(stand))
        rows = slice(first, first + BATCH)
        known = None if height is None else height[rows]
        met[rows] = obstacles(reacher, tree, stand[rows], normal[rows], axis[rows], known)
    return met


def find_freedom(
    nodes: Nodes,
    reacher: Reacher,
    tree: FacetTree,
    direction: Floats,
    progress: Progress = silent,
    along_walls: bool = True,
) -> Freedom:
    """Try ``direction`` (d, 3) and the own normals at all nodes where the ball fits.

    Only where no axis above a floor is free, lower ones are tried; and only where none lets the tool be drawn
    out along it, it is enough that the tool is free as it stands.
    ``along_walls``: they may lean by ALONG, else by WIDEST."""
    direction = direction[within_limits(reacher, direction)]
    rows, height = np.arange(len(nodes.point)), part_heights(tree, nodes.normal)
    along = nodes.normal @ direction.T
    tried = along > math.cos(WIDEST + reacher.cutter.undercut)
    if along_walls:  # but not with a tool as level as may be under what looks straight down
        most = math.cos(max(reacher.most - (ALONG - WIDEST), 0.0))
        tried |= (along > math.cos(ALONG)) & (direction[:, 2] > most)
    tried &= nodes.fits[:, None]
    first, *others = (*stay_above(with_way_out(reacher, tree)), reacher)
    found = _try_directions(nodes, rows, first, tree, direction, tried, height, progress)
    for tool in others:
        if len(held := rows[nodes.fits & ~found.some]):
            here = _try_directions(nodes, held, tool, tree, direction, tried[held], height[held], progress)
            found.free[held], found.upright[held], found.met[held] = here.free, here.upright, here.met
    return found


def with_way_out(reacher: Reacher, tree: FacetTree) -> Reacher:
    """Return the tool as it would be if it were in all places at once on its way out of the part's box along
    its axis."""
    return replace(reacher, far=2.0 * float(np.linalg.norm(tree.half[:, 0])) + tree.most_allowance)


def _try_directions(
    nodes: Nodes,
    rows: Ints,
    reacher: Reacher,
    tree: FacetTree,
    direction: Floats,
    tried: Bools,
    height: Floats,
    progress: Progress,
) -> Freedom:
    """Return what is free at the nodes ``rows`` (k,) of directions (d, 3) within the limits, of those
    ``tried`` (k, d) there; ``height`` (k,) mm of the part there."""
    stand, normal, fits = nodes.stand[rows], nodes.normal[rows], nodes.fits[rows]
    node, way = np.nonzero(tried)
    free, farthest = (
        np.zeros(tried.shape, np.bool_),
        np.where(fits, int(Obstacle.LIMITS), int(Obstacle.CUTTER)),
    )
    within = replace(reacher, kinematics=None, most=math.pi)
    met = _find_obstacles(within, tree, stand[node], normal[node], direction[way], progress, height[node])
    free[node, way] = met == Obstacle.NONE
    along = (normal[node] * direction[way]).sum(axis=1)
    above = along > math.cos(
        WIDEST
    )  # what an undercut meets below the surface is no reason: few places have one
    np.maximum.at(farthest, node[above], met[above])
    own = np.where(
        fits, _find_obstacles(reacher, tree, stand, normal, normal, height=height), int(Obstacle.CUTTER)
    )
    return Freedom(direction, free, own == Obstacle.NONE, np.maximum(farthest, own))


def find_field(
    nodes: Nodes, freedom: Freedom, reacher: Reacher, tree: FacetTree, progress: Progress = silent,
    strict: Bools | None = None,
) -> Floats:  # fmt: skip
    """Find the unit axis (n, 3) of every node: free wherever any direction is, else the mean of its
    neighbours. ``strict`` (n,): nodes that take one of the free directions, None: only where nothing near it
    is free."""
    _, near = scipy.spatial.cKDTree(nodes.places()).query(
        nodes.places(), k=min(NEIGHBOURS + 1, len(nodes.point))
    )
    near = near.reshape(len(nodes.point), -1)[:, 1:]
    weight = agreeing(nodes.normal[:, None], nodes.normal[near])
    axis, some = _first_guess(nodes.normal, freedom), freedom.some
    strict = np.zeros(len(nodes.point), np.bool_) if strict is None else strict.copy()
    for _ in range(2):
        axis = _smooth_field(axis, nodes.normal, (near, weight), freedom, strict)
        progress("axis field", 1.0)
        strict[some] |= ~are_free(reacher, tree, nodes.stand[some], nodes.normal[some], axis[some])
        nearest, _ = nearest_free(axis, nodes.normal, freedom)
        strict |= find_lower(with_way_out(reacher, tree), nodes.stand, nodes.normal, axis, nearest)
    nearest, _ = nearest_free(axis, nodes.normal, freedom)
    return np.where((strict & some)[:, None], nearest, axis)


def _first_guess(normal: Floats, freedom: Freedom) -> Floats:
    """Return the normals (n, 3) where these are free, else the nearest direction of the set cover, else any
    that is free."""
    cover = _set_cover(normal, freedom)
    axis, got = nearest_free(
        normal, normal, replace(freedom, direction=freedom.direction[cover], free=freedom.free[:, cover])
    )
    other, _ = nearest_free(normal, normal, freedom)
    return np.where(got[:, None], axis, other)


def _set_cover(normal: Floats, freedom: Freedom) -> Ints:
    """Few directions (c,) that free most nodes whose own normals are not, each the one that frees most of the
    rest."""
    left, found = freedom.some & ~freedom.upright, list[int]()
    frees = freedom.free & (normal @ freedom.direction.T > WELL)
    for _ in range(FRAMES if frees.shape[1] else 0):
        gain = (frees & left[:, None]).sum(axis=0)
        best = int(gain.argmax())
        if gain[best] < max(1.0, FEW * len(normal)):
            break
        found.append(best)
        left &= ~frees[:, best]
    return np.array(found, np.int64)


def nearest_free(axis: Floats, normal: Floats, freedom: Freedom) -> tuple[Floats, Bools]:
    """Find the free direction (n, 3) nearest to unit ``axis`` (n, 3), and where there is one (n,); elsewhere
    the axis stays."""
    if not len(freedom.direction):
        return np.where(freedom.upright[:, None], normal, axis), freedom.upright.copy()
    best, cosine = _find_nearest(axis, freedom)
    upright = np.where(freedom.upright, (axis * normal).sum(axis=1), BARRED)
    got = np.maximum(cosine, upright) > 0.5 * BARRED
    found = np.where((upright > cosine)[:, None], normal, freedom.direction[best])
    return np.where(got[:, None], found, axis), got


def _find_nearest(axis: Floats, freedom: Freedom) -> tuple[Ints, Floats]:
    """Find which direction (n,) is nearest to each axis, and the cosine to it (n,), below BARRED / 2 where
    none is free; so many at a time that their table of cosines stays in the processor's cache."""
    best, cosine = np.empty(len(axis), np.int64), np.empty(len(axis))
    for first in range(0, len(axis), IN_CACHE):
        rows = slice(first, first + IN_CACHE)
        along = axis[rows] @ freedom.direction.T
        along += freedom.barred[rows]
        best[rows] = along.argmax(axis=1)
        cosine[rows] = along[np.arange(len(along)), best[rows]]
    return best, cosine


def _smooth_field(
    axis: Floats, normal: Floats, about: tuple[Ints, Floats], freedom: Freedom, strict: Bools
) -> Floats:
    """Return the field after ROUNDS means ``about`` each node: its neighbours (n, k) and their weights (n,
    k). ``strict`` (n,): what takes a free direction itself, whatever is near it."""
    near, weight = about
    share = weight / np.maximum(weight.sum(axis=1), 1e-9)[:, None]
    for _ in range(ROUNDS):
        mean = unit(np.einsum("nk,nki->ni", share, axis[near]) + OWN * axis + UPRIGHT * normal)
        nearest, _ = nearest_free(mean, normal, freedom)
        inside = ~strict & ((mean * nearest).sum(axis=1) > freedom.cell)
        axis = np.where(inside[:, None], mean, nearest)
    return axis


def agreeing(one: Floats, other: Floats) -> Floats:
    """Weigh (...) unit normals (..., 3) by how they agree: 1 up to 90 deg, nothing where they oppose, as on
    two sides of a thin wall."""
    return np.asarray(np.clip(1.0 + (one * other).sum(axis=-1) / OPPOSING, 0.0, 1.0))


def near_places(point: Floats, normal: Floats, spacing: float) -> Floats:
    """Put points (n, 3) mm and unit normals (n, 3) into the one space (n, 6) mm in which near is meant."""
    return np.concatenate([point, spacing * normal], axis=1)


def unit(vector: Floats) -> Floats:
    """Make vectors (n, 3) unit; what has no length stays."""
    length = np.linalg.norm(vector, axis=1)
    return np.asarray(vector / np.where(length > 0.0, length, 1.0)[:, None])
