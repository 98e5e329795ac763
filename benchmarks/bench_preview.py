# SPDX-License-Identifier: LGPL-2.1-or-later
"""The passes alone beside the whole path that they become, of the same part and settings in one process.

*Preview*: :func:`freecad_fiveaxis.core.pipeline.preview.preview_passes`; *path*: the program, not yet proven,
tool axes along the normals and without a cure of gouges, so that the ratio is a lower bound. The part is a
bumpy block of SIDE mm; with the stepover its passes are only cut, with the scallop their distances are
measured first.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.parts import bumpy
from benchmarks.timing import median_seconds, print_table
from freecad_fiveaxis.core.base.memory import keep_freed_memory
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.preview import preview_passes
from freecad_fiveaxis.core.pipeline.settings import build_settings

FACETS = 20_000
GIVEN = {
    "machine": "trunnion_ac",
    "cutter": "ball:10",
    "tool_axis": "facet_mean",
    "gouge": "off",
    "linearize": "off",
}
SPACINGS = ({"stepover": 1.3}, {"scallop": 0.1})


def compare() -> None:
    """Each strategy with each spacing."""
    mesh, rows = bumpy(FACETS), []
    for passes in ("planes", "zlevel", "scallop"):
        for spacing in SPACINGS:
            settings = build_settings("mill", "part.stl", GIVEN | spacing | {"passes": passes})
            found = preview_passes(settings, mesh=mesh)
            taken = median_seconds(lambda settings=settings: preview_passes(settings, mesh=mesh), 1)
            whole = median_seconds(lambda settings=settings: job.make(settings, mesh=mesh), 1)
            message = " ".join(f"{name} {value}" for name, value in spacing.items())
            rows.append(
                [passes, message, found.passes, f"{found.length / 1000:.1f}", f"{1e3 * taken:.0f}",
                    f"{1e3 * whole:.0f}",
                 f"{whole / taken:.1f}"]
            )  # fmt: skip
    heads = ("passes", "spacing", "number", "m", "preview, ms", "path, ms", "times")
    print_table(f"preview of passes, {len(mesh.face):,} facets", heads, rows)


if __name__ == "__main__":
    keep_freed_memory()
    compare()
