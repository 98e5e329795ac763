# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fitted numbers as people name them: coordinates of the rotary lines and zeros of the words, each with
its certainty."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine import Machine

from .model import LINEAR_ZERO, ROTARY_ZERO, across
from .recovery import Recovery


@dataclass(frozen=True)
class Parameter:
    """``name`` as "A line, Y"; ``value`` in ``unit`` (mm or deg), of lines in the machine frame, as in the
    file.

    ``certainty`` half the width of the 95 % interval, infinite where the rows do not determine it;
    ``fitted``: False where it is taken as 0; ``certainty_free``: were no zero of any word taken as known.
    ``given``: of the machine to compare with.
    """

    name: str
    unit: str
    value: float
    certainty: float
    certainty_free: float
    fitted: bool
    given: float | None = None

    @property
    def determined(self) -> bool:
        """Whether the rows say anything of it."""
        return math.isfinite(self.certainty)

    @property
    def apart(self) -> float:
        """Its distance from that of the machine to compare with; 0 where there is none."""
        return 0.0 if self.given is None else abs(self.value - self.given)


def parameters(found: Recovery) -> tuple[Parameter, ...]:
    """All nine, lines first."""
    fit = found.fit
    fixed, free = (fit.factor * np.sqrt(np.diag(covariance)) for covariance in (fit.covariance, fit.free))
    fitted = set(fit.freedom.columns.tolist())
    values, names, given = _values(found)
    kinds = [1.0] * 7 + [180.0 / math.pi] * 2
    return tuple(
        Parameter(
            names[k], "mm" if k < ROTARY_ZERO.start else "deg", values[k], float(fixed[k]) * kinds[k],
            float(free[k]) * kinds[k],
            k in fitted, given[k],
        )
        for k in range(len(values))
    )  # fmt: skip


def _values(found: Recovery) -> tuple[list[float], list[str], list[float | None]]:
    layout, unknown = found.fit.layout, found.fit.unknown
    values, names, given = [], [], []
    lines = zip(layout.letters, (layout.direction1, layout.direction2), strict=True)
    for letter, direction in lines:
        for way in across(direction):
            values.append(float(way @ point_of(found.machine, letter)))
            names.append(f"{letter} line, {way_name(way)}")
            given.append(_find_given(found.start, letter, way, direction))
    values += unknown[LINEAR_ZERO].tolist() + np.degrees(unknown[ROTARY_ZERO]).tolist()
    names += [f"{letter} zero" for letter in "XYZ" + layout.letters]
    return values, names, given + [None] * 5


def point_of(machine: Machine, letter: str) -> Floats:
    """Return the point (3,) of a rotary axis in the file."""
    return np.array(next(axis.point for axis in machine.rotary if axis.letter == letter))


def _find_given(
    start: Machine | None, letter: str, way: Floats, direction: tuple[float, float, float]
) -> float | None:
    """Return the same coordinate of the machine to compare with, where its axis of that letter has the same
    line direction."""
    same = [] if start is None else [axis for axis in start.rotary if axis.letter == letter]
    if not same or np.linalg.norm(np.cross(same[0].direction, direction)) > 1e-6:
        return None
    return float(way @ np.array(same[0].point))


def way_name(way: Floats) -> str:
    """X, Y, Z or the three numbers of a direction."""
    k = int(np.argmax(np.abs(way)))
    if abs(abs(way[k]) - 1.0) < 1e-9:
        return ("" if way[k] > 0.0 else "-") + "XYZ"[k]
    return "(" + ", ".join(f"{value + 0.0:.4g}" for value in way) + ")"
