# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields that name files: one to read, one to write."""

from __future__ import annotations

import os
from typing import Any

from freecad_fiveaxis.app.labels import option_hint
from freecad_fiveaxis.gui.qt import QtWidgets, translate

from .fields import TextField


class FileField(TextField):
    """A file to read, and a button that chooses it. ``title`` of the dialog, ``kinds`` of files as Qt filters
    them; ``missing``: what to do while none is named, empty where none is needed: a hint in the box, and an
    error once the file is ``wanted``."""

    wanted = False

    def __init__(self, name: str, title: str, kinds: str, hint: str = "", missing: str = "") -> None:
        super().__init__(name, hint)
        self.title, self.kinds, self.missing = title, kinds, missing
        self.browse = QtWidgets.QToolButton()
        self.browse.setText("…")
        self.browse.setToolTip(title)
        self.browse.setObjectName(name + "_browse")
        self.browse.clicked.connect(self._browse)
        self.editor.setPlaceholderText(missing)

    def want(self) -> None:
        """From now on a name that is missing is an error: the user has asked for what needs it."""
        self.wanted = True

    def check(self) -> None:
        """Raise FileError for a file that cannot be read, or is wanted and not named."""
        from freecad_fiveaxis.core.base.errors import FileError
        from freecad_fiveaxis.core.base.files import check_readable

        if self.value():
            check_readable(self.value())
        elif self.missing and self.wanted:
            raise FileError(self.missing, "")

    def _browse(self, *_: Any) -> None:
        path, _ = QtWidgets.QFileDialog.getOpenFileName(self.editor, self.title, self.value(), self.kinds)
        if path:
            self.show_value(path)


class SaveField(FileField):
    """A file to write. ``endings``: those that its name may have, none: any; ``new``: it must not be there
    yet.

    ``propose`` shows a name until the user gives one; a name without a folder belongs to the ``folder`` of
    what is proposed.
    """

    def __init__(
        self, name: str, title: str, kinds: str, hint: str = "", missing: str = "",
        endings: tuple[str, ...] = (),
        new: bool = False,
    ) -> None:  # fmt: skip
        super().__init__(name, title, kinds, hint, missing)
        self.endings, self.new, self._proposed, self.folder = endings, new, "", ""
        self.editor.editingFinished.connect(self._show_whole)

    def _show_whole(self) -> None:
        """Show where a name that was typed without its folder goes."""
        if self.value() != super().value():
            self.show_value(self.value())

    def show_written(self, path: str) -> None:
        """Show where the file was written; the next proposal takes its place."""
        self._proposed = path
        self.show_value(path)
        self.show_error("")

    def propose(self, path: str) -> None:
        """Show this name, unless the user has named another file."""
        self.folder = os.path.dirname(path)
        if self.value() == self._proposed:
            self._proposed = path
            self.show_value(path)

    def value(self) -> str:
        """Return the whole name; empty where there is none."""
        typed = os.path.expanduser(super().value())
        return os.path.abspath(os.path.join(self.folder, typed)) if typed else ""

    def check(self) -> None:
        """Raise FileError for a file that is not named, has no known ending, or is there although it may
        not."""
        from freecad_fiveaxis.app.machines import is_new_folder
        from freecad_fiveaxis.core.base.errors import FileError
        from freecad_fiveaxis.core.base.files import check_writable

        path = self.value()
        if not path:
            if self.missing and self.wanted:
                raise FileError(self.missing, "")
            return
        if self.endings and os.path.splitext(path)[1].lower() not in self.endings:
            text = translate("FiveAxis", "Its name must end in {endings}.")
            raise FileError(text.format(endings=", ".join(self.endings)), path)
        if self.new and os.path.lexists(path):
            raise FileError(translate("FiveAxis", "This file is there already: choose another name."), path)
        if not is_new_folder(path):
            check_writable(path)

    def _browse(self, *_: Any) -> None:
        options = QtWidgets.QFileDialog.DontConfirmOverwrite
        path, _ = QtWidgets.QFileDialog.getSaveFileName(
            self.editor, self.title, self.value(), self.kinds, "", options
        )
        if path:
            self.show_value(path)


def all_files() -> str:
    """Any kind of file, as Qt filters them."""
    return translate("FiveAxis", "All files (*)")


def cl_files() -> str:
    """Return the kinds of CL files, as Qt filters them."""
    return ";;".join(
        [translate("FiveAxis", "CL files (*.apt *.cl *.cls *.ncl *.aptsource *.txt)"), all_files()]
    )


def nc_files() -> str:
    """Return the kinds of NC files, as Qt filters them."""
    kinds = translate(
        "FiveAxis", "NC files (*.ngc *.nc *.tap *.cnc *.h *.mpf *.spf *.eia *.iso *.gcode *.txt)"
    )
    return ";;".join([kinds, translate("FiveAxis", "All files (*)")])


def machine_files() -> str:
    """Machine files, as Qt filters them."""
    return translate("FiveAxis", "Machine files (*.fcm)")


def any_file(leaf: Any) -> FileField:
    """Return the field of an option that names a file to read, of which no more is known than its help."""
    return FileField(leaf.name, translate("FiveAxis", "Choose a file"), all_files(), option_hint(leaf))


def new_machine() -> SaveField:
    """Return the field of a machine file to write, which is never one that is there."""
    from freecad_fiveaxis.app import machines

    field = SaveField(
        "machine_file", translate("FiveAxis", "The machine file to write"), machine_files(),
        translate("FiveAxis", "In the folder that is proposed it stands in every list of machines from then "
                              "on."),
        translate("FiveAxis", "Name the machine file."), (".fcm",), new=True,
    )  # fmt: skip
    field.folder = str(machines.user_folder())
    return field
