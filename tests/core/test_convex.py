# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gaps of convex pieces, beside scipy's least squares and linear programmes, and bounds over cells of joints,
beside samples."""

from itertools import product

import numpy as np
import pytest
from mesh_shapes import box
from scipy.optimize import linprog, nnls
from scipy.spatial.transform import Rotation
from test_machine_bodies import MACHINES
from thorough import some_in_core

from freecad_fiveaxis.core.geometry import convex
from freecad_fiveaxis.core.geometry.convex import (
    Poses,
    convex_hull,
    find_gaps,
    find_met_poses,
    nearest_weights,
    support_gap,
)
from freecad_fiveaxis.core.geometry.solids import frustum_facets
from freecad_fiveaxis.core.gouge import carried_motion
from freecad_fiveaxis.core.gouge.carried_motion import CarriedMotion, steps_between
from freecad_fiveaxis.core.machine import load_machine

BAR = convex_hull(box((-50.0, -20.0, -10.0), (50.0, 20.0, 10.0)).reshape(-1, 3))
CONE = convex_hull(
    frustum_facets(np.array([0.0, 0.0, -30.0]), np.array([0.0, 0.0, 30.0]), 40.0, 60.0).reshape(-1, 3)
)
UP = np.array([[0.0, 0.0, 1.0]])


def gaps(one, other, shift, within=0.0, turn=None):
    poses = Poses(np.eye(3)[None] if turn is None else turn[None], np.array([shift], float))
    return find_gaps(one, other, poses, within, np.array([np.inf]), UP)


def apart(one, other, turn, shift):
    """How far two hulls are apart, by non-negative least squares, and whether they share a point, by a linear
    programme."""
    points, own = one.corner @ turn.T + shift, len(one.corner)
    sums = np.zeros((2, own + len(other.corner)))
    sums[0, :own] = sums[1, own:] = 1.0
    table = np.vstack([np.hstack([points.T, -other.corner.T]), sums])
    scaled = np.vstack([table[:3] / 100.0, 30.0 * sums])
    share, _ = nnls(scaled, np.array([0.0, 0.0, 0.0, 30.0, 30.0]), maxiter=10_000)
    share[:own] /= share[:own].sum()
    share[own:] /= share[own:].sum()
    met = linprog(np.zeros(table.shape[1]), A_eq=table, b_eq=[0.0, 0.0, 0.0, 1.0, 1.0]).status == 0
    return float(np.linalg.norm(table[:3] @ share)), met


def compare(count):
    rng, turns = np.random.default_rng(1), Rotation.random(count, random_state=1).as_matrix()
    shifts = rng.uniform(-120.0, 120.0, (count, 3))
    found = find_gaps(BAR, CONE, Poses(turns, shifts), 0.0, np.full(count, np.inf), np.tile(UP, (count, 1)))
    for k in range(count):
        distance, met = apart(BAR, CONE, turns[k], shifts[k])
        assert met == found.met[k]
        assert met or 0.999 * distance - 1e-3 <= found.least[k] <= distance * (1.0 + 1e-9)
    assert found.met.any() and not found.met.all()
    assert np.allclose(
        support_gap(BAR, CONE, Poses(turns, shifts), found.way)[~found.met], found.least[~found.met]
    )


def test_gaps_are_those_of_least_squares_and_meetings_those_of_a_linear_programme():
    compare(120)


def test_a_search_that_takes_no_inside_of_a_simplex_would_be_noticed(monkeypatch):
    monkeypatch.setattr(
        convex, "_on_sides", lambda point: (np.zeros((len(point), 4, 4)), np.ones((len(point), 4), bool))
    )
    with pytest.raises(AssertionError):
        compare(120)


SHEET = convex_hull(
    np.array([[-60.0, -40.0, 0.0], [60.0, -40.0, 0.0], [60.0, 40.0, 0.0], [-60.0, 40.0, 0.0]])
)
DISC = convex_hull(np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 60.0]]), 25.0)


def tell_meetings(one, other, within, count=200):
    """What is told, and whether the pieces really are so near; but for those that are so to 0.01 mm."""
    rng, turns = np.random.default_rng(5), Rotation.random(count, random_state=5).as_matrix()
    shifts = rng.uniform(-130.0, 130.0, (count, 3))
    reported = find_met_poses(one, other, Poses(turns, shifts), within)
    real = [apart(one, other, turn, shift) for turn, shift in zip(turns, shifts, strict=True)]
    gap = np.array([-1.0 if met else distance for distance, met in real]) - one.round - other.round
    sure = np.abs(gap - within) > 0.01
    return reported[sure], (gap <= within)[sure]


@some_in_core("within", [0.0, 7.0], kept=(1,))
@pytest.mark.parametrize(
    ("one", "other"),
    [(BAR, CONE), (CONE, BAR), (BAR, SHEET), (SHEET, BAR), (DISC, CONE), (BAR, DISC)],
    ids=["bar-cone", "cone-bar", "bar-sheet", "sheet-bar", "disc-cone", "bar-disc"],
)
def test_pieces_meet_exactly_where_least_squares_say_so(one, other, within):
    reported, real = tell_meetings(one, other, within)
    assert (reported == real).all() and real.any() and not real.all()


@pytest.mark.parametrize("name", ["reach", "inmost"])
def test_balls_that_are_too_small_or_too_large_would_be_noticed(name, monkeypatch):
    one, other = convex_hull(BAR.corner), convex_hull(CONE.corner)
    for piece in (one, other):
        value = 0.5 * piece.reach if name == "reach" else (piece.inmost[0], 3.0 * piece.inmost[1])
        monkeypatch.setitem(piece.__dict__, name, value)
    reported, real = tell_meetings(one, other, 0.0)
    assert (reported != real).any()


def test_a_piece_faces_a_point_by_the_plane_that_the_point_is_farthest_outside_of():
    ways = BAR.facing(np.array([(0.0, 0.0, 11.0), (-60.0, 21.0, 5.0), (1.0, -25.0, 0.0)]))
    assert np.allclose(ways, [(0, 0, 1), (-1, 0, 0), (0, -1, 0)], atol=1e-12)
    assert np.allclose(SHEET.facing(np.array([(0.0, 3.0, 4.0)])), [(0.0, 0.6, 0.8)])


def test_two_boxes_side_by_side_corner_to_corner_and_in_each_other():
    assert gaps(BAR, BAR, (103.0, 0.0, 0.0)).least[0] == pytest.approx(3.0)
    assert gaps(BAR, BAR, (103.0, 44.0, 0.0)).least[0] == pytest.approx(5.0)
    assert gaps(BAR, BAR, (103.0, 44.0, 0.0), within=4.9).least[0] == pytest.approx(0.1)
    assert gaps(BAR, BAR, (103.0, 44.0, 0.0), within=5.1).met[0] and gaps(BAR, BAR, (99.9, 39.9, 19.9)).met[0]
    met = gaps(BAR, BAR, (99.0, 0.0, 0.0))
    assert met.met[0] and 49.0 <= met.place[0, 0] <= 50.0


def test_points_lines_and_sheets_are_pieces_too():
    point, ball = convex_hull(np.zeros((1, 3))), convex_hull(np.zeros((1, 3)), 4.0)
    line = convex_hull(np.array([[0.0, 0.0, 0.0], [10.0, 0.0, 0.0]]))
    sheet = convex_hull(np.array([[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0], [9.0, 9.0, 0.0]]))
    assert gaps(point, line, (5.0, 3.0, 4.0)).least[0] == pytest.approx(5.0)
    assert (
        gaps(ball, sheet, (5.0, 5.0, 7.0)).least[0] == pytest.approx(3.0)
        and gaps(ball, sheet, (5.0, 5.0, 3.9)).met[0]
    )
    assert sheet.inmost[1] == 0.0 and sheet.pare(1.0) is sheet


def test_what_is_pared_off_a_piece_lies_less_deep():
    assert BAR.inmost[1] == pytest.approx(10.0)
    less = BAR.pare(2.5)
    assert np.allclose(np.abs(less.corner), (47.5, 17.5, 7.5)) and less.inmost[1] == pytest.approx(7.5)


def test_the_point_of_a_simplex_next_to_zero_is_that_of_least_squares():
    rng = np.random.default_rng(2)
    points = rng.normal(size=(300, 4, 3)) + rng.normal(size=(300, 1, 3))
    weight = nearest_weights(points)
    assert np.allclose(weight.sum(axis=1), 1.0) and (weight >= 0.0).all()
    for one, given in zip(points, weight, strict=True):
        share, _ = nnls(np.vstack([one.T, np.full(4, 1e3)]), np.array([0.0, 0.0, 0.0, 1e3]))
        assert np.linalg.norm(given @ one) == pytest.approx(
            np.linalg.norm(share @ one / share.sum()), abs=1e-5
        )


# -------------------------------------------------------------------------------------------- cells of joints


def cell_slack(name, joined, count=60):
    """How much less than in any sample the gap is that is said to be left in random cells: the least, mm."""
    rng, machine, slack = np.random.default_rng(4), load_machine(name), []
    names = ["base", "spindle", *(axis.letter for axis in machine.fitted)]
    while len(slack) < count:
        steps = steps_between(machine, *rng.choice(names, 2, replace=False))
        if not steps:
            continue
        motion = CarriedMotion(steps, BAR)
        size = np.where(motion.rotary, 0.6, 40.0)
        middle, half = rng.uniform(-1, 1, len(steps)) * size, rng.uniform(-1, 1, len(steps)) * size
        g = rng.normal(size=3)
        g /= np.linalg.norm(g)
        left = motion.least_gap(CONE, motion.lines(middle[None]), half[None], g[None], joined)[0]
        share = rng.uniform(-1, 1, (400, 1 if joined else len(steps)))
        share[:200] = np.sign(share[:200])
        at = motion.lines(middle + share * half).poses
        slack.append(support_gap(BAR, CONE, at, np.tile(g, (400, 1))).min() - left)
    return min(slack)


@pytest.mark.parametrize("joined", [True, False])
@pytest.mark.parametrize("name", MACHINES)
def test_in_no_sample_of_a_cell_the_gap_is_less_than_is_stated_to_be_left(name, joined):
    assert cell_slack(name, joined) > -1e-9


def slack_of_two_turns():
    """How much less than at the ends of cells of a trunnion's two turns the gap is that is said to be left:
    the least, mm. The pieces are hulls of some points, so that the corner that both turns take lowest is
    often one that neither of them does."""
    rng, machine, slack = np.random.default_rng(3), load_machine("trunnion_ac"), []
    for _ in range(20):
        motion = CarriedMotion(
            steps_between(machine, "base", "C"), convex_hull(rng.normal(size=(12, 3)) * (200.0, 200.0, 50.0))
        )
        for middle, half in zip(
            rng.uniform(-1.5, 1.5, (20, 1, 2)), rng.choice([0.003, 0.01, 0.1], (20, 1, 2)), strict=True
        ):
            g = rng.normal(size=(1, 3))
            g /= np.linalg.norm(g)
            left = motion.least_gap(CONE, motion.lines(middle), half, g, False)[0]
            at = motion.lines(middle + np.array(list(product((-1.0, 1.0), repeat=2))) * half).poses
            slack.append(support_gap(motion.moved, CONE, at, np.tile(g, (4, 1))).min() - left)
    return min(slack)


def test_no_corner_goes_lower_by_two_turns_of_their_own_than_is_stated():
    assert slack_of_two_turns() > -1e-9


def test_turns_taken_together_that_go_each_as_it_will_would_be_noticed(monkeypatch):
    monkeypatch.setattr(carried_motion, "product", lambda signs, repeat: [repeat * (sign,) for sign in signs])
    assert slack_of_two_turns() < -1.0


def test_turns_that_add_up_would_be_noticed_where_each_is_counted_alone(monkeypatch):
    def alone(self, lines, half):
        size = np.abs(half).T
        return (0.5 * size * size * lines.lever * self.rotary[:, None]).sum(axis=0), (size * lines.lever).sum(
            axis=0
        )

    monkeypatch.setattr(CarriedMotion, "travel", alone)
    assert min(cell_slack(name, False) for name in MACHINES) < -1.0


def test_along_linear_axes_alone_the_bound_is_the_gap():
    machine = load_machine("trunnion_ac")
    motion = CarriedMotion(steps_between(machine, "base", "Z"), BAR)
    lines, half = motion.lines(np.array([[0.0, 0.0, 200.0]])), np.array([[10.0, 20.0, 5.0]])
    assert motion.least_gap(CONE, lines, half, UP, False)[0] == pytest.approx(200.0 - 10.0 - 30.0 - 5.0)
    assert motion.least_gap(CONE, lines, half, UP, True)[0] == pytest.approx(200.0 - 10.0 - 30.0 - 5.0)
