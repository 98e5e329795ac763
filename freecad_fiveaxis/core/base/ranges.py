# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ranges that an option and the work behind it share: the option is checked, and its help is shown, without
loading the work."""

from __future__ import annotations

import math

LEAST_TILT, MOST_TILT = math.radians(1e-3), math.radians(30.0)
"""rad; how far the strategy ``minimax`` may leave the normals. Less is hardly more than the words' last
digit; with more an axis has little to do with its surface."""

OFF_POLE = math.radians(1e-3)
"""rad; a tool axis that was led is kept that far off the pole, so that it still says which first rotary word
is meant."""

LEAST_CHANGE, LARGEST_CHANGE = 10.0 * OFF_POLE, math.radians(30.0)
"""rad; how far an axis may be led past the pole. Below it there is no room to lead in; an axis that is led
further has little to do with the strategy that was chosen."""

ROUNDING = 1e-9
"""mm; a deviation that is less is what the arithmetic leaves of none."""
