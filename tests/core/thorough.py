# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameters of which some stand for all in the core ring; the others are tried too where there is time: in
`make slow`.

OTHERS_ONCE: other parts, machines, sizes, which call the same functions with other numbers: to them it is nothing
which numpy is there, so they are not tried in `make oldest` too. Kinds that take another way through the
code (a cutter, a cure, a strategy, an engine) are."""

import pytest
from _pytest.mark import ParameterSet

OTHERS_ONCE = pytest.mark.slow


def some_in_core(names, kinds, *, kept=(0,), others=pytest.mark.thorough, **more):
    """As ``pytest.mark.parametrize``; the kinds at other places than those ``kept`` are ``others``, unless
    they are ``slow``."""
    several = not isinstance(names, str) or "," in names
    made = []
    for place, kind in enumerate(kinds):
        one = (
            kind if isinstance(kind, ParameterSet) else pytest.param(*kind) if several else pytest.param(kind)
        )
        slow = any(mark.name == "slow" for mark in one.marks)
        made.append(one if place in kept or slow else one._replace(marks=(*one.marks, others)))
    return pytest.mark.parametrize(names, made, **more)
