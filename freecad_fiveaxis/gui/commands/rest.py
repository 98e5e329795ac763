# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rest material: the machined surface in the 3D view, coloured by what the cutter leaves on it and takes too
much of it."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon, translate


class Rest:
    """The map of rest material of a Toolpath."""

    NAME = "FiveAxis_Left"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_Left", "What is left"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_Left",
                "Colour the machined surface by what the cutter leaves on it, and by where it cuts too deep",
            ),
        }

    def IsActive(self) -> bool:
        """There is a tool path."""
        return selected.has_path(selected.TOOLPATH) and selected.idle()

    def Activated(self) -> None:
        """Make or renew the map of the tool path that is selected, or of the only one."""
        from freecad_fiveaxis import app
        from freecad_fiveaxis.gui.messages import telling, warn
        from freecad_fiveaxis.gui.undo import transaction
        from freecad_fiveaxis.gui.waiting import waiting

        path = selected.find_selected_path(selected.TOOLPATH)
        if path is None:
            warn(translate("FiveAxis", "There are several tool paths: select the one to map."))
            return
        name = translate("FiveAxis", "What is left")
        with telling(), transaction(path.Document, name), waiting(name):
            app.left_map(path)
