# SPDX-License-Identifier: LGPL-2.1-or-later
"""A barrel on its passes: its flank on every contact, few passes on steep walls, and what is said where it
cannot."""

import math
from dataclasses import replace

import numpy as np
import pytest

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.options import axis_options
from freecad_fiveaxis.core.pipeline.settings import MILL, build_settings
from freecad_fiveaxis.core.tool import parse_cutter
from freecad_fiveaxis.core.tool.body import body_of, depth_of
from freecad_fiveaxis.core.toolpath.cl_path import Motion

BARREL, FLANK = "barrel:10:85:2", 85.0
SCALLOP = 0.02


def tower(sides=48, height=24.0):
    """A tower with an elliptic foot whose wall leans in by 8 %: steep all round."""
    turn, levels = np.arange(sides) * 2.0 * math.pi / sides, np.linspace(0.0, height, 9)
    far = (14.0 - 0.08 * levels)[:, None]
    rings = np.stack(
        [far * np.cos(turn), 0.7 * far * np.sin(turn), np.repeat(levels[:, None], sides, axis=1)], axis=2
    )
    after = np.roll(rings, -1, axis=1)
    a, b, c, d = rings[:-1], after[:-1], after[1:], rings[1:]
    walls = [np.stack(one, axis=2).reshape(-1, 3, 3) for one in ((a, b, c), (a, c, d))]
    low, high = (np.broadcast_to((0.0, 0.0, z), (sides, 3)) for z in (0.0, height))
    ends = [np.stack([low, after[0], rings[0]], axis=1), np.stack([high, rings[-1], after[-1]], axis=1)]
    return from_triangles(np.concatenate([*walls, *ends]))


@pytest.fixture(scope="module")
def part(tmp_path_factory):
    path = tmp_path_factory.mktemp("barrel") / "tower.stl"
    write_stl(tower(), path)
    return str(path)


def settings_of(part, **options):
    given = {
        "machine": "trunnion_ac",
        "controller": "linuxcnc",
        "cutter": BARREL,
        "scallop": SCALLOP,
        "passes": "zlevel",
    }
    return build_settings(MILL, part, {**given, "spindle": 8000, **options})


@pytest.fixture(scope="module")
def with_barrel(part):
    return job.run(settings_of(part, rest="on"))


@pytest.fixture(scope="module")
def with_ball(part):
    return job.run(settings_of(part, cutter="ball:10", tool_axis="facet_mean", rest="on"))


def codes(result):
    return {finding.code for finding in result.findings}


def walls(result):
    """Contacts, normals, axes and tips of the rows that cut, and how far the axis leans from the normal."""
    path = result.draft.path
    rows = np.flatnonzero(np.isin(path.motion, (Motion.CUT, Motion.FILL)))
    lean = np.arccos(np.clip((path.normal[rows] * path.axis[rows]).sum(axis=1), -1.0, 1.0))
    return path.contact[rows], path.normal[rows], path.axis[rows], path.tip[rows], lean


@pytest.mark.thorough
@pytest.mark.oldest
def test_on_a_steep_wall_the_middle_of_its_flank_touches_and_the_axis_stands_up(with_barrel):
    contact, _, axis, tip, lean = walls(with_barrel)
    barrel = parse_cutter(BARREL).barrel
    assert np.median(lean) == pytest.approx(barrel.middle, abs=1e-3) and (axis[:, 2] > 0.9).all()
    assert ((lean > barrel.begins) & (lean < 0.5 * math.pi)).all() and "off-flank" not in codes(with_barrel)
    depth = depth_of(body_of(parse_cutter(BARREL)), tip, axis, contact)
    assert np.abs(depth).max() < 0.01, (
        "every contact lies on its flank, but for what it rocks from facet to facet"
    )


def test_it_needs_a_fourth_of_the_passes_and_leaves_no_more_than_was_requested(with_barrel, with_ball):
    """Both leave s^2 / 8 R: passes go with the root of R."""
    count = [len(np.unique(result.draft.offset.pass_)) for result in (with_barrel, with_ball)]
    assert count[1] / count[0] == pytest.approx(math.sqrt(FLANK / 5.0), rel=0.25)
    for result in (with_barrel, with_ball):
        rest, mesh = result.rest, result.draft.mesh
        wall = np.abs(mesh.normal[rest.facet][:, 2]) < 0.5
        assert rest.height[wall].max() < 1.5 * SCALLOP  # facets turn by up to 10 deg
        assert np.quantile(rest.height[wall], 0.9) < 1.1 * SCALLOP
    assert not {"overcut", "tool-in-part"} & codes(with_barrel)


def test_passes_as_far_apart_with_a_ball_would_leave_more(part, with_barrel):
    """The comparison of the test above can fail."""
    apart = 2.0 * math.sqrt(2.0 * FLANK * SCALLOP)
    settings = settings_of(
        part, cutter="ball:10", tool_axis="facet_mean", rest="on", scallop=None, stepover=apart
    )
    rest = job.run(settings).rest
    wall = np.abs(with_barrel.draft.mesh.normal[rest.facet][:, 2]) < 0.5
    assert np.quantile(rest.height[wall], 0.9) > 5.0 * SCALLOP


@pytest.mark.parametrize("order", ["zigzag", "one_way"])
def test_it_leans_to_the_upper_side_whichever_way_the_passes_run(part, order):
    axis = walls(job.run(settings_of(part, passes="planes", plane_normal="0,0,1", order=order)))[2]
    assert (axis[:, 2] > 0.9).all()


@pytest.mark.oldest
@pytest.mark.thorough
def test_a_tilt_that_is_requested_stays_what_it_is(part):
    """To the right of the feed, by so much; and the finding where it leaves the flank, with the tilt that
    does not."""
    assert axis_options(settings_of(part, tilt="80deg")).tilt == pytest.approx(math.radians(80.0))
    assert not axis_options(settings_of(part, tilt="80deg")).upwards
    result = job.run(settings_of(part, tilt="30deg"))
    found = next(finding for finding in result.findings if finding.code == "off-flank")
    assert found.value > 100.0 and "--tilt 82 deg" in str(found.text) and "ball of 2 mm" in str(found.text)
    assert np.median(walls(result)[4]) == pytest.approx(math.radians(30.0), abs=0.01)


@pytest.mark.thorough
def test_with_a_fixed_axis_it_cuts_upright_walls_with_its_widest_place(part):
    options = axis_options(settings_of(part, tool_axis="fixed"))
    assert (options.lead, options.tilt) == (0.0, 0.0)
    lean = walls(job.run(settings_of(part, tool_axis="fixed")))[4]
    assert lean.max() < 0.5 * math.pi and lean.min() > parse_cutter(BARREL).barrel.begins


def test_minimax_is_refused_and_names_what_to_choose(part, capsys, tmp_path):
    with pytest.raises(SettingsError, match="off its flank"):
        settings_of(part, tool_axis="minimax")
    given = [
        "--machine",
        "trunnion_ac",
        "--cutter",
        BARREL,
        "--tool-axis",
        "minimax",
        "-o",
        str(tmp_path / "x.ngc"),
    ]
    assert cli.main(["mill", part, *given]) == 2
    error = capsys.readouterr().err.strip()
    assert error.count("\n") == 0 and "facet_mean" in error and not list(tmp_path.iterdir())


def test_what_stands_beside_the_wall_is_found_and_lifted_over(tmp_path):
    """A wall opposite, 9 mm away: the cutter of 10 mm has no room."""
    one = tower(16)
    both = from_triangles(
        np.concatenate([mesh.vertex[mesh.face] for mesh in (one, moved(one, (36.0, 0.0, 0.0)))])
    )
    path = tmp_path / "two.stl"
    write_stl(both, path)
    deep = job.run(settings_of(str(path), gouge="report"))
    assert any(code.startswith("tool-in-part") or "overcut" in code for code in map(str, codes(deep))), codes(
        deep
    )


def moved(mesh, by):
    return replace(mesh, vertex=mesh.vertex + np.array(by))
