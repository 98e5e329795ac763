# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where labels and legends stand on the screen: none over another, as near as may be, and quick enough for
every frame."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_fiveaxis.gui.scene import layout

VIEW = (1200, 700)


def crossing(boxes):
    """How many pairs of boxes share a pixel, counted on the pixels themselves."""
    picture = np.zeros((VIEW[1] + 2, VIEW[0] + 2), int)
    for left, bottom, right, top in np.round(boxes).astype(int):
        picture[bottom:top, left:right] += 1
    return int((picture > 1).sum())


def placed(anchor, size=(150.0, 23.0), taken=layout.NONE, before=None):
    anchor = np.asarray(anchor, float)
    sizes = np.broadcast_to(np.asarray(size, float), anchor.shape)
    return layout.label_places(
        anchor, sizes, VIEW, taken, np.full(len(anchor), -1) if before is None else before
    )


@pytest.mark.parametrize("seed", range(20))
def test_no_label_lies_over_another_nor_over_a_legend_nor_out_of_the_view(seed):
    rng = np.random.default_rng(seed)
    spread = (2.0, 40.0, 300.0)[seed % 3]
    anchor = rng.normal((760.0, 350.0), spread, (12, 2))
    legends = np.array([[12.0, 150.0, 320.0, 560.0], [330.0, 150.0, 560.0, 560.0]])
    size = np.stack([rng.uniform(30.0, 260.0, 12), np.full(12, 23.0)], axis=1).round()
    box, slot = placed(anchor, size, legends)
    seen = slot >= 0
    assert crossing(np.concatenate([box[seen], legends])) == 0
    assert (box[seen, :2] >= 0.0).all() and (box[seen, 2:] <= VIEW).all()
    assert np.isnan(box[~seen]).all()
    assert np.allclose(box[seen, 2:] - box[seen, :2], size[seen])
    assert seen.sum() >= (8 if spread < 100.0 else 4), "labels are left out that had room"
    marks = anchor[((anchor >= 0.0) & (anchor <= VIEW)).all(axis=1)]
    assert not ((marks[:, None] > box[seen, :2]) & (marks[:, None] < box[seen, 2:])).all(axis=2).any(), (
        "a marker is covered"
    )


def test_where_labels_were_before_they_lay_over_each_other():
    """The old place, up and right of the anchor, for three anchors that are near to each other: the count
    would notice it."""
    anchor = np.array([[600.0, 350.0], [606.0, 352.0], [640.0, 340.0]])
    assert crossing(np.concatenate([anchor + 14.0, anchor + (164.0, 37.0)], axis=1)) > 0
    assert crossing(placed(anchor)[0]) == 0


def test_a_lone_label_stands_beside_its_marker_and_a_crowd_is_cut_off():
    box, slot = placed([[600.0, 350.0]])
    assert (
        slot[0] == 0
        and np.linalg.norm(layout.leader_ends(np.array([[600.0, 350.0]]), box)[0] - (600.0, 350.0)) < 16.0
    )
    _, slot = placed(np.full((40, 2), 350.0))
    assert (slot >= 0).sum() <= layout.MOST and (slot[layout.MOST :] < 0).all(), (
        "the most important come first"
    )


def test_what_is_out_of_the_view_or_behind_the_eye_has_no_label():
    _, slot = placed([[-5.0, 350.0], [600.0, 705.0], [np.nan, np.nan], [600.0, 350.0]])
    assert slot.tolist()[:3] == [-1, -1, -1] and slot[3] >= 0


def test_a_label_keeps_its_slot_while_the_view_moves_a_little():
    rng = np.random.default_rng(3)
    anchor = rng.uniform((300.0, 200.0), (900.0, 500.0), (10, 2))
    _, slot = placed(anchor)
    jumps, fresh = 0, 0
    for _ in range(40):
        anchor = anchor + (1.5, 0.5)
        kept, alone = placed(anchor, before=slot)[1], placed(anchor)[1]
        jumps, slot = jumps + int((kept != slot).sum()), kept
        fresh += int((alone >= 0).sum())
    assert jumps <= 0.05 * fresh


def test_the_line_of_a_label_ends_at_its_nearest_point():
    rng = np.random.default_rng(4)
    anchor = rng.uniform(0.0, 500.0, (50, 2))
    low = rng.uniform(0.0, 400.0, (50, 2))
    box = np.concatenate([low, low + (120.0, 23.0)], axis=1)
    end = layout.leader_ends(anchor, box)
    shares = np.stack(np.meshgrid(np.linspace(0, 1, 121), np.linspace(0, 1, 24)), axis=-1).reshape(-1, 2)
    points = box[:, None, :2] + shares * (120.0, 23.0)
    least = np.linalg.norm(points - anchor[:, None], axis=2).min(axis=1)
    assert np.linalg.norm(end - anchor, axis=1) == pytest.approx(least, abs=1.0)


@pytest.mark.parametrize("view", [VIEW, (200, 150)])
def test_the_legend_stands_in_the_upper_left_corner_even_of_a_view_that_is_too_small_for_it(view):
    assert layout.legend_place((330, 300), view) == (layout.EDGE, view[1] - layout.EDGE - 300)


def test_places_are_projected_as_a_camera_sees_them():
    eye, focal = 100.0, 2.0
    perspective = np.array(
        [[focal, 0, 0, 0], [0, focal, 0, 0], [0, 0, -1, -1], [0, 0, 0, eye]]
    )  # rows from the left
    seen = layout.project_places(
        np.array([[10.0, 5.0, 0.0], [0.0, 0.0, 50.0], [0.0, 0.0, 150.0]]), perspective, VIEW
    )
    assert seen[0] == pytest.approx([600.0 * (1.0 + focal * 10.0 / eye), 350.0 * (1.0 + focal * 5.0 / eye)])
    assert seen[1] == pytest.approx([600.0, 350.0]) and np.isnan(seen[2]).all()


def test_a_label_stands_beside_the_middle_of_its_part_where_there_is_room():
    anchor = np.array([[600.0, 350.0], [630.0, 330.0]])
    part = layout.middle_of(np.array([[450.0, 250.0], [750.0, 250.0], [450.0, 450.0], [750.0, 450.0]]))
    assert (part == [[510.0, 290.0, 690.0, 410.0]]).all()
    assert layout.overlap(placed(anchor)[0], part).all(), "they would lie over it"
    sizes, before = np.full((2, 2), (150.0, 23.0)), np.full(2, -1)
    box, slot = layout.label_places(anchor, sizes, VIEW, layout.NONE, before, part)
    assert (slot >= 0).all() and not layout.overlap(box, part).any()
    again, _ = layout.label_places(anchor, sizes, VIEW, layout.NONE, placed(anchor)[1], part)
    assert not layout.overlap(again, part).any(), "a label that lay over it before goes"
    whole = np.array([[0.0, 0.0, *map(float, VIEW)]])
    assert (layout.label_places(anchor, sizes, VIEW, layout.NONE, before, whole)[1] >= 0).all(), (
        "over it rather than nowhere"
    )


def test_a_part_behind_the_eye_or_none_has_no_middle():
    assert len(layout.middle_of(np.zeros((0, 2)))) == 0
    assert len(layout.middle_of(np.array([[1.0, 2.0], [np.nan, 3.0]]))) == 0
