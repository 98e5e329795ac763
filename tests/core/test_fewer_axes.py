# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines of three and four axes: their files, kinematics by hand, programs, audit, play, and what is
refused by name."""

from __future__ import annotations

import math
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from mesh_shapes import field
from plain import build_settings
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import FiveAxisError, MachineError, ReachError, SettingsError
from freecad_fiveaxis.core.calibration.tasks import prove as prove_signs
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.machine import (
    Axis,
    Machine,
    SafeStart,
    find_physical_columns,
    load_machine,
    save_machine,
)
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, inverse, words_to_q
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.pipeline import job, settings
from freecad_fiveaxis.core.pipeline.fewer_axes import suit_tool_axis
from freecad_fiveaxis.core.pipeline.outputs import write_outputs
from freecad_fiveaxis.core.report.machine_sketch import ToolRoom, sketch
from freecad_fiveaxis.core.report.playback import Playback
from freecad_fiveaxis.core.studies.study import try_machines, try_setups

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
PIVOT = (0.0, 20.0, -50.0)

LEVEL_APT = """UNITS/MM
FEDRAT/800
RAPID
GOTO/0,0,60
GOTO/0,0,10
GOTO/30,0,10
GOTO/30,20,5
RAPID
GOTO/30,20,60
FINI
"""
LEANING_APT = """UNITS/MM
MULTAX/ON
FEDRAT/800
RAPID
GOTO/0,0,60,0,0,1
GOTO/0,0,10,0,0,1
GOTO/30,10,10,0,0.5,0.866025404
GOTO/60,20,5,0,0.6,0.8
RAPID
GOTO/60,20,60,0,0.6,0.8
FINI
"""
ASIDE_APT = LEANING_APT.replace("0,0.5,0.866025404", "0.5,0,0.866025404")


def linear():
    return tuple(
        Axis(letter, False, "head", way, low=-500, high=500, max_rate=9000)
        for letter, way in zip("XYZ", (X, Y, Z), strict=True)
    )


def three(**more):
    return Machine("three", linear(), safe_start=SafeStart("none"), **more)


def table_a(way=X):
    return Machine(
        "table_a",
        (Axis("A", True, "table", way, PIVOT, max_rate=30.0), *linear()),
        safe_start=SafeStart("none"),
    )


def head_b():
    low, high = math.radians(-100), math.radians(100)
    return Machine(
        "head_b",
        (*linear(), Axis("B", True, "head", Y, low=low, high=high, max_rate=30.0)),
        safe_start=SafeStart("none"),
    )


MACHINES = {"three": three, "table_a": table_a, "head_b": head_b}


@pytest.fixture
def files(tmp_path):
    """A folder with the machines' files and the CL files."""
    for name, make in MACHINES.items():
        save_machine(make(), tmp_path / f"{name}.fcm")
    for name, text in (("level", LEVEL_APT), ("leaning", LEANING_APT), ("aside", ASIDE_APT)):
        (tmp_path / f"{name}.apt").write_text(text)
    return tmp_path


def posted(files, machine, path, **options):
    given = {"machine": str(files / f"{machine}.fcm"), "tool_length": 120, "spindle": 9000, **options}
    return job.run(build_settings("post", str(files / f"{path}.apt"), given))


def blocks(nc):
    return [line for line in nc.decode().splitlines() if line.startswith(("G0 ", "G1 "))]


@pytest.mark.parametrize("name", MACHINES)
def test_the_file_holds_the_axes_that_there_are_and_comes_back(name, files):
    machine = MACHINES[name]()
    text = (files / f"{name}.fcm").read_text()
    assert load_machine(files / f"{name}.fcm") == machine
    assert text.count('"role"') == len(machine.fitted) == 3 + machine.rotaries
    assert machine.has_head == (name == "head_b")


def test_a_rotary_axis_along_the_tool_alone_is_refused_with_the_remedy():
    with pytest.raises(MachineError, match=r"rotary axis C is parallel to the tool.*leave it out"):
        Machine("c", (Axis("C", True, "table", Z), *linear()))


def test_a_table_turns_the_part_about_its_pivot_as_by_hand():
    kinematics = chain(table_a(), Setup())
    q = np.array([[3.0, 7.0, 11.0, math.radians(30), 0.0]])
    tip, axis = forward(kinematics, q)
    cos, sin = math.cos(math.radians(30)), math.sin(math.radians(30))
    y, z = 7.0 - PIVOT[1], 11.0 - PIVOT[2]
    np.testing.assert_allclose(
        tip, [[3.0, PIVOT[1] + cos * y - sin * z, PIVOT[2] + sin * y + cos * z]], atol=1e-12
    )
    np.testing.assert_allclose(axis, [[0.0, -sin, cos]], atol=1e-12)


def test_a_head_swings_the_tool_by_its_length_as_by_hand():
    kinematics = chain(head_b(), Setup(tool_length=120.0))
    tip, axis = forward(kinematics, np.array([[0.0, 0.0, 0.0, math.radians(30), 0.0]]))
    np.testing.assert_allclose(
        tip, [[-120.0 * 0.5, 0.0, 120.0 * (1.0 - math.cos(math.radians(30)))]], atol=1e-12
    )
    np.testing.assert_allclose(axis, [[0.5, 0.0, math.cos(math.radians(30))]], atol=1e-12)


@pytest.mark.parametrize("name", MACHINES)
def test_inverse_is_the_way_back_and_never_near_a_pole(name):
    kinematics = chain(MACHINES[name](), Setup(tool_length=120.0))
    turn = np.zeros(50) if name == "three" else np.linspace(-1.5, 1.5, 50)
    q = np.column_stack(
        [np.linspace(-90, 90, 50), np.linspace(40, -40, 50), np.linspace(0, 30, 50), turn, np.zeros(50)]
    )
    words, sine = inverse(kinematics, *forward(kinematics, q))
    assert np.abs(words - q).max(axis=(2)).min(axis=0).max() < 1e-9
    np.testing.assert_allclose(sine, 1.0, atol=1e-12)


def test_a_program_of_three_axes_says_x_y_z_alone(files):
    result = posted(files, "three", "level")
    assert blocks(result.draft.nc) == [
        "G0 X0.0000 Y0.0000 Z60.0000", "G1 Z10.0000 F16.0000", "G1 X30.0000 F26.6666", "G1 Y20.0000 Z5.0000 F38.8057", "G0 Z60.0000",
    ]  # fmt: skip
    assert result.deviation.bound.max() < 1e-9
    assert not result.singularity.singular.any()


def test_a_program_of_four_axes_says_the_one_word_and_the_bound_holds(files):
    result = posted(files, "table_a", "leaning", linearize="off")
    program = result.draft.program
    assert all(set(re.findall("[A-Z_]", line)) <= set("GXYZAF") for line in blocks(result.draft.nc))
    assert "A-36.8699" in result.draft.nc.decode()
    q, rows = words_to_q(program.words), range(1, len(program.words))
    for row in rows:
        u = np.linspace(0.0, 1.0, 2001)[:, None]
        tip, _ = forward(result.draft.kinematics, q[row - 1] + u * (q[row] - q[row - 1]))
        chord = tip[-1] - tip[0]
        along = np.clip((tip - tip[0]) @ chord / max(chord @ chord, 1e-30), 0.0, 1.0)[:, None]
        off = np.linalg.norm(tip - tip[0] - along * chord, axis=1).max()
        assert off <= result.deviation.bound[row] + 1e-9
        assert off == pytest.approx(result.deviation.segment[row], abs=1e-4)
    assert result.deviation.segment.max() > 0.5


@pytest.mark.parametrize(("name", "path"), [("three", "level"), ("table_a", "leaning"), ("head_b", "aside")])
@pytest.mark.parametrize(
    "controller", ["linuxcnc", "fanuc", "haas", "siemens840d", "heidenhain", "mach3", "grbl"]
)
def test_what_is_posted_is_read_again_by_every_controller(files, name, path, controller):
    if name == "head_b":
        (files / "aside.apt").write_text(
            LEANING_APT.replace("0,0.5,0.866025404", "0.5,0,0.866025404").replace("0,0.6,0.8", "0.6,0,0.8")
        )
    outcome = posted(files, name, path, controller=controller, linearize="on").draft
    read = read_nc(outcome.nc, outcome.kinematics, outcome.dialect)
    np.testing.assert_allclose(read.words, outcome.program.words, atol=1e-9)
    assert not [finding for finding in read.findings if finding.code in ("unknown-axis", "position-unknown")]


def test_an_axis_out_of_reach_is_named(files):
    with pytest.raises(ReachError, match=r"A alone does not reach within its limits.*\(0.5, 0, 0.866025\)"):
        posted(files, "table_a", "aside")
    with pytest.raises(ReachError, match=r"leaning tool.*\(0, 0.5, 0.866025\).*no rotary axis.*fixed"):
        posted(files, "three", "leaning")


def test_machines_that_cannot_cut_a_path_are_rows_of_the_comparison_that_say_why(files, tmp_path):
    part = tmp_path / "part.stl"
    write_stl(from_triangles(field(2, lambda x, y: -0.02 * (x * x + x * y + y * y), spacing=10.0)), part)
    names = tuple(str(files / f"{name}.fcm") for name in ("three", "table_a")) + ("trunnion_ac",)
    given = {"machines": names, "cures": ("none",), "stepover": 10, "cutter": "ball:6"}
    rows = try_machines(build_settings("compare", str(part), given)).rows
    assert [(row.machine, bool(row.problem), math.isnan(row.deviation)) for row in rows[::2]] == [
        (names[0], True, True), (names[1], True, True), (names[2], False, False)
    ]  # fmt: skip
    assert "three has no rotary axis" in rows[0].problem and "A alone does not reach" in rows[2].problem
    with pytest.raises(SettingsError, match="three has no rotary axis"):
        try_machines(build_settings("compare", str(part), given | {"machines": names[:1]}))


def test_a_comparison_takes_a_cl_path_that_the_first_machine_cannot_drive(files):
    names = tuple(str(files / f"{name}.fcm") for name in ("three", "table_a"))
    given = {"machines": names, "cures": ("none",)}
    rows = try_machines(build_settings("compare", str(files / "leaning.apt"), given)).rows
    assert ["no rotary axis" in row.problem for row in rows] == [True, True, False, False]


def test_tool_axes_printed_with_four_decimals_are_within_reach(files):
    (files / "leaning.apt").write_text(LEANING_APT.replace("0,0.6,0.8", "0.0001,0.6000,0.8000"))
    assert not posted(files, "table_a", "leaning").draft.program.words[:, 4].any()


def test_a_word_of_an_axis_that_is_not_there_is_reported(files):
    kinematics = chain(three(), Setup())
    found = read_nc(b"G21 G90\nG0 X0 Y0 Z10 A0\nG1 X5 A3 F100\nM2\n", kinematics).findings
    assert [finding.code for finding in found if finding.severity.name == "ERROR"] == ["unknown-axis"]


@some_in_core(("name", "path"), [("three", "level"), ("table_a", "leaning")])
def test_audit_and_every_output_name_the_real_axes_alone(files, name, path):
    outcome = posted(files, name, path, linearize="on").draft
    nc = files / "out.ngc"
    nc.write_bytes(outcome.nc)
    reports = [str(files / ("report" + kind)) for kind in (".html", ".json", ".txt")]
    options = {
        "machine": str(files / f"{name}.fcm"),
        "report": reports,
        "blocks": str(files / "blocks.csv"),
        "tolerance": 0.05,
    }
    write_outputs(job.run(build_settings("audit", str(nc), options)))
    letters = "X,Y,Z" + (",A" if name == "table_a" else "")
    assert (files / "blocks.csv").read_text().splitlines()[0].startswith(f"block,line,motion,{letters},feed")
    for report in reports:
        text = Path(report).read_text(encoding="utf-8")
        assert '"-"' not in text and '"_"' not in text and "- turns" not in text


@pytest.mark.parametrize(("name", "path"), [("three", "level"), ("table_a", "leaning")])
def test_play_moves_what_there_is(files, name, path):
    result = posted(files, name, path)
    kinematics, program = result.draft.kinematics, result.draft.program
    pose = Playback(kinematics, program, result.deviation).at(float(program.seconds.sum()))
    np.testing.assert_allclose(pose.tip, forward(kinematics, words_to_q(program.words[-1:]))[0][0], atol=1e-9)
    bodies = sketch(kinematics, np.zeros(3), np.full(3, 20.0), ToolRoom(50.0, 5.0))
    carriers = {body.carrier for body in bodies} - {None}
    assert carriers <= set(find_physical_columns(kinematics.letters)) and (3 in carriers) == (
        name == "table_a"
    )


def test_the_dome_is_milled_with_the_tool_along_z(parts, files):
    options = {"machine": str(files / "three.fcm"), "tool_axis": "fixed", "stepover": 5, "spindle": 9000}
    result = job.run(build_settings("mill", str(parts / "dome.stl"), options))
    assert result.draft.keep.sum() > 0.4 * len(result.draft.keep)
    assert (result.draft.path.axis == (0.0, 0.0, 1.0)).all()
    assert result.deviation.bound.max() < 1e-9


@pytest.mark.parametrize(
    ("options", "reported"),
    [
        ({}, "cannot lean the tool as facet_mean asks: choose --tool-axis fixed"),
        ({"tool_axis": "fixed", "lead": 0.1}, "leave --lead out"),
        ({"tool_axis": "fixed", "gouge": "tilt"}, "choose --gouge lift"),
        ({"tool_axis": "fixed", "rtcp": "angles"}, "--rtcp.*leave it out"),
        ({"tool_axis": "fixed", "singularity": "deform"}, "has none; leave it out"),
    ],
)
def test_what_needs_a_leaning_tool_is_refused_with_the_remedy(parts, files, options, reported):
    with pytest.raises(SettingsError, match=reported):
        job.run(
            build_settings("mill", str(parts / "dome.stl"), {"machine": str(files / "three.fcm"), **options})
        )


@pytest.mark.oldest
@pytest.mark.thorough
def test_a_barrel_is_not_leaned_about_one_rotary_axis(parts, files):
    options = {"machine": str(files / "table_a.fcm"), "cutter": "barrel:10:85:2", "stepover": 5}
    with pytest.raises(SettingsError, match=r"leans 82 deg .* choose --tool-axis fixed for upright walls"):
        job.run(build_settings("mill", str(parts / "dome.stl"), options))
    upright = job.make(build_settings("mill", str(parts / "dome.stl"), {**options, "tool_axis": "fixed"}))
    assert (upright.path.axis == (0.0, 0.0, 1.0)).all()


@pytest.mark.parametrize(
    ("name", "strategy"), [("three", "fixed"), ("table_a", "facet_mean"), ("trunnion_ac", "auto")]
)
def test_a_tool_axis_that_is_not_named_is_one_that_the_machine_can_follow(name, strategy, files):
    machine = load_machine(name if name == "trunnion_ac" else files / f"{name}.fcm")
    open_, named = (
        settings.build_settings("mill", "a.stl", {"machine": "x", **given})
        for given in ({}, {"tool_axis": "auto"})
    )
    assert suit_tool_axis(open_, machine).tool_axis.tool_axis == strategy
    assert suit_tool_axis(named, machine) == named


def test_by_default_the_dome_is_milled_by_three_axes(parts, files):
    given = {"machine": str(files / "three.fcm"), "stepover": 5, "spindle": 9000}
    outcome = job.make(settings.build_settings("mill", str(parts / "dome.stl"), given))
    assert (outcome.path.axis == (0.0, 0.0, 1.0)).all()
    assert outcome.settings.tool_axis.tool_axis == "fixed" and outcome.settings.passes.passes == "scallop"


def test_the_studies_that_make_no_sense_are_refused(files):
    given = {"machine": str(files / "table_a.fcm"), "output": str(files / "signs.ngc")}
    with pytest.raises(SettingsError, match=r"fewer than two rotary axes.*jog"):
        prove_signs(build_settings("prove-signs", "", given))
    with pytest.raises(SettingsError, match=r"no rotary axis.*wherever the part is clamped"):
        try_setups(build_settings("setup", str(files / "level.apt"), {"machine": str(files / "three.fcm")}))


@pytest.mark.rs274
@pytest.mark.skipif(shutil.which("rs274") is None, reason="needs LinuxCNC")
def test_linuxcnc_reads_the_four_axes_as_they_are_written(files):
    outcome = posted(files, "table_a", "leaning", linearize="on").draft
    nc = files / "out.ngc"
    nc.write_bytes(outcome.nc)
    reported = subprocess.run(
        ["rs274", "-g", str(nc)], capture_output=True, text=True, timeout=60, check=True
    ).stdout
    moves = [line for line in reported.splitlines() if "STRAIGHT_FEED" in line]
    last = [float(word) for word in moves[-1].split("(")[1].rstrip(")").split(",")]
    feeds = outcome.program.words[outcome.program.motion != 3]
    np.testing.assert_allclose(last[:4], feeds[-1][:4], atol=1e-4)


def test_two_stand_ins_are_errors_of_no_machine():
    with pytest.raises(FiveAxisError, match="at most 2"):
        Machine(
            "six",
            (
                Axis("A", True, "table", X),
                Axis("B", True, "table", Y),
                Axis("C", True, "table", Z),
                *linear(),
            ),
        )
