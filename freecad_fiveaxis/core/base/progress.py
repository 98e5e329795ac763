# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long work says where it stands, and how it is stopped.

A long function takes ``progress`` and calls ``progress(stage, fraction)`` a few times a second at most.
Whoever wants to stop it raises :class:`~freecad_fiveaxis.core.base.errors.Cancelled` (or any exception) from
that call.
"""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[str, float], None]


def silent(stage: str, fraction: float) -> None:
    """Say nothing: the default."""
