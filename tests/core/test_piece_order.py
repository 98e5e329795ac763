# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of polylines: never more air than in the order of the passes, near the best of all orders of a
few pieces, and every polyline whole."""

from itertools import permutations, product

import numpy as np
import pytest
from gouge_examples import blade_beside_hub
from plain import build_settings

from freecad_fiveaxis.core.passes import ContactPath
from freecad_fiveaxis.core.passes.piece_order import Tour, air, find_tour, order_pieces
from freecad_fiveaxis.core.pipeline import job


def pieces(count, seed, length=5.0):
    """(count, 2, 3) mm: ends of short pieces in a cube of 50 mm."""
    random = np.random.default_rng(seed)
    start = 50.0 * random.random((count, 3))
    return np.stack([start, start + length * random.normal(size=(count, 3))], axis=1)


def path_of(ends, rows=6):
    """A contact path of straight polylines of ``rows`` rows between these ends."""
    share = np.repeat(np.linspace(0.0, 1.0, rows // 2 + 1), 2)[1:-1]
    point = (ends[:, :1] + share[None, :, None] * (ends[:, 1:] - ends[:, :1])).reshape(-1, 3)
    number = np.repeat(np.arange(len(ends)), rows)
    row = np.arange(len(point))
    return ContactPath(
        point, np.tile([0.0, 0.0, 1.0], (len(point), 1)), row >> 1, row, row >> 1, number, number
    )


def as_they_are(ends):
    return Tour(np.arange(len(ends)), np.zeros(len(ends), bool))


def best_air(ends):
    """The least air of all orders that begin with the first piece as it is."""
    rest = range(1, len(ends))
    return min(
        air(ends, Tour(np.array([0, *order]), np.array([False, *back])))
        for order in permutations(rest)
        for back in product([False, True], repeat=len(ends) - 1)
    )


@pytest.mark.parametrize("seed", range(6))
def test_of_a_few_pieces_the_tour_is_near_the_best_there_is(seed):
    ends = pieces(6, seed)
    assert best_air(ends) - 1e-9 <= air(ends, find_tour(ends)) <= 1.25 * best_air(ends)


def test_the_order_of_the_passes_is_not_near_the_best():
    """The comparison above can fail."""
    ends = pieces(6, 0)
    assert air(ends, as_they_are(ends)) > 1.25 * best_air(ends)


@pytest.mark.parametrize("count", [1, 2, 3, 40, 300])
def test_every_polyline_is_cut_once_and_whole(count):
    ends = pieces(count, count)
    path = path_of(ends)
    ordered = order_pieces(path)
    assert sorted(ordered.face.tolist()) == sorted(path.face.tolist())
    assert (
        np.array_equal(np.unique(ordered.polyline), np.arange(count))
        and (np.diff(ordered.polyline) >= 0).all()
    )
    assert np.array_equal(ordered.segment, np.arange(len(ordered.point)) >> 1)
    for number in range(count):
        rows = np.flatnonzero(ordered.polyline == number)
        source = ordered.coedge[rows]  # here: the row of the path given
        assert abs(source[-1] - source[0]) == len(rows) - 1 and len(set(np.diff(source))) == 1
        assert np.array_equal(ordered.point[rows], path.point[source])
    if count >= 40:
        assert air(pieces(count, count), find_tour(ends)) < 0.5 * air(ends, as_they_are(ends))


def test_an_order_that_is_good_already_stays_the_very_path():
    start = np.array([[0.0, 2.0 * i, 0.0] for i in range(8)])
    side = np.array([[30.0, 0.0, 0.0]])
    ends = np.stack(
        [
            np.where(np.arange(8)[:, None] % 2, start + side, start),
            np.where(np.arange(8)[:, None] % 2, start, start + side),
        ],
        axis=1,
    )
    path = path_of(ends)
    assert order_pieces(path) is path


def test_passes_in_one_direction_keep_it_and_those_to_and_fro_spare_air():
    def milled(order):
        options = {
            "machine": "trunnion_ac",
            "tool_length": 120,
            "cutter": "ball:8",
            "stepover": 2,
            "max_axis_angle": 60,
        }
        draft = job.make(
            build_settings("mill", "part", {**options, "order": order, "passes": "scallop", "gouge": "off"}),
            mesh=mesh,
        )
        first = np.flatnonzero(np.diff(draft.contact.polyline, prepend=-1))
        return np.stack(
            [
                draft.contact.point[first],
                draft.contact.point[np.append(first[1:], len(draft.contact.point)) - 1],
            ],
            axis=1,
        )

    mesh = blade_beside_hub(cells=24)
    one, both = milled("one_way"), milled("zigzag")
    assert len(one) == len(both) > 10
    assert air(both, as_they_are(both)) < 0.8 * air(one, as_they_are(one))
