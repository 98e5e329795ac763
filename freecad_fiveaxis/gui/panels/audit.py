# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of an audit: a finished NC file, the machine that it is for, and what it comes to there."""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, translate

from .files import FileField
from .form import Form, Section, group_sections
from .path_panel import DRAWN, PathPanel, fit, show
from .picking import PointField
from .post import nc_files


class AuditPanel(PathPanel):
    """A new Audit in ``doc``, or the Audit ``obj`` to change."""

    MADE_HERE = False

    def __init__(self, doc: Any, obj: Any = None) -> None:
        title, missing = translate("FiveAxis", "Choose an NC file"), translate("FiveAxis", "Choose the NC file to audit.")
        self.file = FileField("nc_file", title, nc_files(), missing=missing)
        zero = PointField("work_zero", translate("FiveAxis", "Where the program's zero is drawn in the document"))
        super().__init__(doc, translate("FiveAxis", "Audit"), Form("audit", doc, _sections(), [self.file, zero]), obj)

    def compute(self) -> Any:
        """A new Audit, or the one that is there with other settings."""
        from freecad_fiveaxis import app
        from freecad_fiveaxis.app import changes

        empty = not self.doc.Objects
        settings = self.options.said()
        path = settings.pop("nc_file")
        made = changes.change_audit(self.obj, path, settings) if self.obj else app.audit(self.doc, path, **settings)
        if empty:  # nobody has chosen a view yet
            QtCore.QTimer.singleShot(DRAWN, lambda: fit(self.doc.Name))
        return made

    def finish(self) -> None:
        """The places worth a look get their markers."""
        from freecad_fiveaxis import app

        app.annotate(self.obj)


def create(doc: Any) -> AuditPanel:
    """Open the panel for a new audit; its first values are the user's preferences."""
    from freecad_fiveaxis.app import changes, preferences

    panel = AuditPanel(doc)
    preferred = {"machine": preferences.machine(), "controller": preferences.controller(), "tolerance": preferences.tolerance()}
    panel.fill(changes.default_options("audit") | preferred)
    return show(panel)


def edit(obj: Any) -> AuditPanel:
    """Open the panel for an Audit that is there."""
    from freecad_fiveaxis.app import changes

    panel = AuditPanel(obj.Document, obj)
    panel.fill(changes.shown_options(obj, "audit") | {"nc_file": obj.NCFile, "work_zero": tuple(obj.WorkZero)})
    return show(panel)


MORE = ("origin", "method")
"""Options that few need."""
TOLD = {"machine": ("machine", "controller"), "tool": ("cutter", "holder"), "safety": ("tolerance",)}
"""What stands in the title of a group."""
OPEN = ("machine", "comparison", "tool", "safety")
"""Groups that are open until the user folds them, besides the file."""


def _sections() -> list[Section]:
    """The file, and a section for each group of the task's settings."""
    groups = [
        Section(name, title, names, TOLD.get(name, ()), name in OPEN) for name, title, names in group_sections("audit", MORE)
    ]
    return [Section("file", translate("FiveAxis", "NC file"), ["nc_file"]), *groups]
