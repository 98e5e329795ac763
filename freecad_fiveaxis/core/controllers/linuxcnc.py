# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC 2.8 and later (manual: G-code reference; Kinematics, switchable kinematics).

Joint output: trivial kinematics, the words are the joints. Guided: the ``trt`` and other switchable
kinematics, whose remaps M428 and M429 switch to the tip and back; the tool's length reaches the kinematics by
``motion.tooloffset.z``.

Rapids: "the axes will arrive at the same time, since the ones that would arrive before the last axis gets to
the end are slowed down" (EMC Handbook, G0 Rapid linear motion).
"""

from __future__ import annotations

from freecad_fiveaxis.core.base.rapids import INTERPOLATED

from .dialect import ANGLES, Dialect, Guide

LINUXCNC = Dialect(
    name="linuxcnc",
    suffix=".ngc",
    description="LinuxCNC, joint output (trivial kinematics) or switchable kinematics (M428), G93 or G94",
    convention="""Rotary words are absolute degrees, not modulo (WRAPPED_ROTARY takes a word by its sign, not by the shorter
way, so words are never folded). Under G93 a block takes 60/F seconds, and every G1 needs its own F. Under G94 F is the
speed of X Y Z; where only rotary axes move, degrees a minute. G61 (exact path) is the default: G64 without P rounds corners
as far as the acceleration asks for, and what was proven is then not what is cut; with a blend tolerance the head says G64 P
Q. A line may hold 255 characters. M2 ends the program and sets the modes back.""",  # noqa: E501
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
    tail=("M5", "M9", "G94", "M2"),
    guided_head=(
        "{title}",
        "G21 G17 G40 G80 G90",
        "{offset}",
        "{path}",
        "{tool}",
        "{length}",
        "{guide}",
        "{spindle}",
        "{coolant}",
        "{feed_mode}",
    ),
    guided_tail=("{guide}", "M5", "M9", "G94", "M2"),
    guides={ANGLES: Guide(on=("M428",), off=("M429",))},
    exact_path="G61",
    rapids=INTERPOLATED,
    blend_path="G64 P{blend} Q{blend}",
    work_offsets=(r"G5[4-9]|G59\.[1-3]", "G54 to G59, or G59.1 to G59.3"),
)
