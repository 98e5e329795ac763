# SPDX-License-Identifier: LGPL-2.1-or-later
"""The controllers: one table each. To add one, write its module, list it here, and run the contract tests."""

from __future__ import annotations

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import ask_for_near, say

from .dialect import ANGLES, VECTORS, Dialect, Guide
from .fanuc import FANUC
from .grbl import GRBL
from .haas import HAAS
from .heidenhain import HEIDENHAIN, HEIDENHAIN_M128
from .linuxcnc import LINUXCNC
from .mach3 import MACH3
from .siemens840d import SIEMENS840D

DIALECTS: dict[str, Dialect] = {
    dialect.name: dialect
    for dialect in (LINUXCNC, FANUC, HAAS, SIEMENS840D, HEIDENHAIN, HEIDENHAIN_M128, MACH3, GRBL)
}  # fmt: skip


def find_dialect(name: str) -> Dialect:
    """Return the dialect of that name, in any case. Raises SettingsError that lists the names."""
    if name.lower() not in DIALECTS:
        hint = ask_for_near(name.lower(), DIALECTS)
        known = say("known are {dialects}", dialects=", ".join(DIALECTS))
        raise SettingsError(
            say("unknown controller {name}; {hint}{known}", name=repr(name), hint=hint, known=known), name
        )
    return DIALECTS[name.lower()]


__all__ = ["ANGLES", "DIALECTS", "VECTORS", "Dialect", "Guide", "find_dialect"]
