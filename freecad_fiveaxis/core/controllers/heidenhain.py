# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heidenhain TNC 320 to TNC7 and iTNC 530, conversational (klartext; User's manuals Klartext programming and
Multiple-axis machining).

Guided: FUNCTION TCPM, with the rotary words (AXIS POS, L blocks) or the tool vector (LN blocks with TX TY
TZ); on older controls M128 and M129.

Rapids: L blocks are straight, FMAX too: "the TNC moves the tool in a straight line from its current position
to the straight-line end point" (TNC 320 User's manual, 6.4). Of the older controls of ``heidenhain_m128`` it
is not known for rotary axes.
"""

from __future__ import annotations

from dataclasses import replace

from freecad_fiveaxis.core.base.rapids import INTERPOLATED, UNKNOWN

from .dialect import ANGLES, VECTORS, Dialect, Guide

HEIDENHAIN = Dialect(
    name="heidenhain",
    description="Heidenhain TNC, klartext: joint output or FUNCTION TCPM (L, or LN with TX TY TZ), mm/min",
    convention="""Rotary words are absolute degrees, turns not folded (M127, the behaviour without M126); where the machine
file says modulo, words are 0 to 360 under M126, "shorter-path traverse of rotary axes". There is no inverse time: F is
mm/min, 0.001 to 99999.999. In joint output (no M116) F is the speed over all axes, a degree counted as a millimetre; with F
TCP it is the speed of the tip over the work. FMAX is rapid, for its block alone. Every line has its number, from 0 on. The
work offset is the preset that is active at the control: the program calls none. L X Y Z and the rotary letters with their
signs; a comment follows a semicolon. Cycle 32 TOLERANCE sets the high-speed mode: T, the tolerance of the path, HSC-MODE 0
to finish, TA of rotary axes.""",  # noqa: E501
    language="heidenhain",
    suffix=".h",
    metric="MM",
    inch="",
    absolute="BEGIN",
    head=(
        "BEGIN PGM {program} MM",
        "{title}",
        "FUNCTION RESET TCPM",
        "{shorter}",
        "{tool}",
        "{offset}",
        "{spindle}",
        "{coolant}",
    ),
    tail=("M5", "M9", "M30", "END PGM {program} MM"),
    guided_head=(
        "BEGIN PGM {program} MM",
        "{title}",
        "{shorter}",
        "{tool}",
        "{offset}",
        "{spindle}",
        "{coolant}",
        "{guide}",
    ),
    guided_tail=("{guide}", "M5", "M9", "M30", "END PGM {program} MM"),
    guides={
        ANGLES: Guide(on=("FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS",), off=("FUNCTION RESET TCPM",)),
        VECTORS: Guide(
            on=("FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR",),
            off=("FUNCTION RESET TCPM",),
            vector=("TX", "TY", "TZ"),
            straight="LN",
        ),
    },
    rapid="L",
    straight="L",
    rapid_end=" FMAX",
    rapids=INTERPOLATED,
    inverse_time="",
    per_minute="",
    feed_decimals=3,
    largest_feed=99_999.999,
    rotary_in_feed=True,
    plus=True,
    number_step=1,
    number_letter="",
    number_all=True,
    comment=("; ", ""),
    work_offset="; ACTIVE PRESET",
    work_offsets=("G54", "G54, which stands for the preset that is active at the control"),
    shorter_way=True,
    shorter_on="M126",
    shorter_off="M127",
    high_speed=(
        ("CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1 T{tolerance}", "CYCL DEF 32.2 HSC-MODE:0 TA0.05"),
        ("CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1"),
    ),
    machine_retract=("L Z{z} R0 FMAX M91",),
    reference_return=("L Z+0 R0 FMAX M91",),
    tool_call="TOOL CALL {tool} Z S{speed:.0f}",
    speed_call="TOOL CALL Z S{speed:.0f}",
    spindle_on="M3",
)

HEIDENHAIN_M128 = replace(
    HEIDENHAIN,
    name="heidenhain_m128",
    rapids=UNKNOWN,
    description="Heidenhain iTNC 530 and TNC 4xx, klartext: as heidenhain, with M128 for FUNCTION TCPM",
    head=tuple("M129" if line == "FUNCTION RESET TCPM" else line for line in HEIDENHAIN.head),
    guides={
        ANGLES: Guide(on=("M128",), off=("M129",)),
        VECTORS: Guide(on=("M128",), off=("M129",), vector=("TX", "TY", "TZ"), straight="LN"),
    },
)
