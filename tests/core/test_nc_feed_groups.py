# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens' FGROUP and FGREF: the times that its manual tells, and by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from test_nc_cycles import errors
from test_nc_planes import TRUNNION, read

from freecad_fiveaxis.core.audit.rates import compute_commanded_rates, feed_findings
from freecad_fiveaxis.core.motion.program import Program

HEAD = "G710 G90 G94\nG0 X0 Y0 Z0 A0 C0\n"


def siemens(text: str) -> Program:
    return read(f"{HEAD}{text}M30\n", "siemens840d")


@pytest.mark.parametrize(
    ("line", "seconds"),
    [
        ("G710 X10 F100", 6.0),
        ("G710 X10 A10 F100", 60 * 14.1421356 / 100),
        ("G710 A10 F100", 6.0),
        ("G710 X0.001 A10 F100", 6.0),
        ("G700 X10 F100", 6.0),
        ("G700 X10 A10 F100", 60 * math.hypot(254, 10) / 2540),
        ("G700 A10 F100", 6.0),
        ("G700 X0.001 A10 F100", 60 * math.hypot(0.0254, 10) / 2540),
        ("G700 FGREF[A]=57.2957795 X0.001 A10 F100", 6.0),
        ("G700 FGREF[A]=57.2957795 A10 F100", 6.0),
        ("G710 FGREF[A]=10 A36 F100", 60 * 2 * math.pi / 100),
    ],
)
def test_the_times_of_the_manuals_example(line: str, seconds: float) -> None:
    """NC programming 2.7.1, example 1: the blocks N140 to N320, under FGROUP(X,A), each from X0 A0; and A alone with
    a radius."""
    program = siemens(f"FGROUP(X,A)\nG91 G1 {line}\n")
    assert not errors(program), program.findings
    assert program.seconds[-1] == pytest.approx(seconds, rel=1e-5)


@pytest.mark.parametrize(
    ("group", "way"),
    [
        ("", 5.0),
        ("FGROUP()\n", 5.0),
        ("FGROUP(X,Y,Z)\n", 5.0),
        ("FGROUP(X, Y, Z, A, C)\n", math.sqrt(3**2 + 4**2 + 12**2)),
        ("FGROUP(Y,A)\n", math.hypot(4, 12)),
        ("FGROUP(X,Y,Z,A,C)\nFGROUP()\n", 5.0),
        ("FGREF[A]=90\n", 5.0),
        ("FGROUP(X,Y,Z,A)\nFGREF[A]=90\n", math.hypot(5, 90 * math.radians(12))),
        ("FGREF[A]=90 FGREF[C]=7\nFGROUP(X,Y,Z,A)\n", math.hypot(5, 90 * math.radians(12))),
    ],
)
@pytest.mark.parametrize("guide", ["", "TRAORI\n"])
def test_f_is_over_the_axes_that_fgroup_names(group: str, way: float, guide: str) -> None:
    """Under TRAORI X Y Z are the tip's, so without FGROUP F is the feed over the part."""
    program = siemens(f"{guide}{group}G1 X0 Y0 Z0 F600\nX3 Y4 A12\n")
    assert program.seconds[-1] == pytest.approx(way / 10, rel=1e-6)


def test_a_group_holds_from_its_line_on_and_in_a_loop_anew() -> None:
    text = "G1 X0 F600\nX3 A4\nFGROUP(X,A)\nX6 A8\nFGROUP()\nX9 A12\nR1=0\nAGAIN:\nFGROUP(A)\nX12 A16\nFGROUP(X)\n"
    program = siemens(f"{text}X15 A20\nX9 A12\nR1=R1+1\nIF R1<2 GOTOB AGAIN\n")
    assert (program.seconds[2:] * 10).tolist() == pytest.approx([3, 5, 3, 4, 3, 6, 4, 3, 6])


def test_a_block_in_which_no_axis_of_the_group_moves_is_measured_over_all_that_do() -> None:
    program = siemens("FGROUP(X,Y)\nG1 X0 F600\nZ3 A4\n")
    assert program.seconds[-1] == pytest.approx(0.5)


def test_under_g93_a_group_changes_nothing() -> None:
    program = siemens("FGROUP(X,Y,Z,A,C)\nG93 G1 X3 A4 F2\n")
    assert program.seconds[-1] == pytest.approx(30.0)


@pytest.mark.parametrize(("group", "slow"), [("", 0), ("FGROUP(X,Y,Z)\n", 0), ("FGROUP(X,Y,Z,A,C)\n", 1)])
def test_the_audit_warns_of_the_feed_only_where_rotary_axes_count(group: str, slow: int) -> None:
    """1 mm and 3 deg a block: over all five axes the tip has 500 / sqrt(10) mm/min."""
    lines = "".join(f"X{k} A{3 * k}\n" for k in range(1, 9))
    program = siemens(f"TRAORI\n{group}G1 X0 F500\n{lines}")
    rates = compute_commanded_rates(TRUNNION, program)
    np.testing.assert_allclose(rates.tip_feed[-8:], 500 / 10**0.5 if slow else 500.0, rtol=1e-6)
    found = feed_findings(TRUNNION, program, rates)
    assert [one.code for one in found] == ["feed-over-part"] * slow
