# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user means: the selection, and the path among the objects of a document. Cheap, for it is asked
all the time.

path      a Toolpath or an Audit; its markers, its NC output and its tessellation stand for it too.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

APP = "freecad_fiveaxis.app."
TOOLPATH, AUDIT, TESSELLATION, SETUP_MAP, REACH_MAP = (
    "Toolpath",
    "Audit",
    "Tessellation",
    "SetupMap",
    "ReachMap",
)


def idle() -> bool:
    """Whether no task panel is open: a second one cannot be shown."""
    return not FreeCADGui.Control.activeDialog()


def has_objects() -> bool:
    """Whether the active document holds anything to start from."""
    doc = FreeCAD.ActiveDocument
    return doc is not None and bool(doc.Objects)


def kind_of(obj: Any) -> str:
    """Return the name of our proxy's class; empty for an object that is none of ours. Imports nothing."""
    cls = type(getattr(obj, "Proxy", None))
    return cls.__name__ if cls.__module__.startswith(APP) else ""


def has_path(*kinds: str) -> bool:
    """Whether the active document has a path of one of the kinds."""
    doc = FreeCAD.ActiveDocument
    return doc is not None and any(kind_of(obj) in kinds for obj in doc.findObjects("App::FeaturePython"))


def find_selected_path(*kinds: str) -> Any:
    """Return the path of one of the kinds that is selected, or that what is selected belongs to; else the
    document's only one.

    None where there is no such path, or where several could be meant.
    """
    doc = FreeCAD.ActiveDocument
    chosen = {
        path.Name: path for obj in FreeCADGui.Selection.getSelection() for path in _paths_of(obj, kinds)
    }
    there = chosen or {
        obj.Name: obj for obj in doc.findObjects("App::FeaturePython") if kind_of(obj) in kinds
    }
    return next(iter(there.values())) if len(there) == 1 else None


def find_selected_reach_map() -> Any:
    """Return the reach map that alone is selected, or None."""
    chosen = FreeCADGui.Selection.getSelection()
    return chosen[0] if len(chosen) == 1 and kind_of(chosen[0]) == REACH_MAP else None


def _paths_of(obj: Any, kinds: tuple[str, ...]) -> list[Any]:
    near = [obj, getattr(obj, "Path", None)]
    if kind_of(obj) == TESSELLATION:
        near += obj.InList
    return [one for one in near if kind_of(one) in kinds]


def part() -> tuple[Any, tuple[str, ...]]:
    """Return the object to mill and the names of its chosen faces. Raises SelectionError that says what to
    select."""
    from freecad_fiveaxis.app import selection

    return selection.pick(
        [(one.Object, one.SubElementNames) for one in FreeCADGui.Selection.getSelectionEx()]
    )


def path_or_part() -> tuple[Any, tuple[Any, ...]]:
    """Return the Toolpath that is meant, or None and the part with its chosen faces. Raises SelectionError.

    With nothing selected the document's only Toolpath is meant.
    """
    chosen = FreeCADGui.Selection.getSelection()
    if not chosen or any(_paths_of(obj, (TOOLPATH,)) for obj in chosen):
        path = find_selected_path(TOOLPATH)
        if path is not None:
            return path, ()
    return None, part()


def job_or_part() -> tuple[Any, tuple[str, ...], dict[str, Any]]:
    """Return the same and settings: those of a CAM Job where that is selected, whose model is then milled.
    Raises SelectionError."""
    from freecad_fiveaxis.app import cam, selection

    chosen = FreeCADGui.Selection.getSelection()
    if len(chosen) == 1 and chosen[0] in cam.jobs_of(chosen[0].Document):
        model, settings = cam.settings_from_job(chosen[0])
        return (*selection.pick([(one, ()) for one in model]), settings)
    return (*part(), {})
