# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of the numbers that a mesh is made of: their shape, and the size of a part."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from freecad_fiveaxis.core.base.errors import MeshError
from freecad_fiveaxis.core.base.sentences import Length, say

from .weld import Reals

LARGEST = 1e6  # mm; no machine reaches a kilometre, so the units are wrong
# mm; a part that is smaller is a slip of the units too, and squares of its sides would be no numbers
LEAST = 1e-6


def read_numbers(given: ArrayLike, what: str, row: tuple[int, ...]) -> NDArray[Any]:
    """``given`` as an array of numbers with at least one row of shape ``row``, or MeshError."""
    try:
        array = np.asarray(given)
    except ValueError as problem:
        raise MeshError(
            say("the {what} form no regular table: {problem}", what=what, problem=problem), None
        ) from problem
    if array.size == 0:
        raise MeshError(
            say("the mesh has no facets: export a solid or a surface with at least one triangle"), 0
        )
    if array.dtype.kind not in "iuf" or array.shape[1:] != row:
        form = f"{array.dtype} of shape {array.shape}"
        wanted = f"(n, {', '.join(map(str, row))})"
        raise MeshError(
            say("the {what} are {form}: give numbers of shape {wanted}", what=what, form=form, wanted=wanted),
            form,
        )
    return array


def find_range(column: Reals, rows: int, what: str) -> tuple[Reals, Reals]:
    """Least and largest of each of the three columns, or MeshError where one holds a coordinate that no part
    can have, or all of them together a size that none has."""
    with np.errstate(invalid="ignore"):
        low, high = column.min(axis=1), column.max(axis=1)
        if np.maximum(-low, high).max() <= LARGEST:  # no NaN: it would come out of all three
            _check_size(float((high - low).max()))
            return low, high
        axis, entry = (int(i[0]) for i in np.nonzero(~(np.abs(column) <= LARGEST)))
    value = float(column[axis, entry])
    given = {"what": what, "number": entry % rows + 1, "rows": rows, "axis": "xyz"[axis]}
    if not np.isfinite(value):
        raise MeshError(
            say(
                "{what} {number} of {rows} has {axis} = {value}: coordinates must be finite numbers; export "
                "the mesh again",
                value=value,
                **given,
            ),
            value,
        )
    raise MeshError(
        say(
            "{what} {number} of {rows} has {axis} = {value}, and no part exceeds {most}: check the units of "
            "the export",
            value=Length(value),
            most=Length(LARGEST),
            **given,
        ),
        value,
    )


def _check_size(size: float) -> None:
    """Raise MeshError for a part that is ``size`` mm long, less than any; where it is but a point, no facet
    has an area."""
    if 0.0 < size < LEAST:
        raise MeshError(
            say(
                "the whole part is {size} long, and none is less than {least}: check the units of the export",
                size=Length(size, ".4g"),
                least=Length(LEAST),
            ),
            size,
        )
