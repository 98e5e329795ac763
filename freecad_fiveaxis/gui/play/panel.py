# SPDX-License-Identifier: LGPL-2.1-or-later
"""The player's task panel: it lets time pass, moves the picture, and says where the program stands.

A timer ticks; every tick the program goes on by the time that has passed, times the speed. A view that needs
longer to draw than a tick shows fewer pictures of the same motion.
"""

from __future__ import annotations

import time
from typing import Any

import FreeCADGui
import numpy as np

from freecad_fiveaxis.app import results, wording
from freecad_fiveaxis.app.selection import SelectionError
from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.machine import find_physical_columns
from freecad_fiveaxis.core.pipeline.in_machine import stand_up
from freecad_fiveaxis.core.pipeline.programs import MilledProgram
from freecad_fiveaxis.core.report.playback import NCLines, Pose
from freecad_fiveaxis.gui.failures import attend
from freecad_fiveaxis.gui.messages import status
from freecad_fiveaxis.gui.panels.panel_widget import MARGIN, shorten_title
from freecad_fiveaxis.gui.qt import QtCore, QtGui, QtWidgets, flags, icon, later, translate

from .camera import Camera
from .controls import SLIDER, Controls
from .document_copies import DocumentCopies
from .machine import machine_of
from .player import Player
from .readout import Readout
from .solids import DrawnFixtures
from .stage import Stage
from .tool import tool_of
from .watch import Watch

TICK = 30
"""ms between two pictures."""
READ = 0.1
"""s between two readings while the picture moves: faster, numbers are not read, and writing them takes a
tenth of a picture's time."""
LONGEST_STEP = 0.25
"""s: if the window was held up for longer, the program did not go on meanwhile."""
REACH = 0.9
"""How far the rotary axes are drawn, in diagonals of the path's box."""
LEAST_REACH = 30.0
"""mm."""


class PlayPanel:
    """The player of one path. ``close`` may come from the user, from a deleted object or from a closed
    document."""

    def __init__(self, obj: Any, view: Any) -> None:
        self.obj, self.view, self.camera = obj, view, Camera(view)
        figures = results.figures_of(obj)
        self.player = Player(figures)
        self.controls = Controls()
        self.readout = Readout(figures, NCLines(results.nc_of(obj)))
        self.form = self._widget()
        self.stage = self._new_stage()
        self.timer, self._then, self._drawn, self._read = QtCore.QTimer(), 0.0, -1, 0.0
        self._late = QtCore.QTimer()
        self._late.setSingleShot(True)
        self._late.timeout.connect(lambda: self._read_out(self.player.pose))
        self.timer.setInterval(TICK)
        self.timer.timeout.connect(self._tick)
        self._stale, self._open, self._docked = False, True, False
        self._connect()
        self.watch = Watch(obj, self._on_change, self._on_delete)
        _panels.append(self)
        self.refresh()

    # ------------------------------------------------------------------------------------- what the user does

    @property
    def playing(self) -> bool:
        """Whether time passes."""
        return bool(self.timer.isActive())

    @property
    def moving(self) -> bool:
        """Whether one picture follows the other: while time passes, or the user drags the slider."""
        return self.playing or bool(self.controls.slider.isSliderDown())

    def play(self, on: bool) -> None:
        """Let time pass, from the start again where the program is at its end; or hold it."""
        if on and self.player.at_end:
            self.player.begin()
        self._then = time.monotonic()
        if on:
            self.timer.start()
        else:
            self.timer.stop()
        self.controls.show_playing(on)
        self.refresh()

    def step(self, move: Any) -> None:
        """Pause and go somewhere else: ``move`` is one of the player's own moves."""
        if self.playing:
            self.play(False)
        move()
        self.refresh()

    def slide(self, value: int) -> None:
        """Go where the user has moved the slider."""
        self.player.go_to_share(value / SLIDER)
        self._then = time.monotonic()
        self.refresh()

    def _tick(self) -> None:
        now = time.monotonic()
        passed, self._then = min(now - self._then, LONGEST_STEP), now
        if self.controls.slider.isSliderDown():
            return
        stops = self.player.advance(passed * self.controls.each_speed())
        if stops or self.player.at_end:  # a short block would else be over before anybody saw what it hits
            self.play(False)
        self.refresh()

    # ------------------------------------------------------------------------------------------ the picture

    def refresh(self) -> None:
        """Show the moment at which the player stands."""
        if not self.stage.shown:
            return
        pose, block = self.player.pose, self.player.block
        curve = self.player.playback.curve(block) if block != self._drawn else None
        self._drawn = block
        player, on_machine = self.player, self.controls.machine.isChecked()
        self.stage.show(pose, curve, on_machine, player.struck, player.near, self.moving)
        self._read_out(pose)
        self.controls.show_share(self.player.share())
        if self.controls.follow.isChecked():
            self._follow()

    def _read_out(self, pose: Pose) -> None:
        """Say where the program stands; while the picture moves, a few times a second, and once more where
        the hand on the slider rests."""
        now = time.monotonic()
        if self.moving and now - self._read < READ:
            self._late.start(round(1e3 * min(READ, 1.0)))
            return
        self._late.stop()
        self._read = now
        self.readout.show(pose, self.player.playback.seconds, self.player.met)

    def _follow(self) -> None:
        try:
            self.camera.follow(self.stage.tip)
        except (ReferenceError, RuntimeError):  # the user has closed the view
            self.controls.follow.setChecked(False)

    def _new_stage(self) -> Stage:
        figures, settings = self.player.figures, results.result_of(self.obj).draft.settings
        low, high = figures.tip.min(axis=0), figures.tip.max(axis=0)
        tool = tool_of(self.obj, settings.machine.control_point == "centre")
        reach = max(REACH * float(np.linalg.norm(high - low)), LEAST_REACH)
        zero, words = np.array(self.obj.WorkZero), figures.program.letters
        letters = "".join(words[at] for at in find_physical_columns(words)[3:])
        draft = results.result_of(self.obj).draft
        origin = draft.settings.machine.origin or draft.machine.origin
        table = None if draft.machine.table is None else draft.machine.table - origin[2]
        box, held = self._part_box(), bool(draft.fixtures)
        standing, graph = stand_up(draft), self.view.getSceneGraph()
        document = DocumentCopies(graph, [len(one.mesh.face) for one in standing])
        machine = machine_of(self.player.playback, *box, tool, table, standing, held, document.counts)
        fixtures, middle = DrawnFixtures(draft.fixtures), (low + high) / 2.0
        return Stage(graph, tool, machine, fixtures, document, zero, letters, middle, reach)

    def _part_box(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the corners (3,) mm of the part's box, work frame; those of the path where no part is
        known."""
        draft, figures = results.result_of(self.obj).draft, self.player.figures
        cut = figures.tip[figures.feeds] if len(figures.feeds) else figures.tip
        points = draft.mesh.vertex if isinstance(draft, MilledProgram) else cut
        return points.min(axis=0), points.max(axis=0)

    # ----------------------------------------------------------------------------------- changes from outside

    def _on_change(self) -> None:
        if not self._stale:
            self._stale = True
            later(self._reload)

    def _reload(self) -> None:
        """Play the other result that the object shows now, from the same block; close where there is none."""
        self._stale = False
        if not self._open:
            return
        self.stage.remove()
        before = self.player
        try:
            self.player = Player(results.figures_of(self.obj))
            self.readout.use(self.player.figures, NCLines(results.nc_of(self.obj)))
            stage = self._new_stage()
        except FiveAxisError as error:
            status(wording.localize(error))
            self._leave()
            return
        self.player.resume(before)
        self._enable()
        self.stage, self._drawn = stage, -1
        self.refresh()

    def _on_delete(self) -> None:
        """Close the panel once FreeCAD is done with deleting the object or its document."""
        self.close()
        later(self._leave)

    def _leave(self) -> None:
        self.close()
        if self._docked:
            self._docked = False
            FreeCADGui.Control.closeDialog()

    def _on_destroy(self) -> None:
        """FreeCAD has closed the panel, for whatever reason."""
        self._docked = False
        self.close()

    def close(self) -> None:
        """Stop, and leave the view as it was. May be called twice."""
        if not self._open:
            return
        self._open = False
        _panels.remove(self)
        self.timer.stop()
        self._late.stop()
        self.watch.stop()
        self.stage.remove()
        try:
            self.camera.restore()
        except (ReferenceError, RuntimeError):  # the view has gone
            return

    # ----------------------------------------------------------------------------------- FreeCAD's task panel

    def getStandardButtons(self) -> int:
        """FreeCAD asks which buttons the panel has."""
        return flags(QtWidgets.QDialogButtonBox.Close)

    def isAllowedAlterSelection(self) -> bool:
        """Return the user may select while the panel is open."""
        return True

    def isAllowedAlterView(self) -> bool:
        """And turn the view."""
        return True

    def isAllowedAlterDocument(self) -> bool:
        """And change the document."""
        return True

    def reject(self) -> bool:
        """Close, or Esc."""
        self._leave()
        return True

    # ------------------------------------------------------------------------------------------ widgets

    def _widget(self) -> Any:
        form = QtWidgets.QWidget()
        form.setObjectName("FiveAxisPlay")
        form.setWindowTitle(translate("FiveAxis", "Play {path}").format(path=self.obj.Label))
        form.setWindowIcon(QtGui.QIcon(icon("FiveAxis_Play")))
        column = QtWidgets.QVBoxLayout(form)
        column.setContentsMargins(MARGIN, MARGIN, MARGIN, MARGIN)
        column.addWidget(self.controls.widget)
        column.addWidget(self.readout.widget)
        column.addStretch()
        form.destroyed.connect(lambda *_: self._on_destroy())
        return form

    def _connect(self) -> None:
        controls = self.controls
        self._enable()
        controls.play.clicked.connect(lambda *_: self.play(not self.playing))
        controls.connect(
            {
                "begin": lambda: self.step(self.player.begin),
                "back": lambda: self.step(self.player.back),
                "forward": lambda: self.step(self.player.forward),
                "worst": lambda: self.step(self.player.go_to_worst),
                "singular": lambda: self.step(self.player.go_to_next_singular),
                "collision": lambda: self.step(self.player.go_to_next_collision),
                "machine": self._to_machine,
                "follow": self._on_follow,
            }
        )
        controls.slider.valueChanged.connect(self.slide)
        controls.slider.sliderReleased.connect(self.refresh)

    def _enable(self) -> None:
        self.controls.singular.setEnabled(len(self.player.singular) > 0)
        self.controls.name_stops(any(one.hit is not None for one in self.player.stops))
        self.controls.collision.setVisible(len(self.player.stops) > 0)
        self.controls.worst.setEnabled(self.player.playback.worst is not None)

    def _on_follow(self) -> None:
        if not self.controls.follow.isChecked():
            self.camera.restore()
        self.refresh()

    def _to_machine(self) -> None:
        """Show the whole machine; over the part again, look from where the user looked before."""
        self.refresh()
        if not self.controls.machine.isChecked():
            self.camera.restore()
        elif not self.controls.follow.isChecked():
            low, high = self.stage.machine.room(self.player.playback)
            self.camera.cover(low + self.stage.zero, high + self.stage.zero)


_panels: list[PlayPanel] = []
"""Those that are open: one at most is shown, for FreeCAD shows a single task panel."""


def current() -> PlayPanel | None:
    """Return the player that is open."""
    return _panels[-1] if _panels else None


def open_panel(obj: Any) -> PlayPanel:
    """Show the player of a path. Raises FiveAxisError where there is nothing to play or no 3D view to play it
    in, and RuntimeError where another task panel is open."""
    panel = PlayPanel(obj, _view_of(obj))
    try:
        attend(panel)
        shorten_title(panel.form)
        FreeCADGui.Control.showDialog(panel)
    except RuntimeError:
        panel.close()
        raise
    panel._docked = True
    return panel


def _view_of(obj: Any) -> Any:
    gui = FreeCADGui.getDocument(obj.Document.Name)
    views = gui.mdiViewsOfType("Gui::View3DInventor")
    active = gui.ActiveView
    if not views:
        text = translate("FiveAxis", "{document} has no 3D view: open one and play {path} again.")
        raise SelectionError(text.format(document=obj.Document.Label, path=obj.Label), obj.Label)
    return active if hasattr(active, "getSceneGraph") else views[0]
