# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs whose tip the controller guides: what they say, what is proven of them, and what is not."""

from __future__ import annotations

import csv
import json

import numpy as np
import pytest

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings

APT = """UNITS/MM
MULTAX/ON
FEDRAT/800
RAPID
GOTO/0,0,60,0,0,1
RAPID
GOTO/10,0,40,0.1,0.2,0.974679434
GOTO/10,0,10,0.1,0.2,0.974679434
GOTO/11,3,10.5,-0.2,0.1,0.974679434
GOTO/12,7,9.5,-0.3,-0.3,0.905538514
GOTO/14,9,9.5,0.05,-0.4,0.915150261
RAPID
GOTO/14,9,60,0.05,-0.4,0.915150261
FINI
"""
GUIDED = [(name, how) for name, dialect in DIALECTS.items() for how in dialect.guides]
MACHINES = ["trunnion_ac", "head_b_table_c", "fork_head_bc", "linuxcnc_xyzac_trt"]


@pytest.fixture
def path_file(tmp_path):
    file = tmp_path / "path.apt"
    file.write_text(APT)
    return file


def posted(path_file, machine="trunnion_ac", **options):
    given = {"machine": machine, "tool_length": 120, "tool": 3, **options}
    return job.run(build_settings("post", str(path_file), given))


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize(("name", "how"), GUIDED)
def test_the_words_are_the_tip_and_the_axis_of_the_cl_path_within_half_a_step(path_file, machine, name, how):
    draft = posted(path_file, machine, controller=name, rtcp=how).draft
    program, path = draft.program, draft.joints.path
    rows = program.row
    assert np.abs(program.guided.tip - path.tip[rows]).max() <= 0.5 * 10.0**-draft.dialect.linear_decimals * (
        1 + 1e-9
    )
    tip, axis = forward(draft.kinematics, words_to_q(program.words))
    assert np.abs(tip - program.guided.tip).max() < 1e-9  # where the axes stand puts the tip exactly there
    if how == "vectors":
        assert np.abs(program.guided.vector - path.axis[rows]).max() <= 0.5e-7 * (1 + 1e-6)
    step = 10.0**-draft.dialect.rotary_decimals if how == "angles" else 0.0
    assert np.linalg.norm(axis - path.axis[rows], axis=1).max() <= np.radians(step) + 2e-7


def test_nothing_is_claimed_of_a_block_that_the_controller_guides(path_file):
    result = posted(path_file, rtcp="angles")
    joint = posted(path_file, linearize="off")
    numbers = job.figures(result)
    from freecad_fiveaxis.core.report import as_text
    from freecad_fiveaxis.core.report.figures import summary

    reported = summary(numbers)
    assert reported["guided_blocks"] == reported["feed_blocks"] > 0 and reported["proven"] is False
    assert reported["max_segment_deviation"] == reported["max_bound"] == 0.0
    assert reported["worst_line"] is None and not len(numbers.worst), (
        "no block is the worst of what nobody has measured"
    )
    assert (
        summary(job.figures(joint))["max_segment_deviation"] > 0.01
        and summary(job.figures(joint))["guided_blocks"] == 0
    )
    text = " ".join(as_text(numbers).split())
    assert (
        "Only block end points are verified in all 4 feed blocks: the path between them is under RTCP" in text
    )
    assert "- (the controller guides the tip: only block ends are verified)" in " ".join(text.split())
    assert "proven upper bound" not in text and "0.000000 mm" not in text
    found = [one for one in result.findings if one.code == "tip-guided-by-controller"]
    assert len(found) == 1 and "not proven here" in found[0].text and 0.0 < found[0].value < 2e-3
    assert not [one for one in result.findings if one.code == "deviation-over-tolerance"]
    assert [one for one in joint.findings if one.code == "deviation-over-tolerance"]


def test_the_rounding_that_is_stated_to_be_proven_is_that_of_the_words(path_file):
    draft = posted(path_file, rtcp="angles").draft
    tip, _ = forward(draft.kinematics, words_to_q(draft.program.words))
    off = np.linalg.norm(tip - draft.joints.path.tip[draft.program.row], axis=1).max()
    message = next(one for one in draft.program.findings if one.code == "tip-guided-by-controller").value
    assert message == pytest.approx(off, abs=1e-12)


def test_f_is_the_feed_of_the_tip_under_g94_and_the_blocks_time_under_g93(path_file):
    per_minute = posted(path_file, controller="fanuc", rtcp="angles", feed_mode="g94").draft.program
    inverse = posted(path_file, controller="fanuc", rtcp="angles", feed_mode="g93").draft.program
    chord = np.linalg.norm(np.diff(per_minute.guided.tip, axis=0), axis=1)
    rows = np.flatnonzero(per_minute.feed[1:] > 0)
    assert (per_minute.feed[1:][rows] <= 800).all() and (per_minute.feed[1:][rows] == 800).any()
    assert per_minute.seconds[1:][rows] == pytest.approx(60 * chord[rows] / per_minute.feed[1:][rows])
    assert inverse.seconds[1:][rows] == pytest.approx(per_minute.seconds[1:][rows], rel=1e-3)


def test_blocks_table_shows_the_words_of_the_nc_file(path_file, tmp_path):
    out, table, report = tmp_path / "a.ngc", tmp_path / "a.csv", tmp_path / "a.json"
    words = [
        "post",
        path_file,
        "--machine",
        "trunnion_ac",
        "--rtcp",
        "-o",
        out,
        "--blocks",
        table,
        "--report",
        report,
        "--quiet",
    ]
    assert cli.main([str(word) for word in words]) == cli.DONE
    lines, rows = out.read_text().splitlines(), list(csv.DictReader(table.read_text().splitlines()))
    assert "M428" in lines and "M429" in lines
    for row in rows:
        line = lines[int(row["line"]) - 1]
        assert "X" not in line or f"X{float(row['X']):.4f} " in line + " "
        assert float(row["segment_deviation"]) == 0.0
    data = json.loads(report.read_text())
    assert data["summary"]["guided_blocks"] > 0 and data["inputs"]["rtcp"] == "angles"


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (["--rtcp"], "angles"),
        (["--rtcp", "vectors"], "vectors"),
        (["--rtcp=angles"], "angles"),
        (["--rtcp", "off"], "off"),
        ([], "off"),
    ],
)
def test_rtcp_may_stand_bare_on_the_command_line_even_before_the_file(
    path_file, tmp_path, given, message, capsys
):
    report, out = tmp_path / "a.json", tmp_path / "a.mpf"
    words = [
        "post",
        *given,
        path_file,
        "--machine",
        "trunnion_ac",
        "--controller",
        "siemens840d",
        "-o",
        out,
        "--report",
        report,
    ]
    cli.main([str(word) for word in (*words, "--quiet")])
    assert json.loads(report.read_text())["inputs"]["rtcp"] == message


def test_true_in_a_job_file_means_the_same_as_the_bare_option(path_file):
    assert build_settings("post", "x.apt", {"machine": "trunnion_ac", "rtcp": True}).head.rtcp == "angles"
    assert build_settings("post", "x.apt", {"machine": "trunnion_ac", "rtcp": False}).head.rtcp == "off"


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"controller": "mach3", "rtcp": "angles"}, "mach3 does not guide the tip itself"),
        ({"controller": "grbl", "rtcp": "angles"}, "--linearize on"),
        ({"controller": "haas", "rtcp": "vectors"}, "give angles"),
        ({"controller": "fanuc", "rtcp": "angles", "tool": None}, "give --tool"),
        ({"rtcp": "angles", "linearize": "on"}, "give one"),
        ({"rtcp": "angles", "singularity": "linearize"}, "give one"),
        ({"controller": "grbl", "high_speed": "on"}, "no high-speed mode"),
    ],
)
def test_what_cannot_be_written_is_refused_with_its_remedy(path_file, options, message):
    with pytest.raises(SettingsError, match=message):
        posted(path_file, **options)


def test_the_high_speed_mode_stands_in_the_head(path_file):
    draft = posted(path_file, controller="heidenhain", high_speed="on", blend=0.02, rtcp="angles").draft
    nc = draft.nc.decode()
    first = nc.index(nc.split("\n")[int(draft.program.line[0]) - 1])
    assert nc.index("CYCL DEF 32.1 T0.0200") < nc.index("FUNCTION TCPM F TCP") < first
