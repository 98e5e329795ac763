# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that makes a program which proves a machine's signs, and the sheet for whoever stands at the
machine.

mark    its coordinates count from the work zero; where it is picked in the 3D view, from the work zero's
        place in the document.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Sequence
from typing import Any

import FreeCAD
import FreeCADGui

from freecad_fiveaxis.gui import selected
from freecad_fiveaxis.gui.qt import QtCore, QtGui, QtWidgets, translate

from . import result_html
from .files import SaveField, all_files, nc_files
from .form import Form, group_sections
from .picking import Point, PointField
from .post import propose_file
from .work_panel import WorkPanel, open_panel

USUAL_MARK = (30.0, 20.0, 0.0)
"""mm over the work zero: X and Y of the mark that is proposed."""
SHEETS = (".html", ".htm", ".txt", ".json")
WIDTH = 80
"""Pixels of a coordinate at least: of a mark off the zero all digits are to be read."""


class MarkField(PointField):
    """A place over the work zero; ``zero`` tells where in the document that is.

    Until somebody gives one, it is at the top of the part (``top``, mm in the document); where there is no
    part, none is given.
    """

    def __init__(self, name: str, hint: str, zero: Callable[[], Any]) -> None:
        super().__init__(name, hint, WIDTH)
        self.zero = zero
        self.top: float | None = None
        self.given, self._showing = False, False

    def value(self) -> list[float] | None:
        """Three numbers, mm; None where nobody has given one and there is no part."""
        return super().value() if self.given or self.top is not None else None

    def show_value(self, value: Sequence[float] | None) -> None:
        """Three numbers, or None."""
        self.given = value is not None
        self._show(value or USUAL_MARK)
        self.propose()

    def propose(self) -> None:
        """At the top of the part, unless somebody has given one."""
        if not self.given and self.top is not None:
            x, y, _ = USUAL_MARK
            self._show((x, y, round(self.top - self.zero()[2], 6)))

    def _show(self, value: Sequence[float]) -> None:
        self._showing = True
        super().show_value(value)
        self._showing = False

    def _on_change(self, *given: Any) -> None:
        self.given |= not self._showing
        super()._on_change(*given)

    def _on_find(self, point: Point) -> None:
        x, y, z = (round(there - here, 6) for there, here in zip(point, self.zero(), strict=True))
        super()._on_find((x, y, z))


class ProvePanel(WorkPanel):
    """A machine, the moves, and the two files that OK writes."""

    def __init__(self) -> None:
        hint = translate(
            "App::Property", "X,Y,Z over the work zero of a place to mark, as high as part and clamps reach"
        )
        self.zero = PointField(
            "work_zero", translate("FiveAxis", "Where the work zero lies in the document"), WIDTH
        )
        self.mark = MarkField("mark", hint, self.zero.value)
        self.nc_file = SaveField(
            "nc_file", translate("FiveAxis", "The NC file to write"), nc_files(),
            translate("FiveAxis", "The program: slow feed moves, with a stop after each"),
            translate("FiveAxis", "Name the NC file."),
        )  # fmt: skip
        self.sheet = SaveField(
            "sheet", translate("FiveAxis", "The sheet to write"),
            ";;".join([translate("FiveAxis", "Web page (*.html)"), all_files()]),
            translate("FiveAxis", "What must be seen at each stop, to print; empty: no sheet"),
            endings=SHEETS,
        )  # fmt: skip
        self.open_button = QtWidgets.QPushButton(translate("FiveAxis", "Open the sheet"))
        self.open_button.setObjectName("open_sheet")
        self.shown = ""
        form = Form("prove-signs", None, _sections(), [self.mark, self.zero, self.nc_file, self.sheet])
        super().__init__(translate("FiveAxis", "Prove the signs"), form, (self.open_button,))
        self.open_button.clicked.connect(lambda *_: self.open_sheet())
        self.nc_file.edited.connect(self._propose_sheet)
        self.zero.edited.connect(self.mark.propose)
        for name in ("machine", "controller"):
            form.fields[name].edited.connect(self.propose)

    def propose(self) -> None:
        """Names for the files, after the machine."""
        from freecad_fiveaxis.app.controllers import suffix_of

        options = self.options.options()
        machine = options.get("machine", "")
        name = os.path.splitext(os.path.basename(machine))[0] + " " + translate("FiveAxis", "signs")
        document = FreeCAD.ActiveDocument.FileName if FreeCAD.ActiveDocument else ""
        self.nc_file.propose(propose_file(name, document, suffix_of(options.get("controller"), machine)))
        self._propose_sheet()

    def _propose_sheet(self) -> None:
        if self.nc_file.value():
            self.sheet.propose(os.path.splitext(self.nc_file.value())[0] + ".html")

    def compute(self) -> Any:
        """Program and sheet."""
        from freecad_fiveaxis.app import signs

        values = self.options.read_values()
        nc_file, sheet = values.pop("nc_file"), values.pop("sheet")
        values.pop("work_zero")
        return signs.prove(nc_file, values, sheet or None)

    def tell(self, done: Any) -> str:
        """Return the sheet."""
        return result_html.sheet(done)

    def files(self, done: Any) -> list[str]:
        """Return the program and its sheet."""
        from freecad_fiveaxis.app import signs

        return signs.targets(done)

    def write(self, done: Any, overwrite: bool) -> None:
        """Write both."""
        from freecad_fiveaxis.app import signs

        signs.write(done, overwrite)

    def open_sheet(self) -> None:
        """Show the sheet as it will be printed, from a file of its own."""
        from freecad_fiveaxis.core.base.files import write_whole
        from freecad_fiveaxis.core.calibration import tasks as workshop

        self.shown = os.path.join(tempfile.mkdtemp(prefix="fiveaxis-"), "sheet.html")
        write_whole(self.shown, workshop.as_html(self.done).encode("utf-8", "backslashreplace"))
        QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(self.shown))


def create(machine: str = "") -> ProvePanel:
    """Open the panel; the first values are the user's preferences, and those of the tool path that is
    selected or alone. For a ``machine`` that is given, they are its own."""
    from freecad_fiveaxis.app import changes, preferences

    panel = ProvePanel()
    values = changes.default_options("prove-signs") | {
        "machine": preferences.machine(),
        "controller": preferences.controller(),
    }
    path = selected.find_selected_path(selected.TOOLPATH) if selected.has_path(selected.TOOLPATH) else None
    if machine:
        path, values = None, values | {"machine": machine, "controller": None}
    if path is not None:
        used = changes.read_options(path, "mill")
        values |= {
            name: used[name]
            for name in ("machine", "controller", "origin", "tool_length", "tool", "work_offset")
        }
        values |= {"work_zero": tuple(path.WorkZero)}
    panel.mark.top = _top(path)
    panel.options.show_options(values)
    panel.propose()
    return open_panel(panel)


def _top(path: Any) -> float | None:
    """Return the top of what is selected, else of the tool path's part, else of all that is seen, mm in the
    document."""
    from freecad_fiveaxis.app import signs

    if FreeCAD.ActiveDocument is None:
        return None
    chosen = signs.top_of(FreeCADGui.Selection.getSelection())
    if chosen is None and path is not None:
        chosen = signs.top_of([path.Mesh])
    return (
        chosen
        if chosen is not None
        else signs.top_of([one for one in FreeCAD.ActiveDocument.Objects if one.Visibility])
    )


def _sections() -> list[tuple[str, str, list[str]]]:
    less = ("origin", "work_offset")
    names = {name: (title, fields) for name, title, fields in group_sections("prove-signs", less)}
    title, moves = names.pop("prove")
    others = [(name, *pair) for name, pair in names.items()]
    files = ("output", translate("FiveAxis", "Output"), ["nc_file", "sheet"])
    return [*others, ("prove", title, moves), files]
