# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bores and slots little wider than the tool: the map sees them reached as the path does."""

import math

import numpy as np
import pytest
from test_axis_field import bore_askew, narrow_bore
from test_reach_map import slot

from freecad_fiveaxis.core.gouge.obstacles import Obstacle, Reacher
from freecad_fiveaxis.core.studies import reach_map as module
from freecad_fiveaxis.core.studies import reach_report
from freecad_fiveaxis.core.studies.reach_map import reach_map
from freecad_fiveaxis.core.tool import Cutter


@pytest.mark.parametrize("shape", [narrow_bore, bore_askew, lambda: slot(6.5, 60.0)])
def test_a_bore_or_slot_little_wider_than_the_cutter_is_reached_along_its_walls(shape, monkeypatch):
    """80 deg from the wall the flank meets the other one: the path stands along it, and so does the map."""
    monkeypatch.setattr(module, "FINEST", 1.0)
    mesh = shape()
    found = reach_map(mesh, Reacher(Cutter(6.0, 80.0)))
    free = found.obstacle == Obstacle.NONE
    assert not (found.obstacle == Obstacle.FLANK).any()
    level = free & (found.tilt > math.radians(80.0 + 1e-6))
    assert level.any() and np.isclose(found.tilt[level], 0.5 * math.pi, atol=math.radians(3.1)).all()
    assert abs((found.axis[level] * mesh.normal[found.facet[level]]).sum(axis=1)).max() < 0.06
    assert "reachable, tilted 80 to 90 deg" in reach_report.reach_text(found)
