# SPDX-License-Identifier: LGPL-2.1-or-later
"""CL files: written, read back, and read from others."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from freecad_fiveaxis.core.base.errors import FiveAxisError, ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.apt import ClReading, read_apt, write_apt
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

RAPID, LINK, CUT, FILL = Motion.RAPID, Motion.LINK, Motion.CUT, Motion.FILL


def some_path(rows: int = 200, seed: int = 0) -> CLPath:
    random = np.random.default_rng(seed)
    tip, axis = random.normal(0, 100, (rows, 3)), random.normal(0, 1, (rows, 3))
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    motion = random.choice([RAPID, LINK, CUT, CUT, CUT], rows).astype(np.int8)
    motion[0] = RAPID
    feed = np.where(motion == RAPID, 0.0, np.where(motion == LINK, 300.0, 1234.5))
    none = np.full(rows, -1)
    return CLPath(tip, axis, motion, feed, tip, axis, none, none, none)


def test_what_is_written_is_read_back_within_half_a_printed_step() -> None:
    path = some_path()
    again = read_apt(write_apt(path, Cutter(10.0), "part"))
    assert np.abs(again.tip - path.tip).max() <= 0.5e-6 * (1 + 1e-6)
    assert np.abs(again.axis - path.axis).max() <= 2e-9  # half a step, and scaled to length 1
    assert (again.motion == path.motion).all() and (again.feed == path.feed).all()
    assert again.findings == ()


def test_the_comparison_sees_one_digit() -> None:
    path = some_path()
    text = write_apt(path, Cutter(10.0), "part")
    at = text.index(b"GOTO/", len(text) // 2) + 5
    digit = next(k for k in range(at, at + 10) if text[k] in b"0123456789")
    changed = text[:digit] + (b"1" if text[digit] != ord("1") else b"2") + text[digit + 1 :]
    assert np.abs(read_apt(changed).tip - path.tip).max() > 0.5e-6


def test_a_small_file_is_what_one_would_write_by_hand() -> None:
    tip = np.array([[0.0, 0, 50], [0, 0, 5], [1, 0, 0], [2, 0, -0.5], [2, 0, 50]])
    axis = np.tile((0.0, 0.6, 0.8), (5, 1))
    motion, feed = np.array([RAPID, LINK, CUT, FILL, RAPID], np.int8), np.array([0.0, 300, 1000, 1000, 0])
    none = np.full(5, -1)
    text = write_apt(CLPath(tip, axis, motion, feed, tip, axis, none, none, none), Cutter(10.0), "dome\n(x)")
    assert text.decode().splitlines() == [
        "PARTNO dome--x-", "UNITS/MM", "CUTTER/10.0000,5.0000", "LOADTL/1", "MULTAX/ON",
        "RAPID", "GOTO/0.000000,0.000000,50.000000,0.000000000,0.600000000,0.800000000",
        "PPRINT/MOTION,LINK", "FEDRAT/300.0000,MMPM", "GOTO/0.000000,0.000000,5.000000,0.000000000,0.600000000,0.800000000",
        "PPRINT/MOTION,CUT", "FEDRAT/1000.0000,MMPM", "GOTO/1.000000,0.000000,0.000000,0.000000000,0.600000000,0.800000000",
        "GOTO/2.000000,0.000000,-0.500000,0.000000000,0.600000000,0.800000000",
        "RAPID", "GOTO/2.000000,0.000000,50.000000,0.000000000,0.600000000,0.800000000",
        "END", "FINI",
    ]  # fmt: skip


FOREIGN = b"""$$ from another system
PARTNO BLADE 7 $$ with / and , in it
UNITS / INCHES
LOAD/TOOL,3
CUTTER/ 0.5
SPINDL/RPM,1000,CLW
FROM/0,0,10
FEDRAT/ 10., IPM
goto / 1 , 2 , 3
MULTAX
GOTO/1,2, $ goes on
  3, 0, 3E-1, $
  -.4
RAPID
GOTO/1,2,5
GOTO/1,2,6
COOLNT/OFF
FINI
GOTO/9,9,9
"""


def test_a_foreign_file_is_read_with_its_units_continuations_and_one_shot_rapids() -> None:
    path = read_apt(FOREIGN)
    assert np.allclose(path.tip, 25.4 * np.array([[0, 0, 10], [1, 2, 3], [1, 2, 3], [1, 2, 5], [1, 2, 6]]))
    assert np.allclose(path.axis, [[0, 0, 1], [0, 0, 1], [0, 0.6, -0.8], [0, 0.6, -0.8], [0, 0.6, -0.8]])
    assert path.motion.tolist() == [RAPID, CUT, CUT, RAPID, CUT]
    assert path.feed.tolist() == [0, 254, 254, 0, 254]
    assert path.pass_.tolist() == [-1, 0, 0, -1, 1]
    assert (path.contact == path.tip).all() and (path.normal == path.axis).all()
    assert [(found.code, found.severity, found.line) for found in path.findings] == [
        ("axis-not-unit", Severity.WARNING, 11), ("text-after-end", Severity.NOTE, 19),
    ]  # fmt: skip


@pytest.mark.parametrize("end", [b"\r\n", b"\r"])
def test_line_endings_do_not_matter(end: bytes) -> None:
    assert np.array_equal(read_apt(FOREIGN.replace(b"\n", end)).tip, read_apt(FOREIGN).tip)
    assert (
        read_apt(FOREIGN.decode()).findings
        == read_apt(b"\xef\xbb\xbf" + FOREIGN.replace(b"\n", end)).findings
    )


@pytest.mark.parametrize(
    ("statement", "severity"),
    [(b"CYCLE/DRILL,5", Severity.ERROR), (b"TLAXIS/PERPTO", Severity.ERROR), (b"FOO/1", Severity.WARNING)],
)
def test_statements_that_are_not_interpreted_are_reported_once_each(
    statement: bytes, severity: Severity
) -> None:
    path = read_apt(b"FEDRAT/100\nGOTO/1,2,3\n" + statement + b"\n" + statement + b"\nGOTO/1,2,4\n")
    assert [(found.code, found.severity, found.line, found.value) for found in path.findings] == [
        ("statement-not-interpreted", severity, 3, 2.0)
    ]


def test_moves_before_any_feed_take_the_given_one_or_are_reported() -> None:
    assert read_apt(b"GOTO/1,2,3\nFEDRAT/5\nGOTO/1,2,4\n", ClReading(feed=700.0)).feed.tolist() == [700, 5]
    assert [found.code for found in read_apt(b"GOTO/1,2,3\n").findings] == ["no-feed"]


@pytest.mark.parametrize(
    ("text", "where"),
    [
        (b"GOTO/1,2,3\n GOTO/1,2,X7\n", "line 2, column 11"), (b"\nGOTO/1,2\n", "line 2"), (b"GOTO/1,2,3,4,5,6,7\n", "line 1"),
        (b"GOTO/1,,3\n", "line 1"), (b"GOTO/1,2,3,0,$\n0,1-2\n", "line 2, column 3"), (b"GOTO/1.2.3,,4\n", "line 1, column 6"),
        (b"GOTO/\n", "line 1"), (b"GOTO/1,2,3,0,0,0\n", "line 1"), (b"GOTO/1,2,1E999\n", "line 1, column 10"),
        (b"FEDRAT/FAST\nGOTO/1,2,3\n", "line 1, column 8"), (b"FEDRAT/-5\nGOTO/1,2,3\n", "line 1"),
        (b"FEDRAT/0.1,MMPR\nGOTO/1,2,3\n", "line 1"), (b"UNITS/FURLONG\nGOTO/1,2,3\n", "line 1, column 7"),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_refused_with_line_and_column(text: bytes, where: str) -> None:
    with pytest.raises(ProgramError) as caught:
        read_apt(text)
    assert where in str(caught.value)


@pytest.mark.parametrize("text", [b"", b"\n", b"PARTNO X\nFINI\n", b"FINI\nGOTO/1,2,3\n"])
def test_a_file_without_positions_is_refused(text: bytes) -> None:
    with pytest.raises(ProgramError, match="no GOTO"):
        read_apt(text)


def test_a_binary_file_is_refused() -> None:
    with pytest.raises(ProgramError, match="text file"):
        read_apt(b"GOTO/1,2,3\n\x00\x01\nGOTO/1,2,3\n")


def test_an_empty_path_is_written_and_its_file_refused() -> None:
    with pytest.raises(ProgramError, match="no GOTO"):
        read_apt(write_apt(_empty(), Cutter(1.0), ""))


def _empty() -> CLPath:
    three, one, count = np.empty((0, 3)), np.empty(0), np.empty(0, np.int64)
    return CLPath(three, three, np.empty(0, np.int8), one, three, three, count, count, count)


@settings(max_examples=300, deadline=None)
@given(st.text(alphabet="GOTO/RAPIDFEDRATUNITSMM0123456789.,-+E $\n", max_size=60))
def test_no_text_whatever_gives_a_traceback(text: str) -> None:
    for given_text in (text, "GOTO/" + text, "FEDRAT/" + text + "\nGOTO/1,2,3"):
        try:
            read_apt(given_text)
        except FiveAxisError as error:
            assert "\n" not in str(error)
