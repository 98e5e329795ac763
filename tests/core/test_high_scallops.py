# SPDX-License-Identifier: LGPL-2.1-or-later
"""What passes leave above the scallop, told from the passes: closed forms on a plane, a cylinder, a cone's tip
and a ridge."""

import math
import re

import numpy as np
import pytest

from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.passes import PassOptions, Region, flat_interval, report_high_scallops, slice_field
from freecad_fiveaxis.core.passes.geodesic import frames
from freecad_fiveaxis.core.passes.high_scallops import _are_near, find_turns, measure_heights

RADIUS, SCALLOP = 3.0, 0.05


def sheet(point):
    """Two facets for each square of points (n, m, 3)."""
    row = np.arange(point.shape[0] * point.shape[1]).reshape(point.shape[:2])
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    face = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return from_faces(point.reshape(-1, 3), face)


def plate(width=10.0, length=8.0, count=41):
    """A level plate from 0 to ``width`` along X and to ``length`` along Y."""
    x, y = np.meshgrid(np.linspace(0, width, count), np.linspace(0, length, 9), indexing="ij")
    return sheet(np.stack([x, y, 0.0 * x], axis=-1))


def reported(mesh, value, levels, scallop=SCALLOP, **options):
    """The findings of passes at ``levels`` of ``value`` (v,)."""
    region = Region(mesh, np.ones(len(mesh.face), bool), RADIUS, flat_interval(RADIUS, scallop))
    contact = slice_field(mesh, value, levels)
    rows = np.arange(len(mesh.face))
    return report_high_scallops(region, PassOptions(scallop=scallop, **options), contact, mesh, rows)


def cusp(half):
    """How near the ball comes to a place on a plane ``half`` mm from its pass: of a cusp so low its height."""
    return math.sqrt(RADIUS**2 + half**2) - RADIUS


def test_two_passes_on_a_plane_leave_the_cusp_between_them():
    mesh, apart = plate(), 1.7
    levels = np.array([0.4, 0.4 + apart, *np.arange(0.4 + apart + 0.9, 9.6, 0.9), 9.6])
    (one,) = reported(mesh, mesh.vertex[:, 0], levels)
    assert one.value == pytest.approx(cusp(0.5 * apart), rel=0.01) and one.limit == SCALLOP
    assert one.place[0] == pytest.approx(0.4 + 0.5 * apart, abs=0.02)
    enough = math.sqrt((RADIUS + 1.02 * SCALLOP) ** 2 - RADIUS**2)  # mm from a pass
    area = float(re.search(r"at least ([\d.]+) mm2", one.text)[1])
    assert area == pytest.approx(8.0 * (apart - 2.0 * enough), rel=0.03)
    assert one.severity is Severity.NOTE


def test_passes_one_step_apart_are_not_worth_a_word_nor_those_by_stepover():
    step = flat_interval(RADIUS, SCALLOP)
    mesh, levels = plate(9.0 * step), (np.arange(9.0) + 0.5) * step
    assert reported(mesh, mesh.vertex[:, 0], levels) == ()
    assert len(reported(mesh, mesh.vertex[:, 0], levels[::2])) == 1
    assert reported(mesh, mesh.vertex[:, 0], levels[::2], stepover=2.0 * step) == ()


def test_lengthwise_passes_on_a_cylinder_leave_the_cusp_of_its_curvature():
    radius, turn = 6.0, math.radians(20.0)
    angle, x = np.meshgrid(np.linspace(-1.2, 1.2, 1201), np.linspace(0, 8, 5), indexing="ij")
    mesh = sheet(np.stack([-x, radius * np.sin(angle), radius * np.cos(angle)], axis=-1)[:, ::-1])
    mesh = mesh if mesh.normal[:, 2].mean() > 0 else from_faces(mesh.vertex, mesh.face[:, ::-1])
    around = np.arctan2(mesh.vertex[:, 1], mesh.vertex[:, 2])
    (one,) = reported(mesh, around, np.arange(-3, 3.5) * turn + 0.5e-3)
    centre, half = radius + RADIUS, 0.5 * turn
    exact = math.sqrt(centre**2 + radius**2 - 2 * centre * radius * math.cos(half)) - RADIUS
    assert one.value == pytest.approx(exact, rel=0.02)


def test_the_tip_of_a_cone_keeps_what_the_innermost_ring_leaves():
    """A ball that follows the ring ``off`` mm down the side stands square on it: the tip is a cusp over the
    plane of that side."""
    slant, off, turns = math.radians(70.0), 1.1, 240
    way, turn = np.meshgrid(np.linspace(0.0, 8.0, 81), np.linspace(0, 2 * np.pi, turns + 1), indexing="ij")
    point = np.stack([way * np.sin(slant) * np.cos(turn), way * np.sin(slant) * np.sin(turn), -way * np.cos(slant)], axis=-1)  # fmt: skip
    corner = point.reshape(-1, 3)
    row = np.arange(len(corner)).reshape(point.shape[:2])
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    face = np.concatenate([np.stack([a, b, c], axis=1)[:], np.stack([a, c, d], axis=1)[turns:]])
    mesh = from_faces(corner, face)
    down = np.linalg.norm(mesh.vertex, axis=1)
    (one,) = reported(mesh, down, np.arange(off, 8.0, 0.8))
    assert one.value == pytest.approx(cusp(off), rel=0.05)
    assert np.linalg.norm(one.place) < 0.1


def test_a_ridge_where_fronts_meet_keeps_more_than_the_scallop_and_no_more_than_the_corner_asks():
    """Passes half and one and a half steps from two sides of a square corner: on the diagonal a place stays
    that is as far from the outer one's sides as from the inner one's corner."""
    step = flat_interval(RADIUS, SCALLOP)
    mesh = plate(7.0 * step, 7.0 * step, 9)
    value = mesh.vertex[:, :2].min(axis=1)
    (one,) = reported(mesh, value, np.array([0.2, *np.arange(0.5, 6.0), 6.2, 6.8]) * step)
    beyond = (
        step * math.sqrt(2.0) / (1.0 + math.sqrt(2.0))
    )  # b from the sides, sqrt 2 (step - b) from the corner
    assert one.value == pytest.approx(cusp(beyond), rel=0.03)
    assert one.place[0] == pytest.approx(one.place[1], abs=0.1)
    assert one.severity is Severity.NOTE


def turning(mesh, value):
    return find_turns(frames(mesh.vertex, mesh.face), mesh, value)


def test_a_field_turns_where_two_fronts_meet_and_nowhere_else():
    mesh = plate(8.0, 8.0, 9)
    assert turning(mesh, mesh.vertex[:, 0] + 0.3 * mesh.vertex[:, 1]).size == 0
    rows = turning(mesh, mesh.vertex[:, :2].min(axis=1))
    x, y, _ = mesh.vertex[mesh.face[rows]].mean(axis=1).T
    assert set(zip(range(8), range(8), strict=True)) <= set(zip(x.astype(int), y.astype(int), strict=True))
    assert np.abs(x - y).max() < 2.5


@pytest.mark.parametrize(("degrees", "turns"), [(20.0, False), (26.0, True)])
def test_fronts_that_meet_nearly_in_one_direction_are_none(degrees, turns):
    half = math.radians(0.5 * degrees)
    mesh = plate(8.0, 8.0, 9)
    x, y = mesh.vertex[:, 0] - 4.0, mesh.vertex[:, 1]
    assert bool(turning(mesh, y * math.cos(half) - np.abs(x) * math.sin(half)).size) == turns


def test_what_no_pass_comes_near_is_no_scallop():
    """Half of the plate has no pass; a step and a half from the last one a place still counts."""
    step = flat_interval(RADIUS, SCALLOP)
    mesh = plate(20.0 * step)
    (one,) = reported(mesh, mesh.vertex[:, 0], (np.arange(10.0) + 0.5) * step)
    assert cusp(1.9 * step) < one.value < cusp(2.0 * step) and one.place[0] < 11.6 * step
    region = Region(mesh, np.ones(len(mesh.face), bool), RADIUS, step)
    contact = slice_field(mesh, mesh.vertex[:, 0], np.array([0.5 * step]))
    assert measure_heights(region, contact, np.array([[19.0 * step, 4.0, 0.0]])).tolist() == [-np.inf]


def test_pieces_far_from_every_place_are_left_out_and_change_nothing():
    mesh = plate(30.0, 8.0, 121)
    region = Region(mesh, np.ones(len(mesh.face), bool), RADIUS, flat_interval(RADIUS, SCALLOP))
    contact = slice_field(mesh, mesh.vertex[:, 0], np.arange(0.35, 30.0, 0.7))
    point = np.array([[3.0, 4.0, 0.0], [3.3, 1.0, 0.0], [21.0, 2.0, 0.0]])
    pieces = (contact.point[::2] + contact.point[1::2]) / 2 + RADIUS * contact.normal[::2]
    height = measure_heights(region, contact, point)
    across = np.abs(point[:, None, 0] - pieces[None, :, 0]).min(axis=1)
    np.testing.assert_allclose(height, np.hypot(RADIUS, across) - RADIUS, atol=1e-9)
    assert _are_near(contact, point, 1.0).sum() < 0.4 * len(pieces)
