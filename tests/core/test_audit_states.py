# SPDX-License-Identifier: LGPL-2.1-or-later
"""An audit follows spindle, tool length and end of a program line by line."""

from pathlib import Path

import pytest

from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report.figures import summary
from freecad_fiveaxis.core.report.scope import scope

STATES = {
    "spindle-off", "spindle-without-speed", "spindle-reversed", "tool-length-off", "tool-length-other",
    "guide-not-ended", "program-without-end",
}  # fmt: skip
GOLDEN = Path(__file__).parents[1] / "golden"
CONTROLLERS = ("fanuc", "haas", "linuxcnc", "mach3", "grbl", "siemens840d", "heidenhain", "heidenhain_m128")
ISO = "G21 G90 G94 G54\n{head}\nG0 X0 Y0 Z10 A0 C0\nG1 Z0 F100\n{middle}\nG1 X5\nX10\n{tail}\nM30\n"
KLARTEXT = (
    "BEGIN PGM A MM\n{head}\nL X0 Y0 Z10 A0 C0 FMAX\nL Z0 F100\n{middle}\nL X5\nL X10\n{tail}\nEND PGM A MM\n"
)
START = "T1 M6\nG43 H1\nS800 M3"
SIEMENS = 'T="MILL"\nM6\nD1\nS800 M3'
CALL = "TOOL CALL 1 Z S800\nM3"


def audit(folder, text, controller):
    nc = folder / "part.nc"
    nc.write_text(text, encoding="utf-8")
    return job.make(build_settings("audit", str(nc), {"machine": "trunnion_ac", "controller": controller}))


def find_states(folder, text, controller):
    findings = audit(folder, text, controller).findings
    return [(one.code, one.line, one.value) for one in findings if one.code in STATES]


def in_iso(folder, head=START, middle="", tail="M5", controller="mach3"):
    return find_states(folder, ISO.format(head=head, middle=middle, tail=tail), controller)


def in_siemens(folder, head=SIEMENS, middle="", tail="M5"):
    return find_states(folder, ISO.format(head=head, middle=middle, tail=tail), "siemens840d")


def in_klartext(folder, head=CALL, middle="", tail="M5"):
    return find_states(folder, KLARTEXT.format(head=head, middle=middle, tail=tail), "heidenhain")


@pytest.mark.parametrize("nc", sorted(path.name for path in GOLDEN.glob("*_g9*.nc")))
def test_our_own_programs_leave_nothing_open(tmp_path, nc):
    controller = nc.split("_g9")[0]
    assert controller in CONTROLLERS
    assert find_states(tmp_path, (GOLDEN / nc).read_text(encoding="utf-8"), controller) == []


@pytest.mark.parametrize("controller", ["fanuc", "haas", "linuxcnc", "mach3"])
def test_a_complete_program_has_nothing_to_say(tmp_path, controller):
    assert in_iso(tmp_path, controller=controller) == []
    assert in_siemens(tmp_path) == in_klartext(tmp_path) == []


def test_the_spindle_is_followed_from_block_to_block(tmp_path):
    assert in_iso(tmp_path, middle="M5") == [("spindle-off", 8, 2.0)]
    assert in_iso(tmp_path, middle="M5\nM3") == []
    assert in_iso(tmp_path, middle="X1 M5\nX2\nM3") == [("spindle-off", 8, 1.0)], "its own line ends before"
    assert in_siemens(tmp_path, middle="M5") == [("spindle-off", 9, 2.0)]
    numbered = 'T="MILL"\nM6\nD1\nS1=800 M1=3'
    assert in_siemens(tmp_path, numbered, "M1=5") == [("spindle-off", 9, 2.0)]
    assert in_siemens(tmp_path, numbered, "M1=5\nM1=3") == in_siemens(tmp_path, numbered, "; M1=5") == []
    assert in_siemens(tmp_path, numbered, "M2=5") == in_siemens(tmp_path, middle="M2=5") == []
    assert in_klartext(tmp_path, middle="L X2 M5\nL X3\nM13") == [("spindle-off", 7, 1.0)]


def test_it_is_followed_through_calls_in_the_order_of_the_control(tmp_path):
    text = "G21 G90\nT1 M6\nG43 H1\nS800 M3\nG0 X0 Y0 Z10 A0 C0\nM98 P2\nM5\nM98 P2\nM30\nO2\nG1 X5 F100\nX0\nM99\n"
    assert find_states(tmp_path, text, "fanuc") == [("spindle-off", 11, 2.0)]


def test_a_call_that_is_not_interpreted_may_start_the_spindle(tmp_path):
    assert in_iso(tmp_path, head="T1 M6\nG43 H1\nG65 P9000", controller="fanuc") == []
    assert in_siemens(tmp_path, head='T="MILL" M6 D1\nBUILDERS_START') == []


def test_feed_straight_up_is_a_retract(tmp_path):
    assert in_iso(tmp_path, tail="M5\nG1 Z50") == []


@pytest.mark.parametrize(("speed", "finds"), [("M3", 1), ("S0 M3", 1), ("M3\nS5", 0), ("S100 M3\nS0", 1)])
def test_a_spindle_needs_a_speed(tmp_path, speed, finds):
    found = [code for code, *_ in in_iso(tmp_path, head="T1 M6\nG43 H1\n" + speed)]
    assert found == ["spindle-without-speed"] * finds


def test_a_speed_that_is_not_known_is_not_taken_for_none(tmp_path):
    assert in_iso(tmp_path, head="T1 M6\nG43 H1\n#1=800\nS#1 M3", controller="fanuc") == []
    assert in_siemens(tmp_path, head='T="MILL" M6 D1\nS1=800 M1=3') == []
    assert in_klartext(tmp_path, head="TOOL CALL 1 Z SQ1\nM3") == []
    assert in_klartext(tmp_path, head="TOOL CALL 1 Z S0\nM3")[0][0] == "spindle-without-speed"
    assert in_siemens(tmp_path, head='T="MILL" M6 D1\nS1=0 M1=3')[0][0] == "spindle-without-speed"


def test_the_power_of_a_laser_is_no_speed(tmp_path):
    assert in_iso(tmp_path, head="M3 S0", middle="G1 X1 S800\nG1 X2 S0\nG1 X3 S500", controller="grbl") == []


def test_a_spindle_that_turns_to_the_left_is_reported(tmp_path):
    assert in_iso(tmp_path, head="T1 M6\nG43 H1\nS800 M4") == [("spindle-reversed", 6, 3.0)]
    assert in_klartext(tmp_path, head="TOOL CALL 1 Z S800\nM14")[0][0] == "spindle-reversed"
    assert in_iso(tmp_path, middle="M14", controller="fanuc") == [], "it may clamp an axis"


@pytest.mark.parametrize("controller", ["fanuc", "haas", "linuxcnc", "mach3"])
def test_after_a_tool_change_a_length_is_taken(tmp_path, controller):
    assert in_iso(tmp_path, head="T1 M6\nS800 M3", controller=controller) == [("tool-length-off", 5, 3.0)]
    assert in_iso(tmp_path, middle="G49", controller=controller) == [("tool-length-off", 8, 2.0)]
    zero = in_iso(tmp_path, head="T1 M6\nG43 H0\nS800 M3", controller=controller)
    assert zero == [("tool-length-off", 6, 3.0)]


def test_a_length_without_its_number_is_none_but_in_linuxcnc(tmp_path):
    head = "T1 M6\nG43\nS800 M3"
    assert in_iso(tmp_path, head, controller="linuxcnc") == []
    assert in_iso(tmp_path, head, controller="haas") == [("tool-length-off", 6, 3.0)]
    guided = "T1 M6\nS800 M3\nG43.4{h}"
    found = in_iso(tmp_path, guided.format(h=""), tail="G49\nM5", controller="fanuc")
    assert found == [("tool-length-off", 6, 3.0)]
    assert in_iso(tmp_path, guided.format(h=" H1"), tail="G49\nM5", controller="fanuc") == []


def test_the_length_is_that_of_the_tool_in_the_spindle(tmp_path):
    assert in_iso(tmp_path, head="T1 M6\nG43 H7\nS800 M3") == [("tool-length-other", 6, 3.0)]
    assert in_iso(tmp_path, middle="T2 M6") == [("tool-length-other", 8, 2.0)]
    assert in_iso(tmp_path, middle="T2 M6\nG43 H2") == []
    assert in_iso(tmp_path, middle="T2") == [], "called, and not yet changed to"
    assert in_iso(tmp_path, head="T1\nM6\nT2\nG43 H1\nS800 M3") == []


def test_a_rule_of_the_shop_is_worth_a_note(tmp_path):
    result = audit(tmp_path, ISO.format(head="T3 M6\nG43 H103\nS800 M3", middle="", tail="M5"), "fanuc")
    assert [one.severity for one in result.findings if one.code == "tool-length-other"] == [Severity.NOTE]


def test_siemens_and_heidenhain_take_the_length_with_the_tool(tmp_path):
    assert in_siemens(tmp_path, middle="D0") == [("tool-length-off", 9, 2.0)]
    assert in_siemens(tmp_path, head='D0\nT="MILL"\nM6\nS800 M3') == [], "D1 comes with the tool"
    assert in_klartext(tmp_path, middle="TOOL CALL 0 Z S800") == [("tool-length-off", 7, 2.0)]


def test_what_is_not_read_is_assumed(tmp_path):
    part = ISO.format(head="S800 M3", middle="", tail="M5")
    assert [str(one) for one in audit(tmp_path, part, "fanuc").assumed] == [
        "the length of the tool is active: no G43 was read"
    ]
    assert audit(tmp_path, part, "grbl").assumed == audit(tmp_path, ISO.format(
        head=START, middle="", tail="M5"), "fanuc").assumed == ()  # fmt: skip


def guide_left_on(folder, text, controller):
    result = audit(folder, text, controller)
    return [(one.line, one.severity) for one in result.findings if one.code == "guide-not-ended"]


@pytest.mark.parametrize(
    ("controller", "frame", "head", "off", "home"),
    [
        ("fanuc", ISO, "T1 M6\nS800 M3\nG43.4 H1", "G49", "G53 G0 X0 Y0"),
        ("fanuc", ISO, "T1 M6\nS800 M3\nG43.4 H1", "G49", "G0 A0 C0"),
        ("haas", ISO, "T1 M6\nS800 M3\nG234 H1", "G49", "G53 G0 X0 Y0"),
        ("siemens840d", ISO, SIEMENS + "\nTRAORI", "TRAFOOF", "SUPA G0 X0 Y0"),
        ("heidenhain", KLARTEXT, CALL + "\nFUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS", "FUNCTION RESET TCPM",
         "L X0 Y0 FMAX M91"),
        ("heidenhain_m128", KLARTEXT, CALL + "\nM128", "M129", "L A0 C0 FMAX"),
    ],
    ids=("fanuc", "fanuc rotary", "haas", "siemens", "heidenhain", "heidenhain M128"),
)  # fmt: skip
def test_axes_do_not_go_home_under_tool_centre_control(tmp_path, controller, frame, head, off, home):
    def findings(*tail):
        return guide_left_on(tmp_path, frame.format(head=head, middle="", tail="\n".join(tail)), controller)

    line = frame.format(head=head, middle="", tail="HERE").split("\n").index("HERE") + 1
    assert findings(home) == [(line, Severity.WARNING)]
    assert findings(off, home) == findings(home, off) == []
    assert [severity for _, severity in findings("M5")] == [Severity.NOTE]


def test_z_retracts_before_the_guide_is_switched_off(tmp_path):
    head = "T1 M6\nS800 M3\nG43.4 H1"
    text = ISO.format(head=head, middle="", tail="G53 G0 Z0\nG49\nG53 G0 Z0\nG0 A0 C0")
    assert guide_left_on(tmp_path, text, "fanuc") == []
    text = ISO.format(head=head, middle="", tail="G53 G0 Z0\nG0 A0 C0")
    assert guide_left_on(tmp_path, text, "fanuc") == [(11, Severity.WARNING)], "the line that turns"


def test_the_dynamic_offset_of_haas_ends_before_axes_go_home(tmp_path):
    text = ISO.format(head=START, middle="", tail="{off}G53 G0 X0 Y0").replace("G1 Z0", "G254\nG1 Z0", 1)
    assert guide_left_on(tmp_path, text.format(off=""), "haas") != []
    assert guide_left_on(tmp_path, text.format(off="G255\n"), "haas") == []


def without_end(folder, text, controller):
    result = audit(folder, text, controller)
    return [one.severity for one in result.findings if one.code == "program-without-end"]


def test_a_program_has_an_end(tmp_path):
    iso = ISO.format(head="{head}", middle="", tail="").replace("M30\n", "")
    assert without_end(tmp_path, iso.format(head=START), "fanuc") == [Severity.WARNING]
    assert without_end(tmp_path, iso.format(head="(a part)"), "fanuc") == [Severity.NOTE]
    assert without_end(tmp_path, "O2\n" + iso.format(head="") + "M99\n", "fanuc") == []
    assert without_end(tmp_path, f"%\n{iso.format(head=START)}%\n", "linuxcnc") == []
    assert without_end(tmp_path, f"%\n{iso.format(head=START)}%\n", "fanuc") == [Severity.WARNING]
    for end, finds in (("M17", 0), ("RET", 0), ("M30", 0), ("", 1)):
        assert len(without_end(tmp_path, iso.format(head=SIEMENS) + end, "siemens840d")) == finds
    klartext = KLARTEXT.format(head=CALL, middle="", tail="")
    assert without_end(tmp_path, klartext, "heidenhain") == []
    assert without_end(tmp_path, klartext.replace("END PGM A MM\n", ""), "heidenhain") == [Severity.WARNING]


def test_the_report_names_what_it_takes_for_granted(tmp_path):
    nc = tmp_path / "part.nc"
    nc.write_text(ISO.format(head="S800 M3", middle="", tail="M5"), encoding="utf-8")
    settings = build_settings("audit", str(nc), {"machine": "trunnion_ac", "controller": "fanuc"})
    figures = job.figures(job.run(settings))
    assumed = [str(one) for one in scope(figures, summary(figures)).assumed]
    assert "the length of the tool is active: no G43 was read" in assumed
