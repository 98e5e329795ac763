# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of runs of unlike lengths."""

import numpy as np
import pytest

from freecad_fiveaxis.core.base.records import number_runs


@pytest.mark.parametrize("least", [0, 1])
def test_rows_of_runs_are_numbered_in_each(least):
    count = np.random.default_rng(least).integers(least, 5, 40)
    pairs = [(run, number) for run, size in enumerate(count.tolist()) for number in range(size)]
    np.testing.assert_array_equal(np.column_stack(number_runs(count)), pairs)
    assert [part.tolist() for part in number_runs(count[:0])] == [[], []]
