# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was met in an NC text and is not interpreted: by name, with its first line and its count."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Ints
from freecad_fiveaxis.core.base.sentences import plural, say

from .codes import DRILL, PLANE, UNKNOWN, Kind
from .feed_groups import FeedGroups
from .plane_calls import Tilt
from .siemens_cycles import Drill


@dataclass
class Notes:
    """``met``: by kind and name, the offsets in the text where it stands; ``tilts``: the lines that begin or
    end a tilted plane, in their order; ``drills``: the calls of drilling cycles;
    ``feeds``: over which axes F is measured."""

    met: dict[tuple[Kind, str], list[int]] = field(default_factory=dict)
    tilts: list[Tilt] = field(default_factory=list)
    drills: list[Drill] = field(default_factory=list)
    feeds: FeedGroups = field(default_factory=FeedGroups)

    def tilt(self, tilt: Tilt) -> bytes:
        """Return the private word for such a line."""
        self.tilts.append(tilt)
        return b"%c%d" % (ord(PLANE), len(self.tilts) - 1)

    def drill(self, drill: Drill) -> bytes:
        """Return the private word for a line that calls a cycle."""
        if self.drills[-1:] != [drill]:
            self.drills.append(drill)
        return b"%c%d" % (ord(DRILL), len(self.drills) - 1)

    def note(self, kind: Kind, name: str, at: int) -> None:
        """``name`` stands at offset ``at`` of the text, whose lines end in LF."""
        self.met.setdefault((kind, name[:40]), []).append(at)

    def findings(self, text: bytes, source: Ints | None = None) -> list[Finding]:
        """One finding for each kind; of what is not known, one for each name, the first :data:`MOST`.
        ``source``: the lines of the file that those of the text are, where it was written out."""
        ends = np.flatnonzero(np.frombuffer(text, np.uint8) == ord("\n")) if self.met else np.empty(0)
        of_kind: dict[Kind, dict[str, tuple[int, int]]] = {}
        for (kind, name), places in self.met.items():
            line = int(np.searchsorted(ends, min(places))) + 1
            line = line if source is None else int(source[line])
            of_kind.setdefault(kind, {})[name] = line, len(places)
        return [found for kind, named in of_kind.items() for found in kind_findings(kind, named)]


def kind_findings(kind: Kind, named: Mapping[str, tuple[int, int]]) -> list[Finding]:
    """Return what is said of one kind: ``named`` the first line and the count of each name."""
    code, explanation = kind
    apart = code == UNKNOWN[0] or len(named) == 1
    found = []
    if not apart:
        first, count = min(line for line, _ in named.values()), sum(count for _, count in named.values())
        shown = ", ".join(f"{name} ({line})" for name, (line, _) in [*named.items()][:MOST])
        more = " ..." if len(named) > MOST else ""
        text = say(
            "{names} (with their first lines) stand in {count} lines: {explanation}.",
            names=shown + more,
            count=count,
            explanation=explanation,
        )
        return [report_finding(code, text, float(count), line=first)]
    for name, (line, count) in [*named.items()][:MOST]:
        text = plural(
            count,
            "{name} stands in NC line {line}: {explanation}.",
            "{name} stands in {count} lines: {explanation}.",
            name=name,
            line=line,
            explanation=explanation,
        )
        found.append(report_finding(code, text, float(count), line=line))
    return found


MOST = 20
