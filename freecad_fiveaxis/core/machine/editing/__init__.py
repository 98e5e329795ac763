# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine as a draft that is edited value by value, checked as its file will be, and written as a new
file."""

from .attached import AttachedMeshes, attach_bodies
from .check import Problem, check_draft
from .draft import AxisDraft, MachineDraft, read_draft
from .draft_file import draft_bytes
from .edits import add_axis, change_axis, free_letters, move_axis, remove_axis
from .save import save_draft

__all__ = [
    "AttachedMeshes", "AxisDraft", "MachineDraft", "Problem", "add_axis", "attach_bodies", "change_axis",
    "check_draft",
    "draft_bytes", "free_letters", "move_axis", "read_draft", "remove_axis", "save_draft",
]  # fmt: skip
