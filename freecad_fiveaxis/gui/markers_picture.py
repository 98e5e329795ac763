# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a Markers object, from its properties alone: it stands as soon as a document is opened."""

from __future__ import annotations

from typing import Any

import numpy as np

from .scene import gouge_words, nodes, overlay, words
from .scene.marks import LARGEST, Marks
from .view_properties import rgb


class MarkersPicture:
    """Nodes of the markers; ``root`` goes into the view provider."""

    def __init__(self, vobj: Any) -> None:
        self.vobj, self.obj, self.marks = vobj, vobj.Object, Marks()
        self.label = nodes.separate()
        self.root = nodes.separate(self.marks.root, self.label)

    def refresh(self) -> None:
        """Draw the markers where they stand now."""
        view, kinds = self.vobj, list(self.obj.Kinds)
        places = np.array([tuple(place) for place in self.obj.Places], float).reshape(-1, 3)
        self.marks.show(places, kinds, rgb(view.ColourBad), rgb(view.ColourSingular), view.MarkerSize)
        self.label.removeAllChildren()
        path = self.obj.Path
        if not view.ShowLabel or path is None:
            return
        texts = []
        if LARGEST in kinds:
            said = words.label_text(path.MaxSegmentDeviation.Value, path.WorstLine)
            texts.append((places[kinds.index(LARGEST)].tolist(), said))
        texts += gouge_words.labels(places.tolist(), kinds, list(self.obj.Depths))
        self.label.addChild(overlay.label_nodes(texts))
