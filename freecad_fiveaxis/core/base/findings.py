# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a result says about itself.

finding   one poor spot of a result: what, how bad, where, and what helps. Findings never stop the output.
code      what it is about, one of the list in :mod:`.codes`, with its severity.
"""

from __future__ import annotations

from dataclasses import dataclass

from .codes import Code, Severity


@dataclass(frozen=True)
class Hit:
    """A collision or a near miss: what ``enters`` or would (cutter, shank, holder, spindle) and what is
    ``entered``: a fixture or a body of the machine by its name, "" for the part; ``u``: when within the block
    it is deepest or nearest, 0 to 1, None where that is not known."""

    enters: str
    entered: str
    u: float | None = None


@dataclass(frozen=True)
class Finding:
    """One poor spot. ``code`` is a stable kebab-case word, ``text`` a full sentence with its remedy.

    ``value`` and ``limit`` are in ``unit`` (``mm``, ``deg``, ``mm2``, ``1`` ...); ``block`` is a row of the
    Program, ``line`` a line of the NC file (counted from 1), ``place`` a point in the work frame, mm.
    ``hit``: of a collision with a fixture or the machine; ``near``: of what comes nearer to one than is asked
    for. ``within`` mm2: of the facets that are cut so much stays because of it; where the value is an area,
    this is part of it.
    """

    severity: Severity
    code: str
    text: str
    value: float | None = None
    limit: float | None = None
    unit: str = ""
    block: int | None = None
    line: int | None = None
    place: tuple[float, float, float] | None = None
    hit: Hit | None = None
    near: Hit | None = None
    within: float | None = None


def report_finding(
    code: Code,
    text: str,
    value: float | None = None,
    limit: float | None = None,
    block: int | None = None,
    line: int | None = None,
    place: tuple[float, float, float] | None = None,
    *,
    severity: Severity | None = None,
    unit: str | None = None,
    hit: Hit | None = None,
    near: Hit | None = None,
    within: float | None = None,
) -> Finding:
    """Make a finding of the list: ``severity`` and ``unit`` are those of its code where none are given."""
    if unit is None:
        unit = "" if value is None else code.unit
    return Finding(
        code.severity if severity is None else severity,
        code,
        text,
        value,
        limit,
        unit,
        block,
        line,
        place,
        hit,
        near,
        within,
    )
