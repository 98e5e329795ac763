# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench: its menu, its toolbar, and what is set up once when FreeCAD's window starts. Imports nothing
heavy."""

from __future__ import annotations

import FreeCADGui

from freecad_fiveaxis.app.decimal_sign import use_decimal_sign

from .qt import QT_TRANSLATE_NOOP, QtCore, icon

TITLE = QT_TRANSLATE_NOOP("Workbench", "Five-axis")
MACHINES = QT_TRANSLATE_NOOP("Workbench", "Five-axis machines")


class FiveAxisWorkbench(FreeCADGui.Workbench):
    """Five-axis tool paths with a proven deviation for every block."""

    MenuText = TITLE
    ToolTip = QT_TRANSLATE_NOOP("Workbench", "Five-axis tool paths with a proven deviation for every block")
    Icon = icon("fiveaxis")

    def Initialize(self) -> None:
        """FreeCAD calls this when the workbench is opened for the first time."""
        from .commands import SEPARATOR, machine_names, work_names

        self.appendToolbar(TITLE, work_names())
        self.appendToolbar(MACHINES, machine_names())
        self.appendMenu(TITLE, [*work_names(), SEPARATOR, *machine_names()])

    def Activated(self) -> None:
        """FreeCAD calls this whenever the workbench is opened."""
        from . import warm_up

        warm_up.soon()

    def ContextMenu(self, recipient: str) -> None:
        """FreeCAD calls this before it shows a context menu, of the tree or of the 3D view."""
        from .commands import NAMES

        self.appendContextMenu(TITLE, NAMES)

    def GetClassName(self) -> str:
        """Return the C++ class behind a workbench that is written in Python."""
        return "Gui::PythonWorkbench"


def start() -> None:
    """Make the workbench known, and what other workbenches need of it too: commands, preferences, view
    providers."""
    from . import attach, commands, failures, preferences

    failures.watch()
    use_decimal_sign(lambda: str(QtCore.QLocale().decimalPoint()))
    FreeCADGui.addWorkbench(FiveAxisWorkbench())
    commands.register()
    preferences.register()
    attach.register()
