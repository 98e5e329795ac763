# SPDX-License-Identifier: LGPL-2.1-or-later
"""The audit of a finished program: limits, axis rates, feed over the part, and where it leaves a CL path or
enters a part.

A ball's distance from the part is a small module for audits; any other cutter, shank and holder are the gouge
check's.
"""

from .against_cl import AgainstPath, against_path
from .against_part import AgainstPart, against_part
from .judge import Audit, AuditOptions, audit_program
from .limits import Limits, check_limits
from .rates import Rates, compute_commanded_rates, feed_findings, find_timed_feeds, rate_findings
from .tool_in_part import tool_in_part

__all__ = [
    "AgainstPart",
    "AgainstPath",
    "Audit",
    "AuditOptions",
    "Limits",
    "Rates",
    "against_part",
    "against_path",
    "audit_program",
    "check_limits",
    "compute_commanded_rates",
    "feed_findings",
    "find_timed_feeds",
    "rate_findings",
    "tool_in_part",
]  # fmt: skip
