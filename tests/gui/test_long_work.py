# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window lives while the core works: its own events go on being served, and Esc stops everything.

Beats: a timer of the window's own thread. How many of them were served while the work went on is what the
tests ask for; no test depends on how quick the machine is. The bounds in seconds guard against hanging only:
more than ten times the most that was measured on two cores beside four busy loops, in scripts/busy's way.
"""

import subprocess
import time

import FreeCAD
import FreeCADGui
import Mesh
import numpy as np
import Part
import pytest
from conftest import QtCore, QtWidgets, close_all
from test_clicks import look

from freecad_fiveaxis import app
from freecad_fiveaxis.app import comparing, preferences, results, spreading
from freecad_fiveaxis.core.base import workers
from freecad_fiveaxis.core.base.errors import Cancelled
from freecad_fiveaxis.gui import keys
from freecad_fiveaxis.gui.waiting import waiting

pytestmark = pytest.mark.usefixtures("every_frame")

BEAT = 20
"""ms."""
ENOUGH = 40
"""Beats that are served under the dialog before Esc is pressed: the work goes on meanwhile."""
SOME = 10
"""Beats that are served under work that nobody stops."""
LONGEST = 30.0
"""s between two beats. Measured: 0.1 to 0.8, with half a million facets 0.4 to 1.9."""
LATEST = 10.0
"""s from Esc, or from a click on Cancel, until the work is over. Measured: 0.04 to 0.5."""


class Beats:
    """``served``: the beats inside the ``with`` while a dialog of long work is shown; ``gap``: the longest
    time between two beats, s.

    ``on(dialog)`` is called at each of them."""

    def __init__(self, on=None):
        self.served, self.gap, self._on = 0, 0.0, on

    def __enter__(self):
        self._last = time.monotonic()
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self._beat)
        self.timer.start(BEAT)
        return self

    def _beat(self):
        self._look()
        dialog = QtWidgets.QApplication.activeModalWidget()
        if isinstance(dialog, QtWidgets.QProgressDialog):
            self.served += 1
            if self._on:
                self._on(dialog)

    def _look(self):
        now = time.monotonic()
        self.gap, self._last = max(self.gap, now - self._last), now

    def __exit__(self, *_):
        self.timer.stop()
        self._look()


@pytest.fixture
def stopped(real_key):
    """stopped(work): Esc is pressed once ENOUGH beats were served under the work and ``ready()``, by the X
    server, again and again until the dialog goes. The work must be under way then. The longest gap between
    two beats, s, and the time from Esc to the work's end, s."""

    def run(work, ready=lambda: True):
        pressed = []

        def escape(dialog):
            if beats.served > ENOUGH and ready():
                pressed.append(time.monotonic())
                real_key(dialog, "Escape")

        with Beats(escape) as beats:
            work()
        assert pressed, f"the work was over before Esc was pressed; {beats.served} beats were served"
        late = time.monotonic() - pressed[0]
        print(f"{beats.served} beats, longest gap {beats.gap:.3f} s, Esc to end {late:.3f} s")
        return beats.gap, late

    return run


def state(doc):
    """What a stop must leave as it was."""
    return [
        (one.Name, one.Label, one.State, getattr(one, "Fingerprint", ""), getattr(one, "Facets", 0))
        for one in doc.Objects
    ]


def in_dialog(work):
    """The work as a command does it, stopped by the user."""

    def act():
        with pytest.raises(Cancelled), waiting("Watched"):
            work()

    return act


@pytest.fixture
def dome(doc):
    """A half ball of 20 mm."""
    ball = doc.addObject("Part::Sphere", "Dome")
    ball.Radius, ball.Angle1 = 20, 0
    doc.recompute()
    look(doc)
    return ball


@pytest.fixture
def path(dome, pump):
    """A path over it, of a few thousand blocks."""
    toolpath = app.create_toolpath(dome.Document, dome, machine="trunnion_ac", passes="planes", stepover=2)
    pump(500)
    return toolpath


def test_work_in_the_windows_own_thread_would_be_noticed(window, stopped):
    """No beat is served under it (but where the dialog comes up), so Esc never comes."""

    def in_window():
        with waiting("Watched"):
            time.sleep(1.5 * ENOUGH * BEAT / 1000)

    with pytest.raises(AssertionError, match=r"; [012] beats were served"):
        stopped(in_window)


@pytest.mark.parametrize(
    ("passes", "tool_axis", "stepover"),
    [("planes", "minimax", 0.3), ("planes", "facet_mean", 0.01), ("scallop", "auto", 0.3)],
)
def test_a_path_leaves_the_window_alive_and_esc_stops_it(path, stopped, passes, tool_axis, stepover):
    path.PassStrategy, path.ToolAxis, path.Stepover = passes, tool_axis, stepover
    before = state(path.Document)
    gap, late = stopped(in_dialog(lambda: results.result_of(path)))
    assert gap <= LONGEST and late <= LATEST and state(path.Document) == before


@pytest.fixture
def beside(monkeypatch):
    """Processes are started at once, two at a time; none of them is left. Whether one is ready."""
    pools, begin = [], workers.WorkerProcesses

    def keep(find, count, patience):
        pools.append(begin(find, 2, 0.0))
        return pools[-1]

    processes, start = [], workers.start
    monkeypatch.setattr(workers, "start", lambda *given: processes.append(start(*given)) or processes[-1])
    monkeypatch.setattr(spreading, "WorkerProcesses", keep)
    monkeypatch.setattr(preferences, "processes", lambda: 2)
    yield lambda: any(pool.ready for pool in pools)
    assert processes and all(process.returncode is not None for process in processes)
    assert [pool.died for pool in pools] == [0]


def test_comparing_machines_leaves_the_window_alive_and_esc_stops_it(path, stopped, beside):
    machines, before = ["trunnion_ac", "trunnion_bc"], state(path.Document)
    gap, late = stopped(in_dialog(lambda: comparing.compare(path, machines, comparing.cures())), beside)
    assert gap <= LONGEST and late <= LATEST and state(path.Document) == before


def test_a_map_of_setups_leaves_the_window_alive_and_esc_stops_it(path, stopped, beside):
    before = state(path.Document)
    gap, late = stopped(in_dialog(lambda: app.setup_map(path, grid=(9, 9, 9))), beside)
    assert gap <= LONGEST and late <= LATEST and state(path.Document) == before


def plate(count):
    """A plate of so many rounded pegs each way, ten faces and more a peg: one solid, thousands of faces."""
    box = Part.makeBox(8, 8, 8, FreeCAD.Vector(1, 1, 1))
    peg = box.makeFillet(1, box.Edges[4:12])
    pegs = []
    for i in range(count * count):
        pegs.append(peg.copy())
        pegs[-1].translate(FreeCAD.Vector(10 * (i % count), 10 * (i // count), 0))
    return Part.makeCompound(pegs)


@pytest.fixture(scope="module")
def coarse(window):
    """A document with a coarse path over a part of some 3000 faces: made once, for most of the time would go
    there."""
    doc = FreeCAD.newDocument()
    part = doc.addObject("Part::Feature", "Pegs")
    part.Shape = plate(14)
    app.create_toolpath(
        doc, part, passes="planes", stepover=6, linear_deflection=0.5, angular_deflection=90, gouge="off"
    )
    assert len(part.Shape.Faces) > 2500
    name = doc.Name
    yield doc
    close_all(name)


@pytest.fixture
def pegs(coarse):
    """Its path, asked for finer: a refresh meshes and computes."""
    FreeCAD.setActiveDocument(coarse.Name)
    path = coarse.Toolpath
    path.Mesh.LinearDeflection, path.Mesh.AngularDeflection = 0.002, 3
    assert "Touched" in path.Mesh.State and path.Blocks
    return path


def test_refreshing_a_path_of_thousands_of_faces_leaves_the_window_alive_and_esc_stops_it(pegs, stopped):
    before, facets = state(pegs.Document), pegs.Mesh.Facets
    gap, late = stopped(lambda: FreeCADGui.runCommand("Std_Refresh"))
    assert gap <= LONGEST and late <= LATEST
    assert pegs.Mesh.Facets == facets and pegs.Blocks and "stopped" in results.out_of_date(pegs)
    assert [row[:2] + row[3:] for row in state(pegs.Document)] == [row[:2] + row[3:] for row in before]


def test_cancel_is_pressed_by_the_mouse_while_freecad_recomputes(pegs):
    """By the X server: FreeCAD keeps the events of the mouse from all windows then."""
    at, hands = [], []

    def press_cancel():
        dialog = QtWidgets.QApplication.activeModalWidget()
        if isinstance(dialog, QtWidgets.QProgressDialog) and not at:
            at.append(time.monotonic())
            button = dialog.findChild(QtWidgets.QPushButton)
            spot = button.mapToGlobal(button.rect().center())
            hands.append(
                subprocess.Popen(
                    ["xdotool", "mousemove", str(spot.x()), str(spot.y()), "sleep", "0.3", "click", "1"]
                )
            )

    timer = QtCore.QTimer()
    timer.timeout.connect(press_cancel)
    timer.start(500)
    FreeCADGui.runCommand("Std_Refresh")
    timer.stop()
    late = time.monotonic() - at[0]
    hands[0].wait(60)
    print(f"Cancel shown to end {late:.3f} s")
    assert late < LATEST and "stopped" in results.out_of_date(pegs)


def test_a_whole_refresh_of_thousands_of_faces_leaves_the_window_alive(pegs):
    pegs.Mesh.LinearDeflection, pegs.Mesh.AngularDeflection = 0.02, 22.5
    with Beats() as beats:
        FreeCADGui.runCommand("Std_Refresh")
    print(f"a whole refresh: {beats.served} beats, longest gap {beats.gap:.3f} s, {pegs.Mesh.Facets} facets")
    assert pegs.Mesh.Facets > 50000 and "Up-to-date" in pegs.State
    assert beats.served >= SOME and beats.gap <= LONGEST


def test_a_mesh_of_half_a_million_facets_leaves_the_window_alive(doc, stopped):
    mesh = doc.addObject("Mesh::Feature", "Large")
    side = np.linspace(0.0, 100.0, 501)
    x, y = np.meshgrid(side, side)
    grid = np.stack([x, y, 5.0 * np.sin(x / 20.0) * np.cos(y / 15.0)], axis=-1)
    corner = np.stack(
        [grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[:-1, :-1], grid[1:, 1:], grid[1:, :-1]], axis=2
    )
    mesh.Mesh = Mesh.Mesh(corner.reshape(-1, 3).tolist())
    assert mesh.Mesh.CountFacets == 500000
    before = state(doc)
    gap, late = stopped(in_dialog(lambda: app.create_toolpath(doc, mesh, stepover=0.05)))
    assert gap <= LONGEST and late <= LATEST and state(doc) == before


def test_lifting_the_tool_leaves_the_window_alive_and_esc_stops_it(doc, stopped):
    pocket = doc.addObject("Part::Feature", "Pocket")
    pocket.Shape = Part.makeBox(60, 60, 30).cut(Part.makeSphere(22, FreeCAD.Vector(30, 30, 30)))
    path = app.create_toolpath(
        doc, pocket, cutter="ball:12", stepover=8, linear_deflection=0.2, gouge="off", holder="40x50"
    )
    path.Gouge, path.Stepover = "lift", 0.1
    before = state(doc)
    gap, late = stopped(in_dialog(lambda: results.result_of(path)))
    assert gap <= LONGEST and late <= LATEST and state(doc) == before


def test_a_fraction_that_stands_still_is_shown_as_a_bar_that_runs(window, pump):
    with waiting("Watched") as reported:
        bar = reported.dialog.findChild(QtWidgets.QProgressBar)
        reported("weld", 0.25)
        assert (bar.maximum(), bar.value()) == (100, 25)
        time.sleep(1.1)
        reported.pump()
        assert bar.maximum() == 0 and not reported.dialog.wasCanceled()
        reported("weld", 0.5)
        assert (bar.maximum(), bar.value()) == (100, 50)


class Form:
    """Stands for a panel's widget in a window that becomes active at the third look only."""

    def __init__(self):
        self.looks, self.keys = 0, []

    def isVisible(self):
        return True

    def isActiveWindow(self):
        self.looks += 1
        return self.looks > 2

    def hasFocus(self):
        return self.looks > 3

    def setFocus(self, _reason):
        self.keys.append(self.looks)


def test_after_long_work_the_panel_gets_the_keys_once_its_window_is_active(monkeypatch, pump, until):
    form = Form()
    monkeypatch.setattr(keys, "_open", [form])
    with waiting("Watched"):
        pass
    until(lambda: form.looks >= 4, 20000, "looks at the form")  # one more where the test before still looks
    pump(600)
    assert form.keys == [1, 2, 3]
