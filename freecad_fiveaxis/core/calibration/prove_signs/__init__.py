# SPDX-License-Identifier: LGPL-2.1-or-later
"""A short safe program, and a sheet for whoever stands at the machine, that show a wrong sign or letter
before it cuts."""

from .nc import proof_nc, proof_program
from .plan import Plan, Stop, Wishes, make_plan
from .sheet import READY, STAND, notices, rows, sheet_html, sheet_json, sheet_text, verdict
from .wrong import Wrong, wrong_machines

__all__ = [
    "READY", "STAND", "Plan", "Stop", "Wishes", "Wrong", "make_plan", "notices", "proof_nc", "proof_program",
    "rows",
    "sheet_html", "sheet_json", "sheet_text", "verdict", "wrong_machines",
]  # fmt: skip
