# SPDX-License-Identifier: LGPL-2.1-or-later
"""What undo and redo bring back: current where it is what its base and its settings give.

touched   FreeCAD 1.0 and later have everything that undo or redo brings back recomputed, plain boxes too. A
          path that is still right would be called out of date, and be computed once more.
"""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.core.base.errors import FiveAxisError

from . import results, tessellation
from .tessellation import Tessellation


def settle(doc: Any) -> list[Any]:
    """Take the touch from our objects that are current, meshes first; returns those."""
    settled = [obj for obj in _ours(doc) if isinstance(obj.Proxy, Tessellation) and _is_current_mesh(obj)]
    for obj in settled:
        obj.purgeTouched()
    for obj in _ours(doc):
        if (hasattr(obj.Proxy, "make_draft") or hasattr(obj.Proxy, "settles")) and not results.out_of_date(
            obj
        ):
            obj.purgeTouched()
            settled.append(obj)
    return settled


def _ours(doc: Any) -> list[Any]:
    """Our objects that wait to be recomputed, and have not failed."""
    waiting = [obj for obj in doc.Objects if "Touched" in obj.State and "Invalid" not in obj.State]
    return [obj for obj in waiting if type(getattr(obj, "Proxy", None)).__module__.startswith(__package__)]


def _is_current_mesh(obj: Any) -> bool:
    base, _ = tessellation.find_base_and_faces(obj)
    if base is None or "Touched" in base.State or "Invalid" in base.State or not obj.MadeOf:
        return False
    try:
        return bool(tessellation.hash_inputs(obj) == obj.MadeOf) and not tessellation.has_moved(obj)
    except FiveAxisError:  # it says so itself when it is recomputed
        return False
