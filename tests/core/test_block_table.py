# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of blocks: columns, values that read back, a bound that stays one."""

import csv
import dataclasses
import io

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from report_examples import TRUNNION, TRUNNION_BC, by_hand, dome, empty, table2

from freecad_fiveaxis.core.report import blocks_csv
from freecad_fiveaxis.core.report.block_table import header, letter_order, round_up

NAMES = "feed,u_line,line_deviation,u_segment,segment_deviation,bound,axis_deviation,singular"


def table_of(figures):
    text = blocks_csv(figures.program, figures.deviation, figures.singularity).decode("ascii")
    return list(csv.DictReader(io.StringIO(text)))


def column(rows, name):
    return np.array([float(row[name]) for row in rows])


@pytest.mark.parametrize(
    ("machine", "letters"),
    [(TRUNNION, "A,C"), (TRUNNION_BC, "B,C")],
    ids=["C carries A in words CA", "C carries B in words CB"],
)
def test_the_header_is_exact_and_sorts_the_rotary_letters(machine, letters):
    figures = dome(machine, passes=2, points=5)
    first = blocks_csv(figures.program, figures.deviation, figures.singularity).split(b"\n")[0].decode()
    assert first == f"block,line,motion,X,Y,Z,{letters},{NAMES}"


def test_letters_already_in_order_stay():
    assert letter_order("XYZAC") == [0, 1, 2, 3, 4]
    assert letter_order("XYZCA") == [0, 1, 2, 4, 3]
    assert "X,Y,Z,A,C" in header("XYZAC") and "X,Y,Z,A,C" in header("XYZCA")


def test_every_value_reads_back():
    figures = dome(passes=4, points=30)
    rows, program, deviation = table_of(figures), figures.program, figures.deviation
    assert len(rows) == len(program.words)
    assert [row["motion"] for row in rows[:3]] == ["rapid", "link", "cut"]
    np.testing.assert_array_equal(column(rows, "block"), np.arange(len(rows)))
    np.testing.assert_array_equal(column(rows, "line"), program.line)
    for letter, place in zip("XYZCA", range(5), strict=True):
        np.testing.assert_array_equal(column(rows, letter), program.words[:, place])
    for name, values in {
        "feed": program.feed,
        "u_line": deviation.u_line,
        "line_deviation": deviation.line,
        "u_segment": deviation.u_segment,
        "segment_deviation": deviation.segment,
        "axis_deviation": np.degrees(deviation.axis),
    }.items():
        np.testing.assert_allclose(column(rows, name), values, rtol=0, atol=0.5000001e-6)
    np.testing.assert_array_equal(column(rows, "singular"), figures.singularity.singular)


def test_swapped_rotary_columns_would_be_noticed():
    rows, words = table_of(dome(passes=2, points=5)), dome(passes=2, points=5).program.words
    assert np.abs(column(rows, "A") - words[:, 3]).max() > 1.0


def test_the_bound_that_is_read_back_is_never_below_the_bound_nor_the_deviation():
    figures = dome(passes=6, points=40)
    rows = table_of(figures)
    bound = column(rows, "bound")
    assert (bound >= figures.deviation.bound).all()
    assert (bound >= column(rows, "segment_deviation")).all()
    assert (bound <= figures.deviation.bound + 1.001e-6).all()


def test_rounding_to_nearest_would_break_the_bound():
    figures = dome(passes=6, points=40)
    assert (np.round(figures.deviation.bound, 6) < figures.deviation.bound).any()


@given(st.floats(0.0, 1e6))
@settings(deadline=None)
def test_rounding_up_reaches_the_next_decimal_and_no_further(value):
    up = float(f"{round_up(np.array([value]))[0]:.6f}")
    assert value <= up <= value * (1 + 1e-15) + 1.0000001e-6


def test_decimals_stay_as_they_are_when_rounded_up():
    np.testing.assert_array_equal(round_up(np.array([0.0, 1e-6, 0.3, 2.126421])), [0.0, 1e-6, 0.3, 2.126421])


def test_the_bytes_are_those_of_python_formatting():
    figures = by_hand()
    program, deviation = figures.program, figures.deviation
    kinds = ["cut", "fill", "link", "rapid"]
    lines = [header(program.letters)]
    for i, words in enumerate(program.words):
        numbers = [
            *words[[0, 1, 2, 4, 3]],
            program.feed[i],
            deviation.u_line[i],
            deviation.line[i],
            deviation.u_segment[i],
        ]
        numbers += [deviation.segment[i], deviation.bound[i], np.degrees(deviation.axis[i])]
        text = ",".join(f"{number:.6f}" for number in numbers)
        lines.append(
            f"{i},{program.line[i]},{kinds[program.motion[i]]},{text},{int(figures.singularity.singular[i])}"
        )
    assert blocks_csv(program, deviation, figures.singularity).decode() == "\n".join(lines) + "\n"


def test_no_word_reads_minus_zero():
    figures = table2()
    words = figures.program.words.copy()
    words[0] = -0.0
    program = dataclasses.replace(figures.program, words=words)
    assert b"-0.000000" not in blocks_csv(program, figures.deviation, figures.singularity)


def test_a_program_without_blocks_has_only_a_header():
    figures = empty()
    assert (
        blocks_csv(figures.program, figures.deviation, figures.singularity)
        == header("XYZCA").encode() + b"\n"
    )
