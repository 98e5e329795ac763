# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the legends of several objects stand beside each other in one view."""

from __future__ import annotations

from itertools import takewhile
from typing import Any

from .view_providers import kind_of

PATHS, MAPS = ("toolpath", "audit"), ("setups", "left")
"""What has a legend at the left edge of the view, and at the right one."""


def legend_slot(obj: Any, kinds: tuple[str, ...]) -> int:
    """How many other objects of these kinds show their legend before this one, at the same edge of the view."""
    others = (one for one in obj.Document.Objects if kind_of(one) in kinds)
    before = takewhile(lambda one: one != obj, others)  # an object that is being deleted is not among them
    return sum(one.ViewObject.Visibility and getattr(one.ViewObject, "ShowLegend", False) for one in before)
