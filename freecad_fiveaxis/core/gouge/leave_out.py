# SPDX-License-Identifier: LGPL-2.1-or-later
"""The other cure: leave out what cannot be cut, or left, without entering the part, before the passes are
linked."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, take_rows
from freecad_fiveaxis.core.base.sentences import Choice, Length, Point, Sentence, say
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.known_depths import Entries
from freecad_fiveaxis.core.gouge.search import find_entries
from freecad_fiveaxis.core.gouge.swept_motion import straight_motion
from freecad_fiveaxis.core.tool.body import Body
from freecad_fiveaxis.core.toolpath.cl_offset import rows_between
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath, lasting_rows, take_path_rows

from .overhang import groups_of, is_under, under_with

FINE = 0.25
"""Of the tool's thickness: a block that enters is left out in parts of that length."""


def leave_out(
    path: OffsetPath, axis: Floats, tree: FacetTree, body: Body, tolerance: float, back: float,
    progress: Progress = silent,
    above: float = 0.0,
) -> tuple[OffsetPath, Floats]:  # fmt: skip
    """Return the rows between which body and part stay apart but for ``tolerance`` mm, and from whose ends
    the body can rise, and their axes (n, 3); findings say what is left out.

    ``path``: with the cutter's hubs for its centres (:func:`~.cl_offset.cl_offset_path`), ``back`` mm above
    the tip; ``above`` mm: how far over it the point lies that goes straight. Shank and holder count as the
    cutter does. Raises SettingsError where nothing is left.
    """
    without = _Without(tree, body, tolerance, back, progress, above)
    return without.drop_trapped(*without.entering(path, axis))


def keep_away(
    path: OffsetPath, axis: Floats, tree: FacetTree, grown: Body, tolerance: float, back: float,
    allowance: float,
    progress: Progress = silent, above: float = 0.0,
) -> tuple[OffsetPath, Floats]:  # fmt: skip
    """Return the rows between which a body, ``grown`` by an ``allowance`` mm, keeps out of faces to avoid,
    and out of which it can rise so, and their axes (n, 3); the rest as for :func:`leave_out`."""
    without = _Without(tree, grown, tolerance, back, progress, above, allowance)
    return without.drop_trapped(*without.entering(path, axis))


@dataclass(frozen=True, eq=False)
class _Without:
    """What leaves rows out; fields as the arguments of :func:`leave_out`. ``allowance`` mm on faces to avoid,
    None: it is not these that are looked at."""

    tree: FacetTree
    body: Body
    tolerance: float
    back: float
    progress: Progress
    above: float
    allowance: float | None = None

    def entering(self, path: OffsetPath, axis: Floats) -> tuple[OffsetPath, Floats]:
        """Return the path without the rows between which the body enters, and its axes."""
        entries = self._entries(path, axis, _find_joined_blocks(path))
        if not entries.depth.any():
            return path, axis
        path, axis, deep = _divide_blocks(path, axis, entries.depth > 0.0, self._fine())
        entries = self._entries(path, axis, deep)
        blocks = np.flatnonzero(entries.depth > 0.0)
        out = np.zeros(len(path.point), np.bool_)
        out[blocks] = out[blocks + 1] = True
        worst = int(entries.depth.argmax())
        x, y, z = entries.place[worst].tolist()
        depth = float(entries.depth[worst])

        def why(where: Sentence) -> Sentence:
            if self.allowance is not None:
                return say(
                    "the tool would come nearer to the faces to avoid {where} than {allowance}, as at "
                    "{place}",
                    where=where, allowance=Length(self.allowance), place=Point((x, y, z)),
                )  # fmt: skip
            return say(
                "the tool would enter the part {where}, deepest by {depth} at {place}",
                where=where,
                depth=Length(depth, ".4g"),
                place=Point((x, y, z)),
            )

        remedy = say("Use a smaller cutter or another tool axis there.")
        return _drop_rows(path, axis, out, why, depth, (x, y, z), remedy, self.allowance is None)

    def drop_trapped(self, path: OffsetPath, axis: Floats) -> tuple[OffsetPath, Floats]:
        """Return the path without the rows under an overhang up to the ends of polylines: a retract there
        would go through the part."""
        ends = self._find_trapped_ends(path, axis)
        if not len(ends):
            return path, axis
        x, y, z = path.point[ends[0]].tolist()
        joined = np.diff(path.polyline) == 0
        runs = groups_of(np.ones(len(axis), np.bool_), joined, ends)
        path, axis, _ = _divide_blocks(path, axis, joined & runs[1:], self._fine())
        ends, joined = self._find_trapped_ends(path, axis), np.diff(path.polyline) == 0
        out = under_with(
            self.body, self.tree, self._tips(path, axis), axis, joined, ends, self.tolerance, self.progress
        )

        def why(where: Sentence) -> Sentence:
            if self.allowance is not None:
                return say(
                    "on its way out along its axis the tool would come nearer to the faces to avoid {where} "
                    "than {allowance}, as at {place}",
                    where=where, allowance=Length(self.allowance), place=Point((x, y, z)),
                )  # fmt: skip
            return say(
                "the tool could not get out along its axis {where}, for the part is over it, as at {place}",
                where=where,
                place=Point((x, y, z)),
            )

        remedy = say("Turn the part, or use another tool axis there.")
        return _drop_rows(path, axis, out, why, None, (x, y, z), remedy, self.allowance is None)

    def _entries(self, path: OffsetPath, axis: Floats, blocks: Ints) -> Entries:
        swept = straight_motion(self._tips(path, axis), axis, self.above)
        return find_entries(
            self.body, self.tree, swept, self.tolerance, blocks=blocks, progress=self.progress
        )

    def _find_trapped_ends(self, path: OffsetPath, axis: Floats) -> Ints:
        first = np.diff(path.polyline, prepend=-1) != 0
        ends = np.flatnonzero(first | np.append(first[1:], True))
        tip = self._tips(path, axis)[ends]
        return ends[is_under(self.body, self.tree, tip, axis[ends], self.tolerance, self.progress)]

    def _tips(self, path: OffsetPath, axis: Floats) -> Floats:
        return path.centre - self.back * axis

    def _fine(self) -> float:
        return FINE * max(piece.most for piece in self.body.pieces)


def _find_joined_blocks(path: OffsetPath) -> Ints:
    """Return the blocks (k,) between rows of one polyline."""
    return np.flatnonzero(np.diff(path.polyline) == 0)


def _drop_rows(
    path: OffsetPath,
    axis: Floats,
    out: Bools,
    why: Callable[[Sentence], Sentence],
    value: float | None,
    place: tuple[float, float, float],
    remedy: str,
    part: bool,
) -> tuple[OffsetPath, Floats]:
    """Return the path without the rows ``out`` (n,), and its axes; ``why``: the reason, given on which of its
    passes; ``remedy``: what helps; ``part``: whether it is for the part, not for faces to avoid."""
    steps, joined = np.linalg.norm(np.diff(path.point, axis=0), axis=1), _find_joined_blocks(path)
    length = float(steps[joined[(out[1:] | out[:-1])[joined]]].sum())
    rows = lasting_rows(path, np.flatnonzero(~out))
    if not len(rows) and not part:
        text = say(
            "nothing is left to cut: {why}; use a smaller allowance or tool", why=why(say("on every pass"))
        )
        raise SettingsError(text, value)
    if not len(rows):
        text = say(
            "{leave_out} leaves nothing to cut: {why}; use a smaller cutter or holder, a longer tool or "
            "another tool axis, or see where with {report}",
            leave_out=Choice("gouge", ("leave-out",)),
            report=Choice("gouge", ("report",)),
            why=why(say("on every pass")),
        )
        raise SettingsError(text, value)
    left = take_path_rows(path, rows)
    text = say(
        "{length} of the passes are left out, because {why}. {remedy}",
        length=Length(length, ".4g"),
        why=why(say("there")),
        remedy=remedy,
    )
    finding = report_finding(Code.LEFT_OUT, text, length, 0.0, place=place)
    return replace(left, findings=(*path.findings, finding)), take_rows(axis, rows)


def _divide_blocks(
    path: OffsetPath, axis: Floats, deep: Bools, part: float
) -> tuple[OffsetPath, Floats, Ints]:
    """Return the path with the blocks ``deep`` (n - 1,) in parts of at most ``part`` mm, its axes, and those
    parts."""
    length = np.linalg.norm(np.diff(path.centre, axis=0), axis=1)
    pieces = np.ones(len(axis), np.int64)
    pieces[1:][deep] = np.maximum(np.ceil(length[deep] / part), 1)
    path, axis, row = rows_between(path, axis, pieces, 0.0)
    return path, axis, np.flatnonzero(deep[row[1:] - 1])
