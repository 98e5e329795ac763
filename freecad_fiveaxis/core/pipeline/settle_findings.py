# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings made on the way to a program that its check and the map of what is left have settled."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.gouge import GougeCheck, RestMaterial

from .collision_avoidance import area_of

JUDGED = frozenset({Code.SURFACE_TIGHTER_THAN_CUTTER, Code.HEEL_IN_HOLLOW})
"""The codes of findings that only suspect what the check of the finished program then knows, cured or not."""


def still_true(
    findings: tuple[Finding, ...],
    check: GougeCheck | None,
    rest: RestMaterial | None,
    later: Sequence[Finding],
) -> tuple[Finding, ...]:
    """Return the findings without those that the check of the finished program and the map of what is left,
    where there were any, have settled, by the findings ``later`` than these: a side of which the map finds
    less than half uncut is swept from its neighbours, and corners in which it finds nothing are notes."""
    uncut = area_of(later, Code.UNCUT) if rest is not None else math.inf

    def stays(one: Finding) -> bool:
        if one.code == Code.SIDE_NOT_MACHINED:
            return (one.value or 0.0) <= 2.0 * uncut
        return check is None or one.code not in JUDGED

    true = tuple(one for one in findings if stays(one))
    return true if rest is None else settle_corners(settle_intervals(true, rest), later)


def settle_corners(findings: tuple[Finding, ...], later: Sequence[Finding]) -> tuple[Finding, ...]:
    """Return the findings, inside corners tighter than the cutter as notes where a map of what is left was
    made and the findings ``later``, which hold what it found, tell of nothing uncut."""
    if any(one.code == Code.UNCUT for one in later):
        return findings
    text = say(
        "Inside corners are tighter than the cutter, but the map of what is left finds nowhere more in them "
        "than may stay: twice the scallop and the tolerance."
    )
    return tuple(
        replace(one, severity=Severity.NOTE, text=text) if one.code == Code.CORNER_NOT_REACHED else one
        for one in findings
    )


def settle_intervals(findings: tuple[Finding, ...], rest: RestMaterial) -> tuple[Finding, ...]:
    """Return the findings, planes that stand no closer than they may as notes where the map of what is left
    finds nowhere as much as would stay between them alone."""
    most = float(rest.height.max(initial=0.0))
    return tuple(_settle_interval(one, most) for one in findings)


def _settle_interval(one: Finding, most: float) -> Finding:
    """Return a finding with the most, mm, that the map finds left, where that is less than it tells."""
    if one.code != Code.LEAST_INTERVAL or one.value is None or one.value <= most:
        return one
    text = say(
        "On steep walls passes stand no closer than the least interval, and between them alone up to "
        "{estimate} would stay. Other passes cut there: the map of what is left finds at most {height} "
        "anywhere.",
        estimate=Length(one.value, ".4g"),
        height=Length(most, ".4g"),
    )
    return replace(one, severity=Severity.NOTE, text=text, value=most)
