# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is poor about a mesh, with its places."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import Point, Template

from .words import Words

FLAT_FACETS = Template(
    "{count} facets without area were left out, the first at {at}; passes end where that leaves a crack."
)
INWARD_FACETS = Template(
    "All {count} facets looked inward and were turned outward; check the export if only some of them should."
)
INWARD_LUMPS = Template(
    "{count} facets, the first at {at}, make solids that looked inward beside others and were turned "
    "outward. Check the export if one of them should be a cavity."
)
TURNED_FACETS = Template(
    "{count} facets, the first at {at}, faced the other way than their neighbours and were turned round."
)
JOIN_FINDINGS = (
    (
        Code.DOUBLED_FACETS,
        Template("{count} facets were there twice, the first at {at}; one of each was kept."),
    ),
    (
        Code.CORNERS_JOINED,
        Template("{count} corners next to others, the first at {at}, were joined with them."),
    ),
    (
        Code.T_JUNCTIONS_JOINED,
        Template(
            "{count} corners lie on a side of another facet, the first at {at}; that facet was divided there."
        ),
    ),
)
CHANGES = (Code.DEGENERATE_FACETS, *(code for code, _ in JOIN_FINDINGS))
"""Of what was done to the mesh, however it is made anew afterwards."""
TORN = Template(
    "{edges} edges have one facet only, the first at {at}: the facets hang together nearly nowhere, and "
    "passes end at each of them. Export the mesh again with common corners, or repair it (in FreeCAD: "
    "Evaluate and repair mesh, Duplicated points)."
)
"""In place of the first of ``EDGE_FINDINGS`` where there are more than two such edges a facet."""
FEW_FACETS = 10
"""A mesh of fewer facets may be meant to be open all round."""
EDGE_FINDINGS = (
    (
        Code.OPEN_SHELL,
        Template(
            "{edges} edges leave the mesh open, the first at {at}; passes end there. Close the shell in CAD "
            "if it is meant to be solid."
        ),
    ),
    (
        Code.INCONSISTENT_WINDING,
        Template(
            "{edges} edges have two facets that run along them in the same sense, the first at {at}; passes "
            "end there. Unify the facet normals."
        ),
    ),
    (
        Code.NON_MANIFOLD_EDGES,
        Template(
            "{edges} edges have more than two facets, the first at {at}; passes end there. Separate or "
            "unite the bodies that meet there."
        ),
    ),
)


def report_at(code: Code, template: Template, vertex: Floats, row: Ints, **count: int) -> Finding:
    """Return the finding of one ``count`` of facets, corners or edges, at the middle of the first one's
    vertices ``row`` (k,)."""
    x, y, z = vertex[row].mean(axis=0).tolist()
    (number,) = count.values()
    text = template.say(**count, at=Point((x, y, z), "g"))
    return report_finding(code, text, float(number), 0.0, place=(x, y, z))


def report_edges(key: Words, half: Ints, low: int, vertex: Floats, face: Ints) -> tuple[list[Finding], bool]:
    """Return findings on the half-edges without a partner, and whether the mesh is closed all the same.

    It is closed when every edge is run along as often in one sense as in the other.
    """
    _, group, count = np.unique(key >> np.uint64(1), return_inverse=True, return_counts=True)
    group = group.reshape(-1)
    forward = np.bincount(group, weights=(key & np.uint64(1)) == 0)
    kind = np.minimum(count, 3)[group]
    facet = half & ((1 << low) - 1)
    findings = []
    for number, (code, template) in enumerate(EDGE_FINDINGS, start=1):
        at = np.flatnonzero(kind == number)
        if len(at):
            worst = at[np.argmin(facet[at])]
            corner = half[worst] >> low
            ends = face[facet[worst], [corner, (corner + 1) % 3]]
            edges = int(np.count_nonzero(np.minimum(count, 3) == number))
            if code is Code.OPEN_SHELL and edges > 2 * len(face) >= 2 * FEW_FACETS:
                template = TORN
            findings.append(report_at(code, template, vertex, ends, edges=edges))
    return findings, bool((2 * forward == count).all())
