# SPDX-License-Identifier: LGPL-2.1-or-later
"""A draft is written: checked before, never over a file, whole or not at all."""

from __future__ import annotations

import os
from pathlib import Path

from freecad_fiveaxis.core.base.files import write_whole
from freecad_fiveaxis.core.machine import check_new

from .check import require_machine
from .draft import MachineDraft
from .draft_file import draft_bytes


def save_draft(draft: MachineDraft, path: str | os.PathLike[str]) -> None:
    """Write the draft as a new ``.fcm`` file. Raises MachineError for what is wrong with it, FileError where the file is there
    already or cannot be written; then no file is left."""
    target = Path(path)
    require_machine(draft, target.parent)
    check_new(target)
    write_whole(target, draft_bytes(draft, target.parent))
