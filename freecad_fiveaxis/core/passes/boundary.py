# SPDX-License-Identifier: LGPL-2.1-or-later
"""The boundary within which passes are kept: closed curves, seen along an axis.

boundary   an outer curve and islands in it, or several of both: what is inside follows from the even-odd
           rule.
contact    the boundary holds the contact points; ``centre``: the centre of the cutter.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.curve_text import LONGEST_NAME, is_number, read_runs
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Area, Length, Number, Option, Point, Sentence, one_line, say
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .field import Vector
from .plane_curves import PlaneCurves

OPEN = 1e-3
"""mm; a curve whose ends are farther apart is open."""

MOST_POINTS = 20_000
"""Points of all curves together; a file of more is no boundary that somebody drew."""

MOST_BYTES = 10_000_000

FARTHEST = 1e6
"""mm; of a coordinate from 0."""

FLATTEST = 1e-9
"""Of its size: a curve that is less wide is seen edgewise."""


@dataclass(frozen=True, eq=False)
class Boundary:
    """``name`` of the file; ``basis`` (2, 3): the directions u and v of the plane across the axis; ``curves``
    in it; ``low`` and ``high`` (3,) mm: the box of the points."""

    name: str
    basis: Floats
    curves: PlaneCurves
    low: Floats
    high: Floats

    def project(self, point: Floats) -> Floats:
        """Give the points (..., 3) mm as they are seen along the axis, (..., 2) mm."""
        return np.asarray(point @ self.basis.T)


def read_boundary(path: str, name: str, axis: Vector) -> Boundary:
    """Read closed curves, :mod:`.curve_text`: a point X,Y,Z in mm a line, a blank line between two curves,
    perhaps names of the columns first. ``axis``: I,J,K, any length above 0. Raises SettingsError, FileError
    for what is no boundary."""
    curves = [_close_curve(curve, name, number) for number, curve in enumerate(_read_curves(path, name), 1)]
    basis = _across(axis)
    basis = basis[np.argsort([-_to_and_fro(curves, one) for one in basis])]
    seen = [curve @ basis.T for curve in curves]
    for number, curve in enumerate(seen, 1):
        if _width(curve) <= FLATTEST * float(np.ptp(curves[number - 1], axis=0).max()):
            text = say(
                "curve {number} of boundary {name} has no area when it is seen along {axis}; give another "
                "{option}",
                number=number, name=name, axis=_list_numbers(axis), option=Option("boundary_axis"),
            )  # fmt: skip
            raise SettingsError(text, axis)
    point, found = np.concatenate(curves), PlaneCurves.of(seen)
    if (place := found.self_crossing()) is not None:
        x, y, z = (place @ basis).tolist()
        text = say(
            "boundary {name} crosses itself at {place}, seen along {axis}; give curves that do not",
            name=name,
            place=Point((x, y, z), ".6g"), axis=_list_numbers(axis),
        )  # fmt: skip
        raise SettingsError(text, name)
    return Boundary(name, basis, found, point.min(axis=0), point.max(axis=0))


def _across(axis: Vector) -> Floats:
    """Two unit directions (2, 3) across the axis; those of the frame, to the last bit, where it is one of the
    frame's."""
    along = np.array(axis, dtype=np.float64) / math.hypot(*axis)
    least = np.zeros(3)
    least[np.abs(along).argmin()] = 1.0
    one = np.cross(least, along)
    one /= np.linalg.norm(one)
    return np.array([one, np.cross(one, along)]) + 0.0


def _list_numbers(axis: Vector) -> str:
    return ",".join(f"{number:g}" for number in axis)


def _read_curves(path: str, name: str) -> list[Floats]:
    """Return the curves (n, 3) of the file, as they stand there. Raises SettingsError, FileError."""
    runs = read_runs(path, "boundary", MOST_BYTES)
    if not runs or sum(map(len, runs)) > MOST_POINTS:
        raise SettingsError(_unreadable(name), path)
    for number, run in enumerate(runs, 1):
        if wrong := next((row for row in run if not _is_point(row)), None):
            text = say(
                "boundary {name} holds no closed curves: {cells} in curve {number} is no point; give X,Y,Z "
                "in mm on a line each, none beyond {farthest}",
                name=name, cells=repr(one_line(",".join(wrong))[:LONGEST_NAME]), number=number,
                farthest=Length(FARTHEST),
            )  # fmt: skip
            raise SettingsError(text, path)
    return [np.array([[float(cell) for cell in row[:3]] for row in run]) for run in runs]


def _is_point(row: list[str]) -> bool:
    """Tell whether the cells begin with three finite numbers that may be coordinates."""
    return len(row) > 2 and all(is_number(cell) and abs(float(cell)) <= FARTHEST for cell in row[:3])


def _unreadable(name: str) -> Sentence:
    return say(
        "boundary {name} holds no closed curves: give X,Y,Z in mm on a line each, a blank line between two "
        "curves, at most {most} points, none beyond {farthest}",
        name=name, most=MOST_POINTS, farthest=Length(FARTHEST),
    )  # fmt: skip


def _close_curve(curve: Floats, name: str, number: int) -> Floats:
    """Return the curve (n, 3), its last point the first to the last bit. Raises SettingsError for one that is
    open or no polygon."""
    gap = float(np.linalg.norm(curve[-1] - curve[0]))
    if len(curve) > 2 and gap > OPEN:
        text = say(
            "curve {number} of boundary {name} is not closed: its ends are {gap} apart; repeat the first "
            "point at the end",
            number=number, name=name, gap=Length(gap, ".4g"),
        )  # fmt: skip
        raise SettingsError(text, gap)
    corners = len(curve) - 1 if gap <= OPEN else len(curve)
    if corners < 3:
        text = say(
            "curve {number} of boundary {name} has {count} points; give three or more, and the first again "
            "at the end",
            number=number, name=name, count=corners,
        )  # fmt: skip
        raise SettingsError(text, corners)
    return np.concatenate([curve[:-1], curve[:1]])


def _to_and_fro(curves: list[Floats], along: Floats) -> float:
    """How many times the curves go over their whole extent along a direction: few slabs are worth it across
    that."""
    place = [curve @ along for curve in curves]
    way = sum(float(np.abs(np.diff(one)).sum()) for one in place)
    return way / max(float(np.ptp(np.concatenate(place))), 1e-300)


def _width(curve: Floats) -> float:
    """About how far (mm) points (n, 2) lie beside a line: 0 where one goes through all of them."""
    return float(np.linalg.svd(curve - curve.mean(axis=0), compute_uv=False)[1])


def facets_within(
    boundary: Boundary, mesh: Mesh, faces: Bools | None, reach: float = 0.0
) -> tuple[Bools, tuple[Finding, ...]]:
    """Find those of the ``faces`` (f,; None: all facets) that lie within the boundary, if only in part, and
    say how much area the others have. ``reach`` mm: of a cutter whose centre is held, how far its contact may
    lie from it.

    Raises SettingsError where there is none.
    """
    wanted = np.ones(len(mesh.face), np.bool_) if faces is None else faces
    rows = np.flatnonzero(wanted)
    kept = np.zeros(len(wanted), np.bool_)
    corner = boundary.project(mesh.vertex)[mesh.face[rows]]
    kept[rows] = boundary.curves.find_touched(corner, reach)
    if not kept.any():
        raise SettingsError(nothing_inside(boundary), boundary.name)
    return kept, _report_outside(boundary, mesh, wanted & ~kept, wanted)


def nothing_inside(boundary: Boundary) -> Sentence:
    """Say that no part of the surface lies inside."""
    return say(
        "no part of the surface that is to be machined lies inside boundary {name}, which reaches from "
        "{low} to {high}; its points are in mm, in the frame of the part",
        name=boundary.name, low=Point(tuple(boundary.low.tolist()), ".6g"),
        high=Point(tuple(boundary.high.tolist()), ".6g"),
    )  # fmt: skip


def _report_outside(boundary: Boundary, mesh: Mesh, out: Bools, wanted: Bools) -> tuple[Finding, ...]:
    if not out.any():
        return ()
    area, whole = float(mesh.area[out].sum()), float(mesh.area[wanted].sum())
    text = say(
        "{count} facets of {area} ({share} % of what was to be machined) lie outside boundary {name} and "
        "are not machined; {gouge} keeps the tool out of them.",
        count=int(out.sum()), area=Area(area, ".6g"), share=Number(100.0 * area / whole, ".3g"),
        name=boundary.name,
        gouge=Option("gouge"),
    )  # fmt: skip
    return (report_finding(Code.OUTSIDE_BOUNDARY, text, area),)
