# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which facets can be cut along their normal, and how much area is left out."""

import math

import numpy as np
import pytest
from mesh_shapes import box, sphere

from freecad_fiveaxis.core.base.errors import ReachError, SettingsError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.machine import Axis, Machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward
from freecad_fiveaxis.core.passes import axes_within_limits, facets_within_limits

INF = math.inf


def kinematics(tilt=(-INF, INF), turn=(-INF, INF), first=(0, 0, 1), second=(1, 0, 0)):
    """Table-table: the first axis, nearer to the work, with limits ``turn`` deg, the second with ``tilt``
    deg."""
    move = [
        Axis(letter, False, "head", tuple(row)) for letter, row in zip("XYZ", np.eye(3).tolist(), strict=True)
    ]
    c = Axis("C", True, "table", first, low=math.radians(turn[0]), high=math.radians(turn[1]))
    a = Axis("A", True, "table", second, low=math.radians(tilt[0]), high=math.radians(tilt[1]))
    return chain(Machine("trial", (c, a, *move)), Setup())


def ball(rows=40, columns=60):
    return from_triangles(sphere(10.0, rows, columns))


def codes(found):
    return {finding.code: finding for finding in found}


def test_a_box_keeps_its_top_and_its_upright_walls():
    mesh = from_triangles(box(high=(10, 20, 30)))
    keep, found = facets_within_limits(mesh, kinematics(), math.pi / 2)
    np.testing.assert_array_equal(keep, mesh.normal[:, 2] > -0.5)
    assert [finding.severity for finding in found] == [Severity.NOTE]
    assert found[0].value == pytest.approx(200.0) and found[0].unit == "mm2" and found[0].place[2] == 0.0
    assert "200 mm2" in found[0].text and f"{100 * 200 / 2200:.3g} %" in found[0].text


def test_walls_that_rounding_tilts_over_are_still_walls():
    corners = box(high=(10, 20, 30)).astype(float)
    corners[..., 0] += 3e-5 * (corners[..., 2] > 0) * np.where(corners[..., 0] > 0, 1, -1)
    keep, found = facets_within_limits(from_triangles(corners), kinematics(), math.pi / 2)
    assert keep.sum() == 10 and [finding.code for finding in found] == ["facets-looking-down"]


@pytest.mark.parametrize("most", [20.0, 45.0, 70.0])
def test_facets_steeper_than_the_largest_axis_angle_are_out_with_their_area(most):
    mesh = ball()
    keep, found = facets_within_limits(mesh, kinematics(), math.radians(most))
    lean = np.degrees(np.arccos(mesh.normal[:, 2]))
    np.testing.assert_array_equal(keep[np.abs(lean - most) > 0.01], (lean < most)[np.abs(lean - most) > 0.01])
    steep = codes(found)["facets-beyond-axis-angle"]
    assert steep.severity == Severity.WARNING
    zone = (
        2 * math.pi * 10 * 10 * math.cos(math.radians(most))
    )  # of the sphere between that angle and its equator
    assert steep.value == pytest.approx(zone, rel=0.1)
    corners = mesh.vertex[mesh.face[~keep & (mesh.normal[:, 2] >= 0)]]
    area = (
        0.5
        * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()
    )
    assert steep.value == pytest.approx(area)


def test_a_tilt_limit_leaves_out_what_leans_further():
    mesh = ball()
    keep, found = facets_within_limits(mesh, kinematics(tilt=(-30, 50)), math.pi / 2)
    lean = np.degrees(np.arccos(mesh.normal[:, 2]))
    clear = np.abs(lean - 50) > 1e-3
    np.testing.assert_array_equal(keep[clear], (lean < 50)[clear])
    assert set(codes(found)) == {"facets-looking-down", "facets-beyond-machine"}
    assert "A (-30 to 50 deg)" in codes(found)["facets-beyond-machine"].text


def test_the_three_reasons_part_the_area():
    mesh = ball()
    keep, found = facets_within_limits(mesh, kinematics(tilt=(-30, 50)), math.radians(80))
    assert len(found) == 3
    total = mesh.area.sum()
    assert total == pytest.approx(4 * math.pi * 100, rel=0.01)
    assert sum(finding.value for finding in found) + mesh.area[keep].sum() == pytest.approx(total)


def brute_force(chain_, axis, low, high, step=0.5):
    """Which axes the words on a grid within the limits come near to, by forward kinematics alone."""
    first, second = (np.radians(np.arange(low[i], high[i] + step / 2, step)) for i in range(2))
    words = np.zeros((first.size * second.size, 5))
    words[:, 3:] = np.stack(np.meshgrid(first, second), axis=-1).reshape(-1, 2)
    result = forward(chain_, words)[1]
    return np.array([(result @ row).max() for row in axis])


@pytest.mark.parametrize("kind", [((0, 0, 1), (1, 0, 0)), ((0, 0, 1), (0, math.sqrt(0.5), math.sqrt(0.5)))])
def test_limits_of_both_axes_agree_with_forward_kinematics(kind):
    low, high = (200.0, -20.0), (500.0, 100.0)
    trial = kinematics(turn=(low[0], high[0]), tilt=(low[1], high[1]), first=kind[0], second=kind[1])
    axis = np.random.default_rng(7).normal(size=(400, 3))
    axis[:, 2] = np.abs(axis[:, 2])
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    within = axes_within_limits(trial, axis)
    nearest = brute_force(trial, axis, low, high)
    assert within.any() and not within.all()
    assert (nearest[within] > math.cos(math.radians(0.6))).all()
    assert (within | (nearest < 1.0 - 1e-9)).all()
    wrong = within != (nearest > math.cos(math.radians(0.4)))
    assert wrong.mean() < 0.03  # only those within a grid step of a limit


def test_at_the_pole_any_first_word_will_do():
    assert axes_within_limits(kinematics(turn=(20, 60)), np.array([[0.0, 0.0, 1.0]]))[0]
    assert not axes_within_limits(kinematics(turn=(20, 60), tilt=(5, 60)), np.array([[0.0, 0.0, 1.0]]))[0]


def test_whole_turns_bring_a_word_within_its_limits():
    axis = np.array([[math.sin(0.3), 0.0, math.cos(0.3)]])
    assert axes_within_limits(kinematics(turn=(360, 719)), axis)[0]
    assert axes_within_limits(kinematics(turn=(-719, -360)), axis)[0]
    assert not axes_within_limits(kinematics(turn=(400, 440)), axis)[0]


def test_nothing_left_is_an_error_that_names_the_reasons():
    with pytest.raises(ReachError, match="no facet can be cut") as caught:
        facets_within_limits(ball(), kinematics(tilt=(60, 61)), math.radians(30))
    assert "rotary limits" in str(caught.value) and "turn the part" in str(caught.value)


@pytest.mark.parametrize("angle", [0.0, -1.0, math.nan, 4.0])
def test_a_largest_axis_angle_out_of_range_is_refused(angle):
    with pytest.raises(SettingsError, match="largest axis angle"):
        facets_within_limits(ball(4, 6), kinematics(), angle)


@pytest.mark.parametrize(
    "second", [(1, 0, 0), (0, math.sqrt(0.5), math.sqrt(0.5)), (0.6, 0.0, 0.8), (0.0, 0.8, -0.6)]
)
def test_a_free_first_axis_changes_no_answer(second):
    """Without limits of the first axis the answer comes from one component; two halves of its turn go the
    long way."""
    random = np.random.default_rng(3)
    axis = random.normal(size=(3000, 3))
    axis[:200, :2] *= 1e-7
    axis[200:300, 2] = 0.0
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    spans = [
        (-120, 30),
        (0, 90),
        (-90, 0),
        (-1e-5, 2e-5),
        (100, 260),
        (-400, -100),
        (-360, 360),
        (170, 190),
        (179, 180),
    ]
    for tilt in spans:
        free, one, other = (
            axes_within_limits(kinematics(turn=turn, tilt=tilt, second=second), axis)
            for turn in ((-180, 180), (-180, 1), (1, 180))
        )
        np.testing.assert_array_equal(free, one | other)
