# SPDX-License-Identifier: LGPL-2.1-or-later
"""From rows in short form to the columns of an offset path."""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.vectors import dot
from freecad_fiveaxis.core.passes import ContactPath

from .junction import CHUNK, Rows, Segments, direction, pick_plain_rows
from .rows import NO_ROWS, Closed


class Columns:
    """The columns of an offset path while they are filled in, part by part; ``values`` has them by name."""

    def __init__(self, contact: ContactPath, segments: Segments, parts: list[Closed]) -> None:
        self.contact, self.segments, self.parts = contact, segments, parts
        size = [len(part.rows.base) for part in parts]
        self.start = np.cumsum([0, *size]).tolist()
        n = self.start[-1]
        self.vectors = {name: np.empty((3, n)) for name in ("point", "centre", "normal", "before", "after")}
        self.lengths = {name: np.empty(n) for name in ("step_before", "step_after")}
        self.labels = {
            name: np.empty(n, np.int64) for name in ("face", "coedge", "segment", "polyline", "pass_")
        }
        self.fill = np.empty(n, bool)
        self.lines = np.cumsum(
            [0, *(0 if part.begins is None else np.count_nonzero(part.begins) for part in parts)]
        ).tolist()

    @property
    def values(self) -> dict[str, Any]:
        """All columns by name."""
        return (
            {name: vector.T for name, vector in self.vectors.items()}
            | self.lengths
            | self.labels
            | {"fill": self.fill}
        )

    @property
    def breaks(self) -> Ints:
        """The rows at which a polyline is broken and begins anew."""
        breaks = [part.breaks + start for part, start in zip(self.parts, self.start, strict=False)]
        return np.concatenate([NO_ROWS, *breaks])

    @property
    def walls(self) -> dict[str, Any]:
        """The rows at which the ball also touches a facet that is not cut, and its normal."""
        beside = [part.beside + start for part, start in zip(self.parts, self.start, strict=False)]
        wall = [self.segments.normal.take(2 * part.wall, axis=1) for part in self.parts]
        return {
            "beside": np.concatenate([NO_ROWS, *beside]),
            "wall": np.concatenate([np.empty((3, 0)), *wall], axis=1).T,
        }

    def write(self, number: int) -> None:
        """Work out part ``number`` and put it in its place."""
        rows, start = self.parts[number].rows, self.start[number]
        for low in range(0, len(rows.base), CHUNK):
            part = slice(low, min(low + CHUNK, len(rows.base)))
            self._write(slice(start + part.start, start + part.stop), pick_plain_rows(rows, part))
        where = slice(start, start + len(rows.base))
        self._lift(where, rows)
        self._number_polylines(where, number)

    def _write(self, where: slice, rows: Rows) -> None:
        segments, contact, labels = self.segments, self.contact, self.labels
        point = _gather_columns(segments.point, rows.base, self.vectors["point"][:, where])
        normal = _gather_columns(segments.normal, rows.base, self.vectors["normal"][:, where])
        normal *= rows.w1
        normal += rows.w2 * segments.normal.take(2 * rows.far, axis=1)
        self._add_travel(point, rows, rows.shift)
        self._add_travel(normal, rows, rows.w3)
        centre = np.multiply(rows.reach, normal, out=self.vectors["centre"][:, where])
        centre += point
        for name, side in (("before", rows.left), ("after", rows.right)):
            _gather_columns(segments.normal, 2 * side, self.vectors[name][:, where])
            segments.length.take(side, out=self.lengths[f"step_{name}"][where], mode="clip")
        for name in ("face", "coedge", "pass_"):
            getattr(contact, name).take(rows.base, out=labels[name][where], mode="clip")
        labels["coedge"][where][rows.shift != 0.0] = -1  # a trimmed contact lies inside its facet
        np.right_shift(rows.base, 1, out=labels["segment"][where])
        self.fill[where] = rows.fill

    def _add_travel(self, vector: Floats, rows: Rows, by: Floats) -> None:
        """``vector`` (3, k) + ``by`` (k,) x the direction of the row's segment, in place."""
        along = np.flatnonzero(by)
        travel = direction(self.segments, rows.base.take(along) >> 1)
        travel *= by.take(along)
        for column, part in zip(vector, travel, strict=True):
            column[along] += part

    def _lift(self, where: slice, rows: Rows) -> None:
        """Put the lifted rows where they belong."""
        if len(rows.lifted):
            point, centre, normal = (self.vectors[name][:, where] for name in ("point", "centre", "normal"))
            centre[:, rows.lifted] = rows.centre
            lift = rows.centre - point[:, rows.lifted]
            normal[:, rows.lifted] = lift / np.sqrt(dot(lift, lift))

    def _number_polylines(self, where: slice, number: int) -> None:
        """As in the contact path; counted anew where rows are left out, because a polyline ends there."""
        begins, polyline = self.parts[number].begins, self.labels["polyline"][where]
        if begins is None:
            self.contact.polyline.take(self.parts[number].rows.base, out=polyline, mode="clip")
        else:
            np.cumsum(begins, out=polyline)
            polyline += self.lines[number] - 1
            self.fill[where] &= ~begins


def _gather_columns(table: Floats, index: Ints, out: Floats) -> Floats:
    """Columns ``index`` (k,) of ``table`` (3, n) into ``out`` (3, k), row by row: numpy copies an ``out``
    with gaps twice."""
    for row, target in zip(table, out, strict=True):
        row.take(index, out=target, mode="clip")
    return out
