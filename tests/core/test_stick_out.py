# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shortest stick-out that is free: closed forms, the program that ``mill`` makes with it against dense
samples, and what is said."""

import importlib.util
import json
import math
from pathlib import Path

import numpy as np
import pytest
from plain import build_settings
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_faces, from_triangles, write_stl
from freecad_fiveaxis.core.geometry.solids import box_facets
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.studies.setup_map import standing, stick_out
from freecad_fiveaxis.core.studies.study import try_setups
from freecad_fiveaxis.core.tool import parse_cutter
from freecad_fiveaxis.core.tool.stick_out import Stack, clamp_tool

SCRIPT = Path(__file__).parents[2] / "resources" / "examples" / "make_parts.py"
spec = importlib.util.spec_from_file_location("make_parts", SCRIPT)
parts = importlib.util.module_from_spec(spec)
spec.loader.exec_module(parts)

GIVEN = {
    "machine": "trunnion_ac", "cutter": "ball:6", "holder": "40x30", "passes": "planes",
    "tool_axis": "facet_mean", "stepover": 4.0, "origin": (0.0, 0.0, 0.0), "region": (20.0, 0.0, 0.0),
    "grid": (2.0, 1.0, 1.0), "gouge": "off",
}  # fmt: skip
"""The path is not lifted off walls, but where the cutter's own shank would meet them else (LIFTED)."""

LIFTED = {"gouge": "lift"}


def plate(*more, half=20.0):
    """A plate with its top at 0, and boxes on it."""
    boxes = [((-30.0, -half, -10.0), (30.0, half, 0.0)), *more]
    return from_triangles(np.concatenate([box_facets(*np.array(one)) for one in boxes]))


def wall(height):
    return plate(((30.0, -20.0, -10.0), (40.0, 20.0, height)))


def found(mesh, **more):
    return try_setups(build_settings("setup", "part.stl", GIVEN | more), mesh=mesh).chart


# ----------------------------------------------------------------------------------------------- closed forms


@pytest.mark.parametrize(("present", "met"), [(60.0, False), (20.0, True), (40.0, False)])
def test_beside_a_wall_the_holder_just_clears_its_top(present, met):
    """Cuts with upright axes at height 0, a wall of 40 mm: the holder stands 40 mm above the tip."""
    lifted = LIFTED if present < 40.0 else {}
    chart = found(wall(40.0), **lifted, cutter=f"ball:6:{present}", max_axis_angle=10.0)
    reported = chart.stick_out
    assert reported.present == present and reported.enough == pytest.approx(40.0, abs=1e-9)
    assert (reported.met is not None) == met and reported.shorter.enters == "holder"
    assert (
        reported.shorter.depth == pytest.approx(stick_out.STEP, abs=1e-6)
        and reported.shorter.entered == "part"
    )


@some_in_core("tilt", [50.0, 60.0])
def test_tilted_over_a_plane_the_rim_of_the_holder_just_clears_it(tilt):
    """Tip and rim: L cos t - R sin t + r (1 - cos t) = 0 for a ball of r, a holder of R, and a tilt of t."""
    t = math.radians(tilt)
    least = (20.0 * math.sin(t) - 3.0 * (1.0 - math.cos(t))) / math.cos(t)
    reported = found(plate(half=60.0), tilt=tilt, max_axis_angle=tilt + 5.0).stick_out
    assert 0.0 <= reported.enough - least <= stick_out.STEP + 1e-6


def test_the_clearance_is_kept_all_round_the_holder():
    """A gap of 2 mm on the rim that is nearest to the plane, square to it."""
    t = math.radians(60.0)
    least = (2.0 + 20.0 * math.sin(t) - 3.0 * (1.0 - math.cos(t))) / math.cos(t)
    reported = found(plate(half=60.0), tilt=60.0, max_axis_angle=70.0, fixture_clearance=2.0).stick_out
    assert 0.0 <= reported.enough - least <= stick_out.STEP + 1e-6


def test_a_fixture_is_in_the_way_as_the_part_is(tmp_path):
    write_stl(
        from_triangles(box_facets(*np.array(((30.5, -20.0, -10.0), (40.0, 20.0, 33.0))))), tmp_path / "v.stl"
    )
    reported = found(plate(), max_axis_angle=10.0, fixture=(str(tmp_path / "v.stl"),)).stick_out
    assert reported.enough == pytest.approx(33.0) and reported.shorter.entered == "v.stl"


def test_where_no_length_within_reason_helps_that_is_stated_with_what_is_met():
    chart = found(wall(200.0), max_axis_angle=10.0)
    reported = chart.stick_out
    assert reported.enough is None and reported.longest == 130.0 and reported.options == ()
    message = next(one for one in chart.findings if one.code == "no-stick-out-free")
    assert (
        "from that up to 130 mm" in message.text
        and "holder goes at least" in message.text
        and "smaller holder" in message.text
    )


def test_what_only_comes_too_near_is_stated_to_and_goes_into_nothing():
    chart = found(wall(30.0), max_axis_angle=10.0, fixture_clearance=3.0)
    message = next(one.text for one in chart.findings if one.code == "stick-out-enough")
    assert chart.stick_out.shorter.near and chart.stick_out.shorter.depth == 0.0
    assert "comes nearer to the part than the clearance" in message and "goes at least" not in message


def test_no_tool_is_proposed_that_would_have_no_length():
    reported = found(plate(), max_axis_angle=10.0, tool_length=30.0).stick_out
    assert float(dict(reported.options).get("tool_length", 30.0)) >= 0.0 and reported.enough >= 20.0


def test_where_nothing_is_ever_met_only_the_rounded_end_of_the_cutter_limits_it():
    reported = found(plate(), max_axis_angle=10.0).stick_out
    assert reported.enough == pytest.approx(3.1) and reported.shorter is None


def finding_of(chart):
    return next(one.text for one in chart.findings if "stick-out" in one.code)


FREE_AXES = {"tool_axis": "auto", "gouge": "lift", "stepover": 8.0}


@pytest.mark.thorough
def test_with_free_tool_axes_the_length_is_stated_of_this_path_and_a_shorter_tool_is_named_that_mill_frees():
    """Beside a wall the tool may lean away from it: for the shorter tool `mill` lets it do so, and nothing
    hits. The finding said flatly that the longer one is the least."""
    chart = found(wall(40.0), **FREE_AXES)
    reported = chart.stick_out
    assert reported.shorter.enters == "holder" and str(reported.axes_by) == "--tool-axis auto"
    shorter = dict(reported.to_try)["cutter"]
    assert float(shorter.rpartition(":")[2]) == pytest.approx(reported.enough - stick_out.LESS)
    assert (
        "told of the path as it was made for 50 mm: by --tool-axis auto another tool is given another path. "
        f"A shorter one may then do: to try it, run `mill` with --cutter {shorter}; it says"
        in finding_of(chart)
    )
    given = {name: value for name, value in (GIVEN | FREE_AXES).items() if name not in ("region", "grid")}
    settings = build_settings("mill", "part.stl", given | {"cutter": shorter, "spindle": "off"})
    done = job.prove(job.make(settings, mesh=wall(40.0)))
    assert not [one.text for one in done.findings if one.severity is Severity.ERROR]


@pytest.mark.parametrize(
    ("more", "option"),
    [({"gouge": "tilt"}, "--gouge tilt"), ({"gouge": "leave-out"}, "--gouge leave-out"), (LIFTED, None)],
)
def test_axes_that_no_tool_changes_leave_the_sentence_as_it_is(more, option):
    chart = found(wall(40.0), max_axis_angle=10.0, **more)
    assert (str(chart.stick_out.axes_by) if chart.stick_out.axes_by else None) == option
    assert ("another path" in finding_of(chart)) == (option is not None) == bool(chart.stick_out.to_try)


@pytest.mark.oldest
@pytest.mark.thorough
def test_a_length_that_is_needed_is_stated_of_this_path_and_no_shorter_one_is_named():
    chart = found(wall(40.0), cutter="ball:6:30", max_axis_angle=10.0, gouge="tilt")
    assert chart.stick_out.met is not None and not chart.stick_out.to_try
    assert "are needed" in finding_of(chart) and "by --gouge tilt another tool is given another path" in (
        finding_of(chart)
    )


def test_without_a_holder_there_is_nothing_to_tell():
    chart = found(plate(), holder=(), max_axis_angle=10.0)
    assert chart.stick_out is None and not [one for one in chart.findings if "stick-out" in one.code]


# ------------------------------------------------------------------------------------------- the second route


def samples(mesh, outcome, near=None):
    """Points (k, 3) of the mesh, and tips and axes (n, 3) of the tool: dense samples of the joints' straight
    way, and of the facets' edges, one in each cube of 4 mm and at 4000 places; or of all that are within 5 mm
    of a place."""
    words = outcome.program.words
    corner = mesh.vertex[mesh.face]
    wide = np.linalg.norm(corner - np.roll(corner, 1, axis=1), axis=2).max()
    share = np.linspace(0.0, 1.0, math.ceil(wide / 5.0) + 1)[:, None, None, None]
    edge = (1.0 - share) * corner + share * np.roll(corner, 1, axis=1)
    point = edge.reshape(-1, 3)
    if near is None:
        point, shares = point[np.unique((point / 4.0).round().astype(int), axis=0, return_index=True)[1]], 3
    else:
        point, shares = np.unique(point[np.linalg.norm(point - near, axis=1) < 5.0], axis=0), 12
    at = np.linspace(0.0, 1.0, shares, endpoint=False)[:, None, None]
    way = ((1.0 - at) * words[:-1] + at * words[1:]).transpose(1, 0, 2).reshape(-1, 5)
    way = way[:: max(len(way) // 4000, 1)] if near is None else way
    return point, *forward(outcome.kinematics, words_to_q(way))


CELLS = 5
"""So many cubes stand along the widest side of points of which one in each cube is asked first."""


def deepest_in(point, tip, axis, length, radius, high):
    """How deep the deepest of points (k, 3) is in the cylinder at any of these tips and axes (n, 3); 0 where
    all stay out.

    No point is deeper than another by more than they are apart. So of each cell of points one is asked
    first, and the others only where they may be deeper than what is found: the result is that of all.
    """
    cube = (CELLS * point / np.ptp(point, axis=0).max()).round()
    _, first, cell = np.unique(cube, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(cell.reshape(-1), kind="stable")
    point, middle, count = point[order], point[first], np.bincount(cell.reshape(-1))
    begin = np.cumsum(count) - count
    apart = np.maximum.reduceat(np.linalg.norm(point - np.repeat(middle, count, axis=0), axis=1), begin)

    def depth(at, tip, axis):
        height = ((at - tip) * axis).sum(axis=-1)
        across = np.sqrt(np.maximum(((at - tip) ** 2).sum(axis=-1) - height**2, 0.0))
        return np.minimum(np.minimum(height - length, length + high - height), radius - across)

    deepest = 0.0
    for some in np.array_split(np.arange(len(tip)), max(len(tip) * len(middle) // 200_000, 1)):
        reported = depth(middle, tip[some, None], axis[some, None])
        deepest = max(deepest, float(reported.max()))
        pose, of = np.nonzero(reported + apart > deepest)
        which = np.repeat(np.arange(len(of)), count[of])
        rest = np.arange(len(which)) - np.repeat(np.cumsum(count[of]) - count[of], count[of])
        pose = some[pose[which]]
        own = depth(point[begin[of[which]] + rest], tip[pose], axis[pose])
        deepest = max(deepest, float(own.max(initial=0.0)))
    return deepest


EXAMPLES = {
    "saddle": ("saddle", {}),
    "saddle on a head": ("saddle", {"machine": "head_b_table_c", "tool_length": 120.0}),
    "dome, leaning": ("dome", {"tilt": 40.0}),
}


def result_with(mesh, given, chart, names=("cutter", "shank", "tool_length")):
    """The program that ``mill`` makes with what is recommended, of it the options of these names: the second
    route starts from them."""
    options = {name: value for name, value in chart.stick_out.options if name in names}
    more = {name: float(value) if name == "tool_length" else value for name, value in options.items()}
    plain = {name: value for name, value in given.items() if name not in ("region", "grid")}
    origin = tuple(chart.origin[chart.best].tolist())
    settings = build_settings("mill", "part.stl", plain | more | {"origin": origin, "spindle": "off"})
    return job.make(settings, mesh=mesh)


@pytest.mark.thorough
@some_in_core("name", EXAMPLES)
def test_dense_samples_of_the_recommended_program_hit_nothing_and_half_a_millimetre_shorter_they_do(name):
    part, more = EXAMPLES[name]
    mesh = from_faces(*parts.PARTS[part]())
    given = GIVEN | LIFTED | {"cutter": "ball:8", "holder": "40x30,63x60", "stepover": 8.0} | more
    chart = try_setups(build_settings("setup", "part.stl", given), mesh=mesh).chart
    enough = chart.stick_out.enough
    result = result_with(mesh, given, chart)
    assert not [
        one for one in job.prove(result).findings if one.code in ("holder-collision", "machine-collision")
    ]
    assert holder_depth(mesh, result, enough) <= 0.01 + 1e-6
    same = result_with(mesh, given, chart, ("tool_length",))  # the links of a shorter tool are others
    assert holder_depth(mesh, same, enough) <= 0.01 + 1e-6
    assert holder_depth(mesh, same, enough - 0.5, chart.stick_out.shorter.place) > 0.05


def holder_depth(mesh, outcome, length, near=None):
    """How deep a holder of two steps is in the mesh, by samples."""
    at = samples(mesh, outcome, near)
    return max(deepest_in(*at, length, 20.0, 30.0), deepest_in(*at, length + 30.0, 31.5, 60.0))


@pytest.mark.thorough
def test_a_holder_that_is_forgotten_would_be_noticed(monkeypatch):
    """The comparison can fail: proven with a holder that is 4 mm thinner, the samples hit the true one."""
    mesh, true = from_faces(*parts.PARTS["dome"]()), standing.Run.above.fget

    def thinner(run):
        pieces = (
            one._replace(low_radius=one.low_radius - 2.0, high_radius=one.high_radius - 2.0)
            for one in true(run).pieces
        )
        return standing.Body(tuple(pieces))

    monkeypatch.setattr(standing.Run, "above", property(thinner))
    given = GIVEN | {"cutter": "ball:8", "stepover": 8.0, "tilt": 40.0}
    chart = try_setups(build_settings("setup", "part.stl", given), mesh=mesh).chart
    reported, outcome = chart.stick_out, result_with(mesh, given, chart, ())
    assert deepest_in(*samples(mesh, outcome, reported.shorter.place), reported.enough, 20.0, 30.0) > 0.1


# ---------------------------------------------------------------------------------------- machine and spindle


def test_the_spindle_over_a_known_tool_is_looked_at_and_the_length_is_stated():
    """A spindle nose of radius 60 mm, lower than the holder is high: it meets the wall before the holder."""
    machine = "trunnion_with_bodies"
    more = {
        "machine": machine,
        "cutter": "ball:6:70",
        "holder": "6x10",
        "tool_length": 80.0,
        "max_axis_angle": 10.0,
    }
    reported = found(wall(60.0), **LIFTED, **more).stick_out
    assert reported.shorter.enters == "spindle" and reported.shorter.entered == "part"
    assert reported.enough == pytest.approx(50.0) and dict(reported.options)["tool_length"] == "60"


# --------------------------------------------------------------------------------------------------- the tool


@pytest.mark.parametrize(
    ("cutter", "shank", "length", "options"),
    [
        ("ball:10:50", (), 60.0, ("ball:10.0:50.0", ((10.0, 10.0),))),
        ("ball:10:50", ((8.0, 20.0),), 75.0, ("ball:10.0:50.0", ((8.0, 25.0),))),
        ("ball:10:50", ((8.0, 20.0),), 65.0, ("ball:10.0:50.0", ((8.0, 15.0),))),
        ("ball:10:50", ((8.0, 20.0), (12.0, 10.0)), 65.0, ("ball:10.0:50.0", ((8.0, 15.0),))),
        ("ball:10:50", ((8.0, 20.0),), 45.0, ("ball:10.0:45.0", ())),
        ("lollipop:10:6:40", (), 50.0, ("lollipop:10.0:6.0:40.0", ((6.0, 10.0),))),
    ],
)  # fmt: skip
def test_a_tool_is_clamped_otherwise(cutter, shank, length, options):
    from freecad_fiveaxis.core.tool import cutter_text

    outcome = clamp_tool(Stack(parse_cutter(cutter), shank), length)
    assert (cutter_text(outcome.cutter), outcome.shank) == options and outcome.stick_out == pytest.approx(
        length
    )


@pytest.mark.parametrize(
    "cutter", ["ball:10", "flat:10", "bull:10:2", "taperball:6:5deg", "lollipop:10:6", "barrel:10:85:2"]
)
def test_the_shortest_tool_can_be_built_and_a_shorter_one_is_refused(cutter):
    stack = Stack(parse_cutter(cutter), (), ((40.0, 30.0),))
    outcome = clamp_tool(stack, stack.shortest)
    assert outcome.stick_out == pytest.approx(stack.shortest) and outcome.body.pieces
    with pytest.raises(SettingsError, match="stick-out"):
        clamp_tool(stack, stack.shortest - 0.5)


# ----------------------------------------------------------------------------------------------- what is said


def test_text_page_and_record_say_it_with_the_option_to_give(tmp_path, capsys):
    write_stl(wall(40.0), tmp_path / "part.stl")
    words = [
        "setup",
        str(tmp_path / "part.stl"),
        "--machine",
        "trunnion_ac",
        "--cutter",
        "ball:6",
        "--holder",
    ]
    words += ["40x30", "--passes", "planes", "--stepover", "4", "--max-axis-angle", "10", "--origin=0,0,0"]
    words += ["--region", "20,0,0", "--grid", "2,1,1"]
    reports = [str(tmp_path / f"map.{ending}") for ending in ("json", "html")]
    assert cli.main([*words, "--report", reports[0], "--report", reports[1]]) == 0
    message = " ".join(capsys.readouterr().out.split())
    assert "Tool stick-out: 40 mm are enough, 50 mm are set. Give --cutter ball:6:40." in message
    assert "for a tool that sticks out 40 mm: --cutter=ball:6:40" in message
    record = json.loads(Path(reports[0]).read_text())["stick_out"]
    assert (record["present"], record["enough"], record["met"]) == (50.0, 40.0, None)
    assert record["options"] == {"cutter": "ball:6:40"} and record["shorter"]["enters"] == "holder"
    assert "40 mm are enough" in Path(reports[1]).read_text()
