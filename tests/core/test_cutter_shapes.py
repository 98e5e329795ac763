# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutters of every shape touch what they cut, at their contact and nowhere deeper; proven on bodies of
points."""

from functools import cache

import numpy as np
import pytest
from cutter_body import body, meridian, placed, support

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.orientation.strategies import lean_axis
from freecad_fiveaxis.core.tool import Cutter, cutter_name, cutter_text, parse_cutter
from freecad_fiveaxis.core.tool.contact import ring_direction
from freecad_fiveaxis.core.tool.silhouette import width_at

SHAPES = (
    "ball:10",
    "flat:10",
    "bull:10:2",
    "bull:8:0.05",
    "taperball:6:5deg:30",
    "taperbull:10:2:10deg:25",
    "taperbull:6:0:3deg:20",
)
NEAR = 1e-4
"""mm: what the issue asks for."""


@cache
def fine_body(shape):
    """A body as dense as its width is to be measured, put together once for each shape."""
    return body(parse_cutter(shape), 1500, arc=200, flank=400)


def stands(leads, tilts, seed=3):
    """Contacts, normals, axes and feeds of a tool that stands with every lead and tilt (deg) on planes of any
    direction."""
    rng = np.random.default_rng(seed)
    lead, tilt = (np.radians(part).ravel() for part in np.meshgrid(leads, tilts))
    normal = rng.normal(size=(len(lead), 3))
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    feed = np.cross(normal, rng.normal(size=(len(lead), 3)))
    feed /= np.linalg.norm(feed, axis=1)[:, None]
    axis = np.concatenate(
        [lean_axis(n[None], f[None], a, b) for n, f, a, b in zip(normal, feed, lead, tilt, strict=True)]
    )
    return rng.uniform(-50, 50, (len(lead), 3)), normal, axis, feed


@pytest.mark.parametrize("shape", SHAPES)
def test_the_cutter_touches_its_facet_for_every_lead_and_tilt(shape):
    """The lowest of all points of the body is on the facet's plane, and the contact is on the body."""
    cutter = parse_cutter(shape)
    points = body(cutter, 720, arc=240)
    rows = stands((0, 5, 30), (0, 30))
    for contact, normal, axis, tip in zip(*rows[:3], cutter.tip_from_contact(*rows), strict=True):
        frame = placed(
            np.eye(3), np.zeros(3), axis
        )  # the normal as the body sees it: cheaper than to place all of its points
        height = points @ (frame @ normal) + (tip - contact) @ normal
        assert -NEAR <= height.min() <= NEAR
        lowest = placed(points[height < height.min() + 2 * NEAR], tip, axis)
        assert np.linalg.norm(lowest - contact, axis=1).min() < 0.05  # as near as the points stand


@pytest.mark.parametrize("shape", SHAPES)
def test_the_same_for_many_stands_by_the_farthest_point_of_each_circle(shape):
    cutter = parse_cutter(shape)
    rows, outline = stands(np.linspace(0, 30, 13), np.linspace(-30, 30, 11)), meridian(cutter, arc=1500)
    for contact, normal, axis, tip in zip(*rows[:3], cutter.tip_from_contact(*rows), strict=True):
        assert -NEAR <= (tip - contact) @ normal - support(outline, axis, -normal[None])[0] <= NEAR


def test_a_tip_beside_its_place_would_be_noticed():
    cutter = parse_cutter("bull:10:2")
    contact, normal, axis, feed = stands((5,), (0,))
    tip = cutter.tip_from_contact(contact, normal, axis, feed) - 2e-4 * normal
    assert ((placed(body(cutter), tip[0], axis[0]) - contact[0]) @ normal[0]).min() < -NEAR


@pytest.mark.parametrize("shape", ["flat:10", "bull:10:2", "taperbull:6:0:3deg:20"])
def test_square_on_the_surface_the_contact_is_the_foremost_point_of_the_bottom(shape):
    cutter = parse_cutter(shape)
    contact, normal, axis, feed = stands((0,), (0,))
    tip = cutter.tip_from_contact(contact, normal, axis, feed)
    np.testing.assert_allclose(tip, contact - cutter.ring * feed, atol=1e-12)
    leaning = lean_axis(normal, feed, 1e-3, 0.0)
    np.testing.assert_allclose(cutter.tip_from_contact(contact, normal, leaning, feed), tip, atol=0.02)
    a_hair = lean_axis(normal, feed, 0.0, 1e-6)  # less than what makes a difference in a word's last digit
    np.testing.assert_allclose(cutter.tip_from_contact(contact, normal, a_hair, feed), tip, atol=1e-4)


def test_noise_of_the_normal_does_not_throw_a_level_bottom_about():
    """The axis is within rounding of the normal: whichever way, the hub stays."""
    rng = np.random.default_rng(5)
    axis = np.array([[0.0, 0.0, 1.0]]).repeat(200, 0)
    normal = axis + 1e-6 * rng.normal(size=axis.shape)
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    feed = np.array([[1.0, 0.0, 0.0]]).repeat(200, 0)
    np.testing.assert_allclose(ring_direction(normal, axis, feed, 5.0), -feed, atol=1e-9)


def test_a_feed_along_the_axis_still_gives_a_place():
    axis = np.array([[0.0, 0.6, 0.8]])
    out = ring_direction(axis, axis, axis, 4.0)
    assert np.linalg.norm(out) == pytest.approx(1.0) and abs(out @ axis.T) < 1e-12


@pytest.mark.parametrize("shape", ["taperball:6:5deg:30", "taperbull:10:2:10deg:25"])
def test_beyond_its_flank_a_tapered_cutter_touches_with_its_rim(shape):
    cutter = parse_cutter(shape)
    points = body(cutter)
    for angle in (-0.4, 0.4):
        beyond = 90 - np.degrees(cutter.taper) + angle
        contact, normal, axis, feed = stands((beyond,), (0,))
        tip = cutter.tip_from_contact(contact, normal, axis, feed)
        height = (placed(points, tip[0], axis[0]) - contact[0]) @ normal[0]
        assert -NEAR <= height.min() <= NEAR
        assert (np.linalg.norm(tip - contact) > 20) == (angle > 0)


def test_a_ball_stands_as_it_always_did():
    contact, normal, axis, feed = stands((0, 5, 30), (0, 30))
    ball = Cutter(10.0)
    centre = contact + 5.0 * normal
    np.testing.assert_allclose(
        ball.tip_from_contact(contact, normal, axis, feed), ball.tip_at(centre, axis), atol=1e-14
    )
    assert ball.ring == 0.0 and ball.corner == ball.radius == 5.0


# ------------------------------------------------------------------------------------------- how wide it cuts


@pytest.mark.parametrize("shape", ["ball:10", "flat:10", "bull:10:2", "taperbull:10:2:10deg:25"])
@pytest.mark.parametrize(("lead", "tilt"), [(3, 0), (10, 0), (30, 0), (0, 10), (8, 4), (20, 25)])
def test_the_effective_radius_is_the_curvature_of_the_body_seen_along_the_feed(shape, lead, tilt):
    """Radius of curvature of a plane curve from its support function h: h + h''."""
    cutter = parse_cutter(shape)
    _, normal, axis, feed = stands((lead,), (tilt,))
    across, step = np.cross(normal, feed), 2e-3
    angle = step * np.arange(-1, 2)[:, None]
    h = support(meridian(cutter, arc=100_001), axis[0], -np.cos(angle) * normal + np.sin(angle) * across)
    radius = h[1] + (h[0] - 2 * h[1] + h[2]) / step**2
    if cutter.corner == 0.0 and tilt:  # the sharp corner of a flat: the rest is that of its ring
        assert radius == pytest.approx(cutter.effective_radius(normal, axis, across)[0], rel=2e-3, abs=2e-3)
    assert cutter.effective_radius(normal, axis, across)[0] == pytest.approx(radius, rel=2e-3, abs=2e-3)


def test_known_effective_radii():
    bull, up, x, y = parse_cutter("bull:10:2"), *np.eye(3)[[2, 0, 1], None]
    lead = lean_axis(up, x, np.radians(5), 0.0)
    assert bull.effective_radius(up, lead, y)[0] == pytest.approx(3 / np.sin(np.radians(5)) + 2)
    assert bull.effective_radius(up, lead, x)[0] == pytest.approx(2)
    assert bull.effective_radius(up, up, y)[0] == np.inf
    assert Cutter(10.0).effective_radius(up, up, y)[0] == 5.0
    assert Cutter(10.0).equivalent_radius(up, lead, y, 0.01)[0] == pytest.approx(5.0, rel=3e-4)


@pytest.mark.parametrize("shape", ["ball:10", "flat:10", "bull:10:2", "taperbull:10:2:10deg:25"])
@pytest.mark.parametrize(("lead", "tilt"), [(0, 0), (3, 0), (30, 0), (0, 10), (0, 45), (8, 4)])
def test_the_width_is_that_of_the_body_seen_along_the_feed(shape, lead, tilt):
    cutter = parse_cutter(shape)
    _, normal, axis, feed = stands((lead,), (tilt,))
    across = np.cross(normal, feed)
    frame = placed(
        np.eye(3), np.zeros(3), axis[0]
    )  # the two directions as the body sees them: cheaper than to place its points
    above, beside = (fine_body(shape) @ (frame @ np.stack([normal[0], across[0]], axis=1))).T
    for height in (0.02, 0.3):
        seen = beside[above <= above.min() + height]
        got = width_at(normal, axis, across, height, cutter.hub_discs())[0]
        assert seen.max() - seen.min() == pytest.approx(got, rel=0.03, abs=0.08)


def test_no_part_of_the_sweep_below_the_scallop_is_outside_the_equivalent_ball():
    for shape in ("bull:10:2", "flat:10"):
        cutter = parse_cutter(shape)
        _, normal, axis, feed = stands((5,), (0,))
        across = np.cross(normal, feed)
        radius = cutter.equivalent_radius(normal, axis, across, 0.02)[0]
        for height in (0.001, 0.005, 0.01, 0.019):
            half = 0.5 * width_at(normal, axis, across, height, cutter.hub_discs())[0]
            assert half >= np.sqrt(height * (2 * radius - height)) - 1e-6


# -------------------------------------------------------------------------------------------- sizes and texts


@pytest.mark.parametrize("shape", SHAPES)
def test_the_profile_is_the_body(shape):
    """Rounds and flanks have the outline that the sizes make."""
    cutter = parse_cutter(shape)
    rounds, flanks, holder = cutter.profile()
    (ring, corner, height), (low, r0, high, r1) = rounds[0], flanks[0]
    radius, z = meridian(cutter).T
    on_round = np.abs(np.hypot(np.maximum(radius - ring, 0), height - z) - corner) < 1e-9
    on_flank = (z >= low - 1e-9) & (np.abs(radius - (r0 + (z - low) * (r1 - r0) / (high - low))) < 1e-9)
    assert (on_round | on_flank).all() and high == cutter.length and r1 == pytest.approx(cutter.top_radius)
    assert holder.shape == (0, 4)
    assert np.hypot(np.maximum(r0 - ring, 0), low - height) == pytest.approx(corner)


def test_the_holder_is_kept_apart():
    row = (50.0, 3.0, 80.0, 12.0)
    assert Cutter(6.0, holder=(row,)).profile().holder.tolist() == [list(row)]
    for bad in (
        (50.0, 3.0, 50.0, 4.0),
        (50.0, -1.0, 60.0, 4.0),
        (-1.0, 1.0, 2.0, 1.0),
        (0.0, 1.0, float("nan"), 1.0),
    ):
        with pytest.raises(SettingsError, match="is no cone"):
            Cutter(6.0, holder=(bad,))


@pytest.mark.parametrize("shape", SHAPES)
def test_a_cutter_comes_back_from_its_text(shape):
    cutter = parse_cutter(shape)
    assert parse_cutter(cutter_text(cutter)) == cutter
    assert cutter_text(cutter).startswith(shape.partition(":")[0] + ":")


@pytest.mark.parametrize(
    ("text", "sizes"),
    [("flat:0.5in", (12.7, 50, 0, 0)), ("bull:10:2:60", (10, 60, 2, 0)), (" TaperBall:6:5 ", (6, 50, 3, 5)),
     ("taperbull:10mm:1mm:0.1rad:2in", (10, 50.8, 1, np.degrees(0.1))), ("bull:10:5", (10, 50, 5, 0)), ("taperball:6:0", (6, 50, 3, 0))],
)  # fmt: skip
def test_sizes_are_read_with_their_units(text, sizes):
    cutter = parse_cutter(text)
    assert (cutter.diameter, cutter.length, cutter.corner, np.degrees(cutter.taper)) == pytest.approx(sizes)


@pytest.mark.parametrize(
    ("text", "why"),
    [("bull:10:6", "corner radius is 6 mm; give 0 to 5 mm"), ("bull:10:-1", "corner radius is -1"), ("bull:10", "KIND:DIAMETER:CORNER"),
     ("taperball:6:-5deg", "taper is -5 deg; give 0 to 60"), ("taperball:6:80", "taper is 80 deg"), ("flat:0", "diameter is 0 mm"),
     ("taperball:6:5deg:0", "length is 0 mm"), ("taperball:6:5deg:2", "begins 2.7"), ("taperbull:10:2:5deg:1.5", "longer cutter"),
     ("taperball:6:60deg:9000", "wide"), ("taperball:6", "KIND:DIAMETER:TAPER"), ("flat:10:20:30", "needs KIND:DIAMETER"),
     ("bull:10:2mm:3deg", "cutter length"), ("taperball:6:5mm", "cutter taper"), ("bull:10:inf", "corner")],
)  # fmt: skip
def test_a_cutter_that_cannot_be_is_refused_with_the_reason(text, why):
    with pytest.raises(SettingsError, match=why):
        parse_cutter(text)


def test_the_machinist_reads_what_to_take():
    assert cutter_name(parse_cutter("ball:10")) == "ball 10 mm"
    assert cutter_name(parse_cutter("flat:12.7")) == "flat 12.7 mm"
    assert cutter_name(parse_cutter("bull:10:2")) == "bull 10 mm, corner 2 mm"
    assert cutter_name(parse_cutter("taperball:6:5deg")) == "taper ball 6 mm, 5 deg"
    assert cutter_name(parse_cutter("taperbull:10:2:5deg")) == "taper bull 10 mm, corner 2 mm, 5 deg"
