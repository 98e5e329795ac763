# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nodes of a drawn path: cuts coloured by deviation, links, rapids, tool axes, the worst blocks' curves,
label, legend."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.report import Drawing
from freecad_fiveaxis.core.report.drawing import CURVE_POINTS

from . import colours, nodes
from .cut_nodes import CutNodes
from .marks import NOTHING, Marks, largest_colour
from .on_screen import Labels, LegendBox
from .zoom import Zoom

PARTS = ("cuts", "links", "rapids", "axes", "curves", "marks", "legend", "label")
"""What can be switched on and off by itself, in the order in which it is drawn."""
LINK_COLOUR, RAPID_COLOUR, AXIS_COLOUR = (0.60, 0.53, 0.83), (0.55, 0.57, 0.6), (0.68, 0.86, 1.0)
FAINT = 0.5
"""The transparency of rapids."""
CHORD_COLOUR, FOOT_SHADE = (1.0, 1.0, 1.0), 0.2
DASHES = 0x0F0F
SHORTEST = 16.0
"""Pixels: tool axes that stand nearer together than two thirds of this are a fur over the part, and are left
out."""
BEFORE_ALL = 0.999
"""The worst blocks' curves are seen through the part: where they lie below its surface they matter most."""


@dataclass(frozen=True)
class Look:
    """Colours, and sizes in pixels; ``axis_length`` mm, 0: as the part needs it."""

    good: nodes.Colour
    bad: nodes.Colour
    singular: nodes.Colour
    axes: nodes.Colour = AXIS_COLOUR
    line_width: float = 2.0
    mark_size: float = 7.0
    axis_length: float = 0.0


class PathNodes:
    """The scene of one path; ``root`` goes into the view provider."""

    def __init__(self) -> None:
        self.root, self.origin = coin.SoSeparator(), coin.SoTranslation()
        self.cuts, self.marks, self.labels, self.legend = CutNodes(), Marks(), Labels(), LegendBox()
        self.ground = Labels()  # without words: what all labels of the view keep beside, whoever draws them
        self.groups = {name: coin.SoSeparator() for name in PARTS}
        self.switches = {name: nodes.switch(group) for name, group in self.groups.items()}
        self.zoom, self.sticks, self.stick = Zoom(self), nodes.switch(coin.SoSeparator()), 0.0
        self.sticks.enableNotify(False)  # it is turned within a frame, and must not ask for the next one
        for name, own in (
            ("cuts", self.cuts),
            ("marks", self.marks),
            ("label", self.labels),
            ("legend", self.legend),
        ):
            self.groups[name].addChild(own.root)
        for node in (self.origin, nodes.flat(), self.zoom.root, self.ground.root, *self.switches.values()):
            self.root.addChild(node)

    def clear(self) -> None:
        """Show nothing."""
        for name in ("links", "rapids", "axes", "curves"):
            self.groups[name].removeAllChildren()
        self.cuts.clear()
        self.marks.show(np.zeros((0, 3)), (), None, (0, 0, 0), (0, 0, 0), 1.0)
        self.labels.show(())
        self.legend.show(None)

    def turn(self, name: str, on: bool) -> None:
        """Switch one of PARTS."""
        nodes.turn(self.switches[name], on)

    def zoom_to(self, pixels_per_mm: float) -> None:
        """Draw as many passes and tool axes as there is room for; called within a frame."""
        self.cuts.choose(pixels_per_mm)
        nodes.turn(self.sticks, self.stick * pixels_per_mm >= SHORTEST)

    def move_to(self, origin: tuple[float, float, float]) -> None:
        """Move to the work zero in the document, mm."""
        self.origin.translation.setValue(*origin)

    def show(self, drawing: Drawing, look: Look) -> None:
        """Draw all but the label and the legend, which carry words."""
        self.cuts.show(drawing, look.good, look.bad, look.line_width)
        links = nodes.lines(drawing.stroke[np.repeat(~drawing.cut, 2)])
        self._fill(
            "links",
            nodes.unpickable(),
            nodes.nearer(0.0005),
            nodes.colour(LINK_COLOUR),
            nodes.style(1.0),
            links,
        )
        faint, dashed = nodes.colour(RAPID_COLOUR, FAINT), nodes.style(1.0, pattern=DASHES)
        self._fill("rapids", nodes.unpickable(), faint, dashed, nodes.lines(drawing.rapid))
        self.ground.stand_beside(drawing.low, drawing.high)
        self.zoom.middle, self.stick = 0.5 * (drawing.low + drawing.high), drawing.axis_length
        self.sticks.removeAllChildren()
        self.sticks.addChild(nodes.separate(_sticks(drawing, look)))
        self._fill("axes", nodes.unpickable(), nodes.style(1.0), self.sticks)
        self._fill("curves", nodes.unpickable(), nodes.nearer(BEFORE_ALL), *_curves(drawing, look))
        self.show_marks(drawing, look)

    def show_marks(self, drawing: Drawing, look: Look) -> None:
        """Draw the markers."""
        places = np.array([one.place for one in drawing.markers], float).reshape(-1, 3)
        self.marks.stand_on(drawing.low, drawing.high)
        largest = largest_colour(
            float(drawing.deviation.max(initial=0.0)), drawing.tolerance, look.good, look.bad
        )
        self.marks.show(
            places, [one.kind for one in drawing.markers], largest, look.bad, look.singular, look.mark_size
        )

    def _fill(self, name: str, *children: Any) -> None:
        self.groups[name].removeAllChildren()
        for child in children:
            self.groups[name].addChild(child)


def _sticks(drawing: Drawing, look: Look) -> Any:
    """Return the tool axes, dark at the tip and bright at the holder's end: seen on light and on dark
    grounds."""
    tops = drawing.foot + drawing.axis * (look.axis_length or drawing.axis_length)
    red, green, blue = look.axes
    dark = (FOOT_SHADE * red, FOOT_SHADE * green, FOOT_SHADE * blue)
    rgba = np.tile(np.array([colours.pack(dark), colours.pack(look.axes)], np.uint32), len(drawing.foot))
    return nodes.lines(np.stack([drawing.foot, tops], axis=1).reshape(-1, 3), colours=rgba)


def _curves(drawing: Drawing, look: Look) -> list[Any]:
    """Return the commanded chord in white with thick ends, the real curve, and where they are farthest apart:
    in the good colour within the tolerance, in the bad one over it."""
    off = np.linalg.norm(drawing.spoke[1::2] - drawing.spoke[0::2], axis=1)
    rows, width = np.flatnonzero(off >= NOTHING), look.line_width
    if not len(rows):
        return []
    rgba = np.where(off[rows] <= drawing.tolerance, colours.pack(look.good), colours.pack(look.bad)).astype(
        np.uint32
    )
    chord, spoke = (
        points.reshape(-1, 2, 3)[rows].reshape(-1, 3) for points in (drawing.chord, drawing.spoke)
    )
    curve = drawing.curve.reshape(-1, CURVE_POINTS, 3)[rows].reshape(-1, 3)
    return [
        nodes.separate(nodes.colour(CHORD_COLOUR), nodes.style(width + 1.0), nodes.lines(chord)),
        nodes.separate(nodes.colour(CHORD_COLOUR), nodes.style(point=width + 4.0), nodes.points(chord)),
        nodes.separate(
            nodes.style(width + 1.0), nodes.lines(curve, CURVE_POINTS, np.repeat(rgba, CURVE_POINTS))
        ),
        nodes.separate(nodes.style(1.0, pattern=DASHES), nodes.lines(spoke, colours=np.repeat(rgba, 2))),
    ]
