# SPDX-License-Identifier: LGPL-2.1-or-later
"""Both strategies on whole parts, through the whole pipeline: the paper's Figs. 18 to 21.

Judged are the blocks that cut a facet or close a gap; rapids, retracts and approaches are left out. The words
drive the ball's centre, because that is what leaves the mark.

depth     of the A axis' line below the part's lowest point, mm; None: through the part, at half its height.
tables    ``trunnion_ac`` is shipped: A carries C, and its pole is the upright tool. ``table_ab`` is the same
          trunnion with a B axis in the place of C: its pole is the tool along Y, which no part here comes
          near.
"""

from __future__ import annotations

import atexit
import functools
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from lin_ye_arc import MACHINE

from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.geometry.mesh import read_stl
from freecad_fiveaxis.core.machine import Machine, save_machine
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.cl_path import Motion

ROOT = Path(__file__).resolve().parents[2]
PART = "freeform_233"
OTHERS = ("dome", "blade", "saddle")
TABLES = ("table_ab", "trunnion_ac")
STEPOVER = 5.0
STEEPEST = 60.0
"""deg: steeper facets are left out. Over the rim to a wall the tool would turn by 90 deg within one facet."""
LEAST = 1e-3
"""mm: blocks that deviate less are left out of medians. They are the many that hardly turn, and gaps, where
nothing turns."""


@dataclass(frozen=True, eq=False)
class Cuts:
    """One row a cutting block: ``deviation`` mm; ``pass_`` counted from 1; ``start``, ``end`` (n, 3) mm, the
    contact at its ends; ``along`` (n,) mm, the way cut since the pass began."""

    deviation: Floats
    pass_: Ints
    start: Floats
    end: Floats
    along: Floats

    @property
    def per_pass(self) -> Floats:
        """Largest deviation of each pass, mm."""
        return np.array(
            [self.deviation[self.pass_ == number].max() for number in range(1, self.pass_.max() + 1)]
        )

    @property
    def length(self) -> Floats:
        """Of each block on the part, mm; 0 where it closes a gap."""
        return np.asarray(np.linalg.norm(self.end - self.start, axis=1))

    @property
    def median(self) -> float:
        """Of the blocks that deviate at all, mm."""
        return float(np.median(self.deviation[self.deviation > LEAST]))


@functools.lru_cache(maxsize=1)
def workshop() -> Path:
    """A folder with the example parts and the machine files; it is removed when the interpreter ends."""
    folder = Path(tempfile.mkdtemp(prefix="lin-ye-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    script = ROOT / "resources" / "examples" / "make_parts.py"
    subprocess.run([sys.executable, str(script), str(folder)], check=True, capture_output=True)
    for machine in (MACHINE, table_ab()):
        save_machine(machine, str(folder / f"{machine.name}.fcm"))
    return folder


def table_ab() -> Machine:
    """The trunnion machine with B in the place of C; both rotary lines cross."""
    crossing = MACHINE.rotary[1].point
    axes = tuple(
        replace(axis, letter="B", direction=(0.0, 1.0, 0.0), point=crossing) if axis.letter == "C" else axis
        for axis in MACHINE.axes
    )
    return replace(MACHINE, name="table_ab", axes=axes)


def origin(part: str, depth: float | None) -> tuple[float, float, float]:
    """The work zero in the machine frame: the part's middle over the crossing of the rotary lines, ``depth``
    above A."""
    vertex = read_stl(str(workshop() / f"{part}.stl")).vertex
    low, high = vertex.min(axis=0), vertex.max(axis=0)
    x, y, z = MACHINE.rotary[1].point
    level = 0.5 * (low[2] + high[2]) if depth is None else low[2] - depth
    return float(x - 0.5 * (low[0] + high[0])), float(y - 0.5 * (low[1] + high[1])), float(z - level)


@functools.cache
def mill(part: str, table: str, strategy: str, depth: float | None, **others: float) -> Cuts:
    """The cutting blocks of one job: ball 10, planes 5 mm apart along X, all passes one way; ``others``: more
    options."""
    options = {
        "machine": str(workshop() / f"{table}.fcm"), "origin": list(origin(part, depth)), "cutter": "ball:10",
        "passes": "planes", "stepover": STEPOVER, "order": "one_way", "tool_axis": strategy,
        "control_point": "centre",
        "linearize": "off", "gouge": "off", "max_axis_angle": STEEPEST, **others,
    }  # fmt: skip
    result = job.run(build_settings("mill", str(workshop() / f"{part}.stl"), options))
    program, path = result.draft.program, result.draft.joints.path
    cut = np.flatnonzero(program.motion <= Motion.FILL)
    row, row_before = program.row[cut], program.row[cut - 1]
    pass_ = np.unique(path.pass_[row], return_inverse=True)[1]
    total = np.cumsum(np.linalg.norm(path.tip[row] - path.tip[row_before], axis=1))
    begun = np.concatenate([[0.0], total])[np.searchsorted(pass_, pass_)]
    return Cuts(
        result.deviation.segment[cut], pass_ + 1, path.contact[row_before], path.contact[row], total - begun
    )


def deviation_at(cuts: Cuts, start: Floats, end: Floats) -> float:
    """Deviation of the block between two contacts, mm: the same block of another method's job."""
    off = np.abs(cuts.start - start).max(axis=1) + np.abs(cuts.end - end).max(axis=1)
    return float(cuts.deviation[off.argmin()])
