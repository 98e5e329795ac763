# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a map of rest material. Its heights are found again where the document was just opened and
shows the map."""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.app import rest
from freecad_fiveaxis.core.report.rest_material_map import HeightScale, height_scale

from .qt import translate
from .scene import gouge_words, nodes, overlay
from .scene.marks import GOUGE_COLOURS, OVERCUT
from .scene.on_screen import Label, Labels, LegendBox
from .scene.rest_nodes import bar_marks, rest_surface, scale_ramp
from .scene.units import area_text, length_text
from .waiting import find_for_drawing

MARK_DIGITS = 3


class RestPicture:
    """Nodes of a map; ``root`` goes into the view provider.

    ``heights`` those that are drawn; ``failed``: why none could be found; ``warned``: what the legend warns
    of.
    """

    def __init__(self, vobj: Any) -> None:
        self.vobj, self.obj = vobj, vobj.Object
        self.origin, self.surface, self.labels, self.legend = (
            coin.SoTranslation(),
            nodes.separate(),
            Labels(),
            LegendBox(),
        )
        self.root = nodes.separate(self.origin, self.surface, self.legend.root, self.labels.root)
        self.heights: rest.Heights | None = None
        self.scale: HeightScale | None = None
        self.failed = self.warned = ""

    def refresh(self) -> None:
        """Draw what is new."""
        if self.obj.Path is not None:
            self.origin.translation.setValue(*self.obj.Path.WorkZero)
        found = self._find() if self.obj.Fingerprint else None
        if found is not self.heights:
            self.heights = found
            self.surface.removeAllChildren()
            if found is not None:
                self.scale = height_scale(found.rest, found.tolerance, found.allowed)
                self.surface.addChild(rest_surface(found.mesh, found.rest, self.scale))
        self.warned = self.failed or (
            rest.out_of_date(self.obj) if self.vobj.Visibility else ""
        )  # it hashes the mesh
        self._write()

    def _find(self) -> rest.Heights | None:
        """Return the heights that the object's properties tell of. Where that fails, the legend and the
        object say why."""
        known = self.obj.Proxy.last
        if known is not None:
            self.failed = ""
        elif self.vobj.Visibility and not self.failed:
            known, self.failed = find_for_drawing(self.obj, rest.heights_of)
        return known

    def _write(self) -> None:
        """Labels and legend."""
        shown = self.heights if self.vobj.ShowLabel else None
        self.labels.show(self._extremes(shown) if shown is not None else ())
        legend = (
            self._legend() if self.vobj.ShowLegend and (self.heights is not None or self.warned) else None
        )
        self.legend.show(legend.fold() if legend is not None and self.vobj.FoldLegend else legend)

    def _extremes(self, found: rest.Heights) -> list[Label]:
        """Return the labels: where the cut is deepest, and where most is left, if that is more than may
        be."""
        height, point, labels = found.rest.height, found.rest.point, []
        if (least := float(height.min())) < -found.tolerance:
            labels.append(Label(point[height.argmin()].tolist(), _deep_text(-least), GOUGE_COLOURS[OVERCUT]))
        if (most := float(height.max())) > found.allowed:
            labels.append(Label(point[height.argmax()].tolist(), _rest_text(most)))
        return labels

    def _legend(self) -> overlay.Legend:
        if self.heights is None or self.scale is None:
            return overlay.Legend(self.obj.Label, np.zeros((0, 3)), (), ("", ""), (), (), self.warned)
        marks = [(at, length_text(height, MARK_DIGITS)) for at, height in bar_marks(self.scale)]
        halves = (translate("FiveAxis", "cut too deep"), translate("FiveAxis", "is left"))
        uncut = translate("FiveAxis", "Uncut: {area} of {whole}")
        notes = (
            translate("FiveAxis", "From the part's surface to the cutter"),
            translate("FiveAxis", "Most that is left: {height}").format(
                height=length_text(self.obj.LargestUndercut.Value)
            ),
            translate("FiveAxis", "Deepest below it: {depth}").format(
                depth=length_text(self.obj.LargestOvercut.Value)
            ),
            uncut.format(
                area=area_text(self.obj.UncutArea.Value), whole=area_text(self.obj.MachinedArea.Value)
            ),
        )
        return overlay.Legend(self.obj.Label, scale_ramp(), marks, halves, (), notes, self.warned, notes[1])


def _rest_text(height: float) -> str:
    return translate("FiveAxis", "{height} left").format(height=length_text(height))


def _deep_text(depth: float) -> str:
    return gouge_words.label_text(OVERCUT, depth)
