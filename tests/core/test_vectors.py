# SPDX-License-Identifier: LGPL-2.1-or-later
"""Great arcs between unit vectors, against rotations about the common normal."""

import math

import numpy as np
import pytest

from freecad_fiveaxis.core.base.vectors import NO_DIRECTION, slerp


def unit_rows(rng, *shape):
    rows = rng.normal(size=(*shape, 3))
    return rows / np.linalg.norm(rows, axis=-1, keepdims=True)


def turned(start, about, angle):
    """``start`` (n, 3) turned by ``angle`` (n,) rad about unit rows ``about`` square to it, by Rodrigues: the
    closed form that slerp is held against. (Older scipy's rotations round more.)"""
    cosine, sine = (np.asarray(one)[:, None] for one in (np.cos(angle), np.sin(angle)))
    return cosine * start + sine * np.cross(about, start)


@pytest.mark.parametrize("angle", [1e-12, 1e-7, 1e-3, 0.7, math.pi / 2, 3.0, math.pi - 1e-4])
def test_slerp_turns_about_the_common_normal_evenly_with_the_share(angle):
    rng = np.random.default_rng(3)
    start, share = unit_rows(rng, 200), rng.random(200)
    about = np.cross(start, unit_rows(rng, 200))
    about /= np.linalg.norm(about, axis=1)[:, None]
    found = slerp(start, turned(start, about, np.full(200, angle)), share)
    lost = 1e-16 / (math.pi - angle)  # nearly opposite vectors say less well where the arc lies
    assert np.abs(found - turned(start, about, share * angle)).max() < 1e-15 + 8.0 * lost


def test_slerp_has_its_ends_and_between_equal_vectors_nothing_turns():
    rng = np.random.default_rng(4)
    start, end, share = unit_rows(rng, 50), unit_rows(rng, 50), rng.random(50)
    for whole, there in ((0.0, start), (1.0, end)):
        assert np.abs(slerp(start, end, np.full(50, whole)) - there).max() < 3e-16
    assert np.abs(slerp(start, start, share) - start).max() < 3e-16


@pytest.mark.parametrize("off", [0.0, 0.5 * NO_DIRECTION])
def test_between_opposite_vectors_slerp_takes_one_great_arc_evenly(off):
    rng = np.random.default_rng(5)
    start = np.concatenate([unit_rows(rng, 20), np.eye(3), -np.eye(3)])
    aside = np.cross(start, unit_rows(rng, 26))
    end = off * aside / np.linalg.norm(aside, axis=1)[:, None] - start
    about = np.cross(start, slerp(start, end, np.full(26, 0.5)))
    assert np.linalg.norm(about, axis=1) == pytest.approx(np.ones(26), abs=1e-8)
    for share in (0.0, 0.2, 0.5, 0.9, 1.0):
        found = slerp(start, end, np.full(26, share))
        assert np.linalg.norm(found, axis=1) == pytest.approx(np.ones(26), abs=1e-15)
        assert np.abs(found - turned(start, about, np.full(26, share * math.pi))).max() < 2.0 * NO_DIRECTION


def test_slerp_takes_arrays_of_any_shape_and_leaves_them_as_they_are():
    rng = np.random.default_rng(6)
    start, end, share = unit_rows(rng, 4, 5), unit_rows(rng, 4, 5), rng.random((4, 5))
    end[1, 2] = -start[1, 2]
    before = start.copy(), end.copy(), share.copy()
    found = slerp(start, end, share)
    rows = [slerp(start[i, j], end[i, j], share[i, j]) for i in range(4) for j in range(5)]
    assert np.array_equal(found, np.reshape(rows, (4, 5, 3)))
    assert np.array_equal(slerp(start[0].T.copy().T, end[0], share[0]), found[0])
    assert all(np.array_equal(one, two) for one, two in zip(before, (start, end, share), strict=True))
    assert slerp(start[:0], end[:0], share[:0]).shape == (0, 5, 3)
