# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fanuc series 15i to 31i (B-63324EN and later operator's manuals), joint output without tool centre point control."""

from __future__ import annotations

from .dialect import Dialect

FANUC = Dialect(
    name="fanuc",
    description="Fanuc 15i to 31i, joint output (no tool centre point control), G93 or G94",
    convention="""Rotary words are absolute degrees, turns not folded: the axes must be set to rotary type B, or roll-over off
(parameters 1006 and 1008). Every number has a decimal point. Under G93 F is one over the minutes of the block, in every
feed block. Under G94 F is the speed over all axes, a degree counted as a millimetre (Linear interpolation G01: X20. C40. F300.
takes sqrt(20^2 + 40^2)/300 min). Comments in capitals. G49 stands before the tool call, because it ends G43.4 too.""",
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
    feed_decimals=3,
    inverse_decimals=3,
    largest_feed=99_999.0,
    largest_inverse=9_999.999,
    rotary_in_feed=True,
    upper_case=True,
    line_length=120,
    tool_call="G49 T{tool} M6",
)
