# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heidenhain's drilling cycles as moves, by hand; datums of the table; tools that differ from theirs."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_cycles import errors, path, read

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.nc.reader import heidenhain_cycles

HEAD = "0 BEGIN PGM T MM\n1 ; DRILL / DM=6 CR=0\n2 TOOL CALL 5 Z S500\n3 L X+0 Y+0 Z+20 A+0 C+0 R0 FMAX\n4 L F100\n"
LEVELS = {"Q200": 2, "Q201": -10, "Q203": 1, "Q204": 30}


def klartext(text: str, head: str = HEAD):
    return read(head + text, "heidenhain")


def hole(number: int, words: dict[str, float], head: str = HEAD):
    reported = " ~\n".join(f"   {name}={value:+} ;NOTE" for name, value in words.items())
    return klartext(f"5 CYCL DEF {number} NAME ~\n{reported}\nL X+5 Y+6 FMAX M99\n", head)


def reason(program) -> str:
    return " ".join(found.text for found in program.findings if found.code == "cycle-not-interpreted")


def test_203_breaks_chips_and_lessens_its_infeeds() -> None:
    words = {**LEVELS, "Q206": 150, "Q202": 4, "Q213": 2, "Q256": 0.5, "Q212": 1, "Q205": 1.5, "Q208": 500}
    program = hole(203, words)
    # infeeds 4, 3, 2, 1 (the rest; 1.5 at least): a break after the first two, a retract after the third
    assert path(program) == [
        "r 5 6 20", "r 5 6 3", "f 5 6 -3", "r 5 6 -2.5", "f 5 6 -6", "r 5 6 -5.5", "f 5 6 -8", "r 5 6 3", "r 5 6 -6", "f 5 6 -9",
        "f 5 6 3", "r 5 6 31",
    ]  # fmt: skip
    assert not errors(program) and program.feed[11] == 500
    assert "without Q256" in reason(hole(203, {**words, "Q256": -1}))


def test_207_taps_at_pitch_times_speed() -> None:
    program = hole(207, {**LEVELS, "Q239": 1.5})
    assert path(program) == ["r 5 6 20", "r 5 6 3", "f 5 6 -9", "f 5 6 3", "r 5 6 31"] and not errors(program)
    assert program.feed[3:5].tolist() == [750, 750]
    assert hole(207, {**LEVELS, "Q239": -1.5}).feed[3] == 750
    assert "speed" in reason(hole(207, {**LEVELS, "Q239": 1.5}, HEAD.replace("S500", "")))


def test_241_goes_slowly_over_a_start_below_the_surface() -> None:
    program = hole(241, {**LEVELS, "Q206": 150, "Q379": 5, "Q253": 50, "Q208": 300})
    assert path(program) == ["r 5 6 20", "r 5 6 3", "f 5 6 -3", "f 5 6 -9", "f 5 6 3", "r 5 6 31"]
    assert program.feed[3:6].tolist() == [50, 150, 300] and not errors(program)
    deep = hole(241, {**LEVELS, "Q201": -80, "Q206": 150, "Q379": 60})
    assert path(deep)[1:4] == ["r 5 6 3", "r 5 6 -57", "f 5 6 -79"]  # no more than Q200 over the start
    assert "Q202" in reason(hole(241, {**LEVELS, "Q206": 150, "Q202": 3}))


def test_208_mills_helices_about_the_hole() -> None:
    words = {**LEVELS, "Q206": 150, "Q334": 5, "Q335": 16}
    program = hole(208, words)
    x, y, z = program.words[:, :3].T
    cut = program.feed == 150
    assert not errors(program) and cut.any()
    radius = np.hypot(x - 5, y - 6)
    round_ = radius > 1e-6
    np.testing.assert_allclose(radius[round_ & (program.line == program.line[-1])], 5, atol=1e-6)
    angle = np.unwrap(np.arctan2(y - 6, x - 5)[round_ & cut])
    assert angle[-1] - angle[0] == pytest.approx(
        2 * np.pi * 4, abs=1e-6
    )  # 12 mm in three turns, then a circle: against the clock
    assert z.min() == pytest.approx(-9) and path(program)[-1] == "r 5 6 31"
    turn = round_ & cut & (z > -9 + 1e-9) & (z < 3)
    pitch = np.diff(z[turn]) / np.diff(np.unwrap(np.arctan2(y - 6, x - 5)[turn])) * 2 * np.pi
    assert pitch.min() == pytest.approx(-5, abs=1e-6)
    up_cut = hole(208, {**words, "Q351": -1})
    assert np.unwrap(np.arctan2(up_cut.words[:, 1] - 6, up_cut.words[:, 0] - 5)[round_ & cut])[-1] < 0


def test_208_asks_for_the_tools_diameter() -> None:
    words = {**LEVELS, "Q206": 150, "Q334": 5, "Q335": 16}
    assert "DM=16" in reason(hole(208, words, HEAD.replace("DM=6", "D=6")))
    assert "wider than the hole" in reason(hole(208, {**words, "Q335": 5}))
    assert path(hole(208, {**words, "Q335": 6}))[1:4] == ["r 5 6 3", "f 5 6 -9", "r 5 6 3"]
    wider = hole(208, words, HEAD.replace("S500", "S500 DR+0.5"))
    assert np.hypot(wider.words[:, 0] - 5, wider.words[:, 1] - 6)[wider.feed == 150].max() == pytest.approx(
        4.5, abs=1e-6
    )
    other = HEAD.replace("3 L X+0", "TOOL CALL 6 Z S400\n3 L X+0")
    assert "DM=16" in reason(hole(208, words, other))


def test_a_comment_belongs_to_the_call_right_below_it() -> None:
    found = heidenhain_cycles.diameters(
        b"1 ; / DM=5 CR=0\r\n2 L X+1\r\n3 * - TOOL: A / DM=7.5\r\n\r\n4 TOOL CALL 7 Z\r\n5 TOOL CALL 8 Z\r\n"
    )
    assert found == {4: 7.5}


def test_cycle_1_goes_by_steps_from_where_the_tool_stands() -> None:
    text = "CYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP -2\nCYCL DEF 1.2 DEPTH -20\nCYCL DEF 1.3 PECKG -15\nCYCL DEF 1.4 DWELL 0\nCYCL DEF 1.5 F80\n"
    program = klartext(text + "L X+5 Y+6 FMAX\nL Z+2 FMAX\nCYCL CALL\nL X+9\n")
    assert path(program) == [
        "r 5 6 20", "r 5 6 2", "f 5 6 -15", "r 5 6 2", "r 5 6 -14.4", "f 5 6 -20", "r 5 6 2", "f 9 6 2",
    ]  # fmt: skip
    assert program.feed[3] == 80 and program.feed[-1] == 100 and not errors(program)
    assert "1.5" in reason(klartext(text.replace("CYCL DEF 1.5 F80\n", "") + "L X+5 Y+6 FMAX M99\n"))
    assert "depth" in reason(klartext(text.replace("DEPTH -20", "DEPTH 20") + "L X+5 Y+6 FMAX M99\n"))
    assert "infeed" in reason(klartext(text.replace("PECKG -15", "PECKG 0") + "L X+5 Y+6 FMAX M99\n"))


def test_cycle_1_takes_clearance_and_infeed_without_a_sign_too_and_a_dwell_spelled_otherwise_moves_nothing() -> (
    None
):
    head = "L X+5 Y+6 Z+2 FMAX\nCYCLE DEF 9.0 DWELL TIME\nCYCLE DEF 9.1 5\nCYCL DEF 1.0 PECKING\n"
    text = "CYCL DEF 1.1 DIST{0}2.000\nCYCL DEF 1.2 DEPTH-20.000\nCYCL DEF 1.3 PLNGNG{0}15.0\nCYCL DEF 1.4 DWELL0\nCYCL DEF 1.5 F80\nL FMAX M99\n"
    plain, signed = (klartext(head + text.format(sign)) for sign in ("", "-"))
    assert path(plain) == path(signed) and "f 5 6 -20" in path(plain) and not errors(plain)


def test_what_a_cycle_lacks_is_found_once_and_the_rest_is_run() -> None:
    program = klartext(
        "Q1 = 5\nCYCL DEF 207 TAP ~\nQ200=2 ~\nQ201=-3\nL X+Q1 Y+6 FMAX M99\nL X+7 FMAX M99\nCALL LBL 1\nM30\nLBL 1\nL X+8\nLBL 0\n"
    )
    found = [one for one in program.findings if one.severity is Severity.ERROR]
    assert (
        [one.code for one in found] == ["cycle-not-interpreted"]
        and "without Q203" in found[0].text
        and found[0].line == 10
    )
    assert path(program) == ["r 5 6 20", "r 7 6 20", "f 8 6 20"]


@pytest.mark.parametrize(
    "other", ["CYCL DEF 4.0 POCKET\nCYCL DEF 4.1 SET UP -2\n", "CYCL DEF 251 POCKET ~\nQ215=0\n"]
)
def test_another_cycle_is_not_called_as_the_one_before(other: str) -> None:
    program = klartext(
        f"CYCL DEF 207 TAP ~\nQ200=2 ~\nQ201=-3 ~\nQ203=0 ~\nQ239=1\n{other}L X+5 Y+6 FMAX M99\n"
    )
    assert path(program) == ["r 5 6 20"] and "cycle-not-interpreted" in errors(program)


def test_one_datum_of_the_table_is_a_note_and_several_are_a_warning() -> None:
    one = klartext(
        "CYCL DEF 247 DATUM SETTING ~\nQ339=+3\nL X+1\nCYCL DEF 247 DATUM SETTING ~\nQ339=+3\nL X+2\n"
    )
    assert [(found.code, found.severity, found.line) for found in one.findings] == [
        ("datum-of-table", Severity.NOTE, 6)
    ]
    two = klartext(
        "CYCL DEF 247 DATUM SETTING ~\nQ339=+3\nL X+1\nCYCL DEF 247 DATUM SETTING ~\nQ339=+4\nL X+2\n"
    )
    (found,) = [one for one in two.findings if one.severity is Severity.WARNING]
    assert (found.code, found.value) == (
        "work-offset-change",
        2.0,
    ) and "Q339=3 (6), CYCL DEF 247 Q339=4 (9)" in found.text


@pytest.mark.parametrize(
    ("reported", "note"),
    [
        ("DL+0 DR+0", ""),
        ("DL-0.0 DR0", ""),
        ("DL+0.25", "DL+0.25"),
        ("DR-.1 DR2+0.", "DR-.1"),
        ("DL+Q5", "DL+Q5"),
    ],
)
def test_a_tool_that_differs_from_its_table_is_a_note(reported: str, note: str) -> None:
    program = klartext(f'TOOL CALL "DL+9" Z S1 {reported}\nL X+1\n')
    notes = [found.text for found in program.findings if found.code == "tool-delta"]
    assert (
        len(notes) == bool(note)
        and (not note or notes[0].startswith(f"TOOL CALL {note} "))
        and not errors(program)
    )


def test_201_reams_down_and_up_at_feed() -> None:
    program = hole(201, {**LEVELS, "Q206": 150, "Q208": 300})
    assert path(program) == ["r 5 6 20", "r 5 6 3", "f 5 6 -9", "f 5 6 3", "r 5 6 31"] and not errors(program)
    assert program.feed[3:5].tolist() == [150, 300]
    assert hole(201, {**LEVELS, "Q206": 150, "Q208": 0}).feed[4] == 150
    fast = klartext(
        "5 CYCL DEF 201 R ~\n Q200=2 ~\n Q201=-10 ~\n Q206=150 ~\n Q208= MAX ~\n Q203=1 ~\n Q204=30\nL X+5 Y+6 FMAX M99\n"
    )
    assert path(fast)[2:] == ["f 5 6 -9", "r 5 6 3", "r 5 6 31"]


@pytest.mark.parametrize(("way", "off"), [(1, "4.8 6"), (2, "5 5.8"), (3, "5.2 6"), (4, "5 6.2")])
def test_202_goes_off_the_wall_and_back_over_the_middle(way: int, off: str) -> None:
    program = hole(202, {**LEVELS, "Q206": 150, "Q208": 0, "Q214": way, "Q336": 30})
    assert path(program) == [
        "r 5 6 20", "r 5 6 3", "f 5 6 -9", f"f {off} -9", f"f {off} 3", f"r {off} 31", "r 5 6 31",
    ] and not errors(program)  # fmt: skip
    still = hole(202, {**LEVELS, "Q206": 150, "Q208": 0, "Q214": 0})
    assert path(still) == ["r 5 6 20", "r 5 6 3", "f 5 6 -9", "f 5 6 3", "r 5 6 31"]
    assert "Q214" in reason(hole(202, {**LEVELS, "Q206": 150, "Q214": 7}))


def test_205_stops_before_the_depth_reached_and_breaks_chips() -> None:
    words = {**LEVELS, "Q206": 150, "Q202": 4, "Q258": 0.4, "Q259": 0.8, "Q208": 0}
    program = hole(205, words)
    assert path(program) == [
        "r 5 6 20", "r 5 6 3", "f 5 6 -3", "r 5 6 3", "r 5 6 -2.6", "f 5 6 -7", "r 5 6 3", "r 5 6 -6.2", "f 5 6 -9",
        "f 5 6 3", "r 5 6 31",
    ] and not errors(program)  # fmt: skip
    breaks = hole(205, {**words, "Q202": 8, "Q257": 3, "Q256": 0.5})
    assert path(breaks)[1:] == [
        "r 5 6 3", "f 5 6 -2", "r 5 6 -1.5", "f 5 6 -5", "r 5 6 -4.5", "f 5 6 -7", "r 5 6 3", "r 5 6 -6.6", "f 5 6 -9",
        "f 5 6 3", "r 5 6 31",
    ]  # fmt: skip
    assert "Q379" in reason(hole(205, {**words, "Q379": 3}))
    assert "Q256" in reason(hole(205, {**words, "Q257": 3}))


def test_206_and_209_tap_at_feed_and_in_steps() -> None:
    program = hole(206, {**LEVELS, "Q206": 750})
    assert path(program) == ["r 5 6 20", "r 5 6 3", "f 5 6 -9", "f 5 6 3", "r 5 6 31"] and not errors(program)
    assert program.feed[3:5].tolist() == [750, 750]
    words = {**LEVELS, "Q239": 1.5, "Q257": 4, "Q256": 0.5, "Q403": 2}
    program = hole(209, words)
    assert path(program) == [
        "r 5 6 20", "r 5 6 3", "f 5 6 -3", "f 5 6 -2.25", "f 5 6 -7", "f 5 6 -6.25", "f 5 6 -9", "f 5 6 3", "r 5 6 31",
    ] and not errors(program)  # fmt: skip
    assert program.feed[3:9].tolist() == [750, 750, 750, 750, 750, 1500]
    out = hole(209, {**words, "Q256": 0})
    assert path(out)[2:7] == ["f 5 6 -3", "f 5 6 3", "f 5 6 -7", "f 5 6 3", "f 5 6 -9"]
    assert path(hole(209, {**words, "Q257": 0}))[2:] == ["f 5 6 -9", "f 5 6 3", "r 5 6 31"]
    assert "speed" in reason(hole(209, words, HEAD.replace("S500", "")))


def test_240_centres_by_its_depth_alone() -> None:
    program = hole(240, {**LEVELS, "Q343": 0, "Q206": 150})
    assert path(program) == ["r 5 6 20", "r 5 6 3", "f 5 6 -9", "r 5 6 3", "r 5 6 31"] and not errors(program)
    assert "Q343" in reason(hole(240, {**LEVELS, "Q343": 1, "Q344": -6, "Q206": 150}))


def test_old_tapping_goes_by_steps_from_where_the_tool_stands() -> None:
    tap = "CYCL DEF 2.0 TAPPING\nCYCL DEF 2.1 SET UP 2\nCYCL DEF 2.2 DEPTH -10\nCYCL DEF 2.3 DWELL 0.5\nCYCL DEF 2.4 F625\n"
    program = klartext(f"{tap}L X+5 Y+6 Z+2 FMAX M99\n")
    assert path(program) == ["r 5 6 2", "f 5 6 -10", "f 5 6 2"] and not errors(program)
    assert program.feed[2:].tolist() == [625, 625]
    rigid = "CYCL DEF 17.0 RIGID TAPPING\nCYCL DEF 17.1 SET UP 2\nCYCL DEF 17.2 DEPTH -10\nCYCL DEF 17.3 PITCH +1.25\n"
    program = klartext(f"{rigid}L X+5 Y+6 Z+2 FMAX\nCYCL CALL\n")
    assert path(program) == ["r 5 6 2", "f 5 6 -10", "f 5 6 2"] and program.feed[2:].tolist() == [625, 625]


def test_what_cycles_have_of_their_own_is_mm_in_programs_in_inches() -> None:
    inch = HEAD.replace(" MM", " INCH")
    off = hole(202, {**LEVELS, "Q206": 150, "Q214": 3}, inch)
    assert off.words[4, 0] - off.words[3, 0] == pytest.approx(0.2, abs=1e-4)
    tap = hole(207, {**LEVELS, "Q239": 0.05}, inch)
    assert tap.feed[3] == pytest.approx(0.05 * 500 * 25.4)
    peck = "CYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP 0.1\nCYCL DEF 1.2 DEPTH -1\nCYCL DEF 1.3 PECKG 0.5\nCYCL DEF 1.4 DWELL 0\nCYCL DEF 1.5 F30\n"
    pecked = klartext(f"{peck}L X+5 Y+6 Z+0.1 FMAX M99\n", inch)
    assert pecked.words[4, 2] - pecked.words[2, 2] == pytest.approx(0.6, abs=1e-4)


def test_words_of_a_cycle_in_lines_of_their_own_without_a_sign_that_it_goes_on() -> None:
    words = "   Q200=2 ;CLEARANCE\n   Q201 = -10 ;DEPTH\n\n   Q206=150\n   Q202=10\n   Q203=+1\n   Q204=30\n"
    for sign in (" ~", ""):
        program = klartext(f"5 CYCL DEF 200 DRILLING{sign}\n{words}6 L X+5 Y+6 FMAX M99\n")
        assert path(program) == ["r 5 6 20", "r 5 6 3", "f 5 6 -9", "r 5 6 3", "r 5 6 31"] and not errors(
            program
        )
        assert program.line[-1] == 14


def test_a_decimal_comma_is_a_point() -> None:
    program = klartext("5 L X+5,25 Y-,5 Z+1 F100,5\n6 Q1 = 2,5\n7 L X+Q1 IY-0,25\n")
    assert path(program) == ["f 5.25 -0.5 1", "f 2.5 -0.75 1"] and not errors(program)
    assert program.feed[1] == 100.5
    named = klartext('5 TOOL CALL "D8,5" Z S500\n6 L X+5 F100\n')
    assert path(named) == ["f 5 0 20"]


def test_words_without_a_number_as_old_controls_list_them_say_nothing() -> None:
    program = klartext("5 L X+5 Y+6 R F500 M\n6 L Z+1 R F M\n7 L X+9 R F MAX M3\n8 L Y+1 F M8\n9 L X+0 R\n")
    assert path(program) == ["f 5 6 20", "f 5 6 1", "r 9 6 1", "f 9 1 1", "f 0 1 1"] and not errors(program)
    assert program.feed[[1, 2, 4, 5]].tolist() == [500] * 4


def test_a_line_of_din_iso_in_klartext_is_named_and_changes_nothing_behind_it() -> None:
    program = klartext("5 L X+5 F500\n6 G91 G28 Z0.0\n7 L X+9 Y+1\n")
    assert path(program) == ["f 5 0 20", "f 9 1 20"]
    found = next(one for one in program.findings if one.code == "unknown-code")
    assert found.line == 7 and "G91 G28" in found.text
