# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the tip leaves the commanded segment while the axes move linearly, with a proven bound."""

from .bound import quick_bound
from .guided import without_guided
from .measurement import Deviation, lin_ye_deviation, measure, measure_above, same_u_deviation

__all__ = [
    "Deviation",
    "lin_ye_deviation",
    "measure",
    "measure_above",
    "quick_bound",
    "same_u_deviation",
    "without_guided",
]
