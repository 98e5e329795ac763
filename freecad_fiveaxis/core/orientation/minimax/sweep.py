# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cheapest way through the states of every run: dynamic programming, all runs at once.

The states of a run's rows are the layers of a graph. The sweep goes once along the runs, a row of each at a
time, and keeps for every state the cost of the cheapest way to it and where that came from.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints


def cheapest(cost: Floats, entry: Floats, first: Ints, size: Ints) -> Ints:
    """Return the state (k,) of each row on the cheapest way through its run.

    ``cost`` (m, m, k - 1) of the step from row i to i + 1, inf where there is none; those from one run to the
    next are not used. ``entry`` (m, k) cost of being in a state. ``first``, ``size`` (p,): the rows of each
    run.
    """
    cost, entry = (np.ascontiguousarray(np.moveaxis(table, -1, 0)) for table in (cost, entry))
    order = np.argsort(-size, kind="stable")
    first, size = first[order], size[order]
    value = entry[first]
    trace = np.zeros(entry.shape, np.int16)
    longest = int(size[0])
    alive = np.searchsorted(
        -size, -np.arange(longest), side="left"
    )  # how many runs have more than so many rows
    for step in range(1, longest):
        at = first[: alive[step]] + step
        total = value[: len(at), :, None] + cost[at - 1]
        origin = total.argmin(axis=1)
        trace[at] = origin
        value[: len(at)] = np.take_along_axis(total, origin[:, None], 1)[:, 0] + entry[at]
    state = np.empty(len(entry), np.int64)
    state[first + size - 1] = value.argmin(axis=1)
    for step in range(longest - 1, 0, -1):
        at = first[: alive[step]] + step
        state[at - 1] = trace[at, state[at]]
    return state
