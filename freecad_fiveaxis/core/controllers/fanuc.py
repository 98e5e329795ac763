# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fanuc series 15i to 31i (B-63324EN, B-63944EN and later operator's manuals).

Guided: tool center point control for 5-axis machining, type 1 (G43.4, rotary words) and type 2 (G43.5, I J
K).

Rapids: "either of the following tool paths can be selected according to bit 1 (LRP) of parameter No. 1401"
(B-63944EN, 4.1 Positioning): nonlinear, each axis at its own rate, or linear. What the builder has set is not
known.
"""

from __future__ import annotations

from freecad_fiveaxis.core.base.rapids import UNKNOWN

from .dialect import ANGLES, INCH, VECTORS, Dialect, Guide

FANUC = Dialect(
    name="fanuc",
    least_increment=True,
    description="Fanuc 15i to 31i, joint output or tool centre point control (G43.4, G43.5), G93 or G94",
    convention="""Rotary words are absolute degrees, turns not folded: the axes must be set to rotary type B, or roll-over
off (parameters 1006 and 1008); where the machine file says modulo, they are 0 to 360, which is roll-over on and the shorter
way (parameter 1008#0 and #1). Every number has a decimal point. Under G93 F is one over the minutes of the block, in every
feed block. Under G94 F is the speed over all axes, a degree counted as a millimetre (Linear interpolation G01: X20. C40.
F300. takes sqrt(20^2 + 40^2)/300 min). Comments in capitals. G49 stands before the tool call, because it ends G43.4 too; by itself it drives Z down by the tool's
length where parameter 5006#6 is 0, so Z retracts before it.
Under G43.4 and G43.5 X Y Z are the tip's place in the work ("programming coordinate system" on the workpiece, parameter
19696#5 = 0) and F is the tip's speed. Type 2: I J K is the tool's direction, all three in every block that has one, because
an omitted one counts as 0; the rotary axes take the shorter way. G05.1 Q1 is AI contour control.""",  # noqa: E501
    head=(
        "%",
        "O{program} {title}",
        "G21 G17 G40 G80 G90",
        "{offset}",
        "{tool}",
        "{length}",
        "{spindle}",
        "{coolant}",
        "{feed_mode}",
    ),
    tail=("M5", "M9", "G94", "M30", "%"),
    guided_head=(
        "%",
        "O{program} {title}",
        "G21 G17 G40 G80 G90",
        "{offset}",
        "{tool}",
        "{guide}",
        "{spindle}",
        "{coolant}",
        "{feed_mode}",
    ),
    guided_tail=("{guide}", "M5", "M9", "G94", "M30", "%"),
    guides={
        ANGLES: Guide(on=("G43.4 H{number}",), off=("G49",), needs_tool=True, retract_first=True),
        VECTORS: Guide(
            on=("G43.5 H{number}",), off=("G49",), vector=("I", "J", "K"), needs_tool=True, retract_first=True
        ),
    },
    feed_decimals=3,
    inch_decimals=4,
    inch_degree=INCH,
    rapids=UNKNOWN,
    inverse_decimals=3,
    largest_feed=99_999.0,
    largest_inverse=9_999.999,
    rotary_in_feed=True,
    upper_case=True,
    line_length=120,
    shorter_way=True,
    high_speed=(("G05.1 Q1",), ("G05.1 Q0",)),
    tool_call="G49 T{tool} M6",
)
