# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a cutter that is no ball bends where it touches each facet: what its passes are spaced by there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints

FEW = 0.02
"""Of the area: where the cutter is narrower on so little, it is not spaced for that."""


@dataclass(frozen=True, eq=False)
class SpacingTool:
    """``radius`` (f,) mm of the ball whose passes may stand as far apart where the tool bends most, ``soft``
    (f,) mm of that along the unit ``way`` (f, 3) in the facet, where it bends least."""

    radius: Floats
    soft: Floats
    way: Floats

    def bends(self, rows: Ints) -> Floats:
        """Return by how much less, 1/mm, the tool bends than a ball of ``radius``, on the facets ``rows``
        (n,): a tensor (6, n), xx, yy, zz, xy, yz, zx."""
        x, y, z = self.way[rows].T
        less = 1.0 / self.soft[rows] - 1.0 / self.radius[rows]
        return np.asarray(less * np.array([x * x, y * y, z * z, x * y, y * z, z * x]))

    def least(self, rows: Ints) -> Floats:
        """Return the share (n,) of ``radius`` in ``soft``: no surface makes passes stand farther apart."""
        return np.asarray(self.radius[rows] / self.soft[rows])

    def narrowest(self, area: Floats) -> float:
        """Return the radius, mm, of the ball whose passes leave the scallop on all facets but FEW of the
        ``area`` (f,) mm2, where passes lie along the soft way."""
        order = np.argsort(self.soft, kind="stable")
        summed = np.cumsum(area[order])
        return float(self.soft[order][np.searchsorted(summed, FEW * summed[-1])])
