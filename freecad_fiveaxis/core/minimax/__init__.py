# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool axes with the smallest largest deviation (``minimax``)."""

from .minimax import LEAST_TILT, MOST_TILT, minimax_axes

__all__ = ["LEAST_TILT", "MOST_TILT", "minimax_axes"]
