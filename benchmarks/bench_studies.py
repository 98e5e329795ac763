# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a setup map and a reach map gain by a second process, as ratios in the same run; the processes have
begun before.

Run: ``python benchmarks/bench_studies.py [facets]``. Without workers one process makes all trials, with
threads where columns are long, so that a second process gains less than twice.
"""

from __future__ import annotations

import sys
import tempfile
from concurrent.futures import Executor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.parts import bumpy
from benchmarks.timing import median_seconds, print_table
from freecad_fiveaxis.core.base.crew import process_crew
from freecad_fiveaxis.core.base.memory import keep_freed_memory
from freecad_fiveaxis.core.geometry.mesh import write_stl
from freecad_fiveaxis.core.pipeline.settings import Settings, build_settings
from freecad_fiveaxis.core.studies import study

GIVEN = {"machine": "trunnion_ac", "cutter": "ball:6"}
STUDIES = {
    "setup": {
        "passes": "planes",
        "tool_axis": "facet_mean",
        "stepover": 1.0,
        "region": (40, 40, 20),
        "grid": (7, 7, 3),
    },
    "reach": {"holder": ((40.0, 30.0),), "tool_length": 120.0},
}


def compare(facets: int = 5_000) -> None:
    """Each study without workers, with one, and with two."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        part = str(Path(folder) / "part.stl")
        write_stl(bumpy(facets), part)
        with process_crew(1).open() as one, process_crew(2).open() as two:
            for task, more in STUDIES.items():
                settings = build_settings(task, part, GIVEN | more)
                here, single, double = (_seconds(settings, pool) for pool in (None, one, two))
                taken = [f"{took:.2f}" for took in (here, single, double)]
                rows.append([task, *taken, f"{single / double:.2f}", f"{here / double:.2f}"])
    heads = ("study", "here, s", "1 worker, s", "2 workers, s", "2 : 1", "2 : here")
    print_table(f"studies of {facets:,} facets", heads, rows)


def _seconds(settings: Settings, pool: Executor | None) -> float:
    return median_seconds(lambda: study.run(settings, executor=pool), 3)


if __name__ == "__main__":
    keep_freed_memory()
    compare(*map(int, sys.argv[1:]))
