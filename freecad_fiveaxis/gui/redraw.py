# SPDX-License-Identifier: LGPL-2.1-or-later
"""Views are redrawn one after the other, when the window is idle.

A change of an object comes as many small changes of its properties; the view is asked once, after them. It
waits while a document is being computed or read and while a dialog waits for an answer, so that long work
never starts within other work.
"""

from __future__ import annotations

from typing import Any

import FreeCAD

from .qt import QtCore, QtWidgets

AGAIN = 150
"""ms until a window that was busy is looked at again."""

_due: list[Any] = []
_state = {"armed": False, "running": False}


def soon(view: Any) -> None:
    """Call ``view.refresh()`` when the window is idle, once however often it was asked for.

    A view that FreeCAD has not attached yet (``root`` is made then) asks again when it is.
    """
    if view not in _due and hasattr(view, "root"):
        _due.append(view)
    _arm(0)


def _arm(delay: int) -> None:
    if not _state["armed"] and not _state["running"]:
        _state["armed"] = True
        QtCore.QTimer.singleShot(delay, _run)


def _run() -> None:
    _state["armed"] = False
    if _busy():
        _arm(AGAIN)
        return
    _state["running"] = True
    try:
        if _due:
            _due.pop(0).refresh()
    except ReferenceError:
        FreeCAD.Console.PrintLog("Five-axis: an object was deleted before its view was drawn\n")
    finally:
        _state["running"] = False
        if _due:
            _arm(0)


def _busy() -> bool:
    if QtWidgets.QApplication.activeModalWidget() is not None or FreeCAD.isRestoring():
        return True
    return any(doc.Recomputing for doc in FreeCAD.listDocuments().values())
