# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why no axis is free where the cutter itself has room: a bore from below is not too tight for it, and into a
closed hollow no cutter gets, however small."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.records import Ints
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.hollows import find_hollow_facets
from freecad_fiveaxis.core.gouge.obstacles import Obstacle, Reacher, within_limits

from .axis_field import Freedom, Nodes, even_directions, find_freedom, main_directions, with_margin

BY_PART = (Obstacle.CUTTER, Obstacle.SHANK)
"""What is met where the part is in the way of all axes that the machine takes up; a holder's way may as well
be cleared by a tool that sticks out farther."""


def narrow_reasons(nodes: Nodes, freedom: Freedom, mesh: Mesh, reacher: Reacher) -> Ints:
    """Return what is in the way (n,) of :class:`Obstacle` at ``nodes`` with this ``freedom``; where the ball
    has room and the part is in the way of all axes that were tried, HOLLOW in a closed hollow, and LIMITS
    where one beyond the machine's limits is free."""
    met = freedom.met.copy()
    held = np.flatnonzero(~freedom.some & nodes.fits & np.isin(met, BY_PART))
    if not len(held):
        return met
    hollow = find_hollow_facets(mesh)[nodes.facet[held]]
    met[held[hollow]] = Obstacle.HOLLOW
    met[_free_beyond(nodes, mesh, reacher, held[~hollow])] = Obstacle.LIMITS
    return met


def _free_beyond(nodes: Nodes, mesh: Mesh, reacher: Reacher, held: Ints) -> Ints:
    """Return those of the nodes ``held`` (k,) where an axis is free that the machine does not take up or
    that is not wanted."""
    direction = np.concatenate([main_directions(mesh), even_directions()])
    direction = direction[~within_limits(reacher, direction)]
    if not len(held) or not len(direction):
        return held[:0]
    anywhere = replace(
        with_margin(reacher), kinematics=None, most=math.pi, table=None, machine=None, fixtures=None
    )
    found = find_freedom(nodes.take(held), anywhere, facet_tree(mesh), direction)
    return np.asarray(held[found.some])
