# SPDX-License-Identifier: LGPL-2.1-or-later
"""A draft is written: checked before, never over a file, all of its files whole or none of them."""

from __future__ import annotations

import os
from pathlib import Path

from freecad_fiveaxis.core.base.files import write_all
from freecad_fiveaxis.core.machine import check_new

from .attached import AttachedMeshes, name_attached
from .check import require_machine
from .draft import MachineDraft
from .draft_file import draft_bytes


def save_draft(
    draft: MachineDraft, path: str | os.PathLike[str], attached: AttachedMeshes | None = None
) -> None:
    """Write the draft as a new ``.fcm`` file, the meshes ``attached`` to it as STL files beside it. Raises
    MachineError for what is wrong with it, FileError where the file is there already or cannot be written;
    then no file is left."""
    target = Path(path)
    require_machine(draft)
    check_new(target)
    draft, files = name_attached(draft, target, attached or AttachedMeshes())
    write_all(files | {str(target): draft_bytes(draft, target.parent)})
