# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines and their files."""

from .machine_file import check_new, load_machine, machine_bytes, machine_path, save_machine, shipped_machines
from .model import FARTHEST, Axis, Machine, Vector, fitted_columns
from .safe_start import BY_CLEARANCE, BY_MACHINE, BY_NOTHING, BY_REFERENCE, RETRACTS, SafeStart

__all__ = [
    "BY_CLEARANCE", "BY_MACHINE", "BY_NOTHING", "BY_REFERENCE", "FARTHEST", "RETRACTS", "Axis", "Machine",
    "SafeStart", "Vector",
    "check_new", "fitted_columns", "load_machine", "machine_bytes", "machine_path", "save_machine",
    "shipped_machines",
]  # fmt: skip
