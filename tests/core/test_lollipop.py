# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lollipop, a ball on a thinner neck: its outline in closed form, what it gets under, and its texts there
and back."""

import math

import numpy as np
import pytest
from gouge_examples import dense_points, sampled_depth, shelf
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.gouge.obstacles import Obstacle, Reacher, obstacles, stick_out_farther
from freecad_fiveaxis.core.gouge.search import find_entries
from freecad_fiveaxis.core.gouge.swept_motion import straight_motion
from freecad_fiveaxis.core.nc.named_cutter import find_named_cutter
from freecad_fiveaxis.core.studies import reach_map as reach_map_module
from freecad_fiveaxis.core.studies.reach_map import reach_map
from freecad_fiveaxis.core.tool import Cutter, cutter_name, cutter_text, parse_cutter
from freecad_fiveaxis.core.tool.body import SHANK, body_of, body_support, depth_of
from freecad_fiveaxis.core.toolpath.apt import read_cl_file, write_apt
from freecad_fiveaxis.core.toolpath.apt.head import ClHead, cutter_note
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

TEXT = "lollipop:10:4:40"
RADIUS, NECK, LENGTH = 5.0, 2.0, 40.0
UP = np.array([[0.0, 0.0, 1.0]])


def lollipop():
    return parse_cutter(TEXT)


def truly_inside(radius, height):
    """Whether points are in the ball or in the neck above it, by their sizes alone."""
    in_ball = radius**2 + (height - RADIUS) ** 2 < RADIUS**2
    return in_ball | ((radius < NECK) & (height > RADIUS) & (height < LENGTH))


def overlaps(cutter, point, normal, axis, mesh):
    return Obstacle(int(obstacles(Reacher(cutter), facet_tree(mesh), point, normal, axis)[0]))


# ------------------------------------------------------------------------------------------------ its shape


def test_its_outline_in_every_direction_is_that_of_a_ball_and_a_disc():
    """The support from the tip: the ball's R + R a, the upper rim's h a + r sqrt(1 - a^2)."""
    along = np.linspace(-1.0, 1.0, 201)
    across = np.sqrt(1.0 - along**2)
    begins = RADIUS + math.sqrt(RADIUS**2 - NECK**2)
    neck = np.maximum(LENGTH * along + NECK * across, begins * along + NECK * across)
    np.testing.assert_allclose(
        body_support(body_of(lollipop()), along), np.maximum(RADIUS + RADIUS * along, neck), atol=1e-12
    )


def test_its_body_is_the_ball_and_the_neck_and_a_ball_end_mills_is_not():
    rng = np.random.default_rng(1)
    radius, height = rng.uniform(0.0, 6.0, 20_000), rng.uniform(-1.0, 42.0, 20_000)
    place = np.stack([radius, np.zeros_like(radius), height], axis=1)
    depth = depth_of(body_of(lollipop()), np.zeros(3), UP[0], place)
    assert ((depth > 0.0) == truly_inside(radius, height)).all()
    ball = depth_of(body_of(Cutter(10.0, LENGTH)), np.zeros(3), UP[0], place)
    assert ((ball > 0.0) != truly_inside(radius, height)).mean() > 0.2, (
        "this comparison sees a shank as wide as the ball"
    )


def test_the_neck_does_not_cut():
    ball, neck = body_of(lollipop()).pieces
    assert neck.part == SHANK and ball.part != SHANK
    assert (
        lollipop().profile().holder.tolist() == [[neck.low, NECK, LENGTH, NECK]]
        and len(lollipop().profile().flanks) == 0
    )


def test_it_stands_and_cuts_as_a_ball_does():
    rng = np.random.default_rng(2)
    normal, axis, feed = (v / np.linalg.norm(v, axis=1)[:, None] for v in rng.normal(size=(3, 200, 3)))
    some = np.einsum("ij,ij->i", normal, axis) > 0.0
    normal, axis, feed, point = normal[some], axis[some], feed[some], rng.uniform(-9.0, 9.0, (some.sum(), 3))
    ball = Cutter(10.0, LENGTH)
    stands = lollipop().tip_from_contact(point, normal, axis, feed)
    np.testing.assert_array_equal(stands, ball.tip_from_contact(point, normal, axis, feed))
    across = np.cross(normal, feed)
    np.testing.assert_array_equal(
        lollipop().effective_radius(normal, axis, across), ball.effective_radius(normal, axis, across)
    )
    assert lollipop().equivalent_radius(UP, UP, np.eye(3)[:1], 0.01)[0] == pytest.approx(RADIUS, rel=3e-4)


@pytest.mark.parametrize(("below", "ball_touches"), [(0.0, True), (30.0, True), (66.0, True), (67.0, False)])
def test_below_the_surface_it_touches_with_its_ball_as_far_as_its_neck_lets_it(below, ball_touches):
    """The neck leaves the ball where sin = neck / diameter: 90 - 23.578 = 66.42 deg above its equator."""
    assert math.degrees(lollipop().undercut) == pytest.approx(66.42, abs=0.01)
    lean = math.radians(90.0 + below)
    axis = np.array([[math.sin(lean), 0.0, math.cos(lean)]])
    tip = lollipop().tip_from_contact(np.zeros((1, 3)), UP, axis, np.array([[0.0, 1.0, 0.0]]))
    assert np.allclose(tip + RADIUS * axis, RADIUS * UP) == ball_touches


# ----------------------------------------------------------------------------------------- what it gets under


def test_it_cuts_beside_a_roof_that_the_shank_of_a_ball_would_hit():
    """Floor at z 0, roof from y 0 on between z 12 and 16: 3 mm before its edge the ball's shank of 5 mm
    enters, the neck of 2 does not; with its middle 1 mm before the edge the neck enters, too."""
    mesh, at = shelf(), np.array([[0.0, -3.0, 0.0]])
    assert overlaps(Cutter(10.0, LENGTH), at, UP, UP, mesh) == Obstacle.CUTTER
    assert overlaps(lollipop(), at, UP, UP, mesh) == Obstacle.NONE
    assert overlaps(lollipop(), at + (0.0, 2.0, 0.0), UP, UP, mesh) == Obstacle.SHANK
    drawn_out = Reacher(lollipop(), far=50.0)
    assert obstacles(drawn_out, facet_tree(mesh), at, UP, UP)[0] != Obstacle.NONE, (
        "its ball does not get out through the roof"
    )


def test_it_cuts_the_underside_of_a_roof_from_before_its_edge():
    """The axis leans 45 deg away from the roof: it looks 45 deg below the surface that is cut."""
    at, down, axis = np.array([[0.0, 1.0, 12.0]]), -UP, np.array([[0.0, -math.sqrt(0.5), math.sqrt(0.5)]])
    assert overlaps(lollipop(), at, down, axis, shelf()) == Obstacle.NONE
    assert overlaps(Cutter(10.0, LENGTH), at, down, axis, shelf()) == Obstacle.CUTTER


@some_in_core("text", [TEXT, "lollipop:6:5:30"])
def test_its_entries_are_those_of_dense_samples(text):
    """No sample is deeper than the bound, and the deepest sample is as deep as what is found."""
    cutter, mesh, rng = parse_cutter(text), shelf(length=24.0), np.random.default_rng(4)
    points, count, tolerance = dense_points(mesh, 0.4), 8, 0.01
    tip = np.stack(
        [rng.uniform(-8.0, 8.0, count), rng.uniform(-12.0, 6.0, count), rng.uniform(-1.0, 8.0, count)], axis=1
    )
    axis = UP + np.stack([*rng.uniform(-0.4, 0.4, (2, count)), np.zeros(count)], axis=1)
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    swept, body = straight_motion(tip, axis), body_of(cutter)
    found = find_entries(body, facet_tree(mesh), swept, tolerance)
    sampled = np.array([sampled_depth(body, points, swept, block) for block in range(count - 1)])
    assert (sampled <= found.bound + 1e-9).all() and (sampled > 0.5).any()
    np.testing.assert_allclose(found.depth, sampled, atol=0.2)  # as near as points and poses lie
    as_ball = find_entries(
        body_of(Cutter(cutter.diameter, cutter.length)), facet_tree(mesh), swept, tolerance
    )
    assert np.abs(as_ball.depth - sampled).max() > 0.5, "this comparison sees another body"


@pytest.mark.oldest
@pytest.mark.thorough
def test_a_reach_map_knows_that_it_gets_farther_under_a_roof(monkeypatch):
    monkeypatch.setattr(reach_map_module, "PLACES", 1500)

    def reached(cutter, most, height):
        found = reach_map(shelf(), Reacher(cutter, most=math.radians(most)))
        x, y, z = found.point.T
        return y[np.isclose(z, height) & (np.abs(x) < 10.0) & (found.obstacle == Obstacle.NONE)]

    ball, thin = Cutter(8.0, LENGTH), Cutter(8.0, LENGTH, neck=3.0)
    assert reached(thin, 20.0, 0.0).max() > reached(ball, 20.0, 0.0).max() + 1.0
    assert not len(reached(ball, 45.0, 12.0)) and reached(thin, 45.0, 12.0).max() > 1.0


# ------------------------------------------------------------------------------------------------ its texts


@pytest.mark.parametrize(
    ("text", "sizes"),
    [
        ("lollipop:10:6", (10.0, 6.0, 50.0)),
        (" Lollipop:0.5in:6mm:4cm ", (12.7, 6.0, 40.0)),
        ("lollipop:4:0.1in", (4.0, 2.54, 50.0)),
    ],
)
def test_it_is_read_with_its_units_and_comes_back_from_its_text(text, sizes):
    cutter = parse_cutter(text)
    assert (cutter.diameter, cutter.neck, cutter.length) == pytest.approx(sizes)
    assert parse_cutter(cutter_text(cutter)) == cutter and cutter_text(cutter).startswith("lollipop:")


@pytest.mark.parametrize(
    ("text", "why"),
    [("lollipop:10", "KIND:DIAMETER:NECK"), ("lollipop:10:0", "neck is 0 mm; give 0.001 mm or more, and less than 10 mm"),
     ("lollipop:10:10", "neck is 10 mm"), ("lollipop:10:0.5in", "neck is 12.7 mm"), ("lollipop:10:-2", "neck is -2 mm"),
     ("lollipop:10:6:9", "length is 9 mm, the neck begins 9 mm above the tip; give a longer cutter"),
     ("lollipop:10:5deg", "cutter neck"), ("lollipop:10:wide", "cutter neck")],
)  # fmt: skip
def test_a_lollipop_that_cannot_be_is_refused_with_the_reason(text, why):
    with pytest.raises(SettingsError, match=why):
        parse_cutter(text)
    for sizes in ({"corner": 1.0}, {"taper": 0.1}):
        with pytest.raises(SettingsError, match="only a ball without a taper"):
            Cutter(10.0, neck=6.0, **sizes)


def test_the_command_line_refuses_it_in_one_line(capsys, tmp_path):
    assert cli.main(["mill", "part.stl", "--cutter", "lollipop:10:10", "-o", str(tmp_path / "x.ngc")]) == 2
    error = capsys.readouterr().err.strip()
    assert error.count("\n") == 0 and "neck is 10 mm" in error and not list(tmp_path.iterdir())


def cl_file(cutter):
    none, one = np.zeros(1, np.int64), np.zeros((1, 3))
    path = CLPath(one, UP, np.zeros(1, np.int8), np.full(1, 500.0), one, UP, none, none, none)
    return write_apt(path, cutter, "A", head=ClHead(tool=1))


@pytest.mark.parametrize("text", ["lollipop:10:6:60", "lollipop:0.5in:3.25", "ball:10", "bull:10:2"])
def test_a_cl_file_brings_it_back_with_its_neck(text):
    cutter, written = parse_cutter(text), cl_file(parse_cutter(text))
    got = read_cl_file(written.decode()).head.cutter
    assert (got.diameter, got.corner, got.neck) == (cutter.diameter, cutter.corner, cutter.neck)
    assert (b"PPRINT/NECK," in written) == (cutter.neck is not None)
    if cutter.neck is not None:
        assert got == cutter
        others = read_cl_file(written.decode().replace("PPRINT/NECK,", "PPRINT/NECK ")).head.cutter
        assert others == Cutter(cutter.diameter), "to whom the mark is text, it is a ball"


def test_a_neck_thicker_than_the_cl_files_is_reported():
    head = read_cl_file(cl_file(parse_cutter("lollipop:10:6")).decode()).head
    assert [one.code for one in cutter_note(head, Cutter(10.0))] == ["cutter-differs"]
    assert [one.code for one in cutter_note(head, parse_cutter("lollipop:10:7"))] == ["cutter-differs"]
    assert (
        cutter_note(head, parse_cutter("lollipop:10:5"))
        == cutter_note(head, parse_cutter("lollipop:10:6"))
        == ()
    )


def test_the_head_of_a_program_names_it_and_an_audit_reads_it():
    cutter = parse_cutter("lollipop:10:6")
    assert cutter_name(cutter) == "lollipop 10 mm, neck 6 mm"
    assert find_named_cutter(b"(T3 LOLLIPOP 10 MM, NECK 6 MM, L 120.000)\n") == cutter
    assert find_named_cutter(b"(T3 LOLLIPOP 10 MM, L 120.000)\n") is None


def test_where_it_sticks_out_farther_its_neck_fills_the_gap_and_not_its_ball():
    longer = stick_out_farther(Reacher(parse_cutter("lollipop:10:6")), 20.0)
    assert longer.shank == ((6.0, 20.0),)
