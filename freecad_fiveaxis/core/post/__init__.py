# SPDX-License-Identifier: LGPL-2.1-or-later
"""The controllers: one table each. To add one, write its module, list it here, and run the contract tests."""

from __future__ import annotations

from freecad_fiveaxis.core.errors import SettingsError

from .dialect import Dialect, PostOptions
from .fanuc import FANUC
from .linuxcnc import LINUXCNC

DIALECTS: dict[str, Dialect] = {dialect.name: dialect for dialect in (LINUXCNC, FANUC)}


def find_dialect(name: str) -> Dialect:
    """The dialect of that name, in any case. Raises SettingsError that lists the names."""
    if name.lower() not in DIALECTS:
        raise SettingsError(f"unknown controller {name!r}; known are {', '.join(DIALECTS)}", name)
    return DIALECTS[name.lower()]


__all__ = ["DIALECTS", "Dialect", "PostOptions", "find_dialect"]
