# SPDX-License-Identifier: LGPL-2.1-or-later
"""Audit: opens the panel that proves a finished NC file, of any origin, against a machine."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon


class Audit:
    """An Audit of a finished NC file."""

    NAME = "FiveAxis_Audit"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_Audit", "Audit an NC file…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_Audit",
                "Read a finished NC file of any origin and prove its deviations on a machine",
            ),
        }

    def IsActive(self) -> bool:
        """Offer it always, but for an open panel: it needs nothing but a file."""
        return selected.idle()

    def Activated(self) -> None:
        """Open the panel, in the active document or a new one."""
        import FreeCAD
        import FreeCADGui

        from freecad_fiveaxis.gui.waiting import busy

        with busy():
            from freecad_fiveaxis.gui.panels import audit

            doc = FreeCAD.ActiveDocument or FreeCAD.newDocument()
            audit.create(doc, FreeCADGui.Selection.getSelection(doc.Name))
