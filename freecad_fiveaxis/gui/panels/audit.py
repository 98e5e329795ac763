# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of an audit: a finished NC file, the machine that it is for, and what it comes to there."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

from freecad_fiveaxis.gui.qt import translate

from .fields import ChoiceField
from .files import FileField, nc_files
from .fixtures import FixturesField
from .form import Form, Section, group_sections
from .path_panel import PathPanel, fit_soon, show
from .picking import PointField


class AuditPanel(PathPanel):
    """A new Audit in ``doc``, or the Audit ``obj`` to change."""

    CREATES_PROGRAM = False

    def __init__(self, doc: Any, obj: Any = None) -> None:
        title, missing = (
            translate("FiveAxis", "Choose an NC file"),
            translate("FiveAxis", "Choose the NC file to audit."),
        )
        self.file = FileField("nc_file", title, nc_files(), missing=missing)
        zero = PointField(
            "work_zero", translate("FiveAxis", "Where the program's zero is drawn in the document")
        )
        hint = translate(
            "App::Property",
            "Solids and meshes of the document that hold the part: the tool is checked against them",
        )
        extras = [self.file, PartField(doc), FixturesField(doc, None, hint), zero]
        self.named: str | None = None  # the cutter that is shown because a program names it
        self.first = ""  # the cutter that was shown first
        self.seen: tuple[str, str] | None = None  # file and cutter, until the user gives a cutter himself
        super().__init__(doc, translate("FiveAxis", "Audit"), Form("audit", doc, _sections(), extras), obj)

    def fill(self, values: Mapping[str, Any]) -> None:
        """Show these values. Their cutter counts until a file is chosen that names another one, unless it was
        given for the audit that is there."""
        self.seen = None
        super().fill(values)
        given = self.obj is not None and not self.obj.CutterFromProgram
        self.first = self.options.fields["cutter"].value()
        self.named = self.first if self.obj is not None and not given else None
        self.seen = None if given else (self.file.value(), self.first)

    def _on_edit(self) -> None:
        self._follow_program()
        super()._on_edit()

    def _follow_program(self) -> None:
        """Show the cutter that the chosen file names, until the user says another one."""
        from freecad_fiveaxis.app.auditing import find_other_cutter

        cutter, file = self.options.fields["cutter"], self.file.value()
        if self.seen is None or self.seen[0] == file or self.seen[1] != cutter.value():
            return
        found = find_other_cutter(file, self.first)
        if cutter.value() != (shown := found or self.first):
            self.seen = None  # to show it is an edit, too
            self.options.show_options({"cutter": shown})
        self.named = cutter.value() if found else None
        self.seen = file, cutter.value()

    def read_settings(self) -> dict[str, Any]:
        """Return what the form says, without a cutter that only the program has named; one that was given for
        the audit stays where the form has no use for it and hides it."""
        settings, shown = self.options.read_values(), self.options.fields["cutter"].value()
        if "cutter" not in settings and self.obj is not None and not self.obj.CutterFromProgram:
            return settings | {"cutter": shown}
        by_program = self.named is not None and shown == self.named
        return settings | {"cutter": None} if by_program else settings

    def compute(self) -> Any:
        """Return a new Audit, or the one that is there with other settings."""
        from freecad_fiveaxis import app
        from freecad_fiveaxis.app import changes

        empty = not self.doc.Objects
        settings = self.read_settings()
        path = settings.pop("nc_file")
        audited = (
            changes.change_audit(self.obj, path, settings)
            if self.obj
            else app.audit(self.doc, path, **settings)
        )
        if empty:  # nobody has chosen a view yet
            fit_soon(self.doc)
        return audited

    def finish(self) -> None:
        """Give the places worth a look their markers."""
        from freecad_fiveaxis import app

        app.annotate(self.obj)


class PartField(ChoiceField):
    """The solids and meshes of the document, to compare with; without one of them the file below counts, if
    any is named."""

    def __init__(self, doc: Any) -> None:
        from freecad_fiveaxis.app import compared

        choices = [(None, translate("FiveAxis", "none, or a file"))]
        choices += [(one.Name, one.Label) for one in compared.parts_of(doc)]
        super().__init__("part", choices, translate("App::Property", PART))
        self.doc = doc

    def value(self) -> Any:
        """Return the object, or None."""
        name = super().value()
        return self.doc.getObject(name) if name else None

    def words(self) -> str:
        """Its label."""
        return self.value().Label if self.value() is not None else ""

    def show_value(self, value: Any) -> None:
        """Show an object, which joins the list where it is not there, or None."""
        if value is not None and self.editor.findData(value.Name) < 0:
            self.editor.addItem(value.Label, value.Name)
        super().show_value(value.Name if value is not None else None)


PART = "The solid or mesh of the document that the program is compared with"
"""As the property's help says."""


def create(doc: Any, chosen: Collection[Any] = ()) -> AuditPanel:
    """Open the panel for a new audit; its first values are those of what was posted from the document, of the
    ``chosen`` objects where they say which, else the user's preferences."""
    from freecad_fiveaxis.app import changes, preferences, proposing

    panel = AuditPanel(doc)
    preferred = {
        "machine": preferences.machine(),
        "controller": preferences.controller(),
        "tolerance": preferences.tolerance(),
    }
    panel.fill(changes.default_options("audit") | preferred | proposing.propose_values(doc, chosen))
    return show(panel)


def edit(obj: Any) -> AuditPanel:
    """Open the panel for an Audit that is there."""
    from freecad_fiveaxis.app import changes, convert

    panel = AuditPanel(obj.Document, obj)
    extras = {
        "cutter": convert.cutter_of(obj),
        "nc_file": obj.NCFile,
        "part": obj.Part,
        "fixtures": obj.Fixtures,
        "work_zero": tuple(obj.WorkZero),
    }
    panel.fill(changes.read_options(obj, "audit") | extras)
    return show(panel)


MORE = ("origin", "method")
"""Options that few need."""
FIRST = {"comparison": ("part",), "safety": ("fixtures",)}
"""Fields that are no options, before those of a group."""
IN_TITLE = {
    "machine": ("machine", "controller"),
    "comparison": ("part",),
    "tool": ("cutter", "holder"),
    "safety": ("fixtures", "tolerance"),
}
"""What stands in the title of a group."""
OPEN = ("machine", "comparison", "tool", "safety")
"""Groups that are open until the user folds them, besides the file."""


def _sections() -> list[Section]:
    """Return the file, and a section for each group of the task's settings."""
    groups = [
        Section(name, title, [*FIRST.get(name, ()), *names], IN_TITLE.get(name, ()), name in OPEN)
        for name, title, names in group_sections("audit", MORE)
    ]
    return [Section("file", translate("FiveAxis", "NC file"), ["nc_file"]), *groups]
