# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a map of setups: how far the part may be moved, what is recommended, and the button that
applies it.

Over a solid without a tool path one is made first, with the preferences; it is part of the same step of undo.
"""

from __future__ import annotations

import html
import os
from types import SimpleNamespace
from typing import Any

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.gui.messages import ask, status
from freecad_fiveaxis.gui.qt import QtWidgets, translate
from freecad_fiveaxis.gui.scene.units import angle_text, length_text, write_number
from freecad_fiveaxis.gui.undo import is_there
from freecad_fiveaxis.gui.verdict_label import ADVICE
from freecad_fiveaxis.gui.waiting import waiting

from .fixtures import FixturesField
from .form import Form
from .path_panel import PathPanel, fit_soon, reveal, show
from .post import propose_file
from .summary import Summary, clock
from .toolpath import find_milled_solid, read_preferred


class SetupSummary(Summary):
    """What is recommended, in a sentence that is always whole, before and after."""

    def show_result(self, obj: Any) -> None:
        """Show the figures of the map."""
        cells = "".join(
            f"<tr><td>{label}&nbsp;</td><td>{html.escape(before)}&nbsp;</td><td><b>{html.escape(after)}</b></td></tr>"
            for label, before, after in rows(obj)
        )
        paragraphs = "".join(f"<p>{html.escape(text)}</p>" for text in obj.Findings)
        self.verdict.show_verdict(SimpleNamespace(Light=ADVICE, Verdict=obj.Verdict))
        self.tell(f"<table>{cells}</table>{paragraphs}")


def rows(obj: Any) -> list[tuple[str, str, str]]:
    """Label, value before and value after of each line of the summary."""
    zeros = [
        f"{letter} {length_text(value, 6)}"
        for letter, value in zip("XYZ" * 2, (*obj.Centre, *obj.Recommended), strict=True)
    ]
    times = [clock(float(getattr(time, "Value", time))) for time in (obj.TimeBefore, obj.TimeAfter)]
    return [
        ("", translate("FiveAxis", "now"), translate("FiveAxis", "recommended")),
        *((translate("FiveAxis", "Work zero"), *pair) for pair in zip(zeros[:3], zeros[3:], strict=True)),
        (translate("FiveAxis", "Turn about Z"), angle_text(0.0), angle_text(obj.RecommendedTurn.Value)),
        (
            deviation_words(obj),
            length_text(obj.DeviationBefore.Value),
            length_text(obj.DeviationAfter.Value),
        ),
        (translate("FiveAxis", "Time"), *times),
    ]


def deviation_words(obj: Any) -> str:
    """Return what the deviations of a map are called: of a path that divides its blocks they are not those of
    its program."""
    from freecad_fiveaxis.app import setups

    if setups.divides_blocks(obj.Path):
        return translate("FiveAxis", "Largest deviation, blocks not yet divided")
    return translate("FiveAxis", "Largest deviation")


def describe_applied(path: Any) -> str:
    """Return what a path has come to in its new place, by what the verdict goes by."""
    from freecad_fiveaxis.app import results, setups

    text = translate("FiveAxis", "Applied: the largest deviation is now {deviation}.")
    if setups.divides_blocks(path):
        text = translate(
            "FiveAxis", "Applied: the largest deviation of the divided blocks is now {deviation}."
        )
    return text.format(deviation=length_text(results.read_judged(path)[0]))


class SetupPanel(PathPanel):
    """The map of the Toolpath ``path``, of a new one over ``base`` and its ``faces``, or the map ``obj`` to
    change."""

    SUMMARY = SetupSummary
    CREATES_PROGRAM = False  # a map is no program

    def __init__(
        self, path: Any = None, base: Any = None, faces: tuple[str, ...] = (), obj: Any = None
    ) -> None:
        from freecad_fiveaxis.app import preferences

        self.path, self.base, self.faces = path, base, faces
        doc = (path or base).Document
        machine = path.Machine if path else preferences.machine()
        names = ["region", "grid", "turns", "table_height", "fixtures", "jaw_thickness"]
        section = ("setup", translate("FiveAxis", "Setup"), names)
        hint = translate(
            "App::Property",
            "Solids and meshes of the document that hold the part, as in the tool path, which takes a change",
        )
        held = FixturesField(doc, find_milled_solid(path.Mesh if path else base), hint)
        form = Form("setup", doc, [section], [held], group="SetupSettings", given={"machine": machine})
        super().__init__(doc, translate("FiveAxis", "Where to clamp"), form, obj)
        form.fields["table_height"].editor.setPlaceholderText(table_of(machine))

    def _widget(self, title: str) -> Any:
        widget = super()._widget(title)
        self.apply_button = QtWidgets.QPushButton(translate("FiveAxis", "Apply to the tool path"))
        self.page_button = QtWidgets.QPushButton(translate("FiveAxis", "Save as a web page…"))
        for at, (name, button) in enumerate((("apply", self.apply_button), ("page", self.page_button))):
            button.setObjectName(name)
            widget.layout().insertWidget(2 + at, button)
        self.apply_button.clicked.connect(lambda *_: self.apply())
        self.page_button.clicked.connect(lambda *_: self.save())
        return widget

    def _show_parts(self) -> None:
        """Hide what a map has not: it is no path, and has no cuts, links and rapids to switch."""
        self.shown_parts.show_for(None)

    def is_current(self) -> bool:
        """Whether the map is of its toolpath, and that of its part, as they are."""
        from freecad_fiveaxis.app import results

        path = self.obj.Path
        return bool(self.obj.UpToDate) and path is not None and not results.out_of_date(path)

    def calculate(self) -> bool:
        """Return the places of the map lie about the part: all of them are to be seen."""
        good = super().calculate()
        if good:
            fit_soon(self.doc)
        return good

    def compute(self) -> Any:
        """Return the map of the toolpath; over a part, of a new toolpath with the preferences."""
        from freecad_fiveaxis import app
        from freecad_fiveaxis.app import results

        values = self.options.read_values()
        if self.path is not None:
            results.renew(self.path)
        else:
            held = values["fixtures"]
            self.path = app.create_toolpath(
                self.doc, self.base, faces=self.faces, fixtures=held, **read_preferred()
            )
        return app.setup_map(self.path, **values)

    def forget_gone(self) -> None:
        """The path that was made with the map goes with it."""
        if self.base is not None and self.path is not None and not is_there(self.path):
            self.path = None
        super().forget_gone()

    def _undone(self) -> None:
        super()._undone()
        if self.base is not None:
            self.path = None

    def _on_edit(self) -> None:
        super()._on_edit()
        turned = not self.stale and self.obj.RecommendedTurn.Value != 0.0
        self.apply_button.setEnabled(not self.stale and not turned)
        self.apply_button.setToolTip(
            translate("FiveAxis", "Turn the solid first, as the recommendation says, then try one turn only.")
            if turned
            else translate(
                "FiveAxis",
                "Set the tool path's work zero on the machine to the recommended one, and compute it.",
            )
        )
        self.page_button.setEnabled(not self.stale)

    def apply(self) -> bool:
        """Give the toolpath the recommended work zero; whether that went well. Cancel takes it back."""
        from freecad_fiveaxis import app

        self.step.begin()
        try:
            with waiting(self.title):
                app.apply_setup(self.obj)
        except BaseException as error:  # FreeCADAbort (Esc) is no Exception
            self._undone()
            self._tell(error)
            return False
        self.options.show_error("")
        self.summary.tell(
            f"<p><b>{html.escape(describe_applied(self.path))}</b></p>{self.summary.text.text()}"
        )
        reveal(self.form)
        return True

    def save(self) -> None:
        """Ask for a file and write the map there; a file that is there is replaced only if the user says
        so."""
        from freecad_fiveaxis.app import setups

        file = ask_file(self.form, self.doc.FileName, self.path.Label + " " + translate("FiveAxis", "setups"))
        if file:
            write_asking(
                file, lambda agreed: setups.write_page(self.obj, file, agreed), self.options.show_error
            )


def table_of(machine: str) -> str:
    """Return what the empty field of the table's height says: the machine's own, where its file has one."""
    from freecad_fiveaxis.core.base.errors import FiveAxisError
    from freecad_fiveaxis.core.machine import load_machine

    try:
        table = load_machine(machine).table
    except FiveAxisError:  # the form says what is wrong with the machine
        table = None
    return translate("FiveAxis", "not known") if table is None else f"{write_number(f'{table:g}')} mm"


def ask_file(parent: Any, document: str, name: str) -> str:
    """Return the file that the user names for a report, proposed beside the file of the document; empty where
    he names none."""
    proposed = propose_file(name, document, ".html")
    kinds = translate("FiveAxis", "Web page (*.html);;For programs (*.json);;Text (*.txt)")
    dialog = QtWidgets.QFileDialog
    return dialog.getSaveFileName(
        parent,
        translate("FiveAxis", "Save the table and its pictures"),
        proposed,
        kinds,
        "",
        dialog.DontConfirmOverwrite,
    )[0]


def write_asking(file: str, write: Any, tell: Any) -> bool:
    """``write(agreed)`` the file; where one is there, ask first. What cannot be written is told by
    ``tell``."""
    from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError

    there = os.path.lexists(file)
    question = translate("FiveAxis", "These files are there already. Replace them?")
    if there and not ask(question + "\n\n" + file, translate("FiveAxis", "Replace")):
        return False
    tell("")
    try:
        with waiting(translate("FiveAxis", "Save")):
            write(there)
    except Cancelled:
        status(translate("FiveAxis", "Stopped; the document is as it was."))
        return False
    except FiveAxisError as error:
        tell(wording.localize(error))
        return False
    status(translate("FiveAxis", "Written: {}").format(file))
    return True


def create(path: Any) -> SetupPanel:
    """Open the panel for a Toolpath; its map, where there is one, is renewed."""
    from freecad_fiveaxis.app import setups

    existing = setups.of(path)
    return edit(existing) if existing is not None else _open(SetupPanel(path), {"fixtures": path.Fixtures})


def create_over(base: Any, faces: tuple[str, ...] = ()) -> SetupPanel:
    """Open the panel for a part that has no tool path yet."""
    return _open(SetupPanel(base=base, faces=faces), {})


def edit(obj: Any) -> SetupPanel:
    """Open the panel for a map that is there."""
    from freecad_fiveaxis.app import setups

    values = setups.own_options(obj) | {"fixtures": obj.Path.Fixtures}
    return _open(SetupPanel(obj.Path, obj=obj), values)


def _open(panel: SetupPanel, values: dict[str, Any]) -> SetupPanel:
    from freecad_fiveaxis.app import changes

    panel.fill(changes.default_options("setup") | values)
    return show(panel)
