# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mach3 and Mach4 (Using Mach3Mill, G and M code reference). There is no tool centre point control: joint
output only.

Rapids: no source was found that says whether G0 is interpolated in every version, rotary axes too.
"""

from __future__ import annotations

from freecad_fiveaxis.core.base.rapids import UNKNOWN

from .dialect import Dialect

MACH3 = Dialect(
    name="mach3",
    description="Mach3 and Mach4, joint output, G93 or G94",
    convention="""Rotary words are absolute degrees and count on without end ("wrapped linear axes"): in General Config,
Rotational, "Rot 360 rollover" and "Ang short rot on G0" must be off, and A, B, C set to angular. Under G93 F is one over
the minutes of the block, in every feed block. Under G94 F is the speed of X Y Z; where only rotary axes move, degrees a
minute. G61 (exact stop) is the default; G64 (constant velocity) rounds corners as the general settings say, so a blend
tolerance cannot be given in the program. The percent sign is not needed.""",  # noqa: E501
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
    line_length=250,
    rapids=UNKNOWN,
    exact_path="G61",
    blend_path="G64",
    work_offsets=(
        r"G5[4-9]|G59 ?P([7-9]|[1-9][0-9]|1[0-9]{2}|2[0-4][0-9]|25[0-4])",
        "G54 to G59, or G59 P7 to G59 P254",
    ),
    tool_call="T{tool} M6",
)
