# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh object's facets without FreeCAD's help: taken in one quick call, made into an STL in any thread.

kernel  what FreeCAD saves of a mesh in a document (its BMS format: a header, corners as 32-bit floats, then
        each facet's three corners and three neighbours as 32-bit numbers).

FreeCAD's own ``Mesh.read`` of the kernel and ``Mesh.write`` of an STL take 0.35 s for 500 000 facets, all of
it in the window's thread. The bytes made here are the same to the last bit.
"""

from __future__ import annotations

import hashlib
import io
import zipfile
from typing import Any, NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints

STL = np.dtype([("normal", "<f4", (3,)), ("corner", "<f4", (3, 3)), ("attribute", "<u2")])
_TITLE = (b"MESH-" * 16)[:79] + b"\n"
"""What FreeCAD writes at the head of a binary STL, 80 bytes."""
_COUNTS, _START = 264, 272
"""Bytes of the kernel's header before the two counts and after them."""


def kernel_of(obj: Any) -> bytes:
    """Return the kernel of a mesh object, or of the one that it links to: 0.1 s for 500 000 facets."""
    saved = obj.getLinkedObject().dumpPropertyContent("Mesh", Compression=0)
    with zipfile.ZipFile(io.BytesIO(saved)) as files:
        return next(files.read(name) for name in files.namelist() if name.endswith(".bms"))


class Facets(NamedTuple):
    """A kernel and where it stands: the rows of a 4x4 ``matrix`` (mm), one after the other."""

    kernel: bytes
    matrix: tuple[float, ...]

    @property
    def facet_count(self) -> int:
        """How many facets there are."""
        return int(self._counts()[1])

    def digest(self) -> bytes:
        """Return a checksum of both."""
        return hashlib.sha256(hashlib.sha256(self.kernel).digest() + repr(self.matrix).encode()).digest()

    def stl(self) -> bytes:
        """Return the facets as a binary STL."""
        corner, face = self._columns()
        records = np.zeros(len(face), STL)
        records["corner"] = _move_corners(corner, self.matrix)[face]
        records["normal"] = _normals(records["corner"])
        return _TITLE + len(face).to_bytes(4, "little") + records.tobytes()

    def _order(self) -> str:
        """Of the bytes; the kernel begins with 0xA0B0C0D0."""
        return "<" if self.kernel[0] == 0xD0 else ">"

    def _counts(self) -> Ints:
        return np.frombuffer(self.kernel, self._order() + "u4", count=2, offset=_COUNTS)

    def _columns(self) -> tuple[Floats, Ints]:
        """Corners (v, 3), mm, not yet moved, and rows of them (f, 3)."""
        corners, facets = map(int, self._counts())
        corner = np.frombuffer(self.kernel, self._order() + "f4", count=3 * corners, offset=_START)
        rows = np.frombuffer(
            self.kernel, self._order() + "u4", count=6 * facets, offset=_START + 12 * corners
        )
        return corner.reshape(-1, 3), rows.reshape(-1, 6)[:, :3]


def _move_corners(corner: Floats, matrix: tuple[float, ...]) -> Floats:
    """Corners where the matrix puts them: in FreeCAD's order of operations, and rounded as there."""
    x, y, z = corner.astype(float).T
    rows = np.reshape(matrix, (4, 4))[:3]
    return np.stack([((row[0] * x + row[1] * y) + row[2] * z) + row[3] for row in rows], axis=1).astype(
        np.float32
    )


def _normals(corner: Floats) -> Floats:
    """Return unit normals (f, 3) of facets (f, 3, 3), of length 0 where a facet has no area; in FreeCAD's
    order of 32-bit operations."""
    (ax, ay, az), (bx, by, bz) = (corner[:, 1] - corner[:, 0]).T, (corner[:, 2] - corner[:, 0]).T
    normal = np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], axis=1)
    length = np.sqrt(normal[:, 0] * normal[:, 0] + normal[:, 1] * normal[:, 1] + normal[:, 2] * normal[:, 2])
    np.divide(normal, length[:, None], out=normal, where=length[:, None] > 0)
    return normal
