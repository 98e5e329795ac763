# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a tool path: a new one over a selected part, or one that is there already."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import FreeCAD

from freecad_fiveaxis.app.labels import group_label
from freecad_fiveaxis.app.selection import is_mesh
from freecad_fiveaxis.gui.messages import telling
from freecad_fiveaxis.gui.qt import QtCore, translate
from freecad_fiveaxis.gui.waiting import waiting

from .advice_offer import AdviceOffer
from .avoid import AvoidField
from .fields import QuantityField
from .fixtures import FixturesField
from .form import SPACING, Form, Section
from .guides import AxisField, PlaceField
from .job_setup import FAR, SHARED, SetupField, ask, read_values
from .panel_widget import PanelWidget
from .path_panel import DRAWN, PathPanel, fit, is_seen, show
from .picking import PointField
from .preview import PreviewRow
from .scale_offer import ScaleOffer

EXTRAS = ("work_zero", "linear_deflection", "angular_deflection")
"""Fields that are no options of the core."""
PLACES = ("from_", "to", "pass_centre", "boundary")
"""Options that are places or curves, and may be picked."""


class ToolpathPanel(PathPanel):
    """``base`` and ``faces`` of a new path, or the Toolpath ``obj`` to change."""

    def __init__(self, doc: Any, base: Any = None, faces: tuple[str, ...] = (), obj: Any = None) -> None:
        self.base, self.faces, self.shown = base, faces, obj is not None
        self.last_choices: dict[str, Any] = {}
        self.usual: str | None = None
        meshed = _tessellation(obj) is None if obj else is_mesh(base)
        self.setup = SetupField(doc)
        part = base if obj is None else obj.Mesh
        solid = find_milled_solid(part)
        hint = translate(
            "App::Property", "Solids and meshes of the document that hold the part: the path goes around them"
        )
        extras = [
            self.setup,
            FixturesField(doc, solid, hint),
            *self._extras(not meshed),
            AvoidField(part if meshed else solid),
        ]
        extras += [*(PlaceField(name, self._zero) for name in PLACES), AxisField(self._zero)]
        form = Form("mill", doc, _sections(getattr(part, "Label", ""), [one.name for one in extras]), extras)
        self.scale_offer, self.advice_offer = ScaleOffer(), AdviceOffer()
        super().__init__(doc, translate("FiveAxis", "Tool path"), form, obj)
        self.scale_offer.chosen.connect(self.scale_part)
        self.advice_offer.requested.connect(self.ask_advice)
        self.advice_offer.chosen.connect(self.use_advice)
        self.setup.edited.connect(self._take_setup)
        self.setup.browse.clicked.connect(lambda *_: self._edit_setup())

    def _zero(self) -> Sequence[float]:
        """Return the work zero of the form, mm, document."""
        return self.options.fields["work_zero"].value()

    def _take_setup(self) -> None:
        """Show what the setup says in the fields that it holds, which then are its own to change, and offer
        its cutters."""
        from freecad_fiveaxis.app import job_setup

        chosen = self.setup.value()
        note = (
            translate("FiveAxis", "From setup {name}").format(name=chosen.Label) if chosen is not None else ""
        )
        for name in SHARED:
            field = self.options.fields[name]
            for widget in filter(None, (field.editor, getattr(field, "browse", None))):
                widget.setEnabled(chosen is None)
        for name in FAR:
            self.options.fields[name].show_note(note)
        self.options.fields["cutter"].setup.offer(job_setup.cutters_of(chosen) if chosen is not None else [])
        if chosen is not None:
            self.options.show_options(read_values(chosen))

    def _undone(self) -> None:
        """Keep the values of a setup that was made in the step that is taken back, to be edited here."""
        super()._undone()
        self.setup.forget_gone()
        self._take_setup()

    def calculate(self) -> bool:
        """Compute; a new path that is out of sight is brought into view, the first time."""
        if not super().calculate():
            return False
        hidden, name = self.base is not None and not self.base.ViewObject.Visibility, self.doc.Name
        if not self.shown and (hidden or not is_seen(name, _box(self.obj))):
            QtCore.QTimer.singleShot(DRAWN, lambda: fit(name))
        self.shown = True
        return True

    def _widget(self, title: str) -> Any:
        self.preview = PreviewRow(self.doc, self.calculate_button, self.preview_passes)
        head = (
            self.preview,
            self.summary,
            self.advice_offer,
            self.shown_parts,
            self.scale_offer,
            self.options.error,
        )
        return PanelWidget(title, head, self.options.widget)

    def preview_passes(self) -> bool:
        """Lay the passes of what the form says, draw them and say what they come to; whether that went well.
        The document stays as it is, and what is computed there too."""
        from freecad_fiveaxis import app

        self.preview.clear()
        if not self.options.check():
            return False
        values = self.options.read_values()
        base = (self.base, self.faces) if self.obj is None else self.obj
        try:
            with waiting(translate("FiveAxis", "Preview passes")):
                found = app.preview_passes(base, **values)
        except BaseException as error:  # FreeCADAbort (Esc) is no Exception
            self._tell(error)
            return False
        self.preview.show_passes(found, values["work_zero"])
        return True

    def _close(self) -> None:
        self.preview.clear()
        super()._close()

    def _on_edit(self) -> None:
        self.preview.clear()
        for name in PLACES:
            self.options.fields[name].follow_zero()
        self._follow_tool_axis()
        super()._on_edit()
        for offer in (self.scale_offer, self.advice_offer):
            offer.show_for(None if self.stale else self.obj)

    def ask_advice(self) -> bool:
        """Try what would finish more of the part, and say it; whether that went well. The document stays as
        it is."""
        from freecad_fiveaxis import app
        from freecad_fiveaxis.app import advising
        from freecad_fiveaxis.core.pipeline.advice import is_worth

        try:
            with waiting(translate("FiveAxis", "What would finish more?")):
                trials = app.advise(self.obj)
        except BaseException as error:  # FreeCADAbort (Esc) is no Exception
            self._tell(error)
            return False
        best: Mapping[str, Any] = next((one.changes for one in trials[:1] if is_worth(one)), {})
        self.advice_offer.show_advice(advising.tell_advice(self.obj, trials), best)
        return True

    def use_advice(self) -> None:
        """Show the settings that finish more in the form; they are computed once the user asks for it."""
        self.options.show_options(dict(self.advice_offer.changes))

    def scale_part(self, factor: float) -> bool:
        """Mill the part ``factor`` times as large, and calculate anew; whether that went well. Cancel takes
        it back."""
        from freecad_fiveaxis.app.scaling import scale_part

        self.step.begin()
        try:
            with waiting(self.title):
                scale_part(self.obj, factor)
        except BaseException as error:  # FreeCADAbort (Esc) is no Exception
            self._undone()
            self._tell(error)
            return False
        self.options.show_options({"work_zero": tuple(self.obj.WorkZero)})
        self.calculated = None
        self.shown = self.shown and self.base is None
        return self.calculate()

    def _edit_setup(self) -> None:
        """Change the setup, or make one of what the form says; Cancel of the panel takes that back."""
        values = self.options.read_values()
        self.step.begin()
        with telling():
            setup = ask(self.doc, self.setup.value(), {name: values.get(name) for name in SHARED})
            if setup is not None:
                self.setup.show_value(setup)
                self._take_setup()

    def fill(self, values: Mapping[str, Any]) -> None:
        """Show these values, above them those of the setup."""
        super().fill(values)
        self._take_setup()

    def _follow_tool_axis(self) -> None:
        """Show the tool axis that is usual for machine, cutter and passes, as long as nobody has chosen
        another one."""
        options = self.options.options()
        choices: dict[str, Any] = {
            name: options[name] for name in ("machine", "cutter", "passes") if name in options
        }
        if choices == self.last_choices:
            return
        self.last_choices, before, now = choices, self.usual, _usual_tool_axis(choices)
        self.usual = now or before
        if now and now != before and options.get("tool_axis") == before:
            self.options.show_options({"tool_axis": now})

    @staticmethod
    def _extras(tessellated: bool) -> list[Any]:
        point = PointField(
            "work_zero", translate("FiveAxis", "The point of the part that is the program's zero")
        )
        if not tessellated:
            return [point]
        return [
            point,
            QuantityField(
                "linear_deflection", "length", translate("FiveAxis", "How far the mesh may leave the solid")
            ),
            QuantityField(
                "angular_deflection",
                "angle",
                translate("FiveAxis", "How far two neighbouring facets may lean apart"),
            ),
        ]

    def is_current(self) -> bool:
        """Not where the mesh could not be made anew: the result is that of another part."""
        return super().is_current() and self.obj.Mesh is not None and "Invalid" not in self.obj.Mesh.State

    def compute(self) -> Any:
        """Return a new Toolpath, or the one that is there with other settings."""
        from freecad_fiveaxis import app
        from freecad_fiveaxis.app import changes

        settings = self.options.read_values()
        if self.obj is None:
            return app.create_toolpath(self.doc, self.base, faces=self.faces, **settings)
        return changes.change_toolpath(self.obj, settings)


def _box(path: Any) -> Any:
    """Return the box of the part that a path was computed over, document coordinates."""
    vertex, zero = path.Proxy.last.result.draft.mesh.vertex, path.WorkZero
    low, high = (zero + FreeCAD.Vector(*side.tolist()) for side in (vertex.min(axis=0), vertex.max(axis=0)))
    return FreeCAD.BoundBox(low.x, low.y, low.z, high.x, high.y, high.z)


def create(
    base: Any, faces: tuple[str, ...] = (), settings: Mapping[str, Any] | None = None
) -> ToolpathPanel:
    """Open the panel for a new path over ``base``; its first values are the user's preferences, and above
    them ``settings``."""
    from freecad_fiveaxis.app import changes, job_setup
    from freecad_fiveaxis.app.tessellation import ANGULAR, LINEAR

    panel = ToolpathPanel(base.Document, base, faces)
    meshing = {"linear_deflection": LINEAR, "angular_deflection": ANGULAR}
    setup = {"setup": job_setup.only_setup(base.Document)}
    values = changes.default_options("mill") | read_preferred() | meshing | setup | dict(settings or {})
    machine = setup["setup"].Machine if setup["setup"] is not None else values["machine"]
    usual = _usual_tool_axis({"machine": machine, "cutter": values["cutter"], "passes": values["passes"]})
    panel.fill(values | {"tool_axis": dict(settings or {}).get("tool_axis") or usual or values["tool_axis"]})
    return show(panel)


def _usual_tool_axis(choices: Mapping[str, Any]) -> str | None:
    """Return the tool axis that the core chooses for these options; None where it cannot use them, which the
    form says."""
    from freecad_fiveaxis.app.toolpath import with_strategies
    from freecad_fiveaxis.core.base.errors import FiveAxisError

    try:
        return str(with_strategies(choices)["tool_axis"])
    except FiveAxisError:
        return None


def read_preferred() -> dict[str, Any]:
    """Return what the user's preferences say of a new path."""
    from freecad_fiveaxis.app import preferences

    return {
        "machine": preferences.machine(), "controller": preferences.controller(),
        "scallop": preferences.scallop(),
        "cutter": preferences.cutter(), "tolerance": preferences.tolerance(), "feed": preferences.feed(),
    } | {name: text for name,
    text in (("shank", preferences.shank()), ("holder", preferences.holder())) if text}  # fmt: skip


def edit(obj: Any) -> ToolpathPanel:
    """Open the panel for a Toolpath that is there."""
    from freecad_fiveaxis.app import changes, guides, tessellation

    panel = ToolpathPanel(obj.Document, obj=obj)
    values = changes.read_options(obj, "mill") | {
        "work_zero": tuple(obj.WorkZero),
        "setup": obj.Setup,
        "fixtures": obj.Fixtures,
    }
    values["picked"] = guides.links_of(obj)
    mesh = _tessellation(obj)
    if mesh is not None:
        values |= {
            "linear_deflection": mesh.LinearDeflection.Value,
            "angular_deflection": mesh.AngularDeflection.Value,
        }
        values["avoid"] = tessellation.name_avoided(mesh)
    panel.fill(values)
    return show(panel)


def find_milled_solid(part: Any) -> Any:
    """Give the solid that a tessellation is of; of any other object itself, None where it was deleted."""
    base = getattr(part, "Base", None) if part is not None and is_mesh(part) else None
    return base[0] if base else part


def _tessellation(obj: Any) -> Any:
    """Return the Tessellation that a Toolpath is made of, where it is one of a solid; None for any other
    mesh."""
    base = getattr(obj.Mesh, "Base", None)
    return obj.Mesh if base and hasattr(obj.Mesh, "LinearDeflection") and not is_mesh(base[0]) else None


OF_FRAMES = ("frames", "within_frames")
DIVIDED = ("direction", "steep_shallow")
HELD = ("fixtures", "fixture_clearance")
ORDERING = ("order", "spiral", "links", "lead_in", "boundary", "boundary_axis", "boundary_by")
SECTIONS = {
    "Part": ("avoid", "avoid_allowance", "work_zero", "linear_deflection", "angular_deflection"),
    "Machine": ("setup", "machine", "controller", "tool_length"),
    "Tool": ("cutter", "tool", "spindle", "feed", "plunge_feed", "shank", "holder"),
    "Passes": (
        "passes",
        "from_",
        "to",
        "pass_centre",
        "pass_axis",
        "rotary_by",
        *OF_FRAMES,
        SPACING,
        *DIVIDED,
        *ORDERING,
    ),
    "Axis": ("tool_axis", "axis", "lead", "tilt", "max_tilt"),
    "Safety": (
        "gouge",
        *HELD,
        "linearize",
        "singularity",
        "max_axis_change",
        "tolerance",
        "clearance",
        "rest",
    ),
    "Output": ("rtcp", "high_speed", "feed_mode", "nc_units", "blend", "work_offset", "coolant"),
}
"""The fields of each group; what is not here stands under More settings."""
IN_TITLE = {
    "Part": ("avoid", "work_zero"),
    "Machine": ("setup", "machine", "controller"),
    "Tool": ("cutter", "spindle", "feed"),
    "Passes": ("passes", SPACING, "direction"),
    "Axis": ("tool_axis", "lead", "tilt"),
    "Safety": ("gouge", "fixtures", "linearize", "tolerance"),
    "Output": ("rtcp", "feed_mode", "work_offset"),
}
"""What stands in the title of each group."""
OPEN = ("Machine", "Tool", "Passes")
"""What a novice needs."""


def _sections(part: str, extras: Sequence[str]) -> list[Section]:
    """Return the groups of the panel over the object labelled ``part``; of the extras those that there
    are."""
    sections = []
    for name, names in SECTIONS.items():
        there = [one for one in names if one in extras or one not in EXTRAS]
        about = part if name == "Part" else ""
        sections.append(Section(name.lower(), group_label(name), there, IN_TITLE[name], name in OPEN, about))
    return sections
