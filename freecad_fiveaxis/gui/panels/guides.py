# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of what leads passes: typed, or picked in the 3D view and then named by the object that it is of.

A field that is picked gives the numbers that the pick has now; whoever edits these lets go of it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import FreeCAD
import FreeCADGui

from freecad_fiveaxis.app.labels import option_hint
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, later, translate

from .fields import Field, TextField, width_of
from .files import all_files
from .picking import Pick
from .triple import LAST, TripleField

APART, LEAST = 4, 30
"""Pixels between a line and the button for its file, and the least width of such a line: what stands there is
long anyway."""
Zero = Callable[[], Sequence[float]]
"""Gives the work zero, mm, document."""
Link = tuple[Any, str]
"""An object and the name of an element of it."""


class ElementPick(Pick):
    """Waits for one vertex, edge or face; ``found`` gets the object and the element's name."""

    def addSelection(self, doc: str, name: str, element: str, _spot: Any) -> None:
        """FreeCAD calls this when something is selected."""
        from freecad_fiveaxis.app.selection import leaf_of

        if self.running and element:  # an empty element: chosen in the tree
            obj = FreeCAD.getDocument(doc).getObject(name)
            link = leaf_of(obj, element), element.rsplit(".", 1)[-1]
            later(lambda: self._take(link))


class Picker(QtCore.QObject):
    """The button beside a field, and the link that was picked with it. ``show`` gets what the link says now,
    as the option."""

    def __init__(self, field: Field, zero: Zero, wanted: str, show: Callable[[Any], None]) -> None:
        super().__init__()
        self.field, self.zero, self.show = field, zero, show
        self.link: Link | None = None
        self.seen_from: tuple[float, ...] = ()
        self.named = QtWidgets.QLabel()
        self.named.setObjectName(field.name + "_picked")
        self.named.setWordWrap(True)
        self.named.hide()
        self.button = QtWidgets.QToolButton()
        self.button.setObjectName(field.name + "_pick")
        self.button.setText(translate("FiveAxis", "Pick"))
        self.button.setToolTip(wanted)
        self.button.setCheckable(True)
        self.button.clicked.connect(self._on_press)
        self.pick = ElementPick(self.take_link, lambda: self.button.setChecked(False))

    def _on_press(self, down: bool) -> None:
        if down:
            self.pick.start()
        else:
            self.pick.stop()

    def take_link(self, link: Link) -> None:
        """Take a link that the user has picked; say what is needed where it is none that can be used."""
        from freecad_fiveaxis.app import wording
        from freecad_fiveaxis.core.base.errors import FiveAxisError

        try:
            self.take(link)
        except FiveAxisError as error:
            self.field.show_error(wording.localize(error))
            return
        FreeCADGui.Selection.addSelection(link[0].Document.Name, link[0].Name, link[1])  # it lights up
        self.field.edited.emit()

    def take(self, link: Link | None) -> None:
        """Show a link and what it says; None: there is none. Raises FiveAxisError for what cannot be used."""
        from freecad_fiveaxis.app import guides, wording

        if link is not None:
            self.seen_from = tuple(self.zero())
            self.show(guides.options_of({self.field.name: link}, self.zero())[self.field.name])
        self.link = link
        self.named.setText(wording.localize(guides.name_of(link)) if link else "")
        self.named.setVisible(link is not None)

    def let_go(self) -> None:
        """Let go of the object: the numbers were edited and are the user's own from now on."""
        if self.link is not None:
            self.take(None)


def show_link(picker: Picker, link: Link | None) -> None:
    """Show a link that is kept already; one that is gone stays, and its field says so."""
    from freecad_fiveaxis.app import wording
    from freecad_fiveaxis.core.base.errors import FiveAxisError

    try:
        picker.take(link)
    except FiveAxisError as error:
        picker.link = link
        picker.named.setText(wording.localize(error))
        picker.named.show()


class PlaceField(TextField):
    """A place or a curve: a word, X,Y,Z about the work zero, a CSV file of a curve, or what is picked."""

    def __init__(self, name: str, zero: Zero) -> None:
        super().__init__(name, _hint(name))
        self.picker = Picker(self, zero, _explain_pick(name), self._show)
        self.pick, self.browse, self.line = self.picker.pick, self.picker.button, self.editor
        self.editor.textEdited.connect(lambda *_: self.picker.let_go())
        self.file = QtWidgets.QToolButton() if name != "pass_centre" else None
        self.editor = _with(self.line, self.file, self.picker.named, self.name)
        if self.file is not None:
            self.file.clicked.connect(lambda *_: self._choose_file())

    def _choose_file(self) -> None:
        kinds = ";;".join([translate("FiveAxis", "Curves (*.csv)"), all_files()])
        path, _ = QtWidgets.QFileDialog.getOpenFileName(
            self.editor, translate("FiveAxis", "Choose a file"), "", kinds
        )
        if path:
            self.show_value(path)
            self.edited.emit()

    def check(self) -> None:
        """Raise FileError for a boundary that is a file which cannot be read."""
        from freecad_fiveaxis.core.base.curve_text import is_inline
        from freecad_fiveaxis.core.base.files import check_readable

        if self.name == "boundary" and self.value() and not is_inline(self.value()):
            check_readable(self.value())

    @property
    def link(self) -> Link | None:
        """What was picked."""
        return self.picker.link

    def focus_widget(self) -> Any:
        """Return the line."""
        return self.line

    def room(self) -> int:
        """Return the name of what is picked may be long."""
        return width_of(self.line, "0" * 12) + (
            0 if self.file is None else self.file.sizeHint().width() + APART
        )

    def value(self) -> str:
        """Return the text as job files have it, its words in the core's language."""
        text = str(self.line.text()).strip()
        return next((word for word, local in _words().items() if text == local), text)

    def show_value(self, value: str | None) -> None:
        """Show the text, as typed."""
        self.picker.let_go()
        self._show(value)

    def show_link(self, link: Link | None) -> None:
        """Show a link, or none."""
        show_link(self.picker, link)

    def follow_zero(self) -> None:
        """Show the picked place about a work zero that was changed."""
        if self.link is not None and tuple(self.picker.zero()) != self.picker.seen_from:
            show_link(self.picker, self.link)

    def _show(self, value: str | None) -> None:
        self.line.setText(_words().get(value or "", value or ""))
        self.line.setCursorPosition(0)


def _words() -> dict[str, str]:
    """Return the words that stand for a place, and what they are in the user's language."""
    return {"border": translate("FiveAxis", "border"), "middle": translate("FiveAxis", "middle")}


class AxisField(TripleField):
    """The axis of radial passes: a direction, or an edge or round face that has one."""

    def __init__(self, zero: Zero) -> None:
        super().__init__("pass_axis", "vector", _hint("pass_axis"))
        wanted = translate(
            "FiveAxis",
            "Then click a straight or circular edge, or a cylindrical or conical face, in the 3D view; Esc "
            "stops it",
        )
        self.picker = Picker(self, zero, wanted, self._show)
        self.pick = self.picker.pick
        self.row.addWidget(self.picker.button, LAST, 0)
        self.row.addWidget(self.picker.named, LAST, 1, 1, 2)
        self.showing = False

    @property
    def link(self) -> Link | None:
        """What was picked."""
        return self.picker.link

    def show_value(self, value: Sequence[float] | None) -> None:
        """Three numbers, as typed."""
        if hasattr(self, "picker"):
            self.picker.let_go()
        self._show(value)

    def show_link(self, link: Link | None) -> None:
        """Show a link, or none."""
        show_link(self.picker, link)

    def _show(self, value: Sequence[float] | None) -> None:
        self.showing = True
        super().show_value(value)
        self.showing = False

    def _on_change(self, *_: Any) -> None:
        if not self.showing:
            self.picker.let_go()
            super()._on_change()


def _explain_pick(name: str) -> str:
    """Return what may be clicked for an option."""
    if name == "pass_centre":
        return translate("FiveAxis", "Then click a vertex, a circle or a sphere in the 3D view; Esc stops it")
    if name == "boundary":
        return translate(
            "FiveAxis", "Then click a face, or an edge of a closed wire, in the 3D view; Esc stops it"
        )
    return translate("FiveAxis", "Then click a vertex or an edge in the 3D view; Esc stops it")


def _with(line: Any, file: Any, named: Any, name: str) -> Any:
    """Return an editor with a button for a file beside it, None for none, and a line of words below it."""
    whole = QtWidgets.QWidget()
    whole.setObjectName(name)
    whole.setAccessibleName(line.accessibleName())
    line.setObjectName(name + "_line")
    column = QtWidgets.QVBoxLayout(whole)
    column.setContentsMargins(0, 0, 0, 0)
    column.setSpacing(2)
    row = QtWidgets.QHBoxLayout()
    row.setSpacing(APART)
    row.addWidget(line)
    if file is not None:
        line.setMinimumWidth(LEAST)
        file.setText("…")
        file.setToolTip(translate("FiveAxis", "Choose a CSV file with the points of the curve"))
        file.setObjectName(name + "_browse")
        row.addWidget(file)
    column.addLayout(row)
    column.addWidget(named)
    return whole


def _hint(name: str) -> str:
    from freecad_fiveaxis.app.properties import list_options

    return option_hint(next(leaf for _, leaf in list_options("mill") if leaf.name == name))
