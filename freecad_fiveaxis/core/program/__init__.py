# SPDX-License-Identifier: LGPL-2.1-or-later
"""The NC program as the machine gets it: rounded words, feeds, times."""

from .feeds import rapid_minutes
from .program import Program, block_findings, build_program

__all__ = ["Program", "block_findings", "build_program", "rapid_minutes"]
