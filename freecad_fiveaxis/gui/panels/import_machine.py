# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that makes a machine file of a LinuxCNC configuration, a URDF file or a file of FreeCAD's Machine
editor."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from freecad_fiveaxis.gui.qt import translate

from . import result_html
from .files import FileField, all_files, new_machine
from .form import Form
from .work_panel import WorkPanel, open_panel


class FilesForm(Form):
    """A form without options of the core: files alone."""

    def check_together(self, options: Mapping[str, Any]) -> None:
        """Nothing can contradict."""


class ImportPanel(WorkPanel):
    """The file to import, the model with its bodies, and the machine file that OK writes."""

    def __init__(self) -> None:
        kinds = translate("FiveAxis", "LinuxCNC configurations, URDF and machine files (*.ini *.urdf *.fcm)")
        self.source = FileField(
            "source", translate("FiveAxis", "Choose the file to import"), ";;".join([kinds, all_files()]),
            translate("FiveAxis", "LinuxCNC's .ini, a .urdf, or a .fcm of FreeCAD's Machine editor"),
            translate("FiveAxis", "Choose the file to import."),
        )  # fmt: skip
        self.bodies = FileField(
            "bodies", translate("FiveAxis", "Choose the vismach model"),
            ";;".join([translate("FiveAxis", "Vismach models (*.py)"), all_files()]),
            translate("FiveAxis", "of a LinuxCNC .ini: its vismach model, which is read, never run"),
        )  # fmt: skip
        self.target = new_machine()
        sections = [("files", translate("FiveAxis", "Files"), ["source", "bodies", "machine_file"])]
        super().__init__(
            translate("FiveAxis", "Import a machine"),
            FilesForm("import-machine", None, sections, [self.source, self.bodies, self.target]),
        )
        self.found = ""
        self.source.edited.connect(self._propose)

    def _propose(self) -> None:
        from freecad_fiveaxis.app import importing, machines

        if self.source.value():
            self.target.propose(machines.free_file(Path(self.source.value()).stem))
        if self.bodies.value() in ("", self.found):
            self.found = importing.find_bodies(self.source.value())
            self.bodies.show_value(self.found)

    def compute(self) -> Any:
        """Return the machine, and what its source leaves open."""
        from freecad_fiveaxis.app import importing

        importing.check_target(self.target.value())
        return importing.read(self.source.value(), self.bodies.value())

    def tell(self, done: Any) -> str:
        """Axes and findings."""
        return result_html.describe_imported(done)

    def files(self, done: Any) -> list[str]:
        """Return the machine file."""
        return [self.target.value()]

    def write(self, done: Any, overwrite: bool) -> None:
        """Write the machine file; never over another one."""
        from freecad_fiveaxis.app import importing

        importing.write(done, self.target.value())


def create() -> ImportPanel:
    """Open the panel."""
    return open_panel(ImportPanel())
