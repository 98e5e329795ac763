# SPDX-License-Identifier: LGPL-2.1-or-later
"""Five-axis tool paths with a proven deviation for every block, in FreeCAD and without it."""

__version__ = "0.2.0"
