# SPDX-License-Identifier: LGPL-2.1-or-later
"""CL files as CAMWorks writes them, and NX's helices and GOHOME; the forms are those of files, the texts are
our own."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.toolpath.apt import ClReading, read_apt, read_cl_file
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

R, C = int(Motion.RAPID), int(Motion.CUT)
HEAD = """PARTNO/1
UNIT/MM
INSERT/[HOLDER=C40] 6MM CRB 2FL 19 LOC
CUTTER/6.,0,3.,0,0,0,57.
LOAD/TOOL,3
CSI_SET_FLUTE_LENGTH/19.
CSI_SET_EXTENSION_LENGTH/30.
COOLNT/FLOOD
SPINDL/4000,RPM,CLW
INSERT/Stock Size X80. Y60. Z20.
TRNTYP/WORLD,0,0,0
CSYS/1.,0,0,0,0,1.,0,0,0,0,1.,0
SETUP/START,1
RAPID/
GOTO/10.,0,25.
FEDRAT/300.,MMPM
GOTO/10.,0,-2.
"""


def _rows(path: CLPath) -> list[tuple[float, float, int, float]]:
    """X, Z, motion and feed of each row."""
    columns = (
        path.tip[:, 0].round(9).tolist(),
        path.tip[:, 2].round(9).tolist(),
        path.motion.tolist(),
        path.feed.tolist(),
    )
    return list(zip(*columns, strict=True))


@pytest.mark.parametrize(("vector", "sweep"), [("1.", 90.0), ("-1.", 270.0)])
def test_a_circle_without_a_radius_has_that_of_its_start(vector: str, sweep: float) -> None:
    path = read_apt(f"{HEAD}CIRCLE/0,0,-2.,0,0,{vector}\nGOTO/0,10.,-2.\n", ClReading(chord=0.002))
    arc = path.tip[1:]
    assert path.findings == () and np.abs(np.hypot(arc[:, 0], arc[:, 1]) - 10.0).max() < 1e-9
    assert np.linalg.norm(np.diff(arc, axis=0), axis=1).sum() == pytest.approx(
        np.radians(sweep) * 10.0, rel=1e-3
    )


def test_a_circle_back_to_its_start_is_a_whole_turn_and_one_off_its_end_is_an_error() -> None:
    whole = read_apt(f"{HEAD}CIRCLE/0,0,-2.,0,0,1.\nGOTO/10.,0,-2.\n")
    assert whole.findings == () and whole.tip[:, 0].min() == pytest.approx(-10.0, abs=0.01)
    off = read_apt(f"{HEAD}CIRCLE/0,0,-2.,0,0,1.\nGOTO/0,11.,-2.\n")
    assert [(found.code, found.value) for found in off.findings] == [("arc-does-not-fit", 1.0)]


def _drilled(cycle: str, before: str = "CYCLE/INIT") -> list[tuple[float, float, int, float]]:
    text = f"{HEAD}{before}\n{cycle}\nGOTO/10.,0,0\nGOTO/30.,0,-4.\nCYCLE/OFF\n".replace(
        "GOTO/10.,0,-2.\n", "", 1
    )
    path = read_apt(text)
    assert path.findings == ()
    return _rows(path)[1:]


def test_a_drilled_hole_counts_fedto_downwards_and_leaves_at_rtrcto() -> None:
    rows = _drilled("CYCLE/DRILL,FEDTO,5.,MMPM,120.5,RAPTO,3.,RTRCTO,25.,DWELL,0")
    first, over = [(10, 3, R, 0), (10, -5, C, 120.5), (10, 25, R, 0)], [(30, 25, R, 0)]
    assert rows == [*first, *over, (30, -1, R, 0), (30, -9, C, 120.5), (30, 21, R, 0)]


@pytest.mark.parametrize(
    ("before", "words", "leaves"),
    [("CYCLE/CLEAR", ",RTRCTO,25.", 3), ("CYCLE/INIT", "", 25), ("CYCLE/INIT", ",RTRCTO,9.", 9), ("$$", ",RTRCTO,9.", 9), ("$$", "", 3)],
)  # fmt: skip
def test_cycle_init_and_clear_say_where_holes_are_left(before: str, words: str, leaves: float) -> None:
    assert _drilled(f"CYCLE/DRILL,FEDTO,5.,MMPM,120.5,RAPTO,3.{words}", before)[2] == (10, leaves, R, 0)


def test_first_and_further_pecks_come_to_the_bottom() -> None:
    rows = _drilled("CYCLE/DEEP2,FEDTO,9.5,1STPECK,5.,SUBPECK,2.,MMPM,90.,RAPTO,3.,RTRCTO,25.")
    assert [z for x, z, motion, _ in rows if x == 10 and motion == C] == [-5, -7, -9, -9.5]
    assert [z for x, z, motion, _ in rows if x == 10 and motion == R] == [3, 3, -4.5, 3, -6.5, 3, -8.5, 25]
    even = _drilled("CYCLE/DEEP,FEDTO,9.,INCR,4.,MMPM,90.,RAPTO,3.,RTRCTO,25.")
    assert [z for x, z, motion, _ in even if x == 10 and motion == C] == [-4, -8, -9]


@pytest.mark.parametrize(
    "cycle",
    ["DRILL,RAPTO,3.,FEDTO,5.,MMPM,9.", "DEEP2,FEDTO,5.,1STPECK,0.,SUBPECK,2.,MMPM,9.,RAPTO,3.", "DEEP2,FEDTO,5.,STEP,1.,1STPECK,2.,RAPTO,3.", "DRILL,FEDTO,5.,1STPECK,2.,RAPTO,3."],
)  # fmt: skip
def test_what_is_no_such_cycle_stays_an_error(cycle: str) -> None:
    found = read_apt(f"{HEAD}CYCLE/{cycle}\nGOTO/10.,0,0\nCYCLE/OFF\n").findings
    assert [(one.severity, one.code) for one in found] == [(Severity.ERROR, "statement-not-interpreted")]


def test_csys_says_the_axis_of_moves_without_one() -> None:
    side = "CSYS/0,0,1.,0,1.,0,0,0,0,1.,0,0\n"
    path = read_apt(
        f"{HEAD}{side}GOTO/20.,0,0\nGOTO/20.,5.,0,1.,0,0\nCSYS/-1.,0,0,99.,0,-1.,0,88.,0,0,1.,0\nGOTO/1.,1.,1.\n"
    )
    assert path.findings == ()
    assert path.axis.tolist() == [[0, 0, 1], [0, 0, 1], [1, 0, 0], [1, 0, 0], [0, 0, 1]]
    assert path.tip[-1].tolist() == [1, 1, 1]
    local = read_apt(f"{HEAD.replace('TRNTYP/WORLD,0,0,0', '$$')}{side}GOTO/20.,0,0\n")
    assert [found.code for found in local.findings] == ["several-coordinate-systems"]
    moved = read_apt(HEAD.replace("WORLD,0,0,0", "WORLD,0,5.,0"))
    assert [(found.severity, found.code) for found in moved.findings] == [
        (Severity.ERROR, "statement-not-interpreted")
    ]


def test_cutter_compensation_is_one_warning_and_a_contours_points_are_an_error() -> None:
    text = f"{HEAD}CUTCOM/LEFT\nGOTO/20.,0,-2.\nCUTCOM/OFF\nGOTO/30.,0,-2.\nCUTCOM/RIGHT,XYPLAN\nGOTO/40.,0,-2.\n"
    (found,) = read_apt(text).findings
    assert (found.severity, found.code, found.value, found.line) == (
        Severity.WARNING,
        "cutter-compensation",
        2.0,
        18,
    )
    (found,) = read_apt("$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_PROFILE\n" + text).findings
    assert (found.severity, found.code) == (Severity.ERROR, "cutter-compensation")
    assert read_apt(f"{HEAD}CUTCOM/OFF\n").findings == ()


def test_gohome_to_a_place_is_a_rapid_and_without_one_an_error() -> None:
    path = read_apt(f"{HEAD}GOHOME/50.,0,90.\n")
    assert _rows(path)[-1] == (50, 90, R, 0) and path.findings == ()
    assert [found.severity for found in read_apt(f"{HEAD}GOHOME\n").findings] == [Severity.ERROR]


def test_a_helix_goes_round_once_less_than_times_says() -> None:
    """From 3 o'clock to 12, 5 mm down; twice: a quarter and a turn."""
    head = "FEDRAT/100\nGOTO/10,0,5\nCIRCLE/0,0,0,0,0,-1,10.0000,0.0600,0.5000,8.0000,0.0000,TIMES,"
    for times, sweep in ((1, 90.0), (2, 450.0), (3, 810.0)):
        path = read_apt(f"{head}{times}\nGOTO/0,10,0\n", ClReading(chord=0.002))
        angle = np.degrees(np.unwrap(np.arctan2(path.tip[:, 1], path.tip[:, 0])))
        assert path.findings == () and angle[-1] == pytest.approx(sweep)
        assert np.abs(path.tip[:, 2] - 5.0 * (1.0 - angle / sweep)).max() < 1e-9
    assert [found.code for found in read_apt(f"{head}0\nGOTO/0,10,0\n").findings] == [
        "statement-not-interpreted"
    ]


def test_cusps_are_a_note_where_other_arcs_of_the_file_run_on() -> None:
    """Twice round a slot's ends, and once into a corner beside an island of 5 mm and back."""
    end = "GOTO/20,0,0\nCIRCLE/20,5,0,0,0,1\nGOTO/20,10,0\nGOTO/0,10,0\n"
    cusp = "GOTO/-5,10,0\nGOTO/-5,5,0\nCIRCLE/0,5,0,0,0,-1\nGOTO/0,10,0\nGOTO/-5,10,0\n"
    found = read_cl_file(f"FEDRAT/9\nGOTO/0,0,0\n{end}GOTO/0,0,0\n{end}{cusp}").path.findings
    assert [(one.severity, one.code, one.value) for one in found] == [(Severity.NOTE, "arc-runs-back", 1.0)]
    alone = read_cl_file(f"FEDRAT/9\nGOTO/0,10,0\n{cusp}").path.findings
    assert [(one.severity, one.code) for one in alone] == [(Severity.ERROR, "arc-runs-back")]
