# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lead-ins: arcs in closed form, counts of ends, and by another library's distances none of them leads the
tool into the part."""

import itertools
import subprocess
import sys

import gouge_judge
import numpy as np
import pytest
from gouge_examples import blade_beside_hub, knob_in_corner, prism, step
from plain import build_settings
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import write_stl
from freecad_fiveaxis.core.links import lead_in as module
from freecad_fiveaxis.core.links.lead_in import LeadOptions, find_ends, lead_in
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.report.figures import summary
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import body_of
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

OPTIONS = {
    "machine": "trunnion_ac",
    "tool_length": 120,
    "cutter": "ball:8:40",
    "stepover": 4.0,
    "max_axis_angle": 60,
}
PLATE = {"tool_axis": "fixed", "axis": "0.2,0.1,1", "direction": "30", "links": "over", "linearize": "off"}
R, UP = 4.0, np.array([0.0, 0.0, 1.0])


def plate():
    return prism([(-20, -10), (20, -10), (20, 0), (-20, 0)])


def milled(mesh, **options):
    return job.make(build_settings("mill", "part", {**OPTIONS, **options}), mesh=mesh)


def note(result):
    return [one for one in result.findings if one.code == "lead-in-smaller"]


def contacts(path):
    """The rows on the part that the tool comes to, and those that it leaves, told by what stands on a
    facet."""
    on = path.face >= 0
    return np.flatnonzero(on[1:] & ~on[:-1]) + 1, np.flatnonzero(on[:-1] & ~on[1:])


def runs_to(path, row, way, count):
    """Tips of the ``count`` rows before (way -1) or after (1) the row, nearest first."""
    return path.tip[row + way * np.arange(1, count + 1)]


@pytest.mark.parametrize("control_point", ["tip", "centre"])
@pytest.mark.parametrize("cutter", ["ball:8:40", "bull:10:2:40"])
def test_on_a_plate_the_arcs_are_quarter_circles_tangent_to_it(cutter, control_point):
    result = milled(plate(), **PLATE, cutter=cutter, control_point=control_point, lead_in=R)
    path, tolerance = result.path, result.settings.proof.tolerance
    chords = int(np.ceil(0.25 * np.pi / np.arccos(1.0 - tolerance / R)))
    assert chords > 5 and not note(result)
    first, last = contacts(path)
    assert len(first) == len(last) > 5
    for rows, way in ((first, -1), (last, 1)):
        for row in rows:
            away = path.tip[row] - path.tip[row - way]
            away /= np.linalg.norm(away)
            arc = np.vstack([path.tip[row], runs_to(path, row, way, chords)])
            middle = path.tip[row] + R * UP
            assert np.linalg.norm(arc - middle, axis=1) == pytest.approx(R, abs=1e-9)
            assert np.allclose((arc - middle) @ np.cross(away, UP), 0.0, atol=1e-9)
            assert np.allclose(arc[-1] - path.tip[row], R * (away + UP), atol=1e-9)
            halfway = np.linalg.norm(0.5 * (arc[1:] + arc[:-1]) - middle, axis=1)
            assert (R - halfway).max() <= tolerance * (1 + 1e-9) and (arc[:, 2] >= arc[0, 2]).all()
            turn = np.arccos((arc[1] - arc[0]) @ away / np.linalg.norm(arc[1] - arc[0]))
            assert turn == pytest.approx(
                0.25 * np.pi / chords, abs=1e-9
            )  # half of a chord's angle: tangent at the contact
            assert np.ptp(path.axis[row + way * np.arange(chords + 2)], axis=0).max() == 0.0


def test_the_approach_is_along_the_axis_and_all_rows_of_arcs_are_links():
    path, bare = (milled(plate(), **PLATE, lead_in=value).path for value in (R, 0.0))
    first, last = contacts(path)
    chords = (len(path.tip) - len(bare.tip)) // (len(first) + len(last)) - 1
    for rows, way in ((first, -1), (last, 1)):
        top, over, outer = (rows + way * k for k in (chords, chords + 1, chords + 2))
        rise = path.tip[over] - path.tip[top]
        assert (
            np.allclose(np.cross(rise, path.axis[rows]), 0.0, atol=1e-9)
            and ((rise * path.axis[rows]).sum(1) > 0).all()
        )
        assert np.allclose(((path.tip[outer] - path.tip[over]) * path.axis[rows]).sum(1), 0.0, atol=1e-9)
    new = path.motion == Motion.LINK
    assert (path.feed[new] > 0).all() and np.count_nonzero(new) == np.count_nonzero(
        bare.motion == Motion.LINK
    ) + (chords + 1) * (len(first) + len(last))
    assert set(path.feed[first]) == {1000.0} and set(path.feed[first - chords]) == {300.0}
    for name in ("tip", "axis", "contact", "normal", "face", "pass_"):
        kept = [
            getattr(one, name)[np.isin(one.motion, (Motion.CUT, Motion.FILL, Motion.RAPID))]
            for one in (path, bare)
        ]
        assert np.array_equal(*kept), name


def test_what_is_cut_and_what_is_left_stay_as_they_were():
    result = [milled(plate(), **PLATE, rest="on", lead_in=value) for value in (0.0, R)]
    figures = [job.figures(job.prove(one)) for one in result]
    numbers = [summary(one) for one in figures]
    assert numbers[1]["cut_length"] == pytest.approx(numbers[0]["cut_length"], rel=1e-9)
    assert numbers[1]["link_length"] > numbers[0]["link_length"]
    assert np.allclose(figures[0].rest.height, figures[1].rest.height, atol=1e-9)


def test_none_is_the_default_and_changes_no_byte():
    given, bare = (milled(step(), **({"lead_in": "0 mm"} if zero else {})) for zero in (True, False))
    assert given.nc == bare.nc
    assert milled(step(), lead_in=1).nc != bare.nc


# ----------------------------------------------------------------------------------------------- beside walls

WALLED = {
    "knob": lambda: knob_in_corner(cells=16),
    "blade": lambda: blade_beside_hub(cells=16),
    "step": lambda: step(6.0),
}


def deepest(result):
    """How deep the cutter goes on any feed block, mm, by the judge."""
    blocks = np.flatnonzero(result.program.motion[1:] != Motion.RAPID)
    return gouge_judge.judged(
        result.mesh, result.settings.cutter.cutter, result.kinematics, result.program.words, blocks
    ).worst


@pytest.mark.thorough
@some_in_core("part, links", [*itertools.product(WALLED, ["near", "over"])], kept=(1, 2, 4, 5))
def test_the_judge_finds_nothing_beside_walls(part, links):
    result = milled(WALLED[part](), lead_in=R, links=links, stepover=2.0)
    assert deepest(result) <= result.settings.proof.tolerance
    codes = {finding.code for finding in job.prove(result).findings}
    assert not codes & {"overcut", "rapid-collision", "holder-collision"}


def test_the_judge_would_see_an_arc_that_is_not_free(monkeypatch):
    monkeypatch.setattr(module, "_free", lambda path, ends, *rest: np.ones(len(ends.row), bool))
    assert deepest(milled(knob_in_corner(cells=16), lead_in=R, stepover=2.0, linearize="off")) > 0.1


# ------------------------------------------------------------------------- by hand: counts, table, near links

CUTTER = Cutter(8.0, length=40.0)
FLOOR = [(-30, -10), (30, -10), (30, 30), (0, 30), (0, 0), (-30, 0)]
"""y and z: a floor at z = 0 up to a wall at y = 0."""


def by_hand(*pieces, height=50.0, between=Motion.RAPID, axis=UP, normal=UP):
    """A path over pieces (2, 3) mm each: down to each, along it, up."""
    tip, motion = [], []
    for piece in pieces:
        up = height * np.asarray(axis)
        tip += [piece[0] + up, piece[0], piece[1], piece[1] + up]
        motion += [between if tip[4:] else Motion.RAPID, Motion.LINK, Motion.CUT, Motion.LINK]
    tip, on = np.array(tip, float), np.tile([False, True, True, False], len(pieces))
    n, none = len(tip), np.where(on, 0, -1)
    feed = np.where(np.array(motion) == Motion.RAPID, 0.0, 1000.0)
    rows = np.where(on[:, None], normal, axis)
    return CLPath(tip, np.tile(axis, (n, 1)), np.array(motion, np.int8), feed, tip, rows, none, none, none)


def floor_line(y, x=(-10.0, 10.0)):
    """Away from the wall, or along it."""
    return np.array([[x[0], y, 0.0], [x[1], y, 0.0]])


def correct_axes(path, radius=R, mesh=None, table=None, tolerance=0.01):
    body = body_of(CUTTER)
    return lead_in(
        path, facet_tree(mesh or prism(FLOOR)), body, LeadOptions(radius, tolerance, 0.005, table, 0.0, 4.0)
    )


@pytest.mark.parametrize(("room", "radius"), [(4.5, 4.0), (3.0, 2.0), (1.5, 1.0), (0.5, 0.0)])
def test_towards_a_wall_the_radius_is_halved_up_to_two_times_and_counted(room, radius):
    """A pass that ends with ``room`` mm between the ball and the wall, and begins far from it."""
    path = by_hand(np.array([[0.0, -20.0, 0.0], [0.0, -4.0 - room, 0.0]]))
    result = correct_axes(path)
    first, last = contacts(result)
    assert np.abs(result.tip[: first[0], 1] - result.tip[first[0], 1]).max() == pytest.approx(R)
    assert np.abs(result.tip[last[0] + 1 :, 1] - result.tip[last[0], 1]).max() == pytest.approx(
        radius, abs=1e-9
    )
    reported = [(one.code, one.value) for one in result.findings]
    assert reported == ([] if radius == R else [("lead-in-smaller", 1.0)])
    assert not reported or result.findings[0].text.startswith(
        "1 of 2 ends of passes has a smaller lead-in or lead-out than 4 mm"
    )


def test_a_path_without_a_single_free_end_stays_as_it_is_but_for_the_note():
    path = by_hand(
        np.array([[0.0, -4.1, 0.0], [0.0, -4.2, 0.0]])[::-1], np.array([[0.0, -4.2, 0.0], [0.0, -4.1, 0.0]])
    )
    walls = prism([(-9, -10), (9, -10), (9, 30), (0, 30), (0, 0), (-8.3, 0), (-8.3, 30), (-9, 30)])
    result = correct_axes(path, mesh=walls)
    assert np.array_equal(result.tip, path.tip) and [one.value for one in result.findings] == [4.0]


def test_below_the_table_no_arc_goes():
    """Up a wall that faces -y, with a level axis: the arc begins below the contact."""
    level = np.array([0.0, -1.0, 0.0])
    path = by_hand(np.array([[0.0, 0.0, 6.0], [0.0, 0.0, 20.0]]), axis=level, normal=level)
    free, held = (
        correct_axes(path, mesh=prism([(0, -10), (20, -10), (20, 30), (0, 30)]), table=table)
        for table in (-2.5, 1.0)
    )
    assert free.tip[:, 2].min() == pytest.approx(2.0) and not free.findings
    assert held.tip[:, 2].min() == pytest.approx(5.0) and [one.value for one in held.findings] == [1.0]


@pytest.mark.parametrize("height", [10.0, 1.0])
def test_a_raised_near_link_goes_from_arc_to_arc(height):
    path = by_hand(floor_line(-12.0), floor_line(-20.0, (10.0, -10.0)), height=height, between=Motion.LINK)
    result = correct_axes(path)
    assert len(find_ends(path).row) == 4 and not result.findings
    first, last = contacts(result)
    between = result.tip[last[0] + 1 : first[1]]
    assert between[:, 2].max() == pytest.approx(max(height, R))
    top = between[np.isclose(between[:, 2], max(height, R))]
    assert np.allclose(top[:, 0], 10.0 + R) and np.allclose(np.unique(top[:, 1]), [-20.0, -12.0])


def test_links_on_the_surface_have_no_arcs():
    path = by_hand(floor_line(-12.0), floor_line(-14.0, (10.0, -10.0)))
    keep = np.array([0, 1, 2, 5, 6, 7])  # straight from end to start
    columns = {name: getattr(path, name)[keep] for name in path.__dataclass_fields__ if name != "findings"}
    ends = find_ends(CLPath(**columns))
    assert sorted(ends.row) == [1, 4]
    assert sorted(ends.outer) == [0, 5] and np.allclose(ends.along, [[-1, 0, 0]] * 2)


# ---------------------------------------------------------------------------------------------- what is given


@pytest.mark.parametrize("given", ["-1", "nan", "inf", "100.1", "much"])
def test_a_radius_that_is_none_is_refused(given):
    with pytest.raises(SettingsError, match="lead-in"):
        build_settings("mill", "part.stl", {**OPTIONS, "lead_in": given})


@pytest.mark.parametrize(
    ("task", "given", "message"),
    [("mill", "101", "at most 100 mm"), ("mill", "-1", "at least 0 mm"), ("post", "1", "lead-in")],
)
def test_the_command_line_refuses_it_in_one_line(task, given, message, tmp_path):
    part = tmp_path / "part.stl"
    write_stl(step(), part)
    words = [
        sys.executable,
        "-m",
        "freecad_fiveaxis",
        task,
        part,
        "--machine",
        "trunnion_ac",
        f"--lead-in={given}",
    ]
    done = subprocess.run(words, capture_output=True, text=True, timeout=60)
    assert done.returncode == 2 and message in done.stderr and given in done.stderr, done.stderr
    assert task == "post" or len(done.stderr.splitlines()) == 1
