# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lin & Ye's half circle (III.A, Figs. 10 to 12): an arc that one rotary axis cuts with the tool normal to
it.

The arc lies in the YZ plane about the work zero M. On the trunnion machine the A axis runs R0 below M, and C
stands still.
psi       place on the arc, rad: 0 along +Y, pi/2 at the top.
beta      psi - pi/2 at the middle of a step: the angle between the arc's normal there and the line from the A
          axis to M.
shift     the way, mm, by which the whole tool is off at some u. The tool turns evenly, as the arc's normal
          does, so its direction is right, and every point of it is shifted by the same way.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, linear_words, q_to_words
from freecad_fiveaxis.core.motion.deviation import lin_ye_deviation, measure
from freecad_fiveaxis.core.motion.trajectory import tip_at

PAPER_R0 = 177.73
"""mm: with this the paper's example gives its 2.7 mm; the paper does not print its own."""
ARC, BALL = 60.0, 5.0
"""mm: radius of the half circle and of the ball. The ball's centre runs on a radius of 65."""
SAMPLES = 2001
MACHINE = load_machine("trunnion_ac")


def trunnion(centre_distance: float) -> Chain:
    """The trunnion machine with its A axis ``centre_distance`` mm below the work zero."""
    x, y, z = MACHINE.rotary[1].point
    return chain(MACHINE, Setup((x, y, z + centre_distance)))


def arc_words(kinematics: Chain, radius: float, psi: Floats) -> Floats:
    """Words (n, 5), mm and degrees: the driven point on the arc of ``radius`` mm at ``psi`` (n,), the tool
    normal to it."""
    point = radius * np.stack([0.0 * psi, np.cos(psi), np.sin(psi)], axis=1)
    angles = np.stack([0.0 * psi, psi - np.pi / 2], axis=1)
    return q_to_words(np.column_stack([linear_words(kinematics, point, angles), angles]))


def off_the_arc(kinematics: Chain, radius: float, psi: Floats) -> Floats:
    """Distance (n - 1, SAMPLES) mm of the real ball centre from the arc, along each step; negative:
    overcut."""
    words, u = arc_words(kinematics, radius, psi), np.linspace(0.0, 1.0, SAMPLES)
    place = tip_at(kinematics, words[:-1], words[1:], np.broadcast_to(u, (len(psi) - 1, SAMPLES)))
    return np.asarray(np.linalg.norm(place, axis=2) - radius)


def shift_measured(centre_distance: float, step: float, beta: float = 0.0) -> float:
    """The largest shift of one step, mm, by ``deviation.measure``.

    The driven point is the arc's centre, as on a tool that is longer by the arc's radius. It is commanded to
    stay where it is, so its deviation from that point is the shift.
    """
    psi = np.pi / 2 + beta + 0.5 * np.array([-step, step])
    kinematics = trunnion(centre_distance)
    return float(measure(kinematics, arc_words(kinematics, 0.0, psi)).segment[1])


def deviation_simulated(centre_distance: float, step: float, beta: float) -> float:
    """Distance, mm, of the ball's centre from its arc in the middle of a step: sampled, nothing left out."""
    psi = np.pi / 2 + beta + 0.5 * np.array([-step, step])
    off = off_the_arc(trunnion(centre_distance), ARC + BALL, psi)
    return float(np.abs(off[0, SAMPLES // 2]))


def off_the_chords(centre_distance: float, step: float) -> float:
    """What an audit of the half circle's program says, mm: the largest deviation from a commanded chord."""
    kinematics = trunnion(centre_distance)
    return float(measure(kinematics, arc_words(kinematics, ARC + BALL, half_circle(step))).segment.max())


def half_circle(step: float) -> Floats:
    """psi of the ends of the steps, from 0 to pi."""
    return np.linspace(0.0, np.pi, round(np.pi / step) + 1)


def steps_table() -> list[str]:
    """R0 by step angle (the paper's Fig. 12): measured, and eq. (6)."""
    steps = (2.5, 5.0, 10.0, 15.0, 20.0)
    lines = [
        "| R0, mm | " + " | ".join(f"{step:g} deg" for step in steps) + " |",
        "|---|" + "---|" * len(steps),
    ]
    for distance in (0.0, 50.0, 100.0, 150.0, PAPER_R0, 250.0, 300.0):
        cells = [
            (shift_measured(distance, np.radians(s)), float(lin_ye_deviation(distance, np.radians(s))))
            for s in steps
        ]
        lines.append(
            f"| {distance:g} | " + " | ".join(f"{got:.4f} / {formula:.4f}" for got, formula in cells) + " |"
        )
    return lines


def beta_table() -> list[str]:
    """beta at R0 of the paper and 20 deg: simulated, and eq. (6)."""
    lines = ["| beta, deg | simulated, mm | eq. (6), mm |", "|---|---|---|"]
    for beta in (0, 15, 30, 45, 60, 75, 90):
        formula = float(lin_ye_deviation(PAPER_R0, np.radians(20), np.radians(beta)))
        lines.append(
            f"| {beta} | {deviation_simulated(PAPER_R0, np.radians(20), np.radians(beta)):.3f} | "
            f"{formula:.3f} |"
        )
    return lines
