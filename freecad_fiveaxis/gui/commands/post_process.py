# SPDX-License-Identifier: LGPL-2.1-or-later
"""Post-process: opens the panel that writes a tool path's NC file, its report and its preview."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon, translate


class PostProcess:
    """The NC file of a Toolpath."""

    NAME = "FiveAxis_PostProcess"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_PostProcess", "Post-process…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_PostProcess", "Write the NC file of a tool path, and a report of its deviations"
            ),
        }

    def IsActive(self) -> bool:
        """There is a tool path."""
        return selected.has_path(selected.TOOLPATH) and selected.idle()

    def Activated(self) -> None:
        """Open the panel for the tool path that is selected, or the only one."""
        from freecad_fiveaxis.gui.messages import warn
        from freecad_fiveaxis.gui.panels import post

        path = selected.find_selected_path(selected.TOOLPATH)
        if path is None:
            warn(translate("FiveAxis", "There are several tool paths: select the one to write."))
        else:
            post.write(path)
