# SPDX-License-Identifier: LGPL-2.1-or-later
"""In which setups the machine is hit, by tool and spindle, or by its bodies, part or fixtures: asked of the
present one, and of those that would be recommended, one by one, until one is free.

A part that is moved by less than the depth of a hit, at the same turn, moves the tool's way, itself and its
fixtures against each body by no more: there it is hit as well. So these are passed over without a look.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Length, Option, Point, plural

MOST_LOOKED_AT = 24
"""Setups whose whole program is checked: what is free nowhere near these is for the user to find another
region for."""

Look = Callable[[float, Floats], tuple[Finding, ...]]
"""What of the machine is hit at a turn, rad, and a work zero (3,) mm, deeper than the tolerance."""
Choose = Callable[[Bools], int | None]
"""The row to recommend of those (k,) that may be."""


class FreeSetup(NamedTuple):
    """``best``: the row to recommend, None where none is free; ``hits`` (k,) mm: at least so deep
    something goes into the machine, 0 where nothing is hit, NaN where nobody knows; ``findings`` of the best,
    and of those that were passed over; ``least``: where none is free the row in which it is hit least."""

    best: int | None
    hits: Floats
    findings: tuple[Finding, ...] = ()
    least: int | None = None


def choose_free(
    choose: Choose, origin: Floats, turn: Floats, able: Bools, present: bool, look: Look | None
) -> FreeSetup:
    """Choose the best of the rows ``able`` (k,) in which nothing of the machine is hit;
    ``present``: whether row 0 keeps the limits, and is looked at too. ``look``: None where the machine has no
    bodies. ``origin`` (k, 3) mm, ``turn`` (k,) rad."""
    hits = np.full(len(origin), np.nan)
    if look is None:
        return FreeSetup(choose(able), hits)
    seen, row = dict[int, tuple[Finding, ...]](), 0 if present else choose(able)
    while row is not None and len(seen) < MOST_LOOKED_AT:
        seen[row] = look(float(turn[row]), origin[row])
        depth, away = _depth(seen[row]), np.linalg.norm(origin - origin[row], axis=1)
        near = (turn == turn[row]) & (away < depth)
        near[list(seen)] = False  # what was looked at is known better
        hits[near] = np.fmax(hits[near], depth - away[near])
        hits[row] = depth
        best = choose(able & ~(hits > 0.0))
        if best in seen:
            passed = {at: found for at, found in seen.items() if hits[at] > 0.0 and able[at]}
            return FreeSetup(best, hits, (*seen[best], *_note_passed_over(origin, passed)))
        row = best
    hit = [row for row in seen if hits[row] > 0.0]
    if not hit or not able.any():  # the limits are why
        return FreeSetup(None, hits)
    least = min(hit, key=lambda row: float(hits[row]))
    return FreeSetup(None, hits, (_none_free(origin[least], len(hit), seen[least]),), least)


def _depth(found: tuple[Finding, ...]) -> float:
    deepest = _deepest(found)
    return 0.0 if deepest is None else float(deepest.value or 0.0)


def _deepest(found: tuple[Finding, ...]) -> Finding | None:
    return max(
        (one for one in found if one.severity is Severity.ERROR),
        key=lambda one: one.value or 0.0,
        default=None,
    )


def _note_passed_over(origin: Floats, passed: dict[int, tuple[Finding, ...]]) -> Iterator[Finding]:
    """Yield a note on the setups that would be better, but for what is hit there."""
    if passed:
        row = next(iter(passed))
        text = plural(
            len(passed),
            "1 setup that was tried is passed over, because the machine is hit there: with the work zero at "
            "{origin} the {name} by {depth}.",
            "{count} setups that were tried are passed over, because the machine is hit there: with the work "
            "zero at {origin} the {name} by {depth}.",
            origin=Point(tuple(origin[row].tolist()), ".6g"),
            **_hit(passed[row]),
        )
        yield report_finding(Code.SETUPS_HIT_MACHINE, text, float(len(passed)))


def _none_free(least: Floats, count: int, found: tuple[Finding, ...]) -> Finding:
    """Tell that in so many setups the machine is hit, ``found`` with the work zero at ``least`` (3,) mm."""
    text = plural(
        count,
        "In the one setup that was tried the machine is hit, with the work zero at {origin}: the {name} by "
        "{depth}. Move the region ({option}), clamp the part higher, or use a longer tool.",
        "In all {count} setups that were tried the machine is hit, least with the work zero at {origin}: the "
        "{name} by {depth}. Move the region ({option}), clamp the part higher, or use a longer tool.",
        origin=Point(tuple(least.tolist()), ".6g"),
        option=Option("origin"),
        **_hit(found),
    )
    return report_finding(Code.NO_SETUP_FREE, text, _depth(found), 0.0)


def _hit(found: tuple[Finding, ...]) -> dict[str, object]:
    """Return the name of the body that is hit deepest, and how deep."""
    deepest = _deepest(found)
    assert deepest is not None
    return {"name": deepest.hit.entered if deepest.hit else "", "depth": Length(deepest.value or 0.0, ".3g")}
