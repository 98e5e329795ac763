# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the distance of constant-scallop passes begins: the region's border, a point, or a curve."""

from __future__ import annotations

import numpy as np
import scipy

from freecad_fiveaxis.core.base.curve_text import is_inline, name_source, read_runs
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.records import Floats, Ints, number_runs
from freecad_fiveaxis.core.base.sentences import Length, Option, Point, say
from freecad_fiveaxis.core.geometry.nearest import Facets, nearest, search

from .field import Region, Vector
from .geodesic import Frames, side_lengths
from .refine import Copy

BORDER = "border"

FROM = Option("from_")

NEAR = 1.6
"""Sides of the facets: the vertices so near to a curve get their distance from it straight."""

MOST_POINTS = 100_000
"""Points of a curve; a file of more is no guide curve."""


def find_source(source: str | Vector, region: Region, option: Option = FROM) -> Floats | None:
    """Read the source that an ``option`` names, as :func:`read_curve` does. Raises SettingsError, FileError,
    also where a place of it is farther from the region than the ball is thick."""
    curve = read_curve(source, option)
    if curve is not None:
        _refuse_off_surface(region, sample_curve(curve, 0.25 * region.radius))
    return curve


def read_curve(source: str | Vector, option: Option = FROM) -> Floats | None:
    """Return the points (n, 3) mm of the source, one for a point; None for the border. Raises SettingsError,
    FileError."""
    if not isinstance(source, str):
        return np.array([source], dtype=np.float64)
    if source == BORDER:
        return None
    if not (source.lower().endswith(".csv") or is_inline(source)):
        raise SettingsError(
            say("{option} {source} is neither border nor X,Y,Z nor a file CURVE.csv; give one of them",
                option=option,
                source=repr(source)), source,
        )  # fmt: skip
    rows = [row for run in read_runs(source, "guide curve") for row in run]
    try:
        point = np.array([[float(cell) for cell in row[:3]] for row in rows[:MOST_POINTS]], dtype=np.float64)
    except ValueError:
        point = np.empty(0)
    if (
        point.ndim != 2
        or point.shape[1] != 3
        or len(point) < 2
        or len(rows) > MOST_POINTS
        or not np.isfinite(point).all()
    ):
        raise SettingsError(
            say("guide curve {source} needs two points or more, X,Y,Z in mm on a line each, at most {most}",
                source=name_source(source), most=MOST_POINTS), source,
        )  # fmt: skip
    return point


def source_values(copy: Copy, frame: Frames, metric: Floats, curve: Floats | None) -> tuple[Ints, Floats]:
    """Vertices (m,) of the copy at the source, and their distance (m,) from it, in steps; of every piece at
    least one.

    ``curve`` (n, 3) mm as of :func:`read_curve`.
    """
    if curve is None:
        return _at_border(copy)
    length = side_lengths(copy.mesh.vertex, copy.mesh.face, frame, metric)
    size = np.linalg.norm(
        np.roll(copy.mesh.vertex[copy.mesh.face], -1, axis=1) - copy.mesh.vertex[copy.mesh.face], axis=2
    ).T
    at = copy.mesh.face.T.reshape(-1)
    reach, scale = np.zeros(len(copy.mesh.vertex)), np.zeros(len(copy.mesh.vertex))
    np.maximum.at(reach, at, size.reshape(-1))
    np.maximum.at(scale, at, (length / size).reshape(-1))
    samples = sample_curve(curve, 0.25 * float(np.median(size)))
    off = scipy.spatial.cKDTree(samples).query(copy.mesh.vertex)[0]
    chosen = off <= (NEAR * reach if len(curve) > 1 else 0.0)
    lonely = np.setdiff1d(copy.component, copy.component[chosen])
    order = np.lexsort((off, copy.component))
    nearest = order[np.flatnonzero(np.diff(copy.component[order], prepend=-1))]
    alone = nearest[np.isin(copy.component[nearest], lonely)]
    known = off * scale
    known[alone] = 0.0
    source = np.union1d(np.flatnonzero(chosen), alone)
    return source, known[source]


def _at_border(copy: Copy) -> tuple[Ints, Floats]:
    """Return the vertices on the borders of the pieces; of a piece without one its lowest."""
    border = np.unique(copy.mesh.coedge_vertex[copy.mesh.coedge_face[:, 1] < 0])
    closed = np.setdiff1d(copy.component, copy.component[border])
    order = np.lexsort((copy.mesh.vertex[:, 2], copy.component))
    lowest = order[np.flatnonzero(np.diff(copy.component[order], prepend=-1))]
    source = np.union1d(border, lowest[np.isin(copy.component[lowest], closed)])
    return source, np.zeros(len(source))


def sample_curve(curve: Floats, step: float) -> Floats:
    """Give points (m, 3) of a polyline (n, 3) at most ``step`` mm apart, itself where it is one point; at
    most about MOST_POINTS of them."""
    if len(curve) == 1:
        return curve
    way = np.diff(curve, axis=0)
    length = np.linalg.norm(way, axis=1)
    pieces = np.ceil(length / max(step, float(length.sum()) / MOST_POINTS)).astype(np.int64).clip(min=1)
    row, number = number_runs(pieces)
    share = number / pieces[row]
    return np.concatenate([curve[row] + share[:, None] * way[row], curve[-1:]])


def _refuse_off_surface(region: Region, samples: Floats) -> None:
    """Raise SettingsError where one of the samples (n, 3) mm is farther from the region than the ball is
    thick."""
    mesh = region.mesh
    facets = Facets(mesh.vertex[mesh.face[region.keep]].transpose(1, 0, 2), mesh.normal[region.keep])
    off = search(samples, facets.pieces(), facets.square_distances, nearest, 2)[:, 0]
    worst = int(off.argmax())
    if off[worst] <= 2.0 * region.radius:
        return
    x, y, z = samples[worst].tolist()
    raise SettingsError(
        say(
            "passes cannot begin at {place}: it is {off} off the surface that is to be cut; give a place or "
            "a curve on it",
            place=Point((x, y, z), ".6g"),
            off=Length(off[worst], ".4g"),
        ),
        float(off[worst]),
    )
