# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tessellate: the selected solid, or faces of it, as the mesh that tool paths are made of."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon, translate


class Tessellate:
    """A Tessellation of the selected solid."""

    NAME = "FiveAxis_Tessellate"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_Tessellate", "Tessellate"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_Tessellate",
                "Make a mesh of the selected solid, body or compound, as fine as tool paths need it",
            ),
        }

    def IsActive(self) -> bool:
        """There is something to select."""
        return selected.has_objects() and selected.idle()

    def Activated(self) -> None:
        """Tessellate what is selected; what cannot be says what to select."""
        from freecad_fiveaxis import app
        from freecad_fiveaxis.gui.messages import telling
        from freecad_fiveaxis.gui.undo import transaction
        from freecad_fiveaxis.gui.waiting import waiting

        with telling():
            base, faces = selected.part()
            with (
                transaction(base.Document, translate("FiveAxis", "Tessellate")),
                waiting(translate("FiveAxis", "Tessellate")),
            ):
                app.tessellate(base, faces=faces)
