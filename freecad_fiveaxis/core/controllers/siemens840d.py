# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens SINUMERIK 840D sl and ONE (Programming manuals Fundamentals, NC programming, and Job planning:
5-axis transformation).

Guided: TRAORI, with the rotary words (ORIAXES) or the direction vector A3= B3= C3= (ORIVECT, ORIWKS); TRAFOOF
ends it.

Rapids: linear by RTLION, the default (MD20730); RTLIOF makes them nonlinear only under G60 and without a
transformation (SINUMERIK ONE Programming Manual NC programming, 2.9 Motion commands). What we write is under
G64 or G642, so linear.
"""

from __future__ import annotations

from freecad_fiveaxis.core.base.rapids import INTERPOLATED

from .dialect import ANGLES, VECTORS, Dialect, Guide

SIEMENS840D = Dialect(
    name="siemens840d",
    description="Siemens 840D, joint output or TRAORI (rotary words, or A3= B3= C3=), G93 or G94",
    convention="""Rotary words are absolute degrees, turns not folded; where the machine file says modulo, they are C=DC(0
to 360), "direct coordinate", which is the shorter way. G710: lengths and feeds in mm. FGROUP names all five axes, so that F
(G94) is the speed over all of them, a degree counted as a millimetre (FGREF as it is set at the factory, 360/2pi mm: one
degree is one millimetre). Under G93 (inverse-time feedrate) F is one over the minutes of the block, in every feed block.
G64 is continuous path mode; G642 with CTOL rounds within the contour tolerance. Comments after a semicolon. After TRAORI
the work offset is called again, because the switch drops it. ORIAXES interpolates the rotary axes, ORIVECT turns the vector
in a plane. CYCLE832 is High Speed Settings: tolerance, mode, version. D1 is the cutting edge with the tool's length. SUPA
suppresses all offsets for its block and D0 the tool's length, so that Z is a machine coordinate; G75 FP=1 Z1=0 drives the
machine axis Z1 to its first fixed point.""",  # noqa: E501
    language="siemens",
    suffix=".mpf",
    metric="G710",
    inch="G700",
    head=(
        "{title}",
        "G710 G17 G40 G90",
        "TRAFOOF",
        "{offset}",
        "{path}",
        "{tool}",
        "{length}",
        "{spindle}",
        "{coolant}",
        "FGROUP({axes})",
        "{feed_mode}",
    ),
    tail=("M5", "M9", "G94", "M30"),
    guided_head=(
        "{title}",
        "G710 G17 G40 G90",
        "{path}",
        "{tool}",
        "{length}",
        "{guide}",
        "{offset}",
        "{spindle}",
        "{coolant}",
        "FGROUP({axes})",
        "{feed_mode}",
    ),
    guided_tail=("{guide}", "M5", "M9", "G94", "M30"),
    guides={
        ANGLES: Guide(on=("TRAORI", "ORIMKS ORIAXES"), off=("TRAFOOF",), rotary_in_feed=True),
        VECTORS: Guide(
            on=("TRAORI", "ORIWKS ORIVECT"),
            off=("TRAFOOF",),
            vector=("A3=", "B3=", "C3="),
            rotary_in_feed=True,
        ),
    },
    feed_decimals=3,
    inverse_decimals=3,
    largest_feed=999_999.0,
    largest_inverse=99_999.0,
    rotary_in_feed=True,
    line_length=512,
    comment=("; ", ""),
    exact_path="G64",
    rapids=INTERPOLATED,
    blend_path="G642 CTOL={blend}",
    work_offsets=(r"G5[4-7]|G50[5-9]|G5[1-9][0-9]", "G54 to G57, or G505 to G599"),
    shorter_way=True,
    shorter_word=("=DC(", ")"),
    high_speed=(("CYCLE832({tolerance},_FINISH,1)",), ("CYCLE832(0,_OFF,1)",)),
    machine_retract=("G0 SUPA Z{z} D0", "D1"),
    reference_return=("G75 FP=1 Z1=0",),
    tool_call="T{tool} M6",
    tool_length="D1",
)
