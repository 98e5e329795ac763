# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes: welded triangles with co-edges, and STL files in and out."""

from .stl import check_stl_beginning, read_corners, read_stl, stl_bytes, write_stl
from .triangles import Mesh, from_faces, from_triangles, join_loose

__all__ = [
    "Mesh",
    "check_stl_beginning",
    "from_faces",
    "from_triangles",
    "join_loose",
    "read_corners",
    "read_stl",
    "stl_bytes",
    "write_stl",
]
