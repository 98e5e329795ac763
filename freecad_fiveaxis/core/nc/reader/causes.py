# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings of one cause as one finding: where a program is not run, all that its variables, calls and cycles
then leave open follows from the one line that was not understood."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.sentences import say

from . import codes

FOLLOW = (
    codes.MACRO[0], codes.CALL[0], codes.CYCLE_KIND[0], Code.FEED_BY_PARAMETER, Code.NO_FEED,
    Code.PLANE_NOT_TAKEN,
    Code.POSITION_UNKNOWN, Code.NO_MOTION_CODE,
)  # fmt: skip
"""Codes of what is missing, or stands where it would not, in a program that is not run."""


def fold(findings: Sequence[Finding], cause: Finding | None) -> tuple[Finding, ...]:
    """Put the ``cause`` first, with the codes and first lines of what follows from it in its text, and leave
    those out; all findings as they are where there is no cause, or nothing follows."""
    if cause is None:
        return tuple(findings)
    under = [found for found in findings if found is not cause and found.code in FOLLOW]
    if not under:
        return tuple(findings)
    first: dict[str, int] = {}
    for found in under:
        first[found.code] = min(first.get(found.code, found.line or 0), found.line or 0)
    text = say(
        "{cause} What follows from it is not told one by one ({count} in all): {codes}.",
        cause=cause.text,
        count=len(under),
        codes=", ".join(f"{code} ({line})" if line else code for code, line in first.items()),
    )
    others = [found for found in findings if found is not cause and found.code not in FOLLOW]
    return (replace(cause, text=text), *others)
