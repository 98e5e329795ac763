# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the CL path to joints: branch, winding, limits, retract and re-engage."""

from __future__ import annotations

from dataclasses import dataclass

from .cl_path import CLPath
from .findings import Finding
from .records import Bytes, Floats, Ints, freeze


@dataclass(frozen=True, eq=False)
class JointPath:
    """Words before rounding, one row a block end.

    ``path`` the CL path that is really driven: the one given plus inserted retract, rewind and re-engage rows; ``row`` (n,)
    the row of the given CL path that each row came from (an inserted row has that of the row which it leads to);
    ``q`` (n, 5) words before rounding in the order X Y Z, first rotary, second rotary (rotary: nearer to the work first),
    mm and rad, turns not folded; ``branch`` (n,) 0 or 1; ``sine`` (n,) singularity measure, 0 at the pole.
    """

    path: CLPath
    row: Ints
    q: Floats
    branch: Bytes
    sine: Floats
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, len(self.path.tip), row="i", q="f5", branch="m", sine="f")
