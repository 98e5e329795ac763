# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a reach map. Its places are found again where the document was just opened and shows the
map."""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.app import reach
from freecad_fiveaxis.core.gouge.obstacles import Obstacle

from .qt import translate
from .scene import nodes, overlay
from .scene.on_screen import LegendBox
from .scene.reach_nodes import COLOURS, SHARE, patches, reach_axes, reach_surface
from .scene.units import area_text, write_number
from .view_properties import rgb
from .waiting import find_for_drawing


def reason_text(obstacle: Obstacle) -> str:
    """Return what a colour means."""
    return {
        Obstacle.NONE: translate("FiveAxis", "reached"),
        Obstacle.CUTTER: translate("FiveAxis", "cutter too large"),
        Obstacle.FLANK: translate("FiveAxis", "cutter's flank in the way"),
        Obstacle.SHANK: translate("FiveAxis", "shank in the way"),
        Obstacle.HOLDER: translate("FiveAxis", "holder in the way"),
        Obstacle.FIXTURE: translate("FiveAxis", "fixture in the way"),
        Obstacle.MACHINE: translate("FiveAxis", "machine in the way"),
        Obstacle.TABLE: translate("FiveAxis", "below the table"),
        Obstacle.LIMITS: translate("FiveAxis", "beyond the machine's limits"),
        Obstacle.HOLLOW: translate("FiveAxis", "in a closed hollow"),
    }[obstacle]


def area_lines(obj: Any) -> list[tuple[Obstacle, str, str, str]]:
    """Reason, its words, area and per cent of each that there is, from the properties of a ReachMap."""
    whole = max(obj.WholeArea.Value, 1e-30)
    areas = [(reason, getattr(obj, name).Value) for reason, name in reach.AREAS.items()]
    return [
        (reason, reason_text(reason), area_text(area), write_number(f"{100.0 * area / whole:.1f}") + " %")
        for reason, area in areas
        if area > 0.0
    ]


class ReachPicture:
    """Nodes of a map; ``root`` goes into the view provider.

    ``found`` what is drawn; ``failed``: why nothing could be found; ``warned``: what the legend warns of;
    ``styled``: the axes are drawn as the view's properties say.
    """

    def __init__(self, vobj: Any) -> None:
        self.vobj, self.obj = vobj, vobj.Object
        self.origin, self.surface, self.legend = coin.SoTranslation(), nodes.separate(), LegendBox()
        self.strokes = nodes.separate()
        self.axes = nodes.switch(nodes.without_box(self.strokes), False)
        self.root = nodes.separate(self.origin, self.surface, self.axes, self.legend.root)
        self.found: reach.Last | None = None
        self.failed = self.warned = ""
        self.styled = False

    def refresh(self) -> None:
        """Draw what is new."""
        self.origin.translation.setValue(*self.obj.WorkZero)
        found = self._find() if self.obj.Fingerprint else None
        if found is not self.found:
            self.found, self.styled = found, False
            self.surface.removeAllChildren()
            if found is not None:
                corner = patches(found.mesh, found.chart, reach.find_chosen_facets(found))
                self.surface.addChild(reach_surface(corner, found.chart.obstacle))
        if self.vobj.ShowAxes and not self.styled:
            self._draw_axes()
        nodes.turn(self.axes, bool(self.vobj.ShowAxes))
        self.warned = self.failed or (
            reach.out_of_date(self.obj) if self.vobj.Visibility else ""
        )  # it hashes the mesh
        legend = self._legend() if self.vobj.ShowLegend and (self.found is not None or self.warned) else None
        self.legend.show(legend.fold() if legend is not None and self.vobj.FoldLegend else legend)

    def _draw_axes(self) -> None:
        self.styled = True
        self.strokes.removeAllChildren()
        if self.found is None:
            return
        low, high = self.found.mesh.box
        length = self.vobj.AxisLength.Value or SHARE * float(np.linalg.norm(high - low))
        self.strokes.addChild(reach_axes(*reach.axis_field(self.found), length, rgb(self.vobj.ColourAxes)))

    def _find(self) -> reach.Last | None:
        """Return the map that the object's properties tell of. Where that fails, the legend and the object
        say why."""
        known = self.obj.Proxy.last
        if known is not None:
            self.failed = ""
        elif self.vobj.Visibility and not self.failed:
            known, self.failed = find_for_drawing(self.obj, reach.find_map)
        return known

    def _legend(self) -> overlay.Legend:
        if self.found is None:
            return overlay.Legend(self.obj.Label, np.zeros((0, 3)), (), ("", ""), (), (), self.warned)
        lines = area_lines(self.obj)
        keys = [(COLOURS[reason], f"{words}: {area} ({share})") for reason, words, area, share in lines]
        gist = translate("FiveAxis", "{share} % reached").format(
            share=write_number(f"{self.obj.ReachableShare:.1f}")
        )
        return overlay.Legend(self.obj.Label, np.zeros((0, 3)), (), ("", ""), keys, (), self.warned, gist)
