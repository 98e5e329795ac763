# SPDX-License-Identifier: LGPL-2.1-or-later
"""The boundary that the settings name: which facets lie within it, and where it cuts the passes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from freecad_fiveaxis.core.base.curve_text import name_source
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.orientation.order_with_axes import order_with_axes
from freecad_fiveaxis.core.passes.boundary import Boundary, facets_within, read_boundary
from freecad_fiveaxis.core.toolpath.cl_path import CLPath
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath
from freecad_fiveaxis.core.toolpath.cut_at_boundary import cut_at_boundary

from .context import MillContext
from .options import compute_driven_to_hub
from .overlapping import make_buried_test
from .settings import Settings

CENTRE = "centre"


def boundary_of(settings: Settings) -> Boundary | None:
    """Read the boundary that the settings name, None where they name none. Raises SettingsError,
    FileError."""
    chosen = settings.boundary
    if chosen.boundary is None:
        return None
    return read_boundary(chosen.boundary, name_source(chosen.boundary), chosen.boundary_axis)


def facets_inside(
    settings: Settings, boundary: Boundary | None, mesh: Mesh, faces: Bools | None
) -> tuple[Bools, tuple[Finding, ...]]:
    """Find those of the ``faces`` (f,; None: all) that lie within the boundary at least in part, and say what
    the others are. Raises SettingsError where there is none."""
    if boundary is None:
        return np.ones(len(mesh.face), np.bool_) if faces is None else faces, ()
    reach = settings.cutter.cutter.radius if settings.boundary.boundary_by == CENTRE else 0.0
    return facets_within(boundary, mesh, faces, reach)


def cut_to_boundary(context: MillContext, offset: OffsetPath) -> OffsetPath:
    """Cut the passes at the boundary, and order the pieces anew where passes run to and fro. Where the centre
    of a cutter that is no ball counts, :func:`cut_by_hub` does so once its axes are known. Raises
    SettingsError where nothing is left."""
    settings, boundary = context.settings, context.boundary
    if boundary is None or _by_hub(context):
        return offset
    cut, _ = cut_at_boundary(offset, boundary, settings.boundary.boundary_by == CENTRE)
    if cut is offset or settings.links.order != "zigzag":
        return cut
    return order_with_axes(cut, cut.normal)[0]


def cut_by_hub(context: MillContext, offset: OffsetPath, axis: Floats) -> tuple[OffsetPath, Floats]:
    """Cut passes on which a cutter that is no ball sits with its axes (n, 3) where its centre crosses the
    boundary, where that counts. Raises SettingsError where nothing is left."""
    if context.boundary is None or not _by_hub(context):
        return offset, axis
    cut, along = cut_at_boundary(offset, context.boundary, True, axis)
    return cut, axis if along is None else along


def make_place_test(context: MillContext) -> Callable[[Floats, Ints], Bools] | None:
    """Return what tells of places (k, 3) mm on facets (k,) of the part whether they lie within the boundary,
    far enough from faces to avoid, and inside no other solid of the part, so that something is to be cut
    there; where the centre counts, the place of a ball's over them. None where there is nothing of these."""
    within, keep_off, mesh = _within(context), context.keep_off, context.mesh
    tests: list[Callable[[Floats, Ints], Bools]] = [] if within is None else [within]
    if keep_off is not None:
        tests.append(lambda point, facet: keep_off.allows(mesh, point, facet))
    is_buried = make_buried_test(mesh)
    if is_buried is not None:
        tests.append(lambda point, facet: ~is_buried(point, facet))
    if not tests:
        return None
    return lambda point, facet: np.asarray(np.all([test(point, facet) for test in tests], axis=0))


def _within(context: MillContext) -> Callable[[Floats, Ints], Bools] | None:
    boundary = context.boundary
    if boundary is None:
        return None
    stand = context.settings.cutter.cutter.corner if context.settings.boundary.boundary_by == CENTRE else 0.0
    normal, curves, project = context.mesh.normal, boundary.curves, boundary.project
    return lambda point, facet: curves.inside(project(point + stand * normal[facet]))


def leads_outside(context: MillContext, path: CLPath, begin: Ints, end: Ints) -> Bools:
    """Find the straight ways from rows ``begin`` to rows ``end`` (w,) of the path that leave the boundary."""
    boundary, settings = context.boundary, context.settings
    if boundary is None:
        return np.zeros(len(begin), np.bool_)
    by_centre = settings.boundary.boundary_by == CENTRE
    place = boundary.project(
        path.tip + compute_driven_to_hub(settings) * path.axis if by_centre else path.contact
    )
    found = ~boundary.curves.inside(0.5 * (place[begin] + place[end]))
    found[boundary.curves.crossings(place[begin], place[end])[0]] = True
    return found


def _by_hub(context: MillContext) -> bool:
    """Whether the boundary holds the centre of a cutter whose centre depends on its axis."""
    settings = context.settings
    return settings.boundary.boundary_by == CENTRE and not settings.cutter.cutter.touches_as_ball
