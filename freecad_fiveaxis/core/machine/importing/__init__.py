# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines from what others have written: LinuxCNC's configurations, URDF files, FreeCAD's Machine editor."""

from .imported import Imported, as_text, import_machine
from .save import save_imported
from .vismach import find_model

__all__ = ["Imported", "as_text", "find_model", "import_machine", "save_imported"]
