# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forward and inverse kinematics of every shipped machine, points per second, beside stacked matrices in the
same run.

The peer is what is usually written first: one 3x3 matrix a point (scipy's Rotation), applied to rows.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.timing import median_seconds, print_table
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine import list_shipped_machines, load_machine
from freecad_fiveaxis.core.machine.kinematics import (
    Chain,
    Setup,
    chain,
    forward,
    inverse,
    inverse_axis,
    linear_words,
)

POINTS = 500_000


def stacked_forward(kinematics: Chain, q: Floats) -> tuple[Floats, Floats]:
    """Tip and axis of a machine whose linear axes stand together, by stacks of matrices."""
    first, second = (Rotation.from_rotvec(q[:, 3 + i, None] * kinematics.direction[3 + i]) for i in range(2))
    sums = [q[:, :3] if kinematics.slot[0] == slot else 0.0 for slot in range(3)]
    inner = kinematics.point2 + second.apply(np.zeros((len(q), 3)) + sums[2] - kinematics.point2)
    tip = sums[0] + kinematics.point1 + first.apply(sums[1] + inner - kinematics.point1)
    return tip, (first * second).apply((0.0, 0.0, 1.0))


def rows() -> list[list[str]]:
    """One row a machine: million points per second."""
    rng = np.random.default_rng(1)
    q = np.asfortranarray(
        np.column_stack([rng.uniform(-300, 300, (POINTS, 3)), rng.uniform(-np.pi, np.pi, (POINTS, 2))])
    )
    table = []
    for name in list_shipped_machines():
        kinematics = chain(load_machine(name), Setup(tool_length=100.0))
        tip, axis = forward(kinematics, q)
        np.testing.assert_allclose(stacked_forward(kinematics, q[:1000])[0], tip[:1000], rtol=0, atol=1e-9)
        calls = (
            lambda kinematics=kinematics: forward(kinematics, q),
            lambda kinematics=kinematics, tip=tip, axis=axis: inverse(kinematics, tip, axis),
            lambda kinematics=kinematics, axis=axis: inverse_axis(kinematics, axis),
            lambda kinematics=kinematics, tip=tip: linear_words(kinematics, tip, q[:, 3:]),
        )
        speeds = [POINTS / median_seconds(call) / 1e6 for call in calls]
        peer = (
            POINTS
            / 10
            / median_seconds(lambda kinematics=kinematics: stacked_forward(kinematics, q[: POINTS // 10]))
            / 1e6
        )
        table.append([name, *(f"{speed:.1f}" for speed in speeds), f"{peer:.2f}", f"{speeds[0] / peer:.1f}"])
    return table


def main() -> None:
    """Print the table."""
    heads = [
        "machine",
        "forward",
        "inverse, both",
        "angles, both",
        "linear words",
        "stacked forward",
        "ratio",
    ]
    print_table(f"Kinematics, million points/s ({POINTS} points)", heads, rows())


if __name__ == "__main__":
    main()
