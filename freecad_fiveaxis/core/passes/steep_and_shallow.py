# SPDX-License-Identifier: LGPL-2.1-or-later
"""Level planes where the surface is steep, another strategy's passes where it is not, one over the other
along the line between.

Each strategy sees its own part of the surface and the strip beside it, as if that were all there is to cut:
so it lays its passes as close as its own part asks for. Facets that are not to be cut are passed over by
both, as always.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from .contact_path import ContactPath
from .field import PassOptions, PassStrategy, Region, cut
from .refine import take_facets
from .scallop import hand_curvature_on
from .slopes import Slopes, divide_by_slope
from .spirals import put_beside, take_lines

OVERLAP = 1.0
"""Stepovers, of a flat, by which passes go beyond the line."""

STUB = 0.3
"""Stepovers: a pass that is shorter and lies in the strip, where the other strategy's are, is none."""

BEND = 0.01
"""Stepovers by which passes may be straighter inside a facet of the part than on its pieces."""


@dataclass(frozen=True)
class Division:
    """``bound`` rad: steeper facets are cut by the strategy ``steep``, the others by ``shallow``; ``overlap``
    in stepovers of a flat; ``order`` and ``spiral`` as :func:`.field.cut` has them."""

    bound: float
    steep: PassStrategy
    shallow: PassStrategy
    order: str
    spiral: bool = False
    overlap: float = OVERLAP


def lay_by_slope(
    region: Region, options: PassOptions, division: Division
) -> tuple[ContactPath, tuple[Finding, ...]]:
    """Lay the passes of both strategies, those of the steep part first and from the top down, and say what
    they do not touch. Where all that is to be cut is steep, or nothing is, these are the very passes of the
    one strategy. Raises SettingsError."""
    slopes = divide_by_slope(region.mesh, division.bound, division.overlap * region.interval)
    kept = region.keep[slopes.copy.parent]
    if not (kept & ~slopes.steep).any():
        return lay_whole(region, options, division.steep, division.order, division.spiral)
    if not (kept & slopes.steep).any():
        return lay_whole(region, options, division.shallow, division.order, division.spiral)
    down, reports = _cut_strips(region, options, slopes, division, steep=True)
    flat, also = _cut_strips(region, options, slopes, division, steep=False)
    down = _top_down(down, division.order)
    flat = replace(flat, pass_=flat.pass_ + int(down.pass_.max(initial=-1)) + 1)
    return replace(put_beside([down, flat]), findings=(*down.findings, *flat.findings)), (*reports, *also)


def lay_whole(
    region: Region, options: PassOptions, strategy: PassStrategy, order: str, spiral: bool
) -> tuple[ContactPath, tuple[Finding, ...]]:
    """Lay the passes of one strategy on the region, and say what they do not touch. Raises SettingsError."""
    field = strategy.field(region, options)
    contact = cut(region, field, order, spiral)
    return contact, strategy.report_untouched(region, options, field, contact.face)


def _cut_strips(
    region: Region, options: PassOptions, slopes: Slopes, division: Division, steep: bool
) -> tuple[ContactPath, tuple[Finding, ...]]:
    """Return the passes of the one strategy on its part and the strip, and what they do not touch of its
    part."""
    strategy = division.steep if steep else division.shallow
    own = slopes.steep == steep
    kept = region.keep[slopes.copy.parent]
    rows = np.flatnonzero(own | slopes.strip | ~kept)
    copy = take_facets(slopes.copy, region.mesh, rows)
    hand_curvature_on(region.mesh, copy.mesh, copy.parent)
    part = replace(region, mesh=copy.mesh, keep=kept[rows])
    field = strategy.field(part, options)
    contact = cut(part, field, division.order, division.spiral)
    mostly = replace(region, keep=_mostly(slopes, kept & own, region.keep))
    reports = strategy.report_untouched(mostly, options, field, np.unique(copy.parent[contact.face]))
    reports = tuple(
        one
        for one in reports
        if not _at_rim(one, copy.mesh.vertex[copy.mesh.face[slopes.strip[rows]]], region)
    )
    contact = _without_stubs(contact, slopes.strip[rows], STUB * region.interval)
    return replace(copy, bend=BEND * region.interval).on_part(contact, region.mesh), reports


def _mostly(slopes: Slopes, own: Bools, keep: Bools) -> Bools:
    """Return the facets (f,) of the part that are to be cut and lie at least half in the pieces ``own``
    (n,)."""
    area, parent, count = slopes.copy.mesh.area, slopes.copy.parent, len(keep)
    return np.asarray(
        keep & (np.bincount(parent, area * own, count) >= 0.5 * np.bincount(parent, area, count))
    )


def _at_rim(found: Finding, strip: Floats, region: Region) -> bool:
    """Whether a finding tells of planes far apart at the rim of the strip, corners (n, 3, 3): behind it the
    other strategy's passes lie, and the next level plane is nowhere near."""
    if (
        found.code != Code.LEAST_INTERVAL
        or found.place is None
        or not len(strip)
        or (found.value or 0.0) <= region.radius
    ):
        return False
    return (
        float(np.linalg.norm(strip.reshape(-1, 3) - np.asarray(found.place), axis=1).min()) <= region.interval
    )


def _without_stubs(contact: ContactPath, strip: Bools, short: float) -> ContactPath:
    """Return the polylines but those shorter than ``short`` mm that lie in the strip."""
    line, count = contact.polyline[::2], int(contact.polyline.max(initial=-1)) + 1
    length = np.bincount(line, np.linalg.norm(contact.point[1::2] - contact.point[::2], axis=1), count)
    outside = np.bincount(line, ~strip[contact.face[::2]], count)
    stub = (length < short) & (outside == 0)
    return take_lines(contact, np.flatnonzero(~stub[contact.polyline])) if stub.any() else contact


def _top_down(contact: ContactPath, order: str) -> ContactPath:
    """Return the passes from the highest to the lowest: those that run to and fro the other way round, so
    that each still begins near the end of the one before, the others as they are."""
    if not len(contact.point) or contact.point[0, 2] >= contact.point[-1, 2]:
        return contact
    rows = np.arange(len(contact.point))[::-1] if order == "zigzag" else _lines_reversed(contact.polyline)
    turned = take_lines(contact, rows)
    return replace(turned, pass_=int(contact.pass_.max()) - turned.pass_)


def _lines_reversed(polyline: Ints) -> Ints:
    """Return the rows (n,) of polylines from the last to the first, each as it is."""
    return np.argsort(-polyline, kind="stable")
