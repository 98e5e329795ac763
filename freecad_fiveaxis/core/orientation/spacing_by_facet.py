# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far apart the passes of a level bottom may stand on each facet, by the free axes that the tool has
there.

level    on its bottom: as far apart as that is wide.
flank    with its side along a wall: on a plane as far apart as well, for the side covers what lies above; on
         a bent one as those of a ball of the cutter's radius.
aslant   on its corner: as those of a ball of the corner's radius.
"""

from __future__ import annotations

import math

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.passes import facet_curvature
from freecad_fiveaxis.core.tool import Cutter

from .axis_field import near_places
from .facets_with_axis import ABOUT, AxisField

SQUARE = math.cos(math.radians(1.0))
"""Cosine to the normal from which a bottom lies on the surface."""

ALONG = math.sin(math.radians(1.0))
"""Sine to the surface below which the side of the cutter lies along it."""

SHARP = 0.1
"""Of its radius: a flat that stands aslant is taken to have such a corner; it has none, and would never be
done."""


def radii_by_facet(
    field: AxisField, cutter: Cutter, mesh: Mesh, keep: Bools, wide: float, scallop: float
) -> Floats | None:
    """Return the radius (f,) mm of the ball whose passes may stand as far apart as the cutter's on each
    facet; ``wide`` mm where it stands level. None where that is everywhere."""
    rows = np.flatnonzero(keep)
    some = np.flatnonzero(field.freedom.some)
    cosine = (field.axis[some] * field.nodes.normal[some]).sum(axis=1)
    corner = max(cutter.corner, SHARP * cutter.radius, 1.001 * scallop)
    plain = np.where(cosine > SQUARE, wide, np.where(np.abs(cosine) < ALONG, wide, corner))
    bent = np.where(cosine > SQUARE, wide, np.where(np.abs(cosine) < ALONG, min(cutter.radius, wide), corner))
    if (bent == wide).all():
        return None
    middle = mesh.vertex[mesh.face[rows]].mean(axis=1)
    tree = scipy.spatial.cKDTree(field.nodes.places()[some])
    near = tree.query(
        near_places(middle, mesh.normal[rows], field.nodes.spacing), k=np.arange(1, min(ABOUT, len(some)) + 1)
    )[1]
    radii, flat = np.full(len(keep), wide), _are_plane(mesh, wide, scallop)[rows]
    radii[rows] = np.where(flat, np.median(plain[near], axis=1), np.median(bent[near], axis=1))
    return radii


def _are_plane(mesh: Mesh, radius: float, scallop: float) -> Bools:
    """Whether facets (f,) bend so little that over a step of a ball of this ``radius`` mm less than the
    scallop is left."""
    xx, yy, zz, xy, yz, zx = facet_curvature(mesh)
    most = np.sqrt(xx**2 + yy**2 + zz**2 + 2.0 * (xy**2 + yz**2 + zx**2))
    return np.asarray(most * radius < 1.0)
