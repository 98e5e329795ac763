# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rings that follow one another are chained within the limits of a rotary axis: against all chains there are,
and on a whole part."""

from __future__ import annotations

import itertools
import json
import math
from pathlib import Path

import numpy as np
import pytest
from plain import build_settings
from revolved import solid_of_revolution

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.passes.ring_chain import REWIND, TURNING, Ways, choose_ways
from freecad_fiveaxis.core.pipeline import begin_rings, job

MACHINES = Path(__file__).parents[2] / "resources" / "machines"
TURN = 2.0 * math.pi


def ring(begin, place):
    """Both ways round a ring that begins at a word and a place."""
    words = [(begin, begin + TURN, begin, begin + TURN), (begin + TURN, begin, begin, begin + TURN)]
    ends = np.broadcast_to(place, (2, 2, 3))
    return Ways(np.array(words), ends, np.zeros(2, np.int64), np.array([0.0, 0.1]))


def cost_of(passes, chosen, turns, free):
    """What a chain costs with whole turns of its own for each pass."""
    words = [one.words[way] + TURN * turn for one, way, turn in zip(passes, chosen, turns, strict=True)]
    total = sum(float(one.worse[way]) for one, way in zip(passes, chosen, strict=True))
    for k in range(1, len(passes)):
        turn = abs(words[k][0] - words[k - 1][1])
        way = passes[k].ends[chosen[k], 0] - passes[k - 1].ends[chosen[k - 1], 1]
        total += TURNING * turn + float(np.linalg.norm(way)) + REWIND * (turn > math.pi and not free[k])
    return total


def least_cost(passes, chosen, free, low, high):
    """The least cost of a chain over the whole turns that fit."""
    options = []
    for one, way in zip(passes, chosen, strict=True):
        least, most = one.words[way, 2:]
        fits = [turn for turn in range(-3, 4) if least + TURN * turn >= low and most + TURN * turn <= high]
        options.append(fits)
    return min(
        (cost_of(passes, chosen, turns, free) for turns in itertools.product(*options)), default=math.inf
    )


def test_of_all_chains_the_cheapest_is_chosen():
    rng = np.random.default_rng(4)
    for _ in range(12):
        passes = [ring(rng.uniform(-3.0, 3.0), rng.uniform(0.0, 40.0, 3)) for _ in range(4)]
        free = np.array([True, *(rng.random(3) < 0.2)])
        low, high = -TURN - 0.5, TURN + 0.5
        chosen = choose_ways(passes, free, low, high)
        best = min(least_cost(passes, ways, free, low, high) for ways in itertools.product((0, 1), repeat=4))
        assert least_cost(passes, chosen, free, low, high) == pytest.approx(best, abs=1e-9)


def test_rings_on_two_turns_of_an_axis_go_to_and_fro_instead_of_turning_back():
    passes = [ring(0.0, np.array([0.0, 0.0, 2.0 * k])) for k in range(8)]
    free = np.arange(8) == 0
    back = choose_ways(passes, free, -TURN, TURN)
    assert least_cost(passes, back, free, -TURN, TURN) < REWIND
    assert least_cost(passes, np.zeros(8, np.int64), free, -TURN, TURN) > 2 * REWIND


def test_a_pass_longer_than_the_limits_is_borne():
    wide = Ways(np.array([[0.0, 20.0, 0.0, 20.0]]), np.zeros((1, 2, 3)), np.zeros(1, np.int64), np.zeros(1))
    chosen = choose_ways([ring(0.0, np.zeros(3)), wide, ring(1.0, np.zeros(3))], np.zeros(3, bool), -7.0, 7.0)
    assert len(chosen) == 3 and chosen[1] == 0


def milled(folder, **options):
    """A stem on a base, on the trunnion whose C has two turns."""
    reported = json.loads((MACHINES / "trunnion_ac.fcm").read_text())
    reported["machine"]["axes"]["C"]["limits"] = {"min": -360.0, "max": 360.0}
    path = folder / "trunnion.fcm"
    path.write_text(json.dumps(reported))
    profile = [(0.0, 30.0), (9.0, 30.0), (9.0, 8.0), (22.0, 8.0), (22.0, 0.0), (0.0, 0.0)]
    given = {
        "machine": str(path), "cutter": "ball:6", "passes": "scallop", "scallop": 0.1, "tool_axis": "auto",
        "tool_length": 100, **options,
    }  # fmt: skip
    return job.make(build_settings("mill", "stem", given), mesh=solid_of_revolution(profile, 48))


def test_round_a_stem_the_axis_turns_back_less_often_and_all_is_cut_as_before(tmp_path, monkeypatch):
    result = milled(tmp_path)
    assert not [one for one in job.prove(result).findings if one.severity == Severity.ERROR]
    monkeypatch.setattr(begin_rings, "_chain_rings", lambda context, solved: None)
    before = milled(tmp_path)
    assert before.joints.rewinds > 3 * result.joints.rewinds
    assert result.joints.inside == 0
    seen = [{tuple(row) for row in one.contact.point.round(9).tolist()} for one in (result, before)]
    assert seen[0] == seen[1]
