# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pass strategy that leads from one guide to another: passes change their form from that of the one to
that of the other.

guide     a curve on the surface, a point, or part of the region's border. Curves along sides of facets are
          followed as they are, others within a side of the facets.
harmonic  field: 0 on the one guide, 1 on the other, and between them as heat would spread; so it has no
          summit and no basin (maximum principle), and its levels meet other borders, those of islands too, at
          right angles.
"""

from __future__ import annotations

import math

import numpy as np
import scipy

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Option, say
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .contact_path import direction
from .even_steps import count_in_steps
from .field import PassField, PassOptions, Region
from .geodesic import spread_between
from .scallop_passes import OverSurface, Surface, lay_passes, make_surface, survey_region
from .sources import BORDER, find_source, sample_curve

SIDE = math.cos(0.25 * math.pi)
"""Cosine between a side of the border and the travel: within 45 deg it is one that the passes follow."""


class Morph(OverSurface):
    """Level sets of the harmonic field between two guides, as close as the widest place between two of them
    asks for."""

    def check(self, region: Region, options: PassOptions) -> None:
        """Raise SettingsError for guides and a scallop that cannot be used and for more passes than any job
        can want."""
        survey_region(region, options)
        find_source(options.target, region, Option("to"))
        _refuse_without_border(region, options)

    def field(self, region: Region, options: PassOptions) -> PassField:
        """Return steps from the one guide towards the other, the pieces of the region one after the other."""
        region.progress("placing passes", 0.0)
        ground, target = survey_region(region, options), find_source(options.target, region, Option("to"))
        _refuse_without_border(region, options)
        surface = make_surface(region, ground)
        low, high = _find_guides(surface, ground.curve, target, options.direction)
        _refuse_one_guide(surface, low, high)
        region.progress("placing passes", 0.3)
        share = spread_between(surface.copy.mesh.face, surface.frame, surface.metric, low, high)
        region.progress("placing passes", 0.7)
        return lay_passes(region, surface, count_in_steps(surface, share))


def _refuse_without_border(region: Region, options: PassOptions) -> None:
    """Raise SettingsError where a guide is to be the border of a region that has none."""
    side = region.mesh.coedge_face
    inside = region.keep[side] & (side >= 0)
    if BORDER in (options.source, options.target) and inside[inside.any(axis=1)].all():
        text = say(
            "the surface that is to be cut has no border to lead passes from or to; give two guides by "
            "{from_} and {to}, a point X,Y,Z or a file CURVE.csv each",
            from_=Option("from_"), to=Option("to"),
        )  # fmt: skip
        raise SettingsError(text, BORDER)


def _refuse_one_guide(surface: Surface, low: Ints, high: Ints) -> None:
    """Raise SettingsError where no component of the surface has vertices (m,) of both guides."""
    component = surface.copy.component
    if not len(np.intersect1d(component[low], component[high])):
        text = say(
            "no piece of the surface that is to be cut has both guides on it; give {from_} and {to} on one "
            "piece",
            from_=Option("from_"), to=Option("to"),
        )  # fmt: skip
        raise SettingsError(text, "morph")


def _find_guides(
    surface: Surface, source: Floats | None, target: Floats | None, travel: float
) -> tuple[Ints, Ints]:
    """Return the vertices (m,) of the copy on the one guide and on the other; ``source`` and ``target`` (n,
    3) mm, None: the border."""
    mesh = surface.copy.mesh
    if source is None and target is None:
        return _sides_of_border(surface, travel)
    rim = np.unique(mesh.coedge_vertex[mesh.coedge_face[:, 1] < 0])
    low = None if source is None else _along_curve(mesh, source)
    high = None if target is None else _along_curve(mesh, target)
    low = np.setdiff1d(rim, _beside(mesh, high)) if low is None else low
    high = np.setdiff1d(rim, _beside(mesh, low)) if high is None else high
    return np.setdiff1d(low, high), high


def _along_curve(mesh: Mesh, curve: Floats) -> Ints:
    """Return the vertices (m,) nearest to samples of the curve."""
    edge = mesh.vertex[mesh.coedge_vertex]
    step = 0.25 * float(np.median(np.linalg.norm(edge[:, 1] - edge[:, 0], axis=1)))
    return np.unique(scipy.spatial.cKDTree(mesh.vertex).query(sample_curve(curve, step))[1]).astype(np.int64)


def _beside(mesh: Mesh, guide: Ints | None) -> Ints:
    """Return the vertices (m,) of a guide and all that share a side with one: what of the border touches it
    belongs to it."""
    assert guide is not None
    there = np.zeros(len(mesh.vertex), np.bool_)
    there[guide] = True
    return np.unique(mesh.coedge_vertex[there[mesh.coedge_vertex].any(axis=1)])


def _sides_of_border(surface: Surface, travel: float) -> tuple[Ints, Ints]:
    """Of each component with several borders the longest and the next; of one with one border what lies to
    the right and to the left of the travel, rad."""
    mesh, component = surface.copy.mesh, surface.copy.component
    edge = np.flatnonzero(mesh.coedge_face[:, 1] < 0)
    ends = mesh.coedge_vertex[edge]
    graph = scipy.sparse.coo_matrix(
        (np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(len(component), len(component))
    )
    loop = scipy.sparse.csgraph.connected_components(graph, directed=False)[1][ends[:, 0]]
    way = mesh.vertex[ends[:, 1]] - mesh.vertex[ends[:, 0]]
    number = np.unique(loop, return_inverse=True)[1]
    owner = np.zeros(int(number.max(initial=-1)) + 1, np.int64)
    owner[number] = component[ends[:, 0]]
    rank = _ranks(owner, np.bincount(number, np.linalg.norm(way, axis=1)).astype(np.float64))
    alone = np.bincount(owner, minlength=int(component.max(initial=0)) + 1)[owner] == 1
    right, left = _right_and_left(way, travel)
    low, high = (
        np.where(alone[number], side, rank[number] == place) for side, place in ((right, 0), (left, 1))
    )
    one, other = np.unique(ends[low]), np.unique(ends[high])
    return np.setdiff1d(one, other), np.setdiff1d(other, one)


def _ranks(owner: Ints, length: Floats) -> Ints:
    """Of each border (b,) how many of the same component are longer."""
    order = np.lexsort((-length, owner))
    begins = np.append(True, np.diff(owner[order]) != 0)[: len(order)]
    rank = np.empty(len(owner), np.int64)
    rank[order] = np.arange(len(owner)) - np.flatnonzero(begins)[np.cumsum(begins) - 1]
    return rank


def _right_and_left(way: Floats, travel: float) -> tuple[Bools, Bools]:
    """Which of the border's sides (e,), ``way`` (e, 3) mm with the surface to its left, run along the travel
    and so lie to the right of it, and which run against it. Where the surface stands across the travel, its
    sides along Z are taken."""
    cosine, sine = direction(travel)
    for along in np.array([[cosine, sine, 0.0], [0.0, 0.0, 1.0]]):
        share = way @ along
        least = SIDE * np.linalg.norm(way, axis=1)
        right, left = share > least, share < -least
        if right.any() and left.any():
            break
    return np.asarray(right), np.asarray(left)
