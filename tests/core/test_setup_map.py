# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of setups: against full runs, its proof of the least deviation, and what is said of it."""

import json
import math
import re
from dataclasses import replace

import numpy as np
import pytest
from plain import build_settings
from setup_examples import CENTRE, cap, milled, posting
from thorough import some_in_core
from uncured import UNCURED

from freecad_fiveaxis.core.base.errors import Cancelled, ReachError, SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, linear_words
from freecad_fiveaxis.core.motion.deviation import measure, measure_above, quick_bound
from freecad_fiveaxis.core.motion.joint_path import solve
from freecad_fiveaxis.core.motion.program import build_program
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.report import Marker, summary
from freecad_fiveaxis.core.report.figures import feed_blocks
from freecad_fiveaxis.core.studies import study as trials
from freecad_fiveaxis.core.studies.setup_map import (  # fmt: skip
    Kind,
    Region,
    SetupMap,
    advice,
    heat_map_html,
    heat_maps,
    list_marked_rows,
    origin_option,
    part_box,
    setup_json,
    setup_map,
    setup_markers,
    setup_text,
    turn_path,
    verdict,
)
from freecad_fiveaxis.core.studies.setup_map.driven import (
    FIRST_BATCH,
    drive_turned,
    turn_points,
    worst_blocks,
)
from freecad_fiveaxis.core.studies.setup_map.setups import MOST_SETUPS, recommend_setup

COARSE = {"stepover": 12.0, "rings": 8}


def full_run(result, machine, origin, turn):
    """Deviation mm, rotary travel rad, time s and excess over limits mm of one setup, by the pipeline's own
    calls."""
    kinematics = chain(machine, Setup(tuple(origin), result.settings.machine.tool_length or 0.0))
    path, how = turn_path(result.path, turn), posting(result)
    joints = solve(path, kinematics, *part_box(path, how.part, turn), how.clearance, how.radius)
    program = build_program(joints, kinematics, how.dialect, how.inverse_time)
    segment = measure(kinematics, program.words).segment[feed_blocks(program)]
    over = np.maximum(joints.q[:, :3] - kinematics.high[:3], kinematics.low[:3] - joints.q[:, :3]).max()
    travel = np.abs(np.diff(np.radians(program.words[:, 3:]), axis=0)).sum()
    return segment.max(), travel, program.seconds.sum(), max(over, 0.0)


@pytest.fixture(scope="module")
def chart():
    """A map that has something of everything: three axes, two turns, places beyond the limits."""
    result = milled(**COARSE)
    region = Region((-700.0, -100.0, -90.0), (100.0, 120.0, 30.0), (3, 2, 2), (0.0, 0.7))
    return setup_map(result.path, result.machine, Setup((60.0, 10.0, -20.0)), region, posting(result), 0.01)


@some_in_core("machine", ["trunnion_ac", "trunnion_bc"])
def test_the_rotary_centre_is_found_for_a_spherical_part(machine):
    """Both rotary axes meet at (0, 0, z) of these machines; the ball's centre belongs there."""
    centre = np.array([0.0, 0.0, load_machine(machine).axes[0].point[2] - CENTRE])
    away = (100.0, 0.0, float(centre[2]))
    given = {
        "machine": machine,
        "stepover": 3.8,
        "origin": away,
        "grid": "1,1,1",
        "region": "120,120,50",
        "gouge": "off",
    }
    found = trials.try_setups(build_settings("setup", "cap.stl", given), mesh=cap()).chart
    result = milled(machine)
    at_centre = full_run(result, result.machine, centre, 0.0)[0]
    assert found.max_deviation[0] > 10.0 * found.max_deviation[found.best]
    assert found.max_deviation[found.best] <= 1.02 * at_centre + 1e-4
    assert np.linalg.norm(found.origin[found.best][:2]) < 3.8  # within a stepover of the table's axis
    assert found.least <= at_centre


@pytest.mark.slow
def test_the_map_agrees_with_a_full_run_at_20_random_setups():
    result, rng = milled(**COARSE), np.random.default_rng(4)
    low = rng.uniform(-200.0, 0.0, 3)
    region = Region(tuple(low), tuple(low + rng.uniform(50.0, 300.0, 3)), (3, 2, 2), (0.0, 0.7))
    chart = setup_map(result.path, result.machine, Setup((60.0, 10.0, -20.0)), region, posting(result))
    for row in rng.choice(len(chart.turn), 20, replace=False):
        run = full_run(result, result.machine, chart.origin[row], chart.turn[row])
        mapped = [
            column[row] for column in (chart.max_deviation, chart.rotary_travel, chart.time, chart.over)
        ]
        assert np.abs(np.subtract(mapped, run)).max() <= 1e-6
    assert (
        abs(
            mapped[0]
            - full_run(result, result.machine, chart.origin[row] + (1.0, 0.0, 0.0), chart.turn[row])[0]
        )
        > 1e-6
    )


@some_in_core("machine", ["mikron_ucp710", "head_b_table_c", "nutating_table_b45"])
def test_the_map_agrees_with_a_full_run_on_other_chains(machine):
    result = milled(machine, tool_length=80.0, **COARSE)
    region = Region((-50.0, -30.0, 0.0), (40.0, 60.0, 90.0), (2, 1, 1), (1.0,))
    chart = setup_map(result.path, result.machine, Setup((10.0, 10.0, 10.0), 80.0), region, posting(result))
    for row in range(len(chart.turn)):
        run = full_run(result, result.machine, chart.origin[row], chart.turn[row])
        mapped = [
            column[row] for column in (chart.max_deviation, chart.rotary_travel, chart.time, chart.over)
        ]
        assert np.abs(np.subtract(mapped, run)).max() <= 1e-6


@pytest.mark.thorough
def test_a_part_turned_in_cad_as_advised_deviates_as_the_map_says():
    """The solid turned about Z, the passes' direction by as much: `mill` makes the same cuts, at the work
    zero of the map."""
    off, turn = (
        from_faces(cap(rings=8, sectors=24).vertex + (15.0, 5.0, 0.0), cap(rings=8, sectors=24).face),
        math.radians(120.0),
    )
    given = {"machine": "trunnion_ac", "stepover": 12.0}
    wanted = {"grid": "1,1,1", "region": "30,30,0", "turns": 3, "gouge": "off"}
    chart = trials.try_setups(build_settings("setup", "cap.stl", given | wanted), mesh=off).chart
    row = int(np.flatnonzero((chart.kind == Kind.FOUND) & (np.abs(chart.turn - turn) < 1e-9))[0])
    given |= {"direction": 120.0, "origin": chart.origin[row].tolist()}
    result = job.make(
        build_settings("mill", "cap.stl", {**given, **UNCURED}),
        mesh=from_faces(turn_points(off.vertex, turn), off.face),
    )
    centre = result.settings.cutter.cutter.radius
    found = measure_above(result.kinematics, result.program.words, centre, result.dialect.linear_decimals)
    segment = found.segment[feed_blocks(result.program)]
    assert segment.max() == pytest.approx(chart.max_deviation[row], abs=1e-6)


@pytest.mark.parametrize(
    ("cutter", "whose", "name"),
    [("ball:10", "max_surface_deviation", "centre"), ("flat:6", "max_segment_deviation", "tip")],
)
def test_a_setup_is_judged_by_what_the_verdict_of_its_program_goes_by(cutter, whose, name):
    """Of a ball by its centre, which makes the surface; the tip's deviation is another one."""
    given = {"machine": "trunnion_ac", "stepover": 8.0, "cutter": cutter, **UNCURED}
    given["origin"], part = (60.0, 10.0, -20.0), cap(rings=10, sectors=30)
    wanted = build_settings("setup", "cap.stl", {**given, "grid": "2,2,1"})
    tried = trials.try_setups(wanted, mesh=part)
    run = job.prove(job.make(build_settings("mill", "cap.stl", given), mesh=part))
    numbers = summary(job.figures(run))
    assert tried.chart.max_deviation[0] == pytest.approx(numbers[whose], abs=1e-6)
    assert json.loads(setup_json(tried.chart))["deviation_of"] == name
    assert ("ball's centre" if name == "centre" else "of the tip") in verdict(tried.chart)
    if name == "centre":
        assert abs(numbers["max_segment_deviation"] - numbers[whose]) > 0.005


def test_the_present_row_is_what_mill_reports(chart):
    result = milled(**COARSE, origin=(60.0, 10.0, -20.0))
    segment = measure(result.kinematics, result.program.words).segment[feed_blocks(result.program)]
    assert chart.max_deviation[0] == pytest.approx(segment.max(), abs=1e-9)
    assert chart.time[0] == pytest.approx(result.program.seconds.sum(), abs=1e-9)


@pytest.mark.thorough
@pytest.mark.parametrize("above", [0.0, 5.0])
def test_the_deviation_is_convex_in_the_work_zero(above):
    """What the proof rests on: at the middle of two work zeros it is no more than the mean, but for the
    rounding of words; of the tip and of a point on the axis alike."""
    result, rng = milled(**COARSE), np.random.default_rng(1)
    posted = replace(posting(result), above=above)
    driven = drive_turned(result.path, result.machine, Setup(), posted, 0.3)
    for _ in range(12):
        a, b = rng.uniform(-150.0, 150.0, (2, 3))
        ends = [driven.cost(one).deviation for one in (a, b)]
        assert driven.cost(0.5 * (a + b)).deviation <= 0.5 * sum(ends) + 5e-4


@pytest.mark.thorough
@pytest.mark.parametrize("above", [0.0, 5.0])
def test_no_work_zero_has_less_than_the_proven_least(above):
    result, rng = milled(**COARSE), np.random.default_rng(2)
    region = Region((-80.0, -80.0, -80.0), (80.0, 80.0, 80.0), (1, 1, 1))
    posted = replace(posting(result), above=above)
    chart = setup_map(result.path, result.machine, Setup((70.0, 0.0, 0.0)), region, posted)
    driven = drive_turned(result.path, result.machine, Setup(), posted, 0.0)
    around = np.concatenate(
        [rng.uniform(-80.0, 80.0, (20, 3)), chart.origin[-1] + rng.normal(0.0, 3.0, (20, 3))]
    )
    tried = [driven.cost(origin).deviation for origin in around]
    assert min(tried) >= chart.least - 5e-4
    assert (
        chart.max_deviation[-1] <= 1.02 * chart.least + 1e-3
    )  # the place that was found is as good as the proof
    assert min(tried) < 1.3 * chart.least  # a least of nothing would prove nothing


def test_where_no_direction_matters_the_part_stays():
    """Of a machine whose both axes are in the head the deviation does not depend on the work zero at all."""
    result = milled("fork_head_bc", tool_length=80.0, **COARSE)
    region = Region((-50.0, -50.0, -50.0), (50.0, 50.0, 50.0), (2, 1, 1))
    chart = setup_map(result.path, result.machine, Setup((0.0, 0.0, 0.0), 80.0), region, posting(result))
    assert chart.origin[chart.best] == pytest.approx([0.0, 0.0, 0.0], abs=1e-3)
    assert verdict(chart).startswith("The present setup is as good as any")


def of_rows(deviation, best, rewinds=(0, 0, 0), time=(60.0, 60.0, 60.0), present=0.0, enough=0.0):
    """A map of three setups: the present one, one of the grid, one that was found."""
    zeros, yes = np.zeros(3), np.ones(3, bool)
    return SetupMap(
        machine="trunnion_ac", base=Setup((present, 0.0, 0.0)), region=Region((-1.0,) * 3, (1.0,) * 3),
        origin=np.array([[present, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 0.0, 0.0]]), turn=zeros,
        max_deviation=np.array(deviation), rotary_travel=zeros, time=np.array(time), over=zeros,
        within_limits=yes, stands=yes, rewinds=np.array(rewinds), kind=np.array([0, 1, 2], np.int8), best=best,
        least=min(deviation), table=0.0, bottom=0.0, hits=np.full(3, np.nan), enough=enough,
    )  # fmt: skip


def recommended(chart):
    within = chart.able & chart.region.holds(chart.origin)
    base, columns = chart.base.origin, (chart.max_deviation, chart.time, chart.rewinds)
    return recommend_setup(chart.origin, base, *columns, within, chart.enough)


@pytest.mark.parametrize("share", [1.0, 1.009, 1.011, 1.048, 1.06])
@pytest.mark.parametrize("enough", [0.0, 1.03])
def test_sentence_option_and_footnote_go_by_one_threshold(share, enough):
    """A present setup 4.8 % above the least was called as good as any, above another one to give."""
    chart = of_rows((share, 1.0, 1.0), None, enough=enough)
    chart = replace(chart, best=recommended(chart))
    stays = share <= max(1.01, enough)
    assert chart.level == pytest.approx(max(1.0101, enough))
    assert verdict(chart).startswith("The present setup is as good as any") == stays
    assert (origin_option(chart) == "--origin=0,0,0") == stays
    assert ("instead of" in verdict(chart)) == (not stays)
    assert ("equally good" in setup_text(chart)) == (stays and share > 1.0)


@pytest.mark.parametrize(
    ("given", "why"),
    [
        ({"rewinds": (2, 0, 0)}, "turns back more often"),
        ({"time": (70.0, 60.0, 60.0)}, "takes longer"),
        ({"present": 1.5}, "lies outside the region"),
    ],
)
def test_a_present_setup_as_good_in_deviation_is_left_for_what_is_named(given, why):
    chart = of_rows((1.005, 1.0, 1.0), None, **given)
    chart = replace(chart, best=recommended(chart))
    assert chart.best and f"as good as 1.005 mm in the present setup, which {why}." in verdict(chart)
    assert "times less" not in verdict(chart)


def test_limits_are_reported_where_they_are_left(chart):
    result = milled(**COARSE)
    assert not chart.within_limits.all() and chart.within_limits.any()
    assert (chart.within_limits == (chart.over <= 1e-6)).all()
    row = int(chart.over.argmax())
    assert chart.over[row] == pytest.approx(
        full_run(result, result.machine, chart.origin[row], chart.turn[row])[3], abs=1e-6
    )
    assert chart.within_limits[chart.best]


def test_a_region_that_leaves_every_limit_recommends_nothing_and_tells_by_how_much():
    result = milled(**COARSE)
    region = Region((900.0, -10.0, -10.0), (1000.0, 10.0, 10.0), (2, 1, 1))
    chart = setup_map(result.path, result.machine, Setup(), region, posting(result))
    assert chart.best is None and not chart.within_limits[chart.kind == Kind.GRID].any()
    (finding,) = [one for one in chart.findings if one.code != "table-unknown"]
    assert finding.code == "no-setup-within-limits"
    assert (
        0.9 * chart.over[chart.kind == Kind.GRID].min()
        <= finding.value
        <= chart.over[chart.kind == Kind.GRID].min() + 1e-6
    )
    assert verdict(chart).startswith("No setup") and advice(chart) == () and origin_option(chart) == ""
    assert "No setup" in heat_map_html(chart) and setup_markers(chart)[0].kind == "setup-present"


UNKNOWN = "The height of the table is not known: check that the part stands on it"


@pytest.mark.oldest
@pytest.mark.thorough
def test_no_setup_below_the_table_is_recommended_and_such_setups_are_greyed():
    result = milled(**COARSE)
    bottom = min(result.mesh.vertex[:, 2].tolist())
    table = bottom - 10.0  # the work zero must stand at Z -10 or higher
    region = Region((-50.0, -50.0, -90.0), (50.0, 50.0, 30.0), (2, 2, 4))
    free = setup_map(result.path, result.machine, Setup((0.0, 0.0, -20.0)), region, posting(result))
    chart = setup_map(
        result.path, result.machine, Setup((0.0, 0.0, -20.0)), region, posting(result), table=table
    )
    assert free.origin[free.best, 2] < -10.0 <= chart.origin[chart.best, 2]  # the table is what decides
    below = chart.origin[:, 2] + bottom < table - 1e-6
    assert below.any() and np.array_equal(chart.stands, ~below) and free.stands.all()
    assert {kind for row, kind in list_marked_rows(chart) if below[row]} == {
        "setup-present",
        "setup-beyond-limits",
    }
    assert "mm above the table" in verdict(
        chart
    ) and "In the present setup the part reaches below the table" in verdict(chart)
    assert UNKNOWN not in verdict(chart) and "below the table" in setup_text(chart)
    reported = [one for one in chart.findings if one.code == "part-below-table"]
    assert len(reported) == 1 and reported[0].value == pytest.approx(-10.0)
    assert chart.least >= free.least - 1e-9  # proven of what stands
    record = json.loads(setup_json(chart))
    assert (
        record["table"] == pytest.approx(table)
        and [one["on_table"] for one in record["setups"]] == (~below).tolist()
    )


def test_a_table_that_is_not_known_is_stated(chart):
    assert chart.table is None and verdict(chart).endswith(UNKNOWN + ".")
    assert [one.code for one in chart.findings].count("table-unknown") == 1


def test_a_region_that_lies_below_the_table_recommends_nothing():
    result = milled(**COARSE)
    region = Region((-50.0, -50.0, -90.0), (50.0, 50.0, -60.0), (2, 2, 1))
    chart = setup_map(result.path, result.machine, Setup(), region, posting(result), table=500.0)
    assert chart.best is None and chart.findings[0].code == "no-setup-on-the-table"
    assert "the part on the table" in verdict(chart)


@pytest.mark.parametrize(
    ("low", "high", "count", "turns", "named"),
    [((0, 0, 0), (-1, 0, 0), (1, 1, 1), (0.0,), "swap"), ((0, 0, 0), (1, 1, 1), (0, 1, 1), (0.0,), "at least 1"),
     ((0, 0, 0), (1, 1, 1), (1, 1, 1), (), "at least 1"), ((0, 0, 0), (math.inf, 1, 1), (1, 1, 1), (0.0,), "finite"),
     ((0, 0, 0), (1, 1, 1), (200, 200, 1), (0.0,), str(MOST_SETUPS))],
)  # fmt: skip
def test_a_region_that_is_none_is_refused(low, high, count, turns, named):
    with pytest.raises(SettingsError, match=named):
        Region(low, high, count, turns)


def test_what_cannot_be_mapped_is_refused():
    result = milled(**COARSE)
    empty = replace(
        result.path,
        **{
            name: getattr(result.path, name)[:0]
            for name in result.path.__dataclass_fields__
            if name != "findings"
        },
    )
    region = Region((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), (1, 1, 1))
    with pytest.raises(SettingsError, match="no rows"):
        setup_map(empty, result.machine, Setup(), region, posting(result))
    with pytest.raises(SettingsError, match="0 or more"):
        setup_map(result.path, result.machine, Setup(), region, posting(result), -1.0)


def test_a_machine_whose_rotary_limits_allow_no_way_is_refused():
    result = milled(**COARSE)
    beneath = replace(result.path, axis=result.path.axis * (1.0, 1.0, -1.0))  # from below
    with pytest.raises(ReachError):
        setup_map(
            beneath,
            load_machine("mikron_ucp710"),
            Setup(),
            Region((0, 0, 0), (1, 1, 1), (1, 1, 1)),
            posting(result),
        )


@pytest.mark.parametrize(
    ("deviation", "time", "rewinds", "within", "enough", "best"),
    [([3, 1, 2], [1, 9, 1], [0, 0, 0], [1, 1, 1], 0.0, 1), ([3, 1, 2], [1, 9, 1], [0, 0, 0], [1, 0, 1], 0.0, 2),
     ([3, 1, 2], [1, 9, 1], [0, 0, 0], [0, 0, 0], 0.0, None), ([3, 1, 2], [5, 9, 1], [0, 0, 0], [1, 1, 1], 5.0, 2),
     ([1, 1, 1], [1, 1, 1], [1, 0, 1], [1, 1, 1], 0.0, 1), ([1, 1, 1], [1, 1, 1], [0, 0, 0], [1, 1, 1], 0.0, 0),
     ([math.nan, 1, 2], [1, 1, 1], [0, 0, 0], [1, 1, 1], 0.0, 1)],
)  # fmt: skip
def test_the_recommended_one_deviates_least_then_rewinds_least_then_is_quickest_then_nearest(
    deviation, time, rewinds, within, enough, best
):
    origin = np.array([[0.0, 0, 0], [5, 0, 0], [9, 0, 0]])
    columns = (np.array(deviation, float), np.array(time, float), np.array(rewinds), np.array(within, bool))
    assert recommend_setup(origin, (0.0, 0.0, 0.0), *columns, enough) == best


def test_a_part_is_turned_only_where_that_gains():
    """The same place half a turn about C, to a hair better, is the same setup; a turn that gains is taken."""
    origin, base = np.array([[-17.6, 10.3, 0.0], [17.6, -10.3, 0.0], [17.6, -10.3, 0.0]]), (17.6, -10.3, 0.0)
    turn, alike, one = np.array([0.0, math.pi, -math.pi]), np.ones(3), np.zeros(3, np.int64)
    within = np.ones(3, np.bool_)
    near = np.array([1.421231, 1.421186, 1.421186])
    assert recommend_setup(origin, base, near, alike, one, within, 0.0, turn) == 0
    assert recommend_setup(origin, base, near, alike, one, within, 0.0) == 1
    assert recommend_setup(origin, base, np.array([2.0, 1.0, 1.0]), alike, one, within, 0.0, turn) == 1
    assert (
        recommend_setup(origin, base, near, alike, one, within, 0.0, np.array([2.0 * math.pi, 3.0, 3.0])) == 0
    )
    quarters = np.array([1.0, 0.5 * math.pi, 1.5 * math.pi])  # to one side and to the other: the nearer one
    apart, wanted = np.array([[0.0, 0.0, 0.0], [50.0, 0.0, 0.0], [1.0, 0.0, 0.0]]), np.arange(3) > 0
    assert recommend_setup(apart, (0.0, 0.0, 0.0), alike, alike, one, wanted, 0.0, quarters) == 2


def test_why_another_than_the_least_is_recommended_is_stated(chart):
    """The recommended one may deviate by 1 % more where it is nearer."""
    able = np.flatnonzero(chart.able)
    least, other = able[np.argsort(chart.max_deviation[able])[:2]].tolist()
    close = chart.max_deviation.copy()
    close[other] = 1.005 * close[least]
    stated = [
        "are equally good" in " ".join(setup_text(replace(chart, best=best, max_deviation=close)).split())
        for best in (least, other)
    ]
    assert stated == [False, True]


def test_markers_stand_at_places_of_the_map_in_work_coordinates(chart):
    result = setup_markers(chart)
    assert all(isinstance(one, Marker) for one in result)
    assert [one.kind for one in result[:2]] == ["setup-best", "setup-present"]
    assert result[0].place == pytest.approx(chart.origin[chart.best] - np.array(chart.base.origin))
    assert (
        result[1].place == (0.0, 0.0, 0.0)
        and result[1].label == f"work zero now: {chart.max_deviation[0]:.4f} mm"
    )
    grid = chart.origin[(chart.kind == Kind.GRID) & (chart.turn == chart.turn[chart.best])] - np.array(
        chart.base.origin
    )
    assert sorted(one.place for one in result[2:]) == sorted(map(tuple, grid.tolist()))
    assert {one.kind for one in result[2:]} == {"setup", "setup-beyond-limits"}


def test_the_page_needs_nothing_else_and_the_pictures_have_units(chart):
    page = heat_map_html(chart, "cap.stl")
    assert verdict(chart) in page and origin_option(chart) in page and page.count("data:image/svg+xml") == 4
    assert not re.search(r'(src|href)="(?!data:)', page) and "<script" not in page
    for axes in ("along X and Y", "along X and Z", "along Y and Z"):
        assert re.search(rf'alt="Largest deviation over the work zero {axes}: from [^"]+ mm\."', page)
    assert "What turning the part brings" in page


@pytest.mark.thorough
def test_a_region_along_one_axis_is_drawn_as_a_curve():
    result = milled(**COARSE)
    chart = setup_map(
        result.path,
        result.machine,
        Setup(),
        Region((-9.0, 0.0, 0.0), (9.0, 0.0, 0.0), (3, 1, 1)),
        posting(result),
    )
    (plot,), (again,) = heat_maps(chart), heat_maps(chart)
    assert plot.name == "curve-x" and b"<svg" in plot.svg and plot == again  # the same bytes again


def test_the_text_says_what_to_give_to_mill(chart):
    text = setup_text(chart)
    x, y, z = (float(part) for part in re.search(r"--origin=(\S+)", text).group(1).split(","))
    assert (x, y, z) == pytest.approx(chart.origin[chart.best], abs=1e-4)
    is_turned = chart.turn[chart.best] != 0.0
    assert ("turn the part in CAD" in text) == ("--direction" in text) == is_turned


def test_the_json_has_every_setup_in_degrees_and_no_nan(chart):
    record = json.loads(setup_json(chart, {"task": "setup"}))
    assert len(record["setups"]) == len(chart.turn) == 1 + 24 + 2 and record["inputs"] == {"task": "setup"}
    best = record["setups"][record["best"]]
    assert best["max_deviation"] == chart.max_deviation[chart.best]
    assert {one["turn_deg"] for one in record["setups"]} == {0.0, math.degrees(0.7)}


def test_progress_runs_from_0_to_1_and_may_be_cancelled():
    result, seen = milled(**COARSE), []
    region = Region((-9.0, 0.0, 0.0), (9.0, 0.0, 0.0), (2, 1, 1))
    setup_map(
        result.path,
        result.machine,
        Setup(),
        region,
        posting(result),
        progress=lambda stage, fraction: seen.append(fraction),
    )
    assert seen == sorted(seen) and seen[0] == 0.0 and seen[-1] == 1.0 and len(seen) > 5

    def stop(stage, fraction):
        if fraction > 0.3:
            raise Cancelled(stage)

    with pytest.raises(Cancelled):
        setup_map(result.path, result.machine, Setup(), region, posting(result), progress=stop)


def test_the_worst_block_is_found_behind_many_whose_bound_promises_more():
    """Turns that the linear axes make up for deviate by a third of their quick bound, a turn alone by all of
    it."""
    machine = load_machine("trunnion_ac")
    kinematics = chain(machine, Setup(machine.origin))
    result_up, alone, count = np.radians(7.0), np.radians(9.5), FIRST_BATCH + 40
    place = kinematics.point1 + (200.0, 0.0, 20.0)
    turns = np.array([[0.0, 0.0], [result_up, 0.0]])
    pair = np.column_stack([linear_words(kinematics, np.tile(place, (2, 1)), turns), np.degrees(turns)])
    still = np.column_stack(
        [
            linear_words(kinematics, kinematics.point1[None] + (120.0, 0.0, 20.0), np.zeros((1, 2))),
            np.zeros((1, 2)),
        ]
    )
    words = np.concatenate(
        [np.tile(pair, (count, 1)), still, still + (0.0, 0.0, 0.0, np.degrees(alone), 0.0)]
    )
    feeds = np.arange(1, len(words), 2)
    bound, segment = quick_bound(kinematics, words)[feeds], measure(kinematics, words).segment[feeds]
    assert (
        segment.argmax() == count and (bound[:-1] > bound[-1]).all() and segment[:-1].max() > 0.3 * bound[-1]
    )
    worst = worst_blocks(kinematics, words, feeds)
    assert worst.row[0] == feeds[-1] and worst.segment[0] == pytest.approx(
        120.0 * (1.0 - np.cos(0.5 * alone)), rel=1e-6
    )
