# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lollipop leaves a place under a part of the part across its axis; proven by dense samples, and by a whole
program."""

import json

import numpy as np
import pytest
from gouge_examples import dense_points, prism, sampled_depth, shelf

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import write_stl
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.gouge.swept_motion import straight_motion
from freecad_fiveaxis.core.orientation.sideways import find_retreats
from freecad_fiveaxis.core.tool import Cutter, parse_cutter
from freecad_fiveaxis.core.tool.body import body_of

UP = np.array([[0.0, 0.0, 1.0]])
LOLLIPOP = parse_cutter("lollipop:10:4:40")


def t_slot():
    """A T slot along x, 16 mm wide and 12 high under lips of 4 mm, 6 mm wide at its mouth."""
    outside = [(-20, 16), (-20, -5), (20, -5), (20, 16)]
    return prism([*outside, (3, 16), (3, 12), (8, 12), (8, 0), (-8, 0), (-8, 12), (-3, 12), (-3, 16)])


def entering(cutter, mesh, tip, axis, way, length):
    """How deep, by dense samples, the tool enters on that straight way."""
    swept = straight_motion(np.stack([tip, tip + length * way]), np.stack([axis, axis]))
    return sampled_depth(body_of(cutter), dense_points(mesh, 1.0), swept, 0, 121)


def test_from_under_a_roof_it_goes_away_from_the_wall():
    mesh, tip = shelf(), np.array([[0.0, -3.0, 0.0], [0.0, -20.0, 0.0]])
    way, found = find_retreats(Reacher(LOLLIPOP), facet_tree(mesh), tip, np.repeat(UP, 2, axis=0))
    assert found.all() and way[1].tolist() == [0.0, 0.0, 1.0], "in the open it goes up, as all tools"
    assert abs(way[0, 2]) < 1e-12 and way[0, 1] < 0.1 and np.linalg.norm(way[0]) == pytest.approx(1.0)
    assert entering(LOLLIPOP, mesh, tip[0], UP[0], way[0], 60.0) < 0.02
    assert entering(LOLLIPOP, mesh, tip[0], UP[0], UP[0], 60.0) > 1.0, "a way through the roof is seen"
    assert entering(LOLLIPOP, mesh, tip[0], UP[0], np.array([0.0, 1.0, 0.0]), 60.0) > 1.0, (
        "and one through the wall"
    )


def test_in_a_t_slot_it_goes_along_the_slot_by_the_shorter_way():
    mesh, tip = t_slot(), np.array([[6.0, 0.0, 0.0], [-9.0, 0.5, 0.0]])
    way, found = find_retreats(Reacher(LOLLIPOP), facet_tree(mesh), tip, np.repeat(UP, 2, axis=0))
    assert found.all()
    np.testing.assert_allclose(way, [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]], atol=1e-12)


def test_a_tool_that_looks_down_does_not_leave_through_the_table():
    """It looks 10 deg below level, 15 mm above the table: along its axis it would go through that."""
    tip, lean = np.array([[0.0, -30.0, 5.0]]), np.radians(10.0)
    axis = np.array([[0.0, -np.cos(lean), -np.sin(lean)]])
    free, _ = find_retreats(Reacher(LOLLIPOP), facet_tree(shelf()), tip, axis)
    way, found = find_retreats(Reacher(LOLLIPOP, table=-10.0), facet_tree(shelf()), tip, axis)
    assert free.tolist() == axis.tolist() and found.all()
    assert abs(way[0] @ axis[0]) < 1e-12 and way[0, 2] > -1e-6


def test_a_ball_end_mill_is_not_let_out_there():
    tip = np.array([[0.0, -3.0, 0.0]])
    way, found = find_retreats(Reacher(Cutter(10.0, 40.0)), facet_tree(shelf()), tip, UP)
    assert not found.any() and way.tolist() == UP.tolist()


@pytest.mark.oldest
@pytest.mark.thorough
def test_a_program_gets_under_a_roof_from_the_side_and_stays_out_of_the_part(tmp_path):
    """The axis within 30 deg of upright: the lollipop leaves a smaller share unfinished than the ball, and
    both are proven gouge-free."""
    write_stl(shelf(), tmp_path / "part.stl")
    share = {}
    for cutter in ("ball:8", "lollipop:8:3"):
        report = tmp_path / "x.json"
        code = cli.main([
            "mill", str(tmp_path / "part.stl"), "--machine", "trunnion_ac", "--cutter", cutter, "--scallop", "0.3", "--spindle", "off",
            "--max-axis-angle", "30deg", "-o", str(tmp_path / "x.ngc"), "--report", str(report),
        ])  # fmt: skip
        record = json.loads(report.read_text(encoding="utf-8"))
        assert code in (0, 1) and not [one for one in record["findings"] if one["severity"] == "error"]
        share[cutter] = record["summary"]["unfinished_share"]
    assert share["lollipop:8:3"] < share["ball:8"] - 0.01, share
