# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frozen dataclasses of arrays: one row a point, checked for shape and set read-only when made.

A long ``(n, 3)`` array is best kept in Fortran order (``np.empty((3, n)).T``): its columns are then
contiguous, and elementwise work on ``p[:, 0]`` runs at memory speed. Nothing depends on the order but speed.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .chunks import chunks, in_threads

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]
Bytes = NDArray[np.int8]

_KINDS: dict[str, Any] = {"f": np.float64, "i": np.int64, "b": np.bool_, "m": np.int8}


def freeze(record: object, rows: int | None, **columns: str) -> None:
    """Check and lock the columns of a frozen dataclass, from its ``__post_init__``.

    Each keyword is a field and its form: a kind (f float64, i int64, b bool, m int8) and the width of a row,
    as in ``point="f3"``, ``pass_="i"``. ``rows`` is the number of rows that all must have (None: that of the
    first). Raises ValueError with the field's name, its shape and the shape that is needed.
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


def take_rows(table: Floats, rows: Ints) -> Floats:
    """Rows (k,) of a long ``table`` (n, w), in Fortran order: column by column, at memory speed."""
    columns, taken = np.ascontiguousarray(table.T), np.empty((table.shape[1], len(rows)), table.dtype)

    def fill(part: slice) -> None:
        taken[:, part] = columns.take(rows[part], axis=1)

    in_threads(fill, chunks(len(rows)))
    return taken.T


def run_ids(count: Ints) -> Ints:
    """Of the runs of ``count`` (k,) rows, at least 1 each, the one of each row: ``np.repeat(np.arange(k),
    count)``, which would keep a second thread waiting."""
    begins = np.zeros(int(count.sum()), np.int64)
    begins[np.cumsum(count[:-1])] = 1
    return np.cumsum(begins, out=begins)


def number_runs(count: Ints) -> tuple[Ints, Ints]:
    """Return of runs of ``count`` (k,) rows the run (n,) of each row and its number (n,) in the run, from 0
    on."""
    run = run_ids(count) if np.all(count) else np.repeat(np.arange(len(count)), count)
    return run, np.arange(len(run)) - (np.cumsum(count) - count)[run]


SHORTEST = 64
"""Rows between two cuts for which it pays to copy them as a whole."""


class Insertion:
    """Rows put in before the rows ``at`` (m,), ascending, of tables of ``count`` rows, at least one;
    ``count`` is their end."""

    def __init__(self, count: int, at: Ints) -> None:
        self.count, self.place = count, at + np.arange(len(at))
        self.source = np.minimum(at, count - 1)  # the row that each of those put in stands for
        cut = np.unique(at)
        begin, end = np.append(0, cut), np.append(cut, count)
        shift = np.append(0, np.searchsorted(at, cut, side="right"))
        whole, size = end - begin >= SHORTEST, end - begin
        self._whole_runs = np.stack([begin, end, shift])[:, whole].T.tolist()
        rest = np.flatnonzero(~whole & (size > 0))
        owner = run_ids(size[rest])
        head = np.cumsum(size[rest]) - size[rest]
        self._rows = np.arange(len(owner)) + (begin[rest] - head).take(owner)
        self._moved = self._rows + shift[rest].take(owner)

    def interleave(self, own: NDArray[Any], rows: NDArray[Any] | int) -> Any:
        """Return the table ``own`` (count, ...) with ``rows`` (m, ...) put in, in Fortran order.

        Whole runs between the cuts go at a time: at the speed of the memory, where picking row by row is half
        as fast.
        """
        given = own.T
        columns = np.empty((*given.shape[:-1], self.count + len(self.place)), own.dtype)
        for begin, end, shift in self._whole_runs:
            columns[..., begin + shift : end + shift] = given[..., begin:end]
        columns[..., self._moved] = given[..., self._rows]
        columns[..., self.place] = rows if isinstance(rows, int) else rows.T
        return columns.T
