# SPDX-License-Identifier: LGPL-2.1-or-later
"""A few hundred spoilt files of every kind: taken or refused in one line. ``run.py`` goes on for minutes."""

from __future__ import annotations

import random

import pytest
from fuzzing import hunt, tried
from mutations import spoilt
from targets import TARGETS, Target

from freecad_fiveaxis.core.base.errors import FileError

RUNS = {"stl": 10, "command": 60, "machine": 60, "job": 150, "ini": 100}


@pytest.mark.parametrize("name", sorted(TARGETS))
def test_seeds_and_spoilt_copies_are_taken_or_refused_in_one_line(name, tmp_path):
    target = TARGETS[name]
    assert target.seeds
    flaws = [tried(target, seed, tmp_path) for seed in target.seeds] + list(
        hunt(target, 7, RUNS.get(name, 25), tmp_path)
    )
    found = [flaw for flaw in flaws if flaw is not None]
    assert not found, f"{len(found)}: {found[0].texts}\n{found[0].data!r}"


def test_what_is_neither_taken_nor_refused_is_seen(tmp_path):
    def message(read, seconds=5.0):
        flaw = tried(Target((b"",), read, ".nc"), b"G0 X1", tmp_path, seconds)
        return None if flaw is None else flaw.message

    def raises(error):
        def read(_path):
            raise error

        return read

    def hangs(_path):
        while True:
            pass

    assert message(lambda path: path.read_bytes()) is None and message(raises(FileError("no", "p"))) is None
    assert "ZeroDivisionError" in message(lambda _path: 1 / 0) and "several lines" in message(
        raises(FileError("a\nb", "p"))
    )
    assert "SystemExit" in message(raises(SystemExit(3))) and "more than 0.1 s" in message(hangs, 0.1)


def test_the_same_seed_spoils_the_same_way_and_all_seeds_are_spoilt():
    data = b"G1 X1.5 Y2\nG1 Z3\n" * 5
    assert spoilt(data, random.Random(3)) == spoilt(data, random.Random(3))
    assert len({spoilt(data, random.Random(seed)) for seed in range(40)}) > 35
