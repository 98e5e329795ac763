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

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, say

from .contact_path import direction
from .field import ALL_ROUND, PassField, PassOptions, Region, Vector
from .sides import find_untouched_sides, side_findings
from .spacing import WIDEST, PlacePlanes, prepare_planes
from .untouched import report_untouched

SHORTEST = 1e-9
"""Length of a normal whose direction is lost in rounding."""


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
            return field.findings + report_untouched(region, touched)
        mesh, keep = region.mesh, region.keep
        sides = find_untouched_sides(mesh, keep, touched, field.levels, field.upright, region.interval)
        finer = say("a smaller stepover")
        if options.scallop is not None:
            finer = say("a smaller least interval than {interval}", interval=Length(options.least))
        return side_findings(sides, mesh, keep, field.upright, field.findings, options.least, finer)


def _unit(normal: Vector) -> Floats:
    length = math.hypot(*normal)
    if length < SHORTEST:
        given = ",".join(f"{number:g}" for number in normal)
        raise SettingsError(
            say("plane normal {given} has no direction; give I,J,K across the planes, as 0,0,1", given=given),
            normal,
        )
    return np.array(normal, dtype=np.float64) / length
