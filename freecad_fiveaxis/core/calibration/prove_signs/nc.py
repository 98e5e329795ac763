# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plan as a program: one block a move, all at feed, and after each stop's last block a comment and M0."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.controllers.dialect import feed_distance
from freecad_fiveaxis.core.machine.kinematics import q_to_words
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.nc.head import PostOptions, renumber_lines
from freecad_fiveaxis.core.nc.writer import write_nc
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .plan import USUAL_MARK, Plan, Stop

WAIT = "M0"
"""Program stop, ISO 6983-1: the same word in every dialect."""
BEFORE = "stop 0 - jog the tool high above the start - rotary axes at 0 - then go on"
BARE = f"nothing above Z {USUAL_MARK[2]:g}"
INSERTED = 2
"""Lines of a stop: its comment and WAIT."""


def proof_program(plan: Plan, dialect: Dialect) -> Program:
    """Return the blocks, one for each pose of the plan: G94, no axis faster than the wished feed (mm/min and
    deg/min). ``line``: where each stands in the text of :func:`proof_nc`."""
    poses = np.asarray(q_to_words(plan.poses))
    words = np.stack([dialect.round_word(poses[:, k], k) for k in range(5)], axis=1)
    change = np.diff(words, axis=0, prepend=words[:1])
    minutes = np.maximum(np.abs(change).max(axis=1) / plan.wishes.feed, 1e-6)
    feed = np.maximum(np.floor(feed_distance(dialect, change) / minutes + 1e-6), 1.0)
    feed[0] = plan.wishes.feed
    count = len(words)
    waits = np.cumsum([0] + [1 if stop.see else 0 for stop in plan.stops])[:-1]
    before = np.repeat(waits, [len(stop.q) for stop in plan.stops])
    line = dialect.first_line + np.arange(count) + INSERTED * (before + 1)
    motion = np.full(count, Motion.CUT, np.int8)
    return Program(
        plan.kinematics.letters,
        words,
        feed,
        np.zeros(count, bool),
        motion,
        60.0 * minutes,
        np.full(count, -1),
        line,
    )


def proof_nc(plan: Plan, program: Program, dialect: Dialect, options: PostOptions) -> bytes:
    """Return the NC text. The blocks are the writer's; the lines of the stops stand between them."""
    text = write_nc(program, dialect, f"{plan.machine.name}, proving signs", options).decode("ascii")
    lines = text.split(dialect.newline)
    at = dialect.first_line - 1
    before = BEFORE if plan.wishes.mark is not None else f"{BARE} - {BEFORE}"
    numbered = [*lines[:at], dialect.remark(before), WAIT]
    number = 0
    for stop in plan.stops:
        numbered += lines[at : at + len(stop.q)]
        at += len(stop.q)
        if stop.see:
            number += 1
            numbered += [dialect.remark(f"stop {number} - {_ascii(stop)}"), WAIT]
    return dialect.newline.join(renumber_lines(dialect, [*numbered, *lines[at:]])).encode("ascii")


def _ascii(stop: Stop) -> str:
    return stop.title.replace(",", " -")
