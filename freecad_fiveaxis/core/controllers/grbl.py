# SPDX-License-Identifier: LGPL-2.1-or-later
"""grbl's multi-axis forks: grbl-Mega-5X, grblHAL, FluidNC (grbl wiki, G-code; grblHAL wiki). Joint output
only.

Rapids: the planner makes one line of every motion of all axes, rapids too, slowed down to the slowest axis
(grbl 1.1, ``planner.c``, ``plan_buffer_line`` and ``limit_value_by_axis_maximum``).
"""

from __future__ import annotations

from freecad_fiveaxis.core.base.rapids import INTERPOLATED

from .dialect import Dialect

GRBL = Dialect(
    name="grbl",
    description="grbl with five axes (grbl-Mega-5X, grblHAL, FluidNC), joint output, G93 or G94",
    convention="""Rotary words are absolute degrees and count on without end. Under G93 F is one over the minutes of the
block, in every feed block: use it, because under G94 F is the speed over all axes in grbl-Mega-5X and FluidNC, a degree
counted as a millimetre. There is no tool change (M6) and no G43 H: the operator puts in the tool and sets its length. Only
G61 (exact path) is known. A line has no more than 80 characters; numbers are kept in single precision, seven digits: keep
rotary words below some thousand degrees.""",  # noqa: E501
    head=(
        "{title}",
        "G21 G17 G40 G80 G90",
        "{offset}",
        "{path}",
        "{tool}",
        "{length}",
        "{spindle}",
        "{coolant}",
        "{feed_mode}",
    ),
    tail=("M5", "M9", "G94", "M30"),
    feed_decimals=3,
    inch_turns=True,
    rapids=INTERPOLATED,
    inverse_decimals=3,
    rotary_in_feed=True,
    line_length=80,
    exact_path="G61",
    blend_path="G61",
    work_offsets=(r"G5[4-9]", "G54 to G59"),
    tool_call="(put in tool {tool})",
    tool_length="(its length as the operator has set it)",
)
