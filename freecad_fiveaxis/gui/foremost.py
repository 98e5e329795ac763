# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whose legend a view has: that of the object which is selected, else of the one that was selected or shown
last.

Markers, NC output and tessellation have no legend: they stand for their path. Nothing here imports numpy or
pivy.
"""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .failures import guards
from .qt import later
from .selected import kind_of

_chosen: list[Any] = []
_state = {"due": False}


@guards
class Watcher:
    """Watches the selection."""

    def addSelection(self, *_: Any) -> None:
        """Something was selected."""
        look()

    def removeSelection(self, *_: Any) -> None:
        """Something is no longer selected."""
        look()

    def setSelection(self, *_: Any) -> None:
        """All that is selected is something else now."""
        look()

    def clearSelection(self, *_: Any) -> None:
        """Nothing is selected."""
        look()


def register() -> Watcher:
    """Start watching the selection; the caller keeps the watcher."""
    watcher = Watcher()
    FreeCADGui.Selection.addObserver(watcher)
    return watcher


def look() -> None:
    """See which legends' objects are selected, once however much was selected."""
    if not _state["due"]:
        _state["due"] = True
        later(_look)


def _look() -> None:
    _state["due"] = False
    now = [box for obj in FreeCADGui.Selection.getSelection("*") for box in _legends_of(obj)]
    for box in _chosen:
        if box not in now:
            box.step_back()
    for box in now:
        if box not in _chosen:
            box.come_forward(chosen=True)
    _chosen[:] = now


def _legends_of(obj: Any) -> list[Any]:
    """Return the legend of an object, else that of the path which it belongs to; none where that was not
    drawn yet."""
    if not kind_of(obj):
        return []
    near = [obj, getattr(obj, "Path", None), *obj.InList]
    found = [legend_of(one) for one in near if kind_of(one)]
    return [box for box in found if box is not None][:1]


def legend_of(obj: Any) -> Any:
    """Return the legend of one of our objects, or None."""
    view = getattr(getattr(obj, "ViewObject", None), "Proxy", None)
    return getattr(getattr(view, "picture", None), "legend", None)
