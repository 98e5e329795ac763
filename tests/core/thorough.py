# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameters of which some stand for all in the core ring; the others are tried too where there is time: in
`make slow`."""

import pytest
from _pytest.mark import ParameterSet


def some_in_core(names, kinds, *, kept=(0,), **more):
    """As ``pytest.mark.parametrize``; the kinds at other places than those ``kept`` are ``thorough``, unless
    they are ``slow``."""
    several = not isinstance(names, str) or "," in names
    result = []
    for place, kind in enumerate(kinds):
        one = (
            kind if isinstance(kind, ParameterSet) else pytest.param(*kind) if several else pytest.param(kind)
        )
        slow = any(mark.name == "slow" for mark in one.marks)
        result.append(
            one if place in kept or slow else one._replace(marks=(*one.marks, pytest.mark.thorough))
        )
    return pytest.mark.parametrize(names, result, **more)
