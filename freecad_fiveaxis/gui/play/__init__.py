# SPDX-License-Identifier: LGPL-2.1-or-later
"""Play: the tool moves over the part, or table and head move as on the machine, along the real path between
the blocks."""

from __future__ import annotations

from typing import Any


def show(obj: Any) -> None:
    """Open the player of a Toolpath or an Audit in a 3D view of its document.

    Raises FiveAxisError where the path cannot be computed or has nothing to play, or where its document has
    no 3D view.
    """
    from .panel import open_panel

    open_panel(obj)
