# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many ways between cuts lead below the part in the finished path: links near the part take the place of
most of those over it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import plural
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion


def count_below_part(
    findings: tuple[Finding, ...], path: CLPath, mesh: Mesh, above: float, radius: float
) -> tuple[Finding, ...]:
    """Return the findings, retracts and approaches below the part as there are in the finished ``path``;
    none where there is none. ``above`` mm: from the driven point to the hub, whose end of the tool is
    ``radius`` mm wide about it."""
    if not any(one.code == Code.RETRACT_BELOW_PART for one in findings):
        return findings
    first = _first_rows(_below(path, *mesh.box, above, radius))
    return tuple(
        _recount(one, path, first) if one.code == Code.RETRACT_BELOW_PART else one
        for one in findings
        if len(first) or one.code != Code.RETRACT_BELOW_PART
    )


def _below(path: CLPath, low: Floats, high: Floats, above: float, radius: float) -> Bools:
    """Which rows (n,) a link or a rapid leads to with all of the tool's end below the part's box ``low``,
    ``high`` (3,) mm, and not beside it."""
    hub = path.tip + above * path.axis
    beside = ((hub < low - radius) | (hub > high + radius))[:, :2].any(axis=1)
    between = np.isin(path.motion, (Motion.LINK, Motion.RAPID))
    return np.asarray(between & ~beside & (hub[:, 2] < low[2] - radius))


def _first_rows(below: Bools) -> Ints:
    """Return the first row (k,) of each stretch."""
    return np.flatnonzero(below & ~np.append(False, below[:-1]))


def _recount(one: Finding, path: CLPath, first: Ints) -> Finding:
    text = plural(
        len(first),
        "The tool passes below the part once between two cuts, because it looks down there. Check that "
        "nothing holds the part from below, or choose a tool axis that looks up.",
        "{count} times the tool passes below the part between two cuts, because it looks down there. Check "
        "that nothing holds the part from below, or choose a tool axis that looks up.",
    )
    x, y, z = path.tip[first[0]].tolist()
    return replace(one, text=text, value=float(len(first)), place=(x, y, z))
