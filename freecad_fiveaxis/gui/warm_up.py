# SPDX-License-Identifier: LGPL-2.1-or-later
"""Imports what the first panel needs, while the user still looks for the button: numpy, scipy and the core
take a second or more.

It happens in a thread, so that the window goes on; whoever needs a module meanwhile waits for that one only.
FreeCAD's own mesher (0.12 s) is imported before that, in the window's own thread: it registers types with
FreeCAD, and no lock guards those.
"""

from __future__ import annotations

import threading
from importlib import import_module

from .qt import QtCore

WAIT = 1000
"""ms after the workbench was opened, when FreeCAD is done with it."""
FREECADS = ("MeshPart",)
"""Modules of FreeCAD that are not loaded with it."""
NEEDED = (
    "core.pipeline.job", "core.report", "app.results", "app.setups", "app.machines", "app.controllers",
    "app.tessellation", "app.changes", "app.job_setup", "core.machine.bodies_file",
    "core.geometry.reduced", "core.geometry.shading", "gui.panels.toolpath",
)  # fmt: skip
"""Modules of the package, in the order in which they are imported."""

_begun: list[threading.Thread] = []


def soon() -> None:
    """Begin when the window is idle. A second call does nothing."""
    if not _begun:
        _begun.append(threading.Thread(target=_import, name="FiveAxis imports", daemon=True))
        QtCore.QTimer.singleShot(WAIT, _begin)


def is_done() -> bool:
    """Whether all is imported."""
    return bool(_begun) and _begun[0].ident is not None and not _begun[0].is_alive()


def _begin() -> None:
    for name in FREECADS:
        import_module(name)
    _begun[0].start()


def _import() -> None:
    for name in NEEDED:
        import_module("freecad_fiveaxis." + name)
