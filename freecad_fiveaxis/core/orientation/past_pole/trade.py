# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a larger change of the tool axis buys: the table from which an angle is chosen.

pieces    of a block: into how many equal parts it has to be cut for its deviation to keep the tolerance. The
          deviation of a block falls with the square of its length, so these are ``sqrt(deviation /
          tolerance)``, rounded up.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.ranges import LARGEST_CHANGE, LEAST_CHANGE
from freecad_fiveaxis.core.base.records import Floats, Ints, freeze
from freecad_fiveaxis.core.base.sentences import Angle, Length, Sentence, Turn, join_sentences, say
from freecad_fiveaxis.core.machine.kinematics import Chain, joint_words, q_to_words
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.tool.barrel import Flank
from freecad_fiveaxis.core.toolpath.cl_offset import hub_positions
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath, take_path_rows

from .apply import check_change
from .choice import NEAR, near_polylines, reroute_axes
from .drive import drive, figures, starts
from .meridian import Globe, angle_between

STEPS = (0.25, 0.5, 1.0, 2.0)
"""Changes of which the findings tell, in changes allowed."""
MOST_ROWS = 50_000
"""Rows of which the findings' trade is made, or of one pass: of more, evenly chosen passes stand for all."""


@dataclass(frozen=True, eq=False)
class Trade:
    """One row an allowed change, row 0 the axes as given, over the passes that come near the pole at the
    largest change.

    ``allowed`` and ``used`` rad: largest change allowed, and made; ``passes`` passes that are led; ``peak``
    rad/mm largest rate of the first rotary word; ``first``, ``second`` rad turns of the rotary words on the
    part; ``deviation`` mm, the largest of a block; ``blocks`` estimated number after linearization.
    """

    allowed: Floats
    used: Floats
    passes: Ints
    peak: Floats
    first: Floats
    second: Floats
    deviation: Floats
    blocks: Ints

    def __post_init__(self) -> None:
        floats = dict.fromkeys(("allowed", "used", "peak", "first", "second", "deviation"), "f")
        freeze(self, None, **floats, passes="i", blocks="i")

    def table(self, letters: str) -> tuple[tuple[str, ...], list[tuple[float, ...]]]:
        """Headings and rows for a report, degrees and mm; ``letters`` of the chain."""
        first, second = letters[3], letters[4]
        heads = (
            "axis change allowed, deg", "made, deg", "passes led", f"peak {first} rate, deg/mm",
            f"{first} travel, deg",
            f"{second} travel, deg", "largest deviation, mm", "blocks when linearized",
        )  # fmt: skip
        angles = (np.degrees(part) for part in (self.peak, self.first, self.second))
        columns = (
            np.degrees(self.allowed),
            np.degrees(self.used),
            self.passes,
            *angles,
            self.deviation,
            self.blocks,
        )
        return heads, [tuple(float(value) for value in row) for row in np.column_stack(columns)]


def trade_off(
    offset: OffsetPath, axis: Floats, kinematics: Chain, changes: Sequence[float], tolerance: float,
    radius: float = 0.0,
    progress: Progress = silent, ring: float = 0.0, barrel: Flank | None = None,
) -> Trade:  # fmt: skip
    """Lead the axes within each of ``changes`` (rad) and say what comes of it.

    ``tolerance`` mm for the number of blocks; ``radius`` mm from the ball's centre to the driven point (0:
    the centre is driven); ``ring`` mm of a cutter that is no ball, or the flank of a barrel: its hub takes
    the place of the ball's centre. All rows are measured before rounding. Raises SettingsError for a change
    or tolerance out of range.
    """
    for change in changes:
        check_change(change)
    if not 0.0 < tolerance < math.inf:
        raise SettingsError(
            say("tolerance is {tolerance}; give a length above 0", tolerance=Length(tolerance)), tolerance
        )
    axis = np.asarray(axis, float)
    offset, axis = _near(offset, axis, kinematics, NEAR * max(changes, default=0.0))
    allowed = [0.0, *changes]
    if not len(axis):
        nothing = np.zeros(len(allowed))
        none = np.zeros(len(allowed), np.int64)
        return Trade(np.array(allowed), nothing, none, nothing, nothing, nothing, nothing, none)
    table = []
    for count, change in enumerate(allowed):
        progress("trade of axis change", count / len(allowed))
        rerouted = reroute_axes(offset, axis, kinematics, change) if change else None
        corrected, passes = (axis, 0) if rerouted is None else (rerouted.axis, int(rerouted.rerouted.sum()))
        table.append(
            (
                change,
                float(angle_between(corrected, axis).max()),
                passes,
                *_drive_moves(offset, corrected, kinematics, tolerance, (radius, ring, barrel)),
            )
        )
    return Trade(*(np.array(column) for column in zip(*table, strict=True)))


def trade_findings(
    offset: OffsetPath, axis: Floats, kinematics: Chain, change: float, tolerance: float, radius: float = 0.0,
    progress: Progress = silent, ring: float = 0.0, barrel: Flank | None = None,
) -> tuple[Finding, ...]:  # fmt: skip
    """Return what smaller and larger changes than ``change`` (rad) would give the passes that come within
    ``change`` of the pole, as a note; none where no pass does. Other arguments as in :func:`trade_off`."""
    changes = sorted({min(step * change, LARGEST_CHANGE) for step in STEPS if step * change >= LEAST_CHANGE})
    offset, axis = _near(offset, axis, kinematics, change)
    if not len(axis):
        return ()
    begin = starts(offset.polyline)
    chosen = np.arange(len(begin)) % math.ceil(len(axis) / MOST_ROWS) == 0
    rows = np.flatnonzero(np.repeat(chosen, np.diff(begin, append=len(axis))))
    trade = trade_off(
        take_path_rows(offset, rows),
        axis[rows],
        kinematics,
        changes,
        tolerance,
        radius,
        progress,
        ring,
        barrel,
    )
    part = say("the {all}", all=len(begin))
    if not chosen.all():
        part = say("{count} of the {all}", count=int(chosen.sum()), all=len(begin))
    text = say(
        "What an axis change buys on {part} passes that come within {change} of the pole (peak rate and "
        "travel of {letter}, blocks that would hold {tolerance}): {rows}.",
        part=part,
        change=Angle(math.degrees(change), ".3g"),
        letter=kinematics.letters[3],
        tolerance=Length(tolerance),
        rows=join_sentences(_rows(trade), "; "),
    )
    return (report_finding(Code.AXIS_CHANGE_TRADE, text, math.degrees(change)),)


def _rows(trade: Trade) -> Iterator[Sentence]:
    columns = (trade.allowed, trade.peak, trade.first, trade.blocks)
    for row, (allowed, peak, first, blocks) in enumerate(zip(*columns, strict=True)):
        yield say(
            "{change} {rate}, {turned}, {blocks}",
            change=Angle(math.degrees(allowed), ".3g") if row else say("as given"),
            rate=Turn(math.degrees(peak), ".3g"),
            turned=Angle(math.degrees(first), ".0f"),
            blocks=blocks,
        )


def _near(offset: OffsetPath, axis: Floats, kinematics: Chain, angle: float) -> tuple[OffsetPath, Floats]:
    """Return the polylines that come within ``angle`` (rad) of the pole, and their axes."""
    near = near_polylines(offset, axis, Globe.of(kinematics), angle) if len(axis) else np.zeros(0, bool)
    rows = (
        np.flatnonzero(np.repeat(near, np.diff(starts(offset.polyline), append=len(axis))))
        if near.any()
        else np.empty(0, int)
    )
    return take_path_rows(offset, rows), axis[rows]


def _drive_moves(
    offset: OffsetPath,
    axis: Floats,
    kinematics: Chain,
    tolerance: float,
    sizes: tuple[float, float, Flank | None],
) -> tuple[float, float, float, float, int]:
    """Peak rate, turns of both words, largest deviation and number of blocks of the moves on the part.

    ``sizes`` mm: of radius and ring, and the flank."""
    angles = drive(offset, axis, kinematics)
    found = figures(offset, angles)
    words = q_to_words(
        joint_words(kinematics, hub_positions(offset, axis, *sizes[1:]) - sizes[0] * axis, angles)
    )
    on_part = np.diff(offset.polyline, prepend=offset.polyline[:1] - 1) == 0
    deviation = measure(kinematics, words).segment[on_part]
    pieces = np.maximum(np.ceil(np.sqrt(deviation / tolerance)), 1.0)
    first = float(found.first.sum())
    return (
        float(found.peak.max()),
        first,
        float(found.travel.sum()) - first,
        float(deviation.max(initial=0.0)),
        int(pieces.sum()),
    )
