# SPDX-License-Identifier: LGPL-2.1-or-later
"""A spherical cap and its path, for the tests of setups and comparisons."""

from functools import cache

import numpy as np
from plain import build_settings
from uncured import UNCURED

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.studies.setup_map import Posting

RADIUS, CENTRE = 40.0, -10.0
"""mm; the sphere's centre lies on Z of the part."""


def cap(half_angle=50.0, rings=20, sectors=60):
    """An open cap of the sphere, its pole up."""
    tilt, turn = (
        np.radians(half_angle) * np.arange(rings + 1) / rings,
        2.0 * np.pi * np.arange(sectors) / sectors,
    )
    x, y, z = (
        np.outer(np.sin(tilt), np.cos(turn)),
        np.outer(np.sin(tilt), np.sin(turn)),
        np.outer(np.cos(tilt), np.ones(sectors)),
    )
    here = RADIUS * np.stack([x, y, z], axis=-1) + (0.0, 0.0, CENTRE)
    there = np.roll(here, -1, axis=1)
    one = np.stack([here[:-1], here[1:], there[1:]], axis=2).reshape(-1, 3, 3)
    two = np.stack([here[1:-1], there[2:], there[1:-1]], axis=2).reshape(-1, 3, 3)
    return from_triangles(np.concatenate([one, two]))


@cache
def milled(machine="trunnion_ac", stepover=3.8, rings=20, **options):
    """The cap's program, as ``mill`` makes it without a cure."""
    given = {"machine": machine, "stepover": stepover, **UNCURED, **options}
    return job.make(build_settings("mill", "cap.stl", given), mesh=cap(rings=rings, sectors=3 * rings))


def posting(result):
    """As the pipeline posts."""
    return Posting(
        result.dialect,
        True,
        result.settings.links.clearance,
        result.settings.cutter.cutter.radius,
        result.mesh.vertex,
    )
