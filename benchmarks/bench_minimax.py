# SPDX-License-Identifier: LGPL-2.1-or-later
"""minimax on a path of many passes, in rows a second and in measurements of the whole path
(deviation.measure) in the same run.

The passes go over a wave cut into short steps, on an A-B table; every row may turn.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "docs" / "studies"))

import lin_ye_parts as parts
import lin_ye_profiles as profiles

from benchmarks.timing import print_table, run_seconds
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, linear_words, q_to_words
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.orientation.minimax import minimax_axes
from freecad_fiveaxis.core.orientation.strategies import AxisOptions, tool_axes
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

PASSES = 40
TILT = np.radians(5.0)


def many_passes() -> OffsetPath:
    """Return the profiles' waves with every step cut in two, one beside the other."""
    paths = [profiles.offset_path(profiles.profile("wavy", seed % 20, 2)) for seed in range(PASSES)]
    columns = {
        name: np.concatenate([getattr(path, name) for path in paths])
        for name, value in vars(paths[0]).items()
        if isinstance(value, np.ndarray)
    }
    number = np.repeat(np.arange(PASSES), [len(path.point) for path in paths])
    return replace(paths[0], **columns | {"polyline": number, "pass_": number})


def main() -> float:
    """Print the table; returns how many measurements of the path one run of minimax takes."""
    path, (x, y, z) = many_passes(), parts.MACHINE.rotary[1].point
    kinematics = chain(parts.table_ab(), Setup((x, y, z + 60.0)))
    axis, count = tool_axes(path, "facet_mean", AxisOptions()), len(path.point)
    angles = np.column_stack([np.zeros(count), -np.arctan2(axis[:, 1], axis[:, 2])])
    words = q_to_words(np.column_stack([linear_words(kinematics, path.centre, angles), angles]))
    search = min(run_seconds(lambda: minimax_axes(path, axis, kinematics, 0.0, TILT, 1000.0), repeat=1))
    measured = min(run_seconds(lambda: measure(kinematics, words), repeat=5))
    rows = [
        (name, f"{count / time:,.0f}")
        for name, time in (("minimax", search), ("deviation.measure", measured))
    ]
    print_table(f"{PASSES} passes, {count} rows", ("", "rows/s"), rows)
    return search / measured


if __name__ == "__main__":
    print(f"minimax: as long as {main():.0f} measurements of the whole path")
