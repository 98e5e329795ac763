# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs of CL files, in the forms of NX, Creo and CATIA: which way round, how closely, and what does not
fit."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.pipeline.options import cl_reading
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.apt import ClReading, read_apt
from freecad_fiveaxis.core.toolpath.cl_path import Motion

RISE = np.sqrt(0.5)
# A quarter from (10, 0) to (0, 10) about the zero, against the clock seen from above: its middle is (10, 10)
# / sqrt(2).
QUARTERS = {
    "creo": "CIRCLE / 0.0, 0.0, 5.0,  $\n-0.0, 0.0, 1.0,  10.0\nGOTO / 0.0, 10.0, 5.0\n",
    "nx": "CIRCLE/0.0000,0.0000,5.0000,0.0000000,0.0000000,-1.0000000,10.0000,0.0600,0.5000,8.0000,0.0000\nPAINT/COLOR,31\nGOTO/0.0000,10.0000,5.0000\n",
    "catia": "AUTOPS\nINDIRV/ 0.00000, 1.00000, 0.00000\nTLON,GOFWD/ (CIRCLE/ 0.00000, 0.00000, 5.00000,$\n 10.00000),ON,(LINE/ 0.00000, 0.00000, 5.00000,$\n 0.00000, 10.00000, 5.00000)\n",
}  # fmt: skip


def _read(text: str, sagitta: float = 0.002) -> Floats:
    path = read_apt("FEDRAT/100\n" + text, ClReading(chord=sagitta))
    assert path.findings == ()
    return path.tip


@pytest.mark.parametrize("text", QUARTERS.values(), ids=QUARTERS)
def test_a_quarter_runs_against_the_clock_in_every_dialect(text: str) -> None:
    tip = _read("GOTO/10,0,5\n" + text)
    assert tip[0].tolist() == [10, 0, 5] and tip[-1].tolist() == [0, 10, 5] and len(tip) > 20
    assert np.allclose(np.hypot(tip[:, 0], tip[:, 1]), 10.0) and (tip[:, :2] >= -1e-12).all()
    assert np.linalg.norm(tip - (10 * RISE, 10 * RISE, 5), axis=1).min() < 0.5


@pytest.mark.parametrize("name", ["creo", "nx"])
def test_the_opposite_vector_takes_the_other_way(name: str) -> None:
    text = QUARTERS[name].replace("-1.0000000", "+1.0000000").replace(" 1.0,", " -1.0,")
    tip = _read("GOTO/10,0,5\n" + text)
    assert tip[:, :2].min() == pytest.approx(-10.0, abs=0.002) and len(tip) > 60


@pytest.mark.parametrize(("last", "turn"), [("0,0,-1", 0.0), ("0,1,0", 0.5 * np.pi)])
def test_on_an_arc_the_axis_turns_evenly_and_opposite_ones_stay_the_first(last: str, turn: float) -> None:
    text = f"MULTAX/ON\nFEDRAT/100\nGOTO/10,0,5,0,0,1\nCIRCLE/0,0,5,0,0,1,10\nGOTO/-10,0,5,{last}\n"
    path = read_apt(text, ClReading(chord=0.002))
    angle = turn * np.arctan2(path.tip[:-1, 1], path.tip[:-1, 0]) / np.pi
    assert np.abs(path.axis[:-1] - np.column_stack([0.0 * angle, np.sin(angle), np.cos(angle)])).max() < 1e-12
    assert len(angle) > 60 and path.axis[-1].tolist() == [float(number) for number in last.split(",")]


def test_catias_tangent_says_the_way_round() -> None:
    text = (
        QUARTERS["catia"]
        .replace("INDIRV/ 0.00000, 1", "INDIRV/ 0.00000, -1")
        .replace("ON,(LINE", "ON,2,INTOF,$\n(LINE")
    )
    tip = _read("GOTO/10,0,5\n" + text + "GOTO/0,20,5\n")
    assert tip[:, :2].min() == pytest.approx(-10.0, abs=0.002) and tip[-2].tolist() == [0, 10, 5]


@pytest.mark.parametrize("sagitta", [0.02, 0.002, 1e-4])
@pytest.mark.parametrize("radius", [0.001, 1.0, 513.0])
def test_the_true_circle_stays_within_the_sagitta(radius: float, sagitta: float) -> None:
    tip = _read(f"GOTO/{radius},0,0\nCIRCLE/0,0,0,0,0,1,{radius}\nGOTO/0,{-radius},0\n", sagitta)
    angle = np.linspace(0.0, 1.5 * np.pi, 4001)
    true = radius * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    first, way = tip[:-1], np.diff(tip, axis=0)
    worst = 0.0
    for point in true[:: max(1, len(tip) // 50)]:
        share = np.clip(((point - first) * way).sum(axis=1) / (way * way).sum(axis=1), 0.0, 1.0)
        worst = max(worst, np.linalg.norm(point - first - share[:, None] * way, axis=1).min())
    assert worst <= sagitta * (1 + 1e-9)
    assert len(tip) == 4 or worst > 0.3 * sagitta  # and no finer than needed


def test_a_helix_climbs_evenly_and_the_axis_turns_evenly() -> None:
    tip, axis, feed = (
        getattr(
            read_apt("FEDRAT/100\nGOTO/10,0,0,0,0,1\nCIRCLE/0,0,0,0,0,1,10\nGOTO/-10,0,6,0.6,0,0.8\n"), name
        )
        for name in ("tip", "axis", "feed")
    )
    share = np.unwrap(np.arctan2(tip[:, 1], tip[:, 0])) / np.pi
    assert np.allclose(tip[:, 2], 6 * share, atol=1e-9) and (feed == 100).all()
    assert np.allclose(np.arctan2(axis[:, 0], axis[:, 2]), share * np.arctan2(0.6, 0.8))
    assert np.allclose(np.linalg.norm(axis, axis=1), 1.0)


def test_the_same_start_and_end_is_a_whole_turn() -> None:
    tip = _read("GOTO/10,0,0\nCIRCLE/0,0,0,0,0,1,10\nGOTO/10,0,0\n")
    assert np.allclose(np.diff(np.unwrap(np.arctan2(tip[:, 1], tip[:, 0]))).sum(), 2 * np.pi)


def test_arcs_are_scaled_with_the_unit_and_stay_rapids() -> None:
    path = read_apt(
        "UNITS/INCHES\nFEDRAT/1\nGOTO/1,0,0\nRAPID\nCIRCLE/0,0,0,0,0,1,1\nGOTO/0,1,0\nGOTO/0,2,0\n"
    )
    assert np.allclose(np.hypot(*path.tip[:-1, :2].T), 25.4)
    assert (
        path.motion[1:-1].tolist() == [Motion.RAPID] * (len(path.tip) - 2) and path.motion[-1] == Motion.CUT
    )


def test_printed_digits_that_are_off_leave_no_step() -> None:
    tip = _read("GOTO/10.004,0,0\nCIRCLE/0,0,0,0,0,1,10\nGOTO/0,9.996,0\n")
    length = np.linalg.norm(np.diff(tip, axis=0), axis=1)
    assert np.ptp(length) < 0.01 * length.mean()


@pytest.mark.parametrize(
    ("text", "line", "value"),
    [
        ("GOTO/10,0,0\nCIRCLE/0,0,0,0,0,1,10\nGOTO/0,12.5,0\n", 3, 2.5), ("CIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\n", 2, 1),
        ("GOTO/10,0,0\nCIRCLE/0,0,0,0,0,1,10\n", 3, 1), ("GOTO/10,0,0\nCIRCLE/0,0,0,0,0,1,9\nCIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\n", 3, 1),
        ("GOTO/10,0,5\n" + QUARTERS["catia"].replace(" 0.00000, 1.0", " 1.00000, 0.0"), 4, 1),
    ],
)  # fmt: skip
def test_an_arc_that_does_not_fit_is_reported_and_goes_straight(text: str, line: int, value: float) -> None:
    path = read_apt("FEDRAT/100\n" + text)
    (found,) = path.findings
    assert (found.code, found.severity, found.line) == ("arc-does-not-fit", Severity.ERROR, line)
    assert found.value == pytest.approx(value)


CONTOUR = """GOTO/-20,-10,0
GOTO/20,-10,0
CIRCLE/20,0,0,0,0,1,10
GOTO/20,10,0
GOTO/-20,10,0
CIRCLE/-20,0,0,0,0,1,10
GOTO/-20,-10,0
"""


def test_a_contour_taken_the_wrong_way_round_runs_back() -> None:
    assert read_apt("FEDRAT/100\n" + CONTOUR).findings == ()
    (found,) = read_apt("FEDRAT/100\n" + CONTOUR.replace("0,0,1,10", "0,0,-1,10")).findings
    assert (found.code, found.severity, found.value, found.line) == ("arc-runs-back", Severity.ERROR, 2, 4)


def test_ends_that_are_too_near_to_tell_are_reported() -> None:
    (found,) = read_apt("FEDRAT/100\nGOTO/10,0,0\nCIRCLE/0,0,0,0,0,1,10\nGOTO/10,-0.001,0\n").findings
    assert (found.code, found.severity, found.line) == (
        "arc-runs-back",
        Severity.WARNING,
        3,
    ) and "a whole turn" in found.text
    (found,) = read_apt("FEDRAT/100\nGOTO/10,0,0\nCIRCLE/0,0,0,0,0,1,10\nGOTO/10,0.001,0\n").findings
    assert "the short way" in found.text


def test_the_jobs_tolerance_sets_the_sagitta() -> None:
    settings = build_settings("post", "path.apt", {"machine": "linuxcnc_xyzac_trt", "tolerance": "0.05"})
    assert cl_reading(settings).chord == pytest.approx(0.01)


def test_an_arc_of_a_file_of_catia_turns_by_its_quarter() -> None:
    """Numbers as CATIA prints them: the start follows from its tangent, (4.96057, -0.62667)."""
    text = "AUTOPS\nINDIRV/    0.12533,    0.99211,    0.00000\nTLON,GOFWD/      (CIRCLE/      0.00000,      0.00000,      2.00000,$\n"
    text += "       5.00000),ON,(LINE/      0.00000,      0.00000,      2.00000,$\n                               0.62667,      4.96057,      2.00000)\n"
    tip = _read("GOTO  /    4.96057,   -0.62667,    2.00000\n" + text)
    turned = np.unwrap(np.arctan2(tip[:, 1], tip[:, 0]))
    assert turned[-1] - turned[0] == pytest.approx(np.pi / 2, abs=1e-5) and (np.diff(turned) > 0).all()
