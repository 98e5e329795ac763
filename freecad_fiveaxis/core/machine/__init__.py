# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines and their files."""

from .machine_file import (
    check_new,
    list_shipped_machines,
    load_machine,
    machine_bytes,
    machine_path,
    save_machine,
)
from .model import FARTHEST, Axis, Machine, Vector, find_physical_columns
from .safe_start import BY_CLEARANCE, BY_MACHINE, BY_NOTHING, BY_REFERENCE, RETRACTS, SafeStart

__all__ = [
    "BY_CLEARANCE",
    "BY_MACHINE",
    "BY_NOTHING",
    "BY_REFERENCE",
    "FARTHEST",
    "RETRACTS",
    "Axis",
    "Machine",
    "SafeStart",
    "Vector",
    "check_new",
    "find_physical_columns",
    "list_shipped_machines",
    "load_machine",
    "machine_bytes",
    "machine_path",
    "save_machine",
]  # fmt: skip
