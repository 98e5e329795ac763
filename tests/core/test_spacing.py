# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planes: a constant stepover, and the scallop that is really left, measured by dense sampling of analytic surfaces."""

import math

import numpy as np
import pytest
from scipy.spatial import cKDTree

from freecad_fiveaxis.core.errors import Cancelled, FiveAxisError, SettingsError
from freecad_fiveaxis.core.findings import Severity
from freecad_fiveaxis.core.mesh import from_faces
from freecad_fiveaxis.core.scallop import facet_curvature, flat_interval, kink_factor, scallop_height, turned_along
from freecad_fiveaxis.core.spacing import place_planes

RADIUS, SCALLOP, LEAST = 5.0, 0.01, 0.02
LENGTH, WIDTH = 20.0, 14.0  # of the patches, along and across the passes
TURN = 0.3  # of the patches and their passes in the xy-plane, rad


def grid_faces(along, across):
    row = np.arange((along + 1) * (across + 1)).reshape(along + 1, across + 1)
    a, b, c, d = (corner.ravel() for corner in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def turned(s, t, turn):
    return s * math.cos(turn) - t * math.sin(turn), s * math.sin(turn) + t * math.cos(turn)


def patch(height, length=LENGTH, width=WIDTH, size=0.2, turn=TURN, uneven=0.25, seed=5):
    """Mesh of z = height(x, y) over a rectangle whose sides lie along and across the passes."""
    along, across = round(length / size), round(width / size)
    s, t = np.meshgrid(np.linspace(-0.5, 0.5, along + 1) * length, np.linspace(-0.5, 0.5, across + 1) * width, indexing="ij")
    rng = np.random.default_rng(seed)
    s[1:-1, 1:-1] += rng.uniform(-uneven, uneven, s[1:-1, 1:-1].shape) * size
    t[1:-1, 1:-1] += rng.uniform(-uneven, uneven, s[1:-1, 1:-1].shape) * size
    x, y = turned(s, t, turn)
    return from_faces(np.column_stack([x.ravel(), y.ravel(), height(x, y).ravel()]), grid_faces(along, across))


def plane(tilt, toward):
    a, b = math.tan(tilt) * math.cos(toward), math.tan(tilt) * math.sin(toward)
    return lambda x, y: a * x + b * y


def cylinder(radius, axis):
    """Convex for a positive radius, concave for a negative one."""

    def height(x, y):
        v = -math.sin(axis) * x + math.cos(axis) * y
        return math.copysign(1.0, radius) * np.sqrt(radius**2 - v**2)

    return height


def sphere(radius):
    return lambda x, y: math.copysign(1.0, radius) * np.sqrt(radius**2 - x**2 - y**2)


def normals(height, x, y, step=1e-4):
    a = (height(x + step, y) - height(x - step, y)) / (2 * step)
    b = (height(x, y + step) - height(x, y - step)) / (2 * step)
    n = np.stack([-a, -b, np.ones_like(a)], axis=-1)
    return n / np.linalg.norm(n, axis=-1, keepdims=True)


def surface(height, s, t, turn):
    x, y = turned(s, t, turn)
    return np.stack([x, y, height(x, y)], axis=-1)


def smooth_centres(height, offset, length, turn):
    """Ball centres over the smooth surface along one plane, every 0.02 mm."""
    s = np.arange(-0.5 * length, 0.5 * length, 0.02)
    point = surface(height, s, np.full_like(s, offset), turn)
    return point + RADIUS * normals(height, point[:, 0], point[:, 1])


def left_between(height, first, second, centres, length=LENGTH, turn=TURN):
    """Largest distance of the surface between two planes from the nearer pass's centres, less the radius."""
    s, t = np.meshgrid(np.arange(-0.5 * length, 0.5 * length, 0.1), np.linspace(first, second, 43)[1:-1], indexing="ij")
    point = surface(height, s, t, turn).reshape(-1, 3)
    nearest = np.minimum(*(cKDTree(part).query(point)[0] for part in centres))
    return nearest.max() - RADIUS


def some_pairs(offsets, count=4):
    return np.unique(np.linspace(0, len(offsets) - 2, count).round().astype(int))


SURFACES = {f"plane {tilt} deg toward {toward} deg": plane(math.radians(tilt), math.radians(toward))
            for tilt in (0, 20, 45, 60) for toward in (0, 50, 107)}  # fmt: skip
SURFACES |= {f"cylinder {radius} along {axis} deg": cylinder(radius, math.radians(axis))
             for radius in (18, 60, -18, -60) for axis in (17, 60, 107)}  # fmt: skip
SURFACES |= {f"sphere {radius}": sphere(radius) for radius in (18, 60, -18, -60)}


@pytest.mark.parametrize("name", SURFACES)
def test_the_scallop_left_is_nearly_what_was_asked_and_never_more(name):
    height = SURFACES[name]
    offsets, found = place_planes(patch(height), TURN, RADIUS, scallop=SCALLOP, least=LEAST)
    assert not found
    for i in some_pairs(offsets):
        centres = [smooth_centres(height, offsets[k], LENGTH, TURN) for k in (i, i + 1)]
        share = left_between(height, offsets[i], offsets[i + 1], centres) / SCALLOP
        assert 0.8 <= share <= 1.0, (i, share)
