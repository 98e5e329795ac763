# SPDX-License-Identifier: LGPL-2.1-or-later
"""What follows a move to a machine position: rapids from a place that nobody knows are no blocks, and of the
way back nothing is claimed, against fixtures neither."""

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge.check import program_motion
from freecad_fiveaxis.core.gouge.rapid_check import independent_rapids
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.motion.program import block_starts, find_unknown_ways
from freecad_fiveaxis.core.nc.reader.nc_reader import read_nc
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.report import blocks_csv
from freecad_fiveaxis.core.report.figures import summary

TRUNNION = chain(load_machine("trunnion_ac"), Setup())
BEGIN = "BEGIN PGM A MM\nL A+0 C+0 R0 FMAX\nL X+0 Y+0 R0 FMAX\nL Z+10 R0 FMAX M3\nL Z+1 F500\nL Z+10 FMAX\n"
AWAY = "L Z0 R0 FMAX M91\nL X0 Y-400 R0 FMAX M91\n"
BACK = "L C+90 R0 FMAX\nL X+60 Y+0 R0 FMAX\nL Z+10 R0 FMAX\n"
REST = "L Z+1 F500\nL Z+10 FMAX\nEND PGM A MM\n"


def klartext(text):
    return read_nc(text.encode(), TRUNNION, DIALECTS["heidenhain"])


def test_rapids_from_an_unknown_place_are_no_blocks_until_every_axis_has_a_word_again():
    program = klartext(BEGIN + AWAY + BACK + REST)
    assert program.line.tolist() == [4, 5, 6, 11, 12, 13]
    assert program.unknown_way.tolist() == [False, False, False, True, False, False]
    assert program.words[3].tolist() == [60, 0, 10, 90, 0] and program.seconds[3] == 0.0
    (found,) = [one for one in program.findings if one.code == "machine-position"]
    assert found.line == 7 and "the ways back" in found.text
    direct = klartext(BEGIN + BACK + REST)
    assert direct.unknown_way is None and len(direct.words) == 8


def test_a_retract_at_the_end_with_what_turns_the_axes_back_needs_no_warning():
    program = klartext(BEGIN + AWAY + "L A0 C0 R0 FMAX\nEND PGM A MM\n")
    assert program.line.tolist() == [4, 5, 6] and "machine-position" not in {
        one.code for one in program.findings
    }


@pytest.mark.parametrize("away", ["G53 G0 Z0", "G91 G28 Z0\nG90", "G30 Z0"])
def test_iso_codes_leave_the_same_gap_for_the_axes_that_they_name(away):
    text = f"G90 G21 G0 X0 Y0 Z10 A0 C0\nG1 Z1 F500\n{away}\nG0 C90\nX60 Y5\nZ10\nG1 Z1\nM2\n"
    program = read_nc(text.encode(), TRUNNION)
    assert find_unknown_ways(program).tolist() == [False, True, False]
    assert program.words[2].tolist() == [60, 5, 10, 90, 0]


def test_where_something_feeds_from_there_all_lines_stay_blocks():
    program = klartext(BEGIN + "L Z0 R0 FMAX M91\nL X+60 F500\nL Z+1 F500\nEND PGM A MM\n")
    assert program.unknown_way is None and len(program.words) == 5


def test_a_way_that_is_not_known_stands_at_its_end():
    program = klartext(BEGIN + AWAY + BACK + REST)
    swept, block = program_motion(TRUNNION, program), np.array([2, 3])
    tips = swept.pose(block, np.zeros(2)).tip
    np.testing.assert_allclose(tips[:, 0], swept.pose(block, np.ones(2)).tip[:, 0])
    assert tips[2, 1] == pytest.approx(10.0) and swept.pose(block, np.ones(2)).tip[2, 1] == pytest.approx(1.0)
    assert block_starts(program, np.array([0, 3, 4]))[:, 0].tolist() == [0, 60, 60]
    assert 2 not in independent_rapids(program)
    assert 2 in independent_rapids(klartext(BEGIN + "L X+60 C+90 R0 FMAX\n" + REST))


@pytest.fixture
def clamp(tmp_path):
    """Stand a clamp between the two places, higher than the tool goes there."""
    write_stl(from_triangles(box((25, -20, -5), (35, 20, 40))), tmp_path / "clamp.stl")
    return tmp_path / "clamp.stl"


@pytest.mark.parametrize(("away", "exit_code"), [(AWAY, 0), ("", 1)])
def test_a_clamp_between_is_hit_only_where_the_program_goes_there_itself(away, exit_code, clamp, capsys):
    """And an origin that begins with a minus is taken for one."""
    program = clamp.with_name("a.h")
    program.write_text(BEGIN + away + BACK.replace("L C+90 R0 FMAX\n", "") + REST)
    words = [
        "audit", str(program), "--machine", "trunnion_ac", "--fixture", str(clamp), "--cutter", "flat:8:30",
        "--tool-length", "100", "--origin", "-30,-5.5,0",
    ]  # fmt: skip
    assert main(words) == exit_code
    assert ("fixture-collision" in capsys.readouterr().out) is bool(exit_code)


def test_such_a_block_has_no_deviation_and_adds_no_length(tmp_path):
    (tmp_path / "a.h").write_text(BEGIN + AWAY + BACK + REST)
    for cutter in ("flat:8:30", "ball:6"):
        options = {"machine": "trunnion_ac", "cutter": cutter}
        result = job.run(build_settings("audit", str(tmp_path / "a.h"), options))
        assert result.deviation.segment[3] == 0.0 and result.deviation.place[3] == pytest.approx((0, 60, 10))
        found = summary(job.figures(result))
        assert found["rapid_length"] == pytest.approx(18.0) and found["max_rapid_deviation"] < 1e-9


def test_such_a_block_is_not_singular_however_far_it_turns_near_the_pole(tmp_path):
    """C turns by 90 deg with the tool upright: singular where the program goes there itself."""
    for away, block in ((AWAY, 3), ("", 3)):
        (tmp_path / "a.h").write_text(BEGIN + away + BACK + REST)
        result = job.run(build_settings("audit", str(tmp_path / "a.h"), {"machine": "trunnion_ac"}))
        assert bool(result.singularity.singular[block]) is not bool(away)
        assert bool(result.singularity.rotary_travel[block]) is not bool(away)
        table = blocks_csv(result.draft.program, result.deviation, result.singularity).decode().splitlines()
        column = next(row for row in table if "singular" in row).split(",").index("singular")
        rows = [row.split(",")[column] for row in table if row[:1].isdigit()]
        assert rows[block] == str(int(not away))


@pytest.mark.parametrize(
    ("text", "controller", "line", "axes"),
    [
        ("G90 G21 G0 X0 Y0 Z10 A0 C0\nG53 G0 Z0\nG1 X60 F500\nX70\nG0 Z10\nM2\n", "linuxcnc", 3, "Z"),
        ("G90 G21 G0 X0 Y0 Z10 A0 C0\nG91 G28 X0 Y0 Z0\nG90 G0 X60 Y0\nG1 Z-1 F500\nM2\n", "fanuc", 4, "Z"),
        ("G90 G71 G0 X0 Y0 Z10 A0 C0\nSUPA G0 Z0 C0\nG1 X60 F500\nM30\n", "siemens840d", 3, "Z, C"),
        (BEGIN + "L Z0 R0 FMAX M91\nL X+60 F500\nL Z+1 F500\nEND PGM A MM\n", "heidenhain", 8, "Z"),
    ],
)
def test_a_feed_from_where_the_machine_alone_knows_is_an_error(text, controller, line, axes):
    program = read_nc(text.encode(), TRUNNION, DIALECTS[controller])
    (found,) = [one for one in program.findings if one.severity is Severity.ERROR]
    assert (
        found.code == "feed-from-machine-position"
        and found.line == line
        and f"before {axes} has" in found.text
    )


@pytest.mark.parametrize(
    "back", ["G0 X60 Y5\nG0 Z10\nG1 Z1", "G0 Z10\nG1 X60", "G0 Z10\nG53\nG1 X60", "G0 Z10\nG1 Z1\nG91 X5"]
)
def test_a_feed_after_a_rapid_to_that_axis_is_none(back):
    text = f"G90 G21 G0 X0 Y0 Z10 A0 C0\nG1 Z1 F500\nG53 G0 Z0\n{back}\nM2\n"
    findings = read_nc(text.encode(), TRUNNION, DIALECTS["linuxcnc"]).findings
    assert not [one for one in findings if one.severity is Severity.ERROR]


@pytest.mark.parametrize(("before", "errors"), [("", 0), (" C0", 1)])
def test_axes_that_a_program_never_names_stay_where_they_are_taken(before, errors):
    """A program of three axes on a machine of five: G28 alone drives all, but its A and C are 0 throughout."""
    text = f"G90 G21 G0 X0 Y0 Z10{before}\nG1 Z1 F500\nG28\nG0 X60 Y0\nG0 Z10\nG1 Z1\nM2\n"
    program = read_nc(text.encode(), TRUNNION, DIALECTS["linuxcnc"])
    found = [one for one in program.findings if one.severity is Severity.ERROR]
    assert [one.code for one in found] == ["feed-from-machine-position"] * errors
    if errors:
        assert "before C has" in found[0].text
    else:
        assert program.unknown_way.tolist().index(True) == len(program.line) - 2


RETRACTED = BEGIN + "L Z+1 F500\nL M140 MB MAX{}\n"
FEEDS = "L X+60 F500\nL Z+1 F500\nEND PGM A MM\n"


@pytest.mark.parametrize("way", ["", " F MAX", " FMAX"])
def test_a_feed_right_after_a_retract_along_the_tool_is_an_error(way):
    for text in (RETRACTED.format(way) + FEEDS, RETRACTED.replace("MAX", "50").format(way) + FEEDS):
        (found,) = [one for one in klartext(text).findings if one.severity is Severity.ERROR]
        assert found.code == "feed-from-machine-position" and found.line == 9 and "before Z has" in found.text


def test_rapids_after_a_retract_along_the_tool_lead_back_from_an_unknown_height():
    program = klartext(RETRACTED.format("") + BACK + REST)
    assert program.line.tolist() == [4, 5, 6, 7, 11, 12, 13]
    assert program.unknown_way.tolist() == [False] * 4 + [True, False, False]
    assert program.words[4].tolist() == [60, 0, 10, 90, 0]
    assert not [one for one in program.findings if one.severity is Severity.ERROR]


def test_the_words_of_a_retracts_own_block_lead_from_its_end():
    """The manual's own form: the tool goes back first, then X and Y at F."""
    text = BEGIN + "L Z+1 F500\nL X+60 Y+5 F500 M140 MB MAX\n{}L Z+1 F500\nEND PGM A MM\n"
    program = klartext(text.format("L Z+10 FMAX\n"))
    assert not [one for one in program.findings if one.severity is Severity.ERROR]
    assert program.words[4].tolist() == [60, 5, 10, 0, 0] and program.unknown_way[4]
    (found,) = [one for one in klartext(text.format("")).findings if one.severity is Severity.ERROR]
    assert found.code == "feed-from-machine-position" and found.line == 9


@pytest.mark.parametrize(
    ("before", "axes"), [("L C+30\n", "Z"), ("M128\n", "X, Y, Z"), ("PLANE SPATIAL SPA+0 SPB+0 SPC+30 STAY\n", "X, Y, Z")]
)  # fmt: skip
def test_a_retract_loses_all_three_where_they_are_no_words_of_the_axes(before, axes):
    text = (
        BEGIN + before + "L X+1 Y+1 Z+1 F500\nL M140 MB MAX\nL Z+50 FMAX\nL C+31 F500\nL Z+1\nEND PGM A MM\n"
    )
    found = [one for one in klartext(text).findings if one.code == "feed-from-machine-position"]
    assert [one.text.split("before ")[1].split(" has")[0] for one in found] == (
        [] if axes == "Z" else ["X, Y"]
    )
