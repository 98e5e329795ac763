# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where to clamp: opens the panel that tries setups for a tool path and shows the map of them."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon


class Setup:
    """The map of setups of a Toolpath, or of a new one over the selected part."""

    NAME = "FiveAxis_Setup"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_Setup", "Where to clamp…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_Setup",
                "Try where on the machine's table the part should stand, and show the deviation of each "
                "place",
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
            from freecad_fiveaxis.gui.panels import setup

            path, chosen = selected.path_or_part()
            if path is not None:
                setup.create(path)
            else:
                setup.create_over(*chosen)
