# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of an audit: a finished NC file, the machine that it is for, and what it comes to there."""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate

from .fields import TextField
from .form import Form
from .path_panel import DRAWN, PathPanel, fit, show
from .picking import PointField


class FileField(TextField):
    """A file to read, and a button that chooses it. ``title`` of the dialog, ``kinds`` of files as Qt filters them."""

    def __init__(self, name: str, title: str, kinds: str, hint: str = "") -> None:
        super().__init__(name, hint)
        self.title, self.kinds = title, kinds
        self.browse = QtWidgets.QToolButton()
        self.browse.setText("…")
        self.browse.setToolTip(title)
        self.browse.clicked.connect(self._browse)

    def check(self) -> None:
        """Raises FileError for a file that is not named or cannot be read."""
        from freecad_fiveaxis.core.errors import FileError
        from freecad_fiveaxis.core.files import check_readable

        if not self.value():
            raise FileError(translate("FiveAxis", "Choose the NC file to audit."), "")
        check_readable(self.value())

    def _browse(self, *_: Any) -> None:
        path, _ = QtWidgets.QFileDialog.getOpenFileName(self.editor, self.title, self.value(), self.kinds)
        if path:
            self.show_value(path)


class AuditPanel(PathPanel):
    """A new Audit in ``doc``, or the Audit ``obj`` to change."""

    def __init__(self, doc: Any, obj: Any = None) -> None:
        title = translate("FiveAxis", "Choose an NC file")
        kinds = translate("FiveAxis", "NC files (*.ngc *.nc *.tap *.cnc *.mpf *.gcode *.txt)")
        self.file = FileField("nc_file", title, ";;".join([kinds, translate("FiveAxis", "All files (*)")]))
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


def _sections() -> list[tuple[str, str, list[str]]]:
    return [
        ("file", translate("FiveAxis", "NC file"), ["nc_file"]),
        ("machine", translate("FiveAxis", "Machine"), ["machine", "controller", "tool_length"]),
        ("proof", translate("FiveAxis", "Proof"), ["tolerance"]),
    ]
