# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line."""

from .command_line import FAULT, REPORT_TO, STOPPED, TRACEBACK, UNUSABLE, main
from .tasks import DONE, DONE_WITH_ERRORS

__all__ = [
    "DONE", "DONE_WITH_ERRORS", "FAULT", "REPORT_TO", "STOPPED", "TRACEBACK", "UNUSABLE", "main",
]  # fmt: skip
