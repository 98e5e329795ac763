# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks near the pole at which there is nothing to look at: the tool stands at the pole all along.

Which way the first rotary axis points is free there, and the turn that a path needs somewhere is best made
there (``orientation/at_pole``, ``motion/joint_path``): the tool does not lean, and the linear axes carry the
part with the turn. What could show is the part's surface off its chord, and a tool that dwells until the turn
is made; where neither is so such a block is no worse than any other.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, forward_tip, words_to_q
from freecad_fiveaxis.core.motion.deviation import Deviation
from freecad_fiveaxis.core.motion.program import Program, feed_blocks
from freecad_fiveaxis.core.motion.program.feeds import STILL
from freecad_fiveaxis.core.motion.singularity import Singularity

UPRIGHT = math.radians(0.5e-3)
"""rad from the pole: half a step of a rotary word of three decimals, the coarsest that a controller gets."""

KEPT = 0.75
"""Share of the programmed feed that the tip must keep over the part: a quarter less changes chips as little
as a hand at the feed override does; a tool that is held back more may leave a mark where it dwells."""


def find_turns_at_pole(
    kinematics: Chain,
    program: Program,
    deviation: Deviation,
    singularity: Singularity,
    tolerance: float,
    programmed: Floats | None,
) -> Bools:
    """Tell which blocks (m,) turn an axis at the pole and harm nothing by it: singular ones at feed in which
    the tool stands at the pole, that hold ``tolerance`` mm by proof, and in which the tip keeps KEPT of the
    feed ``programmed`` (m,) mm/min. None of them where that is not known, or the controller guides the
    tip."""
    found = np.zeros(len(program.words), np.bool_)
    if programmed is None or program.guided is not None:
        return found
    rows = feed_blocks(program)
    rows = rows[singularity.singular[rows] & (deviation.bound[rows] <= tolerance)]
    share, upright = measure_kept(kinematics, program, rows, programmed)
    found[rows] = upright & (share >= KEPT)
    return found


def assume_programmed_feed(kinematics: Chain, program: Program) -> Floats | None:
    """Return what stands for the programmed feed (m,) mm/min of a program that was not made here: the median
    over the part of its feed blocks in which the tip moves, for F need not be the tip's; None where no block
    has a time."""
    rows = feed_blocks(program)
    rows = rows[program.seconds[rows] > 0.0]
    tip = forward_tip(kinematics, words_to_q(program.words))
    step = np.linalg.norm(tip[rows] - tip[rows - 1], axis=1)
    moving = step > STILL
    if not moving.any():
        return None
    return np.full(len(program.words), np.median(step[moving] * 60.0 / program.seconds[rows[moving]]))


def measure_kept(kinematics: Chain, program: Program, rows: Ints, programmed: Floats) -> tuple[Floats, Bools]:
    """Return which share of the feed ``programmed`` (m,) mm/min the tip keeps in the blocks ``rows`` (k,), 0
    where no time or feed is known, and in which the tool stands at the pole within rounding."""
    words = program.words[np.concatenate([rows - 1, rows])]
    tip, axis = forward(kinematics, words_to_q(words))
    lean = np.linalg.norm(np.cross(axis, kinematics.direction[3]), axis=1).reshape(2, -1)
    swung = np.abs(np.radians(np.subtract(*words[:, 4].reshape(2, -1))))
    step = np.linalg.norm(np.subtract(*tip.reshape(2, -1, 3)), axis=1)
    meant = programmed[rows] * program.seconds[rows] / 60.0
    share = np.divide(step, meant, out=np.zeros_like(step), where=meant > 0.0)
    return share, (lean <= UPRIGHT).all(axis=0) & (swung <= 2.0 * UPRIGHT)
