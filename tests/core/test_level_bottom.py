# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flat and bull nose cutters with free axes: level where that is free, else along walls; beside a wall the
bottom slides, in a hollow it is raised; passes are as far apart as the cutter is wide where it stands so."""

import numpy as np
import pytest
from test_face_normal import walk

from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import from_faces, write_stl
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.orientation.axis_field import Freedom, Nodes
from freecad_fiveaxis.core.orientation.facets_with_axis import AxisField
from freecad_fiveaxis.core.orientation.level_bottom import prefer_level, stand_level
from freecad_fiveaxis.core.orientation.raised_contacts import raise_contacts
from freecad_fiveaxis.core.orientation.slide_bottoms import slide_bottoms
from freecad_fiveaxis.core.orientation.spacing_by_facet import space_by_facet
from freecad_fiveaxis.core.passes.geodesic import frames, scallop_metric, step_across
from freecad_fiveaxis.core.passes.spacing_tool import SpacingTool
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.tool import parse_cutter

UP = np.array((0.0, 0.0, 1.0))
INNER, DEEP, OUTER = (14.0, 10.0), 6.0, (24.0, 20.0, 10.0)


def pocket(inner=INNER, deep=DEEP, outer=OUTER):
    """A block, its middle at X 0 Y 0, on Z 0, with a rectangular pocket from above."""

    def ring(size, z):
        x, y = 0.5 * size[0], 0.5 * size[1]
        return [(-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z)]

    top = outer[2]
    corner = np.array([*ring(outer, 0), *ring(outer, top), *ring(inner, top), *ring(inner, top - deep)])
    quads = [(0, 3, 2, 1), (12, 13, 14, 15)]
    for k in range(4):
        after = (k + 1) % 4
        quads += [(k, after, 4 + after, 4 + k), (4 + k, 4 + after, 8 + after, 8 + k)]
        quads += [(8 + k, 8 + after, 12 + after, 12 + k)]
    face = [part for a, b, c, d in quads for part in ((a, b, c), (a, c, d))]
    return from_faces(corner, np.array(face))


def bowl(radius=20.0, size=12.0, count=25):
    """A spherical hollow over a square, lowest at X 0 Y 0 Z 0."""
    x = np.linspace(-size, size, count)
    place = np.stack(np.meshgrid(x, x), axis=-1).reshape(-1, 2)
    z = radius - np.sqrt(radius**2 - (place**2).sum(axis=1))
    at = np.arange(count * count).reshape(count, count)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, 1:].ravel(), at[1:, :-1].ravel()
    face = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return from_faces(np.column_stack([place, z]), face)


def reach(cutter="flat:6", **more):
    return Reacher(parse_cutter(cutter), limit=0.01, **more)


# ------------------------------------------------------------------------------------------ sliding, raising


@pytest.mark.parametrize(("place", "end"), [
    ((0.0, 0.0), (0.0, 0.0)), ((6.0, 0.0), (4.0, 0.0)), ((0.0, -4.5), (0.0, -2.0)), ((5.0, 1.0), (4.0, 1.0)),
])  # fmt: skip
def test_a_bottom_slides_from_a_wall_as_far_as_it_must(place, end):
    """A flat of 6 on the floor of a pocket of 14 x 10: its middle is 3 mm from each wall then."""
    tree, stand = facet_tree(pocket()), np.array([(*place, OUTER[2] - DEEP)])
    slide = slide_bottoms(reach(), tree, stand, UP[None])
    least = float(np.linalg.norm(np.subtract(end, place)))
    assert least - 0.02 <= np.linalg.norm(slide) <= 1.05 * least + 0.06
    assert (np.abs(stand + slide)[0, :2] < 0.5 * np.array(INNER) - 2.98).all()
    assert slide[0, 2] == 0.0


def test_in_a_corner_it_slides_from_both_walls():
    tree, stand = facet_tree(pocket()), np.array([(6.0, 4.0, OUTER[2] - DEEP)])
    x, y, _ = (stand + slide_bottoms(reach(), tree, stand, UP[None]))[0]
    assert (x, y) == (pytest.approx(4.0, abs=0.06), pytest.approx(2.0, abs=0.06))


@pytest.mark.parametrize("cutter", ["flat:12", "bull:12:1"])
def test_where_no_way_leads_out_it_stays(cutter):
    tree, stand = facet_tree(pocket()), np.array([(6.0, 0.0, OUTER[2] - DEEP)])
    np.testing.assert_array_equal(slide_bottoms(reach(cutter), tree, stand, UP[None]), 0.0)


def test_it_does_not_slide_off_what_it_is_to_cut():
    """On the rim between pocket and outside it stands free as it is; slid over the pocket it would cut
    nothing."""
    tree = facet_tree(pocket())
    stand = np.array([(9.5, 0.0, OUTER[2])])
    np.testing.assert_array_equal(slide_bottoms(reach(), tree, stand, UP[None]), 0.0)


def test_in_a_hollow_a_level_bottom_is_raised_by_its_sagitta():
    mesh, stand = bowl(), np.array([(0.0, 0.0, 0.0)])
    raised, fits = raise_contacts(reach("flat:4"), facet_tree(mesh), stand, UP[None])
    assert raised[0, 2] == pytest.approx(20.0 - np.sqrt(20.0**2 - 2.0**2), abs=0.02)
    assert fits.all()
    deep, _ = raise_contacts(reach("flat:16"), facet_tree(mesh), stand, UP[None])
    np.testing.assert_array_equal(deep, stand)  # 1.7 mm: nothing is finished there, so it stays


# ------------------------------------------------------------------------------------------ axes


def test_axes_turn_level_or_along_the_wall_or_stay():
    lean = np.radians([0.0, 30.0, 44.0, 50.0, 59.0, 61.0, 80.0, 95.0])
    axis = np.column_stack([np.sin(lean), np.zeros(len(lean)), np.cos(lean)])
    found = np.degrees(np.arccos(np.clip(stand_level(axis, np.tile(UP, (len(lean), 1)))[:, 2], -1.0, 1.0)))
    np.testing.assert_allclose(found, [0.0, 0.0, 0.0, 50.0, 59.0, 90.0, 90.0, 90.0], atol=1e-5)


def test_where_a_level_or_a_flank_axis_is_free_no_other_is_left():
    direction = np.array([(0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.6, 0.0, 0.8)])
    freedom = Freedom(direction, np.array([[0, 1, 1], [0, 0, 1], [0, 0, 1]], bool), np.array([0, 0, 1], bool),
        np.zeros(3, int))  # fmt: skip
    preferred, good = prefer_level(freedom, np.tile(UP, (3, 1)))
    np.testing.assert_array_equal(good, [True, False, True])
    np.testing.assert_array_equal(preferred.free, [[0, 1, 0], [0, 0, 1], [0, 0, 0]])


# ------------------------------------------------------------------------------------------ spacing


def field_of(mesh, axis):
    middle = mesh.vertex[mesh.face].mean(axis=1)
    count = len(middle)
    nodes = Nodes(middle, np.arange(count), mesh.normal, middle, np.ones(count, bool), 5.0)
    freedom = Freedom(UP[None], np.ones((count, 1), bool), np.ones(count, bool), np.zeros(count, int))
    return AxisField(nodes, freedom, np.tile(np.asarray(axis, float), (count, 1)))


PLATE = from_faces([[0, 0, 0], [20, 0, 0], [20, 20, 0], [0, 20, 0]], [[0, 1, 2], [0, 2, 3]])


def test_a_leaned_ring_is_as_bent_as_its_torus():
    """By a second route: the radius at which the shadow of the leaned cutter rises by the scallop."""
    lean, cutter = np.radians(50.0), parse_cutter("bull:8:1")
    axis = np.array((np.sin(lean), 0.0, np.cos(lean)))
    tool = space_by_facet(field_of(PLATE, axis), cutter, PLATE, np.ones(2, bool), 200.0, 0.02)
    assert tool is not None
    np.testing.assert_allclose(tool.radius, 1.0)
    np.testing.assert_allclose(tool.soft, 1.0 + 3.0 / np.sin(lean))
    np.testing.assert_allclose(np.abs(tool.way), np.tile((0.0, 1.0, 0.0), (2, 1)), atol=1e-12)
    for side, radius in ((0, tool.radius[0]), (1, tool.soft[0])):
        across = np.eye(3)[side]
        shadow = cutter.equivalent_radius(UP[None], axis[None], across[None], 1e-4, 0.0)
        assert float(shadow[0]) == pytest.approx(radius, rel=0.02)


def test_level_everywhere_needs_no_spacing_by_facet():
    keep = np.ones(2, bool)
    assert space_by_facet(field_of(PLATE, UP), parse_cutter("flat:6"), PLATE, keep, 200.0, 0.02) is None


def test_along_a_wall_the_side_is_as_bent_as_the_cutter():
    keep, axis = np.ones(2, bool), (1.0, 0.0, 0.0)
    tool = space_by_facet(field_of(PLATE, axis), parse_cutter("flat:6"), PLATE, keep, 200.0, 0.02)
    np.testing.assert_allclose(tool.radius, 3.0)
    np.testing.assert_allclose(tool.soft, 200.0)
    np.testing.assert_allclose(np.abs(tool.way), np.tile(axis, (2, 1)))


@pytest.mark.parametrize("turn", [0.0, 0.4, 1.3])
def test_steps_are_those_of_a_ball_on_the_hard_way_and_of_a_wider_one_on_the_soft_way(turn):
    soft = np.array((np.cos(turn), np.sin(turn), 0.0))
    tool = SpacingTool(np.full(2, 1.0), np.full(2, 4.0), np.tile(soft, (2, 1)))
    frame, rows = frames(PLATE.vertex, PLATE.face), np.arange(2)
    metric = scallop_metric(frame, tool.bends(rows), tool.radius, np.full(2, 0.4), tool.least(rows))
    for way, step in ((soft, 0.8), (np.cross(UP, soft), 0.4)):
        slope = np.array([frame.one @ way, frame.two @ way])
        np.testing.assert_allclose(step_across(metric, slope), step)


def test_other_passes_are_as_close_as_all_but_little_of_the_surface_needs():
    tool = SpacingTool(np.array([1.0, 9.0, 9.0]), np.array([2.0, 9.0, 50.0]), np.zeros((3, 3)))
    assert tool.narrowest(np.array([1.0, 60.0, 39.0])) == 9.0
    assert tool.narrowest(np.array([3.0, 60.0, 37.0])) == 2.0


# ------------------------------------------------------------------------------------------ a pocket, through it all


def share_finished(result, radius, within=0.05):
    """Of floor and walls of the pocket, but for what no round tool gets to in its upright edges: the share
    over which the cylinder of the cutter passes no farther than ``within`` mm."""
    tip, axis = walk(result, 8)
    (x, y), floor = 0.5 * np.array(INNER), OUTER[2] - DEEP
    room = radius - np.sqrt(radius**2 - (radius - within) ** 2) if within < radius else 0.0
    wide = [np.linspace(-half + radius, half - radius, 25) for half in (x, y)]
    high = np.linspace(floor + 0.3, OUTER[2] - 0.3, 12)
    place, out = [], []
    for sign in (-1.0, 1.0):
        for along, z in ((a, b) for a in wide[0] for b in high):
            place.append((along, sign * y, z)), out.append((0.0, -sign, 0.0))
        for along, z in ((a, b) for a in wide[1] for b in high):
            place.append((sign * x, along, z)), out.append((-sign, 0.0, 0.0))
    for a in np.linspace(-x + room, x - room, 25):
        for b in np.linspace(-y + room, y - room, 25):
            if min(x - abs(a), y - abs(b)) > radius or max(x - abs(a), y - abs(b)) > radius:
                place.append((a, b, floor)), out.append(UP)
    point = np.array(place) + within * np.array(out)
    done = np.zeros(len(point), bool)
    for first in range(0, len(tip), 4000):
        some = slice(first, first + 4000)
        off = point[:, None] - tip[some]
        up = (off * axis[some]).sum(axis=2)
        done |= ((up > -1e-6) & (np.linalg.norm(off - up[..., None] * axis[some], axis=2) < radius)).any(
            axis=1
        )
    return done.mean()


@pytest.fixture(scope="module")
def pocket_file(tmp_path_factory):
    name = tmp_path_factory.mktemp("pocket") / "pocket.stl"
    write_stl(pocket(), name)
    return str(name)


def mill_pocket(name, **options):
    given = {"machine": "trunnion_ac", "cutter": "flat:4", "scallop": 0.02, "tool_length": 120, **options}
    return job.make(build_settings("mill", name, given))


@pytest.mark.thorough
def test_a_pocket_is_finished_with_free_axes_and_not_on_its_normals(pocket_file):
    free = mill_pocket(pocket_file, tool_axis="auto")
    assert share_finished(free, 2.0) > 0.99
    assert not [one.code for one in free.findings if one.code in ("overcut", "rapid-collision")]
    normal = mill_pocket(pocket_file, tool_axis="face_normal")
    assert share_finished(normal, 2.0) < 0.9
