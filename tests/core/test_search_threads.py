# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries and rest material by several threads: the same numbers as by one; where the work is stopped, all
threads end soon."""

import threading

import numpy as np
import pytest
from gouge_examples import bowl

from freecad_fiveaxis.core.base import chunks
from freecad_fiveaxis.core.base.errors import Cancelled
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.gouge import rest_material, search, straight_motion
from freecad_fiveaxis.core.gouge.rest_material import find_rest_material
from freecad_fiveaxis.core.gouge.search import find_demanded_lift, find_entries
from freecad_fiveaxis.core.gouge.swept_motion import ways_up
from freecad_fiveaxis.core.tool.body import Body, Piece

BODY = Body((Piece(3.0, 0.0, 20.0, 0.0, 3.0),))


@pytest.fixture(autouse=True)
def small_batches(monkeypatch):
    monkeypatch.setattr(search, "FEW", 8)
    monkeypatch.setattr(search, "BATCH", 16)
    monkeypatch.setattr(rest_material, "CHUNK", 400)


@pytest.fixture
def mesh():
    return bowl()


def poses(mesh, count=400):
    """A walk over the part's corners, now in it and now out of it, with axes that lean."""
    rng = np.random.default_rng(3)
    axis = np.array([0.0, 0.0, 1.0]) + 0.3 * rng.normal(size=(count, 3))
    tip = mesh.vertex[rng.integers(len(mesh.vertex), size=count)] + rng.normal(0.0, 1.0, (count, 3))
    return tip, axis / np.linalg.norm(axis, axis=1)[:, None]


def with_threads(monkeypatch, count, work):
    """What ``work`` gives on so many threads, and how many took part."""
    monkeypatch.setattr(chunks, "ALONE", count == 1)
    monkeypatch.setattr(chunks, "PROCESSORS", count)
    seen = set()

    def traced(*given, own=search._Search.batch):
        seen.add(threading.get_ident())
        return own(*given)

    with monkeypatch.context() as patched:
        patched.setattr(search._Search, "batch", traced)
        return work(), len(seen)


def columns(entries):
    return [entries.depth, entries.bound, entries.u, entries.place, entries.facet, entries.part]


@pytest.mark.thorough
@pytest.mark.parametrize("count", [2, 5])
def test_entries_are_the_same_to_the_last_bit_by_any_number_of_threads(monkeypatch, mesh, count):
    tree, swept = facet_tree(mesh), straight_motion(*poses(mesh))
    one, alone = with_threads(monkeypatch, 1, lambda: find_entries(BODY, tree, swept, 0.01))
    many, threads = with_threads(monkeypatch, count, lambda: find_entries(BODY, tree, swept, 0.01))
    assert alone == 1 and 1 <= threads <= count
    assert (one.depth > 0.0).sum() > 50 and (one.depth == 0.0).sum() > 50
    assert all((a == b).all() for a, b in zip(columns(one), columns(many), strict=True))


def test_only_the_blocks_requested_are_filled_in(monkeypatch, mesh):
    tree, swept, some = facet_tree(mesh), straight_motion(*poses(mesh)), np.arange(3, 300, 3)
    found, _ = with_threads(monkeypatch, 3, lambda: find_entries(BODY, tree, swept, 0.01, blocks=some))
    others = np.setdiff1d(np.arange(len(swept)), some)
    assert (found.depth[some] > 0.0).any() and not found.depth[others].any() and not found.bound[others].any()


def test_no_block_is_no_work(mesh):
    found = find_entries(
        BODY, facet_tree(mesh), straight_motion(*poses(mesh)), 0.01, blocks=np.zeros(0, np.int64)
    )
    assert not found.depth.any()


def test_demanded_lifts_are_the_same_by_any_number_of_threads(monkeypatch, mesh):
    tip, axis = poses(mesh)
    tree, up = facet_tree(mesh), ways_up(tip, axis, np.full(len(tip), 4.0))
    one, _ = with_threads(monkeypatch, 1, lambda: find_demanded_lift(BODY, tree, up, 0.01))
    many, _ = with_threads(monkeypatch, 4, lambda: find_demanded_lift(BODY, tree, up, 0.01))
    assert (one > 0.0).sum() > 50 and (one == many).all()


@pytest.mark.parametrize("enough", [-np.inf, 0.05])
def test_rest_material_is_the_same_by_any_number_of_threads(monkeypatch, mesh, enough):
    swept = straight_motion(*poses(mesh))

    def find():
        left = find_rest_material(mesh, BODY, swept, np.arange(len(swept)), 2.0, enough=enough)
        return np.stack([left.height, left.block.astype(float)])

    one, _ = with_threads(monkeypatch, 1, find)
    many, _ = with_threads(monkeypatch, 4, find)
    assert one.shape[1] > 800 and (one == many).all()


@pytest.mark.parametrize("word", [1, 4])
def test_where_the_work_is_stopped_every_thread_ends_at_its_next_tick(monkeypatch, mesh, word):
    """The helper is kept within its first batch until the caller has been stopped; it would go on with it for
    ever."""
    monkeypatch.setattr(chunks, "ALONE", False)
    monkeypatch.setattr(chunks, "PROCESSORS", 2)
    monkeypatch.setattr(search, "PAUSE", -1.0)
    caller, stopped, message = threading.get_ident(), threading.Event(), []

    def batch(self, blocks, ticks):
        if threading.get_ident() != caller:
            stopped.wait(300.0)
            while True:
                ticks()
        ticks()

    def progress(stage, share):
        assert threading.get_ident() == caller
        message.append(share)
        if len(message) == word:
            stopped.set()
            raise Cancelled("stopped")

    monkeypatch.setattr(search._Search, "batch", batch)
    before = threading.active_count()
    with pytest.raises(Cancelled):
        find_entries(BODY, facet_tree(mesh), straight_motion(*poses(mesh)), 0.01, progress=progress)
    assert len(message) == word and message == sorted(message) and threading.active_count() == before
