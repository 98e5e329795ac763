# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of a comparison, a window below the view: one row a machine, cure and kind of control. A click on
a head sorts it.

The numbers are the core's; each cell keeps its own (mm, s, rad) under the text in the user's units, and is
sorted by it. The window closes with the document of its path. Nothing here imports numpy before there is a
table.
"""

from __future__ import annotations

import math
from typing import Any

from .qt import QtCore, QtWidgets, main_window, translate

NAME = "FiveAxisComparison"
NUMBER = QtCore.Qt.UserRole
_docks: dict[str, Any] = {}


class Cell(QtWidgets.QTableWidgetItem):
    """A text, and the number that it is sorted by; without a number it comes last."""

    def __init__(self, text: str, number: float | None = None) -> None:
        super().__init__(text)
        if number is not None:
            self.setData(NUMBER, float(number))
            self.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)

    def __lt__(self, other: Any) -> bool:
        mine, others = self.data(NUMBER), other.data(NUMBER)
        if mine is None and others is None:
            return bool(self.text() < other.text())
        return (math.inf if mine is None else mine) < (math.inf if others is None else others)


class Table:
    """The window: a sentence, the table, and a button that saves it."""

    def __init__(self, dock: Any) -> None:
        self.dock, self.label = dock, ""
        self.comparison: Any = None
        self.document: Any = None
        self.verdict, self.table = QtWidgets.QLabel(), QtWidgets.QTableWidget(0, len(heads()))
        self.save_button = QtWidgets.QPushButton(translate("FiveAxis", "Save…"))
        self.error = QtWidgets.QLabel()
        for widget, name in ((self.table, "Table"), (self.save_button, "Save"), (self.verdict, "Verdict")):
            widget.setObjectName(NAME + name)
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.verticalHeader().hide()
        self.table.setHorizontalHeaderLabels(heads())
        self.save_button.clicked.connect(lambda *_: self.save())
        dock.setWidget(self._widget())

    def _widget(self) -> Any:
        widget = QtWidgets.QWidget()
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self.verdict, 1)
        row.addWidget(self.error)
        row.addWidget(self.save_button)
        column = QtWidgets.QVBoxLayout(widget)
        column.addLayout(row)
        column.addWidget(self.table)
        self.error.setStyleSheet("color: #d0342c;")
        return widget

    def show_rows(self, path: Any, comparison: Any) -> None:
        """Fill the table."""
        from freecad_fiveaxis.app import wording
        from freecad_fiveaxis.core.studies.compare import headline

        self.comparison = comparison
        self.label, self.document = path.Label, path.Document
        self.dock.setWindowTitle(translate("FiveAxis", "Machines on {label}").format(label=path.Label))
        self.verdict.setText(wording.localize(headline(comparison.rows, comparison.settings.proof.tolerance)))
        self.error.setText("")
        self.table.setSortingEnabled(False)
        beside = any(row.fixtures is not None for row in comparison.rows)
        self.table.setColumnHidden(len(heads()) - 1, not beside)
        self.table.setRowCount(len(comparison.rows))
        for at, row in enumerate(comparison.rows):
            for column, cell in enumerate(cells(row)):
                self.table.setItem(at, column, cell)
        self.table.horizontalHeader().setSortIndicator(
            -1, QtCore.Qt.AscendingOrder
        )  # in the core's order until a head is clicked
        self.table.setSortingEnabled(True)
        self.table.resizeColumnsToContents()
        self.table.resizeRowsToContents()

    def clear(self) -> None:
        """Show nothing."""
        self.comparison, self.label, self.document = None, "", None
        self.table.setRowCount(0)
        self.dock.hide()

    def save(self) -> None:
        """Ask for a file and write the table there; a file that is there is replaced only if the user says
        so."""
        from freecad_fiveaxis.app import comparing

        from .panels.setup import ask_file, write_asking

        file = ask_file(
            self.dock, self.document.FileName, self.label + " " + translate("FiveAxis", "machines")
        )
        if file:
            write_asking(
                file, lambda agreed: comparing.write(self.comparison, file, agreed), self.error.setText
            )


def show(path: Any, comparison: Any) -> Table:
    """Open the window with the rows of a comparison."""
    window = main_window()
    if "table" not in _docks:
        dock = QtWidgets.QDockWidget(translate("FiveAxis", "Machines"), window)
        dock.setObjectName(NAME)
        _docks["table"] = Table(dock)
        window.addDockWidget(QtCore.Qt.BottomDockWidgetArea, dock, QtCore.Qt.Vertical)  # the whole width
    shown = _docks["table"]
    shown.show_rows(path, comparison)
    shown.dock.show()
    shown.dock.raise_()
    return shown


def forget(gone: Any) -> None:
    """Close the table of a path whose document is closed."""
    shown = _docks.get("table")
    if shown is not None and shown.document is not None and shown.document is gone:
        shown.clear()


def heads() -> list[str]:
    """Return the titles of the columns."""
    return [
        translate("FiveAxis", "Machine"), translate("FiveAxis", "Correction"),
        translate("FiveAxis", "Tip guided (RTCP)"),
        translate("FiveAxis", "Largest deviation"), translate("FiveAxis", "Proven bound"),
        translate("FiveAxis", "Blocks"),
        translate("FiveAxis", "Time"), translate("FiveAxis", "Peak of X, Y, Z"),
        translate("FiveAxis", "Peak of 1st rotary"),
        translate("FiveAxis", "Peak of 2nd rotary"), translate("FiveAxis", "Limits"),
        translate("FiveAxis", "Part"),
        translate("FiveAxis", "Fixtures"),
    ]  # fmt: skip


def cells(row: Any) -> list[Cell]:
    """Return the cells of one row of the core."""
    from freecad_fiveaxis.app import wording
    from freecad_fiveaxis.app.labels import cure_label

    from .panels.summary import clock
    from .scene.units import length_text

    guided = translate("FiveAxis", "yes") if row.tool_centre else translate("FiveAxis", "no")
    named = [Cell(row.machine), Cell(cure_label(row.cure)), Cell(guided)]
    if row.problem:
        reason = Cell(translate("FiveAxis", "impossible: {why}").format(why=wording.localize(row.problem)))
        reason.setToolTip(wording.localize(row.problem))
        return [*named, *(Cell("–") for _ in range(7)), reason, Cell("–"), Cell("–")]
    linear = max(row.peak_rate[:3])
    within, ends = translate("FiveAxis", "within"), translate("FiveAxis", "only at block ends")
    over = translate("FiveAxis", "over by {length}").format(length=length_text(row.over))
    return [
        *named,
        *(Cell(ends if row.tool_centre else length_text(one), one) for one in (row.deviation, row.bound)),
        Cell(str(row.blocks), row.blocks),
        Cell(clock(row.time), row.time),
        Cell(f"{length_text(linear)}/min", linear),
        *(_turning(row, column) for column in (3, 4)),
        Cell(over if row.over > LEAST_OVER else within, row.over),
        _in_part(row),
        _beside(row),
    ]  # fmt: skip


LEAST_OVER = 5e-4
"""mm; less beyond a limit than this is none, as in the core's own table."""


def _in_part(row: Any) -> Cell:
    """Return how deep the tool goes into the part, sorted by that; what was not looked at comes last."""
    from freecad_fiveaxis.app import wording
    from freecad_fiveaxis.core.base.codes import Code
    from freecad_fiveaxis.core.studies.compare.beside_part import find_deepest

    from .scene.units import length_text

    if row.part is None:
        return Cell(translate("FiveAxis", "not checked"))
    deepest = find_deepest(row.part)
    if deepest is None:
        return Cell(translate("FiveAxis", "free"), 0.0)
    known = deepest.value is not None and deepest.unit == "mm" and deepest.code != Code.AVOIDED_FACES_NEAR
    text = translate("FiveAxis", "collides")
    if known:
        text = translate("FiveAxis", "{length} deep").format(length=length_text(deepest.value or 0.0))
    cell = Cell(text, deepest.value if known else math.inf)
    cell.setToolTip(wording.localize(deepest.text))
    return cell


def _beside(row: Any) -> Cell:
    """Return how deep the tool goes into which fixture, or how near it comes; sorted by the room left."""
    from freecad_fiveaxis.app import wording
    from freecad_fiveaxis.core.studies.compare.beside_fixtures import find_worst_meeting

    from .scene.units import length_text

    met = find_worst_meeting(row.fixtures)
    if met is None:
        return Cell("–") if row.fixtures is None else Cell(translate("FiveAxis", "free"), math.inf)
    words = translate("FiveAxis", "{length} in {fixture}")
    if met.room >= 0.0:
        words = translate("FiveAxis", "{length} from {fixture}")
    elif math.isinf(met.room):
        words = translate("FiveAxis", "wholly in {fixture}")
    length = "" if math.isinf(met.room) else length_text(abs(met.room))
    cell = Cell(words.format(length=length, fixture=met.fixture), met.room)
    cell.setToolTip(wording.localize(met.found.text))
    return cell


def _turning(row: Any, column: int) -> Cell:
    """Return the peak rate of a rotary axis; a dash where the machine has none."""
    from freecad_fiveaxis.core.machine import find_physical_columns

    letter, rate = row.letters[column], row.peak_rate[column]
    return (
        Cell(f"{letter} {math.degrees(rate):.0f}°/min", rate)
        if column in find_physical_columns(row.letters)
        else Cell("–")
    )
