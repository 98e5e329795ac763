# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of findings, a window at the side: the verdict, what a result says about itself, and where.

row       a finding of the result, or a marker that no finding tells of.
Picking a row moves the view to its place; picking a marker in the view selects its row. Below the list
stands, in plain words, what happens there, why, and what helps.
"""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

import FreeCAD
import FreeCADGui

from .failures import guards
from .qt import QtCore, QtWidgets, main_window, translate
from .verdict_label import VerdictLabel

if TYPE_CHECKING:
    from freecad_fiveaxis.core.report import Row

NAME = "FiveAxisFindings"
_docks: dict[str, Any] = {}


@guards
class Watcher:
    """Watches the selection: a marker that is picked shows its finding."""

    def addSelection(self, doc: str, name: str, sub: str, _point: Any = None) -> None:
        """Something was selected."""
        obj = FreeCAD.getDocument(doc).getObject(name)
        view: Any = getattr(getattr(obj, "ViewObject", None), "Proxy", None)
        if sub.startswith("Marker") and hasattr(view, "path_object"):
            show(view.path_object(), int(sub[len("Marker") :]) - 1)


def register() -> Watcher:
    """Start watching the selection; the caller keeps the watcher."""
    watcher = Watcher()
    FreeCADGui.Selection.addObserver(watcher)
    return watcher


def renew(path: Any) -> None:
    """List the other figures that the path has now, if it is listed."""
    panel = _docks.get("panel")
    if panel is not None and panel.path is path:
        panel.show_path(path)


def show_old(path: Any, why: str) -> None:
    """Say above the list why what it lists of the path is out of date; empty where it is not."""
    panel = _docks.get("panel")
    if panel is not None and panel.path is path:
        panel.show_old(why)


def forget(gone: Any) -> None:
    """Forget what is listed of a path or a document that is gone."""
    panel = _docks.get("panel")
    if panel is not None and panel.path is not None and gone in (panel.path, panel.document):
        panel.clear()


def show(path: Any, marker: int | None = None) -> Any:
    """Open the list for a path, at a marker (its row among the path's markers) where given; returns the
    Panel."""
    from .messages import telling
    from .waiting import waiting

    if path is None:
        return None
    from freecad_fiveaxis.app import results

    with telling():
        if path.Proxy.last is None:
            with waiting(translate("FiveAxis", "Findings")) as listener:
                results.figures_of(path, listener)
        panel = _panel()
        panel.show_path(path)
        if marker is not None:
            panel.show_marker(marker)
        return panel
    return None


def _panel() -> Panel:
    """Return the one panel; made when it is first asked for."""
    if "panel" not in _docks:
        window = main_window()
        dock = QtWidgets.QDockWidget(translate("FiveAxis", "Findings"), window)
        dock.setObjectName(NAME)
        _docks["panel"] = Panel(dock)
        window.addDockWidget(QtCore.Qt.RightDockWidgetArea, dock)
    _docks["panel"].dock.show()
    _docks["panel"].dock.raise_()
    return _docks["panel"]


class Panel:
    """The table and the text below it."""

    def __init__(self, dock: Any) -> None:
        from .panels.lines import warning_line

        self.dock, self.old = dock, warning_line(NAME + "Old")
        self.path: Any = None
        self.document: Any = None
        self.figures: Any = None
        self.rows: tuple[Row, ...] = ()
        self.row_of_marker: tuple[int, ...] = ()
        self.table, self.text = QtWidgets.QTableWidget(0, 4), QtWidgets.QTextBrowser()
        self.table.setObjectName(NAME + "Table")
        self.text.setObjectName(NAME + "Text")
        self.table.setHorizontalHeaderLabels(
            [translate("FiveAxis", "What"), translate("FiveAxis", "NC line"), translate("FiveAxis", "Value"),
             translate("FiveAxis", "Kind")]
        )  # fmt: skip
        self.table.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.table.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        self.table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.table.verticalHeader().hide()
        self.table.horizontalHeader().setStretchLastSection(True)
        self.table.itemSelectionChanged.connect(self._on_pick)
        split = QtWidgets.QSplitter(QtCore.Qt.Vertical)
        split.addWidget(self.table)
        split.addWidget(self.text)
        self.verdict = VerdictLabel(NAME + "Verdict")
        whole = QtWidgets.QWidget()
        column = QtWidgets.QVBoxLayout(whole)
        column.addWidget(self.old)
        column.addWidget(self.verdict)
        column.addWidget(split, 1)
        dock.setWidget(whole)
        dock.setMinimumWidth(360)

    def show_path(self, path: Any) -> None:
        """List the findings of a path whose result is there."""
        from freecad_fiveaxis.app import results
        from freecad_fiveaxis.core.report import list_findings

        figures = path.Proxy.last.figures
        self.path, self.document = path, path.Document
        self.dock.setWindowTitle(translate("FiveAxis", "Findings of {label}").format(label=path.Label))
        self.verdict.show_verdict(path)
        self.show_old(results.out_of_date(path))
        if figures is self.figures:
            return
        self.figures = figures
        self.rows, self.row_of_marker = list_findings(figures)
        self._fill()
        self.text.setHtml(_scope_page(figures, bool(self.rows)))

    def show_old(self, why: str) -> None:
        """Show why what is listed is out of date, in amber above the verdict; empty: it is not."""
        self.old.setText(why)
        self.old.setVisible(bool(why))

    def clear(self) -> None:
        """List nothing."""
        self.show_old("")
        self.path = self.document = self.figures = None
        self.rows, self.row_of_marker = (), ()
        self._fill()
        self.verdict.show_verdict(None)
        self.text.clear()
        self.dock.setWindowTitle(translate("FiveAxis", "Findings"))
        self.dock.hide()

    def show_marker(self, marker: int) -> None:
        """Select the row of a marker; the view stays where it is."""
        if marker < len(self.row_of_marker):
            row = self.row_of_marker[marker]
            self.table.blockSignals(True)
            self.table.selectRow(row)
            self.table.blockSignals(False)
            self.table.scrollToItem(self.table.item(row, 0))
            self.text.setHtml(self._page(row))

    def _fill(self) -> None:
        from .scene import words

        self.table.blockSignals(True)
        self.table.clearSelection()
        self.table.setRowCount(len(self.rows))
        for at, row in enumerate(self.rows):
            finding, name = row.finding, words.name_of(row.kind)
            line = "" if finding.line is None else str(finding.line)
            what = translate("FiveAxis", "{what}: all, the worst at").format(what=name) if row.whole else name
            cells = (what, line, words.value_text(finding), words.severity_name(finding.severity))
            for column, cell in enumerate(cells):
                self.table.setItem(at, column, QtWidgets.QTableWidgetItem(cell))
        self.table.resizeColumnsToContents()
        self.table.blockSignals(False)

    def _on_pick(self) -> None:
        """Tell of the row that the user has picked, and go there."""
        chosen = self.table.selectionModel().selectedRows()
        if not chosen:
            return
        row = chosen[0].row()
        self.text.setHtml(self._page(row))
        finding = self.rows[row].finding
        if finding.place is not None:
            from .scene.camera import look_at

            zero = self.path.WorkZero
            place = tuple(part + shift for part, shift in zip(finding.place, tuple(zero), strict=True))
            look_at(self.path.Document, place, self._reach(finding))

    def _reach(self, finding: Any) -> float:
        """How much of the part should be seen about the place, mm."""
        from freecad_fiveaxis.core.report import spot

        if not finding.block:
            return 20.0
        there = spot(self.figures, finding.block)
        depth = finding.value or 0.0 if finding.unit == "mm" else 0.0
        return 4.0 * max(there.step, 2.0 * there.deviation, depth, 0.25)

    def _page(self, at: int) -> str:
        """Return what happens, why, and what helps."""
        from freecad_fiveaxis.core.report import spot, summary

        from .scene import gouge_words, words

        row = self.rows[at]
        finding, title = row.finding, words.name_of(row.kind)
        explanation = words.explain(row.kind, spot(self.figures, finding.block)) if finding.block else None
        explanation = explanation or gouge_words.explain(finding)
        if finding.line is not None:
            title = translate("FiveAxis", "{what}, NC line {line}").format(what=title, line=finding.line)
        if explanation is None:
            from freecad_fiveaxis.app import wording

            return _html([("", wording.localize(finding.text))], title)
        heads = (
            translate("FiveAxis", "What happens"),
            translate("FiveAxis", "Why"),
            translate("FiveAxis", "What helps"),
        )
        parts = list(zip(heads, explanation, strict=True))
        return _html(
            [("", words.count_text(row.kind, summary(self.figures))), *parts] if row.whole else parts, title
        )


def _html(parts: list[tuple[str, str]], title: str) -> str:
    body = "".join(f"<p><b>{html.escape(head)}</b> {html.escape(text)}</p>" for head, text in parts)
    return f"<h3>{html.escape(title)}</h3>{body}"


def _scope_page(figures: Any, some: bool) -> str:
    """Return what the verdict rests on; above it, where there is not ``some`` finding, that there is none."""
    from freecad_fiveaxis.app import wording
    from freecad_fiveaxis.core.report import scope, summary

    parts = (
        [] if some else [("", translate("FiveAxis", "Nothing to report: all blocks are as they should be."))]
    )
    for name, texts in scope(figures, summary(figures)).named:
        parts += [(wording.localize(name) + ":", "; ".join(wording.localize(one) for one in texts) + ".")]
    return _html(parts, translate("FiveAxis", "What the verdict rests on"))
