# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the programs of a comparison do to the part, the table below it and faces to avoid: how it is asked,
and what its findings say."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.motion.program import Program

CheckPart = Callable[[Program, Progress], tuple[Finding, ...]]
"""What a station's program enters, as ``mill`` checks it."""


def enters_part(findings: Sequence[Finding] | None) -> bool:
    """Whether something enters part or table, or comes too near to faces to avoid."""
    return any(one.severity is Severity.ERROR for one in findings or ())


def find_deepest(findings: Sequence[Finding] | None) -> Finding | None:
    """Return the deepest entry."""
    met = [one for one in findings or () if one.severity is Severity.ERROR]
    return max(met, key=rank_entry, default=None)


def rank_entry(found: Finding) -> tuple[bool, bool, float]:
    """Return what is larger of a deeper entry: one of the whole cutter is deeper than any, and to be too near
    to faces to avoid, whose value is the distance left, is none."""
    return found.code == Code.BURIED, found.code != Code.AVOIDED_FACES_NEAR, found.value or 0.0
