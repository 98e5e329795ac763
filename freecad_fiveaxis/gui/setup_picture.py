# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a map of setups, from its object's properties alone: it stands as soon as a document is
opened."""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad_fiveaxis.app import setups

from .qt import translate
from .scene import colours, nodes, overlay
from .scene.on_screen import Label, Labels, LegendBox
from .scene.setup_nodes import BEYOND_COLOUR, PRESENT_COLOUR, layer_rows, setup_points
from .scene.units import length_text
from .view_properties import rgb


class SetupPicture:
    """Nodes of a map; ``root`` goes into the view provider."""

    def __init__(self, vobj: Any) -> None:
        self.vobj, self.obj = vobj, vobj.Object
        self.points, self.labels, self.legend = nodes.separate(), Labels(), LegendBox()
        self.root = nodes.separate(self.points, self.legend.root, self.labels.root)

    def refresh(self) -> None:
        """Draw the map as it is now."""
        self.points.removeAllChildren()
        if not self.obj.Places:
            self.labels.show(())
            self.legend.show(None)
            return
        view, scale, kinds = self.vobj, setups.scale(self.obj), list(self.obj.Kinds)
        places = np.array([tuple(place) for place in self.obj.Places], float).reshape(-1, 3)
        good, bad = rgb(view.ColourGood), rgb(view.ColourBad)
        rows = np.arange(len(kinds)) if view.ShowAllPlaces else layer_rows(places, kinds)
        shown = [kinds[row] for row in rows.tolist()]
        self.points.addChild(
            setup_points(places[rows], shown, scale.level[rows], scale.good[rows], good, bad, view.MarkerSize)
        )  # fmt: skip
        named = view.ShowLabel and setups.BEST in kinds
        self.labels.show(
            [Label(places[kinds.index(setups.BEST)].tolist(), self._best(), nodes.WHITE)] if named else ()
        )
        legend = self._legend(scale, good, bad, len(rows)) if view.ShowLegend else None
        self.legend.show(legend.fold() if legend is not None and view.FoldLegend else legend)

    def _best(self) -> str:
        return translate("FiveAxis", "recommended: {deviation}").format(
            deviation=length_text(self.obj.DeviationAfter.Value)
        )

    def _legend(self, scale: Any, good: nodes.Colour, bad: nodes.Colour, shown: int) -> overlay.Legend:
        template = translate("FiveAxis", "instead of {deviation} where it stood")
        notes = [
            translate("FiveAxis", "Largest deviation with the work zero there"),
            self._best(),
            template.format(deviation=length_text(self.obj.DeviationBefore.Value)),
        ]
        if shown < len(self.obj.Places):
            part = translate("FiveAxis", "{shown} of {count} places: those at the recommended height")
            notes.append(part.format(shown=shown, count=len(self.obj.Places)))
        within, beyond = int(scale.good.sum()), list(self.obj.Kinds).count(setups.BEYOND)
        keys = (
            (good, translate("FiveAxis", "within tolerance: {count} places").format(count=within)),
            (nodes.WHITE, translate("FiveAxis", "recommended")),
            (PRESENT_COLOUR, translate("FiveAxis", "where the work zero stood")),
            (
                BEYOND_COLOUR,
                translate(
                    "FiveAxis", "beyond limits, below the table or in the machine: {count} places"
                ).format(count=beyond),
            ),
        )
        halves = (translate("FiveAxis", "smaller deviation"), translate("FiveAxis", "larger deviation"))
        old = translate("FiveAxis", "The tool path was changed since: double-click the map to try again")
        marks = [(level, length_text(value)) for level, value in scale.marks]
        return overlay.Legend(
            self.obj.Label, colours.heat(bad), marks, halves if len(marks) > 1 else ("", ""), keys, notes,
            "" if self.obj.UpToDate else old, self._best(),
        )  # fmt: skip
