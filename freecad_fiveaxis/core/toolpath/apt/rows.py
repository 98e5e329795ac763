# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of the path made of the moves of a CL file: one each, and those that arcs and holes put in before
them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bytes, Floats, Insertion, Ints
from freecad_fiveaxis.core.toolpath.cl_path import Motion


@dataclass(frozen=True, eq=False)
class Rows:
    """``tip`` (n, 3) mm, ``axis`` (n, 3) unit, ``motion`` (n,) of Motion, ``speed`` (n,) mm/min, 0 for
    rapids."""

    tip: Floats
    axis: Floats
    motion: Bytes
    speed: Floats

    def with_put(self, put: Put) -> Rows:
        """Return these rows with others put in."""
        if not len(put.at):
            return self
        order = np.argsort(put.at, kind="stable")
        places = Insertion(len(self.tip), put.at[order])
        columns = ("tip", "axis", "motion", "speed")
        return Rows(*(places.interleave(getattr(self, name), getattr(put, name)[order]) for name in columns))


@dataclass(frozen=True, eq=False)
class Put:
    """Rows to be put in before the rows ``at`` (m,), in their order where several are; the columns as in
    Rows."""

    at: Ints
    tip: Floats
    axis: Floats
    motion: Bytes
    speed: Floats

    @staticmethod
    def none() -> Put:
        """No rows."""
        return Put.rapids(np.zeros(0, np.int64), np.zeros((0, 3)), np.zeros((0, 3)))

    @staticmethod
    def rapids(at: Ints, tip: Floats, axis: Floats) -> Put:
        """Rapids."""
        return Put(at, tip, axis, np.full(len(at), Motion.RAPID, np.int8), np.zeros(len(at)))

    @staticmethod
    def join(parts: Iterable[Put]) -> Put:
        """All of them; of those before one row, the rows of the first part come first."""
        every = list(parts)
        return Put(
            *(
                np.concatenate([getattr(one, name) for one in every])
                for name in ("at", "tip", "axis", "motion", "speed")
            )
        )
