# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tells the player when its object changes or goes. FreeCAD calls the methods by their names."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD

from freecad_fiveaxis.app.properties import CUTTER
from freecad_fiveaxis.gui.failures import guards

WATCHED = {"Fingerprint", "WorkZero", "Shank", "Holder", *(one.name for one in CUTTER)}
"""A change of these changes the picture; a new result has a new Fingerprint."""


@guards
class Watch:
    """Watches one object: calls ``changed`` where the picture is out of date, ``gone`` where object or
    document is deleted."""

    def __init__(self, obj: Any, changed: Callable[[], None], gone: Callable[[], None]) -> None:
        self._document, self._name = obj.Document.Name, obj.Name
        self._changed, self._gone, self._watching = changed, gone, True
        FreeCAD.addDocumentObserver(self)

    def stop(self) -> None:
        """Watch no longer. May be called twice."""
        if self._watching:
            self._watching = False
            FreeCAD.removeDocumentObserver(self)

    def slotChangedObject(self, obj: Any, name: str) -> None:
        """Hear that a property was set."""
        if self._watching and name in WATCHED and self._is_ours(obj):
            self._changed()

    def slotDeletedObject(self, obj: Any) -> None:
        """Hear that an object is about to be deleted."""
        if self._watching and self._is_ours(obj):
            self._gone()

    def slotDeletedDocument(self, document: Any) -> None:
        """Hear that a document is about to be closed."""
        if self._watching and document.Name == self._document:
            self._gone()

    def _is_ours(self, obj: Any) -> bool:
        return obj.Name == self._name and obj.Document is not None and obj.Document.Name == self._document
