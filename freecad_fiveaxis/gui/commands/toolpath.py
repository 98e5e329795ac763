# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool path: opens the panel for a new path over the selected part."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon


class Toolpath:
    """A new Toolpath over the selected solid, faces, body, compound or mesh."""

    NAME = "FiveAxis_Toolpath"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_Toolpath", "Tool path…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_Toolpath",
                "Plan five-axis passes over the selected solid, its selected faces, a mesh, or the model of "
                "a CAM Job",
            ),
        }

    def IsActive(self) -> bool:
        """There is something to select."""
        return selected.has_objects() and selected.idle()

    def Activated(self) -> None:
        """Open the panel; what cannot be milled says what to select."""
        from freecad_fiveaxis.gui.messages import telling
        from freecad_fiveaxis.gui.waiting import busy

        with telling(), busy():
            from freecad_fiveaxis.gui.panels import toolpath

            toolpath.create(*selected.job_or_part())
