# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each term of the deviation's proof is needed: blocks on which the bound without it is exceeded, by dense
sampling."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from five_kinds import interleaved, kinematics_of

from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.motion.deviation.bound import (
    ROUNDINGS,
    Levers,
    allowance,
    bending,
    close_levers,
    end_levers,
)
from freecad_fiveaxis.core.motion.deviation.quartic import bow, chord
from freecad_fiveaxis.core.motion.deviation.search import Chords, _local, _Pieces
from freecad_fiveaxis.core.motion.linearize.proof import judge_pieces
from freecad_fiveaxis.core.motion.trajectory import Motion, at, axis_at, frames, inner, motion, tip

LONGER = pytest.mark.skipif(
    np.finfo(np.longdouble).eps >= np.finfo(float).eps, reason="no longer floats on this platform"
)
U = np.linspace(0.0, 1.0, 1001)
FRAME = frames(kinematics_of("table_table"))  # the second axis, A, is the first frame's x


def columns(*values):
    return tuple(np.array([value]) for value in values)


# ------------------------------------------------------------------------------------------ levers (bound.py)


def swung(middle, half, aside):
    """A point 100 mm from the second axis, swung by it through ``half`` rad on both sides of ``middle``, and
    ``aside`` mm from the plane of both axes when that angle is 0; the first axis turns, too."""
    arm, still = columns(0, 0, 0, 0, aside, 0, 100.0, 0, 0), columns(*np.zeros(9))
    return Motion(arm, still, *columns(0.0, 0.3, middle - half, 2.0 * half))


def across_first(move):
    """Of the point before the first axis turns: its distances from that axis (k,) mm, and its speeds across
    it."""
    x, y, _ = inner(FRAME, at(move, U))
    x, y = np.broadcast_to(x, U.shape), np.broadcast_to(y, U.shape)
    return np.hypot(x, y), np.hypot(np.diff(x), np.diff(y)) * (len(U) - 1)


def test_a_lever_that_is_longest_within_the_block_is_bounded():
    half = np.radians(60.0)
    move = swung(0.5 * np.pi, half, 100.0 * np.cos(half))  # in the plane of both axes at either end
    lever, _ = across_first(move)
    assert lever[0] < 1e-9 and lever[-1] < 1e-9 and lever.max() == pytest.approx(50.0)
    for levers in (end_levers(move, *columns(lever[0], lever[-1])), close_levers(FRAME, move)):
        assert levers.lever1[0] >= lever.max()


def test_a_speed_that_is_largest_within_the_block_is_bounded():
    move = swung(0.0, np.radians(60.0), 0.0)
    _, speed = across_first(move)
    assert speed.max() > 1.9 * max(speed[0], speed[-1])
    assert close_levers(FRAME, move).speed1[0] >= speed.max()


# --------------------------------------------------------------------------------------- roundings (bound.py)


class Counted:
    """A number that counts through how many roundings, one after the other, it has come."""

    def __init__(self, value, count=0):
        self.value, self.count = float(value), count

    def _with(self, other, value):
        return Counted(value, 1 + max(self.count, getattr(other, "count", 0)))

    def __add__(self, other):
        return self._with(other, self.value + getattr(other, "value", other))

    def __sub__(self, other):
        return self._with(other, self.value - getattr(other, "value", other))

    def __mul__(self, other):
        return self._with(other, self.value * getattr(other, "value", other))

    def __truediv__(self, other):
        return self._with(other, self.value / getattr(other, "value", other))

    def __rsub__(self, other):
        return self._with(other, other - self.value)

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self):
        return Counted(-self.value, self.count)

    def cos(self):
        return self._with(None, np.cos(self.value))

    def sin(self):
        return self._with(None, np.sin(self.value))

    def sqrt(self):
        return self._with(None, np.sqrt(self.value))

    def deg2rad(self):
        return self._with(None, np.deg2rad(self.value))


@pytest.mark.parametrize("kind", ["table_table", "nutating", "head_head", "linear_axes_everywhere"])
def test_every_distance_comes_through_fewer_roundings_than_are_allowed_for(kind):
    """The distance of a node's tip from the chord, on numbers that count: the constants are exact, the words
    too."""
    frame = frames(kinematics_of(kind))
    rows = [
        [Counted(x) for x in row]
        for row in ((110.0, -70.0, 55.0, 20.0, 35.0), (113.0, -64.0, 54.0, 29.0, 31.0))
    ]
    words = np.array(rows, object)
    move = motion(frame, words[:1], words[1:])
    start, there, end = (tip(frame, at(move, np.array([Counted(u)], object))) for u in (0.0, 0.25, 1.0))
    way, off = ([p - q for p, q in zip(one, start, strict=True)] for one in (end, there))
    size = np.sqrt(sum(p * p for p in way))
    along = [p / size for p in way]
    foot = sum(p * q for p, q in zip(off, along, strict=True))
    distance = np.sqrt(sum(x * x for x in (p - foot * q for p, q in zip(off, along, strict=True))))
    assert max(p[0].count for p in there) >= 10  # it does count
    assert 2 * distance[0].count < ROUNDINGS and distance[0].count < 100


@LONGER
def test_at_many_turns_a_tip_is_off_by_more_than_its_coordinates_roundings_and_within_the_allowance():
    """A rounded angle moves the tip by its own rounding times the lever: against the same words in longer
    arithmetic."""
    rng = np.random.default_rng(33)
    words = rng.uniform(0.5, 1.0, (400, 5)) * (100.0, 100.0, 100.0, 1e6, 1e6)
    move = motion(FRAME, words, words)
    near, exact = (
        np.array([np.broadcast_to(x, 400) for x in tip(FRAME, at(move_, move_.a * 0))])
        for move_ in (move, longer(words))
    )
    off = np.linalg.norm((near - exact).astype(float), axis=0)
    size = np.finfo(float).eps * sum(np.abs(p) for p in move.arm)
    assert (off <= allowance(move)).all() and (off > ROUNDINGS * size).any()


def longer(words):
    """The motion that stands at words, its angles in radians not rounded to a float's digits."""
    move, turn = motion(FRAME, words, words), np.longdouble(4.0) * np.arctan(np.longdouble(1.0)) / 180
    return replace(
        move, a=words[:, 3].astype(np.longdouble) * turn, b=words[:, 4].astype(np.longdouble) * turn
    )


# ------------------------------------------------------------------------------------------------ quartic.py


def test_no_quartic_that_counts_as_proven_exceeds_its_bound():
    """Bows g = A + B s + C s^2 of every shape, many with two peaks or with a foot beyond the chord, as
    quartics: no remainder."""
    rng = np.random.default_rng(31)
    a, b, c = 10.0 ** rng.uniform(-2.0, 0.5, (3, 1, 4000)) * rng.normal(size=(3, 3, 4000))
    a[0, ::2], b[:, ::2], c[:, ::2] = (
        0.0,
        0.0,
        -a[:, ::2] * rng.uniform(0.0, 60.0, 2000),
    )  # even ones across the chord: two peaks
    a[1:, 1::4], b[1:, 1::4], c[1:, 1::4] = 0.1, 0.0, 0.0  # a low peak across it, and anything along it
    end = np.zeros((3, 4000))
    end[0] = 10.0 ** rng.uniform(-1.0, 1.0, 4000)

    def path(u):
        s = u - 0.5
        return u * end + u * (1.0 - u) * (a + s * (b + s * c))

    way, nodes = chord(np.zeros_like(end), end), np.stack([path(u) for u in (0.25, 0.5, 0.75)], axis=1)
    found = bow(way, nodes, Levers(*np.array([1e-3, 0.0, 1e8, 0.0, 0.0, 0.0])[:, None] * np.ones(4000)))
    assert 400 < found.proven.sum() < 3600
    most = np.zeros(4000)
    for u in np.linspace(0.0, 1.0, 401):
        place = path(u)
        place[0] -= np.clip(place[0], 0.0, end[0])
        most = np.maximum(most, np.sqrt((place * place).sum(axis=0)))
    proven = found.proven
    assert (most[proven] <= found.bound[proven] * (1 + 1e-9)).all()
    assert (most[~proven] > found.bound[~proven] * 1.01).any()  # those left out would break it


# ------------------------------------------------------------------------------------------------ search.py


def exceeded(move, origin, along, low, high, half, second=None, third=None):
    """The largest squared distance of a piece about u = 1/2 over the bound that the search has for it, less
    1."""
    levers = close_levers(FRAME, move)
    ends = (np.array([low]), np.array([high]), bending(levers, 2), bending(levers, 3), levers.turn)
    if second is not None:  # one's own bounds of the derivatives instead of those of the levers
        ends = (*ends[:2], np.array([second]), np.array([third]), levers.turn)
    chords = Chords(move, columns(*origin), columns(*along), *ends)
    local = _local(FRAME, chords, _Pieces(np.array([0]), np.array([0.5]), np.array([half])))
    path = np.array(tip(FRAME, at(move, 0.5 + half * np.linspace(-1.0, 1.0, 401))))
    off = np.array([np.broadcast_to(p, 401) for p in path]) - np.array(origin)[:, None]
    foot = np.clip(np.array(along) @ off, low, high)
    return float(((off - foot * np.array(along)[:, None]) ** 2).sum(axis=0).max() / local.bound[0] - 1.0)


def test_a_piece_whose_foot_leaves_the_chord_ever_faster_keeps_its_bound():
    """A point that runs out along a spiral; the chord lies along its path and ends where the piece has its
    middle."""
    speed, turn, radius = 20.0, 0.2, 100.0
    move = turning_point(radius - 0.5 * speed, 0.0, speed, turn)
    way = np.array([speed, turn * radius, 0.0])
    way /= np.linalg.norm(way)
    worst = exceeded(move, (radius, 0.0, 0.0), way, -50.0, 0.0, 1.0 / 64.0)
    assert -0.1 < worst <= 1e-12


def test_a_piece_far_from_its_chord_whose_path_has_a_cusp_keeps_its_bound():
    """Where the speed vanishes and the path bends along the chord only the third derivative leads away from
    it."""
    speed, turn, away = 20.0, 1.0, 1e4
    move = turning_point(-0.5 * speed, speed / turn, speed, turn)
    worst = exceeded(move, (-away, 0.0, 0.0), (0.0, 1.0, 0.0), -1e3, 1e3, 0.125)
    assert -1e-3 < worst <= 1e-12


def test_the_third_order_rest_is_used_up_where_the_derivatives_are_as_large_as_they_may_be():
    """The same cusp; at z = x + i y the second derivative is turn |2 speed + i turn z|, the third turn^2 |3
    speed + i turn z|."""
    speed, away, half = 20.0, 1e4, 0.125
    move = turning_point(-0.5 * speed, speed, speed, 1.0)
    second, third = np.hypot(speed, speed * half), np.hypot(2.0 * speed, speed * half)
    worst = exceeded(move, (-away, 0.0, 0.0), (0.0, 1.0, 0.0), -1e3, 1e3, half, second, third)
    assert -1e-6 < worst <= 1e-12


def test_a_piece_whose_foot_stays_beyond_the_chord_is_bounded_by_the_distance_from_its_end():
    """The distance from the line and the way beyond the end, each at its largest, would be far too much: one
    falls as the other rises about the chord's end."""
    turn, radius = 1.0, 100.0
    move = turning_point(radius, 0.0, 0.0, turn)
    worst = exceeded(move, (0.0, 0.0, 0.0), (0.6, 0.8, 0.0), -50.0, 0.0, 0.125)
    assert -0.005 < worst <= 1e-12


def turning_point(x, y, speed, turn):
    """One block: a point at (x + speed u, y) mm about the first axis, which turns by ``turn`` rad and is at 0
    in mid block."""
    arm, step = columns(0, 0, 0, x, y, 0, 0, 0, 0), columns(0, 0, 0, speed, 0, 0, 0, 0, 0)
    return Motion(arm, step, *columns(-0.5 * turn, turn, 0.0, 0.0))


# ----------------------------------------------------------------------------------------- linearize/proof.py


def judged(words, off):
    return judge_pieces(
        FRAME, words, np.ones(len(words) - 1, bool), np.array(off), np.full(len(words) - 1, np.inf)
    )


def test_a_piece_counts_the_worse_of_its_ends_whichever_it_is():
    words = np.array([[0.0, 0.0, 0.0, 0.0, 0.0], [10.0, 0.0, 0.0, 0.0, 0.0], [20.0, 0.0, 0.0, 0.0, 0.0]])
    assert judged(words, [0.5, 0.0, 0.25]).off.tolist() == [0.5, 0.25]


@LONGER
def test_the_bound_of_a_piece_holds_in_longer_arithmetic_too():
    """Tiny turns at long levers: the bow is found to a few roundings of the coordinates, and half of the bows
    are longer."""
    rng = np.random.default_rng(34)
    start = rng.uniform(-1.0, 1.0, (200, 5)) * (1e5, 1e5, 1e5, 180.0, 60.0)
    end = start + rng.uniform(0.5, 1.0, (200, 5)) * (0.0, 0.0, 0.0, 1e-3, 1e-3)
    most = judged(interleaved(start, end), np.zeros(400)).most[::2]
    move, turn = longer(start), longer(end)
    step = tuple(q.astype(np.longdouble) - p for p, q in zip(move.arm, turn.arm, strict=True))
    move = replace(move, arm_step=step, a_step=turn.a - move.a, b_step=turn.b - move.b)
    path = [
        np.array([np.broadcast_to(x, 200) for x in tip(FRAME, at(move, np.longdouble(u)))])
        for u in np.linspace(0.0, 1.0, 41)
    ]
    way = path[-1] - path[0]
    way /= np.sqrt((way * way).sum(axis=0))
    off = [place - path[0] - ((place - path[0]) * way).sum(axis=0) * way for place in path]
    bow = np.max([np.sqrt((x * x).sum(axis=0)) for x in off], axis=0)
    assert (bow <= most).all()


# ---------------------------------------------------------------------------------------------- axis_swing.py


def test_the_widest_of_many_swings_of_the_axis_is_found():
    """Blocks of several turns: samples as far apart as a swing is long would miss the widest."""
    kinematics, rng = kinematics_of("table_table"), np.random.default_rng(32)
    start = rng.uniform(-1.0, 1.0, (40, 5)) * (100, 100, 100, 180, 60)
    end = start + rng.uniform(0.5, 1.0, (40, 5)) * (0, 0, 0, 3000, 700)
    axes = axis_at(kinematics, start, end, np.linspace(0.0, 1.0, 4001)[None])
    normal = np.cross(axes[:, 0], axes[:, -1])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    off = np.arcsin(np.minimum(np.abs(np.einsum("ijk,ik->ij", axes, normal)).max(axis=1), 1.0))
    assert measure(kinematics, interleaved(start, end)).axis[1::2] == pytest.approx(off, abs=2e-3)
