# SPDX-License-Identifier: LGPL-2.1-or-later
"""Open surfaces whose normals are turned round: that the other side is machined is said."""

import math

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.passes import report_far_side
from freecad_fiveaxis.core.pipeline import job

DOWN = "surface-looks-down"


def tile(slope=0.2, width=12.0):
    """Corners (8, 3, 3) of an open ridge of four strips that looks up."""
    x = np.linspace(-0.5, 0.5, 5) * width
    z = -slope * np.abs(x)
    low, high = np.stack([x, 0.0 * x - 4.0, z], axis=1), np.stack([x, 0.0 * x + 4.0, z], axis=1)
    first = np.stack([low[:-1], low[1:], high[1:]], axis=1)
    return np.concatenate([first, np.stack([low[:-1], high[1:], high[:-1]], axis=1)])


def codes(mesh, **options):
    given = {
        "machine": "trunnion_ac",
        "cutter": "ball:2",
        "scallop": 0.1,
        "max_axis_angle": 180.0,
        "linearize": "off",
        "gouge": "off",
    }
    return [
        one.code for one in job.make(build_settings("mill", "tile.stl", given | options), mesh=mesh).findings
    ]


@pytest.mark.parametrize("slope", [0.0, 0.2])
def test_a_surface_that_looks_down_is_named_with_its_area_and_what_to_do(slope):
    mesh = from_triangles(tile(slope)[:, ::-1])
    (found,) = report_far_side(mesh)
    assert found.code == DOWN and found.value == pytest.approx(12.0 * 8.0 * math.hypot(1.0, slope))
    assert "100 %" in found.text and "turn its normals round" in found.text
    assert abs(found.place[1]) < 4.0 and found.place[2] <= 0.0


def test_the_same_surface_looking_up_a_closed_part_and_one_that_looks_both_ways_are_not():
    both = np.concatenate([tile()[:, ::-1], tile()[:1] + [0.0, 20.0, 0.0]])
    for corners in (tile(), both, box((0, 0, 0), (3, 2, 1)), box((0, 0, 0), (3, 2, 1))[:, ::-1]):
        assert not report_far_side(from_triangles(corners))


def test_a_program_of_it_says_so():
    steep = tile(slope=2.5)  # the table of a trunnion leans no further than 120 deg
    assert DOWN in codes(from_triangles(steep[:, ::-1]))
    assert DOWN not in codes(from_triangles(steep))
