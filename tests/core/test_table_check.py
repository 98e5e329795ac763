# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool against the table: by closed forms of a block that stands on it, on cuts, by the shank, and on
rapids of independent axes."""

from dataclasses import replace

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings
from test_axis_field import NODES, take_nodes

from freecad_fiveaxis.core.base.rapids import INDEPENDENT, INTERPOLATED
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge.check import program_motion
from freecad_fiveaxis.core.gouge.table_check import check_table, stays_above, table_slab
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.options import tip_to_driven, tool_body
from freecad_fiveaxis.core.report.figures import summary
from freecad_fiveaxis.core.report.scope import scope
from freecad_fiveaxis.core.tool.body import Body
from freecad_fiveaxis.core.toolpath.cl_path import Motion

ON_TABLE = (0.0, 0.0, -100.0)
"""The work zero of trunnion_ac on its table's face."""
OPTIONS = {
    "machine": "trunnion_ac",
    "tool_length": 120,
    "cutter": "ball:6",
    "stepover": 4.0,
    "passes": "planes",
}


def proved(height=10.0, **options):
    mesh = from_triangles(box((0, 0, 0), (30, 20, height)))
    return job.prove(job.make(build_settings("mill", "part", {**OPTIONS, **options}), mesh=mesh))


def below(result):
    return [one for one in result.findings if one.code == "table-collision"]


def lowest(result, height, **given):
    """The finding of the same program over a table at this height, mm."""
    outcome = result.draft
    back = tip_to_driven(outcome.settings)
    return check_table(
        height, tool_body(outcome.settings), outcome.kinematics, outcome.program, 0.01, back, **given
    )


def test_a_level_ball_at_the_foot_of_a_wall_goes_below_the_table_by_its_radius():
    result = proved(origin=ON_TABLE, gouge="report")
    (one,) = below(result)
    assert one.value == pytest.approx(3.0, abs=0.02) and one.line is not None
    assert "below the table" in str(one.text) and one.place[2] == pytest.approx(0.0, abs=3.0)


def test_what_is_proven_of_the_table_is_stated_and_only_then():
    def proven(result):
        figures = job.figures(result)
        return [str(one) for one in scope(figures, summary(figures)).proven]

    free, low, off = proved(gouge="report"), proved(origin=ON_TABLE, gouge="report"), proved(gouge="off")
    assert "the tool stays above the table's face, at Z -100 mm" in proven(free)
    assert any("out of the part" in one for one in proven(low)), "below the table is not in the part"
    assert not any("table" in one for one in proven(low) + proven(off))


def test_the_same_part_as_much_higher_is_free_to_the_tolerance():
    result = proved(origin=ON_TABLE, gouge="report")
    assert not lowest(result, -3.02)
    (one,) = lowest(result, -2.9)
    assert one.value == pytest.approx(0.1, abs=0.02)
    assert not below(proved(gouge="report"))  # 100 mm above it


def test_axes_that_are_found_freely_keep_off_the_table(monkeypatch):
    take_nodes(monkeypatch, NODES)
    assert not below(proved(origin=ON_TABLE, tool_axis="auto", passes="scallop", stepover=None, scallop=0.3))


def test_bounds_that_clear_the_whole_way_lie_just_below_its_lowest_point():
    """The ball's lowest point is 3 mm below the work zero, see above: a bound that clears less would only be
    slow, one that clears more would hide a collision."""
    outcome = proved(origin=ON_TABLE, gouge="report").draft
    body, swept = (
        tool_body(outcome.settings),
        program_motion(outcome.kinematics, outcome.program, tip_to_driven(outcome.settings)),
    )
    assert stays_above(-3.1, body, swept)
    assert not stays_above(-2.99, body, swept)
    assert not stays_above(-100.0, Body(()), swept)


def test_a_way_that_bends_is_cleared_only_below_its_bend():
    """On its way the tip goes lower than at both ends."""
    outcome = proved(gouge="off").draft
    body, back = tool_body(outcome.settings), tip_to_driven(outcome.settings)
    for program in (swung(outcome, side) for side in (1.0, -1.0)):
        swept = program_motion(outcome.kinematics, program, back)
        lowest = swept.pose(np.zeros(101, np.int64), np.linspace(0.0, 1.0, 101)).tip[2].min()
        assert not stays_above(lowest - 2.0, body, swept)


def test_the_shank_counts():
    thin = proved(gouge="report")
    thick = proved(gouge="report", cutter="ball:6:8", shank="30x40")
    assert not lowest(thin, -4.0)
    (one,) = lowest(thick, -4.0)
    assert "shank" in str(one.text) and one.value > 5.0


def test_nothing_is_looked_at_where_gouges_are_not_or_the_table_is_not_known():
    assert not below(proved(origin=ON_TABLE, gouge="off"))
    assert not below(proved(origin=(0.0, 0.0, -150.0), gouge="report"))


def swung(outcome, side):
    """A program of one rapid from the tool upright 50 mm above the work zero to the tool level there:
    half-way it is 29 mm lower."""
    words = np.zeros((2, 5))
    words[:, 2] = 50.0, -50.0
    words[1, 1], words[1, outcome.program.letters.index("A")] = side * 100.0, 90.0
    rows, one = slice(0, 2), outcome.program
    columns = {name: getattr(one, name)[rows] for name in ("feed", "inverse_time", "seconds", "row", "line")}
    return replace(one, words=words, motion=np.full(2, Motion.RAPID, np.int8), **columns)


def test_a_rapid_that_misses_the_table_interpolated_goes_below_it_where_one_axis_comes_after_the_other():
    """A turns about a line 50 mm below the work zero: with A first, or Y and Z first, the tip comes down to
    that height."""
    outcome = proved(gouge="off").draft
    back = tip_to_driven(outcome.settings)
    (program,) = [
        one for one in (swung(outcome, side) for side in (1.0, -1.0))
        if forward(outcome.kinematics, words_to_q(one.words))[0][1, 2] == pytest.approx(50.0, abs=1e-6)
    ]  # fmt: skip
    assert table_slab(-20.0, outcome.kinematics, program).vertex[:, 2].max() == -20.0

    def found(height, rapids):
        return check_table(
            height, tool_body(outcome.settings), outcome.kinematics, program, 0.01, back, rapids=rapids
        )

    assert not found(-20.0, INTERPOLATED)
    (one,) = found(-20.0, INDEPENDENT)
    assert one.value == pytest.approx(3.0, abs=0.1) and "at least" in str(
        one.text
    )  # 33 mm: more than the ball is thick
    assert not found(-54.0, INDEPENDENT)
    assert not found(19.0, INTERPOLATED)
    assert found(
        20.5, INTERPOLATED
    )  # half-way the tip is at 20.71 and leans by 45 deg: the ball's lowest place is at 19.83
