# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes that are led: from one guide to another, or by an axis. By closed forms, and by a ball that follows
them."""

import math
from functools import lru_cache

import numpy as np
import pytest
from test_pass_strategies import (
    FLAT_STEP,
    SCALLOP,
    ball,
    box,
    grid,
    passes,
    plate,
    region,
    rest_heights,
    samples,
    turned,
)

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_faces, write_stl
from freecad_fiveaxis.core.passes import PASS_STRATEGIES, PassOptions, even_steps, flat_interval
from freecad_fiveaxis.core.pipeline.settings import tree as settings

MORPH, RADIAL = PASS_STRATEGIES["morph"], PASS_STRATEGIES["radial"]


def options(**given):
    return PassOptions(scallop=SCALLOP, **given)


def highest(strategy, mesh, keep=None, given=None, share=0.99):
    rows = np.arange(len(mesh.face)) if keep is None else np.flatnonzero(keep)
    stays = rest_heights(mesh, passes(strategy, mesh, keep, given or options()), samples(mesh, rows)[0])
    assert stays.max() < 3.5 * SCALLOP  # in corners, at which a harmonic field stands still
    return float(np.quantile(stays, share))


def length(contact):
    return float(np.linalg.norm(contact.point[1::2] - contact.point[::2], axis=1).sum())


def wedge(narrow=6.0, wide=14.0):
    """A level plate from y = -h to h, h from half of ``narrow`` at x = 0 to half of ``wide`` at x = 20."""
    x, v = np.meshgrid(np.linspace(0, 20, 41), np.linspace(-1, 1, 33), indexing="ij")
    return grid(np.stack([x, 0.5 * v * (narrow + (wide - narrow) * x / 20.0), 0 * x], axis=-1))


@lru_cache
def welded_ring():
    """A level ring about the origin, 4 to 10 mm from it."""
    turn, radius = np.meshgrid(np.linspace(0, 2 * math.pi, 97), np.linspace(4.0, 10.0, 13), indexing="ij")
    whole, count = grid(np.stack([radius * np.cos(turn), radius * np.sin(turn), 0 * turn], axis=-1)), 96 * 13
    return from_faces(
        np.asarray(whole.vertex)[:count],
        np.where(whole.face >= count, whole.face - count, whole.face)[:, ::-1],
    )


def curve(path, points):
    path.write_text("\n".join(",".join(f"{number:.6f}" for number in point) for point in points) + "\n")
    return str(path)


# ------------------------------------------------------------------------------------------------ both


def test_the_names_of_strategies_over_the_surface_are_those_that_say_so_themselves():
    assert sorted(name for name, one in PASS_STRATEGIES.items() if one.over_surface) == sorted(
        settings.OVER_SURFACE
    )


@pytest.mark.parametrize("strategy", [MORPH, RADIAL], ids=["morph", "radial"])
def test_where_levels_are_spread_evenly_over_the_range_the_widest_place_keeps_too_much(strategy, monkeypatch):
    """Half as many steps as the widest place wants: it would be noticed."""
    assert highest(strategy, wedge()) <= 1.25 * SCALLOP
    counted = even_steps.count_in_steps
    for module in ("morph_passes", "radial_passes"):
        monkeypatch.setattr(
            f"freecad_fiveaxis.core.passes.{module}.count_in_steps", lambda *given: 0.4 * counted(*given)
        )
    monkeypatch.setattr(
        "freecad_fiveaxis.core.passes.scallop_passes._gaps",
        lambda surface, *_: np.zeros(len(surface.copy.mesh.face), bool),
    )
    with pytest.raises(AssertionError):
        highest(strategy, wedge())


# ------------------------------------------------------------------------------------------------ morph


def test_passes_of_a_wedge_fan_out_from_side_to_side():
    """Between two slanting sides the harmonic field is the angle about the point at which they would meet."""
    mesh, apex = wedge(), -6.0 * 20.0 / 8.0
    contact = passes(MORPH, mesh)
    inner = (contact.point[:, 0] > 3.0) & (contact.point[:, 0] < 17.0)
    angle = np.arctan2(contact.point[:, 1], contact.point[:, 0] - apex)
    count = int(contact.pass_.max()) + 1
    assert count >= math.ceil(14.0 / flat_interval(3.0, SCALLOP))
    spread = [np.ptp(angle[inner & (contact.pass_ == number)]) for number in range(count)]
    assert max(spread) < 0.2 * 2 * math.atan(7.0 / (20.0 - apex)) / count
    middle = [np.mean(angle[inner & (contact.pass_ == number)]) for number in range(count)]
    np.testing.assert_allclose(np.diff(middle), np.mean(np.diff(middle)), rtol=0.2)
    assert highest(MORPH, mesh) <= 1.2 * SCALLOP


def test_passes_from_side_to_side_run_along_the_direction():
    along, across = (
        passes(MORPH, plate(), options=options(direction=angle)) for angle in (0.0, 0.5 * math.pi)
    )
    for contact, k, side in ((along, 0, 16.0), (across, 1, 20.0)):
        way = contact.point[1::2] - contact.point[::2]
        assert np.abs(way[:, k]).sum() > 0.99 * np.linalg.norm(way, axis=1).sum()
        assert contact.pass_.max() + 1 == math.ceil(side / FLAT_STEP)


@pytest.mark.parametrize("travel", [0.0, 0.5 * math.pi])
def test_a_wall_is_cut_along_the_direction_or_upwards_where_that_leads_through_it(travel):
    mesh = plate()
    wall = from_faces(np.asarray(mesh.vertex)[:, [0, 2, 1]] * (1.0, -1.0, 1.0), mesh.face)
    contact = passes(MORPH, wall, options=options(direction=travel))
    way = contact.point[1::2] - contact.point[::2]
    assert np.abs(way[:, 2 if travel else 0]).sum() > 0.99 * length(contact)


def test_the_cap_of_a_ball_is_cut_from_side_to_side():
    mesh = ball(12.0, 40, 60)
    keep = mesh.normal[:, 2] > math.cos(math.radians(50.0))
    assert highest(MORPH, mesh, keep, share=0.95) <= 1.2 * SCALLOP


def test_a_ring_is_cut_from_rim_to_rim_in_circles():
    contact = passes(MORPH, welded_ring())
    radius = np.linalg.norm(contact.point[:, :2], axis=1)
    for number in range(int(contact.pass_.max()) + 1):
        assert np.ptp(radius[contact.pass_ == number]) < 0.15
    assert radius.min() - 4.0 < FLAT_STEP and 10.0 - radius.max() < FLAT_STEP
    assert highest(MORPH, welded_ring()) <= 1.2 * SCALLOP


def test_guide_curves_in_a_file_bound_what_is_cut(tmp_path):
    """Between two curves over a plate, along sides of its facets and aslant."""
    low = curve(tmp_path / "low.csv", [(-10, -4, 0), (10, -4, 0)])
    high = curve(tmp_path / "high.csv", [(-10, 2, 0), (0, 5, 0), (10, 2, 0)])
    contact = passes(MORPH, plate(), options=options(source=low, target=high))
    x, y, _ = contact.point.T
    assert y.min() > -4.0 - 1e-6 and (y < 5.0 - 0.3 * np.abs(x) + 0.6).all()
    first = y[contact.pass_ == 0]
    assert first.max() - first.min() < 0.35 and first.min() < -4.0 + FLAT_STEP
    last = np.abs(y - (5.0 - 0.3 * np.abs(x)))[contact.pass_ == contact.pass_.max()]
    assert np.quantile(last, 0.9) < FLAT_STEP


def test_from_a_point_to_the_border_passes_are_rings():
    contact = passes(MORPH, plate(), options=options(source=(0.0, 0.0, 0.0)))
    first = np.linalg.norm(contact.point[contact.pass_ == 0], axis=1)
    assert (
        first.max() < 2.0 * FLAT_STEP
        and highest(MORPH, plate(), given=options(source=(0.0, 0.0, 0.0)), share=0.95) <= 1.2 * SCALLOP
    )


def test_round_an_island_passes_part_and_meet_again():
    mesh = plate()
    middle = mesh.vertex[mesh.face].mean(axis=1)
    keep = (np.abs(middle[:, 0]) > 2.0) | (np.abs(middle[:, 1]) > 2.0)
    low, high = (-10.0, -8.0, 0.0), (10.0, 8.0, 0.0)
    found = MORPH.field(region(mesh, keep), options(source=low, target=high))
    inner = found.surface.component == 0
    assert inner.any() and len(found.levels) > 10
    assert highest(MORPH, mesh, keep, options(source=low, target=high), share=0.9) <= 1.2 * SCALLOP


def test_a_closed_surface_without_guides_is_refused_with_the_remedy():
    with pytest.raises(
        SettingsError, match="has no border to lead passes from or to; give two guides by --from and --to"
    ):
        MORPH.check(region(ball()), options())
    with pytest.raises(SettingsError, match="has no border"):
        MORPH.check(region(ball()), options(source=(0.0, 0.0, -6.0)))
    MORPH.check(region(ball()), options(source=(0.0, 0.0, -6.0), target=(0.0, 0.0, 6.0)))


def test_from_pole_to_pole_a_ball_is_cut_in_circles():
    given = options(source=(0.0, 0.0, -6.0), target=(0.0, 0.0, 6.0))
    contact = passes(MORPH, ball(), options=given)
    for number in range(int(contact.pass_.max()) + 1):
        assert np.ptp(contact.point[contact.pass_ == number, 2]) < 0.5
    assert highest(MORPH, ball(), given=given, share=0.95) <= 1.25 * SCALLOP


def test_guides_on_two_pieces_are_refused():
    mesh = box((30.0, 20.0, 8.0))
    keep = np.abs(mesh.normal[:, 2]) > 0.5
    with pytest.raises(SettingsError, match="no piece of the surface that is to be cut has both guides"):
        MORPH.field(region(mesh, keep), options(source=(15.0, 10.0, 0.0), target=(15.0, 10.0, 8.0)))


# ------------------------------------------------------------------------------------------------ radial


def test_radial_passes_of_a_ring_point_at_the_axis_and_stand_a_step_apart_at_its_rim():
    contact = passes(RADIAL, welded_ring())
    x, y, _ = contact.point.T
    angle = np.arctan2(y, x)
    numbers = np.unique(contact.pass_)
    off = max(
        np.abs(np.sin(angle[contact.pass_ == number] - angle[contact.pass_ == number][0])).max()
        for number in numbers
    )
    assert off < 0.01
    assert len(numbers) == 2 * math.ceil(math.pi * 10.0 / FLAT_STEP * math.cos(math.pi / 96))
    assert highest(RADIAL, welded_ring()) <= 1.2 * SCALLOP


@pytest.mark.parametrize("centre", [(3.0, -2.0, 0.0), "middle"])
def test_over_a_plate_passes_meet_at_the_centre(centre):
    given = options(centre=centre)
    contact = passes(RADIAL, plate(), options=given)
    here = np.array((0.0, 0.0, 0.0) if centre == "middle" else centre)
    x, y, _ = (contact.point - here).T
    far = np.hypot(x, y) > 2.0  # nearer, facets as wide as the ball's step hold many passes
    for number in np.unique(contact.pass_[far]):
        rows = far & (contact.pass_ == number)
        turn = np.median(np.unwrap(np.arctan2(y[rows], x[rows])))
        assert np.abs(y[rows] * math.cos(turn) - x[rows] * math.sin(turn)).max() < 0.25
    assert highest(RADIAL, plate(), given=given) <= 1.2 * SCALLOP


def test_along_a_shaft_passes_run_lengthwise():
    turn, along = np.meshgrid(np.linspace(0, math.pi, 49), np.linspace(0, 30, 31), indexing="ij")
    mesh = grid(np.stack([along, -5.0 * np.cos(turn), 5.0 * np.sin(turn)], axis=-1))
    given = options(axis=(2.0, 0.0, 0.0), centre=(0.0, 0.0, 0.0))
    contact = passes(RADIAL, mesh, options=given)
    way = contact.point[1::2] - contact.point[::2]
    assert np.abs(way[:, 0]).sum() > 0.999 * length(contact)
    assert highest(RADIAL, mesh, given=given) <= 1.25 * SCALLOP


def test_radial_passes_turn_with_the_part_about_any_axis():
    lengths = []
    for turn in (0.0, 0.9):
        tipped = turned(turn) @ np.array([[1.0, 0.0, 0.0], [0.0, 0.6, -0.8], [0.0, 0.8, 0.6]])
        mesh = welded_ring()
        placed = from_faces(np.asarray(mesh.vertex) @ tipped.T + (5.0, 6.0, 7.0), mesh.face)
        contact = passes(RADIAL, placed, options=options(axis=tuple(tipped[:, 2]), centre=(5.0, 6.0, 7.0)))
        lengths.append(length(contact))
    assert lengths[0] == pytest.approx(lengths[1], rel=2e-3)


@pytest.mark.parametrize(
    ("given", "reported"),
    [
        ({"axis": (0.0, 0.0, 0.0)}, "--pass-axis 0,0,0 has no direction"),
        ({"centre": "left"}, "neither middle nor X,Y,Z"),
    ],
)
def test_an_axis_that_is_none_is_refused(given, reported):
    with pytest.raises(SettingsError, match=reported):
        RADIAL.check(region(plate()), options(**given))


# ---------------------------------------------------------------------------------------- on the command line


@pytest.mark.parametrize(
    ("words", "reported"),
    [
        (["--passes", "morph", "--from", "0,0,0"], None), (["--passes", "radial"], None),
        (["--passes", "radial", "--pass-centre", "1,2,3", "--pass-axis", "0,1,1"], None),
        (["--passes", "morph", "--to", "nowhere.csv"], "nowhere.csv"), (["--passes", "morph", "--to", "500,0,0"], "off the surface"),
        (["--passes", "morph", "--to", "end"], "--to 'end' is neither border"), (["--passes", "radial", "--pass-axis", "0,0,0"], "has no direction"),
        (["--passes", "radial", "--pass-centre", "here"], "--pass-centre 'here' is neither middle"),
    ],
)  # fmt: skip
def test_the_command_line_makes_a_program_or_says_in_one_line_why_not(
    tmp_path, monkeypatch, capsys, words, reported
):
    monkeypatch.chdir(tmp_path)
    write_stl(plate(), tmp_path / "part.stl")
    given = [
        "mill",
        "part.stl",
        "--machine",
        "trunnion_ac",
        "--scallop",
        "0.1",
        "--cutter",
        "ball:6",
        "-o",
        "out.ngc",
        "--quiet",
    ]
    code = cli.main([*given, *words])
    if reported is None:
        assert code in (0, 1) and (tmp_path / "out.ngc").exists()
    else:
        error = capsys.readouterr().err
        assert (
            code == 2 and reported in error and error.count("\n") == 1 and not (tmp_path / "out.ngc").exists()
        )
