# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks over tolerance, divided into the fewest that hold it."""

from .linearization import linearize, linearize_words

__all__ = ["linearize", "linearize_words"]
