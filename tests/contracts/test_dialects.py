# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds for every controller dialect in the table, and will hold for the next one."""

from __future__ import annotations

import re
import shutil
import string
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.controllers import DIALECTS, Dialect, find_dialect
from freecad_fiveaxis.core.controllers.dialect import feed_distance
from freecad_fiveaxis.core.machine import (  # fmt: skip
    BY_CLEARANCE,
    BY_MACHINE,
    BY_NOTHING,
    BY_REFERENCE,
    Axis,
    Machine,
    SafeStart,
    load_machine,
)
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, forward, words_to_q
from freecad_fiveaxis.core.motion.joint_path import JointPath, solve
from freecad_fiveaxis.core.motion.program import Program, build_program
from freecad_fiveaxis.core.nc.head import SLOTS, PostOptions
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.nc.start import by_reference, with_start
from freecad_fiveaxis.core.nc.writer import write_nc
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

EVERY = pytest.mark.parametrize("dialect", DIALECTS.values(), ids=DIALECTS)
MODES = [
    (dialect, inverse)
    for dialect in DIALECTS.values()
    for inverse in (True, False)
    if dialect.inverse_time or not inverse
]
EVERY_MODE = pytest.mark.parametrize(
    ("dialect", "inverse_time"), MODES, ids=[f"{d.name}-{'g93' if i else 'g94'}" for d, i in MODES]
)
needs_rs274 = pytest.mark.skipif(
    shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed"
)


def machine(first: str, second: str) -> Chain:
    direction = {"A": (1, 0, 0), "B": (0, 1, 0), "C": (0, 0, 1)}
    linear = [
        Axis(name, False, "head", tuple(row), max_rate=10000.0)
        for name, row in zip("XYZ", np.eye(3), strict=True)
    ]
    rotary = [
        Axis(name, True, "table", direction[name], (0, 10, 20), max_rate=60.0) for name in (first, second)
    ]
    return chain(Machine("any", (*rotary, *linear)), Setup())


LINKS = machine("C", "A")


def some_joints(kinematics: Chain, rows: int = 300, seed: int = 0) -> JointPath:
    """Moves of every kind, some along one axis alone, some of nothing at all."""
    random = np.random.default_rng(seed)
    step = random.normal(0, 1, (rows, 5)) * (2, 2, 2, 0.05, 0.05) * (random.random((rows, 5)) < 0.6)
    q = np.cumsum(step, axis=0) + (0, 0, 60, 0, 0)
    tip, axis = forward(kinematics, q)
    motion = random.choice([Motion.RAPID, Motion.LINK, Motion.CUT, Motion.CUT, Motion.FILL], rows).astype(
        np.int8
    )
    motion[0] = Motion.RAPID
    none = np.full(rows, -1)
    path = CLPath(
        tip, axis, motion, np.where(motion == Motion.RAPID, 0.0, 800.0), tip, axis, none, none, none
    )
    return JointPath(path, np.arange(rows), q, np.zeros(rows, np.int8), np.ones(rows))


def some_program(dialect: Dialect, inverse_time: bool, kinematics: Chain = LINKS) -> Program:
    return build_program(some_joints(kinematics), kinematics, dialect, inverse_time)


def block_lines(text: bytes, dialect: Dialect) -> list[str]:
    """The blocks without their numbers."""
    lines = text.decode("ascii").split(dialect.newline)
    lines = lines[len(dialect.head) : len(lines) - len(dialect.tail) - 1]
    return [line.split(" ", 1)[1] for line in lines] if dialect.number_step else lines


@EVERY_MODE
@pytest.mark.parametrize("letters", ["CA", "CB", "AB", "BA"])
@pytest.mark.parametrize("modal", [True, False], ids=["modal", "all-words"])
def test_every_word_is_read_back_exactly_as_it_was_rounded(dialect, inverse_time, letters, modal) -> None:
    kinematics, dialect = machine(*letters), replace(dialect, modal=modal)
    joints = some_joints(kinematics)
    program = build_program(joints, kinematics, dialect, inverse_time)
    again = read_nc(write_nc(program, dialect, "part"), kinematics, dialect)
    assert np.array_equal(again.words, program.words)
    assert np.array_equal(again.feed, program.feed) and np.array_equal(
        again.inverse_time, program.inverse_time
    )
    assert np.array_equal(again.line, program.line)
    assert np.array_equal(again.motion == Motion.RAPID, program.motion == Motion.RAPID)
    assert np.allclose(again.seconds, program.seconds, rtol=1e-12)
    assert again.findings == ()
    exact = np.concatenate([joints.q[:, :3], np.degrees(joints.q[:, 3:])], axis=1)[program.row]
    half = 0.5 * 10.0 ** -np.array([dialect.decimals(k) for k in range(5)])
    assert (np.abs(again.words - exact) <= half * (1 + 1e-9)).all()


@EVERY
def test_one_changed_digit_is_seen_by_the_comparison(dialect) -> None:
    program = some_program(dialect, True)
    text = write_nc(program, dialect, "part")
    at = text.index(b"X", len(text) // 2) + 1
    digit = next(k for k in range(at, at + 9) if text[k : k + 1].isdigit())
    changed = text[:digit] + (b"1" if text[digit : digit + 1] != b"1" else b"2") + text[digit + 1 :]
    assert not np.array_equal(read_nc(changed, LINKS, dialect).words, program.words)


@EVERY_MODE
def test_there_is_exactly_one_line_for_each_block_in_the_line_that_the_program_says(
    dialect, inverse_time
) -> None:
    program = some_program(dialect, inverse_time)
    lines = write_nc(program, dialect, "part").decode("ascii").split(dialect.newline)
    number = r"\d+ " if dialect.number_all else ""
    form = re.compile(f"{number}({dialect.rapid}|{dialect.straight}) [XYZABC]")
    blocks = [at for at, line in enumerate(lines, 1) if form.match(line)]
    assert blocks == program.line.tolist()


@EVERY_MODE
def test_the_motion_word_stands_in_every_block_and_under_g93_an_f_in_every_feed_block(
    dialect, inverse_time
) -> None:
    program = some_program(dialect, inverse_time)
    for line, motion in zip(
        block_lines(write_nc(program, dialect, "part"), dialect), program.motion, strict=True
    ):
        rapid = motion == Motion.RAPID
        assert line.split()[0] == (dialect.rapid if rapid else dialect.straight)
        assert re.search(r" [XYZAC][+-]?\d", line)
        assert line.endswith(dialect.rapid_end) == rapid or not dialect.rapid_end
        if rapid or inverse_time:
            assert (" F" in line.removesuffix(dialect.rapid_end)) != rapid


@EVERY_MODE
def test_modal_words_are_left_out_and_no_others(dialect, inverse_time) -> None:
    program = some_program(dialect, inverse_time)
    lines = block_lines(write_nc(program, dialect, "part"), dialect)
    changed = np.concatenate([[5], (np.diff(program.words, axis=0) != 0).sum(axis=1)])
    assert [len(re.findall(r" [XYZAC]", line)) for line in lines] == changed.tolist()


@EVERY_MODE
def test_lines_are_short_ascii_without_minus_zero_and_numbers_have_points(dialect, inverse_time) -> None:
    text = write_nc(some_program(dialect, inverse_time), dialect, "part" * 100).decode("ascii")
    assert max(map(len, text.split(dialect.newline))) <= dialect.line_length
    assert not re.search(r"-0\.0+\b", text)
    assert not re.search(r"\+-|-\+", text)
    blocks = [line.removesuffix(dialect.rapid_end) for line in block_lines(text.encode(), dialect)]
    assert all("." in word for line in blocks for word in line.split()[1:])
    assert not dialect.plus or all(
        word[1] in "+-" for line in blocks for word in line.split()[1:] if word[0] != "F"
    )


@EVERY
@pytest.mark.parametrize(
    "title", ["Düse (5)", "a)b(c;%", "\n\rM30", "LOGOPEN,/tmp/x", "日本", "", "x" * 500, "{title} {0}"]
)
def test_no_title_becomes_an_instruction(dialect, title) -> None:
    program = some_program(dialect, True)
    text = write_nc(program, dialect, title)
    assert np.array_equal(read_nc(text, LINKS, dialect).words, program.words)
    assert text.count(b"\n") == len(dialect.head) + len(program.words) + len(dialect.tail)
    comments = [] if dialect.comment[1] == "" else re.findall(r"\(([^\n]*)\)", text.decode("ascii"))
    assert not any(set(comment) & set("();%,") for comment in comments)


@EVERY
def test_every_slot_of_the_templates_is_known_and_the_head_says_units_distance_and_feed_mode(dialect) -> None:
    lines = [*dialect.head, *dialect.tail, *dialect.high_speed[0], *dialect.high_speed[1]]
    lines += [
        line for how in dialect.guides for line in (*dialect.guide_by(how).head, *dialect.guide_by(how).tail)
    ]
    used = {name for line in lines for _, name, _, _ in string.Formatter().parse(line) if name}
    assert used <= set(SLOTS) and {"title", "tool", "offset", "spindle", "coolant"} <= used
    assert ("feed_mode" in used) == bool(dialect.inverse_time)
    for head in filter(None, (dialect.head, dialect.guided_head)):
        assert {dialect.metric, dialect.absolute} <= set(" ".join(head).split())
    assert dialect.description and "\n" not in dialect.description and dialect.convention


@EVERY
def test_options_change_what_the_head_says_but_no_line_of_a_block(dialect) -> None:
    program = some_program(dialect, True)
    plain = write_nc(program, dialect, "part")
    offset = "G55" if re.fullmatch(dialect.work_offsets[0], "G55") else "G54"
    full = write_nc(
        program, dialect, "part", PostOptions(tool=7, speed=12000, coolant=True, offset=offset, program=42)
    )
    head = full.decode().split(dialect.newline)[: len(dialect.head)]
    called = (dialect.tool_call.format(tool=7, speed=12000), dialect.tool_length.format(tool=7))
    message = (
        called[0],
        called[1] if "{length}" in dialect.head else "",
        dialect.work_offset.format(offset=offset),
    )
    for expected in (*message, "S12000", "M3", "M8"):
        assert expected in " ".join(head)
    assert ("42" in " ".join(head)) == any("{program}" in line for line in dialect.head)
    assert block_lines(full, dialect) == block_lines(plain, dialect)


@pytest.mark.parametrize(
    "wrong",
    [
        {"tool": 0},
        {"tool": -1},
        {"speed": -1.0},
        {"speed": float("nan")},
        {"offset": "G17"},
        {"program": 0},
        {"blend": -1.0},
    ],
)
def test_options_out_of_range_are_refused(wrong) -> None:
    with pytest.raises(SettingsError):
        PostOptions(**wrong)


def test_linuxcnc_keeps_to_the_exact_path_unless_reported_a_blend_tolerance() -> None:
    dialect = DIALECTS["linuxcnc"]
    program = some_program(dialect, True)
    assert b"\nG61\n" in write_nc(program, dialect, "part")
    assert b"\nG64 P0.0050 Q0.0050\n" in write_nc(program, dialect, "part", PostOptions(blend=0.005))


def test_block_numbers_go_by_the_step_and_start_again_after_the_largest() -> None:
    dialect = replace(DIALECTS["fanuc"], number_step=10, number_most=1000)
    program = some_program(dialect, True)
    text = write_nc(program, dialect, "part")
    lines = text.decode().split("\n")[len(dialect.head) : -len(dialect.tail) - 1]
    numbers = [int(line.split()[0][1:]) for line in lines]
    assert numbers[:3] == [10, 20, 30] and max(numbers) == 1000 and numbers[100] == 10
    assert np.array_equal(read_nc(text, LINKS, dialect).words, program.words)


def test_a_change_of_feed_mode_inside_a_program_is_written_and_read_back() -> None:
    dialect = DIALECTS["linuxcnc"]
    source = b"G21 G90\nG0 X0 Y0 Z0 A0 C0\nG1 X1 F10\nG93 G1 X2 F5\nX3 F5\nG94 G1 X4 F10\nX4\nX5\n"
    program = read_nc(source, LINKS, dialect)
    again = read_nc(write_nc(program, dialect, "part"), LINKS, dialect)
    for name in ("words", "feed", "inverse_time", "motion", "seconds"):
        assert np.array_equal(getattr(again, name), getattr(program, name))


def test_an_unknown_controller_is_refused_with_the_names_that_are_known() -> None:
    assert find_dialect("LinuxCNC") is DIALECTS["linuxcnc"]
    with pytest.raises(
        SettingsError,
        match=r"hal9000.*linuxcnc, fanuc, haas, siemens840d, heidenhain, heidenhain_m128, mach3, grbl",
    ):
        find_dialect("hal9000")
    with pytest.raises(SettingsError, match=r"'Mach4'; did you mean mach3\? known are linuxcnc"):
        find_dialect("Mach4")


@pytest.mark.rs274
@needs_rs274
@pytest.mark.parametrize(
    "dialect", [DIALECTS[name] for name in ("linuxcnc", "fanuc", "mach3")], ids=["linuxcnc", "fanuc", "mach3"]
)
@pytest.mark.parametrize("inverse_time", [True, False], ids=["g93", "g94"])
@pytest.mark.parametrize(
    "options",
    [PostOptions(), PostOptions(tool=3, speed=5000, coolant=True, blend=0.01)],
    ids=["plain", "full"],
)
def test_linuxcncs_own_interpreter_reads_the_very_same_words(
    dialect, inverse_time, options, tmp_path: Path
) -> None:
    program = some_program(dialect, inverse_time)
    file = tmp_path / "part.ngc"
    file.write_bytes(write_nc(program, dialect, "part", options))
    run = subprocess.run(
        ["rs274", "-g", str(file)],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        timeout=60,
        stdin=subprocess.DEVNULL,
    )
    assert run.returncode == 0, run.stderr
    calls = re.findall(r"(STRAIGHT_FEED|STRAIGHT_TRAVERSE|SET_FEED_RATE)\(([^)]*)\)", run.stdout)
    moves = [(kind, numbers) for kind, numbers in calls if kind != "SET_FEED_RATE"]
    words = np.array([[float(number) for number in numbers.split(",")] for _, numbers in moves])[
        :, [0, 1, 2, 5, 3]
    ]
    assert [kind == "STRAIGHT_TRAVERSE" for kind, _ in moves] == (program.motion == Motion.RAPID).tolist()
    assert np.abs(words - program.words).max() < 1e-9
    rate = np.array(rates_of(calls))
    feeding = program.motion != Motion.RAPID
    if inverse_time:  # the interpreter has turned F into a speed: that must give the block's time
        distance = feed_distance(None, np.diff(words, axis=0, prepend=words[:1]))
        assert np.allclose(60 * distance[feeding] / rate[feeding], program.seconds[feeding], rtol=1e-3)
    else:
        assert np.abs(rate - program.feed)[feeding].max() < 1e-3


def rates_of(calls: list[tuple[str, str]]) -> list[float]:
    """The speed in force at each move."""
    rates, rate = [], 0.0
    for kind, numbers in calls:
        if kind == "SET_FEED_RATE":
            rate = float(numbers)
        else:
            rates.append(rate)
    return rates


@pytest.mark.rs274
@needs_rs274
def test_linuxcncs_interpreter_refuses_a_g93_block_without_f(tmp_path: Path) -> None:
    dialect = DIALECTS["linuxcnc"]
    text = write_nc(some_program(dialect, True), dialect, "part")
    file = tmp_path / "part.ngc"
    file.write_bytes(re.sub(rb"(\nG1[^\n]*) F[0-9.]+\n", rb"\1\n", text, count=1))
    run = subprocess.run(
        ["rs274", "-g", str(file)],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        timeout=60,
        stdin=subprocess.DEVNULL,
    )
    assert run.returncode == 1


HIGH_SPEED = [dialect for dialect in DIALECTS.values() if dialect.high_speed[0]]


@pytest.mark.parametrize("dialect", HIGH_SPEED, ids=[dialect.name for dialect in HIGH_SPEED])
def test_the_high_speed_mode_is_switched_on_before_the_blocks_and_off_after_them(dialect) -> None:
    fast = dialect.fast()
    program = some_program(fast, False)
    text = write_nc(program, fast, "part", PostOptions(blend=0.02)).decode()
    lines = text.split(fast.newline)
    on, off = ([line.format(tolerance="0.0200") for line in reported] for reported in dialect.high_speed)
    at = next(k for k, line in enumerate(lines) if line.endswith(on[0]))
    last = max(k for k, line in enumerate(lines) if line.endswith(off[-1]))
    assert at < program.line[0] - 1 and last > program.line[-1] - 1
    assert block_lines(text.encode(), fast) == block_lines(
        write_nc(some_program(dialect, False), dialect, "part"), dialect
    )
    for how in dialect.guides:
        head = fast.guide_by(how).head
        assert head.index(dialect.high_speed[0][0]) < head.index(dialect.guides[how].on[0])


def test_a_controller_without_a_high_speed_mode_or_without_rtcp_says_so() -> None:
    with pytest.raises(SettingsError, match=r"grbl has no high-speed mode"):
        DIALECTS["grbl"].fast()
    with pytest.raises(SettingsError, match=r"mach3 does not guide the tip"):
        DIALECTS["mach3"].guide_by("angles")
    with pytest.raises(SettingsError, match=r"haas has no RTCP by vectors; give angles"):
        DIALECTS["haas"].guide_by("vectors")


GUIDED = [(dialect, how) for dialect in DIALECTS.values() for how in dialect.guides]
EVERY_GUIDE = pytest.mark.parametrize(
    ("dialect", "how"), GUIDED, ids=[f"{d.name}-{how}" for d, how in GUIDED]
)
TOOL = PostOptions(tool=1)


def posed(kinematics: Chain, words: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return forward(kinematics, words_to_q(words))


@EVERY_GUIDE
@pytest.mark.parametrize("inverse_time", [True, False], ids=["g93", "g94"])
@pytest.mark.parametrize("letters", ["CA", "CB", "BA"])
def test_every_guided_word_is_read_back_exactly_as_it_was_rounded(
    dialect, how, inverse_time, letters
) -> None:
    kinematics, guided = machine(*letters), dialect.guide_by(how)
    joints = some_joints(kinematics)
    program = build_program(joints, kinematics, guided, inverse_time)
    again = read_nc(write_nc(program, guided, "part", TOOL), kinematics, guided)
    assert np.array_equal(again.guided.tip, program.guided.tip) and again.guided.on.all()
    assert np.array_equal(again.feed, program.feed) and np.array_equal(
        again.inverse_time, program.inverse_time
    )
    assert np.array_equal(again.line, program.line)
    assert np.array_equal(again.motion == Motion.RAPID, program.motion == Motion.RAPID)
    assert [found.code for found in again.findings] == ["tip-guided-by-controller"]
    path, half = joints.path, 0.5 * 10.0**-guided.linear_decimals * (1 + 1e-9)
    assert np.abs(again.guided.tip - path.tip[program.row]).max() <= half
    if how == "angles":
        assert np.array_equal(again.words[:, 3:], program.words[:, 3:])
        step = 0.5 * 10.0**-guided.rotary_decimals * (1 + 1e-9)
        assert np.abs(again.words[:, 3:] - np.degrees(joints.q[program.row, 3:])).max() <= step
        assert np.allclose(again.seconds, program.seconds, rtol=1e-12)
    else:
        assert np.array_equal(again.guided.vector, program.guided.vector)
        assert np.abs(again.guided.vector - path.axis[program.row]).max() <= 0.5e-7 * (1 + 1e-6)


@EVERY_GUIDE
def test_one_changed_digit_of_a_guided_program_is_seen(dialect, how) -> None:
    guided = dialect.guide_by(how)
    program = build_program(some_joints(LINKS), LINKS, guided, False)
    text = write_nc(program, guided, "part", TOOL)
    word = b" C" if how == "angles" else b" " + guided.guide.vector[1].encode()
    at = text.index(b".", text.index(word, len(text) // 2)) + 2
    changed = text[:at] + (b"1" if text[at : at + 1] != b"1" else b"2") + text[at + 1 :]
    assert not np.array_equal(read_nc(changed, LINKS, guided).words, program.words)


@pytest.mark.parametrize(
    "machine_name",
    ["trunnion_ac", "head_b_table_c", "fork_head_bc", "nutating_table_b45", "linuxcnc_xyzbc_trt"],
)
def test_the_same_cl_path_through_every_dialect_and_back_is_the_same_path(machine_name) -> None:
    kinematics = chain(load_machine(machine_name), Setup((10.0, 20.0, 30.0), 100.0))
    random = np.random.default_rng(3)
    rows = 200
    lean, round_ = np.radians(random.uniform(1, 25, rows)), np.radians(np.cumsum(random.uniform(-9, 9, rows)))
    axis = np.stack([np.sin(lean) * np.cos(round_), np.sin(lean) * np.sin(round_), np.cos(lean)], axis=1)
    tip = np.cumsum(random.normal(0, 1, (rows, 3)), axis=0)
    motion, none = np.full(rows, Motion.CUT, np.int8), np.full(rows, -1)
    motion[0] = Motion.RAPID
    path = CLPath(
        tip, axis, motion, np.where(motion == Motion.RAPID, 0.0, 500.0), tip, axis, none, none, none
    )
    joints = solve(path, kinematics, tip.min(axis=0), tip.max(axis=0), 5.0)
    reported = {}
    for dialect, how in [(dialect, "") for dialect in DIALECTS.values()] + GUIDED:
        dialect = dialect.guide_by(how) if how else dialect
        program = build_program(joints, kinematics, dialect, bool(dialect.inverse_time))
        again = read_nc(write_nc(program, dialect, "part", TOOL), kinematics, dialect)
        reported[dialect.name, how] = posed(kinematics, again.words)
        lever = 700.0 * np.radians(0.5 * 10.0**-dialect.rotary_decimals) * 2
        off = np.linalg.norm(reported[dialect.name, how][0] - joints.path.tip[program.row], axis=1).max()
        assert off <= (1e-4 if how else lever + 1e-4), (dialect.name, how)
        lean = np.linalg.norm(reported[dialect.name, how][1] - joints.path.axis[program.row], axis=1).max()
        assert lean <= (2e-7 if how == "vectors" else np.radians(10.0**-dialect.rotary_decimals)), (
            dialect.name,
            how,
        )
    assert len(reported) == len(DIALECTS) + len(GUIDED)


WRAPPED = [dialect for dialect in DIALECTS.values() if dialect.shorter_way]


def turning(wrap: str) -> Chain:
    """The machine of the other tests, its axes taken as said."""
    axes = tuple(replace(axis, wrap=wrap) if axis.rotary else axis for axis in LINKS.axes)
    return replace(LINKS, axes=axes)


@pytest.mark.parametrize("dialect", WRAPPED, ids=[dialect.name for dialect in WRAPPED])
@pytest.mark.parametrize("how", ["", "angles"])
def test_modulo_words_are_0_to_360_and_read_back_by_the_shorter_way(dialect, how) -> None:
    kinematics = turning("modulo")
    dialect = dialect.guide_by(how) if how else dialect
    q = some_joints(kinematics, 400).q.copy()
    q[:, 3] += np.linspace(-40.0, 40.0, 400)  # many turns to and fro, in steps of 0.2 rad
    tip, axis = forward(kinematics, q)
    joints = replace(some_joints(kinematics, 400), q=q)
    joints = replace(joints, path=replace(joints.path, tip=tip, axis=axis))
    program = build_program(joints, kinematics, dialect, False)
    assert program.wrap == ("modulo", "modulo") and np.ptp(program.words[:, 3]) > 3000
    assert not [found for found in program.findings if found.code == "turned-the-shorter-way"]
    text = write_nc(program, dialect, "part", TOOL)
    turns = [float(word) for word in re.findall(r" C(?:=DC\()?([+-]?[0-9.]+)", text.decode())]
    assert len(turns) > 300 and min(turns) >= 0.0 and max(turns) < 360.0
    again = read_nc(text, kinematics, dialect)
    first = 360.0 * np.round(
        (program.words[0, 3:] - again.words[0, 3:]) / 360.0
    )  # where the axis came from is not known
    assert np.abs(again.words[:, 3:] + first - program.words[:, 3:]).max() < 1e-8


@EVERY
@pytest.mark.parametrize("wrap", ["unwound", "modulo", "rezero"])
def test_what_is_written_is_read_back_to_the_same_axes_whatever_the_machine_file_says(dialect, wrap) -> None:
    kinematics = turning(wrap)
    joints = some_joints(kinematics, 300)
    q = joints.q.copy()
    q[:, 3] += np.linspace(-40.0, 40.0, 300)
    q[100:, 4] += 4.0  # a block of more than half a turn
    program = build_program(replace(joints, q=q), kinematics, dialect, False)
    again = read_nc(write_nc(program, dialect, "part"), kinematics, dialect)
    first = 360.0 * np.round((program.words[0, 3:] - again.words[0, 3:]) / 360.0)
    assert np.array_equal(again.words[:, :3], program.words[:, :3])
    assert np.abs(again.words[:, 3:] + first - program.words[:, 3:]).max() < 1e-8
    assert (np.abs(np.diff(program.words[:, 4])).max() > 180.0) == (wrap != "modulo")
    assert again.wrap == (wrap, wrap)


def test_a_block_of_more_than_half_a_turn_goes_the_shorter_way_and_says_so() -> None:
    kinematics, dialect = turning("modulo"), DIALECTS["fanuc"]
    joints = some_joints(kinematics, 4)
    q = np.zeros((4, 5))
    q[:, 3] = np.radians([0.0, 100.0, 300.0, 310.0])
    q[:, 0] = np.arange(4)
    program = build_program(replace(joints, q=q), kinematics, dialect, False)
    assert program.words[:, 3].tolist() == [0.0, 100.0, -60.0, -50.0]
    found = [one for one in program.findings if one.code == "turned-the-shorter-way"]
    assert len(found) == 1 and found[0].block == 2 and "1 blocks" in found[0].text


@pytest.mark.parametrize("name", ["linuxcnc", "haas", "mach3", "grbl"])
def test_a_controller_that_takes_no_shorter_way_gets_unwound_words_and_a_warning(name) -> None:
    kinematics, dialect = turning("modulo"), DIALECTS[name]
    program = build_program(some_joints(kinematics), kinematics, dialect, True)
    assert program.wrap == ("unwound", "unwound")
    assert [found.code for found in program.findings].count("wrap-not-written") == 2
    assert np.array_equal(
        read_nc(write_nc(program, dialect, "part"), kinematics, dialect).words, program.words
    )


@pytest.mark.rs274
@needs_rs274
@pytest.mark.parametrize("inverse_time", [True, False], ids=["g93", "g94"])
def test_linuxcncs_interpreter_reads_the_guided_words_with_the_switches_remapped(
    inverse_time, tmp_path: Path
) -> None:
    dialect = DIALECTS["linuxcnc"].guide_by("angles")
    program = build_program(some_joints(LINKS), LINKS, dialect, inverse_time)
    (tmp_path / "part.ngc").write_bytes(write_nc(program, dialect, "part", TOOL))
    for name in ("m428", "m429"):
        (tmp_path / f"{name}.ngc").write_text(f"o<{name}> sub\no<{name}> endsub\nM2\n")
    remaps = "".join(f"REMAP = {name.upper()} modalgroup=10 ngc={name}\n" for name in ("m428", "m429"))
    (tmp_path / "a.ini").write_text(f"[RS274NGC]\nSUBROUTINE_PATH = .\n{remaps}")
    run = subprocess.run(
        ["rs274", "-i", "a.ini", "-g", "part.ngc"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        timeout=60,
        stdin=subprocess.DEVNULL,
    )
    assert run.returncode == 0, run.stderr
    moves = re.findall(r"STRAIGHT_(?:FEED|TRAVERSE)\(([^)]*)\)", run.stdout)
    words = np.array([[float(number) for number in numbers.split(",")] for numbers in moves])[
        :, [0, 1, 2, 5, 3]
    ]
    assert np.abs(words[:, :3] - program.guided.tip).max() < 1e-9
    assert np.abs(words[:, 3:] - program.words[:, 3:]).max() < 1e-9


STARTS = [
    SafeStart(BY_MACHINE, -1.5),
    SafeStart(BY_REFERENCE),
    SafeStart(BY_CLEARANCE),
    SafeStart(BY_NOTHING),
]
EVERY_START = pytest.mark.parametrize("start", STARTS, ids=[start.retract for start in STARTS])
EVERY_FORM = pytest.mark.parametrize(
    ("dialect", "how"), [(dialect, "") for dialect in DIALECTS.values()] + GUIDED,
    ids=[*DIALECTS, *(f"{d.name}-{how}" for d, how in GUIDED)],
)  # fmt: skip
PLANE = 777.0


@EVERY_FORM
@EVERY_START
@pytest.mark.parametrize("by_tip", [False, True], ids=["over", "over-by-tip"])
def test_a_safe_start_is_read_over_and_the_blocks_stay_what_they_are(dialect, how, start, by_tip) -> None:
    begun = with_start(dialect, start, by_tip)
    begun = begun.guide_by(how) if how else begun
    program = build_program(some_joints(LINKS), LINKS, begun, False)
    text = write_nc(program, begun, "part", TOOL, height=PLANE)
    again = read_nc(text, LINKS, begun)
    own = np.isin(again.line, program.line)
    assert np.array_equal(again.line[own], program.line)
    if how == "vectors":  # of two branches the reader is free to take the other one
        assert np.array_equal(again.guided.tip[own], program.guided.tip)
        assert np.array_equal(again.guided.vector[own], program.guided.vector)
    else:
        assert np.abs(again.words[own] - program.words).max() < 1e-8
    assert [found.code for found in again.findings] == (["tip-guided-by-controller"] if how else [])
    others, plane = (
        again.words[~own],
        start.retract == BY_CLEARANCE and not (how and by_reference(dialect, start)),
    )
    assert (
        len(others) == ((1 if by_tip and how else 2) if plane else 0)
        and (np.abs(others[:, 2] - PLANE) < 1e-6).all()
    )


@EVERY_FORM
@EVERY_START
def test_a_safe_start_retracts_turns_goes_over_and_only_then_guides_and_ends_with_the_retract(
    dialect, how, start
) -> None:
    begun = with_start(dialect, start)
    begun = begun.guide_by(how) if how else begun
    turn, over = (f"{dialect.rapid} {{{slot}}}{dialect.rapid_end}" for slot in ("rotaries", "over"))
    if start.retract == BY_NOTHING:
        assert turn not in begun.head and over not in begun.head and begun.head.count("{cutter}") == 1
        return
    plane = f"{dialect.rapid} {{height}}{dialect.rapid_end}"
    up = {
        BY_MACHINE: tuple(line.format(z=_minus(dialect)) for line in dialect.machine_retract),
        BY_CLEARANCE: (plane,),
    }
    reference = start.retract == BY_REFERENCE or (how and by_reference(dialect, start))
    first = (dialect.reference_return if reference else up[start.retract])[0]
    order = [begun.head.index(line) for line in (first, turn, over)]
    assert order == sorted(order) and first in begun.tail
    assert (begun.head.index("{tool}") > order[0]) == (
        first != plane
    )  # a plane above the part needs the tool's length
    if how:
        guide = begun.guide
        assert order[2] < begun.head.index(guide.on[0]) and begun.head.index(guide.off[0]) < _last(
            begun.head, first
        )
        assert begun.tail.index(guide.off[0]) < _last(begun.tail, first)
        before = [lines.index(first) < lines.index(guide.off[0]) for lines in (begun.head, begun.tail)]
        assert before == [guide.retract_first] * 2, "G49 alone may drive Z down by the tool's length"


def _last(lines, line):
    return len(lines) - 1 - lines[::-1].index(line)


def test_fanuc_retracts_before_its_guide_is_switched_off() -> None:
    assert [name for name, one in DIALECTS.items() if any(g.retract_first for g in one.guides.values())] == [
        "fanuc"
    ]


def _minus(dialect: Dialect) -> str:
    return f"{-1.5:.{dialect.linear_decimals}f}"


@EVERY_START
@pytest.mark.rs274
@needs_rs274
@pytest.mark.parametrize("name", ["linuxcnc", "fanuc", "mach3"])
def test_linuxcncs_interpreter_takes_every_safe_start_and_end(name, start, tmp_path: Path) -> None:
    dialect = with_start(DIALECTS[name], start)
    program = build_program(some_joints(LINKS), LINKS, dialect, False)
    (tmp_path / "a.ngc").write_bytes(write_nc(program, dialect, "part", height=PLANE))
    run = subprocess.run(
        ["rs274", "-g", "a.ngc"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        timeout=60,
        stdin=subprocess.DEVNULL,
    )
    assert run.returncode == 0, run.stderr
    moves = re.findall(r"STRAIGHT_(?:FEED|TRAVERSE)\(([^)]*)\)", run.stdout)
    words = np.array([[float(number) for number in numbers.split(",")] for numbers in moves])[
        :, [0, 1, 2, 5, 3]
    ]
    before = {BY_MACHINE: 3, BY_REFERENCE: 4, BY_CLEARANCE: 3, BY_NOTHING: 0}[start.retract]
    assert np.abs(words[before : before + len(program.words)] - program.words).max() < 1e-9
    driven = np.abs(np.diff(words[: before + 1], axis=0)) > 0.0
    groups = np.stack([driven[:, 2], driven[:, 3:].any(axis=1), driven[:, :2].any(axis=1)], axis=1)
    assert (groups.sum(axis=1) <= 1).all()
    last = words[-1]
    assert last[2] == {BY_MACHINE: -1.5, BY_REFERENCE: 0.0, BY_CLEARANCE: PLANE}.get(
        start.retract, program.words[-1, 2]
    )
    assert np.array_equal(last[[0, 1, 3, 4]], program.words[-1, [0, 1, 3, 4]])
