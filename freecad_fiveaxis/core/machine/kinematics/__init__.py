# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forward and inverse kinematics of every machine with two rotary axes."""

from .rotary_pair import BEYOND, RotaryPair
from .serial_chain import (
    Chain,
    Setup,
    branch_of,
    chain,
    forward,
    forward_tip,
    inverse,
    inverse_axis,
    joint_words,
    lift_of,
    linear_words,
    q_to_words,
    raise_chain,
    words_to_q,
)

__all__ = [
    "BEYOND",
    "Chain",
    "RotaryPair",
    "Setup",
    "branch_of",
    "chain",
    "forward",
    "forward_tip",
    "inverse",
    "inverse_axis",
    "joint_words",
    "lift_of",
    "linear_words",
    "q_to_words",
    "raise_chain",
    "words_to_q",
]
