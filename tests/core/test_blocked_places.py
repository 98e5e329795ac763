# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is in the way where no tool axis is free: table, fixture or the part, by closed forms on a block."""

import math
from dataclasses import replace

import numpy as np
import pytest
from mesh_shapes import box

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge.fixtures import Fixture, join_obstacles
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.orientation.axis_field import even_directions
from freecad_fiveaxis.core.orientation.blocked_places import (
    FREE,
    PART,
    Blocker,
    choose_places,
    find_blockers,
)
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report import summary, verdict
from freecad_fiveaxis.core.tool import parse_cutter

SIZE = np.array([24.0, 16.0, 12.0])
ROUND = 2.0 * (SIZE[0] + SIZE[1])
RADIUS, SCALLOP = 3.0, 0.1
GIVEN = {
    "machine": "trunnion_ac",
    "cutter": "ball:6",
    "scallop": SCALLOP,
    "spindle": "off",
    "rest": "on",
}
ON_TABLE = {"origin": (0.0, 0.0, -100.0)}
"""The table of that machine is 100 mm below its zero."""


def block():
    return from_triangles(box((-SIZE[0] / 2, -SIZE[1] / 2, 0.0), (SIZE[0] / 2, SIZE[1] / 2, SIZE[2])))


def jaw(gap, name="jaw"):
    """A jaw as high as the block, ``gap`` mm beside its wall at -Y."""
    low = (-SIZE[0], -SIZE[1] / 2 - gap - 10.0, 0.0)
    return Fixture(name, from_triangles(box(low, (SIZE[0], -SIZE[1] / 2 - gap, SIZE[2]))))


def make_result(fixtures=(), **more):
    draft = job.make(build_settings("mill", "part", {**GIVEN, **more}), mesh=block(), fixtures=fixtures)
    return job.figures(job.prove(draft))


def found_in(figures, code):
    return [one for one in figures.findings if one.code == code]


def test_a_place_is_blocked_by_what_frees_it_when_it_is_taken_away():
    """On the wall at -Y a ball of radius 3 touches at 2 mm only below the table's face; a jaw 0.5 mm beside
    it keeps it off at 8 mm, and nothing at all on the wall at +Y."""
    part, fixture = block(), jaw(0.5)
    joined, reacher = join_obstacles(part, [fixture]), Reacher(parse_cutter("ball:6"), table=0.0)
    blockers = [Blocker("", joined, replace(reacher, table=None)), Blocker("jaw", part, reacher)]
    point = np.array([(0.0, 8.0, 2.0), (0.0, 8.0, 8.0), (0.0, -8.0, 8.0), (0.0, -8.0, 2.0)])
    normal = np.array([(0.0, 1.0, 0.0), (0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (0.0, -1.0, 0.0)])
    found = find_blockers(point, normal, joined, reacher, even_directions(), blockers)
    assert found.tolist() == [0, FREE, 1, PART]  # the last for both, and for neither alone


def test_places_are_chosen_evenly_by_weight():
    assert choose_places(np.ones(5), 5).tolist() == [0, 1, 2, 3, 4]
    weight = np.where(np.arange(1000) < 500, 3.0, 1.0)
    chosen = choose_places(weight, 100)
    assert len(chosen) <= 100 and np.mean(chosen < 500) == pytest.approx(0.75, abs=0.03)


def test_what_the_table_keeps_the_tool_off_is_out_of_reach_and_named():
    """A ball never comes lower than its radius at the middle: of the walls up to there stays what it leaves
    from there, and no more than all."""
    figures = make_result(**ON_TABLE)
    (lost,) = found_in(figures, Code.UNCUT_AT_TABLE)
    above = 2.0 * SCALLOP + 0.01
    strip = RADIUS - math.sqrt((RADIUS + above) ** 2 - RADIUS**2)
    assert ROUND * strip * 0.97 < lost.value < ROUND * RADIUS
    numbers = summary(figures)
    parts = numbers["unfinished_parts"]
    assert parts["out_of_reach"] > 0.9 * numbers["unfinished_share"] > 0.0
    assert "(the table is in the way)" in verdict(figures, numbers).text
    (held,) = found_in(figures, Code.NO_FREE_AXIS)
    assert "In the way is the table at 100 % of them. Clamp the part higher" in held.text
    assert "smaller cutter" not in held.text


@pytest.mark.thorough
def test_a_fixture_in_the_way_is_named_and_one_that_is_far_off_is_not():
    """The wall beside the jaw is left out as a whole, and of the walls at its ends stays what is near it."""
    figures = make_result((jaw(0.5, "left.stl"), jaw(200.0, "far.stl")))
    (wall,) = found_in(figures, Code.FACETS_WITHOUT_FREE_AXIS)
    assert (
        wall.value == pytest.approx(SIZE[0] * SIZE[2]) and "the fixture left.stl is in the way" in wall.text
    )
    (lost,) = found_in(figures, Code.UNCUT_AT_FIXTURE)
    assert 0.0 < lost.value < 2.0 * 2.0 * RADIUS * SIZE[2] and "fixture left.stl" in lost.text
    numbers = summary(figures)
    assert "a fixture is in the way)" in verdict(figures, numbers).text
    assert numbers["unfinished_parts"]["missed"] < 0.05 * numbers["unfinished_share"]
    free = make_result((jaw(200.0),))
    assert not found_in(free, Code.UNCUT_AT_FIXTURE) and not found_in(free, Code.UNCUT_AT_TABLE)
    assert not found_in(free, Code.FACETS_WITHOUT_FREE_AXIS) and not found_in(free, Code.NO_FREE_AXIS)
