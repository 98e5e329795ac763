# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines and their files."""

from .machine import FARTHEST, Axis, Machine, Vector
from .machine_file import load_machine, save_machine, shipped_machines

__all__ = ["FARTHEST", "Axis", "Machine", "Vector", "load_machine", "save_machine", "shipped_machines"]
