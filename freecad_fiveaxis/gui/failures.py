# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors of ours that nobody foresaw: each is shown, in red in the panel that is open or in a message box,
with its traceback in the report view. None vanishes.

slot      a function of ours that Qt or FreeCAD calls: of a button, a field, a timer, an observer, a command.
PySide hands an error of a slot that it calls to ``sys.excepthook``, on PySide2 and PySide6 alike: ``watch``
listens there. FreeCAD catches those of the methods that it calls itself and prints them: they are
wrapped by ``guard_slot``.
"""

from __future__ import annotations

import functools
import os
import sys
import traceback
from collections.abc import Callable
from types import TracebackType
from typing import Any

import FreeCAD

from .qt import QtWidgets, later, main_window, translate

OURS = os.path.dirname(os.path.dirname(os.path.abspath(__file__))) + os.sep
"""Where our code stands: only errors that went through it are ours to tell."""

_line: list[Any] = []
"""The red line of the panel that is open."""
_box: list[Any] = []
"""The message box that is shown: one at a time, for a timer may fail again and again."""


def watch() -> None:
    """From now on errors of slots that PySide calls are shown. Whoever listened before still hears of all of
    them."""
    before = sys.excepthook

    def hook(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        before(kind, error, trace)
        if isinstance(error, Exception) and _is_ours(trace):
            show(error)

    sys.excepthook = hook


def _is_ours(trace: TracebackType | None) -> bool:
    return any(os.path.abspath(frame.filename).startswith(OURS) for frame in traceback.extract_tb(trace))


def guard_slot(slot: Callable[..., Any], failed: Any = None) -> Callable[..., Any]:
    """Return the slot for FreeCAD to call: an error is shown and printed, and ``failed`` is given back."""

    @functools.wraps(slot)
    def call(*values: Any, **named: Any) -> Any:
        try:
            return slot(*values, **named)
        except Exception as error:
            FreeCAD.Console.PrintError(traceback.format_exc())
            show(error)
            return failed

    return call


def guards(cls: type) -> type:
    """Class decorator for an observer: all its methods that FreeCAD calls are guarded."""
    for name, method in list(vars(cls).items()):
        if name.startswith("slot") or name.endswith("Selection"):
            setattr(cls, name, guard_slot(method))
    return cls


def attend(panel: Any) -> None:
    """Give a task panel that is about to open its red line, and guard what FreeCAD calls of it.
    ``panel.form``: its widget."""
    from .panels.lines import error_line

    line = error_line("failure")
    panel.form.layout().insertWidget(0, line)
    _line[:] = [line]
    for name in ("accept", "reject"):
        if hasattr(panel, name):
            setattr(panel, name, guard_slot(getattr(panel, name), False))


def show(error: BaseException) -> None:
    """Tell of an error that should not have happened: in the panel that is open, else in a message box."""
    from freecad_fiveaxis.app import wording

    text = translate(
        "FiveAxis", "This should not have happened: {error}. The details are in the report view."
    )
    text = text.format(error=wording.localize(error).rstrip(".") or type(error).__name__)
    if not _show_in_panel(text):
        later(lambda: _show_box(text))  # no event loop within an observer


def _show_in_panel(text: str) -> bool:
    try:
        for line in _line:
            line.setText(text)
            line.show()
            if line.isVisible():
                return True
    except RuntimeError:  # PySide: already deleted, that panel was closed
        _line.clear()
    return False


def _show_box(text: str) -> None:
    if _box:
        return
    box = QtWidgets.QMessageBox(main_window())
    box.setObjectName("FiveAxisFailure")
    box.setIcon(QtWidgets.QMessageBox.Critical)
    box.setWindowTitle(translate("FiveAxis", "Five-axis"))
    box.setText(text)
    box.finished.connect(_delete_box)
    _box.append(box)
    box.open()


def _delete_box(*_: Any) -> None:
    while _box:
        _box.pop().deleteLater()
