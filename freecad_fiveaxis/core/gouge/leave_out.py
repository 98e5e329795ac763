# SPDX-License-Identifier: LGPL-2.1-or-later
"""The other cure: leave out what cannot be cut without entering the part, before the passes are linked."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.coedge import OffsetPath, lasting_rows, take_rows
from freecad_fiveaxis.core.errors import SettingsError
from freecad_fiveaxis.core.findings import Finding, Severity
from freecad_fiveaxis.core.progress import Progress, silent
from freecad_fiveaxis.core.records import Bools, Floats, Ints, picked
from freecad_fiveaxis.core.seating import rows_between

from .body import Body
from .course import straight_course
from .facet_tree import FacetTree
from .search import find_entries

FINE = 0.25
"""Of the tool's thickness: a block that enters is left out in parts of that length."""


def leave_out(
    path: OffsetPath, axis: Floats, tree: FacetTree, body: Body, tolerance: float, back: float, progress: Progress = silent
) -> tuple[OffsetPath, Floats]:
    """The rows between which body and part stay apart but for ``tolerance`` mm, and their axes (n, 3); findings say what is
    left out.

    ``path``: with the cutter's hubs for its centres (:func:`~.seating.seated`), ``back`` mm above the tip. Shank and holder count
    as the cutter does. Raises SettingsError where nothing is left.
    """
    joined = np.flatnonzero(np.diff(path.polyline) == 0)
    course = straight_course(path.centre - back * axis, axis)
    entries = find_entries(body, tree, course, tolerance, blocks=joined, progress=progress)
    if not entries.depth.any():
        return path, axis
    path, axis, deep = _divided(path, axis, entries.depth > 0.0, FINE * max(piece.most for piece in body.pieces))
    course, joined = straight_course(path.centre - back * axis, axis), np.flatnonzero(np.diff(path.polyline) == 0)
    entries = find_entries(body, tree, course, tolerance, blocks=deep, progress=progress)
    blocks = np.flatnonzero(entries.depth > 0.0)
    out = np.zeros(len(path.point), np.bool_)
    out[blocks] = out[blocks + 1] = True
    steps = np.linalg.norm(np.diff(path.point, axis=0), axis=1)
    length = float(steps[joined[(out[1:] | out[:-1])[joined]]].sum())
    worst = int(entries.depth.argmax())
    x, y, z = entries.place[worst].tolist()
    text = (
        f"{length:.4g} mm of the passes are left out, because the tool would enter the part there, deepest by "
        f"{entries.depth[worst]:.4g} mm at ({x:.6g}, {y:.6g}, {z:.6g}) mm. Use a smaller cutter or another tool axis there."
    )
    rows = lasting_rows(path, np.flatnonzero(~out))
    if not len(rows):
        text = (
            f"gouge leave-out leaves nothing to cut: the tool would enter the part on every pass, deepest by "
            f"{entries.depth[worst]:.4g} mm at ({x:.6g}, {y:.6g}, {z:.6g}) mm; use a smaller cutter or holder, a longer tool or "
            "another tool axis, or see where with gouge report"
        )
        raise SettingsError(text, float(entries.depth[worst]))
    left = take_rows(path, rows)
    finding = Finding(Severity.WARNING, "left-out", text, length, 0.0, "mm", place=(x, y, z))
    return replace(left, findings=(*path.findings, finding)), picked(axis, rows)


def _divided(path: OffsetPath, axis: Floats, deep: Bools, part: float) -> tuple[OffsetPath, Floats, Ints]:
    """The path with the blocks ``deep`` (n - 1,) in parts of at most ``part`` mm, its axes, and those parts."""
    length = np.linalg.norm(np.diff(path.centre, axis=0), axis=1)
    pieces = np.ones(len(axis), np.int64)
    pieces[1:][deep] = np.maximum(np.ceil(length[deep] / part), 1)
    path, axis, row = rows_between(path, axis, pieces, 0.0)
    return path, axis, np.flatnonzero(deep[row[1:] - 1])
