# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contact points of a path, where the tool stands at each, and whether it is free there.

contact    all rows of one contact point: they have the same point and the same facet normals on either side,
           under a level bottom the same seat as well. They share one axis.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.orientation.strategies import AxisOptions, facet_mean
from freecad_fiveaxis.core.toolpath.cl_offset import seat_normal
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath
from freecad_fiveaxis.core.toolpath.feed_direction import SHORT

from .axis_field import are_free, with_way_out
from .facets_with_axis import AxisField
from .level_bottom import TO_LEVEL
from .raised_contacts import raise_contacts
from .slide_bottoms import slide_bottoms

SAME_SEAT, LEANS_IN = 1e-9, 1e-9
"""Of unit normals on which a bottom sits: what differs by less is one. Sine by which rounding may make an
axis along a wall lean into it."""


@dataclass(frozen=True, eq=False)
class Contacts:
    """Of k contact points: ``first`` (k,) row, ``facet`` (k,) and mean normal ``mean`` (k, 3); of n rows: the
    ``contact`` (n,) of each, ``stand`` (n, 3) mm where its tool stands, ``normal`` (n, 3), ``fits`` (n,)
    whether the ball does."""

    point: Floats
    facet: Ints
    first: Ints
    mean: Floats
    contact: Ints
    stand: Floats
    normal: Floats
    fits: Bools

    def free(
        self, axis: Floats, wanted: Bools, reacher: Reacher, tree: FacetTree, progress: Progress
    ) -> Bools:
        """Whether the contacts ``wanted`` (k,) are free with ``axis`` (k, 3), at each of their rows; the
        others are not."""
        rows = np.flatnonzero((wanted & self.all_fit)[self.contact])
        into = rows[
            (axis[self.contact[rows]] * self.normal[rows]).sum(axis=1)
            < -math.sin(reacher.cutter.undercut) - LEANS_IN
        ]  # leans in
        good = wanted & self.all_fit
        good[self.contact[into]] = False
        for part in (self.leads, ~self.leads):  # where the first row is not free the others need not be asked
            rows = np.flatnonzero(part & good[self.contact])
            turned = axis[self.contact[rows]]
            free = are_free(reacher, tree, self.stand[rows], self.normal[rows], turned, progress)
            good[self.contact[rows[~free]]] = False
        return good

    @cached_property
    def leads(self) -> Bools:
        """Which rows (n,) are the first of their contacts."""
        leads = np.zeros(len(self.contact), np.bool_)
        leads[self.first] = True
        return leads

    @cached_property
    def all_fit(self) -> Bools:
        """Whether the ball fits at all rows of a contact (k,)."""
        return np.asarray(np.bincount(self.contact[~self.fits], minlength=len(self.first)) == 0)


def slide_path(
    path: OffsetPath, field: AxisField, mesh: Mesh, reacher: Reacher, progress: Progress = silent
) -> OffsetPath:
    """Return the path with contacts slid to where the tool of ``reacher`` is free and can be drawn out, of
    those at which the ``field`` wants it level and it is not."""
    tree, long = facet_tree(mesh), with_way_out(reacher, facet_tree(mesh))
    normal = seat_normal(path, reacher.cutter.ring)
    rows = np.flatnonzero((field.at(path.point, normal, progress) * normal).sum(axis=1) > TO_LEVEL)
    stand, _ = raise_contacts(
        reacher, tree, (path.centre - reacher.cutter.corner * normal)[rows], normal[rows]
    )
    blocked = ~are_free(long, tree, stand, normal[rows], normal[rows], progress)
    rows, slide = rows[blocked], np.zeros_like(path.point)
    slide[rows] = slide_bottoms(long, tree, stand[blocked], normal[rows], progress)
    return replace(path, point=path.point + slide, centre=path.centre + slide)


def find_contacts(path: OffsetPath, mesh: Mesh, reacher: Reacher) -> Contacts:
    """Find the contacts of ``path`` and where the tool stands there: dear, so :mod:`.auto_axis` takes them
    from whoever asks it twice. Where a level bottom sits on one face after the other of an edge, these are
    contacts of their own."""
    columns = [(path.point, SHORT), (path.before, 0.0), (path.after, 0.0)]
    mean, normal = facet_mean(path, AxisOptions()), path.normal
    if reacher.cutter.has_level_bottom:
        mean = normal = seat_normal(path, reacher.cutter.ring)
        columns.append((normal, SAME_SEAT))
    begins = np.ones(len(path.point), np.bool_)
    begins[1:] = np.diff(path.polyline) != 0
    for column, limit in columns:
        begins[1:] |= (np.abs(column[1:] - column[:-1]) > limit).any(axis=1)
    contact, first = _join_at_seams(path.polyline, columns, np.cumsum(begins) - 1, np.flatnonzero(begins))
    point = path.centre - reacher.cutter.corner * normal
    stand, fits = raise_contacts(reacher, facet_tree(mesh), point, normal)
    return Contacts(path.point[first], path.face[first], first, mean[first], contact, stand, normal, fits)


def _join_at_seams(
    polyline: Ints, columns: list[tuple[Floats, float]], contact: Ints, first: Ints
) -> tuple[Ints, Ints]:
    """Return the contact (n,) of each row and the first row (k,) of each contact, with both ends of a closed
    ``polyline`` (n,) as one: its ``columns`` are alike there within their limits."""
    start = np.flatnonzero(np.diff(polyline, prepend=polyline[0] - 1))
    end = np.append(start[1:], len(contact)) - 1
    same = np.ones(len(start), np.bool_)
    for column, limit in columns:
        same &= (np.abs(column[start] - column[end]) <= limit).all(axis=1)
    into = np.arange(len(first))
    into[contact[end[same]]] = contact[start[same]]
    kept, number = np.unique(into, return_inverse=True)
    return number[contact], first[kept]
