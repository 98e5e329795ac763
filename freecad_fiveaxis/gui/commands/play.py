# SPDX-License-Identifier: LGPL-2.1-or-later
"""Play: the tool moves over the part, block by block."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon, translate


class Play:
    """The player of a Toolpath or an Audit."""

    NAME = "FiveAxis_Play"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_Play", "Play"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_Play", "Show the tool, and the machine's table, move along a path block by block"
            ),
        }

    def IsActive(self) -> bool:
        """There is a path."""
        return selected.has_path(selected.TOOLPATH, selected.AUDIT) and selected.idle()

    def Activated(self) -> None:
        """Play the path that is selected, or the only one."""
        from freecad_fiveaxis.gui import play
        from freecad_fiveaxis.gui.messages import telling, warn
        from freecad_fiveaxis.gui.waiting import waiting

        path = selected.find_selected_path(selected.TOOLPATH, selected.AUDIT)
        if path is None:
            warn(translate("FiveAxis", "There are several paths: select the one to play."))
            return
        with telling():
            with waiting(translate("FiveAxis", "Play")):
                from freecad_fiveaxis.app import results

                results.result_of(path)
            play.show(path)
