# SPDX-License-Identifier: LGPL-2.1-or-later
"""Imports what the first panel needs, while the user still looks for the button: numpy, scipy and the core take a second or more.

It happens in a thread, so that the window goes on; whoever needs a module meanwhile waits for that one only.
"""

from __future__ import annotations

import threading
from importlib import import_module

from .qt import QtCore

WAIT = 1000
"""ms after the workbench was opened, when FreeCAD is done with it."""
NEEDED = ("core.job", "core.report", "app.results", "app.setups", "gui.panels.toolpath")
"""Modules of the package, in the order in which they are imported."""

_begun: list[threading.Thread] = []


def soon() -> None:
    """Begin when the window is idle. A second call does nothing."""
    if not _begun:
        _begun.append(threading.Thread(target=_import, name="FiveAxis imports", daemon=True))
        QtCore.QTimer.singleShot(WAIT, _begun[0].start)


def _import() -> None:
    for name in NEEDED:
        import_module("freecad_fiveaxis." + name)
