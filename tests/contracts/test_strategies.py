# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every tool-axis strategy promises: one unit axis a row, finite, and it moves with the part."""

from functools import lru_cache

import numpy as np
import pytest

from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.orientation.strategies import STRATEGIES, AxisOptions, tool_axes
from freecad_fiveaxis.core.passes import slice_mesh
from freecad_fiveaxis.core.toolpath.coedge import close_gaps

FIXED = np.array([0.3, -0.2, 0.9])
LEANS = [(0.0, 0.0), (0.2, 0.0), (0.0, -0.3), (-0.1, 0.25)]


def turned(angle):
    return np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])


@lru_cache
def path(turn):
    """Passes over a part with hills and hollows, part and passes turned about Z by ``turn`` rad."""
    x, y = np.meshgrid(np.linspace(-20, 20, 18), np.linspace(-20, 20, 18), indexing="ij")
    vertex = np.stack([x, y, 2 * np.sin(x / 6) * np.cos(y / 7) - 0.01 * x * x], axis=-1).reshape(-1, 3)
    row = np.arange(18 * 18).reshape(18, 18)
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    mesh = from_faces(
        vertex @ turned(turn).T, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    )
    contact = slice_mesh(mesh, np.array([-13.1, -4.7, 3.3, 11.9]), 0.2 + turn)
    return close_gaps(contact, mesh, 3.0, 0.05)


@pytest.fixture(params=sorted(STRATEGIES))
def strategy(request):
    return request.param


@pytest.mark.parametrize(("lead", "tilt"), LEANS)
def test_one_finite_unit_axis_a_row(strategy, lead, tilt):
    axis = tool_axes(path(0.0), strategy, AxisOptions(tuple(FIXED), lead, tilt))
    assert axis.shape == path(0.0).point.shape
    assert np.isfinite(axis).all()
    np.testing.assert_allclose(np.linalg.norm(axis, axis=1), 1, atol=1e-14)


@pytest.mark.parametrize(("lead", "tilt"), LEANS)
@pytest.mark.parametrize("turn", [0.7, np.pi / 2, 3.0])
def test_the_axis_moves_with_the_part(strategy, lead, tilt, turn):
    here = tool_axes(path(0.0), strategy, AxisOptions(tuple(FIXED), lead, tilt))
    there = tool_axes(path(turn), strategy, AxisOptions(tuple(turned(turn) @ FIXED), lead, tilt))
    np.testing.assert_allclose(here @ turned(turn).T, there, atol=1e-7)


def test_an_axis_that_stays_behind_is_noticed(strategy):
    here = tool_axes(path(0.0), strategy, AxisOptions(tuple(FIXED)))
    assert np.abs(here @ turned(0.7).T - here).max() > 0.1


def test_the_tool_stands_on_the_side_of_the_part_that_it_cuts(strategy):
    axis = tool_axes(path(0.0), strategy, AxisOptions(through=(0.0, 0.0, -60.0), about=(1.0, 0.0, 0.0)))
    assert ((axis * path(0.0).normal).sum(axis=1) > 0.5).all()


def test_every_strategy_says_in_one_line_what_it_does(strategy):
    assert len((STRATEGIES[strategy].__doc__ or "").splitlines()[0]) > 20
