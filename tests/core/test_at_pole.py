# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool axes of `auto` near the machine's pole: at it, where it is free."""

import math

import numpy as np
import pytest
from dome_passes import kinematics_of
from gouge_examples import prism
from one_field import keep_fields

from freecad_fiveaxis.core.orientation import auto_axis
from freecad_fiveaxis.core.orientation.at_pole import CONE, WIDE, find_near_rows, take_pole
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings

Z = np.array([0.0, 0.0, 1.0])


def leaning(*degrees):
    angle = np.radians(degrees)
    return np.column_stack([np.sin(angle), np.zeros(len(angle)), np.cos(angle)])


def taken(axis, free=lambda near: near, polyline=None):
    rows = np.arange(len(axis))
    polyline = np.zeros(len(axis), np.int64) if polyline is None else polyline
    return take_pole(axis, rows, polyline, kinematics_of("trunnion_ac"), lambda pole, near: free(near))


def test_a_stretch_that_comes_near_the_pole_is_near_as_far_as_it_stays_there():
    lean = np.radians([30.0, 11.0, 8.0, 6.0, 8.0, 11.0, 13.0, 11.0, 8.0, 11.0])
    assert lean[2] > CONE and lean[5] < WIDE < lean[6]
    near = find_near_rows(lean, np.zeros(10, np.int64))
    assert near.tolist() == [False, True, True, True, True, True, False, False, False, False]
    parted = find_near_rows(
        lean, np.array([0, 0, 0, 1, 1, 1, 1, 1, 1, 1])
    )  # another pass: what lies before is not of its stretch
    assert parted.tolist() == [False, False, False, True, True, True, False, False, False, False]


def test_axes_near_the_pole_are_at_it_and_the_others_stay():
    axis = leaning(40.0, 9.0, 3.0, -2.0, -9.0, -40.0)
    assert taken(axis) == pytest.approx(np.concatenate([axis[:1], np.tile(Z, (4, 1)), axis[5:]]))
    down = -axis
    assert (
        taken(down)[1:5] == pytest.approx(np.tile(-Z, (4, 1))) and (taken(down)[[0, 5]] == down[[0, 5]]).all()
    )


def test_where_the_pole_is_not_free_the_axis_stays():
    axis, held = leaning(9.0, 3.0, -2.0, -9.0), np.array([False, True, False, False])
    found = taken(axis, lambda near: near & ~held)
    assert (found[1] == axis[1]).all() and found[[0, 2, 3]] == pytest.approx(np.tile(Z, (3, 1)))


def test_what_does_not_come_near_is_not_requested():
    axis = leaning(40.0, 20.0, math.degrees(CONE) + 1.0)
    assert (taken(axis, lambda near: pytest.fail("asked")) == axis).all()


ROOF = [(0, 0), (24, 0), (24, 4), (21, 8), (16, 10), (8, 10), (3, 8), (0, 4)]


def test_on_a_flat_top_the_first_axis_turns_less_far(monkeypatch):
    """And without taking the pole it turns as far as it did: the comparison can fail."""
    settings = build_settings(
        "mill", "part", {"machine": "trunnion_ac", "cutter": "ball:8", "scallop": 0.4, "gouge": "off"}
    )
    keep_fields(monkeypatch)
    turned, result = [], []
    for take in (take_pole, lambda axis, *_: axis):
        monkeypatch.setattr(auto_axis, "take_pole", take)
        result.append(job.make(settings, mesh=prism(ROOF, 16.0)))
        turned.append(np.abs(np.diff(result[-1].program.words[:, 3])).sum())
    at_pole = []
    for one in result:
        lean = np.degrees(np.arccos(np.clip(one.axis[:, 2], -1.0, 1.0)))
        at_pole.append((lean[lean < 5.0] < 1e-4).mean())
    assert at_pole == [1.0, 0.0] and turned[0] < 0.9 * turned[1], turned
