# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes round parts with inside corners sharper than a right angle: nothing vanishes that the ball can
cut."""

from functools import cache

import numpy as np
import pytest
from offset_examples import chords, clearance, distance, prism
from scipy.spatial import cKDTree
from thorough import some_in_core

from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.passes import PASS_STRATEGIES, PassOptions, Region, cut, flat_interval
from freecad_fiveaxis.core.toolpath.coedge import close_gaps, trimming

RADIUS, SCALLOP = 3.0, 0.02
STEP = flat_interval(RADIUS, SCALLOP)
FREE, FINISHED = 1e-6, 0.05
"""mm: a ball that touches the part is free where it enters no more; what is left on a place that counts as
finished."""


def undercut(degrees):
    """A block 40 x 30 x 30 mm, open above a floor at z 10 from x 5 on, whose wall leans over the floor."""
    over = 5.0 + 20.0 * np.tan(np.radians(degrees))
    outline = [(-20.0, 0.0), (20.0, 0.0), (20.0, 10.0), (5.0, 10.0), (over, 30.0), (-20.0, 30.0)]
    corner = np.array([(x, y, z) for y in (-15.0, 15.0) for x, z in outline])
    caps = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]])
    one = np.arange(6)
    two = (one + 1) % 6
    sides = np.concatenate([np.stack([one, one + 6, two], axis=1), np.stack([two, one + 6, two + 6], axis=1)])
    return from_faces(corner, np.concatenate([caps, caps[:, ::-1] + 6, sides]))


def passes(mesh):
    """Passes one beside the other from the border of the underside, as they lead round the part."""
    keep = mesh.normal[:, 2] > -0.9
    region, options = Region(mesh, keep, RADIUS, STEP), PassOptions(scallop=SCALLOP)
    return cut(region, PASS_STRATEGIES["scallop"].field(region, options), "zigzag")


def samples(mesh, count=4000):
    random = np.random.default_rng(7)
    row = random.choice(len(mesh.face), count, p=mesh.area / mesh.area.sum())
    share = random.random((count, 2))
    share = np.where(share.sum(1, keepdims=True) > 1, 1 - share, share)
    a, b, c = mesh.vertex[mesh.face[row]].transpose(1, 0, 2)
    return a + share[:, :1] * (b - a) + share[:, 1:] * (c - a), mesh.normal[row]


def swept(path, step=0.05):
    """Centres of the ball along the path, so near to each other."""
    row = np.flatnonzero(path.polyline[1:] == path.polyline[:-1])
    length = np.linalg.norm(path.centre[row + 1] - path.centre[row], axis=1)
    count = np.ceil(length / step).astype(int) + 1
    owner = np.repeat(np.arange(len(row)), count)
    share = (np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)) / count[owner]
    start, end = path.centre[row], path.centre[row + 1]
    return start[owner] + share[:, None] * (end - start)[owner]


def finished_share(mesh, path):
    """Of the area that the ball can touch without entering the part, but for the underside, the share that it
    finishes; by brute force."""
    point, normal = samples(mesh)
    point, normal = point[normal[:, 2] > -0.9], normal[normal[:, 2] > -0.9]
    corner = mesh.vertex[mesh.face]
    can = np.array([distance(one[None], corner).min() > RADIUS - FREE for one in point + RADIUS * normal])
    assert can.sum() > 500
    return np.mean(cKDTree(swept(path)).query(point[can])[0] - RADIUS < FINISHED)


undercut_block = cache(undercut)


@cache
def passes_round(degrees):
    """The passes round the block whose wall leans so much."""
    return passes(undercut_block(degrees))


@cache
def offset_path(degrees):
    """The offset path of these passes, made once: no test changes it."""
    return close_gaps(passes_round(degrees), undercut_block(degrees), RADIUS, 0.01)


@cache
def by_planes_without_end(degrees):
    """The offset path where no facet's end counts."""
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(trimming, "spare_free", lambda chords, part, gone: gone)
        patched.setattr(trimming, "break_unmet", lambda chords, part, uncut: None)
        return close_gaps(passes_round(degrees), undercut_block(degrees), RADIUS, 0.01)


BLOCKS = 10.0, 30.0
each_block = pytest.mark.parametrize("degrees", BLOCKS)


def entered_length(path, mesh):
    """The length, mm, of chords that enter the part by more than 0.05 mm somewhere: for the cure of gouges."""
    point, _ = chords(path)
    return np.linalg.norm(point[-1] - point[0], axis=1)[clearance(path, mesh) < RADIUS - 0.05].sum()


@some_in_core("degrees", BLOCKS, kept=(1,))
def test_what_the_ball_can_touch_is_finished(degrees):
    path = offset_path(degrees)
    assert finished_share(undercut_block(degrees), path) >= 0.97
    assert [one.code for one in path.findings].count("corner-not-reached") == 1


@each_block
def test_the_share_notices_trims_by_planes_without_end(degrees):
    assert finished_share(undercut_block(degrees), by_planes_without_end(degrees)) < 0.97


@pytest.mark.thorough
@each_block
def test_a_break_enters_nothing_that_was_not_entered_before(degrees):
    block = undercut_block(degrees)
    before = entered_length(by_planes_without_end(degrees), block)
    assert entered_length(offset_path(degrees), block) <= before


@pytest.mark.oldest
@pytest.mark.thorough
@each_block
def test_no_closed_pass_vanishes(degrees):
    contact = passes_round(degrees)
    assert least_share_of_a_pass(contact, offset_path(degrees)) > 0.5
    assert least_share_of_a_pass(contact, by_planes_without_end(degrees)) < 0.1


def least_share_of_a_pass(contact, path):
    """Of each pass longer than 100 mm the length that is cut, as a share; the least."""
    before, after = contact.point[::2], contact.point[1::2]
    whole = np.bincount(contact.pass_[::2], np.linalg.norm(after - before, axis=1))
    row = np.flatnonzero(np.diff(path.polyline) == 0)
    length = np.linalg.norm(path.point[row + 1] - path.point[row], axis=1)
    cut_ = np.bincount(path.pass_[row], length, minlength=len(whole))
    return (cut_ / np.maximum(whole, 1e-9))[whole > 100.0].min()


def test_each_piece_of_a_broken_pass_is_a_polyline_of_its_own():
    contact, path = passes_round(30.0), offset_path(30.0)
    begins = np.flatnonzero(np.diff(path.polyline, prepend=-1))
    assert len(begins) > len(np.unique(contact.polyline)) and not path.fill[begins].any()
    assert set(np.diff(path.polyline)) <= {0, 1}
    assert np.diff(begins, append=len(path.point)).min() >= 2


def test_where_some_facets_are_not_cut_pieces_are_the_same():
    """Whether or not the caps are cut, the other facets have the same rows."""
    block, whole = undercut_block(30.0), offset_path(30.0)
    keep = np.abs(block.normal[:, 1]) < 0.5
    part = close_gaps(passes_round(30.0), block, RADIUS, 0.01, keep)
    assert keep[part.face].all()
    wanted = keep[whole.face] & ~whole.fill
    assert np.quantile(cKDTree(swept(part)).query(whole.centre[wanted])[0], 0.9) < 0.1


@pytest.mark.parametrize("degrees", [30.0, 50.0, 75.0, 90.0, 120.0])
def test_in_a_notch_the_ball_stops_where_it_touches_both_sides(degrees):
    """R / tan(phi / 2) from the edge, its centre R / sin(phi / 2)."""
    half = 0.5 * np.radians(degrees)
    side = 60.0 * np.array([np.sin(half), np.cos(half)])
    contact = prism([(-side[0], side[1]), (0.0, 0.0), (side[0], side[1])])
    far = from_faces([[900, 0, 0], [901, 0, 0], [900, 1, 0]], [[0, 1, 2]])
    path = close_gaps(contact, far, RADIUS, 0.01)
    lowest = path.centre[:, 2].argmin()
    assert np.linalg.norm(path.point[lowest]) == pytest.approx(RADIUS / np.tan(half), abs=1e-9)
    assert np.linalg.norm(path.centre[lowest]) == pytest.approx(RADIUS / np.sin(half), abs=1e-9)
