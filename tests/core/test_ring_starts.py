# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed passes begin where a rotary axis has room for them: against trying every start, and on whole parts."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
from plain import build_settings
from revolved import solid_of_revolution

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.machine.kinematics import forward
from freecad_fiveaxis.core.passes import slice_field
from freecad_fiveaxis.core.passes.ring_starts import begin_at, find_closed, find_start, find_turn, reverse
from freecad_fiveaxis.core.pipeline import begin_rings, job, milling
from freecad_fiveaxis.core.toolpath.cl_path import Motion

MACHINES = Path(__file__).parents[2] / "resources" / "machines"
TURN = 2.0 * math.pi
LOW, HIGH = math.radians(-200.0), math.radians(200.0)


def unwound(word, start):
    """The words of a closed pass from a row on, each on the turn nearest to the one before."""
    return np.unwrap(np.roll(word, -start))


def room(word, start, low, high):
    """How far the words of a closed pass stay within the limits, of all whole turns the best."""
    way = unwound(word, start)
    return max(
        min(float(way.min()) + TURN * turn - low, high - float(way.max()) - TURN * turn)
        for turn in range(-4, 5)
    )


def ring(phase, sense=1.0, count=144, waver=3.5):
    """Words of a closed pass that waver, so that it spans 367 deg from where it wavers most."""
    at = np.arange(count) * TURN / count
    return phase + sense * at + math.radians(waver) * np.sin(9.0 * at) * (np.arange(count) % 4 < 2)


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_ring_that_needs_367_of_400_deg_fits_at_any_phase(sense):
    begun_as_it_was = 0
    for phase in np.radians(np.arange(-180.0, 180.0, 7.5)):
        word = ring(phase, sense)
        folded = np.arctan2(np.sin(word), np.cos(word))
        start = find_start(folded, LOW, HIGH)
        assert start % 2 == 0 and room(word, start, LOW, HIGH) >= 0.0
        begun_as_it_was += room(word, 0, LOW, HIGH) >= 0.0
    assert 0 < begun_as_it_was < 12  # so it would be noticed if all began where they did


def test_of_random_rings_the_start_has_the_most_room_of_all():
    rng = np.random.default_rng(3)
    for _ in range(60):
        count = 2 * int(rng.integers(6, 40))
        word = rng.uniform(-3, 3) + rng.choice([-1, 1]) * np.arange(count) * TURN / count
        word = word + rng.normal(0.0, 0.15, count)
        low = rng.uniform(-7.0, 0.0)
        high = low + TURN * rng.uniform(1.0, 1.9)
        start = find_start(word + TURN * rng.integers(-2, 3, count), low, high)
        best = max(room(word, k, low, high) for k in range(0, count, 2))
        assert room(word, start, low, high) == pytest.approx(best, abs=1e-9)


def test_a_pass_that_makes_no_turn_of_the_axis_begins_where_it_did():
    assert find_start(0.4 * np.sin(np.arange(40) * TURN / 40), LOW, HIGH) == -1


def cone(columns=24):
    return solid_of_revolution([(0.0, 12.0), (6.0, 12.0), (14.0, 0.0), (0.0, 0.0)], columns)


def test_turned_rings_are_the_same_segments_in_the_same_sense():
    mesh = cone()
    whole = slice_field(mesh, mesh.vertex[:, 2], [3.0, 6.0, 9.0])
    closed = find_closed(whole, np.ones(len(mesh.face), bool))
    assert len(closed) == 3
    start = np.array([2, 10, 24])
    turned = begin_at(whole, closed, start)
    assert len(find_closed(turned, np.ones(len(mesh.face), bool))) == 3
    for (first, behind), rows in zip(closed.tolist(), start.tolist(), strict=True):
        for name in ("point", "normal", "face", "coedge"):
            rolled = np.roll(getattr(whole, name)[first:behind], -rows, axis=0)
            np.testing.assert_array_equal(getattr(turned, name)[first:behind], rolled)
    joined = np.flatnonzero(np.diff(turned.polyline) == 0)
    joined = joined[joined % 2 == 1]
    np.testing.assert_array_equal(turned.point[joined], turned.point[joined + 1])
    np.testing.assert_array_equal(turned.segment, whole.segment)


def test_a_pass_that_goes_over_what_is_not_cut_is_not_closed():
    mesh = cone()
    whole = slice_field(mesh, mesh.vertex[:, 2], [3.0, 6.0])
    keep = np.ones(len(mesh.face), bool)
    keep[whole.face[0]] = False
    assert len(find_closed(whole, keep)) < 2


def machine_file(folder, low, high):
    """The trunnion whose C has these limits, deg, and whose A leans to one side only."""
    reported = json.loads((MACHINES / "trunnion_ac.fcm").read_text())
    for letter, limits in (("C", (low, high)), ("A", (-5.0, 110.0))):
        reported["machine"]["axes"][letter]["limits"] = dict(zip(("min", "max"), limits, strict=True))
    path = folder / "trunnion.fcm"
    path.write_text(json.dumps(reported))
    return str(path)


def milled(folder, low, high, **options):
    """Rings to and fro up a dome."""
    up = np.radians(np.arange(80.0, -1.0, -16.0))
    profile = [(0.0, 12.0), *zip(12.0 * np.cos(up), 12.0 * np.sin(up), strict=True), (0.0, 0.0)]
    given = {
        "machine": machine_file(folder, low, high), "cutter": "ball:6", "passes": "zlevel", "stepover": 3.0,
        "tool_length": 100, **options,
    }  # fmt: skip
    return job.make(build_settings("mill", "dome", given), mesh=solid_of_revolution(profile, 24))


def codes(result):
    return {one.code for one in result.findings}


def marks(result):
    """How many times C turns back inside a cut."""
    return sum(one.code == "rewind" for one in result.findings)


def jumps(result):
    """The largest step of C, deg, on a feed block."""
    fed = result.joints.path.motion[1:] != Motion.RAPID
    return float(np.degrees(np.abs(np.diff(result.joints.q[:, 3]))[fed].max()))


def without_the_stage(monkeypatch):
    stages = tuple(one for one in milling.STAGES if one is not begin_rings.begin_rings_within_limits)
    monkeypatch.setattr(milling, "STAGES", stages)


@pytest.mark.parametrize(("low", "high"), [(-200.0, 200.0), (30.0, 430.0)])
def test_rings_on_a_dome_are_cut_without_turning_back_where_the_axis_has_a_turn_to_spare(
    tmp_path, monkeypatch, low, high
):
    result = milled(tmp_path, low, high)
    assert not codes(result) & {"rewind", "rewinds", "rewinds-between-cuts"} and result.joints.rewinds == 0
    assert "rings-begun-elsewhere" in codes(result) and jumps(result) < 60.0
    word = np.degrees(result.joints.q[:, 3])
    assert low <= word.min() and word.max() <= high
    tip, _ = forward(result.kinematics, result.joints.q)
    np.testing.assert_allclose(tip, result.joints.path.tip, rtol=0.0, atol=2e-4)
    verdict = job.prove(result)
    assert not [one for one in verdict.findings if one.severity == Severity.ERROR]
    without_the_stage(monkeypatch)
    before = milled(tmp_path, low, high)
    assert marks(before) > 1
    seen = [{tuple(row) for row in one.contact.point.round(9).tolist()} for one in (result, before)]
    assert seen[0] == seen[1]


def test_rings_round_a_prism_run_to_and_fro_and_the_axis_turns_back_no_more(tmp_path, monkeypatch):
    """A hexagon: the tour of its rings takes some of them twice the same way round."""
    hexagon = solid_of_revolution([(0.0, 0.0), (12.0, 0.0), (12.0, -15.0), (0.0, -15.0)], 6)
    options = {
        "machine": machine_file(tmp_path, -200.0, 200.0),
        "cutter": "ball:6",
        "passes": "scallop",
        "scallop": 0.03,
    }

    def make(**more):
        return job.make(build_settings("mill", "hexagon", options | more), mesh=hexagon)

    result = make()
    assert "rings-reversed" in codes(result) and marks(result) == 0
    tip, _ = forward(result.kinematics, result.joints.q)
    np.testing.assert_allclose(tip, result.joints.path.tip, rtol=0.0, atol=2e-4)
    assert not [one for one in job.prove(result).findings if one.severity == Severity.ERROR]
    assert "rings-reversed" not in codes(make(order="one_way"))
    for change in ("_reverse_rings", "_chain_rings"):
        monkeypatch.setattr(begin_rings, change, lambda context, solved: None)
    before = make()
    assert before.joints.rewinds > 3 * result.joints.rewinds
    assert np.degrees(np.abs(np.diff(before.joints.q[:, 3])).sum()) > 1.2 * np.degrees(
        np.abs(np.diff(result.joints.q[:, 3])).sum()
    )
    seen = [{tuple(row) for row in one.contact.point.round(9).tolist()} for one in (result, before)]
    assert seen[0] == seen[1]


def test_reversed_rings_are_the_same_segments_the_other_way_round():
    mesh = cone()
    whole = slice_field(mesh, mesh.vertex[:, 2], [3.0, 6.0])
    closed = find_closed(whole, np.ones(len(mesh.face), bool))
    turned = reverse(whole, closed[:1])
    first, behind = closed[0]
    assert np.array_equal(turned.point[first:behind], whole.point[first:behind][::-1])
    assert np.array_equal(turned.face[first:behind], whole.face[first:behind][::-1])
    assert np.array_equal(turned.point[behind:], whole.point[behind:])
    word = np.radians(np.arange(0.0, 360.0, 7.5))
    assert find_turn(word) == pytest.approx(2.0 * math.pi) and find_turn(-word) == pytest.approx(
        -2.0 * math.pi
    )
    assert find_turn(np.sin(word)) == pytest.approx(0.0)


@pytest.mark.parametrize(
    ("before", "after", "text"),
    [
        (1, 0, "C no longer turns back, as it had to once."),
        (5, 0, "C no longer turns back, as it had to 5 times."),
        (5, 1, "C turns back once instead of 5 times."),
        (5, 2, "C turns back 2 instead of 5 times."),
    ],
)
def test_what_rings_spare_is_put_in_plain_words(before, after, text):
    assert begin_rings._say_times(after, before, "C") == text
    inside = begin_rings._say_inside(after, before, "C")
    assert "0" not in inside and "1 times" not in inside and inside.startswith("C ")


def test_rings_all_one_way_turn_back_between_them_only(tmp_path):
    result = milled(tmp_path, -200.0, 200.0, order="one_way")
    assert marks(result) == 0 and {"rewinds-between-cuts", "rings-begun-elsewhere"} <= codes(result)


def test_where_nothing_has_to_turn_back_rings_begin_where_they_did(tmp_path, monkeypatch):
    result = milled(tmp_path, -400.0, 400.0)
    assert "rings-begun-elsewhere" not in codes(result) and result.joints.rewinds == 0
    without_the_stage(monkeypatch)
    assert milled(tmp_path, -400.0, 400.0).nc == result.nc


def test_the_stages_that_turn_rings_go_through_again_are_those_up_to_the_joints():
    again = milling.STAGES[1 : milling.STAGES.index(begin_rings.begin_rings_within_limits)]
    assert again == begin_rings.TO_JOINTS
