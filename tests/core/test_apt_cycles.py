# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drilling cycles of CL files: each hole written out as moves, in the forms of NX and Creo; what is no such
cycle is told."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.apt import ClReading, read_apt
from freecad_fiveaxis.core.toolpath.apt.cycles import GAP, cycle_of
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

R, C = int(Motion.RAPID), int(Motion.CUT)

CREO = """UNITS / MM
RAPID
GOTO / -7, -23, 2
CYCLE / DEEP, DEPTH, 3.500000, STEP, 2.000000, MMPM, 50.000000, CLEAR,$
 1.000000
GOTO / -7, -23, 0.5
GOTO / -16, -23, 0.5
CYCLE / OFF
RAPID
GOTO / -16, -23, 2
FINI
"""
NX = """RAPID
GOTO/66,0,300,0,0,1
CYCLE/DRILL,RAPTO,3.0000,FEDTO,-33.0000,RTRCTO,AUTO,MMPM,250.0000
PAINT/COLOR,31
GOTO/66.0000,0.0000,240.0000,0.0000000,0.0000000,1.0000000
GOTO/-255.0000,0.0000,240.0000
CYCLE/OFF
PAINT/SPEED,10
RAPID
GOTO/0,0,320
"""


def _heights(path: CLPath) -> list[tuple[float, float, int, float]]:
    """X, Z, motion and feed of each row."""
    return [
        (x, z, motion, feed)
        for (x, _, z), motion, feed in zip(
            path.tip.round(9).tolist(), path.motion.tolist(), path.feed.tolist(), strict=True
        )
    ]


def test_creos_deep_holes_are_pecked() -> None:
    path = read_apt(CREO)
    hole = [(1.5, R, 0), (-1.5, C, 50), (1.5, R, 0), (-1.5 + GAP, R, 0), (-3.0, C, 50), (1.5, R, 0)]
    every = [(-7, 2, R, 0), *((-7, *one) for one in hole), *((-16, *one) for one in hole), (-16, 2, R, 0)]
    assert _heights(path) == every and path.findings == ()


def test_nxs_holes_are_left_at_the_height_before_the_cycle() -> None:
    path = read_apt(NX)
    first = [(66, 300, R, 0), (66, 243, R, 0), (66, 207, C, 250), (66, 300, R, 0)]
    second = [(-255, 300, R, 0), (-255, 243, R, 0), (-255, 207, C, 250), (-255, 300, R, 0)]
    assert _heights(path) == [*first, *second, (0, 320, R, 0)] and path.findings == ()


@pytest.mark.parametrize(
    ("words", "leaves"), [("", 3), (",RTRCTO,4.0", 4), (",RTRCTO,1.0", 3), (",RETURN,8", 8)]
)
def test_the_height_at_which_holes_are_left(words: str, leaves: float) -> None:
    path = read_apt(
        f"FEDRAT/9\nRAPID\nGOTO/0,0,3\nCYCLE/DRILL,RAPTO,3,FEDTO,-5{words},MMPM,250\nGOTO/0,0,0\nGOTO/9,0,2\nCYCLE/OFF\n"
    )
    over = [(0, 5, R, 0)] if leaves < 5 else [(9, 8, R, 0)]
    ends = [(9, 5, R, 0), (9, -3, C, 250), (9, 2 + leaves, R, 0)]
    assert _heights(path) == [(0, 3, R, 0), (0, 3, R, 0), (0, -5, C, 250), (0, leaves, R, 0), *over, *ends]


def test_chips_are_broken_by_short_lifts() -> None:
    path = read_apt(
        "GOTO/0,0,9\nCYCLE/DRILL,BRKCHP,STEP,2,1,RAPTO,3,FEDTO,-4.5,MMPM,50\nGOTO/0,0,0\nCYCLE/OFF\n",
        ClReading(100.0),
    )
    assert [row[1] for row in _heights(path)] == [9, 3, -2, -2 + GAP, -3, -3 + GAP, -4, -4 + GAP, -4.5, 3]
    assert path.motion.tolist() == [C, R, C, R, C, R, C, R, C, R]


def test_bores_are_left_at_feed() -> None:
    text = "FEDRAT/80\nGOTO/0,0,9\nCYCLE/{},DEPTH,5,CLEAR,2{}\nGOTO/0,0,0\nCYCLE/OFF\n"
    for kind in ("BORE", "REAM"):
        assert _heights(read_apt(text.format(kind, "")))[1:] == [(0, 2, R, 0), (0, -5, C, 80), (0, 2, C, 80)]
    left = _heights(read_apt(text.format("REAM", ",RETURN,7")))
    assert left[1:] == [(0, 2, R, 0), (0, -5, C, 80), (0, 2, C, 80), (0, 7, R, 0)]


def test_holes_lie_along_the_tool_axis_and_in_the_files_unit() -> None:
    path = read_apt(
        "UNITS/INCHES\nGOTO/0,0,0,0,.6,.8\nCYCLE/DRILL,DEPTH,1,IPM,10,CLEAR,.5\nGOTO/1,0,0\nGOTO/2,0,0\n",
        ClReading(9.0),
    )
    axis = np.array([0, 0.6, 0.8])
    heights = [(0, 0.5), (1, 0.5), (1, -1), (1, 0.5), (2, 0.5), (2, -1), (2, 0.5)]
    assert np.allclose(path.tip[1:], [25.4 * (np.array([x, 0, 0]) + h * axis) for x, h in heights])
    assert np.allclose(path.feed[path.motion == C], [9.0, 254, 254]) and np.allclose(path.axis, axis)


def test_a_hole_with_another_axis_is_gone_to_straight() -> None:
    path = read_apt(
        "GOTO/0,0,50\nCYCLE/DRILL,RAPTO,2,FEDTO,-5,MMPM,50\nGOTO/0,0,0,0,0,1\nGOTO/0,50,0,0,1,0\n",
        ClReading(9.0),
    )
    assert np.allclose(path.tip[-4:], [[0, 0, 2], [0, 52, 0], [0, 45, 0], [0, 52, 0]])


def test_the_feed_of_a_hole_is_its_cycles_or_fedrats_even_per_turn() -> None:
    text = "SPINDL/RPM,500,CLW\nFEDRAT/80\nGOTO/0,0,9\nCYCLE/DRILL,DEPTH,5,{}CLEAR,2\nRAPID\nGOTO/0,0,0\nCYCLE/OFF\n"
    for words, feed in (("", 80), ("MMPR,.2,", 100), ("IPM,10,", 254)):
        assert read_apt(text.format(words)).feed[2] == pytest.approx(feed)
    with pytest.raises(ProgramError, match=r"line 4.*spindle"):
        read_apt(text.format("MMPR,.2,").replace("RPM,500,CLW", "OFF"))


@pytest.mark.parametrize(
    "rest",
    [
        "TAP,DEPTH,5,MMPM,100,CLEAR,2", "DRILL,126.0,85.0,1.0,MMPR", "DRILL,RAPTO,3,FEDTO,5,MMPM,10", "BORE,BACK,RAPTO,3,FEDTO,-5",
        "DRILL,DEPTH,5,MMPM,100", "DRILL,CLEAR,5,MMPM,100", "DRILL,DEPTH,5,FEDTO,-5,CLEAR,2", "DRILL,DEPTH,5,CLEAR,2,ORIENT,3",
        "DRILL,DEPTH,5,CLEAR,2,CLEAR,3", "DRILL,DEPTH,5,CLEAR,-2", "DEEP,DEPTH,5,CLEAR,2,STEP,0", "DEEP,DEPTH,5,CLEAR,2,STEP,1E-9",
        "DRILL,DEPTH,,CLEAR,2", "DRILL,DEPTH,5,CLEAR,2,MMPM,0", "ON", "", "DEEP", "DRILL,DEPTH,1E999,CLEAR,2",
    ],
)  # fmt: skip
def test_what_is_no_such_cycle_is_reported_by_name(rest: str) -> None:
    assert cycle_of(rest) is None
    path = read_apt(f"FEDRAT/9\nGOTO/0,0,9\nCYCLE/{rest}\nGOTO/0,0,0\nCYCLE/OFF\n")
    (found,) = path.findings
    assert (found.code, found.severity, found.line) == ("statement-not-interpreted", Severity.ERROR, 3)
    assert f"CYCLE/{rest.partition(',')[0]} is not interpreted" in found.text and len(path.tip) == 2


def test_a_cycle_that_is_not_interpreted_ends_the_one_before() -> None:
    path = read_apt(
        "FEDRAT/9\nGOTO/0,0,9\nCYCLE/DRILL,DEPTH,5,CLEAR,2\nGOTO/0,0,0\nCYCLE/TAP,DEPTH,5\nGOTO/1,0,0\n"
    )
    assert len(path.tip) == 5


@pytest.mark.parametrize(
    ("text", "code", "severity", "line"),
    [
        ("CYCLE/DEEP,DEPTH,5,CLEAR,2\nGOTO/0,0,0", "cycle-step-not-said", Severity.WARNING, 3),
        ("CYCLE/FACE,DEPTH,5,CLEAR,2,DWELL,1.5\nGOTO/0,0,0", "cycle-dwell-left-out", Severity.WARNING, 3),
        ("CYCLE/DRILL,DEPTH,5,CLEAR,2\nGODLTA/0,0,5", "no-hole-in-cycle", Severity.ERROR, 4),
        (
            "CYCLE/DRILL,DEPTH,5,CLEAR,2\nCIRCLE/0,0,0,0,0,1,5\nGOTO/0,0,0",
            "arc-does-not-fit",
            Severity.ERROR,
            4,
        ),
    ],
)
def test_what_of_a_cycle_is_left_out_is_reported(text: str, code: str, severity: Severity, line: int) -> None:
    (found,) = read_apt(f"FEDRAT/9\nGOTO/0,0,9\n{text}\n").findings
    assert (found.code, found.severity, found.line) == (code, severity, line)


def test_an_arc_may_start_where_a_hole_is_left() -> None:
    path = read_apt(
        "FEDRAT/9\nGOTO/10,0,5\nCYCLE/DRILL,DEPTH,5,CLEAR,2\nGOTO/10,0,0\nCYCLE/OFF\nCIRCLE/0,0,2,0,0,1,10\nGOTO/0,10,2\n"
    )
    assert path.findings == () and path.tip[3].tolist() == [10, 0, 2]
    assert np.allclose(np.hypot(*path.tip[3:, :2].T), 10) and np.allclose(path.tip[3:, 2], 2)


def test_a_file_of_holes_is_posted(tmp_path) -> None:
    (tmp_path / "holes.ncl").write_text(CREO)
    options = {"machine": "linuxcnc_xyzac_trt", "cutter": "flat:3", "output": str(tmp_path / "out.ngc")}
    result = job.run(build_settings("post", str(tmp_path / "holes.ncl"), options))
    assert not [found for found in result.findings if found.severity is Severity.ERROR]
    assert result.draft.program.words[:, 2].min() == pytest.approx(-3.0)


@pytest.mark.parametrize("end", ["LOADTL/2", "LOAD/TOOL,2", "TOOL PATH/NEXT,TOOL,M", "CIRCLE/5,0,0,0,0,1,5"])
def test_a_cycle_that_nothing_ends_ends_at_the_next_tool_operation_or_arc(end: str) -> None:
    arc = end if end.startswith("CIRCLE") else f"{end}\nGOTO/0,0,0\nCIRCLE/5,0,0,0,0,1,5"
    text = (
        "UNITS/MM\nFEDRAT/100,MMPM\nLOADTL/1\nGOTO/0,0,9\nCYCLE/DRILL,DEPTH,4,MMPM,50,CLEAR,2\nGOTO/0,0,0\n"
        + arc + "\nGOTO/10,0,0\nGOTO/20,0,0\nFINI\n"
    )  # fmt: skip
    path = read_apt(text)
    assert (path.tip[:, 2] < -1.0).sum() == 1, "one hole"
    assert abs(path.tip[:, 1]).max() > 4.0, "the arc is driven"
    found = [one for one in path.findings if one.code in ("arc-does-not-fit", "no-hole-in-cycle")]
    assert [(one.code, one.line, one.severity) for one in found] == [
        ("no-hole-in-cycle", 5, Severity.WARNING)
    ]
    assert "(line 7)" in found[0].text


@pytest.mark.parametrize("end", ["CYCLE/OFF\nLOADTL/2\nGOTO/1,1,1\n", "LOADTL/2\nFINI\n"])
def test_nothing_is_stated_where_no_move_follows_the_cycle(end: str) -> None:
    text = "UNITS/MM\nFEDRAT/100,MMPM\nCYCLE/DRILL,DEPTH,4,CLEAR,2\nGOTO/0,0,0\n"
    assert "no-hole-in-cycle" not in [one.code for one in read_apt(text + end).findings]
