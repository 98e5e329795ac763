# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program that proves signs: where it leads every machine, right or wrong, and whether the sheet says
so."""

import math
import re
import shutil
import subprocess
from dataclasses import replace

import numpy as np
import pytest
from bare_machines import BARE

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.calibration.prove_signs import (
    Wishes,
    make_plan,
    proof_nc,
    proof_program,
    sheet_html,
    sheet_json,
    sheet_text,
    wrong_machines,
)
from freecad_fiveaxis.core.calibration.prove_signs.plan import _last_pose
from freecad_fiveaxis.core.calibration.prove_signs.seen import linear_seen, rotary_seen
from freecad_fiveaxis.core.calibration.prove_signs.sheet import rows
from freecad_fiveaxis.core.controllers import DIALECTS, find_dialect
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, words_to_q
from freecad_fiveaxis.core.nc.head import PostOptions
from freecad_fiveaxis.core.nc.reader import read_nc

SETUP = Setup((0.0, 0.0, 0.0), 100.0)
WISHES = Wishes((30.0, 20.0, 0.0))

machines = pytest.mark.parametrize("name", BARE)


def plan(name, setup=SETUP, **wishes):
    return make_plan(load_machine(name), setup, replace(WISHES, **wishes))


def posted(name, controller="linuxcnc"):
    result, dialect = plan(name), find_dialect(controller)
    program = proof_program(result, dialect)
    return result, program, proof_nc(result, program, dialect, PostOptions())


def along(words):
    """Poses (n, 5) mm and rad, dense along all blocks."""
    q = words_to_q(words)
    u = np.linspace(0.0, 1.0, 41)[:, None, None]
    return (q[:-1] + u * np.diff(q, axis=0)).reshape(-1, 5)


def mirrored(name, letters):
    """The same machine with some rotary axes turning the other way."""
    machine = load_machine(name)
    axes = (
        replace(a, direction=tuple(-v for v in a.direction)) if a.letter in letters else a
        for a in machine.axes
    )
    return chain(replace(machine, axes=tuple(axes)), SETUP)


# Safe


@machines
def test_every_move_keeps_the_gap_and_the_limits_whatever_the_signs(name):
    result, program, _ = posted(name)
    q, letters = along(program.words), program.letters[3:]
    assert (q <= result.kinematics.high + 1e-9).all() and (q >= result.kinematics.low - 1e-9).all()
    swapped = q[:, [0, 1, 2, 4, 3]]
    tips = [forward(mirrored(name, which), q)[0] for which in ("", letters[0], letters[1], letters)]
    tips.append(forward(mirrored(name, ""), swapped)[0])
    for tip in tips:
        assert tip[:, 2].min() >= WISHES.place[2] + WISHES.gap - 1e-3


def test_without_that_care_a_wrong_sign_would_come_too_near():
    result, machine = plan("mikron_ucp710"), load_machine("mikron_ucp710")
    assert result.distance > WISHES.gap
    both = result.stops[-2].q[-1, 3:]
    near = _last_pose(result.kinematics, WISHES, both, WISHES.gap)[None]
    assert min(one.reach(near)[0][0, 2] for one in wrong_machines(machine, SETUP)) < WISHES.gap - 3.0


@machines
def test_every_block_is_a_feed_move_that_no_axis_exceeds(name):
    _, program, text = posted(name)
    assert not re.search(rb"^(N\d+ )?G0?0 ", text, re.M)
    change = np.abs(np.diff(program.words, axis=0)).max(axis=1)
    linear = np.linalg.norm(np.diff(program.words[:, :3], axis=0), axis=1)
    turned = np.linalg.norm(np.diff(program.words[:, 3:], axis=0), axis=1)
    minutes = np.where(linear > 0.0, linear, turned) / program.feed[1:]
    assert (change / np.maximum(minutes, 1e-9) <= WISHES.feed * 1.001).all()


@pytest.mark.parametrize(
    ("options", "problem"),
    [
        ({"setup": Setup((0.0, 0.0, 480.0), 0.0)}, "Z would leave its limits by"),
        ({"mark": (501.0, 0.0, 0.0)}, "X would leave its limits by"),
    ],
)
def test_what_does_not_fit_the_limits_is_refused_with_a_remedy(options, problem):
    with pytest.raises(SettingsError, match=problem):
        plan("trunnion_ac", **options)


def test_a_linear_axis_goes_to_the_side_that_its_limits_allow():
    assert any(
        stop.title == "X alone, -20 mm"
        for stop in plan("trunnion_ac", mark=(490.0, 0.0, 0.0), angle=np.radians(2.0)).stops
    )


def test_an_axis_turns_to_the_side_that_its_limits_allow():
    machine = load_machine("trunnion_ac")
    axes = [replace(a, high=np.radians(5.0)) if a.letter == "A" else a for a in machine.axes]
    result = make_plan(replace(machine, axes=tuple(axes)), SETUP, WISHES)
    assert any(stop.title == "A alone, -10 deg" for stop in result.stops)
    axes = [
        replace(a, low=-np.radians(5.0), high=np.radians(5.0)) if a.letter == "A" else a for a in machine.axes
    ]
    with pytest.raises(SettingsError, match="A cannot turn by 10 deg within its limits -5 to 5"):
        make_plan(replace(machine, axes=tuple(axes)), SETUP, WISHES)


NOTICE = "Nothing may stand above Z 0 of the work zero: remove the part, or give --mark as high as part and clamps reach."


def test_without_a_mark_the_first_line_says_that_nothing_may_stand_there():
    result = make_plan(load_machine("trunnion_ac"), SETUP, Wishes())
    program = proof_program(result, find_dialect("linuxcnc"))
    assert " ".join(sheet_text(result, program).split("\n\n")[0].split()) == NOTICE
    assert f'<p class="verdict bad">{NOTICE} At every stop' in sheet_html(result, program)
    assert (result.findings[0].code, result.findings[0].text) == ("mark-not-given", NOTICE)
    nc = proof_nc(result, program, find_dialect("linuxcnc"), PostOptions()).decode()
    assert (
        nc[: nc.index("M0")].rstrip().endswith("rotary axes at 0 - then go on)")
        and "nothing above Z 0 - stop 0" in nc
    )
    given, program, nc = posted("trunnion_ac")
    assert NOTICE not in " ".join(sheet_text(given, program).split()) and b"nothing above" not in nc
    assert not [one for one in given.findings if one.code == "mark-not-given"]


def test_the_tip_keeps_the_gap_to_the_mark_s_height():
    result = plan("trunnion_ac", mark=(30.0, 20.0, 40.0))
    tips = forward(result.kinematics, along(proof_program(result, find_dialect("linuxcnc")).words))[0]
    assert 40.0 + WISHES.gap - 1e-3 <= tips[:, 2].min() < 40.0 + WISHES.gap + 1e-3


# Right


@machines
def test_at_the_last_stop_the_tool_points_at_the_mark(name):
    result, program, _ = posted(name)
    last = rows(result, program)[-1]
    words = np.array([[last["words"][letter] for letter in program.letters]])
    tip, axis = forward(result.kinematics, words_to_q(words))
    np.testing.assert_allclose(tip[0] - result.distance * axis[0], WISHES.place, rtol=0, atol=1e-3)


def test_by_linuxcnc_s_own_formulas_too():
    result, program, _ = posted("linuxcnc_xyzac_trt")
    words = rows(result, program)[-1]["words"]
    joints, a, c = np.array([words[letter] for letter in "XYZ"]), *np.radians([words["A"], words["C"]])
    d = np.array([0.0, 20.0, 10.0])

    def tip(a, c):  # P = Rz(-C) (d + Rx(-A) (J - d))
        x, y, z = joints - d
        v = d + (x, np.cos(a) * y + np.sin(a) * z, np.cos(a) * z - np.sin(a) * y)
        return np.array([np.cos(c) * v[0] + np.sin(c) * v[1], np.cos(c) * v[1] - np.sin(c) * v[0], v[2]])

    k = np.array([np.sin(a) * np.sin(c), np.sin(a) * np.cos(c), np.cos(a)])
    np.testing.assert_allclose(tip(a, c) - result.distance * k, WISHES.place, rtol=0, atol=1e-3)
    predicted = dict(result.predicted_errors)
    for text, signs in (("C turns the wrong way", (1, -1)), ("A turns the wrong way", (-1, 1))):
        np.testing.assert_allclose(
            tip(signs[0] * a, signs[1] * c) - tip(a, c), predicted[text], rtol=0, atol=1e-3
        )
    np.testing.assert_allclose(tip(c, a) - tip(a, c), predicted["C and A are exchanged"], rtol=0, atol=1e-3)


@machines
def test_every_wrong_machine_is_seen_at_the_last_stop(name):
    result = plan(name)
    assert len(result.predicted_errors) == 4 and not result.findings
    assert min(np.linalg.norm(off) for _, off in result.predicted_errors) > 3.0


def test_a_mark_on_the_axis_of_the_table_hides_its_sign_and_that_is_stated():
    result = plan("trunnion_ac", mark=(0.0, 0.0, 0.0), angle=np.radians(2.0))
    assert {one.code for one in result.findings} == {"wrong-sign-hardly-seen"}


# What must be seen


def test_the_words_are_those_of_the_conventions():
    """docs/conventions.md: a table does A10 by turning the part's front edge up; LinuxCNC's trt machines do
    the opposite."""
    iso, other = ({s.title: s for s in plan(name).stops} for name in ("trunnion_ac", "linuxcnc_xyzac_trt"))
    assert (
        "clockwise by 10 deg, seen from the right; its front edge goes up, 17.4 mm"
        in iso["A alone, +10 deg"].see
    )
    assert "front edge going down: A has the wrong sign" in iso["A alone, +10 deg"].bad
    assert (
        "counter-clockwise by 10 deg, seen from the right; its front edge goes down"
        in other["A alone, +10 deg"].see
    )
    assert (
        "clockwise by 10 deg, seen from above; its front edge goes to the left" in iso["C alone, +10 deg"].see
    )


PLACES = {
    "right": (1.0, 0.0, 0.0),
    "left": (-1.0, 0.0, 0.0),
    "front": (0.0, -1.0, 0.0),
    "back": (0.0, 1.0, 0.0),
    "up": (0.0, 0.0, 1.0),
    "down": (0.0, 0.0, -1.0),
}


VIEWS = {"above": PLACES["up"], "front": PLACES["front"], "right": PLACES["right"]}


@machines
@pytest.mark.parametrize("turn", [0.3, -0.3])
def test_what_goes_where_agrees_with_the_forward_kinematics(name, turn):
    machine = load_machine(name)
    kinematics = chain(machine, SETUP)
    for k, axis in enumerate(machine.rotary):
        q = np.zeros((4, 5))
        q[:, 3 + k] = turn
        q[1:, :3] = np.eye(3)
        tip, tool = forward(kinematics, q)
        see, _ = rotary_seen(axis, "?", turn)
        edge, goes, size = re.search(
            r"(?:its (\w+) edge goes|tip swings) (?:to the )?(\w+)(?: and [a-z ]+)?, ([\d.]+) mm",
            see + ("" if " mm" in see else "tip swings up, 0 mm"),
        ).groups()
        if (
            axis.side == "table"
        ):  # linear steps, seen from the part, turn as the tool relative to it: the part turns back
            part_from_machine = (tip[1:] - tip[0]).T
            moved = (
                part_from_machine.T @ np.array(PLACES[edge]) - PLACES[edge]
            )  # that place of the part, in the machine
            along = float(moved @ np.array(PLACES[goes]))
            assert along * 100.0 == pytest.approx(float(size), abs=0.06)
            view = VIEWS[re.search(r"seen from (?:the )?(\w+)", see).group(1)]
            assert (np.cross(PLACES[edge], moved) @ view > 0.0) == ("turns counter-clockwise" in see)
        elif "about itself" not in see:
            moved = -tool[0] - (0.0, 0.0, -1.0)  # the tip hangs below the pivot along the tool
            assert float(moved @ np.array(PLACES[goes])) * 100.0 == pytest.approx(float(size), abs=0.06)


@pytest.mark.parametrize("lean", [45.0, 30.0, -60.0])
@pytest.mark.parametrize("turn", [0.17, -0.4])
def test_the_tip_of_a_nutating_head_swings_as_far_as_its_distance_from_the_leaning_axis_says(lean, turn):
    """By the closed form of a turn about a line: square to the plane of axis and tip the tip moves by its
    distance from the axis times the sine of the turn, whatever the axis leans."""
    along = np.array([0.0, math.sin(math.radians(lean)), math.cos(math.radians(lean))])
    head = next(axis for axis in load_machine("fork_head_bc").rotary if axis.letter == "B")
    nutating = replace(head, direction=tuple(along.tolist()))
    arm = np.array([0.0, -12.0, -260.0])
    see, _ = rotary_seen(nutating, "C", turn, arm)
    goes, size = re.search(r"the tip swings to the (\w+), ([\d.]+) mm for each 100 mm", see).groups()
    moved = (
        arm * math.cos(turn)
        + np.cross(along, arm) * math.sin(turn)
        + along * (along @ arm) * (1.0 - math.cos(turn))
        - arm
    )
    distance = float(np.linalg.norm(np.cross(along, arm)))
    assert moved @ np.array(PLACES[goes]) == pytest.approx(float(size) / 100.0 * distance, rel=3e-3)


def test_a_head_whose_tip_hangs_beside_its_upright_axis_swings():
    head = next(axis for axis in load_machine("fork_head_bc").rotary if axis.letter == "C")
    beside = np.array([80.0, 0.0, -200.0])
    assert "the tip swings to the back, 17.4 mm" in rotary_seen(head, "B", math.radians(10.0), beside)[0]
    assert (
        "the tool turns about itself" in rotary_seen(head, "B", math.radians(10.0), beside * (0.1, 0, 1))[0]
    )


def test_a_table_goes_the_other_way_than_the_tool_seen_from_the_part():
    x = next(axis for axis in load_machine("fork_head_bc").axes if axis.letter == "X")
    see, bad = linear_seen(x, 20.0)
    assert (
        x.side == "table"
        and "the table goes to the left by 20 mm; the tool, seen from the part, goes to the right" in see
    )
    assert "table goes to the right" in bad


# The files


@machines
@pytest.mark.parametrize("controller", sorted(DIALECTS))
def test_the_program_is_read_back_word_by_word_and_waits_at_every_stop(name, controller):
    result, program, text = posted(name, controller)
    again = read_nc(text, result.kinematics, find_dialect(controller))
    np.testing.assert_allclose(again.words, program.words, rtol=0, atol=1e-9)
    np.testing.assert_array_equal(again.line, program.line)
    lines = text.decode().splitlines()
    stops = rows(result, program)
    assert sum(line.split()[-1:] == ["M0"] for line in lines) == len(stops) + 1
    for stop in stops:
        assert (
            lines[stop["line"] + 1].split()[-1] == "M0"
            and f"stop {stop['number']} " in lines[stop["line"]].lower()
        )


@pytest.mark.parametrize("controller", [name for name, dialect in DIALECTS.items() if dialect.number_all])
def test_where_every_line_has_a_number_those_of_the_stops_have_one_too(controller):
    lines = posted("trunnion_ac", controller)[2].decode().splitlines()
    assert [int(line.split()[0]) for line in lines] == list(range(len(lines)))
    assert sum(line.endswith(" M0") for line in lines) == 9
    assert lines[-1] == f"{len(lines) - 1} END PGM 0001 MM"


def test_the_sheet_names_every_stop_with_its_line_and_its_wrong_look():
    result, program, _ = posted("trunnion_ac")
    text, html, record = sheet_text(result, program), sheet_html(result, program), sheet_json(result, program)
    for stop in rows(result, program):
        assert f"stop {stop['number']}, line {stop['line']}: {stop['title']}" in text
        assert stop["see"].replace("'", "&#x27;") in html and stop["title"] in record
    assert html.count("\u2610") == len(rows(result, program)) and "@media print" in html
    assert max(map(len, text.splitlines())) <= 100


rs274 = pytest.mark.skipif(
    shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed"
)


def interpreted(text, folder):
    (folder / "p.ngc").write_bytes(text)
    return subprocess.run(
        ["rs274", "-g", "p.ngc"],
        cwd=folder,
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        timeout=60,
    )


@pytest.mark.rs274
@rs274
@machines
def test_linuxcnc_accepts_it_and_stops_as_often_as_the_sheet_says(name, tmp_path):
    result, program, text = posted(name)
    done = interpreted(text, tmp_path)
    assert done.returncode == 0, done.stderr[-400:]
    assert done.stdout.count("PROGRAM_STOP()") == len(rows(result, program)) + 1


@pytest.mark.rs274
@rs274
def test_linuxcnc_would_refuse_a_broken_one(tmp_path):
    assert interpreted(posted("trunnion_ac")[2].replace(b"M0", b"M0 M0 M1", 1), tmp_path).returncode != 0
