# SPDX-License-Identifier: LGPL-2.1-or-later
"""Constant-scallop passes over slivers that meet in one vertex: cost of a sliver as they grow in number,
against the fewest.

About 1 on every line where the cost is linear.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.timing import print_table, run_seconds
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_faces
from freecad_fiveaxis.core.passes import PassOptions, Region, find_pass_strategy, flat_interval

RADIUS, SCALLOP = 3.0, 0.02  # mm
SLIVERS = (500, 1000, 2000, 4000)


def fan(slivers: int) -> Mesh:
    """Return a flat cone, 12 mm across, of so many facets at its tip."""
    turn, row = np.linspace(0.0, 2.0 * np.pi, slivers, endpoint=False), np.arange(slivers)
    rim = np.stack([6.0 * np.cos(turn), 6.0 * np.sin(turn), np.zeros(slivers)], axis=1)
    return from_faces(
        np.concatenate([[[0.0, 0.0, 0.5]], rim]),
        np.stack([0 * row, 1 + row, 1 + (row + 1) % slivers], axis=1),
    )


def main() -> None:
    """Print the table."""
    rows, strategy, interval, least = [], find_pass_strategy("scallop"), flat_interval(RADIUS, SCALLOP), 0.0
    for slivers in SLIVERS:
        region = Region(fan(slivers), np.ones(slivers, np.bool_), RADIUS, interval)
        seconds = (
            min(run_seconds(lambda region=region: strategy.field(region, PassOptions(scallop=SCALLOP)), 2))
            / slivers
        )
        least = least or seconds
        rows.append([f"{slivers:,}", f"{1e6 * seconds:.0f}", f"{seconds / least:.2f}"])
    print_table("Scallop passes over a fan", ("slivers", "us a sliver", "over the fewest"), rows)


if __name__ == "__main__":
    main()
