# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever a machine file holds: a machine that works, or one clear line."""

from __future__ import annotations

import copy
import json

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from freecad_fiveaxis.core.base.errors import FileError, MachineError
from freecad_fiveaxis.core.machine import load_machine, save_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, inverse
from freecad_fiveaxis.core.machine.machine_file import machine_folder

SHIPPED = [path.read_bytes() for path in sorted(machine_folder().glob("*.fcm"))]
QUICK = settings(
    max_examples=150,
    deadline=None,
    database=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow],
)

numbers = st.one_of(st.integers(), st.floats(), st.sampled_from([0, 1, -1, 99999, 1e308, 5e-324, 10**400]))
words = st.one_of(
    st.text(max_size=8),
    st.sampled_from(["A", "X", "C", "linear", "rotary", "table_rotary", "head_linear", "imperial"]),
)
leaves = st.one_of(st.none(), st.booleans(), numbers, words)
values = st.recursive(
    leaves,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(words, inner, max_size=4),
    max_leaves=8,
)


def ways(node, way=()):
    """Every place in a tree of objects and lists."""
    yield way
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for key, child in children:
        yield from ways(child, (*way, key))


WAYS = [[way for way in ways(json.loads(content)) if way] for content in SHIPPED]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("machines")


def load_or_refuse(content, folder):
    """Load the bytes; a machine must save, load again and turn, a refusal must be one line."""
    path = folder / "fuzzed.fcm"
    path.write_bytes(content)
    try:
        machine = load_machine(path)
        kinematics = chain(machine, Setup(machine.origin, 50.0))
    except (MachineError, FileError) as error:
        text = str(error)
        assert text and "\n" not in text
        text.encode()
        return
    again = folder / "again.fcm"
    save_machine(machine, again, overwrite=True)
    assert load_machine(again) == machine
    tip, axis = forward(kinematics, np.array([(1.0, 2.0, 3.0, 0.4, 0.5)]))
    assert np.isfinite(tip).all() and np.isfinite(axis).all()
    inverse(kinematics, tip, axis)


@pytest.mark.thorough
@QUICK
@given(st.data(), st.integers(0, len(SHIPPED) - 1), st.integers(1, 3))
def test_a_file_with_anything_anywhere_loads_or_is_refused_in_one_line(folder, data, which, changes):
    tree = json.loads(SHIPPED[which])
    for _ in range(changes):
        way = data.draw(st.sampled_from(WAYS[which]))
        spoil(tree, way, data.draw(values), data.draw(st.booleans()))
    load_or_refuse(json.dumps(tree).encode(), folder)


def spoil(tree, way, value, remove):
    """Put a value at a place, or take the place away; a place that an earlier change has removed is left
    alone."""
    for key in way[:-1]:
        if not isinstance(tree, (dict, list)) or (isinstance(tree, dict) and key not in tree):
            return
        if isinstance(tree, list) and (not isinstance(key, int) or key >= len(tree)):
            return
        tree = tree[key]
    last = way[-1]
    if isinstance(tree, dict) or (isinstance(tree, list) and isinstance(last, int) and last < len(tree)):
        tree[last] = copy.deepcopy(value)
        if remove:
            del tree[last]


@QUICK
@given(st.data(), st.integers(0, len(SHIPPED) - 1))
def test_a_file_with_damaged_bytes_loads_or_is_refused_in_one_line(folder, data, which):
    content = bytearray(SHIPPED[which])
    for _ in range(data.draw(st.integers(1, 4))):
        place = data.draw(st.integers(0, len(content) - 1))
        content[place : place + data.draw(st.integers(0, 3))] = data.draw(st.binary(max_size=3))
    load_or_refuse(bytes(content), folder)


@QUICK
@given(st.one_of(st.binary(max_size=300), values.map(lambda value: json.dumps(value).encode())))
def test_any_bytes_and_any_json_are_refused_in_one_line(folder, content):
    load_or_refuse(content, folder)


def test_the_fuzz_would_notice_a_machine_that_does_not_come_back(folder):
    content = SHIPPED[-1]
    load_or_refuse(content, folder)
    (folder / "fuzzed.fcm").write_bytes(content)
    assert load_machine(folder / "fuzzed.fcm") != load_machine("fork_head_bc")
