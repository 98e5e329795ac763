# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is cut from below where nothing is asked: all that the machine reaches, but for a face on which the
part stands."""

import math
from functools import cache

import numpy as np
import pytest
from gouge_examples import prism
from mesh_shapes import box
from plain import build_settings
from test_axis_field import NODES, take_nodes
from underside_parts import PARTS

from freecad_fiveaxis.core.base.errors import ReachError
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.passes import report_standing, standing_facets
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.over_table import largest_axis_angle, report_part_in_table

TRUNNION = load_machine("trunnion_ac")
OPTIONS = {"machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:6", "scallop": 0.2}


@cache
def block():
    return from_triangles(box((0, 0, 0), (30, 20, 10)))


def table_with_one_leg():
    """A plate on a leg under its corner: it would fall over."""
    return prism([(0, 0), (4, 0), (4, 10), (40, 10), (40, 14), (0, 14)])


def mushroom():
    return PARTS["mushroom"](rows=12)


def settings(**options):
    return build_settings("mill", "part", {**OPTIONS, "passes": "scallop", "tool_axis": "auto", **options})


def lean(mesh, machine=TRUNNION, **options):
    return math.degrees(largest_axis_angle(settings(**options), machine, mesh))


def make(wanted, mesh, faces=None):
    """The program, with axes from fewer places of the part than the product looks at: on what it stands does
    not depend on them."""
    with pytest.MonkeyPatch.context() as patch:
        take_nodes(patch, NODES)
        return job.make(wanted, mesh=mesh, faces=faces)


@cache
def make_result(shape, **options):
    """The same, made once for all tests that ask for it."""
    return make(settings(gouge="off", **options), shape())


def test_a_block_stands_on_its_underside_and_on_nothing_else():
    mesh = block()
    standing = standing_facets(mesh)
    assert mesh.area[standing].sum() == pytest.approx(600.0)
    assert (mesh.normal[standing] == [0.0, 0.0, -1.0]).all()
    (one,) = report_standing(mesh, standing)
    assert one.value == pytest.approx(600.0) and "--max-axis-angle" in str(one.text) and one.place[2] == 0.0
    assert "another setup" in str(one.text) and "held off the table" in str(one.text)


@pytest.mark.parametrize("turn", [0.0, 45.0, 180.0])
def test_what_would_fall_over_stands_on_nothing(turn):
    angle = math.radians(turn)
    turned = np.array(
        [[math.cos(angle), -math.sin(angle), 0.0], [math.sin(angle), math.cos(angle), 0.0], [0.0, 0.0, 1.0]]
    )
    for mesh, stands in ((table_with_one_leg(), False), (block(), True)):
        assert standing_facets(from_triangles((mesh.vertex @ turned.T)[mesh.face])).any() == stands


def test_a_part_on_a_point_or_an_edge_stands_on_nothing():
    tip = np.array([[0.0, 0.0, -10.0], [10.0, 0.0, 0.0], [-5.0, 8.0, 0.0], [-5.0, -8.0, 0.0]])
    mesh = from_triangles(tip[[[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]]])
    standing = standing_facets(mesh)
    assert not standing.any() and report_standing(mesh, standing) == ()


def test_axes_lean_as_far_as_the_machine_goes_only_over_a_table_that_is_known():
    mesh = block()
    assert lean(mesh) == pytest.approx(180.0)
    assert lean(mesh, tool_axis="facet_mean") == pytest.approx(90.0)
    assert lean(mesh, origin=(0.0, 0.0, -150.0)) == pytest.approx(
        90.0
    )  # the part lies in the table: who knows where that is
    assert lean(mesh, max_axis_angle=70) == pytest.approx(70.0)
    assert lean(mesh, max_axis_angle=180, tool_axis="facet_mean") == pytest.approx(180.0)


@pytest.mark.thorough
def test_undersides_are_cut_where_nothing_is_requested_and_a_standing_face_where_it_is():
    hanging = make_result(mushroom)
    assert (hanging.axis[:, 2] < -0.05).any()
    level = make_result(mushroom, max_axis_angle=90)
    assert (level.axis[:, 2] > -1e-3).all()

    mesh = block()
    codes = [one.code for one in make_result(block).findings]
    assert codes.count("facets-looking-down") == 1 and "facets-without-free-axis" not in codes
    under = mesh.normal[:, 2] < -0.5
    assert not make_result(block).keep[under].any() and make_result(block).keep[~under].all()
    assert make_result(block, max_axis_angle=180).keep[under].all()
    chosen = make(settings(gouge="off"), mesh, under)
    assert (chosen.keep == under).all()


def test_a_block_that_stands_on_the_table_is_cut_from_above():
    """Its face is 100 mm below the machine's origin: there the tool has no room below level."""
    found = make_result(block, origin=(0.0, 0.0, -100.0))
    assert "retract-below-part" not in [one.code for one in found.findings]
    assert (found.axis[:, 2] > -1e-3).all()


def test_a_part_that_reaches_below_the_table_is_reported_of_where_that_keeps_axes_level():
    mesh, low = block(), {"origin": (0.0, 0.0, -150.0)}
    (one,) = report_part_in_table(settings(**low), TRUNNION, mesh)
    assert "50 mm below the table of trunnion_ac" in str(one.text) and "--origin" in str(one.text)
    assert "part-in-table" in [finding.code for finding in make_result(block, **low).findings]
    for options in ({}, {**low, "max_axis_angle": 90}, {**low, "tool_axis": "facet_mean"}):
        assert report_part_in_table(settings(**options), TRUNNION, mesh) == ()


def test_a_program_built_again_from_what_its_report_says_is_the_same():
    """What was not given is not given then either: a face on which the part stands stays out."""
    given = make_result(block)
    again = job.figures(job.prove(given)).inputs
    again = {name: value for name, value in again.items() if name not in ("task", "source")}
    assert again["max_axis_angle"] is None if "max_axis_angle" in again else True
    assert make(build_settings("mill", "part", again), block()).keep.tolist() == given.keep.tolist()
    assert make_result(block, max_axis_angle=180).keep.tolist() != given.keep.tolist()


@pytest.mark.parametrize("passes", ["scallop", "frames"])
def test_a_sheet_that_looks_down_is_refused_with_a_remedy_and_cut_where_that_is_taken(passes):
    """As a plane face is that was exported with its normals reversed."""
    sheet = from_triangles([[(0, 0, 0), (0, 20, 0), (20, 0, 0)], [(20, 0, 0), (0, 20, 0), (20, 20, 0)]])
    with pytest.raises(ReachError, match=r"stands on all that is to be cut; turn it over.*--max-axis-angle"):
        job.make(settings(passes=passes), mesh=sheet)
    if passes == "scallop":
        assert job.make(settings(max_axis_angle=180), mesh=sheet).keep.all()
