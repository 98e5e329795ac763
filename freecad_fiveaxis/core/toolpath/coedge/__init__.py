# SPDX-License-Identifier: LGPL-2.1-or-later
"""Co-edges: closes the gaps that offsetting leaves, and trims where the surface is concave."""

from .gaps import ROW_COLUMNS, OffsetPath, break_polylines, close_gaps, lasting_rows, take_path_rows

__all__ = ["ROW_COLUMNS", "OffsetPath", "break_polylines", "close_gaps", "lasting_rows", "take_path_rows"]
