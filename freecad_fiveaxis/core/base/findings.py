# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a result says about itself.

finding   one poor spot of a result: what, how bad, where, and what helps. Findings never stop the output.
severity  ordered by consequence: NOTE changes nothing on the part, WARNING may show on the part,
          ERROR will spoil the part or the machine if nobody looks (the command line then exits with 1).
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum


class Severity(IntEnum):
    """Consequence for the part, least first."""

    NOTE = 0
    WARNING = 1
    ERROR = 2


@dataclass(frozen=True)
class Hit:
    """A collision or a near miss: what ``enters`` or would (cutter, shank, holder, spindle) and what is ``entered``: a fixture or
    a body of the machine by its name, "" for the part; ``u``: when within the block it is deepest or nearest, 0 to 1, None where
    that is not known."""

    enters: str
    entered: str
    u: float | None = None


@dataclass(frozen=True)
class Finding:
    """One poor spot. ``code`` is a stable kebab-case word, ``text`` a full sentence with its remedy.

    ``value`` and ``limit`` are in ``unit`` (``mm``, ``deg``, ``mm2``, ``1`` ...); ``block`` is a row of the
    Program, ``line`` a line of the NC file (counted from 1), ``place`` a point in the work frame, mm. ``hit``: of a collision
    with a fixture or the machine; ``near``: of what comes nearer to one than is asked for.
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
