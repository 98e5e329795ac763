# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool axis face_normal: a level bottom lies on plane faces up to their edges and turns over these on the
spot."""

from dataclasses import replace

import numpy as np
import pytest
from offset_examples import prism

from freecad_fiveaxis.core.geometry.mesh import from_faces, write_stl
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.orientation.strategies import AxisOptions, tool_axes
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.collision_avoidance import compute_allowed_rest
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.cl_offset import SHARP, hub_positions
from freecad_fiveaxis.core.toolpath.cl_path import Motion
from freecad_fiveaxis.core.toolpath.coedge import close_gaps

MESH = from_faces([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
SIZE = np.array((20.0, 16.0, 12.0))
SIDES = ((0, 0, 1), (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0))


def offset(profile, skew=(0.0, 1.0, 0.0)):
    return close_gaps(prism(profile, skew), MESH, SHARP, 0.01)


def axes(path, strategy, ring=3.0):
    return tool_axes(path, strategy, AxisOptions(ring=ring))


@pytest.mark.parametrize("skew", [(0.0, 1.0, 0.0), (0.5, 1.0, 0.0), (-2.0, 1.0, 0.0)])
def test_over_a_sharp_edge_the_tool_turns_from_one_normal_to_the_other(skew):
    path = offset([(0, 0), (10, 0), (10, -10), (0, -10)], skew)
    axis = axes(path, "face_normal")
    np.testing.assert_allclose(axis, path.normal, atol=1e-12)
    turned = np.abs(np.diff(axis, axis=0)).max(axis=1) > 0.1
    assert np.count_nonzero(turned) >= 4
    assert path.fill[1:][turned].all()
    assert np.abs(axis - axes(path, "facet_mean")).max() > 0.5


@pytest.mark.parametrize("profile", [
    [(10 * np.sin(a), 10 * np.cos(a)) for a in np.radians(np.arange(-60, 61, 2))],  # one smooth surface
    [(0, 0), (10, 0), (10, 10), (20, 10)][:3],  # an inside corner
])  # fmt: skip
def test_elsewhere_it_is_the_mean(profile):
    path = offset(profile)
    np.testing.assert_array_equal(axes(path, "face_normal"), axes(path, "facet_mean"))


def test_a_bottom_that_stands_square_has_its_middle_over_the_contact():
    """So it sweeps both faces up to the edge, turns there on the spot, and reaches the middle of a narrow
    loop. Another strategy touches with its foremost point."""
    path = replace(offset([(0, 0), (10, 0), (10, -10)]), middle=True)
    axis = axes(path, "face_normal")
    np.testing.assert_allclose(hub_positions(path, axis, 3.0), path.centre, atol=1e-12)
    foremost = hub_positions(replace(path, middle=False), axis, 3.0)
    np.testing.assert_allclose(np.linalg.norm(foremost - path.centre, axis=1), 3.0, atol=1e-12)
    leaned = hub_positions(path, tool_axes(path, "face_normal", AxisOptions(lead=0.1, ring=3.0)), 3.0)
    np.testing.assert_allclose(np.linalg.norm(leaned - path.centre, axis=1), 3.0, atol=1e-12)


# ------------------------------------------------------------------------------------------ a box, through it all


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    corner = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (0, 1)]) * SIZE
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    face = [(a, b, c) for a, b, c, d in quads] + [(a, c, d) for a, b, c, d in quads]
    name = tmp_path_factory.mktemp("box") / "box.stl"
    write_stl(from_faces(corner, np.array(face)), name)
    return str(name)


@pytest.fixture(scope="module")
def milled(box):
    result = {}

    def mill(cutter, **options):
        key = (cutter, *options.items())
        if key not in result:
            given = {"machine": "trunnion_ac", "cutter": cutter, "scallop": 0.02, **options}
            result[key] = job.make(build_settings("mill", box, given))
        return result[key]

    return mill


def walk(result, share=12):
    """Tips and axes along the real way of every block that cuts, ``share`` poses a block."""
    q, motion = words_to_q(result.program.words), result.program.motion
    cuts = np.flatnonzero(np.isin(motion[1:], (Motion.CUT, Motion.FILL)))
    u = np.linspace(0.0, 1.0, share)[None, :, None]
    pose = q[cuts][:, None] + u * (q[cuts + 1] - q[cuts])[:, None]
    return forward(result.kinematics, pose.reshape(-1, 5))


def find_left(result, radius):
    """What (k,) mm stays over samples of all faces of the box but its bottom: over each the lowest of the
    discs of ``radius`` mm that are the level part of the cutter's bottom; below 0: the part is entered."""
    tip, axis = walk(result)
    left = []
    for normal in np.array(SIDES, float):
        middle = 0.5 * SIZE * normal + (0.0, 0.0, 6.0)
        across = [one for one in np.eye(3) if abs(one @ normal) < 0.5]
        grid = np.meshgrid(
            *(np.linspace(-1.0, 1.0, 41) * (0.5 * SIZE @ one - 0.05) for one in across), indexing="ij"
        )
        place = middle + sum(part.reshape(-1, 1) * one for part, one in zip(grid, across, strict=True))
        over = np.flatnonzero(axis @ normal > 0.1)
        height = ((tip[over] * axis[over]).sum(axis=1) - place @ axis[over].T) / (axis[over] @ normal)
        off = place[:, None] + height[:, :, None] * normal - tip[over]
        left.append(np.where(np.linalg.norm(off, axis=2) <= radius, height, np.inf).min(axis=1))
    return np.concatenate(left)


@pytest.mark.parametrize(("cutter", "radius", "rise"), [
    ("flat:6", 3.0, 0.0), ("bull:8:1", 3.2, 1.0 - np.sqrt(1.0 - 0.2**2)),
])  # fmt: skip
@pytest.mark.parametrize("strategy", ["auto", "face_normal"])
def test_on_a_box_plane_faces_are_finished_up_to_their_edges(cutter, radius, rise, strategy, milled):
    """By dense samples of the real way; of a corner that part counts that rises by ``rise`` mm."""
    result = milled(cutter) if strategy == "face_normal" else milled(cutter, tool_axis=strategy)
    assert result.settings.tool_axis.tool_axis == strategy
    left = find_left(result, radius)
    allowed = compute_allowed_rest(result.settings, result.mesh, result.keep)
    assert np.mean(left + rise > allowed) < 1e-3
    assert left.min() > -result.settings.proof.tolerance
    assert not [one for one in result.findings if one.code in ("overcut", "lifted")]


@pytest.mark.thorough
@pytest.mark.oldest
def test_the_mean_of_the_normals_would_leave_much_of_them(milled):
    result = milled("flat:6", tool_axis="facet_mean")
    left = find_left(result, 3.0)
    assert np.mean(left > compute_allowed_rest(result.settings, result.mesh, result.keep)) > 0.2


@pytest.mark.thorough
def test_a_bull_nose_that_leans_freely_leaves_no_more_than_its_scallops(box):
    given = {"machine": "trunnion_ac", "cutter": "bull:6:1", "tool_axis": "auto", "scallop": 0.02}
    result = job.run(build_settings("mill", box, {**given, "rest": "on"}))
    assert "uncut" not in [one.code for one in result.findings]


@pytest.mark.slow
@pytest.mark.parametrize("cutter", ["flat:6", "bull:8:1"])
def test_on_a_blade_hardly_anything_stays(cutter, parts):
    """Facets between two passes that the bottom sweeps do not count as left out."""
    given = {"machine": "trunnion_ac", "cutter": cutter, "scallop": 0.02}
    result = job.make(build_settings("mill", str(parts / "blade.stl"), given))
    found = {one.code: one for one in result.findings}
    assert "side-not-machined" not in found
    assert "overcut" not in found
    assert found["uncut"].value < 2e-3 * float(result.mesh.area[result.keep].sum())
