# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which controller a machine's programs are for, and how their files end."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.pipeline.options import dialect_for, take_units

from .properties import MACHINES_OWN

SUFFIX = ".ngc"
"""Where the controller is not known: writing will say what is the matter with the machine."""


def dialect_of(controller: str | None, machine: str | None) -> Dialect | None:
    """Return the core's table of a controller, or of the machine's own; None where the machine cannot be
    used."""
    try:
        return dialect_for(controller, load_machine(machine) if machine and not controller else None)
    except FiveAxisError:
        return None  # whoever uses the machine tells why it cannot be used


def suffix_of(controller: str | None, machine: str | None) -> str:
    """How the NC files of a controller end, or of the machine's own."""
    dialect = dialect_of(controller, machine)
    return dialect.suffix if dialect else SUFFIX


def suffix_of_path(obj: Any) -> str:
    """How the NC files of a Toolpath end."""
    return suffix_of(None if obj.Controller == MACHINES_OWN else obj.Controller, obj.Machine)


def units_of_path(obj: Any) -> tuple[bool, str]:
    """Return whether a Toolpath's NC file is in inches, and the word of it that says its units; the usual one
    where its controller is not known."""
    dialect = dialect_of(None if obj.Controller == MACHINES_OWN else obj.Controller, obj.Machine)
    with suppress(FiveAxisError):  # then no program is written, and whoever computes it tells why
        dialect = dialect and take_units(obj.ProgramUnits, load_machine(obj.Machine), dialect)
    return (dialect.unit != 1.0, dialect.metric) if dialect else (False, Dialect.metric)
