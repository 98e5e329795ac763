# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits, axis rates and feed over the part, against rows counted by hand, finite differences and dense
sampling."""

import csv
import io
import json
import math
from dataclasses import replace

import numpy as np
import pytest
from five_kinds import KINDS, kinematics_of, random_blocks

from freecad_fiveaxis.core.audit import check_limits, compute_commanded_rates, feed_findings, rate_findings
from freecad_fiveaxis.core.audit.rates import DEGREES
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.controllers import find_dialect
from freecad_fiveaxis.core.machine import Axis, Machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward_tip, words_to_q
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.pipeline import job, outputs
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report import as_html, as_json, as_text, summary
from freecad_fiveaxis.core.toolpath.cl_path import Motion

X, Y, Z = (
    Axis(n, False, "head", tuple(r), (0, 0, 0), -100, 100, 6000.0)
    for n, r in zip("XYZ", np.eye(3).tolist(), strict=True)
)
A = Axis("A", True, "table", (1, 0, 0), (0, 0, -50), math.radians(-30), math.radians(120), math.radians(3600))
C = Axis("C", True, "table", (0, 0, 1), (0, 0, 0), -math.inf, math.inf, math.radians(7200))
SMALL = Machine("small", (C, A, X, Y, Z))


def kinematics_at(*origin):
    return chain(SMALL, Setup(origin or (0.0, 0.0, 0.0)))


def read(text, kinematics=None, controller="linuxcnc"):
    return read_nc(text.encode(), kinematics or kinematics_at(), find_dialect(controller))


def codes(findings):
    return [finding.code for finding in findings]


# ---------------------------------------------------------------------------------------------- limits

BEYOND = """G21 G90 G94
G0 X0 Y0 Z0 A0 C0
G1 X99.9 F500
X101.5
X103.25 A121
Y-100.4 X0 A-31.5
G0 Z100.0004 C4000
M2
"""


def test_words_beyond_limits_are_counted_with_the_worst_and_the_first_line():
    program = read(BEYOND)
    limits = check_limits(kinematics_at(), program)
    found = {(one.text.split(" beyond")[0].split()[-1], round(one.limit, 6)): one for one in limits.findings}
    assert sorted(found) == [("A", -30.0), ("A", 120.0), ("X", 100.0), ("Y", -100.0)]
    np.testing.assert_allclose(limits.excess, [0, 0, 1.5, 3.25, 1.5, 1.5], atol=1e-9)
    assert [program.letters[k] for k in limits.axis[2:5]] == ["X", "X", "A"]
    x = found["X", 100.0]
    assert (x.severity, x.code, x.value, x.unit, x.line, x.block) == (
        Severity.ERROR,
        "limit",
        103.25,
        "mm",
        5,
        3,
    )
    assert (
        "2 blocks" in x.text
        and "first NC line 4" in x.text
        and "3.2500 mm too far" in x.text
        and "--origin" in x.text
    )
    assert found["A", -30.0].unit == "deg" and found["A", -30.0].value == -31.5


def test_the_work_zero_moves_the_limits_of_the_words():
    text = "G21 G90\nG0 X60 Y0 Z0 A0 C0\nM2\n"
    assert check_limits(kinematics_at(), read(text)).findings == ()
    moved = kinematics_at(50.0, 0.0, 0.0)  # X60 then stands at 110 of the machine
    (found,) = check_limits(moved, read(text, moved)).findings
    assert found.code == "limit" and found.limit == pytest.approx(50.0) and found.value == 60.0


def test_a_word_rounded_onto_its_limit_is_within_it():
    assert check_limits(kinematics_at(), read("G0 X100.0005 Y0 Z0 A120.0005 C0\nM2\n")).findings == ()
    assert len(check_limits(kinematics_at(), read("G0 X100.0006 Y0 Z0 A0 C0\nM2\n")).findings) == 1


@pytest.mark.parametrize(("wrap", "count"), [("modulo", 0), ("unwound", 1)])
def test_turns_count_only_where_the_control_does_not_take_the_shorter_way(wrap, count):
    turning = Axis(
        "C", True, "table", (0, 0, 1), (0, 0, 0), math.radians(-190), math.radians(190), 100.0, wrap
    )
    kinematics = chain(Machine("m", (turning, A, X, Y, Z)), Setup())
    words = np.zeros((5, 5))
    words[:, 3] = [0, 100, 200, 300, 400]
    program = program_of(kinematics, words, wrap=(wrap, "unwound"))
    assert len(check_limits(kinematics, program).findings) == count


# -------------------------------------------------------------------------------------------- rates and feeds


def program_of(
    kinematics, words, seconds=1.0, feed=1000.0, inverse=False, motion=None, wrap=("unwound", "unwound")
):
    n = len(words)
    motion = np.zeros(n, np.int8) if motion is None else motion
    times = np.full(n, seconds) * (np.arange(n) > 0)
    return Program(
        kinematics.letters,
        words,
        np.full(n, feed),
        np.full(n, inverse),
        motion,
        times,
        np.full(n, -1),
        np.arange(1, n + 1),
        wrap=wrap,
    )


@pytest.mark.parametrize("kind", KINDS)
def test_rates_and_tip_feed_are_those_of_dense_samples(kind):
    kinematics = kinematics_of(kind)
    start, end = random_blocks(kinematics, 40, 5)
    for first, last in zip(start, end, strict=True):
        program = program_of(kinematics, np.stack([first, last]), 0.7)
        rates = compute_commanded_rates(kinematics, program)
        u = np.linspace(0.0, 1.0, 20_001)[:, None]
        q = words_to_q(first + u * (last - first))
        per_minute = 20_000 * 60.0 / 0.7
        np.testing.assert_allclose(
            rates.rate[1], np.abs(np.diff(q, axis=0)).max(axis=0) * per_minute, rtol=1e-6, atol=1e-5
        )
        way = np.linalg.norm(np.diff(forward_tip(kinematics, q), axis=0), axis=1).sum()
        assert rates.travel[1] == pytest.approx(way, rel=2e-3, abs=1e-6)
        assert rates.tip_feed[1] == pytest.approx(way * 60.0 / 0.7, rel=2e-3, abs=1e-4)


def test_the_chord_instead_of_the_path_would_be_noticed():
    kinematics = kinematics_of("table_table")
    words = np.array([[100.0, 0, 0, 0, 0], [100.0, 0, 0, 170.0, 0]])
    rates = compute_commanded_rates(kinematics, program_of(kinematics, words))
    chord = np.linalg.norm(np.diff(forward_tip(kinematics, words_to_q(words)), axis=0))
    assert rates.travel[1] > 1.3 * chord


@pytest.mark.parametrize(
    ("controller", "line", "minutes"),
    [
        ("linuxcnc", "G94 G1 X30 C40 F600", 30 / 600),  # over X Y Z alone
        ("linuxcnc", "G94 G1 C40 F600", 40 / 600),  # degrees a minute
        ("linuxcnc", "G93 G1 X30 C40 F12", 1 / 12),
        ("fanuc", "G94 G1 X30 C40 F600", 50 / 600),  # over all axes
    ],
)
def test_the_rate_is_that_of_the_dialects_f(controller, line, minutes):
    program = read(f"G21 G90\nG0 X0 Y0 Z0 A0 C0\n{line}\nM2\n", controller=controller)
    rates = compute_commanded_rates(kinematics_at(), program)
    np.testing.assert_allclose(
        rates.rate[1] * DEGREES, np.array([30.0 * ("X" in line), 0, 0, 40.0, 0]) / minutes, rtol=1e-9
    )


def test_blocks_that_ask_too_much_of_an_axis_are_named_with_the_worst():
    text = "G21 G90 G93\nG0 X0 Y0 Z0 A0 C0\nG1 X1 A10 F300\nG1 X2 A40 F300\nG1 X3 A41 F3500\nM2\n"
    kinematics = kinematics_at()
    program = read(text, kinematics)
    rates = compute_commanded_rates(kinematics, program)
    np.testing.assert_allclose(rates.ratio, [0, 3000 / 3600, 9000 / 3600, 3500 / 3600], rtol=1e-9)
    (found,) = rate_findings(kinematics, program, rates)
    assert (found.code, found.severity, found.line, found.unit) == (
        "axis-rate",
        Severity.WARNING,
        4,
        "deg/min",
    )
    assert (
        found.value == pytest.approx(9000)
        and found.limit == pytest.approx(3600)
        and "2.5 times" in found.text
    )


def test_a_block_at_exactly_its_rate_is_no_finding_and_one_a_hundredth_above_is():
    for feed, count in ((360.0, 0), (363.6, 1)):
        program = read(f"G21 G93\nG0 X0 Y0 Z0 A0 C0\nG1 A10 F{feed}\nM2\n")
        assert (
            len(rate_findings(kinematics_at(), program, compute_commanded_rates(kinematics_at(), program)))
            == count
        )


def test_rapids_and_blocks_without_time_ask_for_nothing():
    kinematics = kinematics_at()
    words = np.cumsum(np.ones((4, 5)), axis=0)
    program = program_of(
        kinematics, words, np.array([0.0, 1.0, 0.0, 1.0]), motion=np.array([3, 3, 0, 0], np.int8)
    )
    rates = compute_commanded_rates(kinematics, program)
    assert (rates.ratio > 0).tolist() == [False, False, False, True]
    assert (rates.tip_feed > 0).tolist() == [False, False, False, True]


def test_a_feed_over_the_part_that_is_not_f_is_a_warning():
    text = "G21 G90 G94\nG0 X0 Y0 Z50 A0 C0\nG1 X10 F600\nG1 X10.5 A30 F600\nM2\n"
    kinematics = kinematics_at()
    program = read(text, kinematics)
    rates = compute_commanded_rates(kinematics, program)
    (found,) = feed_findings(kinematics, program, rates)
    assert (found.code, found.severity, found.line, found.limit) == (
        "feed-over-part",
        Severity.WARNING,
        4,
        600.0,
    )
    assert (
        found.value == pytest.approx(rates.tip_feed[2]) and found.value > 10 * 600
    )  # an arc of 30 deg, R 100, in 0.5 / 600 min
    assert rates.travel[2] == pytest.approx(100 * math.radians(30), rel=0.01)


def fan(own_feed=1000.0, count=40):
    """Blocks of 1 mm and 0.25 deg and more, each with the F over X Y Z that keeps ``own_feed`` mm/min over the
    part, as a post writes it for LinuxCNC under G94. Returns kinematics, words and F."""
    kinematics, words = kinematics_at(), np.zeros((count, 5))
    words[:, 0], words[:, 3] = np.arange(count), np.cumsum(np.linspace(0.0, 10.0, count))
    travel = compute_commanded_rates(kinematics, program_of(kinematics, words)).travel
    return kinematics, words, own_feed / np.maximum(travel, 1.0)


def fed(kinematics, words, feed, inverse_time="G93"):
    """What is found where a block of 1 mm takes the time of its F."""
    program = replace(program_of(kinematics, words, 60.0 / feed), feed=feed)
    return feed_findings(kinematics, program, compute_commanded_rates(kinematics, program), inverse_time)


@pytest.mark.parametrize("inverse_time", ["G93", ""])
def test_an_f_that_keeps_the_feed_over_the_part_is_right_however_the_axes_go(inverse_time):
    kinematics, words, feed = fan()
    assert feed.max() > 2 * feed.min()
    assert fed(kinematics, words, feed, inverse_time) == ()
    feed[30] *= 8.0
    (found,) = fed(kinematics, words, feed, inverse_time)
    assert (found.code, found.severity, found.block) == ("feed-over-part", Severity.WARNING, 30)
    assert found.value == pytest.approx(8000, rel=1e-6) and found.limit == pytest.approx(1000)
    assert "the median of all blocks is 1000" in found.text and "Post with" not in found.text


def test_a_plunge_and_an_axis_at_its_limit_are_rightly_slower_where_f_keeps_the_feed():
    kinematics, words, feed = fan()
    words[20:, 3] -= words[20, 3] - words[19, 3]
    feed[20] = 100.0  # the tip alone moves: F says it
    assert fed(kinematics, words, feed) == ()
    feed[30] /= 8.0
    assert [one.block for one in fed(kinematics, words, feed)] == [30]
    at_limit = feed[30] * math.radians(words[30, 3] - words[29, 3])
    assert fed(replace(kinematics, rate=np.array([1e9, 1e9, 1e9, at_limit, 1e9])), words, feed) == ()


@pytest.mark.parametrize(
    ("inverse_time", "advice"),
    [("G93", "Post with inverse time (G93)."), ("", "This one has no inverse time")],
)
def test_one_f_for_all_ways_is_a_warning_with_what_the_controller_can_do(inverse_time, advice):
    kinematics, words, _ = fan()
    (found,) = fed(kinematics, words, np.full(len(words), 1000.0), inverse_time)
    assert (found.code, found.severity, found.limit) == ("feed-over-part", Severity.WARNING, 1000.0)
    assert "where F says 1000" in found.text and advice in found.text
    assert ("G93" in found.text) == (inverse_time == "G93")


def test_under_inverse_time_the_median_is_the_measure():
    words = np.zeros((30, 5))
    words[:, 0] = np.arange(30.0)
    kinematics = kinematics_at()
    seconds = np.full(30, 0.1)
    assert (
        feed_findings(
            kinematics, program_of(kinematics, words, seconds, 600.0, True), even(kinematics, words, seconds)
        )
        == ()
    )
    seconds[17] = 0.01
    (found,) = feed_findings(
        kinematics, program_of(kinematics, words, seconds, 600.0, True), even(kinematics, words, seconds)
    )
    assert (found.code, found.severity, found.block) == ("feed-over-part", Severity.NOTE, 17)
    assert found.value == pytest.approx(6000) and found.limit == pytest.approx(600)


def even(kinematics, words, seconds):
    return compute_commanded_rates(kinematics, program_of(kinematics, words, seconds, 600.0, True))


def test_where_the_controller_guides_the_tip_it_goes_straight():
    text = "G21 G90 G94\nG0 X0 Y0 Z0 A0 C0\nM428\nG1 X10 Y0 Z0 A20 C30 F500\nM2\n"
    program = read(text)
    assert program.guided is not None and program.guided.on[-1]
    rates = compute_commanded_rates(kinematics_at(), program)
    assert rates.travel[-1] == pytest.approx(10.0) and rates.tip_feed[-1] == pytest.approx(500.0)


# ---------------------------------------------------------------------------------------------- the pipeline


@pytest.mark.oldest
@pytest.mark.thorough
def test_the_reports_of_an_audit_name_it_all(tmp_path):
    source = tmp_path / "p.ngc"
    source.write_text("G21 G90 G94\nG0 X0 Y0 Z50 A0 C0\nG1 X10 F600\nG1 X10.5 A30 F600\nG1 Z900 F9000\nM2\n")
    settings = build_settings(
        "audit", str(source), {"machine": "trunnion_ac", "rates": str(tmp_path / "rates.csv")}
    )
    result = job.run(settings)
    outputs.write_outputs(result)
    figures = job.figures(result)
    assert {"limit", "axis-rate", "feed-over-part"} <= set(codes(result.findings))
    numbers = summary(figures)
    assert numbers["over_limit_blocks"] == 1 and numbers["limit_axis"] == "Z" and numbers["limit_line"] == 5
    assert numbers["over_rate_blocks"] == 1 and numbers["rate_axis"] == "A" and numbers["rate_line"] == 4
    page, report = as_html(figures), json.loads(as_json(figures))
    assert [row["line"] for row in report["audit"]["limits"]] == [5] and [
        row["line"] for row in report["audit"]["rates"]
    ] == [4]
    assert "The worst lines beyond a limit" in page and "X10.5000 Y0.0000 Z900.0000 A30.0000 C0.0000" in page
    assert "blocks beyond a limit" in as_text(figures)
    rows = list(csv.DictReader(io.StringIO((tmp_path / "rates.csv").read_text())))
    assert len(rows) == 4 and float(rows[2]["rate_A"]) == pytest.approx(30 / (0.5 / 600), rel=1e-6)
    assert float(rows[3]["excess"]) == pytest.approx(numbers["max_limit_excess"], abs=1e-6)


def test_a_program_built_here_is_within_limits_and_rates(tmp_path):
    cl = tmp_path / "p.apt"
    turn = np.linspace(0.0, 2.0, 40)
    rows = np.column_stack(
        [
            40 * np.cos(turn),
            40 * np.sin(turn),
            5 * turn,
            0.5 * np.cos(turn),
            0.5 * np.sin(turn),
            turn * 0 + 0.75**0.5,
        ]
    )
    cl.write_text(
        "MULTAX/ON\nFEDRAT/2000\n"
        + "".join("GOTO/" + ",".join(f"{v:.6f}" for v in row) + "\n" for row in rows)
        + "FINI\n"
    )
    for mode in ("g93", "g94"):
        nc = tmp_path / "p.ngc"
        posted = build_settings(
            "post",
            str(cl),
            {"machine": "trunnion_ac", "output": str(nc), "feed_mode": mode, "linearize": "on"},
        )
        outputs.write_outputs(job.run(posted))
        audit = job.run(build_settings("audit", str(nc), {"machine": "trunnion_ac"})).audit
        assert not {"limit", "axis-rate"} & set(codes(audit.findings))
        feeds = audit.rates.tip_feed[audit.rates.tip_feed > 0]
        assert np.median(feeds) == pytest.approx(2000, rel=2e-3)


def test_a_heidenhain_program_is_not_reported_of_inverse_time(tmp_path):
    source = tmp_path / "p.h"
    source.write_text(
        "0 BEGIN PGM P MM\n1 L X+0 Y+0 Z+300 A+0 C+0 FMAX\n2 L X+10 F600\n3 L X+10.5 A+30 F600\n4 END PGM P MM\n"
    )
    result = job.run(build_settings("audit", str(source), {"machine": "trunnion_ac"}))
    (found,) = (one for one in result.findings if one.code == "feed-over-part")
    assert "where F says 600" in found.text and "no inverse time" in found.text and "G93" not in found.text


def test_a_program_of_rapids_alone_is_audited(tmp_path):
    source = tmp_path / "p.ngc"
    source.write_text("G0 X0 Y0 Z0 A0 C0\nM2\n")
    figures = job.figures(job.run(build_settings("audit", str(source), {"machine": "trunnion_ac"})))
    assert summary(figures)["median_tip_feed"] is None and figures.program.motion[0] == Motion.RAPID
    assert "feed over the part" in as_text(figures) and as_html(figures)
