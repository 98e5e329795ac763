# SPDX-License-Identifier: LGPL-2.1-or-later
"""The barrel cutter: its flank in closed form, its body against dense samples, and its texts there and
back."""

import math

import numpy as np
import pytest
from gouge_examples import dense_points, sampled_depth, shelf
from scipy.spatial import cKDTree

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.gouge.obstacles import Obstacle, Reacher, obstacles, tip_at
from freecad_fiveaxis.core.gouge.search import find_entries
from freecad_fiveaxis.core.gouge.swept_motion import straight_motion
from freecad_fiveaxis.core.nc.named_cutter import find_named_cutter
from freecad_fiveaxis.core.tool import Cutter, cutter_name, cutter_text, kind_of, parse_cutter
from freecad_fiveaxis.core.tool.body import body_of, body_support, depth_of, grow_body, swing_support, way_out
from freecad_fiveaxis.core.toolpath.apt import read_cl_file, write_apt
from freecad_fiveaxis.core.toolpath.apt.head import ClHead, cutter_note
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

TEXT = "barrel:10:85:2:50"
FLANK, TIP, LENGTH, WIDE = 85.0, 2.0, 50.0, 5.0
RING = WIDE - FLANK
CREST = TIP + math.sqrt((FLANK - TIP) ** 2 - RING**2)
"""mm above the tip: the height of the largest diameter, and of the arc's middle."""
BEGINS = math.asin(-RING / (FLANK - TIP))
UP = np.array([[0.0, 0.0, 1.0]])


def barrel():
    return parse_cutter(TEXT)


def on_flank(angle):
    """The arc by its own parameter: distance from the axis, and height, where its outward normal leans
    ``angle`` rad from straight down."""
    return RING + FLANK * np.sin(angle), CREST - FLANK * np.cos(angle)


def outline(points=4000):
    """Points (n, 2) of the whole outline, by its sizes alone."""
    ball, arc = np.linspace(0.0, BEGINS, points), np.linspace(BEGINS, 0.5 * math.pi, points)
    tip = np.stack([TIP * np.sin(ball), TIP - TIP * np.cos(ball)], axis=1)
    side = np.stack([np.full(points, WIDE), np.linspace(CREST, LENGTH, points)], axis=1)
    top = np.stack([np.linspace(WIDE, 0.0, points), np.full(points, LENGTH)], axis=1)
    return np.concatenate([tip, np.stack(on_flank(arc), axis=1), side, top])


def truly_inside(radius, height):
    by_arc = (radius - RING) ** 2 + (height - CREST) ** 2 < FLANK**2
    leaves = TIP - TIP * math.cos(BEGINS)
    by_ball = radius**2 + (height - TIP) ** 2 < TIP**2
    low, middle = height < leaves, (height >= leaves) & (height < CREST)
    return np.where(low, by_ball, np.where(middle, by_arc, (radius < WIDE) & (height < LENGTH)))


def poses(count, least, most, seed=1):
    """Contacts, normals, axes that lean between two angles from them, and feeds."""
    rng = np.random.default_rng(seed)
    normal, side, feed = (v / np.linalg.norm(v, axis=1)[:, None] for v in rng.normal(size=(3, count, 3)))
    side -= np.einsum("ij,ij->i", side, normal)[:, None] * normal
    side /= np.linalg.norm(side, axis=1)[:, None]
    angle = rng.uniform(least, most, count)[:, None]
    return (
        rng.uniform(-9.0, 9.0, (count, 3)),
        normal,
        np.cos(angle) * normal + np.sin(angle) * side,
        feed,
        angle[:, 0],
    )


# ------------------------------------------------------------------------------------------------ its shape


def test_the_flank_touches_the_ball_at_its_tip_and_ends_upright_at_the_diameter():
    radius, height = on_flank(BEGINS)
    assert math.hypot(radius, height - TIP) == pytest.approx(TIP) and on_flank(0.5 * math.pi)[
        0
    ] == pytest.approx(WIDE)
    assert (
        math.degrees(barrel().barrel.begins)
        == pytest.approx(math.degrees(BEGINS))
        == pytest.approx(74.54, abs=0.01)
    )
    assert barrel().barrel.rise + TIP == pytest.approx(CREST)


def test_on_the_flank_it_touches_where_the_arc_says():
    """The contact seen from the tip is the arc's point whose outward normal is the surface's turned round."""
    point, normal, axis, feed, angle = poses(300, BEGINS, 0.5 * math.pi - 1e-4)
    tip = barrel().tip_from_contact(point, normal, axis, feed)
    arm = point - tip
    height = np.einsum("ij,ij->i", arm, axis)
    radius = np.linalg.norm(arm - height[:, None] * axis, axis=1)
    wanted = on_flank(angle)
    np.testing.assert_allclose(radius, wanted[0], atol=1e-10)
    np.testing.assert_allclose(height, wanted[1], atol=1e-10)
    np.testing.assert_allclose(tip_at(barrel(), point, normal, axis), tip, atol=1e-12)
    ball = Cutter(2 * TIP, LENGTH).tip_from_contact(point, normal, axis, feed)
    assert np.linalg.norm(ball - tip, axis=1).max() > 5.0, "this comparison sees the ball at its tip"


@pytest.mark.parametrize(("least", "most"), [(0.0, BEGINS), (BEGINS, 0.5 * math.pi)])
def test_it_touches_the_plane_and_nothing_of_it_is_below(least, most):
    point, normal, axis, feed, _ = poses(200, least + 1e-6, most - 1e-6, 2)
    tip = barrel().tip_from_contact(point, normal, axis, feed)
    along = np.einsum("ij,ij->i", normal, axis)
    height = np.einsum("ij,ij->i", tip - point, normal)
    lowest = np.min([z * along - r * np.sqrt(1.0 - along**2) for r, z in outline()[::7]], axis=0)
    np.testing.assert_allclose(height + lowest, 0.0, atol=2e-4)
    np.testing.assert_allclose(height, body_support(body_of(barrel()), -along), atol=1e-9)


def test_below_its_arc_it_is_the_ball_at_its_tip():
    point, normal, axis, feed, _ = poses(200, 0.0, BEGINS - 1e-6, 3)
    small = Cutter(2 * TIP, LENGTH)
    tips = (cutter.tip_from_contact(point, normal, axis, feed) for cutter in (barrel(), small))
    np.testing.assert_allclose(*tips, atol=1e-12)
    across = np.cross(normal, feed)
    np.testing.assert_allclose(barrel().effective_radius(normal, axis, across), TIP)


# ------------------------------------------------------------------------------------------------ its body


def test_its_body_is_what_its_outline_holds_and_its_depth_is_the_distance_from_it():
    rng = np.random.default_rng(4)
    radius, height = rng.uniform(0.0, 8.0, 4000), rng.uniform(-3.0, LENGTH + 3.0, 4000)
    place = np.stack([radius, np.zeros_like(radius), height], axis=1)
    depth = depth_of(body_of(barrel()), np.zeros(3), UP[0], place)
    assert ((depth > 0.0) == truly_inside(radius, height)).all()
    apart = cKDTree(outline(40_000)).query(np.stack([radius, height], axis=1))[0]
    upper = height > LENGTH - TIP  # the end is rounded off there, and a cylinder of its own
    np.testing.assert_allclose(np.abs(depth)[~upper], apart[~upper], atol=5e-4)
    ball = depth_of(body_of(Cutter(10.0, LENGTH)), np.zeros(3), UP[0], place)
    assert np.abs(ball - depth).max() > 0.5, "this comparison sees a ball end mill"


@pytest.mark.parametrize("by", [0.0, 0.7])
def test_its_outline_in_every_direction_is_that_of_its_points(by):
    along = np.linspace(-1.0, 1.0, 401)
    r, z = outline()[:, :1], outline()[:, 1:]
    supports = z * along + r * np.sqrt(1.0 - along**2)
    np.testing.assert_allclose(
        body_support(grow_body(body_of(barrel()), by), along), supports.max(axis=0) + by, atol=1e-5
    )
    swung = np.maximum.accumulate(supports.max(axis=0))
    np.testing.assert_allclose(swing_support(body_of(barrel()), along), swung, atol=1e-3)


@pytest.mark.parametrize("by", [0.0, 0.7])
def test_the_way_out_of_it_is_to_its_underside(by):
    radius = np.linspace(0.0, 7.0, 200)
    points = np.stack([radius, np.zeros(200), np.full(200, 30.0)], axis=1)
    got = 30.0 - way_out(body_of(barrel()), np.zeros((200, 3)), np.repeat(UP, 200, axis=0), points, by)
    r, z = outline().T
    inside = np.abs(r - radius[:, None]) <= by
    under = np.where(inside, z - np.sqrt(np.maximum(by**2 - (r - radius[:, None]) ** 2, 0.0)), np.inf).min(
        axis=1
    )
    if by == 0.0:
        falls = z <= CREST
        under = np.where(radius <= WIDE, np.interp(radius, r[falls], z[falls]), 30.0)
    np.testing.assert_allclose(got, np.minimum(under, 30.0), atol=0.03)


def test_a_body_within_its_length_and_its_flank_alone():
    """A barrel that ends at its largest diameter has no cylinder."""
    short = Cutter(10.0, CREST, corner=TIP, flank=FLANK)
    assert len(body_of(short).pieces) == 1 and short.profile().flanks[-1][2] == pytest.approx(CREST)
    rows = barrel().profile().flanks
    np.testing.assert_allclose((rows[:-1, 3] - RING) ** 2 + (rows[:-1, 2] - CREST) ** 2, FLANK**2)
    middle = 0.5 * (rows[:-1, :2] + rows[:-1, 2:])
    assert (FLANK - np.hypot(middle[:-1, 1] - RING, middle[:-1, 0] - CREST) < 1e-3).all()


def test_its_entries_are_those_of_dense_samples():
    """No sample is deeper than the bound, and the deepest sample is as deep as what is found."""
    mesh, rng = shelf(length=24.0), np.random.default_rng(5)
    points, count = dense_points(mesh, 0.4), 8
    tip = np.stack(
        [rng.uniform(-8.0, 8.0, count), rng.uniform(-12.0, 6.0, count), rng.uniform(-1.0, 8.0, count)], axis=1
    )
    axis = UP + np.stack([*rng.uniform(-0.6, 0.6, (2, count)), np.zeros(count)], axis=1)
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    swept, body = straight_motion(tip, axis), body_of(barrel())
    found = find_entries(body, facet_tree(mesh), swept, 0.01)
    sampled = np.array([sampled_depth(body, points, swept, block) for block in range(count - 1)])
    assert (sampled <= found.bound + 1e-9).all() and (sampled > 0.5).any()
    np.testing.assert_allclose(found.depth, sampled, atol=0.2)  # as near as points and poses lie
    as_ball = find_entries(body_of(Cutter(10.0, LENGTH)), facet_tree(mesh), swept, 0.01)
    assert np.abs(as_ball.depth - sampled).max() > 0.5, "this comparison sees another body"


def test_a_wall_beside_the_flank_is_found_by_the_body():
    """On the floor before the shelf's wall: an axis that leans away from it is free, one that leans into it
    enters."""
    at, lean = np.array([[0.0, -20.0, 0.0]] * 2), math.radians(80.0)
    axis = np.array([[0.0, -math.sin(lean), math.cos(lean)], [0.0, math.sin(lean), math.cos(lean)]])
    met = obstacles(Reacher(barrel()), facet_tree(shelf()), at, np.repeat(UP, 2, axis=0), axis)
    assert met[0] == Obstacle.NONE and met[1] != Obstacle.NONE


# ------------------------------------------------------------------------------------------- how wide it cuts


def test_across_a_pass_its_flank_cuts_with_its_own_radius():
    """Tilted, the arc lies across the pass; led, the pass runs along the arc, and what cuts is the flank's
    round, (R + e / sin)."""
    _, normal, axis, _, angle = poses(100, BEGINS + 1e-3, 0.5 * math.pi, 6)
    across = axis - np.einsum("ij,ij->i", axis, normal)[:, None] * normal
    np.testing.assert_allclose(barrel().effective_radius(normal, axis, across), FLANK)
    along = np.cross(normal, across)
    np.testing.assert_allclose(barrel().effective_radius(normal, axis, along), FLANK + RING / np.sin(angle))


@pytest.mark.parametrize("height", [0.002, 0.01, 0.05])
def test_the_ball_as_wide_as_its_flank_is_the_flank(height):
    lean = barrel().barrel.middle
    axis = np.array([[math.sin(lean), 0.0, math.cos(lean)]])
    radius = barrel().equivalent_radius(UP, axis, np.array([[1.0, 0.0, 0.0]]), height)[0]
    assert radius == pytest.approx(FLANK, rel=5e-3)
    assert Cutter(10.0).equivalent_radius(UP, axis, np.array([[1.0, 0.0, 0.0]]), height)[0] == pytest.approx(
        5.0, rel=5e-3
    )


def test_the_scallop_between_two_tilted_passes_is_that_of_the_flank():
    """By dense points of the sweep: passes s apart leave s^2 / 8 R, where balls of the same diameter leave 17
    times as much."""
    lean, apart = barrel().barrel.middle, 2.0
    axis = np.array([math.sin(lean), 0.0, math.cos(lean)])
    heights = np.linspace(0.0, 0.02, 2001)
    tips = barrel().tip_from_contact(
        np.array([[0.0, 0, 0], [apart, 0, 0]]), np.repeat(UP, 2, axis=0), np.array([axis] * 2), UP
    )
    middle = np.stack([np.full_like(heights, 0.5 * apart), np.zeros_like(heights), heights], axis=1)
    cut = np.max([depth_of(body_of(barrel()), tip, axis, middle) for tip in tips], axis=0)
    left = heights[np.flatnonzero(cut >= 0.0)[0]]
    assert left == pytest.approx(apart**2 / (8.0 * FLANK), rel=5e-3)
    assert apart**2 / (8.0 * WIDE) == pytest.approx(17.0 * left, rel=5e-3)


# ------------------------------------------------------------------------------------------------ its texts


@pytest.mark.parametrize(
    ("text", "sizes"),
    [("barrel:10:85:2", (10.0, 85.0, 2.0, 50.0)), (" Barrel:0.5in:80mm:3:6cm ", (12.7, 80.0, 3.0, 60.0)),
     ("barrel:4:1in:0.5", (4.0, 25.4, 0.5, 50.0))],
)  # fmt: skip
def test_it_is_read_with_its_units_and_comes_back_from_its_text(text, sizes):
    cutter = parse_cutter(text)
    assert (cutter.diameter, cutter.flank, cutter.corner, cutter.length) == pytest.approx(sizes)
    assert (
        parse_cutter(cutter_text(cutter)) == cutter
        and cutter_text(cutter).startswith("barrel:")
        and kind_of(cutter) == "barrel"
    )


@pytest.mark.parametrize(
    ("text", "why"),
    [("barrel:10:85", "KIND:DIAMETER:FLANK:CORNER"), ("barrel:10:5:2", "flank radius is 5 mm; give more than 5 mm"),
     ("barrel:10:20000:2", "at most 10000 mm"), ("barrel:10:85:5", "corner radius is 5 mm; a barrel has a ball"),
     ("barrel:10:85:0", "corner radius is 0 mm; a barrel has a ball"), ("barrel:10:85:-1", "corner radius is -1 mm"),
     ("barrel:10:500:1", "its flank ends 64.0"), ("barrel:10:85:2:20", "give a longer cutter or a smaller flank radius"),
     ("barrel:10:wide:2", "cutter flank")],
)  # fmt: skip
def test_a_barrel_that_cannot_be_is_refused_with_the_reason(text, why):
    with pytest.raises(SettingsError, match=why):
        parse_cutter(text)


def test_a_barrel_has_neither_taper_nor_neck():
    for sizes, why in (({"taper": 0.1}, "it has no taper"), ({"neck": 3.0}, "only a ball without a taper")):
        with pytest.raises(SettingsError, match=why):
            Cutter(10.0, corner=TIP, flank=FLANK, **sizes)


def test_the_command_line_refuses_it_in_one_line(capsys, tmp_path):
    assert cli.main(["mill", "part.stl", "--cutter", "barrel:10:4:2", "-o", str(tmp_path / "x.ngc")]) == 2
    error = capsys.readouterr().err.strip()
    assert error.count("\n") == 0 and "flank radius is 4 mm" in error and not list(tmp_path.iterdir())


def cl_file(cutter):
    none, one = np.zeros(1, np.int64), np.zeros((1, 3))
    path = CLPath(one, UP, np.zeros(1, np.int8), np.full(1, 500.0), one, UP, none, none, none)
    return write_apt(path, cutter, "A", head=ClHead(tool=1))


@pytest.mark.parametrize("text", ["barrel:10:85:2:60", "barrel:0.5in:80:3.25", "bull:10:2"])
def test_a_cl_file_brings_it_back_with_its_flank(text):
    cutter, written = parse_cutter(text), cl_file(parse_cutter(text))
    got = read_cl_file(written.decode()).head.cutter
    assert (got.diameter, got.corner, got.flank) == (cutter.diameter, cutter.corner, cutter.flank)
    assert (b"PPRINT/FLANK," in written) == (cutter.flank is not None)
    if cutter.flank is not None:
        assert got == cutter
        others = read_cl_file(written.decode().replace("PPRINT/FLANK,", "PPRINT/FLANK ")).head.cutter
        assert others == Cutter(cutter.diameter, corner=cutter.corner), (
            "to whom the mark is text, it is a bull nose"
        )


def test_another_flank_than_the_cl_files_is_reported():
    head = read_cl_file(cl_file(barrel()).decode()).head
    assert [one.code for one in cutter_note(head, parse_cutter("bull:10:2"))] == ["cutter-differs"]
    assert [one.code for one in cutter_note(head, parse_cutter("barrel:10:80:2"))] == ["cutter-differs"]
    assert cutter_note(head, barrel()) == ()


def test_the_head_of_a_program_names_it_and_an_audit_reads_it():
    cutter = parse_cutter("barrel:10:85:2")
    assert cutter_name(cutter) == "barrel 10 mm, corner 2 mm, flank 85 mm"
    assert find_named_cutter(b"(T3 BARREL 10 MM, CORNER 2 MM, FLANK 85 MM, L 120.000)\n") == cutter
    assert find_named_cutter(b"(T3 BARREL 10 MM, CORNER 2 MM, L 120.000)\n") is None
