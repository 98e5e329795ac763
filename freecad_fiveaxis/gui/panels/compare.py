# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that compares machines on one tool path. Its table stands in a window below the view
(``comparison_table``)."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.app.labels import cure_label
from freecad_fiveaxis.gui import comparison_table
from freecad_fiveaxis.gui.messages import status
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, flags, translate
from freecad_fiveaxis.gui.waiting import waiting

from .choosers import has_head
from .fields import QuantityField
from .fixtures import FixturesField
from .lines import error_line
from .panel_widget import MARGIN
from .path_panel import show
from .toolpath import find_milled_solid

LINE_HEIGHT, LINES = 24, 9
"""Pixels of a line of the list, and how many are shown at once."""


class ComparePanel:
    """Machines and cures to choose, for the Toolpath ``path``."""

    def __init__(self, path: Any) -> None:
        from freecad_fiveaxis.app import comparing, machines

        self.path, self.title = path, translate("FiveAxis", "Compare machines")
        able = [one for one in machines.choices() if not one.error]
        self.machines = _list("machines", [(one.machine, one.label) for one in able], {path.Machine})
        cures = comparing.cures()
        self.cures = _list("cures", [(cure, cure_label(cure)) for cure in cures], set(cures))
        self.browse = QtWidgets.QPushButton(translate("FiveAxis", "Another machine file (.fcm)…"))
        self.length = QuantityField("tool_length", "length", _length_hint(), optional=True)
        self.length.show_value(path.ToolLength.Value)
        self.length.nest()
        self.fixtures = FixturesField(path.Document, find_milled_solid(path.Mesh), _fixtures_hint())
        self.fixtures.show_value(path.Fixtures)
        self.error = error_line("compare_error")
        self.calculate_button = QtWidgets.QPushButton(translate("FiveAxis", "Compare"))
        self.calculate_button.setObjectName("calculate")
        self.form = self._widget()
        self.length.edited.connect(lambda: self.show_error(wording.localize(self.length.refusal())))
        self.browse.clicked.connect(self._browse)
        self.calculate_button.clicked.connect(lambda *_: self.calculate())

    def _widget(self) -> Any:
        widget = QtWidgets.QWidget()
        widget.setObjectName("FiveAxisPanel")
        widget.setWindowTitle(
            translate("FiveAxis", "Compare machines on {label}").format(label=self.path.Label)
        )
        length = QtWidgets.QHBoxLayout()
        length.addWidget(QtWidgets.QLabel(translate("FiveAxis", "Tool length")))
        length.addWidget(self.length.editor)
        note = QtWidgets.QLabel(
            translate(
                "FiveAxis",
                "On each machine the work zero stands where its file says. The document stays as it is.",
            )
        )
        note.setWordWrap(True)
        column = QtWidgets.QVBoxLayout(widget)
        column.setContentsMargins(MARGIN, MARGIN, MARGIN, MARGIN)
        column.addWidget(self.calculate_button)
        column.addWidget(self.error)
        column.addWidget(QtWidgets.QLabel(translate("FiveAxis", "Machines")))
        column.addWidget(self.machines)
        column.addWidget(self.browse)
        column.addLayout(length)
        column.addWidget(QtWidgets.QLabel(translate("FiveAxis", "Corrections")))
        column.addWidget(self.cures)
        column.addWidget(QtWidgets.QLabel(self.fixtures.label))
        column.addWidget(self.fixtures.editor)
        for line in self.fixtures.lines.values():
            column.addWidget(line)
        column.addWidget(note)
        column.addStretch()
        return widget

    def _browse(self, *_: Any) -> None:
        text = translate("FiveAxis", "Machine files (*.fcm)")
        title = translate("FiveAxis", "Choose a machine file (.fcm)")
        path, _ = QtWidgets.QFileDialog.getOpenFileName(self.form, title, "", text)
        if path:
            _add(self.machines, path, path, True)

    def calculate(self) -> bool:
        """Drive the path on each machine and show the table; whether that went well."""
        from freecad_fiveaxis.app import comparing
        from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError

        self.show_error("")
        machines, cures = find_ticked(self.machines), find_ticked(self.cures)
        if not machines or not cures:
            self.show_error(translate("FiveAxis", "Tick at least one machine and one correction."))
            return False
        if self.length.refusal():
            self.show_error(wording.localize(self.length.refusal()))
            return False
        if self.length.value() is None and any(map(has_head, machines)):
            self.show_error(
                translate("FiveAxis", "The head of a machine that is ticked turns: give the tool length.")
            )
            return False
        try:
            with waiting(self.title):
                held, length = self.fixtures.value(), self.length.value()
                comparison = comparing.compare(self.path, machines, cures, length, fixtures=held)
        except Cancelled:
            status(translate("FiveAxis", "Stopped; the document is as it was."))
            return False
        except (FiveAxisError, ReferenceError) as error:
            gone = translate("FiveAxis", "The tool path was deleted meanwhile: close this panel.")
            self.show_error(gone if isinstance(error, ReferenceError) else wording.localize(error))
            return False
        comparison_table.show(self.path, comparison)
        return True

    def show_error(self, text: str) -> None:
        """Why there is no table, in red."""
        self.error.setText(text)
        self.error.setVisible(bool(text))

    def getStandardButtons(self) -> int:
        """FreeCAD asks which buttons the panel has."""
        return flags(QtWidgets.QDialogButtonBox.Close)

    def reject(self) -> bool:
        """Close or Esc; the table stays until it is closed."""
        FreeCADGui.Control.closeDialog()
        return True


def create(path: Any) -> ComparePanel:
    """Open the panel for a Toolpath."""
    return show(ComparePanel(path))


def find_ticked(box: Any) -> list[str]:
    """Return the values of the ticked lines."""
    lines = [box.item(at) for at in range(box.count())]
    return [line.data(QtCore.Qt.UserRole) for line in lines if line.checkState() == QtCore.Qt.Checked]


def _list(name: str, choices: list[tuple[str, str]], ticked: set[str]) -> Any:
    """Return a list whose lines can be ticked; what is ticked but not among the choices joins them under its
    own name."""
    box = QtWidgets.QListWidget()
    box.setObjectName(name)
    known = {value for value, _ in choices}
    for value, text in [*choices, *((one, one) for one in sorted(ticked - known))]:
        _add(box, value, text, value in ticked)
    box.setFixedHeight(LINE_HEIGHT * min(box.count() + 1, LINES))
    return box


def _add(box: Any, value: str, text: str, ticked: bool) -> None:
    line = QtWidgets.QListWidgetItem(text)
    line.setData(QtCore.Qt.UserRole, value)
    line.setToolTip(value)
    line.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable | QtCore.Qt.ItemIsUserCheckable)
    line.setCheckState(QtCore.Qt.Checked if ticked else QtCore.Qt.Unchecked)
    box.addItem(line)


def _fixtures_hint() -> str:
    return translate(
        "FiveAxis",
        "Solids and meshes of the document that hold the part: each program is proven against them",
    )


def _length_hint() -> str:
    return translate("FiveAxis", "From the gauge point to the tip: machines whose head turns need it")
