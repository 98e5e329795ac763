# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a Markers object, from its properties alone: it stands as soon as a document is opened."""

from __future__ import annotations

from itertools import zip_longest
from typing import Any

import numpy as np

from freecad_fiveaxis.app.results import read_judged, tells_of

from .scene import labels, nodes
from .scene.marks import Marks, largest_colour
from .scene.on_screen import Labels
from .view_properties import rgb


class MarkersPicture:
    """Nodes of the markers; ``root`` goes into the view provider."""

    def __init__(self, vobj: Any) -> None:
        self.vobj, self.obj, self.marks, self.labels = vobj, vobj.Object, Marks(), Labels()
        self.root = nodes.separate(self.marks.root, self.labels.root)

    def refresh(self) -> None:
        """Draw the markers where they stand now."""
        view, kinds, path = self.vobj, list(self.obj.Kinds), self.obj.Path
        places = np.array([tuple(place) for place in self.obj.Places], float).reshape(-1, 3)
        good, bad = rgb(view.ColourGood), rgb(view.ColourBad)
        deviation, tolerance = (
            (read_judged(path)[0], path.Tolerance.Value) if path is not None else (0.0, 0.0)
        )
        drawing = (
            getattr(getattr(path.ViewObject.Proxy, "picture", None), "drawing", None)
            if path is not None
            else None
        )
        if drawing is not None:  # else they have their whole size
            self.marks.stand_on(drawing.low, drawing.high)
        self.marks.show(
            places, kinds, largest_colour(deviation, tolerance, good, bad), bad, rgb(view.ColourSingular),
            view.MarkerSize
        )  # fmt: skip
        texts: list[Any] = []
        if view.ShowLabel and path is not None and tells_of(path):
            largest = labels.LargestDeviation(deviation, path.WorstLine, tolerance, good, bad)
            values = [
                depth or area for depth, area in zip_longest(self.obj.Depths, self.obj.Areas, fillvalue=0.0)
            ]
            texts = labels.of_marks(places.tolist(), kinds, values, largest)
        self.labels.show(texts)
