# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of one path: which figures are drawn, whether they still are those of the object, and what says
so."""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.app import results
from freecad_fiveaxis.core.report import Drawing, Figures, draw

from . import findings_panel, redraw
from .scene import labels, words
from .scene.on_screen import Label, LegendBox
from .scene.path_nodes import Look, PathNodes
from .view_properties import rgb
from .view_providers import markers_of
from .waiting import find_for_drawing

SWITCHES = {
    "cuts": "ShowCuts", "links": "ShowLinks", "rapids": "ShowRapids", "axes": "ShowAxes",
    "legend": "ShowLegend",
}  # fmt: skip


class Picture:
    """Nodes of a path, and what they show.

    ``figures`` those that are drawn; ``styled``: with the colours and sizes that the view has now;
    ``checked``: why the object is out of date, empty where it is not, None where nobody looked since the last
    change; ``failed``: why nothing could be computed.
    """

    def __init__(self, vobj: Any) -> None:
        self.vobj, self.obj, self.nodes = vobj, vobj.Object, PathNodes()
        self.figures: Figures | None = None
        self.drawing: Drawing | None = None
        self.styled, self.failed = False, ""
        self.checked: str | None = None

    @property
    def legend(self) -> LegendBox:
        """The node of the legend."""
        return self.nodes.legend

    def refresh(self) -> None:
        """Draw what is new."""
        self.nodes.move_to(tuple(self.obj.WorkZero))
        self._find_figures()
        if self.checked is None:
            self.checked = results.out_of_date(self.obj)
            results.touch_other(self.obj)
            findings_panel.show_old(self.obj, self.checked)
        if self.drawing is None:
            self.nodes.clear()
        elif not self.styled:
            self.nodes.show(self.drawing, self._look())
            self.styled = True
        self._turn()
        self._write()

    def _find_figures(self) -> None:
        """Find the figures that the object's properties tell of; computed where the document was just opened
        and shows the path."""
        last = self.obj.Proxy.last
        if last is None and self.obj.Fingerprint and self.vobj.Visibility and not self.failed:
            last = self._compute()
        if not self.obj.Fingerprint:
            self.figures = self.drawing = None
        elif (
            last is not None
            and last.figures is not self.figures
            and (self.figures is None or results.tells_of(self.obj))
        ):
            self.figures, self.drawing, self.styled, self.failed = last.figures, draw(last.figures), False, ""
            self.checked = None
            findings_panel.renew(self.obj)
            self._renew_markers()

    def _renew_markers(self) -> None:
        """Leave out the label of the Markers object where it would tell of other figures than these."""
        markers = markers_of(self.obj)
        if markers is not None and not results.tells_of(self.obj):
            redraw.soon(markers.ViewObject.Proxy)

    def _compute(self) -> Any:
        """Return the result after the document was opened. Where that fails, the view and the object say
        why."""
        _, why = find_for_drawing(self.obj, results.figures_of)
        self.failed = why or self.failed
        return self.obj.Proxy.last

    def _look(self) -> Look:
        view = self.vobj
        return Look(
            rgb(view.ColourGood), rgb(view.ColourBad), rgb(view.ColourSingular), rgb(view.ColourAxes),
            view.LineWidth,
            view.MarkerSize, view.AxisLength.Value,
        )  # fmt: skip

    def _turn(self) -> None:
        """Markers and label belong to the Markers object where there is one. What is shown of the worst
        blocks, label and curves, goes with the markers: one switch leaves the plain path."""
        for name, prop in SWITCHES.items():
            self.nodes.turn(name, getattr(self.vobj, prop))
        markers = markers_of(self.obj)
        marked = self.vobj.ShowMarkers if markers is None else markers.ViewObject.Visibility
        self.nodes.turn("marks", markers is None and marked)
        self.nodes.turn("label", markers is None and marked and self.vobj.ShowLabel)
        self.nodes.turn("curves", marked and self.vobj.ShowCurves)

    def _write(self) -> None:
        """Label and legend."""
        warning = self.failed or self.checked or ""
        legend = None
        if self.figures is None:
            legend = words.empty_legend(self.obj.Label, warning) if warning else None
        else:
            kinds = [mark.kind for mark in self.drawing.markers] if self.drawing is not None else []
            legend = words.legend_of(
                self.obj.Label, self.figures, self._look(), warning, kinds, self._list_shown()
            )
        self.nodes.legend.show(legend.fold() if legend is not None and self.vobj.FoldLegend else legend)
        self.nodes.labels.show(self._labels())

    def _list_shown(self) -> list[str]:
        """Return the kinds of moves that are shown, for the legend."""
        return [name for name in words.MOVES if getattr(self.vobj, SWITCHES[name])]

    def _labels(self) -> list[Label]:
        """Return what stands at the markers, the most important first."""
        if self.figures is None or self.drawing is None:
            return []
        marks = self.drawing.markers
        values = [mark.finding.value if mark.finding else None for mark in marks]
        deviation = line = None
        if len(self.figures.worst):
            row = self.figures.worst[0]
            deviation, line = float(self.figures.judged.segment[row]), int(self.figures.program.line[row])
        largest = labels.LargestDeviation(
            deviation, line, self.figures.tolerance, rgb(self.vobj.ColourGood), rgb(self.vobj.ColourBad)
        )
        return labels.of_marks([mark.place for mark in marks], [mark.kind for mark in marks], values, largest)
