# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words of 64 bits: what is sorted and the number of its row in one, since sorting words is several times
faster than argsort."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from freecad_fiveaxis.core.base.chunks import meanwhile

Words = NDArray[np.uint64]
T = TypeVar("T")


def sort_during(word: Words, work: Callable[[], T]) -> T:
    """Sort ``word`` in place while ``work`` is done; what that gives.

    numpy sorts without holding up Python, so a second thread does it beside any other work, even beside short
    steps of numpy. Two threads that both take short steps only wait for one another.
    """
    return meanwhile(word.sort, work)
