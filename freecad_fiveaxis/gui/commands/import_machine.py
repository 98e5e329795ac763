# SPDX-License-Identifier: LGPL-2.1-or-later
"""Import a machine: opens the panel that makes a machine file of another program's."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon


class ImportMachine:
    """A machine file from another program's."""

    NAME = "FiveAxis_ImportMachine"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_ImportMachine", "Import a machine…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_ImportMachine",
                "Make a machine file of a LinuxCNC configuration, a URDF file or a FreeCAD machine file",
            ),
        }

    def IsActive(self) -> bool:
        """Offer it always, but for an open panel: it needs files only, and no document."""
        return selected.idle()

    def Activated(self) -> None:
        """Open the panel."""
        from freecad_fiveaxis.gui.panels import import_machine

        import_machine.create()
