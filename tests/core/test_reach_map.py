# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the tool gets: areas in closed form, every reachable place looked at by dense samples, and each
reason on a part made for it."""

import json
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from gouge_examples import dense_points, sampled_depth
from test_fewer_axes import MACHINES
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import Cancelled
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge import still_positions
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.gouge.obstacles import Obstacle, Reacher, tip_at
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.studies import reach_map as module
from freecad_fiveaxis.core.studies import reach_report
from freecad_fiveaxis.core.studies.reach_map import reach_map
from freecad_fiveaxis.core.studies.smaller_ball import smaller_ball
from freecad_fiveaxis.core.tool import Cutter

BALL = Cutter(6.0, 30.0)
HOLDER = ((40.0, 30.0),)


def rectangle(a, b, c, d):
    """Two triangles over four corners, counter-clockwise seen from outside."""
    return [[a, b, c], [a, c, d]]


def profile(outline, length):
    """A prism along Y over an outline (x, z), counter-clockwise seen from -Y; its ends are left open."""
    found = []
    for (x, z), (u, w) in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        found += rectangle((x, 0, z), (x, length, z), (u, length, w), (u, 0, w))
    return from_triangles(np.array(found, float))


def block():
    """40 x 30 x 20 mm, standing on Z 0, without its ends."""
    return profile(np.array([(0, 0), (40, 0), (40, 20), (0, 20)]), 30.0)


def slot(width, depth, length=30.0):
    """A block 60 mm wide and ``depth`` + 10 high with a slot down its middle, open at both ends."""
    low, high, half = 0.0, depth + 10.0, 0.5 * width
    return profile(
        np.array(
            [
                (-30, low),
                (30, low),
                (30, high),
                (half, high),
                (half, 10),
                (-half, 10),
                (-half, high),
                (-30, high),
            ]
        ),
        length,
    )


def test_a_block_on_the_table_is_reached_but_for_its_underside_and_a_strip_as_high_as_the_ball():
    found = reach_map(block(), Reacher(BALL, table=0.0))
    sides, top = 2 * 30.0 * 20.0, 40.0 * 30.0
    row = 30.0 * 2 * found.spacing  # the strip's edge may lie within a row of places on either side
    assert found.area.sum() == pytest.approx(sides + 2 * top)
    assert found.spacing == pytest.approx(math.sqrt(found.area.sum() / 10_000))
    assert found.area_of(Obstacle.NONE) == pytest.approx(top + sides * (20.0 - 3.0) / 20.0, abs=row)
    assert found.area_of(Obstacle.TABLE) == pytest.approx(top + sides * 3.0 / 20.0, abs=row)
    free = reach_map(block(), Reacher(BALL))
    assert free.area_of(Obstacle.NONE) == pytest.approx(sides + 2 * top) and not free.tilt.any()


def test_a_slot_narrower_than_the_ball_is_tighter_than_the_cutter():
    """Its floor and all of its walls but what the ball's lower half leaves free at the mouth: a ball on the
    wall stands 3 mm from it, and the other wall is 5 mm off, so only above the mouth's edge less nothing."""
    found = reach_map(slot(5.0, 20.0), Reacher(BALL))
    assert found.area_of(Obstacle.CUTTER) == pytest.approx(30.0 * (5.0 + 2 * 20.0), rel=0.12)
    assert found.area_of(Obstacle.SHANK) == found.area_of(Obstacle.HOLDER) == 0.0


def on_floor(found, length):
    """The places on a slot's floor that a ball may touch, far from its open ends."""
    x, y, z = found.point.T
    return np.isclose(z, 10.0) & (np.abs(x) < 3.5) & (np.abs(y - 0.5 * length) < 10.0)


@pytest.fixture
def coarse(monkeypatch):
    monkeypatch.setattr(module, "PLACES", 500)


@pytest.fixture
def coarsest(monkeypatch):
    monkeypatch.setattr(module, "PLACES", 200)


@pytest.mark.thorough
def test_a_holder_wider_than_a_deep_slot_is_in_the_way_of_its_floor(coarsest):
    short, mesh = Reacher(Cutter(6.0, 20.0), holder=HOLDER), slot(14.0, 30.0, 160.0)
    found = reach_map(mesh, short)
    floor = on_floor(found, 160.0)
    assert (found.obstacle[floor] == Obstacle.HOLDER).all() and floor.any()
    step, area = found.longer[-1]
    assert step >= 10.0 and area >= 0.95 * found.area[floor].sum()
    longer = reach_map(mesh, replace(short, shank=((6.0, step),)))
    assert (longer.obstacle[floor] == Obstacle.NONE).all()
    free = reach_map(block(), short)
    assert (free.obstacle == Obstacle.NONE).all() and free.longer == ()


def test_a_thick_shank_is_named_as_such(coarsest):
    found = reach_map(slot(14.0, 30.0, 160.0), Reacher(Cutter(6.0, 10.0), shank=((13.0, 40.0),)))
    floor = on_floor(found, 160.0) & (np.abs(found.point[:, 0]) > 1.0)
    assert (found.obstacle[floor] == Obstacle.SHANK).all() and floor.any()


def test_what_the_machine_cannot_turn_to_is_beyond_its_limits(coarse):
    """No tilt up to 80 deg brings the tool to the underside of a part on a machine that stays within 30
    deg."""
    machine = load_machine("trunnion_ac")
    kinematics = chain(machine, Setup(machine.origin))
    low, high = kinematics.low.copy(), kinematics.high.copy()
    low[4], high[4] = -math.radians(30.0), math.radians(30.0)  # A
    found = reach_map(block(), Reacher(BALL, kinematics=replace(kinematics, low=low, high=high)))
    under = np.isclose(found.point[:, 2], 0.0)
    assert (found.obstacle[under] == Obstacle.LIMITS).all()
    assert np.degrees(np.arccos(found.axis[~under, 2])).max() <= 30.0 + 1e-9
    side = ~under & (found.point[:, 2] < 19.0)
    assert (found.tilt[side] >= math.radians(60.0) - 1e-9).all() and (
        found.obstacle[side] == Obstacle.NONE
    ).all()


@pytest.mark.oldest
@pytest.mark.thorough
def test_what_stopped_the_luckiest_axis_is_named_though_later_ones_are_beyond_the_limits(coarsest):
    """On a slot's floor all axes up to 30 deg meet the holder, all farther ones are none of this
    machine's."""
    machine, mesh = load_machine("trunnion_ac"), slot(14.0, 30.0, 160.0)
    kinematics = chain(machine, Setup(machine.origin))
    low, high = kinematics.low.copy(), kinematics.high.copy()
    low[4], high[4] = -math.radians(30.0), math.radians(30.0)  # A
    short = Reacher(Cutter(6.0, 20.0), holder=HOLDER, kinematics=replace(kinematics, low=low, high=high))
    found = reach_map(mesh, short, np.isclose(mesh.vertex[mesh.face][:, :, 2], 10.0).all(axis=1))
    floor = on_floor(found, 160.0)
    assert (found.obstacle[floor] == Obstacle.HOLDER).all() and floor.any()


CUTTERS = [Cutter(6.0, 20.0), Cutter(6.0, 20.0, 0.0), Cutter(8.0, 20.0, 2.0)]


@some_in_core("cutter", CUTTERS, ids=["ball", "flat", "bull"])
def test_at_every_place_called_reachable_the_tool_is_free_by_dense_samples(cutter, coarse):
    mesh, reacher = slot(14.0, 12.0), Reacher(cutter, holder=HOLDER, limit=0.01)
    found = reach_map(mesh, reacher)
    free = np.flatnonzero(found.obstacle == Obstacle.NONE)
    assert len(free) > 300
    some = free[:: len(free) // 60]
    tips = tip_at(cutter, found.point[some], mesh.normal[found.facet[some]], found.axis[some])
    points, swept = dense_points(mesh, 0.5), still_positions(tips, found.axis[some])
    assert max(sampled_depth(reacher.body, points, swept, k, 1) for k in range(len(some))) <= 0.01 + 1e-9


def test_without_the_look_at_the_holder_the_samples_find_it_in_the_part(coarse):
    mesh, reacher = slot(14.0, 30.0), Reacher(Cutter(6.0, 20.0), holder=HOLDER)
    found = reach_map(mesh, replace(reacher, holder=()))
    free = np.flatnonzero((found.obstacle == Obstacle.NONE) & np.isclose(found.point[:, 2], 10.0))
    tips = tip_at(reacher.cutter, found.point[free], mesh.normal[found.facet[free]], found.axis[free])
    points, swept = dense_points(mesh, 0.5), still_positions(tips, found.axis[free])
    assert max(sampled_depth(reacher.body, points, swept, k, 1) for k in range(len(free))) > 1.0


def test_a_flat_bottom_reaches_the_floor_up_to_the_wall_because_its_edge_may_touch(coarse):
    found = reach_map(slot(20.0, 12.0), Reacher(Cutter(6.0, 20.0, 0.0)))
    floor = np.isclose(found.point[:, 2], 10.0)
    assert (found.obstacle[floor] == Obstacle.NONE).mean() > 0.95


def test_only_chosen_facets_are_looked_at_and_progress_can_stop():
    mesh = block()
    top = mesh.normal[:, 2] > 0.9
    found = reach_map(mesh, Reacher(BALL), top)
    assert found.area.sum() == pytest.approx(1200.0) and top[found.facet].all()

    def stop(stage, share):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        reach_map(mesh, Reacher(BALL), None, stop)


@pytest.mark.thorough
def test_more_places_change_little(monkeypatch):
    """It is sampled: the area found converges."""
    few = reach_map(slot(14.0, 20.0), Reacher(BALL, holder=HOLDER)).area_of(Obstacle.NONE)
    monkeypatch.setattr(module, "PLACES", 20_000)
    many = reach_map(slot(14.0, 20.0), Reacher(BALL, holder=HOLDER)).area_of(Obstacle.NONE)
    assert many == pytest.approx(few, rel=0.03)


@pytest.fixture
def part(tmp_path):
    path = tmp_path / "part.stl"
    write_stl(slot(14.0, 30.0), path)
    return path


def test_the_command_line_writes_every_report(part, tmp_path, capsys, coarse):
    words = ["reach", str(part), "--machine", "trunnion_ac", "--cutter", "ball:6:20", "--holder", "40x30"]
    outputs = [str(tmp_path / f"reach{ending}") for ending in (".json", ".html", ".txt")]
    assert cli.main([*words, *(word for path in outputs for word in ("--report", path))]) == cli.DONE
    message = capsys.readouterr().out
    summary = json.loads((tmp_path / "reach.json").read_text())["summary"]
    assert summary["reachable_area"] + sum(summary["by_reason"].values()) == pytest.approx(summary["area"])
    assert sum(row["area"] for row in summary["by_tilt"]) == pytest.approx(summary["reachable_area"])
    assert summary["by_reason"]["holder"] > 20.0 and summary["stick_out"]
    assert "holder in the way" in message and "Let the tool stick out" in message
    assert "holder in the way" in (tmp_path / "reach.html").read_text()


def test_a_part_that_would_lie_in_the_table_is_looked_at_without_one_and_that_is_stated(
    tmp_path, capsys, coarse
):
    """The block stands on Z 0 of the work: 30 mm below the table where the work zero is, on it where it is 30
    mm higher."""
    path, report = tmp_path / "block.stl", tmp_path / "a.json"
    write_stl(block(), path)
    words = ["reach", str(path), "--machine", "trunnion_ac", "--cutter", "ball:6:30"]
    words += ["--table-height", "30", "--report", str(report)]
    shares = {}
    for height in (0, 30):
        assert cli.main([*words, "--origin", f"0,0,{height}"]) == cli.DONE
        message, result = capsys.readouterr().out, json.loads(report.read_text())
        shares[height] = result["summary"]["by_reason"]["below_table"] > 0.0
        assert ("30 mm below the table" in message) == (height == 0)
        assert ("part-below-table" in {one["code"] for one in result["findings"]}) == (height == 0)
    assert shares == {0: False, 30: True}


@pytest.mark.parametrize(("name", "never"), [("three", (0, 1)), ("table_a", (0,)), ("head_b", (1,))])
def test_machines_of_fewer_axes_get_only_where_they_can_turn_to(name, never, coarse):
    """Without rotary axes the tool stands along Z; about X or Y alone it never leans along that axis."""
    machine, mesh = MACHINES[name](), block()
    found = reach_map(mesh, Reacher(BALL, kinematics=chain(machine, Setup(machine.origin))))
    free, up = found.obstacle == Obstacle.NONE, np.isclose(found.point[:, 2], 20.0)
    assert free[up].all() and np.abs(found.axis[free][:, never]).max() < 1e-6
    assert name != "three" or (found.obstacle[~up] == Obstacle.LIMITS).all()


def test_a_cl_file_is_no_part(tmp_path, capsys):
    path = tmp_path / "a.apt"
    path.write_text("GOTO/0,0,0\nFINI\n")
    report = tmp_path / "a.json"
    assert cli.main(["reach", str(path), "--machine", "trunnion_ac", "--report", str(report)]) == cli.UNUSABLE
    assert "a.apt is a CL file (APT), needed is an STL file" in capsys.readouterr().err
    assert not report.exists()


def test_the_ball_that_would_fit_is_that_of_the_closed_form():
    """In a slot 5 mm wide and 20 deep a ball of radius r up to 2.5 is free but for a strip of r beside both
    edges of the floor, on floor and walls: 4 r of 45 mm. A share of s leaves r up to 11.25 (1 - s), of which
    the tenths of 3 mm below are tried."""
    mesh, reacher = slot(5.0, 20.0, 20.0), Reacher(BALL)
    middle = mesh.vertex[mesh.face].mean(axis=1)
    found = reach_map(mesh, reacher, (np.abs(middle[:, 0]) < 3.0) & (middle[:, 2] > 5.0))
    assert found.area_of(Obstacle.CUTTER) == pytest.approx(found.area.sum()) == pytest.approx(45.0 * 20.0)
    for share, radius in ((0.907, 0.9), (0.85, 1.5), (0.8, 2.1), (0.999, 0.0)):
        assert smaller_ball(mesh, reacher, found, share) == pytest.approx(radius), share


@pytest.mark.oldest
@pytest.mark.thorough
def test_no_smaller_ball_is_named_where_none_is_missing_and_fixtures_are_in_the_way(coarse):
    reacher = Reacher(BALL)
    wide = slot(14.0, 20.0, 60.0)
    assert smaller_ball(block(), reacher, reach_map(block(), reacher), 0.9) is None, "nowhere too large"
    flat = Reacher(Cutter(6.0, 20.0, 0.0))
    assert smaller_ball(wide, flat, reach_map(wide, flat), 0.9) is None, "no ball"
    clamp = Fixture("clamp", profile(np.array([(-7, 20), (7, 20), (7, 30), (-7, 30)]), 60.0))
    free, held = reach_map(wide, reacher), reach_map(wide, reacher, None, fixtures=(clamp,))
    assert held.area_of(Obstacle.NONE) < free.area_of(Obstacle.NONE) - 0.5 * 14.0 * 60.0


def test_of_steps_that_reach_the_same_the_shortest_is_named():
    found = SimpleNamespace(longer=((5.0, 275.1), (20.0, 275.2), (40.0, 310.0)))
    texts = [str(one) for one in reach_report.stick_out(found)]
    assert len(texts) == 2 and "5 mm farther" in texts[0] and "40 mm farther" in texts[1]


def roofed(gap, length=40.0):
    """A floor 24 mm wide at Z 10 under a roof ``gap`` mm above it, between walls 34 mm apart: a mouth of 10 mm
    in the middle of the roof, its ends open."""
    low, high = 10.0 + gap, 30.0 + gap
    outline = [(-30, 0), (30, 0), (30, high), (5, high), (5, low), (17, low), (17, 10), (-17, 10)]
    return profile(np.array([*outline, (-17, low), (-5, low), (-5, high), (-30, high)]), length)


def under_roof(found, length):
    """The places of that floor that lie under the roof and farther than a ball of 6 mm from walls, mouth and
    ends."""
    x, y, z = found.point.T
    return np.isclose(z, 10.0) & (np.abs(x) > 9.0) & (np.abs(x) < 13.5) & (np.abs(y - length / 2.0) < 20.0)


@some_in_core("kind", ["ball", "flat"])
def test_where_the_end_fits_under_a_roof_and_the_rest_does_not_it_is_the_flank(kind, coarse):
    """The roof is 9 mm over the floor: a ball of 6 mm fits below it, and so does as much of a flat cutter,
    but no cutter 30 mm long, which leaves the roof beside by 10 mm at most. Under a roof 5 mm over the floor
    not even the end fits."""
    cutter = BALL if kind == "ball" else Cutter(6.0, 30.0, 0.0)
    for gap, reason in ((9.0, Obstacle.FLANK), (5.0, Obstacle.CUTTER)):
        mesh = roofed(gap, 120.0)
        found = reach_map(
            mesh, Reacher(cutter), np.isclose(mesh.vertex[mesh.face][:, :, 2], 10.0).all(axis=1)
        )
        some = under_roof(found, 120.0)
        assert some.any() and (found.obstacle[some] == reason).all(), gap


@pytest.mark.thorough
def test_a_lollipop_reaches_under_the_roof_where_the_flank_of_a_ball_is_in_the_way(coarse):
    mesh = roofed(9.0, 120.0)
    ball, lollipop = (reach_map(mesh, Reacher(one)) for one in (BALL, Cutter(6.0, 30.0, neck=3.0)))
    some = under_roof(ball, 120.0)
    assert (ball.obstacle[some] == Obstacle.FLANK).all() and some.any()
    assert (lollipop.obstacle[some] == Obstacle.NONE).all() and lollipop.area_of(Obstacle.FLANK) == 0.0


def test_end_and_flank_in_the_way_have_a_remedy_each_where_there_is_some(coarse):
    mesh = roofed(9.0, 120.0)
    texts = [str(one) for one in reach_report.remedies(reach_map(mesh, Reacher(BALL)))]
    assert len(texts) == 2 and "smaller radius" in texts[0] and "lollipop" in texts[1]
    narrow = [str(one) for one in reach_report.remedies(reach_map(slot(5.0, 20.0), Reacher(BALL)))]
    assert len(narrow) == 1 and "smaller radius" in narrow[0]
    assert reach_report.remedies(reach_map(block(), Reacher(BALL))) == ()


def cavity():
    """A block with a cavity 40 x 40 mm inside, 160 mm long, open to a slit of 1 mm above, and plates that close
    its ends."""
    outline = [(-30, 0), (30, 0), (30, 60), (0.5, 60), (0.5, 50), (20, 50), (20, 10), (-20, 10), (-20, 50)]
    mesh = profile(np.array([*outline, (-0.5, 50), (-0.5, 60), (-30, 60)]), 160.0)
    square = np.array([(-30, 0), (30, 0), (30, 60), (-30, 60)], float)
    plate = [rectangle(*([x, y, z] for x, z in square)) for y in (0.0, 160.0)]
    return mesh, [Fixture(f"plate {k}", from_triangles(np.array(one, float))) for k, one in enumerate(plate)]


@pytest.mark.thorough
@pytest.mark.oldest
def test_where_the_tool_stands_freely_but_cannot_be_drawn_out_is_reported_with_its_area(coarse):
    """It is no closed hollow, for the slit is open, but no ball of 6 mm gets through that."""
    mesh, plates = cavity()
    x, _, z = mesh.vertex[mesh.face].mean(axis=1).T
    within = (np.abs(x) < 20.1) & (z > 9.9) & (z < 50.1)
    found = reach_map(mesh, Reacher(Cutter(6.0, 15.0)), within, fixtures=plates)
    assert found.area_of(Obstacle.HOLLOW) == 0.0 and found.area_of(Obstacle.NONE) > 0.8 * found.area.sum()
    assert found.shut == pytest.approx(found.area_of(Obstacle.NONE))
    (text,) = reach_report.name_shut(found)
    assert "cannot be drawn out" in text
    free = reach_map(block(), Reacher(Cutter(6.0, 15.0)))
    assert free.shut == 0.0 and reach_report.name_shut(free) == ()


def test_every_report_says_that_the_way_there_is_not_requested_and_what_the_part_stands_on(
    tmp_path, capsys, coarse
):
    """A cube of 20 mm: 400 of 2400 mm2 are its underside, which mill leaves out. With faces chosen it does
    not, and over a table the tool does not get there."""
    low, high = (0.0, 0.0), (20.0, 20.0)
    shape, path = profile(np.array([low, (20, 0), high, (0, 20)]), 20.0), tmp_path / "cube.stl"
    write_stl(shape, path)
    words = ["reach", str(path), "--machine", "trunnion_ac", "--cutter", "ball:6:30"]
    reports = [tmp_path / f"reach{ending}" for ending in (".json", ".html")]
    reported = [*words, *(word for one in reports for word in ("--report", str(one)))]
    assert cli.main(reported) == cli.DONE
    message, page = capsys.readouterr().out, reports[1].read_text()
    summary = json.loads(reports[0].read_text())["summary"]
    caveat = str(reach_report.WAYS)
    assert caveat in message and caveat in page and summary["note"] == caveat
    flat = " ".join(message.split())
    assert "400 mm2 are the underside" in flat and "only with --max-axis-angle" in flat
    assert "are the underside" in page and summary["standing_area"] == pytest.approx(400.0)
    for more in (["--faces", str(path)], ["--table-height", "0", "--origin", "0,0,0"]):
        assert cli.main([*reported, *more]) == cli.DONE
        assert "are the underside" not in capsys.readouterr().out, more
