# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a reach map: machine, tool and what holds the part; how much the tool reaches, and why not the
rest."""

from __future__ import annotations

import html
from collections.abc import Mapping
from types import SimpleNamespace
from typing import Any

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.app.labels import group_label
from freecad_fiveaxis.app.selection import is_mesh
from freecad_fiveaxis.core.studies.reach_report import WAYS
from freecad_fiveaxis.gui.qt import QtWidgets, translate
from freecad_fiveaxis.gui.verdict_label import ADVICE
from freecad_fiveaxis.gui.views import kind_of

from .fields import QuantityField
from .fixtures import FixturesField
from .form import Form, Section
from .path_panel import PathPanel, fit_soon, show
from .picking import PointField
from .setup import table_of
from .summary import Summary
from .toolpath import find_milled_solid, read_preferred

OPTIONS = (
    "machine", "tool_length", "cutter", "shank", "holder", "tolerance", "table_height", "origin", "boundary",
    "boundary_axis",
)  # fmt: skip
"""The options of the core's task that the panel asks for."""
SECTIONS = {
    "Machine": ("machine", "tool_length", "table_height"),
    "Tool": ("cutter", "shank", "holder"),
    "Axis": ("largest_axis_angle",),
    "Safety": ("fixtures", "tolerance"),
    "Part": ("work_zero", "boundary", "boundary_axis"),
}
OPEN = ("Machine", "Tool")


class ReachSummary(Summary):
    """How much is reached, in a sentence that is always whole; the area of each reason; what a longer tool
    would bring; that the way there is not asked."""

    def show_result(self, obj: Any) -> None:
        """Show the figures of the map."""
        from freecad_fiveaxis.gui.reach_picture import area_lines

        cells = "".join(
            f"<tr><td>{html.escape(words)}&nbsp;</td><td align=right><b>{_unbroken(area)}</b>&nbsp;</td>"
            f"<td align=right>{_unbroken(share)}</td></tr>"
            for _, words, area, share in area_lines(obj)
        )
        texts = (obj.Advice, *obj.Findings, wording.localize(WAYS))
        paragraphs = "".join(f"<p>{html.escape(text)}</p>" for text in texts if text)
        self.verdict.show_verdict(SimpleNamespace(Light=ADVICE, Verdict=obj.Verdict))
        self.tell(f"<table>{cells}</table>{paragraphs}")


def _unbroken(text: str) -> str:
    return html.escape(text).replace(" ", "&nbsp;")


class ReachPanel(PathPanel):
    """A new map of ``base``, a solid, a mesh or a Toolpath, and its ``faces``; or the map ``obj`` to
    change."""

    SUMMARY = ReachSummary
    CREATES_PROGRAM = False  # a map is no program

    def __init__(self, base: Any = None, faces: tuple[str, ...] = (), obj: Any = None) -> None:
        self.base, self.faces = base, faces
        doc, part = (base or obj).Document, _part(base if obj is None else obj)
        hint = translate(
            "App::Property",
            "So far the tool may lean from the work frame's Z; 180°: as far as the machine turns",
        )
        fixtures = translate(
            "App::Property",
            "Solids and meshes of the document that hold the part: they are in the tool's way",
        )
        extras = [
            QuantityField("largest_axis_angle", "angle", hint), FixturesField(doc, part, fixtures),
            PointField("work_zero", translate("FiveAxis", "The point of the part that is the program's "
                "zero")),
        ]  # fmt: skip
        sections = [
            Section(
                name.lower(),
                group_label(name),
                names,
                names,
                name in OPEN,
                getattr(part, "Label", "") * (name == "Part"),
            )
            for name, names in SECTIONS.items()
        ]
        super().__init__(
            doc, translate("FiveAxis", "Reach map"), Form("reach", doc, sections, extras, only=OPTIONS), obj
        )

    def _widget(self, title: str) -> Any:
        widget = super()._widget(title)
        self.axes_box = QtWidgets.QCheckBox(translate("FiveAxis", "Show the tool axes"))
        self.axes_box.setObjectName("show_axes")
        self.axes_box.setToolTip(
            translate(
                "App::Property", "Show the tool axis with which each place is reached, as a short stroke"
            )
        )
        widget.layout().insertWidget(2, self.axes_box)
        self.axes_box.clicked.connect(lambda *_: self._show_axes())
        return widget

    def _on_edit(self) -> None:
        """Let the empty field of the table's height say what the machine's file knows of it."""
        self.options.fields["table_height"].editor.setPlaceholderText(
            table_of(self.options.fields["machine"].value())
        )
        super()._on_edit()

    def _show_axes(self) -> None:
        if self.obj is not None:
            self.obj.ViewObject.ShowAxes = self.axes_box.isChecked()

    def _show_parts(self) -> None:
        """Hide what a map has not: it is no path, and has no cuts, links and rapids to switch, but axes once
        it is there."""
        self.shown_parts.show_for(None)
        self.axes_box.setEnabled(self.obj is not None)
        self.axes_box.setChecked(self.obj is not None and bool(self.obj.ViewObject.ShowAxes))

    def is_current(self) -> bool:
        """Whether the map is of the part and the settings as they are."""
        from freecad_fiveaxis.app import reach

        return not reach.out_of_date(self.obj)

    def calculate(self) -> bool:
        """Return a part that was out of sight is to be seen, the first time."""
        new = self.obj is None
        good = super().calculate()
        if good and new:
            fit_soon(self.doc)
        return good

    def compute(self) -> Any:
        """Return a new map, or the one that is there with other settings."""
        from freecad_fiveaxis.app import reach

        settings = self.options.read_values()
        if self.obj is not None:
            return reach.reach_map(self.obj, settings, self.obj)
        if kind_of(self.base) != "toolpath":
            return reach.reach_map((self.base, self.faces) if self.faces else self.base, settings)
        found = reach.reach_map(
            self.base.Mesh, settings
        )  # all that the path says stands in the form, but for what was taken out
        self.base.ViewObject.Visibility = False  # it would cover the map
        return found


def _part(of: Any) -> Any:
    """Return the solid that is looked at: that of a Toolpath, of a map, of a tessellation; any other object
    itself."""
    return find_milled_solid(
        of.Mesh if hasattr(of, "Proxy") and not is_mesh(of) and hasattr(of, "Mesh") else of
    )


def create(base: Any, faces: tuple[str, ...] = ()) -> ReachPanel:
    """Open the panel for a part; its first values are the user's preferences, and above them the document's
    only setup."""
    from freecad_fiveaxis.app import job_setup

    setup = job_setup.only_setup(base.Document)
    return _open(
        ReachPanel(base, faces), read_preferred() | ({} if setup is None else job_setup.options_of(setup))
    )


def create_of(path: Any) -> ReachPanel:
    """Open the panel for the part of a Toolpath; its first values are the path's."""
    from freecad_fiveaxis.app import reach

    return _open(ReachPanel(path), reach.take_over(path))


def edit(obj: Any) -> ReachPanel:
    """Open the panel for a map that is there."""
    from freecad_fiveaxis.app import reach

    return _open(ReachPanel(obj=obj), reach.settings_of(obj))


def _open(panel: ReachPanel, values: Mapping[str, Any]) -> ReachPanel:
    from freecad_fiveaxis.app import changes
    from freecad_fiveaxis.app.reach_properties import ANY_ANGLE

    usual = changes.default_options("reach") | {"largest_axis_angle": ANY_ANGLE, "fixtures": ()}
    panel.fill(usual | dict(values))
    return show(panel)
