# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a map of setups, from its object's properties alone: it stands as soon as a document is opened."""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad_fiveaxis.app import setups

from .legend_slot import MAPS, legend_slot
from .qt import translate
from .scene import colours, nodes, overlay
from .scene.setup_nodes import BEYOND_COLOUR, PRESENT_COLOUR, setup_points
from .scene.units import length_text
from .view_properties import rgb


class SetupPicture:
    """Nodes of a map; ``root`` goes into the view provider."""

    def __init__(self, vobj: Any) -> None:
        self.vobj, self.obj = vobj, vobj.Object
        self.points, self.label, self.legend = nodes.separate(), nodes.separate(), nodes.separate()
        self.root = nodes.separate(self.points, self.label, self.legend)

    def refresh(self) -> None:
        """Draw the map as it is now."""
        for group in (self.points, self.label, self.legend):
            group.removeAllChildren()
        if not self.obj.Places:
            return
        view, scale = self.vobj, setups.scale(self.obj)
        places = np.array([tuple(place) for place in self.obj.Places], float).reshape(-1, 3)
        good, bad = rgb(view.ColourGood), rgb(view.ColourBad)
        self.points.addChild(setup_points(places, list(self.obj.Kinds), scale.level, scale.good, good, bad, view.MarkerSize))
        if view.ShowLabel and setups.BEST in self.obj.Kinds:
            self.label.addChild(overlay.label_node(places[self.obj.Kinds.index(setups.BEST)].tolist(), self._best()))
        if view.ShowLegend:
            self.legend.addChild(overlay.legend_node(self._legend(scale, good, bad), legend_slot(self.obj, MAPS), right=True))

    def _best(self) -> str:
        return translate("FiveAxis", "recommended: {deviation}").format(deviation=length_text(self.obj.DeviationAfter.Value))

    def _legend(self, scale: Any, good: nodes.Colour, bad: nodes.Colour) -> overlay.Legend:
        said = translate("FiveAxis", "instead of {deviation} where it stood")
        notes = (
            translate("FiveAxis", "Largest deviation with the work zero there"),
            self._best(),
            said.format(deviation=length_text(self.obj.DeviationBefore.Value)),
        )
        keys = (
            (good, translate("FiveAxis", "within tolerance")),
            (nodes.WHITE, translate("FiveAxis", "recommended")),
            (PRESENT_COLOUR, translate("FiveAxis", "where the work zero stood")),
            (BEYOND_COLOUR, translate("FiveAxis", "the axes leave their limits")),
        )
        old = translate("FiveAxis", "The tool path was changed since: double-click the map to try again")
        marks = [(level, length_text(value)) for level, value in scale.marks]
        return overlay.Legend(
            self.obj.Label, colours.heat(bad), marks, ("", ""), keys, notes, "" if self.obj.UpToDate else old
        )  # fmt: skip
