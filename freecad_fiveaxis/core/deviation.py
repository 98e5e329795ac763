# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the tip leaves the commanded segment while the axes move linearly, with a proven bound."""

from __future__ import annotations

from dataclasses import dataclass

from .findings import Finding
from .records import Floats, freeze


@dataclass(frozen=True, eq=False)
class Deviation:
    """One row a block of the Program, row 0 (the first position) all zero.

    ``line`` (m,) mm: largest distance of the real tip path from the infinite line through the block's ends (So et al.,
    eq. 6), at ``u_line``; ``segment`` (m,) mm: largest distance from the commanded segment, at ``u_segment``; ``bound``
    (m,) mm: proven upper bound of ``segment``; ``axis`` (m,) rad: largest angle by which the real tool axis leaves the plane
    of the block's two end axes; ``place`` (m, 3) mm: the real tip at ``u_segment``, work frame.
    """

    line: Floats
    u_line: Floats
    segment: Floats
    u_segment: Floats
    bound: Floats
    axis: Floats
    place: Floats
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, None, line="f", u_line="f", segment="f", u_segment="f", bound="f", axis="f", place="f3")
