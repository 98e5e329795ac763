# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inner products and lengths of many vectors at once: by rows (n, 3), or by columns: three arrays, or one (3, ...)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from .records import Floats

Vectors = Sequence[Any] | Floats
"""Three columns x, y and z, of one shape or that of numbers."""


def row_dot(one: Floats, two: Floats) -> Floats:
    """Inner products (n,) of the rows of two (n, 3) arrays."""
    return np.asarray(np.einsum("ij,ij->i", one, two))


def dot(one: Vectors, two: Vectors) -> Floats:
    """Inner products of vectors by columns."""
    product: Floats = one[0] * two[0] + one[1] * two[1] + one[2] * two[2]
    return product


def length(vector: Vectors) -> Floats:
    """Lengths of vectors by columns."""
    return np.asarray(np.sqrt(dot(vector, vector)))
