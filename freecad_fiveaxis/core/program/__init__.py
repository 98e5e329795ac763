# SPDX-License-Identifier: LGPL-2.1-or-later
"""The NC program as the machine gets it: rounded words, feeds, times."""

from .feeds import rapid_minutes
from .program import Program, build_program

__all__ = ["Program", "build_program", "rapid_minutes"]
