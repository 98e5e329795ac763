# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes around and along a rotary axis, and the tool that points at it: by closed forms, by a ball that
follows them, and by the program read back."""

import math
import re
import shutil
import subprocess
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest
from test_pass_strategies import SCALLOP, region, rest_heights, samples
from test_pass_strategies import passes as plan

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import FiveAxisError, SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_faces, from_triangles, write_stl
from freecad_fiveaxis.core.machine import Axis, Machine, SafeStart, load_machine, save_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.passes import PASS_STRATEGIES, PassOptions, cut, flat_interval
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.rotary_axis import own_axis, settle_rotary_axis
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.cl_path import Motion

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
ROTARY = PASS_STRATEGIES["rotary"]
ORIGIN = (0.0, 0.0, 0.0)
LENGTH = 12.0
FLAT = 3.5
FOUR_AXES = str(Path(__file__).parents[2] / "examples" / "mill_xyza.fcm")


def profile(radius, columns=96, rows=8, length=LENGTH):
    """The closed solid about X from 0 to ``length`` with this radius (angle from Y, x), faces at both
    ends."""
    turn, along = np.arange(columns) * 2.0 * math.pi / columns, np.linspace(0.0, length, rows + 1)
    angle, x = np.meshgrid(turn, along, indexing="ij")
    far = radius(angle, x) + 0.0 * angle
    ring = np.stack([x, far * np.cos(angle), far * np.sin(angle)], axis=-1)
    after = np.roll(ring, -1, axis=0)
    a, b, c, d = ring[:, :-1], ring[:, 1:], after[:, 1:], after[:, :-1]
    low, high = (np.broadcast_to((end, 0.0, 0.0), (columns, 3)) for end in (0.0, length))
    ends = [
        np.stack([low, after[:, 0], ring[:, 0]], axis=1),
        np.stack([high, ring[:, -1], after[:, -1]], axis=1),
    ]
    sides = [np.stack(one, axis=2).reshape(-1, 3, 3) for one in ((a, c, b), (a, d, c))]
    return from_triangles(np.concatenate([*sides, *ends]))


def ellipse(angle, _):
    return 9.0 * 6.0 / np.hypot(6.0 * np.cos(angle), 9.0 * np.sin(angle))


def with_flat(angle, _):
    return np.minimum(5.0, FLAT / np.maximum(np.sin(angle), 1e-9))


SHAPES = {
    "cylinder": lambda angle, x: 5.0 + 0.0 * angle,
    "cam": ellipse,
    "flat": with_flat,
    "cone": lambda angle, x: 6.0 - 0.25 * x,
    "bar": lambda angle, _: 4.0 / np.maximum(np.abs(np.cos(angle)), np.abs(np.sin(angle))),
}


@lru_cache
def shape(name):
    return profile(SHAPES[name])


def options(**given):
    return PassOptions(**({"scallop": SCALLOP, "axis": X, "centre": ORIGIN} | given))


def side_of(mesh):
    return np.abs(mesh.normal[:, 0]) < 0.99


@pytest.fixture
def stl(tmp_path):
    def write(name):
        write_stl(shape(name), tmp_path / f"{name}.stl")
        return str(tmp_path / f"{name}.stl")

    return write


def settings_of(source, **given):
    plain = {"machine": FOUR_AXES, "cutter": "ball:6", "scallop": 0.1, "passes": "rotary", "spindle": 8000}
    return build_settings("mill", source, plain | given)


# --------------------------------------------------------------------------------------- where the passes lie


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("by", ["around", "along"])
def test_no_more_than_the_scallop_stays_where_a_ball_follows_the_passes(name, by):
    mesh = shape(name)
    stays = rest_heights(
        mesh, plan(ROTARY, mesh, options=options(by=by)), samples(mesh, np.flatnonzero(side_of(mesh)))[0]
    )
    assert np.quantile(stays, 0.98) <= 1.2 * SCALLOP and stays.max() <= 2.0 * SCALLOP


def test_twice_the_step_would_leave_more():
    mesh = shape("cam")
    contact = plan(ROTARY, mesh, options=options(scallop=4.0 * SCALLOP))
    assert (
        np.quantile(rest_heights(mesh, contact, samples(mesh, np.flatnonzero(side_of(mesh)))[0]), 0.9)
        > 1.2 * SCALLOP
    )


def test_around_a_cylinder_there_is_a_ring_each_step_of_a_flat():
    contact = plan(ROTARY, shape("cylinder"), options=options())
    rings = int(contact.pass_.max()) + 1
    assert rings == math.ceil(LENGTH / flat_interval(3.0, 0.92 * SCALLOP) - 1e-9)
    middle = (np.arange(rings) + 0.5) * LENGTH / rings
    np.testing.assert_allclose(np.sort(contact.point[:, 0]), np.sort(middle[contact.pass_]), atol=1e-3)
    for number in range(rings):
        rows = contact.pass_ == number
        way = contact.point[rows][1::2] - contact.point[rows][::2]
        assert np.linalg.norm(way, axis=1).sum() == pytest.approx(
            96 * 2.0 * 5.0 * math.sin(math.pi / 96), rel=1e-4
        )


def test_along_a_cylinder_lines_lie_the_angle_of_a_step_apart():
    contact = plan(ROTARY, shape("cylinder"), options=options(by="along"))
    way = contact.point[1::2] - contact.point[::2]
    assert np.abs(way[:, 0]).sum() > 0.999 * np.linalg.norm(way, axis=1).sum()
    numbers = np.unique(contact.pass_)
    angle = np.array(
        [
            np.angle(np.exp(1j * np.arctan2(*contact.point[contact.pass_ == n][:, (2, 1)].T)).mean())
            for n in numbers
        ]
    )
    apart = np.diff(np.unwrap(angle))
    np.testing.assert_allclose(apart, apart[0], rtol=0.02)
    assert abs(apart[0]) * len(numbers) == pytest.approx(2.0 * math.pi, rel=0.02)


def test_the_ends_have_no_pass_and_are_reported_with_their_area():
    mesh = shape("cylinder")
    given = options()
    found = ROTARY.field(region(mesh), given)
    contact = cut(region(mesh), found, "zigzag")
    reported = {one.code: one for one in ROTARY.report_untouched(region(mesh), given, found, contact.face)}
    area = 96 * 25.0 * math.sin(2.0 * math.pi / 96)
    assert reported["facets-across-axis"].value == pytest.approx(area, rel=1e-6) and set(reported) == {
        "facets-across-axis"
    }


@pytest.mark.parametrize("by", ["around", "along"])
def test_passes_go_with_a_part_that_is_turned_shifted_and_scaled(by):
    about = np.array([1.0, -2.0, 2.0]) / 3.0
    up = np.cross(about, (0.0, 0.0, 1.0)) / np.linalg.norm(np.cross(about, (0.0, 0.0, 1.0)))
    placed = np.stack([about, up, np.cross(about, up)], axis=1)
    lengths = []
    for turn, shift, size in ((np.eye(3), np.zeros(3), 1.0), (placed, np.array([40.0, -7.0, 11.0]), 1.5)):
        mesh = from_faces(size * np.asarray(shape("cam").vertex) @ turn.T + shift, shape("cam").face)
        given = options(axis=tuple(turn[:, 0]), centre=tuple(shift), stepover=size * 0.6, scallop=None, by=by)
        contact = plan(ROTARY, mesh, options=given)
        lengths.append(float(np.linalg.norm(contact.point[1::2] - contact.point[::2], axis=1).sum()) / size)
    assert lengths[0] == pytest.approx(lengths[1], rel=5e-3)


@pytest.mark.parametrize(
    ("given", "reported"),
    [
        ({"axis": (0.0, 0.0, 0.0)}, "--pass-axis 0,0,0 has no direction"), ({"centre": "left"}, "neither middle nor X,Y,Z"),
        ({"centre": (0.0, 500.0, 0.0), "axis": X}, None),
    ],
)  # fmt: skip
def test_an_axis_that_is_none_is_refused(given, reported):
    if reported is None:
        ROTARY.check(region(shape("cylinder")), options(**given))
        return
    with pytest.raises(SettingsError, match=reported):
        ROTARY.check(region(shape("cylinder")), options(**given))


def test_a_part_that_only_faces_the_axis_is_refused():
    mesh = shape("cylinder")
    with pytest.raises(SettingsError, match="nothing that is to be cut faces away from the axis"):
        ROTARY.check(region(mesh, ~side_of(mesh)), options())


# ------------------------------------------------------------------------------------------------ the axis


def machine(*axes):
    return Machine(
        "m",
        (
            *axes,
            *(
                Axis(a, False, "head", way, low=-500, high=500)
                for a, way in zip("XYZ", (X, Y, Z), strict=True)
            ),
        ),
    )


@pytest.mark.parametrize(
    ("axes", "about", "through"),
    [
        ([Axis("A", True, "table", X, (5.0, 20.0, -50.0))], X, (4.0, 18.0, -53.0)),
        ([Axis("B", True, "table", Y, ORIGIN)], Y, (-1.0, -2.0, -3.0)),
        ([], X, (6.0, 0.0, 0.0)),
        ([Axis("C", True, "table", Z), Axis("A", True, "table", X)], X, (6.0, 0.0, 0.0)),
    ],
)
def test_the_axis_is_the_machines_own_or_the_parts_longest_side(axes, about, through):
    kinematics = chain(machine(*axes), Setup(origin=(1.0, 2.0, 3.0)))
    passes = settle_rotary_axis(settings_of("part.stl"), kinematics, shape("cylinder")).passes
    np.testing.assert_allclose(passes.pass_axis, about, atol=1e-12)
    np.testing.assert_allclose(passes.pass_centre, through, atol=1e-6)


def test_a_head_has_a_direction_and_no_line_in_the_part():
    axes = (
        *(Axis(a, False, "head", way, low=-500, high=500) for a, way in zip("XYZ", (X, Y, Z), strict=True)),
    )
    head = Machine("h", (*axes, Axis("B", True, "head", Y)))
    assert own_axis(chain(head, Setup(tool_length=100.0))) == (Y, None)


def test_what_is_given_counts():
    kinematics = chain(machine(Axis("A", True, "table", X)), Setup())
    given = settings_of("part.stl", pass_axis="0,0,2", pass_centre="1,2,3")
    passes = settle_rotary_axis(given, kinematics, shape("cylinder")).passes
    assert passes.pass_axis == Z and passes.pass_centre == (1.0, 2.0, 3.0)


# ------------------------------------------------------------------------------------------------ the program


@lru_cache
def make_result(name, by="around", spiral="off", order="zigzag"):
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        write_stl(shape(name), Path(folder) / "part.stl")
        return job.run(settings_of(str(Path(folder) / "part.stl"), rotary_by=by, spiral=spiral, order=order))


def feed_rows(program):
    return np.flatnonzero(np.isin(program.motion, (int(Motion.CUT), int(Motion.FILL))))


@pytest.mark.thorough
@pytest.mark.parametrize("name", SHAPES)
def test_the_tool_points_at_the_axis_and_one_rotary_word_turns(name):
    result = make_result(name)
    path = result.draft.path
    rows = np.flatnonzero(path.motion == Motion.CUT)
    outward = path.contact[rows] * (0.0, 1.0, 1.0)
    np.testing.assert_allclose(path.axis[rows], outward / np.linalg.norm(outward, axis=1)[:, None], atol=1e-6)
    blocks = [line for line in result.draft.nc.decode().splitlines() if line.startswith(("G0 ", "G1 "))]
    assert all(set(re.findall("[A-Z]", line)) <= set("GXYZAF") for line in blocks)
    assert result.deviation.bound.max() <= 0.01
    assert not [
        one for one in result.findings if one.severity.name == "ERROR" or one.code == "retract-below-part"
    ]


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "by"), [("cylinder", "around"), ("cam", "around"), ("flat", "along"), ("cone", "along")]
)
def test_what_is_posted_is_read_again_and_the_rotary_word_never_jumps_in_a_pass(name, by):
    built = make_result(name, by).draft
    read = read_nc(built.nc, built.kinematics, built.dialect)
    np.testing.assert_allclose(read.words[-len(built.program.words) :], built.program.words, atol=1e-9)
    rows = feed_rows(built.program)
    turned = np.abs(np.diff(built.program.words[:, 3]))[rows[rows > 0] - 1]
    assert turned.max() < 60.0 and (by == "along" or turned.max() > 0.0)


def test_a_spiral_around_a_cylinder_is_the_helix_of_the_closed_form():
    """One pass: a ring, turns of one step each, and a ring; the rotary word only rises, one turn for each of
    them."""
    rings = int(make_result("cylinder").draft.contact.pass_.max()) + 1
    built = make_result("cylinder", spiral="on").draft
    path = built.path
    assert np.ptp(built.contact.pass_) == 0
    rows = np.flatnonzero(np.isin(path.motion, (Motion.CUT, Motion.FILL)))
    x, y, z = path.contact[rows].T
    turns = np.unwrap(np.arctan2(z, y)) / (2.0 * math.pi)
    turns = (turns - turns[0]) * np.sign(turns[-1] - turns[0])
    assert turns[-1] == pytest.approx(rings + 1, abs=0.1)
    step = LENGTH / rings
    helix = 0.5 * step + step * np.clip(turns - 1.0, 0.0, rings - 1.0)
    rises = x if x[-1] > x[0] else LENGTH - x
    np.testing.assert_allclose(rises, helix, atol=0.1 * step)
    word = built.program.words[feed_rows(built.program), 3]
    way = np.diff(word) * np.sign(word[-1] - word[0])
    assert way.min() >= -1e-3 and abs(word[-1] - word[0]) == pytest.approx(360.0 * (rings + 1), abs=36.0)


def test_turns_beyond_the_limits_are_wound_back_and_reported(tmp_path, stl):
    limited = Axis("A", True, "table", X, low=-3.0 * math.pi, high=3.0 * math.pi, max_rate=60.0)
    linear = (
        Axis(a, False, "head", way, low=-500, high=500, max_rate=9000)
        for a, way in zip("XYZ", (X, Y, Z), strict=True)
    )
    save_machine(Machine("few_turns", (limited, *linear), safe_start=SafeStart("none")), tmp_path / "few.fcm")
    result = job.run(settings_of(stl("cylinder"), machine=str(tmp_path / "few.fcm"), spiral="on"))
    words = result.draft.program.words[:, 3]
    assert words.min() >= -540.0 - 1e-6 and words.max() <= 540.0 + 1e-6
    assert [one for one in result.findings if "rewind" in one.code]


def test_nothing_of_the_sides_is_left_and_none_is_cut_too_deep(stl):
    result = job.run(settings_of(stl("flat"), rest="on", spiral="on"))
    assert [one.code for one in result.findings if one.severity.name != "NOTE"] == []


@pytest.mark.parametrize("cutter", ["bull:6:1", pytest.param("flat:6", marks=pytest.mark.thorough)])
def test_a_cutter_without_a_ball_end_leaves_no_more_than_the_scallop_on_a_cone(stl, cutter):
    result = job.run(settings_of(stl("cone"), cutter=cutter, scallop=0.3, rest="on"))
    assert not [one for one in result.findings if one.severity.name != "NOTE"]


def test_a_machine_of_five_axes_turns_the_part_about_its_longest_side(stl):
    result = job.run(
        settings_of(stl("cylinder"), machine="fork_head_bc", tool_length=100.0, max_axis_angle=90)
    )
    rows = np.flatnonzero(result.draft.path.motion == Motion.CUT)
    assert np.abs(result.draft.path.axis[rows, 0]).max() < 1e-9
    assert (result.draft.path.axis[rows, 2] > -1e-3).all()


@pytest.mark.parametrize(
    ("words", "reported"),
    [
        (["--rotary-by", "around"], None), (["--passes", "scallop", "--tool-axis", "from_axis"], None),
        (["--passes", "rotary", "--tool-axis", "facet_mean"], None),
        (["--passes", "rotary", "--pass-axis", "0,0,0"], "--pass-axis 0,0,0 has no direction"),
        (["--passes", "rotary", "--pass-centre", "here"], "--pass-centre 'here' is neither middle"),
        (["--passes", "rotary", "--pass-axis", "0,0,1"], "no facet can be cut"),
        (["--passes", "rotary", "--steep-shallow", "45"], "does not go together with"),
        (["--passes", "rotary", "--pass-axis", "1,2"], "pass-axis"),
    ],
)  # fmt: skip
def test_the_command_line_makes_a_program_or_says_in_one_line_why_not(tmp_path, capsys, stl, words, reported):
    out = tmp_path / "out.ngc"
    common = ["--machine", FOUR_AXES, "--cutter", "ball:6", "--scallop", "0.2", "-o", str(out), "--quiet"]
    code = cli.main(["mill", stl("cylinder"), *common, *words])
    message = capsys.readouterr().err
    assert (code == 2) == (reported is not None) == (not out.exists())
    assert reported is None or (reported in message and len(message.strip().splitlines()) == 1)


def test_a_word_that_is_no_choice_ends_with_code_2(capsys):
    with pytest.raises(SystemExit) as ended:
        cli.main(["mill", "part.stl", "--machine", FOUR_AXES, "--rotary-by", "across"])
    assert ended.value.code == 2 and "--rotary-by" in capsys.readouterr().err.splitlines()[-1]


@pytest.mark.rs274
@pytest.mark.skipif(shutil.which("rs274") is None, reason="needs LinuxCNC")
def test_linuxcnc_reads_a_helix_of_many_turns(tmp_path):
    built = make_result("cylinder", spiral="on").draft
    nc = tmp_path / "out.ngc"
    nc.write_bytes(built.nc)
    reported = subprocess.run(
        ["rs274", "-g", str(nc)], capture_output=True, text=True, timeout=120, check=True
    ).stdout
    moves = [line for line in reported.splitlines() if "STRAIGHT_FEED" in line]
    last = [float(word) for word in moves[-1].split("(")[1].rstrip(")").split(",")]
    feeds = built.program.words[built.program.motion != int(Motion.RAPID)]
    np.testing.assert_allclose(last[:4], feeds[-1][:4], atol=1e-4)


def test_the_machine_of_the_examples_has_four_axes():
    assert load_machine(FOUR_AXES).rotaries == 1
    with pytest.raises(FiveAxisError):
        settings_of("part.stl", rotary_by="both")
