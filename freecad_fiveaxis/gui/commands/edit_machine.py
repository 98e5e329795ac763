# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edit a machine: opens the panel in which a machine is changed axis by axis and written as a new file."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon


class EditMachine:
    """A machine of one's own, from one that is known."""

    NAME = "FiveAxis_EditMachine"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_EditMachine", "Edit a machine…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_EditMachine",
                "Describe your own machine: its axes, limits, rates and bodies, from one that is known",
            ),
        }

    def IsActive(self) -> bool:
        """Offer it always, but for an open panel: it needs files only, and no document."""
        return selected.idle()

    def Activated(self) -> None:
        """Open the panel."""
        from freecad_fiveaxis.gui.panels import machine_editor

        machine_editor.create()
