# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare machines: opens the panel that drives one and the same path on several machines, with each cure."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon, translate


class Compare:
    """A table of machines for a Toolpath."""

    NAME = "FiveAxis_Compare"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_Compare", "Compare machines…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_Compare",
                "Compare a tool path on several machines, with each correction: deviation and time of each",
            ),
        }

    def IsActive(self) -> bool:
        """There is a tool path."""
        return selected.has_path(selected.TOOLPATH) and selected.idle()

    def Activated(self) -> None:
        """Open the panel for the tool path that is selected, or the only one."""
        from freecad_fiveaxis.gui.messages import warn
        from freecad_fiveaxis.gui.panels import compare

        path = selected.find_selected_path(selected.TOOLPATH)
        if path is None:
            warn(
                translate("FiveAxis", "There are several tool paths: select the one to compare machines on.")
            )
        else:
            compare.create(path)
