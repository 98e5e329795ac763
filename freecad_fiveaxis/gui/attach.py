# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gives each of our document objects its view provider, whoever made it: a command, a macro, or FreeCAD
without a window.

Nothing here imports numpy: it runs when FreeCAD's window starts.
"""

from __future__ import annotations

import sys
from importlib import import_module
from typing import Any

import FreeCAD

from . import redraw
from .failures import guards
from .qt import later
from .views import HOLDER

VIEWS = {
    "freecad_fiveaxis.app.tessellation": "view_providers.TessellationView",
    "freecad_fiveaxis.app.toolpath": "view_providers.PathView",
    "freecad_fiveaxis.app.auditing": "view_providers.PathView",
    "freecad_fiveaxis.app.markers": "view_providers.MarkersView",
    "freecad_fiveaxis.app.nc_output": "view_providers.NCOutputView",
    "freecad_fiveaxis.app.setups": "view_providers.SetupMapView",
    "freecad_fiveaxis.app.job_setup": "job_setup_view.JobSetupView",
    "freecad_fiveaxis.app.left": "left_view.LeftMapView",
    "freecad_fiveaxis.app.reach": "reach_view.ReachMapView",
}
"""The module of a document object's proxy, and module and class of the view that shows it."""


@guards
class Observer:
    """Watches all documents."""

    def slotChangedObject(self, obj: Any, name: str) -> None:
        """Give a new object its view as soon as it has its proxy; what depends on a changed object may be out
        of date."""
        if (
            FreeCAD.isRestoring()
        ):  # the views of the file come later; one that stood here already would be pushed aside
            return
        if name == "Proxy":
            attach(obj)
        elif name == "Path" and hasattr(getattr(obj, "Path", None), "Proxy"):
            _adopt(obj.Path)
        elif name in ("Group", "Placement") and obj.hasExtension(HOLDER):
            _stand_anew(obj.Document)
        elif name != "Visibility":
            _look_again(obj.Document, obj)

    def slotDeletedObject(self, obj: Any) -> None:
        """Forget a path that goes, and what is listed of it; where markers go, their path draws its own
        again."""
        _forget(obj)
        _look_again(obj.Document)

    def slotDeletedDocument(self, doc: Any) -> None:
        """Forget what a document held that is closed."""
        _forget(doc)

    def slotRecomputedDocument(self, doc: Any) -> None:
        """Take away what says "out of date", where it is so no more."""
        _look_again(doc, only_old=True)

    def slotUndoDocument(self, doc: Any) -> None:
        """Settle what undo brings back: it may be current, though FreeCAD would have it recomputed."""
        later(lambda: _settle(doc))
        _tell_panel(doc)

    def slotRedoDocument(self, doc: Any) -> None:
        """Settle what redo brings back."""
        later(lambda: _settle(doc))

    def slotFinishRestoreDocument(self, doc: Any) -> None:
        """Give views to a document that was made without a window, and has none yet."""
        for obj in doc.Objects:
            attach(obj)
        _look_again(doc)


_watching: list[Any] = []


def register() -> None:
    """Start watching, and look at what is open already. A second call does nothing."""
    if _watching:
        return
    from . import findings_panel, foremost, waiting

    waiting.register()
    _watching.extend((Observer(), findings_panel.register(), foremost.register()))
    FreeCAD.addDocumentObserver(_watching[0])
    for doc in FreeCAD.listDocuments().values():
        _watching[0].slotFinishRestoreDocument(doc)


def attach(obj: Any) -> None:
    """Give the object its view where it is one of ours and has none."""
    view = VIEWS.get(type(getattr(obj, "Proxy", None)).__module__)
    if view and obj.ViewObject is not None and not getattr(obj.ViewObject, "Proxy", None):
        module, name = view.split(".")
        getattr(import_module(f".{module}", __package__), name)(obj.ViewObject)


def _settle(doc: Any) -> None:
    """Keep what is current from being recomputed. Documents without an object of ours are left alone, and
    numpy unloaded."""
    if not any(doc is one for one in FreeCAD.listDocuments().values()):
        return
    if any(
        type(getattr(obj, "Proxy", None)).__module__ in VIEWS and "Touched" in obj.State
        for obj in doc.Objects
    ):
        from freecad_fiveaxis.app.restored import settle

        if settle(doc):
            _look_again(doc)


def _adopt(path: Any) -> None:
    """Let a path adopt a new child."""
    view = _view_of(path)
    if hasattr(view, "adopt"):
        view.adopt()


def _view_of(obj: Any) -> Any:
    """Return the view provider of an object, or None."""
    try:
        return getattr(obj.ViewObject, "Proxy", None)
    except RuntimeError:  # FreeCAD 1.0: undo has the object still in its list while its view is gone already
        return None


def _forget(gone: Any) -> None:
    from . import comparison_table, findings_panel

    findings_panel.forget(gone)
    comparison_table.forget(gone)


def _stand_anew(doc: Any) -> None:
    """Draw all of a document anew: a part holds other objects, or was moved with those that it holds."""
    _look_again(doc)
    for obj in doc.Objects:
        view = _view_of(obj)
        if hasattr(view, "stand_in_document"):
            redraw.soon(view)


def _look_again(doc: Any, changed: Any = None, only_old: bool = False) -> None:
    """Let the paths and maps that depend on ``changed`` (None: all), or only those that say so already, see
    whether they are old."""
    for obj in doc.Objects:
        view = _view_of(obj)
        if not hasattr(view, "look_again") or (changed is not None and not view.depends_on(changed)):
            continue
        if not only_old or view.says_old():
            view.look_again()
    _tell_panel(doc)


def _tell_panel(doc: Any) -> None:
    """Let the panel that is open, if there is one, see whether what it shows is still right."""
    panels = sys.modules.get(f"{__package__}.panels.path_panel")
    if panels is not None:
        panels.look_again(doc)
