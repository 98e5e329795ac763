# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frozen dataclasses of arrays: one row a point, checked for shape and set read-only when made.

A long ``(n, 3)`` array is best kept in Fortran order (``np.empty((3, n)).T``): its columns are then contiguous, and
elementwise work on ``p[:, 0]`` runs at memory speed. Nothing depends on the order but speed.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .portions import on_all, portions

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]
Bytes = NDArray[np.int8]

_KINDS: dict[str, Any] = {"f": np.float64, "i": np.int64, "b": np.bool_, "m": np.int8}


def freeze(record: object, rows: int | None, **columns: str) -> None:
    """Check and lock the columns of a frozen dataclass, from its ``__post_init__``.

    Each keyword is a field and its form: a kind (f float64, i int64, b bool, m int8) and the width of a row, as in
    ``point="f3"``, ``pass_="i"``. ``rows`` is the number of rows that all must have (None: that of the first).
    Raises ValueError with the field's name, its shape and the shape that is needed.
    """
    for name, form in columns.items():
        given = getattr(record, name)
        array = np.asarray(given, dtype=_KINDS[form[0]])
        rows = array.shape[0] if rows is None and array.ndim else rows
        need = (rows, int(form[1:])) if form[1:] else (rows,)
        if array.shape != need:
            raise ValueError(f"{type(record).__name__}.{name} has shape {array.shape}, needs {need}")
        if array.flags.writeable:
            array = array.view()
            array.flags.writeable = False
        object.__setattr__(record, name, array)


def picked(table: Floats, rows: Ints) -> Floats:
    """Rows (k,) of a long ``table`` (n, w), in Fortran order: column by column, at memory speed."""
    columns, made = np.ascontiguousarray(table.T), np.empty((table.shape[1], len(rows)), table.dtype)

    def fill(part: slice) -> None:
        made[:, part] = columns.take(rows[part], axis=1)

    on_all(fill, portions(len(rows)))
    return made.T


SHORTEST = 64
"""Rows between two cuts, on the average, for which it pays to copy them as a whole."""


class Insertion:
    """Rows put in before the rows ``at`` (m,), ascending, of tables of ``count`` rows, at least one; ``count`` is their end."""

    def __init__(self, count: int, at: Ints) -> None:
        self.count, self.place = count, at + np.arange(len(at))
        self.source = np.minimum(at, count - 1)  # the row that each of those put in stands for
        cut = np.unique(at)
        self._cuts = cut if SHORTEST * len(cut) < count else None
        self._shift = np.searchsorted(at, cut, side="right")

    def woven(self, own: NDArray[Any], rows: NDArray[Any] | int) -> Any:
        """The table ``own`` (count, ...) with ``rows`` (m, ...) put in, in Fortran order."""
        columns = np.empty((*own.T.shape[:-1], self.count + len(self.place)), own.dtype)
        if self._cuts is None:
            stays = np.ones(columns.shape[-1], np.bool_)
            stays[self.place] = False
            columns[..., stays] = own.T
        else:
            self._copy_stretches(own.T, columns, self._cuts)
        columns[..., self.place] = rows if isinstance(rows, int) else rows.T
        return columns.T

    def _copy_stretches(self, own: NDArray[Any], columns: NDArray[Any], cuts: Ints) -> None:
        """Whole stretches between the cuts at a time: at the speed of the memory, where picking row by row is half as fast."""
        begins, ends = [0, *cuts.tolist()], [*cuts.tolist(), self.count]
        for begin, end, shift in zip(begins, ends, [0, *self._shift.tolist()], strict=True):
            columns[..., begin + shift : end + shift] = own[..., begin:end]
