# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example parts: closed, outward, of the volume that their formula gives, and the same every time."""

import importlib.util
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from freecad_fiveaxis.core.geometry.mesh import from_faces, read_stl

SCRIPT = Path(__file__).parents[2] / "resources" / "examples" / "make_parts.py"
spec = importlib.util.spec_from_file_location("make_parts", SCRIPT)
parts = importlib.util.module_from_spec(spec)
spec.loader.exec_module(parts)

CLOSED = ("dome", "blade", "saddle", "half_cylinder")


def volume(vertex, face):
    a, b, c = (vertex[face[:, k]] for k in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def dome_volume():
    height = 40 * (1 - math.cos(math.radians(60)))
    return math.pi * height**2 * (3 * 40 - height) / 3 + math.pi * (40 * math.sin(math.radians(60))) ** 2 * 10


def blade_volume():
    x = np.linspace(0, 1, 10001)
    lens = 2 / 3 * (44 - 16 * x) * (7 - 4 * x)  # both sides a parabola
    return 100 * np.mean(0.5 * (lens[1:] + lens[:-1]))


VOLUME = {
    "dome": dome_volume(),
    "blade": blade_volume(),
    "saddle": 80 * 60 * (20 + (80**2 - 60**2) / 12 / 160),
    "half_cylinder": 0.5 * math.pi * 60**2 * 80,
}


@pytest.mark.parametrize("name", CLOSED)
def test_solids_are_closed_and_wound_outward(name):
    vertex, face = parts.PARTS[name]()
    edge = np.concatenate([face[:, [0, 1]], face[:, [1, 2]], face[:, [2, 0]]])
    assert len(np.unique(edge, axis=0)) == len(edge)
    assert {tuple(e) for e in edge.tolist()} == {tuple(e) for e in edge[:, ::-1].tolist()}
    mesh = from_faces(vertex, face)
    assert not mesh.findings and len(mesh.face) == len(face)


@pytest.mark.parametrize("name", CLOSED)
def test_solids_have_the_volume_of_their_formula(name):
    assert volume(*parts.PARTS[name]()) == pytest.approx(VOLUME[name], rel=2e-3)


@pytest.mark.parametrize("name", CLOSED)
def test_solids_stand_on_the_work_zero(name):
    vertex, _ = parts.PARTS[name]()
    assert vertex[:, 2].min() == pytest.approx(0.0, abs=1e-9)
    np.testing.assert_allclose(vertex[:, :2].max(axis=0), -vertex[:, :2].min(axis=0), atol=1e-9)


def test_the_dome_has_a_vertex_at_the_pole():
    vertex, _ = parts.dome()
    top = vertex[np.argmax(vertex[:, 2])]
    np.testing.assert_allclose(top, (0, 0, 30), atol=1e-12)
    cap = vertex[vertex[:, 2] > 10 + 1e-9]
    np.testing.assert_allclose(np.linalg.norm(cap - (0, 0, -10), axis=1), 40.0)


def test_the_half_cylinder_is_round_and_takes_another_radius():
    vertex, face = parts.half_cylinder(radius=60.0, facets=9)
    np.testing.assert_allclose(np.hypot(vertex[:, 1], vertex[:, 2]), 60.0)
    assert len(face) == 2 * 9 + 2 * 8 + 2
    assert volume(*parts.half_cylinder(radius=20.0)) == pytest.approx(VOLUME["half_cylinder"] / 9, rel=2e-3)


def test_half_of_the_blade_and_the_tops_of_the_others_can_be_seen_from_above():
    for name in CLOSED:
        vertex, face = parts.PARTS[name]()
        mesh = from_faces(vertex, face)
        shadow = (
            np.abs(
                np.cross(vertex[face[:, 1]] - vertex[face[:, 0]], vertex[face[:, 2]] - vertex[face[:, 0]])[
                    :, 2
                ]
            )
            / 2
        )
        up = mesh.normal[:, 2] > 0
        assert shadow[up].sum() == pytest.approx(shadow[~up].sum(), rel=1e-6)
        assert shadow[up].sum() > 2000


def test_the_freeform_part_has_233_uneven_facets_that_all_look_up():
    vertex, face = parts.freeform_233()
    mesh = from_faces(vertex, face)
    assert len(face) == len(mesh.face) == 233
    assert mesh.normal[:, 2].min() > 0.6
    area = (
        np.linalg.norm(
            np.cross(vertex[face[:, 1]] - vertex[face[:, 0]], vertex[face[:, 2]] - vertex[face[:, 0]]), axis=1
        )
        / 2
    )
    assert area.max() > 5 * area.min()
    plan = area * mesh.normal[:, 2]
    assert plan.sum() == pytest.approx(100 * 60)  # no gap, no overlap
    np.testing.assert_allclose(np.ptp(vertex, axis=0), (100, 60, 22.4), atol=0.2)
    assert [finding.code for finding in mesh.findings] == ["open-shell"]
    border = mesh.coedge_vertex[mesh.coedge_face[:, 1] < 0]
    np.testing.assert_array_equal(np.bincount(border.ravel())[np.unique(border)], 2)  # one closed border


@pytest.mark.parametrize("name", parts.PARTS)
def test_parts_are_the_same_every_time(name):
    for one, other in zip(parts.PARTS[name](), parts.PARTS[name](), strict=True):
        np.testing.assert_array_equal(one, other)


def test_the_script_writes_every_part_as_stl(tmp_path):
    folder = tmp_path / "new" / "parts"
    done = subprocess.run(
        [sys.executable, str(SCRIPT), str(folder)], capture_output=True, text=True, timeout=60, cwd=tmp_path
    )
    assert done.returncode == 0, done.stderr
    assert sorted(path.stem for path in folder.glob("*.stl")) == sorted(parts.PARTS)
    mesh = read_stl(folder / "dome.stl")
    assert len(mesh.face) == len(parts.dome()[1])


def test_the_script_without_a_folder_says_how_it_is_used():
    done = subprocess.run([sys.executable, str(SCRIPT)], capture_output=True, text=True, timeout=60)
    assert done.returncode == 1 and "usage" in done.stderr
