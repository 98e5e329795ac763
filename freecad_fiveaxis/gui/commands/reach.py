# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reach map: opens the panel that colours a part by where a tool gets at all, and by what is in the way
elsewhere."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon


class Reach:
    """The reach map of the selected part, or of that of a tool path, whose machine and tool it takes over."""

    NAME = "FiveAxis_Reach"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_Reach", "Reach map…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_Reach",
                "Colour the part by where the tool gets at all, and by what is in the way elsewhere",
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
            from freecad_fiveaxis.gui.panels import reach

            existing = selected.find_selected_reach_map()
            if existing is not None:
                reach.edit(existing)
                return
            path, chosen = selected.path_or_part()
            if path is not None:
                reach.create_of(path)
            else:
                reach.create(*chosen)
