# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recover: opens the panel that finds a machine from a CL file and the program made of it, and writes its
file."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon


class Recover:
    """A machine file from a program."""

    NAME = "FiveAxis_Recover"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_Recover", "Recover a machine from a program…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_Recover",
                "Find the machine that a post had in mind, from a CL file and the NC file made of it",
            ),
        }

    def IsActive(self) -> bool:
        """Offer it always, but for an open panel: it needs files only, and no document."""
        return selected.idle()

    def Activated(self) -> None:
        """Open the panel."""
        from freecad_fiveaxis.gui.panels import recover

        recover.create()
