# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC programs in inches: read again they are the program that was proven, and beside one in mm the same within
half a step of a word."""

import json
import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from mesh_shapes import field
from plain import build_settings
from rs274_judge import judged, needs_rs274
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import MachineError, SettingsError
from freecad_fiveaxis.core.controllers import DIALECTS, find_dialect
from freecad_fiveaxis.core.controllers.dialect import feed_distance
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.machine import load_machine, machine_path
from freecad_fiveaxis.core.nc.named_cutter import find_named_cutter
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.report.figures import summary
from freecad_fiveaxis.core.toolpath.cl_path import Motion

INCH = 25.4
ISO = ("linuxcnc", "haas", "fanuc", "grbl", "mach3", "siemens840d")
GUIDED = [("haas", "angles"), ("fanuc", "angles"), ("fanuc", "vectors"), ("siemens840d", "vectors")]
GIVEN = {"machine": "trunnion_ac", "tool_length": 120.0, "cutter": "ball:6", "stepover": 8.0, "tool": 3}
TALL = {"gouge": "off", "max_axis_angle": 60.0, "spindle": 9000.0}
CAP = from_triangles(field(8, lambda x, y: 5.0 * np.exp(-((x - 12.0) ** 2 + (y - 12.0) ** 2) / 60.0), 3.0))
"""A hill of 24 x 24 mm, 5 mm high."""


@cache
def milled(controller, **options):
    given = {**GIVEN, **TALL, "controller": controller, "nc_units": "inch", **options}
    return job.make(build_settings("mill", "part.stl", given), mesh=CAP)


def audited(draft, folder, controller):
    (folder / "part.nc").write_bytes(draft.nc)
    given = {"machine": "trunnion_ac", "tool_length": 120.0, "controller": controller, "cutter": "ball:6"}
    return job.make(build_settings("audit", str(folder / "part.nc"), given)).program


def shared(written, read):
    """The rows of the audited program that are blocks of the written one: those before are of its head."""
    first = len(read.words) - len(written.words) - int(read.line[-1] != written.line[-1])
    rows = np.flatnonzero(np.isin(read.line, written.line))
    assert first >= 0 and len(rows) == len(written.words)
    return rows


BOTH = [(controller, mode) for controller in ISO for mode in ("g93", "g94")]


@some_in_core(("controller", "mode"), BOTH, kept=(0, 3, 5, 7, 11))
def test_an_audit_reads_the_very_words_feeds_and_times(controller, mode, tmp_path):
    draft = milled(controller, feed_mode=mode)
    written, read = draft.program, audited(draft, tmp_path, controller)
    rows = shared(written, read)
    assert np.array_equal(read.words[rows], written.words)
    np.testing.assert_allclose(read.seconds[rows][1:], written.seconds[1:], rtol=1e-9)
    feeds = written.motion != Motion.RAPID
    np.testing.assert_allclose(read.feed[rows][feeds], written.feed[feeds], rtol=1e-12)
    assert {code for code in (b"G20", b"G700") if code in draft.nc} and b"G21" not in draft.nc
    assert b"G710" not in draft.nc


@some_in_core(("controller", "how"), GUIDED, kept=(0, 2))
def test_a_guided_program_too(controller, how, tmp_path):
    draft = milled(controller, rtcp=how, tool=3, feed_mode="g94")
    written, read = draft.program, audited(draft, tmp_path, controller)
    rows = shared(written, read)
    assert np.array_equal(read.guided.tip[rows], written.guided.tip)
    np.testing.assert_allclose(read.seconds[rows][1:], written.seconds[1:], rtol=1e-6)


@some_in_core("controller", ISO, kept=(1,))
def test_words_are_whole_steps_of_the_control_and_within_half_a_step_of_those_in_mm(controller):
    dialect = find_dialect(controller).in_inches()
    step = dialect.unit * 10.0**-dialect.linear_decimals
    inch, mm = milled(controller, linearize="off"), milled(controller, linearize="off", nc_units="mm")
    count = inch.program.words[:, :3] / step
    np.testing.assert_allclose(count, np.rint(count), atol=1e-6)
    both = np.intersect1d(inch.program.row, mm.program.row)
    near = [one.program.words[np.searchsorted(one.program.row, both)] for one in (inch, mm)]
    assert len(both) > 20 and np.abs(near[0] - near[1])[:, :3].max() <= 0.5 * (step + 1e-4) * (1 + 1e-9)
    assert np.array_equal(near[0][:, 3:], near[1][:, 3:])


def test_the_proof_is_of_the_rounded_words():
    """0.0001 in is 2.54 micrometres: blocks are divided until the words as they are printed hold the
    tolerance."""
    result, fine = (job.prove(milled("haas", nc_units=one)) for one in ("inch", "mm"))
    inch, mm = summary(job.figures(result)), summary(job.figures(fine))
    assert inch["max_surface_deviation"] <= 0.01 and mm["max_surface_deviation"] <= 0.01
    assert inch["max_surface_deviation"] != mm["max_surface_deviation"]


def numbers(text, letter):
    return [float(one) for one in re.findall(rf"{letter}(-?[\d.]+)", text)]


def test_all_lengths_of_the_head_are_in_inches():
    text, mm = (milled("linuxcnc", blend=0.0254, nc_units=one).nc.decode() for one in ("inch", "mm"))
    assert "G64 P0.00100 Q0.00100" in text and "G64 P0.0254 Q0.0254" in mm
    assert "L 4.7244 IN" in text and "L 120.000)" in mm
    for letter in "XYZ":
        head = [numbers(one.split("G1 ")[0], letter) for one in (text, mm)]
        np.testing.assert_allclose(np.array(head[0]) * INCH, head[1], atol=2e-4)
    assert find_named_cutter(text.encode()) == find_named_cutter(mm.encode()) is not None


def test_a_retract_to_a_machine_position_is_in_inches(tmp_path):
    data = json.loads(Path(machine_path("trunnion_ac")).read_text())
    data["fiveaxis"]["safe_start"] = {"retract": "machine", "Z": -12.7}
    (tmp_path / "own.fcm").write_text(json.dumps(data))
    assert b"G53 G0 Z-0.50000" in milled("linuxcnc", machine=str(tmp_path / "own.fcm")).nc


@pytest.mark.parametrize(
    ("controller", "change", "measured"),
    [
        ("linuxcnc", (25.4, 0, 0, 10, 0), 25.4),
        ("linuxcnc", (0, 0, 0, 30, 40), 50.0),
        ("fanuc", (0, 3 * INCH, 0, 0, 4), 5 * INCH),  # a degree counts as an inch
        ("fanuc", (0, 0, 0, 3, 4), 5.0),
        ("grbl", (0, 3.0, 0, 0, 4), 5.0),
        ("siemens840d", (0, 3.0, 0, 4, 0), 5.0),
    ],
)
def test_what_f_measures_is_as_the_manuals_have_it(controller, change, measured):
    dialect = find_dialect(controller).in_inches()
    assert feed_distance(dialect, np.array([change], float)) == pytest.approx(measured)
    alone = not any(change[:3])
    assert dialect.find_feed_units(np.array([change], float)) == (1.0 if alone else INCH)
    assert find_dialect("grbl").in_inches().find_feed_units(np.array([change], float)) == INCH


def test_heidenhain_programs_are_in_mm_and_the_message_says_what_to_do(tmp_path, capsys):
    with pytest.raises(SettingsError, match=r"in mm.*leave --nc-units out"):
        milled("heidenhain")
    (tmp_path / "own.fcm").write_text(imperial())
    assert b" MM" in milled("heidenhain", machine=str(tmp_path / "own.fcm"), nc_units="machine").nc


def imperial():
    data = json.loads(Path(machine_path("trunnion_ac")).read_text())
    data["output"] = {"units": "imperial"}
    return json.dumps(data)


def posted(path_file, machine, **options):
    given = {"machine": machine, "controller": "haas", "tool_length": 120.0, **options}
    return job.make(build_settings("post", str(path_file), given)).nc


@pytest.fixture
def path_file(tmp_path):
    lines = "UNITS/MM MULTAX RAPID GOTO/0,0,30,0,0,1 FEDRAT/300,MMPM GOTO/25.4,0,10,0,0,1 GOTO/50.8,5.08,10,0,0,1 FINI"
    (tmp_path / "part.apt").write_text("\n".join(lines.split(" ")))
    return tmp_path / "part.apt"


def test_the_machine_file_says_the_units_where_nobody_else_does(path_file, tmp_path):
    (tmp_path / "own.fcm").write_text(imperial())
    own = str(tmp_path / "own.fcm")
    assert load_machine(own).output_inch and not load_machine("trunnion_ac").output_inch
    assert posted(path_file, own) == posted(path_file, own, nc_units="inch")
    assert b"G20" in posted(path_file, own) and b"G21" in posted(path_file, own, nc_units="mm")
    assert b"G21" in posted(path_file, "trunnion_ac") and b"G20" not in posted(path_file, "trunnion_ac")


def test_a_unit_that_the_machine_file_cannot_mean_is_refused(tmp_path):
    (tmp_path / "own.fcm").write_text(imperial().replace('"units": "imperial"', '"units": "feet"'))
    with pytest.raises(MachineError, match=r"output\.units.*feet"):
        load_machine(str(tmp_path / "own.fcm"))


def test_the_command_line_takes_the_option(path_file, tmp_path):
    words = (
        "--machine trunnion_ac --controller haas --tool-length 120 --nc-units inch --feed-mode g94 --quiet"
    )
    assert cli.main(["post", str(path_file), *words.split(), "-o", str(tmp_path / "part.nc")]) == cli.DONE
    text = (tmp_path / "part.nc").read_text()
    assert "X1.0000 Z0.3937 F11.811" in text and "X2.0000 Y0.2000" in text


def test_every_controller_says_whether_it_writes_inches():
    assert {name for name, one in DIALECTS.items() if not one.inch} == {"heidenhain", "heidenhain_m128"}
    for one in DIALECTS.values():
        if one.inch:
            inch = one.in_inches()
            assert not any(re.search(rf"\b{one.metric}\b", line) for line in inch.head + inch.guided_head)


@pytest.mark.rs274
@needs_rs274
def test_linuxcncs_interpreter_goes_where_the_proof_has_it(tmp_path):
    draft = milled("linuxcnc")
    (tmp_path / "part.ngc").write_bytes(draft.nc)
    found = judged(tmp_path / "part.ngc")
    assert not found.refused
    ends = found.ends[-len(draft.program.words) - 1 : -1]
    columns = ["XYZABC".index(letter) for letter in draft.program.letters]
    np.testing.assert_allclose(ends[:, columns], draft.program.words, atol=found.off)
