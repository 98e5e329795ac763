# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was met in an NC text and is not interpreted: by name, with its first line and its count."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.sentences import say

from .codes import DRILL, PLANE, Kind
from .plane_calls import Tilt
from .siemens_cycles import Drill


@dataclass
class Notes:
    """``met``: by kind and name, the offsets in the text where it stands; ``tilts``: the lines that begin or end a tilted plane,
    in their order; ``drills``: the calls of drilling cycles."""

    met: dict[tuple[Kind, str], list[int]] = field(default_factory=dict)
    tilts: list[Tilt] = field(default_factory=list)
    drills: list[Drill] = field(default_factory=list)

    def tilt(self, tilt: Tilt) -> bytes:
        """The private word for such a line."""
        self.tilts.append(tilt)
        return b"%c%d" % (ord(PLANE), len(self.tilts) - 1)

    def drill(self, drill: Drill) -> bytes:
        """The private word for a line that calls a cycle."""
        if self.drills[-1:] != [drill]:
            self.drills.append(drill)
        return b"%c%d" % (ord(DRILL), len(self.drills) - 1)

    def note(self, kind: Kind, name: str, at: int) -> None:
        """``name`` stands at offset ``at`` of the text, whose lines end in LF."""
        self.met.setdefault((kind, name[:40]), []).append(at)

    def findings(self, text: bytes) -> list[Finding]:
        """One finding for each kind and name; the first :data:`MOST` names of each kind."""
        ends = np.flatnonzero(np.frombuffer(text, np.uint8) == ord("\n")) if self.met else np.empty(0)
        found, told = [], dict[Kind, int]()
        for (kind, name), places in self.met.items():
            told[kind] = told.get(kind, 0) + 1
            if told[kind] <= MOST:
                severity, code, said = kind
                line = int(np.searchsorted(ends, min(places))) + 1
                found.append(
                    Finding(
                        severity,
                        code,
                        say("{name} stands in {count} lines: {said}.", name=name, count=len(places), said=said),
                        float(len(places)),
                        line=line,
                    )
                )
        return found


MOST = 20
