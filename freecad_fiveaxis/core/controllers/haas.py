# SPDX-License-Identifier: LGPL-2.1-or-later
"""Haas mills with the next generation control (Mill operator's manual): UMC and rotary tables.

Guided: tool center point control, TCPC (G234); G49 ends it.

Rapids: "Generally, rapid motion will not be in a single straight line. Each axis specified moves at its
maximum speed, but all axes will not necessarily complete their motions at the same time" (Haas, G00 Rapid
Motion Positioning).
"""

from __future__ import annotations

from freecad_fiveaxis.core.base.rapids import INDEPENDENT

from .dialect import ANGLES, Dialect, Guide

HAAS = Dialect(
    name="haas",
    least_increment=True,
    description="Haas NGC (UMC, TR), joint output or TCPC (G234), G93 or G94",
    convention="""Rotary words are absolute degrees. Every number has a decimal point; the control's step is 0.0001 mm and
0.001 deg. Under G93 (inverse time feed mode) F is one over the minutes of the block, in every feed block. Under G94 F is
the speed of X Y Z; a rotary axis alone is timed by its diameter in settings 34 and 79, if they are not 0: use G93 where
rotary axes move, and those settings do not matter. The axes count their turns on and do not take the shorter way to a word,
so words are never folded. G234 H turns on TCPC: X Y Z are the tip in the work, F is the tip's speed. Additional work
offsets are G154 P1 to P99. G187 sets smoothness (P1 rough, P2 medium, P3 finish) and corner rounding (E, mm).""",  # noqa: E501
    head=(
        "%",
        "O{program} {title}",
        "G21 G17 G40 G80 G90",
        "{offset}",
        "{path}",
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
        "{path}",
        "{tool}",
        "{guide}",
        "{spindle}",
        "{coolant}",
        "{feed_mode}",
    ),
    guided_tail=("{guide}", "M5", "M9", "G94", "M30", "%"),
    guides={ANGLES: Guide(on=("G234 H{number}",), off=("G49",), needs_tool=True)},
    linear_decimals=4,
    inch_decimals=4,
    rapids=INDEPENDENT,
    rotary_decimals=3,
    feed_decimals=3,
    inverse_decimals=3,
    largest_feed=99_999.999,
    largest_inverse=99_999.999,
    upper_case=True,
    line_length=120,
    exact_path="G187",
    blend_path="G187 E{blend}",
    work_offsets=(r"G5[4-9]|G154 ?P[1-9][0-9]?|G1(1[0-9]|2[0-9])", "G54 to G59, or G154 P1 to G154 P99"),
    high_speed=(("G187 P3 E{tolerance}",), ("G187",)),
    tool_call="G49 T{tool} M6",
)
