# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of polylines whose tool axes are known: places side by side with other axes are far apart, and
what is cut stays the same."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from gouge_examples import bowl_block, knob_in_corner
from one_field import keep_fields
from plain import build_settings
from test_axis_field import NODES, take_nodes

from freecad_fiveaxis.core.orientation.order_with_axes import LEVER, order_with_axes
from freecad_fiveaxis.core.pipeline import assign_axes, job
from freecad_fiveaxis.core.report.figures import summary
from freecad_fiveaxis.core.toolpath.coedge import ROW_COLUMNS, OffsetPath

OPTIONS = {
    "machine": "trunnion_ac",
    "tool_length": 120,
    "cutter": "ball:6",
    "scallop": 0.2,
    "tool_axis": "auto",
}


def short_polylines(start, rows=3):
    """An offset path of polylines of ``rows`` rows, 1 mm along X each, from these places (p, 3)."""
    point = (start[:, None] + np.linspace(0.0, 1.0, rows)[None, :, None] * np.array([1.0, 0.0, 0.0])).reshape(
        -1, 3
    )
    number, row = np.repeat(np.arange(len(start)), rows), np.arange(len(point))
    columns = dict.fromkeys(("normal", "before", "after"), np.tile([0.0, 0.0, 1.0], (len(point), 1)))
    columns |= dict.fromkeys(("step_before", "step_after"), np.full(len(point), 0.5))
    columns |= dict.fromkeys(("face", "coedge", "segment"), row) | dict.fromkeys(
        ("polyline", "pass_"), number
    )
    return OffsetPath(point=point, centre=point + [0.0, 0.0, 3.0], fill=np.zeros(len(point), bool), **columns)


def moves(path, axis):
    """How often each move of the path is made, whichever way round: both ends with their axes, whether it
    fills, its facets' normals."""
    row = np.flatnonzero(np.diff(path.polyline) == 0)
    pose = np.round(np.hstack([path.point, path.centre, axis]), 9)
    ends = [tuple(sorted((tuple(pose[i]), tuple(pose[i + 1])))) for i in row]
    return Counter(zip(ends, path.fill[row + 1].tolist(), strict=True))


def air(path, axis):
    """mm between polylines, a radian of turn as LEVER."""
    gap = np.flatnonzero(np.diff(path.polyline))
    pose = np.hstack([path.point, LEVER * axis])
    return np.linalg.norm(pose[gap + 1] - pose[gap], axis=1).sum()


def test_polylines_of_one_axis_come_together_though_others_lie_between():
    start = np.column_stack([np.zeros(12), np.arange(12.0), np.zeros(12)])
    path = short_polylines(start)
    lean = np.where(np.arange(12) % 2, 1.0, -1.0)[path.polyline]
    axis = np.column_stack([np.zeros(len(lean)), lean * np.sin(1.0), np.full(len(lean), np.cos(1.0))])
    ordered, turned = order_with_axes(path, axis)
    sides = turned[np.flatnonzero(np.diff(ordered.polyline, prepend=-1)), 1] > 0.0
    assert np.count_nonzero(np.diff(sides)) == 1
    assert moves(ordered, turned) == moves(path, axis)
    assert air(ordered, turned) < 0.2 * air(path, axis)


def test_with_one_axis_for_all_the_places_alone_count_and_a_good_order_stays():
    path = short_polylines(np.column_stack([np.zeros(6), np.arange(6.0), np.zeros(6)]))
    axis = np.tile([0.0, 0.0, 1.0], (len(path.point), 1))
    to_and_fro, turned = order_with_axes(path, axis)
    assert order_with_axes(to_and_fro, turned)[0] is to_and_fro


@pytest.mark.parametrize("count", [0, 1])
def test_a_path_of_one_polyline_or_none_stays(count):
    path = short_polylines(np.zeros((count, 3)))
    assert order_with_axes(path, path.normal)[0] is path


def test_a_row_that_is_come_to_backwards_has_its_sides_and_its_fill_turned_round():
    path = short_polylines(
        np.column_stack([np.zeros(5), 0.1 * np.arange(5.0), np.zeros(5)]), rows=4
    )  # all one way, side by side
    row = np.arange(len(path.point))
    sides = {
        "before": np.eye(3)[row % 3],
        "after": np.eye(3)[(row + 1) % 3],
        "step_before": row + 0.25,
        "step_after": row + 0.75,
    }
    path = replace(path, fill=row % 4 == 1, **sides)  # the first move of each polyline fills
    axis = np.tile([0.0, 0.0, 1.0], (len(row), 1))
    ordered, _ = order_with_axes(path, axis)
    given = ordered.face  # here: the row of the path given
    within = np.flatnonzero(np.diff(ordered.polyline) == 0)
    back = np.diff(given)[within] < 0
    assert back.any() and not back.all()
    for i, turned in zip(within, back, strict=True):
        for one, other in (("before", "after"), ("step_before", "step_after")):
            assert np.array_equal(getattr(ordered, one)[i], getattr(path, other if turned else one)[given[i]])
        assert ordered.fill[i + 1] == path.fill[max(given[i], given[i + 1])]
    assert not ordered.fill[np.flatnonzero(np.diff(ordered.polyline, prepend=-1))].any()
    assert set(ROW_COLUMNS) >= {"fill", "before", "after", "step_before", "step_after"}


@pytest.mark.thorough
@pytest.mark.parametrize(
    "part", [lambda: knob_in_corner(cells=12), lambda: bowl_block(11.0, cells=12)], ids=["knob", "bowl"]
)
def test_the_same_is_cut_with_less_between(part, monkeypatch):
    take_nodes(monkeypatch, NODES)
    keep_fields(monkeypatch)

    def milled():
        return job.make(build_settings("mill", "part", {**OPTIONS, "gouge": "report"}), mesh=part())

    with_axes = milled()
    monkeypatch.setattr(assign_axes, "order_with_axes", lambda path, axis: (path, axis))
    without = milled()
    assert moves(with_axes.offset, with_axes.axis) == moves(without.offset, without.axis)
    numbers = [summary(job.figures(job.prove(result))) for result in (with_axes, without)]
    between = [one["link_length"] + one["rapid_length"] for one in numbers]
    assert between[0] < between[1]
    assert numbers[0]["cut_length"] == pytest.approx(numbers[1]["cut_length"], rel=0.01)


@pytest.mark.thorough
def test_one_way_and_axes_that_lean_with_the_feed_keep_their_way_round(monkeypatch):
    def refuse(path, axis):
        raise AssertionError("asked for another order")

    monkeypatch.setattr(assign_axes, "order_with_axes", refuse)

    def milled(**option):
        job.make(
            build_settings("mill", "part", {**OPTIONS, **option, "gouge": "off"}),
            mesh=bowl_block(11.0, cells=12),
        )

    take_nodes(monkeypatch, NODES)
    keep_fields(monkeypatch)
    milled(order="one_way")
    milled(lead=5)
    with pytest.raises(AssertionError, match="another order"):
        milled()
