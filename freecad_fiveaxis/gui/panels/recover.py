# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that recovers a machine from a program: a CL file, the NC file made of it, and the machine file
to write."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from freecad_fiveaxis.gui.qt import QtWidgets, translate

from . import result_html
from .files import FileField, cl_files, nc_files, new_machine
from .form import Form
from .setup import ask_file, write_asking
from .work_panel import WorkPanel, open_panel


class RecoverPanel(WorkPanel):
    """Two files to read, a machine to compare with, and the file that OK writes."""

    def __init__(self) -> None:
        self.cl_file = FileField(
            "cl_file", translate("FiveAxis", "Choose the CL file (APT)"), cl_files(),
            translate("FiveAxis", "The CL file (APT) that the program was made from"),
            translate("FiveAxis", "Choose the CL file that the program was made from."),
        )  # fmt: skip
        self.program = FileField(
            "program", translate("FiveAxis", "Choose an NC file"), nc_files(),
            translate("FiveAxis", "The program that was made of the CL file, without tool centre point "
                                  "control"),
            translate("FiveAxis", "Choose the NC file that was made of it."),
        )  # fmt: skip
        self.target = new_machine()
        self.save_button = QtWidgets.QPushButton(translate("FiveAxis", "Save the report…"))
        self.save_button.setObjectName("page")
        form = Form("recover", None, _sections(), [self.cl_file, self.program, self.target])
        super().__init__(translate("FiveAxis", "Recover a machine"), form, (self.save_button,))
        self.save_button.clicked.connect(lambda *_: self.save())
        self.program.edited.connect(self._propose)

    def _propose(self) -> None:
        from freecad_fiveaxis.app import machines

        if self.program.value():
            self.target.propose(machines.free_file(Path(self.program.value()).stem))

    def compute(self) -> Any:
        """Return the machine that the post had in mind."""
        from freecad_fiveaxis.app import recovering

        values = self.options.read_values()
        cl_file, program, machine_file = (values.pop(name) for name in ("cl_file", "program", "machine_file"))
        return recovering.recover(cl_file, program, machine_file, values)

    def tell(self, done: Any) -> str:
        """Sentence, numbers with their certainty, findings."""
        return result_html.describe_recovered(done.found)

    def files(self, done: Any) -> list[str]:
        """Return the machine file."""
        return [done.settings.recover.machine_file]

    def write(self, done: Any, overwrite: bool) -> None:
        """Write the machine file; never over another one."""
        from freecad_fiveaxis.app import recovering

        recovering.write(done)

    def save(self) -> None:
        """Ask for a file and write the report there; a file that is there is replaced only if the user says
        so."""
        from freecad_fiveaxis.app import recovering

        file = ask_file(self.form, self.program.value(), Path(self.target.value()).stem)
        if file:
            write_asking(
                file, lambda agreed: recovering.write_report(self.done, file, agreed), self.options.show_error
            )


def create() -> RecoverPanel:
    """Open the panel."""
    from freecad_fiveaxis.app import changes

    panel = RecoverPanel()
    panel.options.show_options(changes.default_options("recover") | {"machine": None})
    return open_panel(panel)


def _sections() -> list[tuple[str, str, list[str]]]:
    return [
        ("files", translate("FiveAxis", "Files"), ["cl_file", "program", "controller"]),
        ("compare", translate("FiveAxis", "Compare with"), ["machine", "certainty"]),
        ("place", translate("FiveAxis", "Setup"), ["origin", "tool_length"]),
        ("output", translate("FiveAxis", "Output"), ["machine_file"]),
    ]
