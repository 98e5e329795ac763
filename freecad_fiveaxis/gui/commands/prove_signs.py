# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prove the signs: opens the panel that makes a short safe program and the sheet for whoever stands at the
machine."""

from __future__ import annotations

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QT_TRANSLATE_NOOP, icon


class ProveSigns:
    """A program that shows a wrong sign before it cuts."""

    NAME = "FiveAxis_ProveSigns"

    def GetResources(self) -> dict[str, str]:
        """FreeCAD asks for icon and texts."""
        return {
            "Pixmap": icon(self.NAME),
            "MenuText": QT_TRANSLATE_NOOP("FiveAxis_ProveSigns", "Prove the signs…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "FiveAxis_ProveSigns",
                "Make a short safe program and a sheet that show a wrong sign or letter before it cuts",
            ),
        }

    def IsActive(self) -> bool:
        """Offer it always, but for an open panel: it needs files only, and no document."""
        return selected.idle()

    def Activated(self) -> None:
        """Open the panel."""
        from freecad_fiveaxis.gui.panels import prove_signs

        prove_signs.create()
