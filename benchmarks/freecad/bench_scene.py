# SPDX-License-Identifier: LGPL-2.1-or-later
"""``make bench-window``: what a frame of FreeCAD's 3D view takes, as ratios to peers in the same view; run
inside FreeCAD.

path    the whole picture of a path, to the bare lines of its strokes
map     a map of rest material, to its bare facets
labels  eight labels and two legends, one of them seen, over a ball, to the ball alone
play    a machine of half a million facets, while it stands (all of them) and while it moves (its coarser
        copy), and an empty view, to its bare facets; and what a step takes besides drawing
work    the same of a part of half a million facets, a mesh and a solid, over which and on the machine the
        program is played; and, of the clock, how many pictures a second are seen while it plays

A frame is the processor's time of the whole process for it: Mesa draws on the processor where there is no
graphics card.
"""

import json
import statistics
import sys
import time
from pathlib import Path

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from PySide import QtCore

HERE = Path(__file__).parent
sys.path[:0] = [
    str(HERE.parent),
    str(HERE.parents[1] / "tests" / "gui"),
    str(HERE.parents[1] / "tests" / "core"),
]

from large_scenes import Frames, long_path, picture_of_long, surface  # noqa: E402
from report_examples import dome  # noqa: E402
from timing import print_table  # noqa: E402

from freecad_fiveaxis.core.geometry.mesh import write_stl  # noqa: E402
from freecad_fiveaxis.core.machine.machine_file import machine_folder  # noqa: E402
from freecad_fiveaxis.core.report.rest_material_map import height_scale  # noqa: E402
from freecad_fiveaxis.gui.scene import nodes, on_screen, path_nodes, rest_nodes, words  # noqa: E402

LOOK = path_nodes.Look((0.0, 0.62, 0.45), (0.835, 0.369, 0.0), (0.8, 0.475, 0.655))
TURNS = 12
REPEAT = 5
HEADS = ("scene", "ms a frame", "peer, ms", "ratio")


@pytest.fixture
def view():
    """Open a 3D view in a window as large as the screen."""
    FreeCADGui.getMainWindow().setGeometry(0, 0, 1920, 1080)
    doc = FreeCAD.newDocument()
    QtCore.QCoreApplication.processEvents()
    yield FreeCADGui.getDocument(doc.Name).ActiveView
    FreeCAD.closeDocument(doc.Name)


def seconds(view, *drawn):
    """Of each of REPEAT rounds: the processor's time for a frame with these nodes, s. The first round fills
    the caches."""
    frames, found = Frames(), []
    group = nodes.separate(frames.node, *drawn)
    view.getSceneGraph().addChild(group)
    view.viewTop()
    view.fitAll()
    for _ in range(1 + REPEAT):
        frames.count, began = 0, time.process_time()
        for turn in range(TURNS):
            view.setCameraOrientation(FreeCAD.Rotation(FreeCAD.Vector(1, 0.3, 0.2), 20 + 7 * turn))
            view.redraw()
            QtCore.QCoreApplication.processEvents()
        found.append((time.process_time() - began) / max(frames.count, 1))
    view.getSceneGraph().removeChild(group)
    return found[1:]


def row(view, name, ours, peer):
    """Print a line of the table."""
    first, second = (statistics.median(seconds(view, *drawn)) for drawn in (ours, peer))
    return name, f"{1e3 * first:.1f}", f"{1e3 * second:.1f}", f"{first / second:.2f}"


def bare(points, corners):
    """Lines of two, or facets of three points, without colours, labels or marks: what drawing them takes at
    the least."""
    place, shape = (
        nodes.coin.SoCoordinate3(),
        nodes.coin.SoLineSet() if corners == 2 else nodes.coin.SoFaceSet(),
    )
    place.point.setValues(0, len(points), points.astype(np.float32))
    shape.numVertices.setValues(0, len(points) // corners, np.full(len(points) // corners, corners, np.int32))
    return place, shape


def test_path(view, capsys):
    rows = []
    for count in (500_000, 1_000_000):
        pairs, level = long_path(count)
        picture = picture_of_long(dome(), LOOK, pairs, level)
        rows.append(row(view, f"{count} blocks, {len(level)} strokes", (picture.root,), bare(pairs, 2)))
    with capsys.disabled():
        print_table("A long path, to the bare lines of its strokes", HEADS, rows)


def test_map(view, capsys, monkeypatch):
    rows = []
    for side, most in ((316, None), (223, 1000)):
        if most:
            monkeypatch.setattr(rest_nodes, "MOST_PATCHES", most)
        mesh, rest = surface(side)
        node = rest_nodes.rest_surface(mesh, rest, height_scale(rest, 0.01, 0.03))
        name = f"{len(mesh.face)} facets{', each with its worst sample' if most else ''}"
        rows.append(row(view, name, (node,), bare(mesh.vertex[mesh.face].reshape(-1, 3), 3)))
    with capsys.disabled():
        print_table("A map of rest material, to its bare facets", HEADS, rows)


BLOCKS = "G21 G90 G94\nG1 X0 Y0 Z60 A0 C0 F2000\nG1 X40 Y5 Z50 A40 C80\nG1 X0 Y-40 Z60 A-40 C200\nM2\n"
BODY = {"name": "housing", "carrier": "A", "file": "housing.stl"}


def play_of(view, folder, side):
    """Open the player on a machine with one body, on A, of 2 side^2 facets; its panel and these."""
    mesh = surface(side)[0]
    write_stl(mesh, folder / "housing.stl")
    data = json.loads((machine_folder() / "trunnion_ac.fcm").read_text(encoding="utf-8"))
    data["fiveaxis"]["bodies"] = [BODY]
    (folder / "m.fcm").write_text(json.dumps(data), encoding="utf-8")
    shown = player_of(folder, str(folder / "m.fcm"))
    shown.controls.machine.setChecked(True)
    QtCore.QCoreApplication.processEvents()
    return shown, mesh


def player_of(folder, machine):
    """Open the player of a small program; its panel."""
    from freecad_fiveaxis import app
    from freecad_fiveaxis.gui import play
    from freecad_fiveaxis.gui.play import panel

    (folder / "p.ngc").write_text(BLOCKS, encoding="utf-8")
    play.show(app.audit(FreeCAD.ActiveDocument, str(folder / "p.ngc"), machine))
    return panel.current()


def steps(view, shown, draw):
    """Of each of REPEAT rounds: the processor's time of a step of the player, s; with drawing, that of a
    frame."""
    frames, found = Frames(), []
    view.getSceneGraph().addChild(frames.node)
    for _ in range(1 + REPEAT):
        frames.count, began = 0, time.process_time()
        for at in range(TURNS):
            shown.player.block, shown.player.u = 1 + at % 2, at / TURNS
            shown.refresh()
            if draw:
                view.redraw()
                QtCore.QCoreApplication.processEvents()
        found.append((time.process_time() - began) / (max(frames.count, 1) if draw else TURNS))
    view.getSceneGraph().removeChild(frames.node)
    return found[1:]


def test_play(view, capsys, tmp_path):
    shown, mesh = play_of(view, tmp_path, 501)
    view.viewIsometric()
    view.fitAll()
    standing, step = (statistics.median(steps(view, shown, draw)) for draw in (True, False))
    shown.controls.slider.setSliderDown(True)  # as a hand does that drags it
    moving = statistics.median(steps(view, shown, True))
    (drawn,) = shown.stage.machine.drawn
    copy = drawn.copy
    assert drawn.reduced
    shown.reject()
    peer = statistics.median(seconds(view, *bare(mesh.vertex[mesh.face].reshape(-1, 3), 3)))
    found = [
        (f"{len(mesh.face)} facets, standing", standing),
        (f"moving, {len(copy.mesh.face)} facets", moving),
        ("an empty view", statistics.median(seconds(view))),
    ]
    with capsys.disabled():
        rows = [(name, f"{1e3 * s:.1f}", f"{1e3 * peer:.1f}", f"{s / peer:.2f}") for name, s in found]
        print_table("A machine that moves, to its bare facets", HEADS, rows)
        print("frames a second:", ", ".join(f"{name} {1.0 / s:.1f}" for name, s in found))
        print(f"all but drawing: {1e3 * step:.2f} ms a step; the copy is {copy.deviation:.2f} mm off at most")


def mesh_part(folder):
    """Add a mesh of 502,002 facets to the document."""
    import Mesh

    write_stl(surface(501)[0], folder / "part.stl")
    FreeCAD.ActiveDocument.addObject("Mesh::Feature", "Part").Mesh = Mesh.Mesh(str(folder / "part.stl"))


def solid_part(_folder):
    """Add a solid of 518,400 facets to the document: eight rings of which OpenCASCADE meshes one."""
    import Part

    one, part = Part.makeTorus(30, 12), FreeCAD.ActiveDocument.addObject("Part::Feature", "Part")
    part.ViewObject.Deviation, part.ViewObject.AngularDeflection = 0.1, 4.0
    places = [FreeCAD.Vector(x, y, z) for x in (-50, 50) for y in (-50, 50) for z in (0, 30)]
    part.Shape = Part.makeCompound([one.translated(place) for place in places])


def frames_seen(view, shown, shape, seconds_long=4.0):
    """What a picture takes while the program plays from its copy: the processor's time, and the clock's,
    s."""
    frames = Frames()
    view.getSceneGraph().addChild(frames.node)
    shown.controls.speed.setCurrentIndex(0)
    shown.player.begin()
    shown.play(True)
    for long in (1.0, seconds_long):  # the first second fills the caches
        frames.count, began, spent = 0, time.monotonic(), time.process_time()
        while time.monotonic() - began < long:
            QtCore.QCoreApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
    found = [passed / frames.count for passed in (time.process_time() - spent, time.monotonic() - began)]
    assert shape.reduced and shown.playing
    shown.play(False)
    view.getSceneGraph().removeChild(frames.node)
    return found


@pytest.fixture
def pieces(monkeypatch):
    """How long each piece of the work at copies holds the window up, s."""
    from freecad_fiveaxis.gui.play.document_copies import DocumentCopies

    found, go_on = [], DocumentCopies._go_on

    def timed(copies):
        began = time.thread_time()
        go_on(copies)
        found.append(time.thread_time() - began)

    monkeypatch.setattr(DocumentCopies, "_go_on", timed)
    return found


@pytest.mark.parametrize("add", [mesh_part, solid_part])
def test_work(view, capsys, tmp_path, pieces, add):
    add(tmp_path)
    FreeCAD.ActiveDocument.recompute()
    shown, found = player_of(tmp_path, "trunnion_ac"), []
    while shown.stage.document.busy:
        QtCore.QCoreApplication.processEvents()
    (shape,) = shown.stage.document.shapes
    view.viewIsometric()
    for on_machine in (False, True):
        shown.controls.machine.setChecked(on_machine)
        shown.refresh()
        view.fitAll()
        where = "on the machine" if on_machine else "over the part"
        for moving in (False, True):
            shown.controls.slider.setSliderDown(moving)
            spent = statistics.median(steps(view, shown, True))
            assert shape.reduced == moving
            found.append((f"{where}, {'moving' if moving else 'standing'}", spent))
        shown.controls.slider.setSliderDown(False)
        spent = frames_seen(view, shown, shape)
        found += [(f"{where}, played{by}", s) for by, s in zip(("", ", by the clock"), spent, strict=True)]
    copy = shape.copy
    shown.reject()
    with capsys.disabled():
        rows = [(name, f"{1e3 * s:.1f}", f"{1.0 / s:.1f}") for name, s in found]
        print_table(f"Play with a part of {shape.count} facets", ("scene", "ms a frame", "a second"), rows)
        print(f"copy: {len(copy.mesh.face)} facets, {copy.deviation:.2f} mm off at most; made in")
        print(f"{len(pieces)} pieces of {1e3 * max(pieces):.0f} ms at most, {sum(pieces):.2f} s together")


def test_labels(view, capsys, monkeypatch):
    rng = np.random.default_rng(2)
    sets, legends = [on_screen.Labels(), on_screen.Labels()], [on_screen.LegendBox(), on_screen.LegendBox()]
    for at, one in enumerate(sets):
        places = rng.uniform(-3.0, 3.0, (4, 3))
        one.show(
            [
                on_screen.Label(place, f"{0.1278 * i:.4f} mm, NC line {1000 * at + i}")
                for i, place in enumerate(places)
            ]
        )
    for title, one in zip(("First", "Second"), legends, strict=True):
        one.show(words.legend_of(title, dome(), LOOK, ""))
    ball, spent, place = nodes.coin.SoSphere(), [], on_screen._Overlay.place
    ball.radius = 20.0

    def timed(overlay, action):
        began = time.thread_time()
        place(overlay, action)
        spent.append(time.thread_time() - began)

    monkeypatch.setattr(on_screen._Overlay, "place", timed)
    found = row(
        view,
        "8 labels, 2 legends",
        (ball, *(one.root for one in (sets[0], legends[0], sets[1], legends[1]))),
        (ball,),
    )
    with capsys.disabled():
        print_table("Labels and legends over a ball, to the ball alone", HEADS, [found])
        share = 4e3 * statistics.median(spent)
        print(
            f"of that, finding their places: {share:.2f} ms a frame, {share / float(found[2]):.2f} of a "
            "frame of the ball"
        )
