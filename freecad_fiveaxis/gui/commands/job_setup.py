# SPDX-License-Identifier: LGPL-2.1-or-later
"""Setup: machine, controller and work zero that several tool paths share."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon


class JobSetup:
    """The Setup that is selected or the document's only one; a new one where there is none."""

    NAME = "FiveAxis_JobSetup"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_JobSetup", "Setup…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_JobSetup",
                "Choose machine, controller and work zero once for all tool paths of the document",
            ),
        }

    def IsActive(self) -> bool:
        """There is something to machine."""
        return selected.has_objects() and selected.idle()

    def Activated(self) -> None:
        """Open the dialog."""
        import FreeCAD
        import FreeCADGui

        from freecad_fiveaxis.app import job_setup as setups
        from freecad_fiveaxis.gui.messages import telling
        from freecad_fiveaxis.gui.panels import job_setup

        doc = FreeCAD.ActiveDocument
        chosen = [one for one in FreeCADGui.Selection.getSelection() if setups.is_setup(one)]
        with telling():
            job_setup.edit(doc, chosen[0] if chosen else setups.only_setup(doc))
