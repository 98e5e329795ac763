# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tool whose axes are chosen freely stays above what a part stands on wherever it can cut from there, and
finishes as much as without that."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from mesh_shapes import box
from revolved import solid_of_revolution

from freecad_fiveaxis.core.base.progress import silent
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.gouge.obstacles import Reacher, find_lower, tip_at
from freecad_fiveaxis.core.orientation import axis_field, find_frames
from freecad_fiveaxis.core.orientation.auto_axis import Free, auto_axes, refine_field
from freecad_fiveaxis.core.orientation.facets_with_axis import find_axis_field
from freecad_fiveaxis.core.orientation.strategies import AxisOptions, facet_mean
from freecad_fiveaxis.core.passes import slice_mesh, standing_facets
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.above_floors import find_floors
from freecad_fiveaxis.core.pipeline.mill_context import begin_context, find_area, find_standing
from freecad_fiveaxis.core.pipeline.options import machine_of
from freecad_fiveaxis.core.pipeline.preview import preview_passes
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.coedge import close_gaps

BLOCK = from_triangles(box((0, 0, 0), (30, 20, 10)))
KNOB = solid_of_revolution([(0, 14), (16, 14), (16, 4), (9, 4), (9, 0), (0, 0)], 16)
OPTIONS = {"machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:6", "stepover": 1.5}
OPTIONS |= {"tool_axis": "auto", "rest": "off", "gouge": "report"}
HOLDER = {"shank": "6x20", "holder": "40x30"}
BALL = Reacher(Cutter(6.0, 30.0), ((6.0, 20.0),), ((40.0, 30.0),))
LOW = (-3.0, -6.0)


def make(mesh, faces=None, **more):
    return job.make(build_settings("mill", "part", OPTIONS | more), mesh=mesh, faces=faces)


def measure_dip(draft):
    return max((one.value for one in draft.findings if one.code == "dip-below-part"), default=0.0)


def floors_of(mesh, faces=None, fixtures=(), **more):
    settings = build_settings("mill", "part", OPTIONS | more)
    machine, kinematics, dialect = machine_of(settings)
    area = find_area(settings, mesh, faces, None)
    context = begin_context(settings, mesh, machine, kinematics, dialect, silent, area, fixtures)
    return find_floors(context, find_standing(settings, mesh, faces))


@pytest.mark.parametrize("cutter", ["ball:6", "bull:6:1", "flat:6"])
def test_beside_the_walls_of_a_block_the_holder_stays_above_what_it_stands_on(cutter):
    """Level, as without a floor, the holder of 40 mm reaches 17 mm below it and more."""
    draft = make(BLOCK, cutter=cutter, **HOLDER)
    assert 0.0 < measure_dip(draft) < 3.05
    assert not {"no-free-axis", "facets-without-free-axis"} & {one.code for one in draft.findings}
    assert draft.keep[~standing_facets(BLOCK)].all()


def test_under_a_knob_the_tool_looks_down_only_as_far_as_it_must():
    """28 mm deep without a floor: the ball gets under the head from the side as well."""
    draft = make(KNOB)
    assert 0.0 < measure_dip(draft) < 3.05
    assert draft.keep.tolist() == make(KNOB, ~standing_facets(KNOB)).keep.tolist()


def test_where_nothing_else_is_free_the_tool_goes_lower_and_as_much_is_cut():
    """With a holder under the head of the knob."""
    draft, level = make(KNOB, **HOLDER), make(KNOB, **HOLDER, max_axis_angle=90)
    assert measure_dip(draft) > 3.05
    keep = make(KNOB, ~standing_facets(KNOB), **HOLDER).keep
    assert draft.keep.tolist() == keep.tolist()
    assert KNOB.area[keep].sum() > KNOB.area[level.keep & ~standing_facets(KNOB)].sum()


def test_floors_are_a_radius_and_two_below_what_the_part_stands_on():
    assert floors_of(BLOCK) == LOW
    raised = from_triangles(BLOCK.vertex[BLOCK.face] + (0.0, 0.0, 5.0))
    assert floors_of(raised, cutter="bull:4:1") == (3.0, 1.0)


def test_there_is_no_floor_below_the_table():
    """The face of the table is 4 mm below the part, then right under it, then above its underside."""
    assert floors_of(BLOCK, origin=(0.0, 0.0, -96.0)) == (-3.0,)
    assert floors_of(BLOCK, origin=(0.0, 0.0, -100.0)) == ()
    assert floors_of(BLOCK, origin=(0.0, 0.0, -150.0)) == ()


def test_there_is_no_floor_where_the_part_stands_on_nothing_or_angle_faces_or_a_fixture_are_given():
    turned = BLOCK.vertex[BLOCK.face] @ np.array([(0.8, 0, 0.6), (0, 1, 0), (-0.6, 0, 0.8)])
    assert floors_of(from_triangles(turned)) == ()
    assert floors_of(BLOCK, max_axis_angle=90) == ()
    assert floors_of(BLOCK, ~standing_facets(BLOCK)) == ()
    below, beside = box((8, 6, -20), (22, 14, 0)), box((40, 6, -20), (50, 14, 0))
    assert floors_of(BLOCK, fixtures=(Fixture("rest", from_triangles(below)),)) == ()
    assert floors_of(BLOCK, fixtures=(Fixture("rest", from_triangles(beside)),)) == LOW


def test_an_angle_or_faces_that_are_given_leave_the_axes_as_they_were():
    for more in ({"faces": ~standing_facets(BLOCK)}, {"max_axis_angle": 90}):
        assert measure_dip(make(BLOCK, **HOLDER, **more)) > 17.0


def test_a_node_has_lower_axes_only_where_none_above_the_floor_is_free():
    """And none loses all its axes."""
    reacher, tree = replace(BALL, floors=LOW), facet_tree(KNOB)
    facets = ~standing_facets(KNOB)
    nodes = axis_field.surface_nodes(KNOB, facets, reacher, tree, 200)
    direction = np.concatenate([axis_field.main_directions(KNOB), axis_field.even_directions(300)])
    any_, above = (axis_field.find_freedom(nodes, one, tree, direction) for one in (BALL, reacher))
    assert above.some.tolist() == any_.some.tolist() and not (above.free & ~any_.free).any()
    node, way = np.nonzero(any_.free)
    low = reach_down(nodes.stand[node], nodes.normal[node], direction[way]) < LOW[0] - 0.01
    low |= direction[way][:, 2] < -1e-9  # on its way out
    high = np.zeros(len(nodes.point), np.bool_)
    np.logical_or.at(high, node[~low], True)
    assert high.any() and not high.all()
    assert not (above.free[node, way] & low & high[node]).any()
    assert (above.free[node, way] >= (~low & high[node])).all(), "what stays above is free as before"


def reach_down(point, normal, axis):
    """The height of the lowest point of that tool by its rims: a ball, a shank and a holder."""
    tip, across = tip_at(BALL.cutter, point, normal, axis)[:, 2], np.sqrt(1.0 - axis[:, 2] ** 2)
    rims = [tip + up * axis[:, 2] - radius * across for up, radius in ((50.0, 20.0), (80.0, 20.0))]
    return np.minimum(tip + 3.0 * axis[:, 2] - 3.0, np.minimum(*rims))


@pytest.mark.parametrize("lean", [0.0, 0.3])
def test_contacts_stay_above_the_floor_and_lose_no_axis(lean):
    facets = ~standing_facets(BLOCK)
    offset = close_gaps(slice_mesh(BLOCK, np.linspace(1.0, 19.0, 5), 0.0, facets), BLOCK, 3.0, 0.05)
    options = AxisOptions(lead=lean)
    given = facet_mean(offset, AxisOptions())
    lowest = []
    for reacher in (BALL, replace(BALL, floors=LOW)):
        field = refine_field(find_axis_field(BLOCK, facets, reacher), offset, BLOCK, reacher)
        axis, free, _ = auto_axes(offset, given, field, BLOCK, reacher, options)
        assert (free == Free.WAY_OUT).all()
        lowest.append(reach_down(offset.centre - 3.0 * offset.normal, offset.normal, axis).min())
    assert lowest[0] < -15.0 and lowest[1] > -3.02


def test_the_way_from_an_axis_to_a_lower_one_is_seen():
    level, up = np.array([[1.0, 0.0, 0.0]] * 2), np.array([[0.6, 0.0, 0.8]] * 2)
    point, normal = np.array([[30.0, 10.0, 1.0], [30.0, 10.0, 60.0]]), level
    reacher = replace(BALL, floors=LOW)
    assert find_lower(reacher, point, normal, level, up).tolist() == [True, False]
    assert not find_lower(reacher, point, normal, level, level).any()
    assert not find_lower(reacher, point, normal, up, level).any()
    assert not find_lower(BALL, point, normal, level, up).any()


@pytest.mark.parametrize(("lost", "above"), [(0, True), (3, False)])
def test_frames_above_a_floor_are_taken_only_where_they_see_as_much(monkeypatch, lost, above):
    def find(mesh, facets, reacher, *rest):
        frame = np.zeros(1000, np.int64)
        frame[: lost if reacher.floors else 0] = -1
        return SimpleNamespace(frame=frame, floors=reacher.floors), facets, ()

    monkeypatch.setattr(find_frames, "_find_frames", find)
    facets = ~standing_facets(BLOCK)
    frames, _, _ = find_frames.find_frames(BLOCK, facets, replace(BALL, floors=LOW), np.pi)
    assert (frames.floors == LOW) == above


def test_the_preview_of_frames_shows_those_of_the_program():
    """Those above the floor are more."""
    wanted = build_settings("mill", "part", OPTIONS | {"passes": "frames"})
    shown, draft = preview_passes(wanted, mesh=KNOB), make(KNOB, passes="frames")
    (one,), (other,) = (
        [a for a in found if a.code == "frames"] for found in (shown.findings, draft.findings)
    )
    assert str(one.text) == str(other.text)
    given = make(KNOB, ~standing_facets(KNOB), passes="frames").findings
    assert str(one.text) not in [str(a.text) for a in given]
