# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse wheel scrolls a panel; it changes a value only where the user has clicked into the field
before."""

from __future__ import annotations

from typing import Any

from .qt import QtCore


class _Wheel(QtCore.QObject):
    """Takes the wheel away from a field without the keyboard focus; Qt then offers it to the widgets
    around."""

    def eventFilter(self, field: Any, event: Any) -> bool:
        """Qt calls this before an event arrives at a field."""
        if event.type() != QtCore.QEvent.Wheel or field.hasFocus():
            return False
        event.ignore()
        return True


_wheel: list[_Wheel] = []
"""One for all fields, for as long as FreeCAD runs."""


def leave_wheel(field: Any) -> None:
    """From now on the field, a spin box or combo box, takes the wheel only with the focus, and no focus by
    the wheel."""
    if not _wheel:
        _wheel.append(_Wheel())
    if field.focusPolicy() == QtCore.Qt.WheelFocus:
        field.setFocusPolicy(QtCore.Qt.StrongFocus)
    field.installEventFilter(_wheel[0])
