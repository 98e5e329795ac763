# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strokes that cut, as many of them as the picture has room for.

coat     ``core.report.thinning``: strokes whose passes stand at least some distance apart.
band     the strokes of which one coat is the widest: each is a node that is drawn or not. Zoomed in, all are;
         the smaller the part is on the screen, the fewer. What is over the tolerance is in the last band,
         which is always drawn.
"""

from __future__ import annotations

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.report import Drawing
from freecad_fiveaxis.core.report.thinning import COATS

from . import colours, nodes

APART = 7.0
"""Pixels: passes that are nearer together on the screen hide the part, and leaning ones cannot be told
apart."""


class CutNodes:
    """Strokes in bands; ``root`` goes into the scene. ``coat``: that which is drawn now; 0: all strokes."""

    def __init__(self) -> None:
        self.root, self.coat = coin.SoSeparator(), 0
        self.apart = np.zeros(0)
        self.root.renderCaching = coin.SoSeparator.OFF
        self.bands = [coin.SoSeparator() for _ in range(COATS + 1)]
        self.switches = [nodes.switch(band) for band in self.bands]
        self.style = nodes.style()
        for node in (nodes.unpickable(), nodes.nearer(0.001), self.style, *self.switches):
            self.root.addChild(node)
        for switch in self.switches:
            switch.enableNotify(False)  # what a frame changes must not ask for the next frame

    def show(self, drawing: Drawing, good: nodes.Colour, bad: nodes.Colour, width: float) -> None:
        """Draw what cuts in the colours of its deviation, ``width`` pixels wide."""
        rgba, ends = colours.pack_levels(drawing.level, good, bad), drawing.stroke.reshape(-1, 2, 3)
        for at, band in enumerate(self.bands):
            rows = drawing.cut & (drawing.coat == at)
            band.removeAllChildren()
            band.addChild(nodes.lines(ends[rows].reshape(-1, 3), colours=np.repeat(rgba[rows], 2)))
        self.style.lineWidth = width
        self.apart = drawing.apart

    def clear(self) -> None:
        """Draw nothing."""
        for band in self.bands:
            band.removeAllChildren()

    def choose(self, pixels_per_mm: float) -> None:
        """Draw the coat whose passes can be told apart; called within a frame."""
        self.coat = int((self.apart * pixels_per_mm <= APART).sum())
        for at, switch in enumerate(self.switches):
            nodes.turn(switch, at >= self.coat)
