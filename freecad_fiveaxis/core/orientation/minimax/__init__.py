# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool axes with the smallest largest deviation (``minimax``)."""

from .apply import minimax_axes

__all__ = ["minimax_axes"]
