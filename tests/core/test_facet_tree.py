# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tree of the facets: the same by portions of any size and any number of threads; and what puts columns
in order for large meshes."""

import dataclasses

import numpy as np
import pytest
from gouge_examples import bowl

from freecad_fiveaxis.core.base import chunks
from freecad_fiveaxis.core.geometry import facet_tree
from freecad_fiveaxis.core.gouge.obstacles import _each_once
from freecad_fiveaxis.core.passes.geodesic import _order_by_count


def columns(tree):
    return {name: value for name, value in vars(tree).items() if isinstance(value, np.ndarray)}


def alike(one, two):
    return all(np.array_equal(column, columns(two)[name]) for name, column in columns(one).items())


@pytest.mark.parametrize(("at_once", "top", "processors"), [(1, 0, 1), (64, 3, 3), (100, 40, 2)])
def test_the_tree_is_the_same_by_portions_of_any_size_and_any_threads(monkeypatch, at_once, top, processors):
    mesh = bowl()
    whole = facet_tree.build_facet_tree(mesh)
    monkeypatch.setattr(facet_tree, "AT_ONCE", at_once)
    monkeypatch.setattr(facet_tree, "TOP", top)
    monkeypatch.setattr(chunks, "ALONE", processors == 1)
    monkeypatch.setattr(chunks, "PROCESSORS", processors)
    assert alike(whole, facet_tree.build_facet_tree(mesh))


def test_another_tree_would_be_noticed():
    mesh = bowl()
    whole = facet_tree.build_facet_tree(mesh)
    assert not alike(
        whole, facet_tree.build_facet_tree(dataclasses.replace(mesh, vertex=mesh.vertex * 1.0001))
    )


def test_each_facet_comes_first_once_and_copies_are_marked():
    tree = facet_tree.build_facet_tree(bowl())
    assert np.array_equal(
        tree.facet_first, np.isin(np.arange(len(tree.facet)), np.unique(tree.facet, return_index=True)[1])
    )


def test_points_are_put_in_order_as_unique_rows_are():
    point = np.random.default_rng(1).integers(0, 4, (500, 3)).astype(float)
    assert np.array_equal(_each_once(np.ascontiguousarray(point.T)), np.unique(point, axis=0))
    assert _each_once(np.empty((3, 0))).shape == (0, 3)


def test_keys_are_counted_as_a_stable_sort_puts_them():
    key = np.random.default_rng(2).integers(0, 30, 2000)
    assert np.array_equal(_order_by_count(key, 31), np.argsort(key, kind="stable"))
    assert not np.array_equal(_order_by_count(key, 31), np.argsort(-key, kind="stable"))
