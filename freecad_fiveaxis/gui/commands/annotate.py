# SPDX-License-Identifier: LGPL-2.1-or-later
"""Annotate: markers in the 3D view where a path is singular or leaves its tolerance."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon, translate


class Annotate:
    """The Markers of a Toolpath or an Audit."""

    NAME = "FiveAxis_Annotate"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_Annotate", "Annotate"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_Annotate",
                "Mark the singular blocks of a path and those over tolerance, and label the largest "
                "deviation",
            ),
        }

    def IsActive(self) -> bool:
        """There is a path."""
        return selected.has_path(selected.TOOLPATH, selected.AUDIT) and selected.idle()

    def Activated(self) -> None:
        """Make or renew the markers of the path that is selected, or the only one."""
        from freecad_fiveaxis import app
        from freecad_fiveaxis.gui.messages import telling, warn
        from freecad_fiveaxis.gui.undo import transaction
        from freecad_fiveaxis.gui.waiting import waiting

        path = selected.find_selected_path(selected.TOOLPATH, selected.AUDIT)
        if path is None:
            warn(translate("FiveAxis", "There are several paths: select the one to mark."))
            return
        with (
            telling(),
            transaction(path.Document, translate("FiveAxis", "Annotate")),
            waiting(translate("FiveAxis", "Annotate")),
        ):
            app.annotate(path)
