# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is left out stays out, and what is cut keeps off what was left out."""

import numpy as np
import pytest
from plain import build_settings

from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.toolpath.cl_path import Motion

STEPS = (30.0, 24.0, 14.0)  # heights of the treads, mm; each 20 mm deep along X, 40 mm wide


def prism(profile, width):
    """A solid of a counter-clockwise profile in XZ, from y = -width/2 to width/2; the profile is convex seen
    from (0, 0)."""
    x, z = np.array(profile, float).T
    n, front, back = len(x), -width / 2, width / 2
    near, far = np.column_stack([x, np.full(n, front), z]), np.column_stack([x, np.full(n, back), z])
    nxt = np.roll(np.arange(n), -1)
    walls = [np.stack([near, far[nxt], near[nxt]], 1), np.stack([near, far, far[nxt]], 1)]
    fan = [(0, i, i + 1) for i in range(1, n - 1)]
    caps = [near[np.array(fan)], far[np.array(fan)[:, ::-1]]]
    return np.concatenate([*walls, *caps])


@pytest.fixture
def stairs(tmp_path):
    """A stepped block whose walls stand upright; seen from its lower back corner every part of the profile is
    in sight."""
    profile = [
        (0.0, 0.0),
        (60.0, 0.0),
        (60.0, STEPS[2]),
        (40.0, STEPS[2]),
        (40.0, STEPS[1]),
        (20.0, STEPS[1]),
        (20.0, STEPS[0]),
        (0.0, STEPS[0]),
    ]
    path = tmp_path / "stairs.stl"
    write_stl(from_triangles(prism(profile, 40.0)), path)
    return path


def milled(path, **options):
    given = {"machine": "trunnion_ac", "stepover": 3.0, **options}
    return job.make(build_settings("mill", str(path), given))


def least_distance_to_the_steps(centre):
    """Of points (n, 3) from the stairs, by hand: the nearest of the three boxes that they are made of."""
    distance = np.full(len(centre), np.inf)
    for k, height in enumerate(STEPS):
        low, high = np.array([20.0 * k, -20.0, 0.0]), np.array([20.0 * (k + 1), 20.0, height])
        distance = np.minimum(
            distance, np.linalg.norm(np.maximum(0, np.maximum(low - centre, centre - high)), axis=1)
        )
    return distance


def centres_along_feed(result):
    """Ball centres on the commanded chords of all feed moves, 9 a move (3 axes: the tool stands upright)."""
    path = result.path
    centre = path.tip + 5.0 * path.axis
    end = np.flatnonzero(path.motion[1:] != Motion.RAPID) + 1
    u = np.linspace(0, 1, 9)[:, None, None]
    return ((1 - u) * centre[end - 1] + u * centre[end]).reshape(-1, 3)


@pytest.mark.parametrize(
    "options", [{"max_axis_angle": "60"}, {"max_axis_angle": "60", "tool_axis": "fixed", "lead": "5"}]
)
def test_the_ball_stops_short_of_a_wall_that_is_left_out(stairs, options):
    result = milled(stairs, **options)
    cut = result.path.motion <= Motion.FILL
    assert set(np.round(result.path.contact[cut, 2], 6)) == set(STEPS)
    assert least_distance_to_the_steps(centres_along_feed(result)).min() > 5.0 - 1e-6


@pytest.mark.parametrize("order", ["zigzag", "one_way"])
@pytest.mark.parametrize("direction", ["0", "180"])
def test_a_tread_is_cut_up_to_its_wall_whichever_way_the_pass_goes(stairs, direction, order):
    """Up to where the ball touches the wall that is left out, on every tread of every pass: 5 mm before
    it."""
    result = milled(stairs, max_axis_angle="60", direction=direction, order=order)
    cut = result.path.pass_ >= 0
    for pass_ in np.unique(result.path.pass_[cut]):
        for tread, wall in ((STEPS[1], 20.0), (STEPS[2], 40.0)):
            reach = result.path.contact[
                cut & (result.path.pass_ == pass_) & (np.abs(result.path.contact[:, 2] - tread) < 1e-6), 0
            ]
            assert reach.min() == pytest.approx(wall + 5.0, abs=1e-6) and reach.max() == pytest.approx(
                wall + 20.0, abs=1e-6
            )


def test_a_tool_that_leans_towards_the_wall_stops_before_it_and_says_so(stairs):
    """Cut towards the wall with a lead, it would retract through the wall; cut away from it, it leans
    away."""
    result = milled(stairs, max_axis_angle="60", tool_axis="fixed", lead="5")
    message = {finding.code: finding for finding in result.findings}["axis-into-part"]
    assert message.value > 10.0
    for pass_, back in ((0, False), (1, True)):
        row = result.path.contact[
            (result.path.pass_ == pass_) & (np.abs(result.path.contact[:, 2] - STEPS[1]) < 1e-6), 0
        ]
        assert (row.min() > 30.0) == back


def test_without_the_wall_the_ball_would_run_into_it(stairs):
    """The same treads, cut as if nothing stood beside them: the comparison above can fail."""
    result = milled(stairs, max_axis_angle="60")
    treads = result.path.contact[result.path.motion <= Motion.FILL]
    into_the_wall = np.array([[20.0 + 1e-3, 0.0, STEPS[1] + 5.0]])
    assert treads[:, 0].max() > 55.0
    assert least_distance_to_the_steps(into_the_wall)[0] < 1.0


def test_contacts_that_the_tool_would_lean_into_are_left_out_with_their_length(stairs):
    result = milled(stairs, tool_axis="fixed", axis="0.3,0,1", stepover=5.0)
    message = {finding.code: finding for finding in result.findings}
    assert message["axis-into-part"].value > 10.0
    cut = result.path.motion <= Motion.FILL
    assert ((result.path.normal * result.path.axis).sum(axis=1)[cut] > -1e-6).all()


def test_lead_beyond_the_rotary_limits_leaves_out_and_does_not_refuse(stairs):
    result = milled(stairs, machine="linuxcnc_xyzac_trt", lead="-20", tilt="20")
    assert "axis-beyond-limits" in {finding.code for finding in result.findings}
    words = np.radians(result.program.words[:, 3:])
    assert (words >= result.kinematics.low[3:] - 1e-6).all() and (
        words <= result.kinematics.high[3:] + 1e-6
    ).all()


@pytest.mark.thorough
def test_where_nothing_is_left_out_no_row_is_lost(stairs):
    result = milled(stairs)
    assert not {"axis-into-part", "axis-beyond-limits"} & {finding.code for finding in result.findings}
