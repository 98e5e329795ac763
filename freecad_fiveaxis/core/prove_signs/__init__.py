# SPDX-License-Identifier: LGPL-2.1-or-later
"""A short safe program, and a sheet for whoever stands at the machine, that show a wrong sign or letter before it cuts."""

from .nc import proof_nc, proof_program
from .plan import Plan, Stop, Wishes, make_plan
from .sheet import sheet_html, sheet_json, sheet_text
from .wrong import Wrong, wrong_machines

__all__ = [
    "Plan", "Stop", "Wishes", "Wrong", "make_plan", "proof_nc", "proof_program", "sheet_html", "sheet_json", "sheet_text",
    "wrong_machines",
]  # fmt: skip
