# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes that are cut with locked rotary axes: where the tool is free with the axis of its frame, and the
order of the frames."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Number, Point, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.orientation.strategies import AxisOptions
from freecad_fiveaxis.core.passes.frames import Frames
from freecad_fiveaxis.core.toolpath.coedge import ROW_COLUMNS, OffsetPath, take_path_rows

from .auto_axis import FEW, Free
from .axis_field import with_way_out
from .contacts import Contacts, find_contacts
from .order_with_axes import order_with_axes


def stands_in(frames: Frames) -> list[tuple[str, AxisOptions]]:
    """Give the tool-axis strategy of each frame with its options."""
    return [("fixed", AxisOptions(fixed=(x, y, z))) for x, y, z in frames.axis.tolist()]


def free_in_frames(
    path: OffsetPath, frames: Frames, frame: Ints, mesh: Mesh, reacher: Reacher, progress: Progress = silent
) -> tuple[Ints, tuple[Finding, ...]]:
    """Find what is free (n,) of :class:`Free` at every row of ``path`` with the axis of the ``frame`` (k,) of
    its pass, and say where nothing is though the place is one of that frame."""
    tree, contacts = facet_tree(mesh), find_contacts(path, mesh, reacher)
    own = frame[path.pass_[contacts.first]]
    axis, free = frames.axis[own], np.zeros(len(own), np.int64)
    for tool, gained in ((with_way_out(reacher, tree), Free.WAY_OUT), (reacher, Free.STANDING)):
        free[contacts.free(axis, free == Free.NONE, tool, tree, progress)] = gained
    held = contacts.all_fit & (free == Free.NONE)
    rows = np.flatnonzero(held)
    held[rows] = frames.at(contacts.point[rows], contacts.mean[rows]) == own[rows]
    return free[contacts.contact], _report_held(held, contacts)


def by_frame(path: OffsetPath, frames: Frames, frame: Ints, to_and_fro: bool) -> tuple[OffsetPath, Floats]:
    """Give the polylines of ``path`` frame by frame and the axes (n, 3) of their rows; ``to_and_fro``: those
    of a frame in an order that spares way, where there is one."""
    own = frame[path.pass_]
    pieces = [take_path_rows(path, np.flatnonzero(own == number)) for number in np.unique(own)]
    axes = [
        np.repeat(frames.axis[number][None], len(one.point), axis=0)
        for number, one in zip(np.unique(own), pieces, strict=True)
    ]
    if to_and_fro:
        pieces = [order_with_axes(one, axis)[0] for one, axis in zip(pieces, axes, strict=True)]
    return _one_after_the_other(path, pieces), np.concatenate(axes)


def _one_after_the_other(path: OffsetPath, pieces: list[OffsetPath]) -> OffsetPath:
    """Paths as one, their polylines counted on."""
    columns = {name: np.concatenate([getattr(one, name) for one in pieces]) for name in ROW_COLUMNS}
    counts = [one.polyline.max(initial=-1) + 1 for one in pieces]
    before = np.repeat(np.cumsum([0, *counts[:-1]]), [len(one.point) for one in pieces])
    return OffsetPath(**columns | {"polyline": columns["polyline"] + before}, findings=path.findings)


def _report_held(held: Bools, contacts: Contacts) -> tuple[Finding, ...]:
    """At how many contacts at which the ball fits the tool is not free in the frame that was to cut them."""
    count = int(np.count_nonzero(held))
    if not count:
        return ()
    x, y, z = contacts.point[int(held.argmax())].tolist()
    text = say(
        "At {count} of {all} contacts ({share} %), the first at {place}, the tool is not free with the axis "
        "of their frame; they "
        "are left out. Use a smaller cutter or holder, a longer tool, or other passes for the rest.",
        count=count, all=len(held), share=Number(100.0 * count / len(held), ".3g"), place=Point((x, y, z)),
    )  # fmt: skip
    severity = Severity.NOTE if count <= FEW * len(held) else Severity.WARNING
    return (report_finding(Code.NO_FREE_AXIS, text, float(count), 0.0, place=(x, y, z), severity=severity),)
