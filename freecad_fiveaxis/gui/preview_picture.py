# SPDX-License-Identifier: LGPL-2.1-or-later
"""The passes of a panel's settings as plain lines over the part, before anything is computed.

They stand in the view and not in the document, and go as soon as something is changed that they may hang on.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin

from freecad_fiveaxis.core.pipeline.preview import Preview

from .failures import guards
from .qt import later
from .scene import nodes

COLOUR = (0.93, 0.20, 0.62)
"""That of no cut, link, rapid or marker."""
NEARER, WIDTH = 0.001, 1.5
SHAPES = ("Shape", "Mesh", "Placement", "Fingerprint")
"""Properties that say that a part has another form or place, or that something was computed."""


@guards
class PreviewPicture:
    """The lines of one preview in a view of the document; ``gone`` is called when a change of the document
    takes them away."""

    def __init__(self, doc: Any, gone: Callable[[], None]) -> None:
        self.doc, self.gone = doc.Name, gone
        self.scene: Any = None
        self.root: Any = None

    @property
    def shown(self) -> bool:
        """Whether there are lines."""
        return self.root is not None

    def show(self, found: Preview, origin: Sequence[float]) -> None:
        """Draw these lines, ``origin`` mm the work zero in the document, instead of those before."""
        self.clear()
        view = FreeCADGui.getDocument(self.doc).ActiveView
        if hasattr(view, "getSceneGraph"):
            self.root, self.scene = lines_of(found, origin), view.getSceneGraph()
            self.scene.addChild(self.root)
            FreeCAD.addDocumentObserver(self)

    def clear(self) -> None:
        """Take the lines away."""
        if self.root is not None:
            self.scene.removeChild(self.root)
            FreeCAD.removeDocumentObserver(self)
        self.root = self.scene = None

    def slotChangedObject(self, obj: Any, prop: str) -> None:
        """FreeCAD calls this after each change of a property."""
        if self.shown and prop in SHAPES and obj.Document.Name == self.doc:
            later(self._leave)

    def slotDeletedObject(self, obj: Any) -> None:
        """FreeCAD calls this before an object goes."""
        if self.shown and obj.Document.Name == self.doc:
            later(self._leave)

    def _leave(self) -> None:
        if self.shown:
            self.clear()
            self.gone()


def lines_of(found: Preview, origin: Sequence[float]) -> Any:
    """Return the lines of a preview as one node, which the mouse does not see."""
    lines, place = coin.SoLineSet(), coin.SoTranslation()
    place.translation.setValue(*origin)
    lines.vertexProperty = nodes.vertices(found.point)
    lines.numVertices.setValues(0, len(found.sizes), np.ascontiguousarray(found.sizes, np.int32))
    look = (nodes.unpickable(), nodes.flat(), nodes.nearer(NEARER), nodes.colour(COLOUR), nodes.style(WIDTH))
    return nodes.separate(place, *look, lines)
