# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the figures of the feed blocks mean for the part, in plain words.

Each kind of trouble gives one finding for all blocks together, with the worst block's value and place, and, where there
are several blocks, one for each of the worst.

deviation-over-tolerance   ERROR: the tip leaves the commanded segment by more than the tolerance.
bound-over-tolerance       WARNING: it was not seen to, but the proven bound does not exclude it.
singular-block             WARNING: near the pole, where the first rotary axis turns far to move the tool a little.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.deviation import Deviation
from freecad_fiveaxis.core.findings import Finding, Severity
from freecad_fiveaxis.core.kinematics import Chain, forward
from freecad_fiveaxis.core.program import Program, feed_blocks
from freecad_fiveaxis.core.records import Floats, Ints
from freecad_fiveaxis.core.singularity import Singularity

from .figures import WORST, inner_words, travel, worst_first

OVER, UNPROVEN, SINGULAR = "deviation-over-tolerance", "bound-over-tolerance", "singular-block"

_SPLIT = "Shorter blocks help: half the length leaves about a quarter of the deviation; linearize makes as many as are needed."
_AWAY = (
    "Let the axis be led past the pole (deform), lead or tilt the tool by a few degrees, or clamp the part in another "
    "position (setup finds one), so that the tool keeps off the pole."
)
_GUIDE = "A controller with tool tip control (RTCP) guides the tip along the segment itself."


def judge(
    links: Chain, program: Program, deviation: Deviation, singularity: Singularity, tolerance: float
) -> tuple[Finding, ...]:
    """The findings of all feed blocks; ``tolerance`` mm. All records have one row a block."""
    feeds = feed_blocks(program)
    over = ~(deviation.segment[feeds] <= tolerance)  # so a NaN counts as over
    unproven = ~over & ~(deviation.bound[feeds] <= tolerance)
    return (
        *_over_tolerance(links, program, deviation, singularity, tolerance, feeds[over]),
        *_unproven(program, deviation, tolerance, feeds[unproven]),
        *_near_pole(program, deviation, singularity, feeds[singularity.singular[feeds]]),
    )


@dataclass(frozen=True)
class _Kind:
    """One kind of trouble: ``values`` (m,) in ``unit``, the worst being the largest."""

    severity: Severity
    code: str
    values: Floats
    limit: float | None
    unit: str


def _findings(
    kind: _Kind, program: Program, deviation: Deviation, rows: Ints, whole: Callable[[int], str], single: Callable[[int], str]
) -> list[Finding]:
    """The worst of ``rows`` first: ``whole`` tells of all, ``single`` of one."""
    rows = worst_first(rows, kind.values)
    told = [(int(row), whole(int(row))) for row in rows[:1]]
    told += [(int(row), single(int(row))) for row in rows[:WORST] if len(rows) > 1]
    return [_finding(kind, program, deviation, row, text) for row, text in told]


def _finding(kind: _Kind, program: Program, deviation: Deviation, row: int, text: str) -> Finding:
    x, y, z = deviation.place[row].tolist()
    value, line = float(kind.values[row]), int(program.line[row])
    return Finding(kind.severity, kind.code, text, value, kind.limit, kind.unit, row, line, (x, y, z))


def _over_tolerance(
    links: Chain, program: Program, deviation: Deviation, singularity: Singularity, tolerance: float, rows: Ints
) -> list[Finding]:
    near = int(singularity.singular[rows].sum())

    def whole(row: int) -> str:
        lead = f"{_blocks(len(rows), 'leaves', 'leave')} the commanded path by more than {tolerance:g} mm; the worst, NC line "
        lead += f"{program.line[row]}, by {deviation.segment[row]:.5g} mm: there {_turns(program, row)} within a step of "
        lead += f"{_chord(links, program, row):.3f} mm. While rotary axes turn, straight moves of the axes carry the tip along "
        lead += "a curve beside the straight segment."
        near_text = "It lies" if len(rows) == 1 else f"{near} of them {'lies' if near == 1 else 'lie'}"
        pole = f" {near_text} near the pole, where {_pole(program)}." if near else ""
        return f"{lead}{pole} {_SPLIT}{' ' + _AWAY if near else ''} {_GUIDE}"

    def single(row: int) -> str:
        help_ = "Split it, or keep the tool off the pole." if singularity.singular[row] else "Split it."
        return (
            f"NC line {program.line[row]} leaves the commanded segment by {deviation.segment[row]:.5g} mm, {tolerance:g} mm "
            f"allowed: {_turns(program, row)} within a step of {_chord(links, program, row):.3f} mm. {help_}"
        )

    kind = _Kind(Severity.ERROR, OVER, deviation.segment, tolerance, "mm")
    return _findings(kind, program, deviation, rows, whole, single)


def _unproven(program: Program, deviation: Deviation, tolerance: float, rows: Ints) -> list[Finding]:
    def whole(row: int) -> str:
        return (
            f"{_blocks(len(rows), 'is', 'are')} so near to the tolerance of {tolerance:g} mm that the proof does not reach: the "
            f"deviation is within it, its proven upper bound is not (worst, NC line {program.line[row]}: bound "
            f"{deviation.bound[row]:.6f} mm). {_SPLIT}"
        )

    def single(row: int) -> str:
        found, bound = f"deviation {deviation.segment[row]:.6f} mm", f"proven bound {deviation.bound[row]:.6f} mm"
        return f"NC line {program.line[row]}: {found}, {bound}, {tolerance:g} mm allowed. Split it."

    kind = _Kind(Severity.WARNING, UNPROVEN, deviation.bound, tolerance, "mm")
    return _findings(kind, program, deviation, rows, whole, single)


def _near_pole(program: Program, deviation: Deviation, singularity: Singularity, rows: Ints) -> list[Finding]:
    turned = np.abs(travel(program)[:, 3:]).max(axis=1, initial=0.0)

    def lean(row: int) -> str:
        return f"{math.degrees(singularity.axis_travel[row]):.3g} deg"

    def whole(row: int) -> str:
        return (
            f"{_blocks(len(rows), 'lies', 'lie')} near the pole (the tool almost along the {program.letters[3]} axis), where "
            f"{_pole(program)}. The worst is NC line {program.line[row]}: {_turns(program, row)} to lean the tool by "
            f"{lean(row)}. The axis may be too slow for the programmed feed, the tool dwells, and marks or a deviation from "
            f"the path may show. {_AWAY}"
        )

    def single(row: int) -> str:
        return f"NC line {program.line[row]}: {_turns(program, row)} to lean the tool by {lean(row)}. Keep the tool off the pole."

    kind = _Kind(Severity.WARNING, SINGULAR, turned, None, "deg")
    return _findings(kind, program, deviation, rows, whole, single)


def _blocks(count: int, one: str, many: str) -> str:
    return f"1 feed block {one}" if count == 1 else f"{count} feed blocks {many}"


def _pole(program: Program) -> str:
    return f"{program.letters[3]} must turn far to lean the tool a little"


def _turns(program: Program, row: int) -> str:
    """What the rotary axes do in a block, as "C turns 27.4 deg and A 0.11 deg"."""
    first, second = np.abs(program.words[row, 3:] - program.words[row - 1, 3:]).tolist()
    return f"{program.letters[3]} turns {first:.4g} deg and {program.letters[4]} {second:.3g} deg"


def _chord(links: Chain, program: Program, row: int) -> float:
    start, end = forward(links, inner_words(program.words[row - 1 : row + 1]))[0]
    return math.dist(start, end)
