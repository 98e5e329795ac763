# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of the machine editor: what to start from, the machine, its axes and bodies, and the file that it
is written to.

picture   the machine as it stood when it last was right, in a 3D view of its own; the sliders move it.
draft     the machine as the fields say it, right or wrong. What is wrong with it is shown as soon as the
          typing pauses.
kept      the draft as it was opened or written last: only what differs from it is asked about before the
          panel closes.
document  an empty one that is open only while the panel is. The user's own documents are never touched.
"""

from __future__ import annotations

import html
from typing import Any

import FreeCAD
import FreeCADGui

from freecad_fiveaxis.app import editing, machines, wording
from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.editing import AttachedMeshes, MachineDraft
from freecad_fiveaxis.gui.messages import ask, status
from freecad_fiveaxis.gui.panels.choosers import MachineField
from freecad_fiveaxis.gui.panels.fields import Field
from freecad_fiveaxis.gui.panels.files import new_machine
from freecad_fiveaxis.gui.panels.folding import FoldingGroup
from freecad_fiveaxis.gui.panels.panel_widget import PanelWidget, TextArea
from freecad_fiveaxis.gui.panels.path_panel import fit, show
from freecad_fiveaxis.gui.panels.work_panel import give_back
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, flags, later, translate

from .axes import AxesEditor
from .bodies import BodiesEditor
from .general import GeneralFields
from .jog import JogSliders

PAUSE = 300
"""ms without a letter typed after which the machine is looked at."""
COLOURS = {Severity.ERROR: "#d0342c", Severity.WARNING: "#b06000", Severity.NOTE: "#6b7785"}


class EditorPanel:
    """A task panel. ``draft`` and ``kept`` as at the head of the module; ``machine``: what the draft makes,
    None while it makes none; ``written``: the file that was written last."""

    def __init__(self, machine: str) -> None:
        self.start = MachineField(
            "start_from", translate("FiveAxis", "The machine whose values are changed; it stays as it is")
        )
        self.attached = AttachedMeshes()
        self.general, self.axes, self.bodies = GeneralFields(), AxesEditor(), BodiesEditor(self.attached)
        self.jog, self.target = JogSliders(), new_machine()
        self.picture: Any = None
        self.names, self.document, self.written = editing.list_known_names(), "", ""
        self.machine: Machine | None = None
        self.draft: MachineDraft
        self.kept: MachineDraft
        self.opened, self.filling = machine, False
        self.findings = QtWidgets.QLabel()
        self.save_button = _button("save", translate("FiveAxis", "Save"))
        self.prove_button = _button("prove", translate("FiveAxis", "Prove the signs…"))
        self.form = self._widget()
        self.timer = QtCore.QTimer()
        self.timer.setSingleShot(True)
        self.timer.setInterval(PAUSE)
        self._connect()
        self.load(machine)

    def _widget(self) -> Any:
        self.findings.setObjectName("editor_findings")
        self.findings.setWordWrap(True)
        self.findings.setTextFormat(QtCore.Qt.RichText)
        self.findings.setAlignment(QtCore.Qt.AlignTop)
        self.findings_area = TextArea(self.findings)
        body = QtWidgets.QWidget()
        column = QtWidgets.QVBoxLayout(body)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(3)
        for group in self._groups():
            column.addWidget(group)
        head = (self.save_button, self.prove_button, self.findings_area)
        return PanelWidget(translate("FiveAxis", "Edit a machine"), head, body)

    def _groups(self) -> list[Any]:
        first = FoldingGroup("start", translate("FiveAxis", "Machine to start from"), "machine-editor_start")
        first.body.add(self.start)
        last = FoldingGroup("file", translate("FiveAxis", "File"), "machine-editor_file")
        last.body.add(self.target)
        return [first, self.general.group, self.axes.group, self.bodies.group, self.jog.group, last]

    def _connect(self) -> None:
        self.timer.timeout.connect(self.judge)
        self.start.edited.connect(self._start_elsewhere)
        self.general.edited.connect(lambda: self._edit(self.general.apply(self.draft)))
        self.axes.edited.connect(lambda: self._edit(self.axes.draft or self.draft))
        self.bodies.edited.connect(lambda: self._edit(self.bodies.draft or self.draft))
        self.bodies.refused.connect(self._tell)
        self.bodies.attach.found.connect(lambda *_: later(self._come_to_front))
        self.jog.moved.connect(self._move)
        self.target.edited.connect(self._check_target)
        self.save_button.clicked.connect(lambda *_: self.save())
        self.prove_button.clicked.connect(lambda *_: later(self.prove))

    # ------------------------------------------------------------------------------------------ the draft

    @property
    def changed(self) -> bool:
        """Whether something would be lost."""
        return self.draft != self.kept

    def load(self, machine: str) -> None:
        """Start from a machine. Raises FiveAxisError; then nothing is changed."""
        self.draft = self.kept = editing.open_draft(machine)
        self.opened, self.written = machine, ""
        self._show()
        self.target.propose(machines.free_file(self.draft.name))
        self.judge()
        self._fit()

    def _show(self) -> None:
        self.filling = True
        self.start.show_value(self.opened)
        self.general.show_draft(self.draft)
        self.axes.show_draft(self.draft, 0)
        self.bodies.show_draft(self.draft, 0)
        self.filling = False

    def _start_elsewhere(self) -> None:
        machine = self.start.value()
        if not self.filling and machine != self.opened:
            later(
                lambda: self._start_from(machine)
            )  # a question must not stand in the way of the list that closes

    def _start_from(self, machine: str) -> None:
        if not self.changed or self._ask_to_leave():
            try:
                self.load(machine)
                return
            except FiveAxisError as error:
                self._tell(wording.localize(error))
        self.filling = True
        self.start.show_value(self.opened)
        self.filling = False

    def _edit(self, draft: MachineDraft) -> None:
        if self.filling or draft == self.draft:
            return
        renamed = draft.name != self.draft.name or self.target.value() == self.written
        self.draft = draft
        self.general.draft = self.axes.draft = draft
        self.bodies.follow(draft)
        if renamed:
            self.target.propose(machines.free_file(draft.name))
        self.timer.start()
        self._enable()

    # ------------------------------------------------------------------------------------------ the picture

    def draw_in(self, view: Any) -> None:
        """Draw the machine in a 3D view from now on."""
        from .picture import MachinePicture

        self.picture = MachinePicture(view.getSceneGraph())
        self._draw()
        view.viewIsometric()
        self._fit()

    def _draw(self) -> None:
        """Draw the machine, unless it is drawn as it is or makes no machine."""
        if self.picture is None or self.machine is None:
            return
        if self.machine == self.picture.shown:
            self._move()
            return
        try:
            self.picture.show(self.machine, self.jog.joints)
        except FiveAxisError as error:
            self._tell(wording.localize(error))

    def _move(self) -> None:
        if self.picture is not None:
            self.picture.move(self.jog.joints)

    def _come_to_front(self) -> None:
        """Show the machine's picture again, behind which the user's document came when something was selected
        there."""
        if self.document in FreeCAD.listDocuments():
            FreeCADGui.setActiveDocument(self.document)

    def _fit(self) -> None:
        if self.document:
            later(lambda: fit(self.document))

    # ---------------------------------------------------------------------------------- what is wrong with it

    def judge(self) -> None:
        """Say what is wrong with the machine and what it leaves open."""
        self.timer.stop()
        self.machine, problems = editing.check(self.draft, self.names)
        lines = [(COLOURS[one.severity], wording.localize(one.text)) for one in problems]
        if self.written and not self.changed:
            lines.insert(
                0, (COLOURS[Severity.NOTE], translate("FiveAxis", "Written: {}").format(self.written))
            )
        self._write(
            lines or [(COLOURS[Severity.NOTE], translate("FiveAxis", "Nothing is wrong with this machine."))]
        )
        self._enable()
        self.jog.show_draft(self.draft)
        self._draw()

    def _tell(self, text: str) -> None:
        self._write([(COLOURS[Severity.ERROR], text)])

    def _write(self, lines: list[tuple[str, str]]) -> None:
        self.findings.setText(
            "<br>".join(f'<span style="color: {colour}">{html.escape(text)}</span>' for colour, text in lines)
        )
        self.findings_area.updateGeometry()

    def _enable(self) -> None:
        self.save_button.setEnabled(not self.timer.isActive() and self.machine is not None)
        self.prove_button.setEnabled(bool(self.written) and not self.changed)

    def _check_target(self) -> bool:
        self.target.show_error("")
        if self.filling:
            return True
        try:
            self.target.check()
        except FiveAxisError as error:
            self.target.show_error(wording.localize(error))
            return False
        return True

    # ------------------------------------------------------------------------------------- what the user does

    def save(self) -> bool:
        """Write the machine as a new file; whether that went well."""
        self.judge()
        self.target.want()
        refused = next((reason for field in self._fields() if (reason := field.refusal())), "")
        if refused:
            self._tell(wording.localize(refused))
        if refused or self.machine is None or not self._check_target():
            return False
        try:
            self.written = editing.write(self.draft, self.target.value(), self.attached)
        except FiveAxisError as error:
            self._tell(wording.localize(error))
            return False
        self.kept, self.names = self.draft, self.names | {self.draft.name}
        status(translate("FiveAxis", "Written: {}").format(self.written))
        self._keep_written()
        return True

    def _fields(self) -> list[Field]:
        return [field for part in (self.general, self.axes, self.bodies) for field in part.fields.values()]

    def _keep_written(self) -> None:
        """Keep in mind that the file is there now; the next one gets another name, once something is
        changed."""
        self.filling = True
        self.draft = self.kept = editing.open_draft(self.written)
        self.opened = self.written
        self.start.show_value(self.written)
        self.general.draft = self.axes.draft = self.draft
        self.bodies.show_draft(self.draft)  # what was attached has a file now
        self.target.show_written(self.written)
        self.filling = False
        self.names -= {self.draft.name}
        self.judge()

    def prove(self) -> None:
        """Close, and open the panel that proves the signs of the machine that was written."""
        from freecad_fiveaxis.gui.panels import prove_signs

        machine = self.written
        self._close()
        later(lambda: prove_signs.create(machine))

    def getStandardButtons(self) -> int:
        """FreeCAD asks which buttons the panel has."""
        return flags(QtWidgets.QDialogButtonBox.Close)

    def reject(self) -> bool:
        """Close or Esc: asks only where something would be lost."""
        if self.changed and not self._ask_to_leave():
            return False
        self._close()
        return True

    def _ask_to_leave(self) -> bool:
        question = translate("FiveAxis", "This machine is not saved. Leave it, and lose what was changed?")
        return ask(question, translate("FiveAxis", "Do not save"))

    def _close(self) -> None:
        self.timer.stop()
        self.bodies.attach.stop()
        if self.picture is not None:
            self.picture.remove()
        self.attached.close()
        FreeCADGui.Control.closeDialog()
        later(lambda: give_back(self.document))


def _button(name: str, text: str) -> Any:
    button = QtWidgets.QPushButton(text)
    button.setObjectName(name)
    return button


def create() -> EditorPanel:
    """Open the panel; it starts from the machine of the preferences, or from a shipped one where that cannot
    be read."""
    from freecad_fiveaxis.app import preferences
    from freecad_fiveaxis.core.machine import list_shipped_machines

    try:
        panel = EditorPanel(preferences.machine())
    except FiveAxisError:
        panel = EditorPanel(list_shipped_machines()[-1])
    if not FreeCADGui.Control.activeDialog():
        before = FreeCAD.ActiveDocument
        panel.document = FreeCAD.newDocument("Machine", translate("FiveAxis", "Machine")).Name
        panel.bodies.attach.stand_beside(panel.document, before.Name if before is not None else "")
        view = FreeCADGui.getDocument(panel.document).ActiveView
        if hasattr(view, "getSceneGraph"):
            panel.draw_in(view)
    return show(panel)
