# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pass strategies of parallel planes: a linear field, spaced by stepover or scallop (Lin & Ye, II.B and
C).

upright   planes along a travel direction, or of any ``normal`` that the options give; level planes are those
          of the normal Z.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import scipy

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import Area, Length, say

from .contact_path import direction
from .field import ALL_ROUND, PassField, PassOptions, Region, Vector
from .sides import find_untouched_sides, side_findings
from .spacing import WIDEST, PlacePlanes, prepare_planes

SHORTEST = 1e-9
"""Length of a normal whose direction is lost in rounding."""

BESIDE = 3.0
"""Intervals of a flat: small facets so near to a pass lie between two."""

SHARE = 0.002
"""Of the area to be cut: what no pass touches is told where it is more."""


@dataclass(frozen=True)
class Planes:
    """Parallel planes; ``own`` normal: the options' one does not count."""

    text: str
    own: Vector | None = None
    over_surface: bool = False

    def travels(self, options: PassOptions) -> tuple[float, ...]:
        """Along the planes' horizontal lines; level planes have those all round."""
        normal = self.own or options.normal
        if normal is None:
            return (options.direction,)
        x, y, _ = _unit(normal).tolist()
        return (math.atan2(-x, y),) if math.hypot(x, y) > SHORTEST else ALL_ROUND

    def check(self, region: Region, options: PassOptions) -> None:
        """Raise SettingsError for a normal without direction, a scallop or stepover out of range, and too
        many planes."""
        self._prepare(region, options)

    def field(self, region: Region, options: PassOptions) -> PassField:
        """Distance across the planes, mm, and where they lie."""
        mesh, across = region.mesh, self._across(options)
        levels, found = self._prepare(region, options)()
        if across is not None:
            return PassField(mesh.vertex @ across, levels, found)
        cosine, sine = direction(options.direction)
        return PassField(
            cosine * mesh.vertex[:, 1] - sine * mesh.vertex[:, 0], levels, found, options.direction
        )

    def _across(self, options: PassOptions) -> Floats | None:
        normal = self.own or options.normal
        return None if normal is None else _unit(normal)

    def _prepare(self, region: Region, options: PassOptions) -> PlacePlanes:
        return prepare_planes(
            region.mesh, options.direction, region.radius, stepover=options.stepover, scallop=options.scallop,
            least=options.least, keep=region.keep, progress=region.progress, widest=region.widest or WIDEST,
            normal=self._across(options),
        )  # fmt: skip

    def report_untouched(
        self, region: Region, options: PassOptions, field: PassField, touched: Ints
    ) -> tuple[Finding, ...]:
        """Of upright planes the sides that they leave out, with a remedy; of others the area."""
        if field.upright is None:
            return field.findings + area_left(region, touched)
        mesh, keep = region.mesh, region.keep
        sides = find_untouched_sides(mesh, keep, touched, field.levels, field.upright, region.interval)
        finer = say("a smaller stepover")
        if options.scallop is not None:
            finer = say("a smaller least interval than {interval}", interval=Length(options.least))
        return side_findings(sides, mesh, keep, field.upright, field.findings, options.least, finer)


def area_left(region: Region, touched: Ints) -> tuple[Finding, ...]:
    """Return a warning where facets to be cut that no pass touches or comes near are more than a little;
    ``touched`` (n,) by one."""
    rows = _without_pass(region, touched)
    lost, whole = float(region.mesh.area[rows].sum()), float(region.mesh.area[region.keep].sum())
    if lost <= SHARE * whole:
        return ()
    largest = rows[region.mesh.area[rows].argmax()]
    x, y, z = region.mesh.vertex[region.mesh.face[largest]].mean(axis=0).tolist()
    text = say(
        "Passes touch none of {count} facets of {area} that are to be cut: they lie along the passes or "
        "between two of them. Choose other passes, or a smaller stepover or scallop, for those.",
        count=len(rows),
        area=Area(lost, ".4g"),
    )
    return (report_finding(Code.SIDE_NOT_MACHINED, text, lost, 0.0, place=(x, y, z)),)


def _without_pass(region: Region, touched: Ints) -> Ints:
    """Facets (k,) to be cut that no pass touches: large ones, and small ones unless they lie beside some that
    are touched."""
    mesh, out, beside = region.mesh, region.keep.copy(), np.zeros(len(region.mesh.vertex), np.bool_)
    out[touched] = False
    rows, there = np.flatnonzero(out), np.unique(touched)
    if not len(rows) or not len(there):
        return rows
    beside[mesh.face[there]] = True
    off = scipy.spatial.cKDTree(mesh.vertex[mesh.face[there]].mean(axis=1)).query(
        mesh.vertex[mesh.face[rows]].mean(axis=1)
    )[0]
    apart = max(region.interval, 2.0 * (region.covered or 0.0))
    side = np.linalg.norm(np.diff(mesh.vertex[mesh.face[rows]][:, [0, 1, 2, 0]], axis=1), axis=2).max(axis=1)
    small = (
        2.0 * mesh.area[rows] < apart * side
    )  # narrower than passes are apart: it lies between two of them
    close = beside[mesh.face[rows]].any(axis=1) | (off < BESIDE * apart)
    return np.asarray(rows[~(small & close)])


def _unit(normal: Vector) -> Floats:
    length = math.hypot(*normal)
    if length < SHORTEST:
        given = ",".join(f"{number:g}" for number in normal)
        raise SettingsError(
            say("plane normal {given} has no direction; give I,J,K across the planes, as 0,0,1", given=given),
            normal,
        )
    return np.array(normal, dtype=np.float64) / length
