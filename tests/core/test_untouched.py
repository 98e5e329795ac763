# SPDX-License-Identifier: LGPL-2.1-or-later
"""Areas that no pass touches, however they are divided into facets."""

import math

import numpy as np
import pytest
from revolved import solid_of_revolution

from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.passes import Region, untouched
from freecad_fiveaxis.core.passes.untouched import find_untouched
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report import summary, verdict

COLUMNS = 48
TOP, FOOT, HEIGHT = 7.0, 10.0, 9.0


def strips(mesh):
    """The same solid with its flat top (and foot) in strips across it, from rim to rim, in place of fans."""
    ring = np.flatnonzero(np.isclose(np.linalg.norm(mesh.vertex[:, :2], axis=1), TOP))
    up = mesh.normal[:, 2] > 0.9
    ring = ring[np.argsort(np.arctan2(mesh.vertex[ring, 1], mesh.vertex[ring, 0]))]
    low, high, face = 0, len(ring) - 1, []
    while high - low > 1:
        face.append((ring[low], ring[low + 1], ring[high]))
        low += 1
        if high - low > 1:
            face.append((ring[low], ring[high - 1], ring[high]))
            high -= 1
    return from_faces(mesh.vertex, np.concatenate([mesh.face[~up], face]))


def frustum():
    return solid_of_revolution([(0.0, HEIGHT), (TOP, HEIGHT), (FOOT, 0.0), (0.0, 0.0)], COLUMNS)


AREA = 0.5 * COLUMNS * TOP**2 * math.sin(2.0 * math.pi / COLUMNS)
"""mm2 of the top, a polygon."""

SIDE = 0.5 * COLUMNS * 2.0 * (TOP + FOOT) * math.sin(math.pi / COLUMNS) * math.hypot(HEIGHT, (FOOT - TOP) * math.cos(math.pi / COLUMNS))  # fmt: skip
"""mm2 of the side: trapezia."""


def judged(mesh, **options):
    given = {"machine": "trunnion_ac", "cutter": "ball:6", "spindle": "off", "scallop": 0.1, **options}
    figures = job.figures(job.prove(job.make(build_settings("mill", "part", given), mesh=mesh)))
    return figures, summary(figures), verdict(figures, summary(figures))


@pytest.mark.parametrize("divided", [lambda mesh: mesh, strips], ids=["fan", "strips"])
def test_a_round_flat_top_that_no_level_pass_touches_is_not_machined(divided):
    figures, numbers, message = judged(divided(frustum()), passes="zlevel")
    (side,) = [one for one in figures.findings if one.code == "side-not-machined"]
    assert side.value == pytest.approx(AREA, rel=0.01)
    assert numbers["unfinished_share"] == pytest.approx(AREA / (AREA + SIDE), rel=0.01)
    assert message.light.name == "AMBER"


def test_of_a_top_along_the_passes_no_other_cutter_is_requested():
    """Where the ball touches the rim it leaves h at x behind it, (3 + h)^2 = 9 + x^2 + 6 x n, n the level part of
    the side's normal."""
    figures, _, _ = judged(frustum(), passes="zlevel", rest="on")
    (uncut,) = [one for one in figures.findings if one.code == "uncut"]
    above, level = 3.0 + 2.0 * 0.1 + 0.01, HEIGHT / math.hypot(HEIGHT, FOOT - TOP)
    rim = math.sqrt((3.0 * level) ** 2 + above**2 - 9.0) - 3.0 * level
    assert uncut.value == pytest.approx(AREA * (1.0 - rim / TOP) ** 2, rel=0.01)
    assert "cut it with other passes" in uncut.text and "smaller cutter" not in uncut.text


@pytest.mark.oldest
@pytest.mark.thorough
def test_what_is_left_elsewhere_still_asks_for_a_smaller_cutter():
    figures, _, _ = judged(solid_of_revolution([(0.0, 2.0), (4.0, 2.0), (4.0, 8.0), (10.0, 8.0), (10.0, 0.0), (0.0, 0.0)], 24), passes="scallop", rest="on")  # fmt: skip
    (uncut,) = [one for one in figures.findings if one.code == "uncut"]
    assert "smaller cutter" in uncut.text


# --------------------------------------------------------------------------------- places, not facets, are asked


def sheet(height, width=20.0, cells=80):
    """A sheet of small facets over a square; ``height`` of x."""
    x, y = np.meshgrid(np.linspace(0.0, width, cells + 1), np.linspace(0.0, width, cells + 1), indexing="ij")
    row = np.arange(x.size).reshape(x.shape)
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    face = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return from_faces(np.stack([x, y, height(x)], axis=-1).reshape(-1, 3), face)


def left_of(mesh, at, radius=3.0, interval=1.0):
    """Area that passes along Y through the facets at these x leave, mm2."""
    x = mesh.vertex[mesh.face, 0]
    touched = np.zeros(len(x), bool)
    for one in at:
        touched |= (x.min(axis=1) <= one) & (one <= x.max(axis=1))
    rows = find_untouched(Region(mesh, np.ones(len(x), bool), radius, interval), np.flatnonzero(touched))
    return float(mesh.area[rows].sum())


def test_small_facets_between_two_passes_are_swept_and_between_two_far_apart_are_left():
    flat = sheet(lambda x: 0.0 * x)
    near, far = np.arange(0.4, 20.0, 1.0), [*np.arange(0.4, 7.0, 1.0), *np.arange(13.4, 20.0, 1.0)]
    assert left_of(flat, near) == 0.0
    assert left_of(flat, far) == pytest.approx(20.0 * (13.25 - 6.5), rel=0.02)


def test_places_far_from_the_rim_are_left_whether_or_not_they_are_compared_with_it(monkeypatch):
    """In the middle of a disc all of its rim is equally far; the bound of the search changes no answer."""
    mesh = frustum()
    touched = np.flatnonzero(np.abs(mesh.normal[:, 2]) < 0.9)
    region = Region(mesh, np.ones(len(mesh.face), bool), 3.0, 0.4)
    bounded = find_untouched(region, touched)
    query = untouched.scipy.spatial.cKDTree

    class Unbounded(query):
        def query(self, place, k=1, distance_upper_bound=np.inf):
            return super().query(place, k=k)

    monkeypatch.setattr(untouched.scipy.spatial, "cKDTree", Unbounded)
    assert len(bounded) and np.array_equal(bounded, find_untouched(region, touched))


def test_in_a_hollow_a_ball_sweeps_more_between_passes():
    """A groove hardly wider than the ball: passes three intervals apart leave little."""
    groove = sheet(lambda x: 6.0 - np.sqrt(12.0**2 - (x - 10.0) ** 2))
    apart = [1.0, 4.0, 7.0, 10.0, 13.0, 16.0, 19.0]
    assert left_of(groove, apart, radius=11.5) == 0.0
    assert left_of(groove, apart, radius=3.0) > 0.0
