# SPDX-License-Identifier: LGPL-2.1-or-later
"""Links that stay near the part: they spare air, and by another library's distances none of them leads the
tool into it."""

from functools import cache

import gouge_judge
import numpy as np
import pytest
from gouge_examples import blade_beside_hub, bowl_block, knob_in_corner, step
from plain import build_settings
from thorough import some_in_core

from freecad_fiveaxis.core.links import near_links
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.report.figures import summary
from freecad_fiveaxis.core.toolpath.cl_path import Motion

PARTS = {
    "step": lambda: step(6.0),
    "bowl": lambda: bowl_block(11.0, cells=16),
    "knob": lambda: knob_in_corner(cells=16),
    "blade": lambda: blade_beside_hub(cells=16),
}
OPTIONS = {
    "machine": "trunnion_ac",
    "tool_length": 120,
    "cutter": "ball:8:40",
    "stepover": 2.0,
    "max_axis_angle": 60,
}


def milled_anew(part, **options):
    return job.make(build_settings("mill", "part", {**OPTIONS, **options}), mesh=PARTS[part]())


milled = cache(milled_anew)
"""The program, made once for all tests that ask for the same."""


def lengths(result):
    numbers = summary(job.figures(result))
    return {name: numbers[f"{name}_length"] for name in ("cut", "link", "rapid")}


def feed_blocks(program):
    return np.flatnonzero(program.motion[1:] != Motion.RAPID)


def deepest(outcome):
    """How deep the cutter goes on any feed block, mm, by the judge."""
    blocks = feed_blocks(outcome.program)
    return gouge_judge.judged(
        outcome.mesh, outcome.settings.cutter.cutter, outcome.kinematics, outcome.program.words, blocks
    ).worst


@pytest.mark.thorough
@some_in_core("part", list(PARTS), kept=(0, 3))
def test_the_same_is_cut_with_less_air_and_the_judge_finds_nothing(part):
    near, over = milled(part), milled(part, links="over")
    result = job.prove(near)
    here, there = lengths(result), lengths(job.prove(over))
    assert here["cut"] == pytest.approx(there["cut"], rel=1e-3)
    assert here["rapid"] + here["link"] < 0.7 * (there["rapid"] + there["link"])
    assert deepest(near) <= near.settings.proof.tolerance
    codes = {finding.code for finding in result.findings}
    assert not codes & {"overcut", "rapid-collision", "holder-collision"}


def test_the_judge_would_see_a_near_link_that_is_not_free(monkeypatch):
    """All links on the surface, whatever is between their ends."""
    monkeypatch.setattr(near_links, "HEIGHTS", (0.0,))
    monkeypatch.setattr(
        near_links, "_worthwhile", lambda path, gaps, lift, radius: np.ones(len(gaps.last), bool)
    )
    monkeypatch.setattr(near_links, "_free", lambda path, last, *rest: np.ones(len(last), bool))
    assert deepest(milled_anew("knob", linearize="off")) > 0.1


def test_nothing_goes_near_a_part_that_is_not_looked_at_or_where_the_user_wants_it_over():
    off, over = milled("knob", gouge="off"), milled("knob", links="over")
    assert near_links.find_gaps(off.path).last.size > 5
    assert near_links.find_gaps(over.path).last.size > 5


def test_a_gap_lies_between_two_polylines_and_is_worth_what_it_takes():
    path = milled("step", links="over").path
    gaps = near_links.find_gaps(path)
    assert np.isin(path.motion[gaps.last], (Motion.CUT, Motion.FILL)).all()
    assert (path.motion[gaps.first] == Motion.LINK).all() and (
        path.motion[gaps.first + 1] == Motion.CUT
    ).all()
    for last, first, worth in zip(*gaps, strict=True):
        step_length = np.linalg.norm(np.diff(path.tip[last : first + 1], axis=0), axis=1)
        rapid = path.motion[last + 1 : first + 1] == Motion.RAPID
        assert worth == pytest.approx(
            step_length[~rapid].sum() + near_links.RAPID_WORTH * step_length[rapid].sum()
        )


def test_rows_of_the_passes_stay_as_they_are():
    over, near = milled("bowl", links="over", gouge="report"), milled("bowl", gouge="report")
    cut = [np.isin(one.path.motion, (Motion.CUT, Motion.FILL)) for one in (over, near)]
    for name in ("tip", "axis", "contact", "face", "pass_"):
        assert np.array_equal(getattr(over.path, name)[cut[0]], getattr(near.path, name)[cut[1]])
    left = near_links.find_gaps(near.path)
    assert len(left.last) < len(near_links.find_gaps(over.path).last)


def test_lifts_stand_along_the_axes_of_either_end():
    near = milled("blade").path
    put = np.flatnonzero((near.motion[1:-1] == Motion.LINK) & (near.motion[:-2] == Motion.CUT)) + 1
    rise = near.tip[put] - near.tip[put - 1]
    height = np.linalg.norm(rise, axis=1)
    lifted = np.isin(np.round(height, 6), near_links.HEIGHTS[1:])
    assert lifted.any()
    assert np.allclose(rise[lifted], height[lifted, None] * near.axis[put - 1][lifted])
