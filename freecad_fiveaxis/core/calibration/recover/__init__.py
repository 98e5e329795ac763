# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine recovered from a CL path and the program that a post made of it."""

from .page import recovery_html, recovery_json, recovery_text, verdict
from .pairs import find_axis_step, rotary_letters
from .parameters import Parameter, parameters
from .recovery import Recovery, recover
from .verdicts import recovery_findings

__all__ = [
    "Parameter",
    "Recovery",
    "find_axis_step",
    "parameters",
    "recover",
    "recovery_findings",
    "recovery_html",
    "recovery_json",
    "recovery_text",
    "rotary_letters",
    "verdict",
]  # fmt: skip
