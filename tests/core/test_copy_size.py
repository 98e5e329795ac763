# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many facets carry the field of a part of slivers, and that passes over fewer of them leave what was asked."""

from unittest.mock import patch

import numpy as np
import pytest

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.passes import PassOptions, Region, scallop_passes

RADIUS, HEIGHT, STEP = 12.0, 60.0, 0.5


def tube(sides):
    """The mantle of a prism of so many sides: slivers as long as it is high."""
    turn = 2.0 * np.pi * np.arange(sides) / sides
    low = np.stack([RADIUS * np.cos(turn), RADIUS * np.sin(turn), 0.0 * turn], axis=1)
    high, beside = low + [0.0, 0.0, HEIGHT], np.roll(low, -1, axis=0)
    over = beside + [0.0, 0.0, HEIGHT]
    return from_triangles(np.concatenate([np.stack([low, beside, over], 1), np.stack([low, over, high], 1)]))


def region(mesh):
    return Region(mesh, np.ones(len(mesh.face), np.bool_), 3.0, STEP)


def surface(mesh):
    given = region(mesh)
    return scallop_passes.make_surface(given, scallop_passes.survey_region(given, PassOptions(stepover=STEP)))


@pytest.mark.parametrize(("sides", "most"), [(60, 4000), (400, 4000), (1000, 6000)])
def test_slivers_make_no_more_facets_than_about_so_many(sides, most):
    mesh = tube(sides)
    with patch.object(scallop_passes, "MOST_FACETS", most):
        count = len(surface(mesh).copy.mesh.face)
    assert 0.5 * most <= count <= 2.5 * (most + len(mesh.face)), count


def test_sides_stay_as_short_as_ever_where_there_are_few():
    copy = surface(tube(60)).copy.mesh
    side = np.linalg.norm(copy.vertex[np.roll(copy.face, -1, axis=1)] - copy.vertex[copy.face], axis=2)
    assert len(copy.face) > 40_000, "of slivers that take so many"
    assert side.max() <= scallop_passes.LONGEST * STEP + 1e-9


def test_steps_over_long_slivers_are_as_far_apart_as_requested():
    """On a mantle the distance from both rims is known: Z, or the height less Z."""
    with patch.object(scallop_passes, "MOST_FACETS", 4000):
        result = surface(tube(400))
    steps = scallop_passes.lay_steps(result, None) * STEP
    z = result.copy.mesh.vertex[:, 2]
    assert np.abs(steps - np.minimum(z, HEIGHT - z)).max() < 0.1 * STEP
