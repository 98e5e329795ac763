# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole pipeline, STL to NC file on disk, against ``%`` formatting of the same rows alone, and how cost
grows with facets.

``python bench_pipeline.py [FACETS PASSES ...]``; without arguments 1M facets x 500 passes, then the growth
table.
"""

from __future__ import annotations

import resource
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

import numpy as np
from parts import bumpy
from timing import print_table

from freecad_fiveaxis.core.base.files import write_whole
from freecad_fiveaxis.core.base.memory import keep_freed_memory
from freecad_fiveaxis.core.geometry.mesh import write_stl
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import Settings, build_settings

GROWTH = (20_000, 60_000, 200_000, 600_000, 2_000_000)
ROWS_FOR_PERCENT = 200_000
ROUNDS, FEW = 9, 3  # of the pipeline that is asked for, and of the table


def percent_rate(words: np.ndarray) -> float:
    """Rows a second of plain ``%`` formatting, the text that every post of the field writes."""
    rows = words[:ROWS_FOR_PERCENT]
    start = time.perf_counter()
    "".join(["G1 X%.4f Y%.4f Z%.4f A%.4f C%.4f F%.4f\n" % (*row, 100.0) for row in rows])  # noqa: UP031 the peer
    return len(rows) / (time.perf_counter() - start)


def settings_for(folder: Path, facets: int, passes: int) -> tuple[Settings, float]:
    """Return the job over a bumpy part of that many facets, its STL written, uncorrected; and the facets in
    millions."""
    mesh = bumpy(facets)
    write_stl(mesh, folder / "part.stl")
    extent = float(np.ptp(mesh.vertex[:, 1]))
    options = {
        "machine": "trunnion_ac", "stepover": extent / passes, "linearize": "off", "gouge": "off",
        "passes": "planes", "tool_axis": "facet_mean", "output": str(folder / "part.ngc"),
    }  # fmt: skip
    return build_settings("mill", str(folder / "part.stl"), options), len(mesh.face) / 1e6


class Timed(NamedTuple):
    """``blocks``; the seconds from STL to NC on disk and those of the proof, and the rows a second of ``%``:
    medians."""

    blocks: int
    draft: float
    proven: float
    percent: float


def timed(settings: Settings, rounds: int) -> Timed:
    """Return the pipeline and its peer in turns, for a busy machine's speed changes from second to second.

    After a run that is not counted: a fresh process gets its memory page by page, which costs more than the
    work itself on some virtual machines. What is freed stays with the process, as on the command line. The NC
    file is a new one each time.
    """
    keep_freed_memory()
    job.make(settings)
    output, found, blocks = Path(settings.output.output or ""), [], 0
    for _ in range(rounds):
        output.unlink(missing_ok=True)
        start = time.perf_counter()
        posted = job.make(settings)
        assert isinstance(posted, job.PostedProgram)
        write_whole(output, posted.nc)
        result = time.perf_counter()
        job.prove(posted)
        found.append((result - start, time.perf_counter() - result, percent_rate(posted.program.words)))
        blocks = len(posted.program.words)
        del posted  # it needs as much room as the next one
    return Timed(blocks, *np.median(found, axis=0).tolist())


def main(sizes: list[tuple[int, int]]) -> None:
    """Print one row a size."""
    rows = []
    for facets, passes in sizes:
        with tempfile.TemporaryDirectory() as folder:
            settings, millions = settings_for(Path(folder), facets, passes)
            blocks, result, proven, percent = timed(settings, FEW if rows else ROUNDS)
            peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
            rows.append(
                (f"{millions:.2f}", passes, blocks, f"{result:.2f}", f"{blocks / result / 1e6:.2f}",
                 f"{blocks / (result + proven) / 1e6:.2f}",
                 f"{percent / 1e6:.2f}", f"{blocks / result / percent:.2f}", f"{result / blocks * 1e6:.2f}",
                 f"{peak:.2f}")
            )  # fmt: skip
    heads = (
        "M facets",
        "passes",
        "blocks",
        "s to NC",
        "M blocks/s",
        "with proof",
        "% rows M/s",
        "ratio",
        "us/block",
        "GB",
    )
    print_table("STL to NC on disk", heads, rows)


if __name__ == "__main__":
    given = [int(float(word)) for word in sys.argv[1:]]
    main(
        list(zip(given[::2], given[1::2], strict=True))
        or [(1_000_000, 500), *((facets, 100) for facets in GROWTH)]
    )
