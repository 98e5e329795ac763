# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that writes a tool path: the NC file, a report where one is wished, a preview for CAM where one
is wished.

poor            errors and warnings of the result. A program with errors, or without a spindle speed, is
                written only when the user says so.
proposed name   the folder of the preferences, else the document's, else the user's own; the path's label; the
                ending of the controller's files.
"""

from __future__ import annotations

import os
from typing import Any

import FreeCADGui

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.app.labels import option_label
from freecad_fiveaxis.gui.messages import ask, status
from freecad_fiveaxis.gui.qt import QtWidgets, flags, translate
from freecad_fiveaxis.gui.undo import transaction
from freecad_fiveaxis.gui.verdict_label import VerdictLabel
from freecad_fiveaxis.gui.waiting import waiting

from . import written
from .files import SaveField, nc_files
from .lines import error_line, note_line
from .option_fields import option_field
from .panel_widget import MARGIN
from .path_panel import show
from .result_html import findings

REPORTS = ("html", "json")
NAMED = 5
"""So many errors, and as many warnings, stand in the question; the list of findings has all."""


class PostPanel:
    """Writes the Toolpath ``path``."""

    def __init__(self, path: Any) -> None:
        self.path = path
        title = translate("FiveAxis", "The NC file to write")
        self.file = SaveField("nc_path", title, nc_files(), title, translate("FiveAxis", "Name the NC file."))
        self.error = error_line("post_error")
        self.reports = {kind: QtWidgets.QCheckBox(text) for kind, text in _report_texts().items()}
        self.preview = QtWidgets.QCheckBox(translate("FiveAxis", "Preview for CAM"))
        self.verdict, self.poor = VerdictLabel("post_verdict"), QtWidgets.QLabel()
        self.file.editor.setAccessibleDescription(self.file.editor.toolTip())
        self.file.editor.textChanged.connect(self.file.editor.setToolTip)  # the box shows but the end
        self.spindle = None if path.Spindle else option_field(_spindle_leaf())
        self.form = self._widget()
        self._show_poor()
        self.file.propose(propose_name(path))
        self._say_old()

    def _say_old(self) -> None:
        """Say where the verdict is not that of the part as it is; OK computes it anew."""
        from freecad_fiveaxis.app import results

        self.show_error(results.out_of_date(self.path))

    def _widget(self) -> Any:
        widget = QtWidgets.QWidget()
        widget.setObjectName("FiveAxisPanel")
        widget.setWindowTitle(translate("FiveAxis", "Post-process {}").format(self.path.Label))
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self.file.editor)
        row.addWidget(self.file.browse)
        column = QtWidgets.QVBoxLayout(widget)
        column.setContentsMargins(MARGIN, MARGIN, MARGIN, MARGIN)
        column.addWidget(QtWidgets.QLabel(translate("FiveAxis", "NC file")))
        column.addLayout(row)
        for kind, box in self.reports.items():
            box.setObjectName("report_" + kind)
        self.preview.setObjectName("preview")
        rows = (
            self.error,
            *self._spindle_row(),
            *_units_row(self.path),
            *self.reports.values(),
            self.preview,
        )
        for part in (*rows, self.verdict, self.poor):
            column.addWidget(part)
        column.addStretch()
        return widget

    def _spindle_row(self) -> list[Any]:
        """Return the speed that the path does not give, asked for here."""
        if self.spindle is None:
            return []
        label = QtWidgets.QLabel(
            translate("FiveAxis", "{name} (0: the program leaves it off)").format(
                name=option_label("spindle")
            )
        )
        label.setWordWrap(True)
        label.setBuddy(self.spindle.editor)
        return [label, self.spindle.editor, self.spindle.warning, self.spindle.error]

    def _show_poor(self) -> None:
        """Verdict, errors and warnings of the last computation; after opening a document the verdict only."""
        self.poor.setObjectName("post_findings")
        self.poor.setWordWrap(True)
        self.verdict.show_verdict(self.path)
        last = self.path.Proxy.last
        self.poor.setText("" if last is None else findings(_poor(last.figures)))

    def getStandardButtons(self) -> int:
        """FreeCAD asks which buttons the panel has."""
        return flags(QtWidgets.QDialogButtonBox.Ok | QtWidgets.QDialogButtonBox.Cancel)

    def accept(self) -> bool:
        """Write the files. What cannot be written is said under the name, and the panel stays."""
        from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError

        self.show_error("")
        try:
            if not self._write():
                return False
        except Cancelled:
            status(translate("FiveAxis", "Stopped; the document is as it was."))
            return False
        except FiveAxisError as error:
            self.show_error(wording.localize(error))
            return False
        status(translate("FiveAxis", "Written: {}").format(self.file.value()))
        FreeCADGui.Control.closeDialog()
        return True

    def _write(self) -> bool:
        from freecad_fiveaxis import app
        from freecad_fiveaxis.app import cam, results
        from freecad_fiveaxis.core.base.files import check_writable
        from freecad_fiveaxis.core.pipeline import outputs
        from freecad_fiveaxis.core.report import summary

        if self.spindle is not None:
            self.spindle.check()
        nc, reports = self._nc_path(), self._report_paths()
        for path in (nc, *reports.values()):
            check_writable(path)
        self._check_names(nc, reports)
        title = translate("FiveAxis", "Post-process")
        with transaction(self.path.Document, title), waiting(title):
            results.renew(self.path)
            self._put_spindle()
            figures = results.figures_of(self.path)
        self._show_poor()
        replaced = self._ask_to_replace([nc, *reports.values()]) if self._is_wanted(figures) else None
        if replaced is None:
            return False
        with transaction(self.path.Document, title), waiting(title):
            sheets = {
                path: outputs.REPORTS["." + kind](figures).encode("utf-8", "backslashreplace")
                for kind, path in reports.items()
            }
            app.post_process(self.path, nc, overwrite=nc in replaced, also=sheets)
            if self.preview.isChecked():
                cam.preview(self.path)
            lines = results.nc_of(self.path).count(b"\n")
        written.tell(nc, lines, summary(figures)["time_s"])
        return True

    def _check_names(self, nc: str, reports: dict[str, str]) -> None:
        """Raise FileError where the NC file has the name of a report, or of the document."""
        from freecad_fiveaxis.core.base.errors import FileError

        own = self.path.Document.FileName
        texts = [translate("FiveAxis", "{} is the name of the report too: name the NC file otherwise.")] * (
            nc in reports.values()
        )
        if own and os.path.realpath(own) in map(os.path.realpath, (nc, *reports.values())):
            texts.append(translate("FiveAxis", "{} is this document: name another file."))
        if texts:
            raise FileError(texts[0].format(nc), nc)

    def _put_spindle(self) -> None:
        """Give the path the speed that was typed here."""
        from freecad_fiveaxis.app import changes

        speed = self.spindle.value() if self.spindle else None
        if speed:
            self.path.Spindle = speed
            changes.compute(self.path)

    def _is_wanted(self, figures: Any) -> bool:
        """Whether the program is written: asked where it has errors, and where nothing starts the spindle."""
        parts = [*self._errors_first(figures), *self._spindle_off()]
        return not parts or ask("\n\n".join(parts), translate("FiveAxis", "Write anyway"))

    def _spindle_off(self) -> list[str]:
        """Return what to ask of a path that has no speed."""
        text = translate(
            "FiveAxis",
            "No spindle speed is given: the program leaves the spindle off, as for a dry run. Cancel, and "
            "type one.",
        )
        return [] if self.path.Spindle else [text]

    def _errors_first(self, figures: Any) -> list[str]:
        """Return the verdict of a program that is not safe, its errors, then its warnings; nothing of
        another."""
        from freecad_fiveaxis.core.base.codes import Severity
        from freecad_fiveaxis.core.report import Light, summary, verdict

        whole = verdict(figures, summary(figures))
        if whole.light is not Light.RED:
            return []
        poor = _poor(figures)
        parts = [wording.localize(whole.text)]
        for severity, title in (
            (Severity.ERROR, translate("FiveAxis", "Errors")),
            (Severity.WARNING, translate("FiveAxis", "Warnings")),
        ):  # fmt: skip
            texts = [f"• {wording.localize(one.text)}" for one in poor if one.severity is severity]
            more = [f"• {translate('FiveAxis', 'and {count} more').format(count=len(texts) - NAMED)}"] * (
                len(texts) > NAMED
            )
            parts += [title + "\n" + "\n".join(texts[:NAMED] + more)] * bool(texts)
        return parts

    def _nc_path(self) -> str:
        """Return the name of the NC file, whole. Raises FileError where there is none."""
        from freecad_fiveaxis.core.base.errors import FileError

        if not self.file.value():
            raise FileError(self.file.missing, "")
        return self.file.value()

    def _report_paths(self) -> dict[str, str]:
        """Return the name of each report that is wished: that of the NC file with another ending."""
        stem = os.path.splitext(self._nc_path())[0]
        return {kind: f"{stem}.{kind}" for kind, box in self.reports.items() if box.isChecked()}

    def _ask_to_replace(self, paths: list[str]) -> list[str] | None:
        """Those files that are there already, when the user agrees that they are replaced; None when not."""
        from freecad_fiveaxis.app.nc_output import is_ours

        there = [path for path in paths if os.path.lexists(path)]
        foreign = [path for path in there if not (os.path.isfile(path) and is_ours(self.path.Document, path))]
        text = translate("FiveAxis", "These files are there already. Replace them?")
        if foreign and not ask(text + "\n\n" + "\n".join(foreign), translate("FiveAxis", "Replace")):
            return None
        return there

    def reject(self) -> bool:
        """Cancel or Esc: nothing is written."""
        FreeCADGui.Control.closeDialog()
        return True

    def show_error(self, text: str) -> None:
        """Why nothing was written, in red under the file's name."""
        self.error.setText(text)
        self.error.setVisible(bool(text))


def _units_row(path: Any) -> list[Any]:
    """Where the user works in inches and the program does not, or the other way round: which it does."""
    from freecad_fiveaxis.app.controllers import units_of_path
    from freecad_fiveaxis.app.units import inches

    in_inches, word = units_of_path(path)
    if in_inches == inches():
        return []
    text = (
        translate("FiveAxis", "The program is in inches ({word}), whatever this document shows.")
        if in_inches
        else translate("FiveAxis", "The program is in millimetres ({word}), whatever this document shows.")
    )
    note = note_line("post_units")
    note.setText(text.format(word=word))
    note.setVisible(True)
    return [note]


def _spindle_leaf() -> Any:
    from freecad_fiveaxis.app.properties import list_options

    return next(leaf for _, leaf in list_options("mill") if leaf.name == "spindle")


def _poor(figures: Any) -> list[Any]:
    """Errors, then warnings, one of each kind: the first of a kind tells of all."""
    from freecad_fiveaxis.core.base.codes import Severity
    from freecad_fiveaxis.core.report.text import group_findings

    return [group[0] for group in group_findings(figures.findings) if group[0].severity > Severity.NOTE]


def write(path: Any) -> PostPanel:
    """Open the panel for a Toolpath."""
    return show(PostPanel(path))


def propose_name(path: Any) -> str:
    """Where the NC file of a Toolpath would go."""
    from freecad_fiveaxis.app.controllers import suffix_of_path

    return propose_file(path.Label or path.Name, path.Document.FileName, suffix_of_path(path))


def propose_file(name: str, document: str, suffix: str) -> str:
    """Return a file of that name in the folder of the preferences, else beside the file of the document, else
    in the user's own."""
    from freecad_fiveaxis.app import preferences
    from freecad_fiveaxis.core.base.files import plain_name

    folder = preferences.output_folder() or os.path.dirname(document) or os.path.expanduser("~")
    return os.path.join(str(folder), plain_name(name, "program") + suffix)


def _report_texts() -> dict[str, str]:
    return {
        "html": translate("FiveAxis", "Report as a web page (.html)"),
        "json": translate("FiveAxis", "Report for programs (.json)"),
    }
