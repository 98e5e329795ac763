# SPDX-License-Identifier: LGPL-2.1-or-later
"""Large solids are meshed by a process of their own: the same mesh, while the window is handled, and it can
be stopped."""

import math
import os
import time

import FreeCAD
import Part
import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app import long_work, meshing
from freecad_fiveaxis.app.selection import SelectionError
from freecad_fiveaxis.core.base.errors import Cancelled

pytestmark = pytest.mark.skipif(not meshing.command(), reason="there is no FreeCAD without a window")


class Dialog:
    """Hears like the window's dialog; stops the work at its ``stop_after``-th turn. ``turns``: how many it
    had."""

    def __init__(self, stop_after=10**9):
        self.turns, self.stop_after = 0, stop_after

    def __call__(self, stage, fraction):
        self.pump()

    def pump(self):
        self.turns += 1
        if self.turns >= self.stop_after:
            raise Cancelled("stopped")


def rounded(corner):
    box = Part.makeBox(8, 8, 8, FreeCAD.Vector(*corner))
    return box.makeFillet(1, box.Edges)


def spline():
    """A block under a wave."""
    points = [
        [FreeCAD.Vector(5 * i, 5 * j, 10 + 3 * math.sin(i) * math.cos(j)) for j in range(6)] for i in range(6)
    ]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    return surface.toShape().extrude(FreeCAD.Vector(0, 0, -20))


def pipe():
    return Part.makeTorus(20, 5).cut(Part.makeBox(40, 40, 40))


def inside_out():
    return Part.makeSphere(7).cut(Part.makeBox(9, 9, 9)).reversed()


def scattered():
    return Part.makeCompound(
        [rounded((0, 0, 0)), rounded((20, 0.1, 1 / 3)), Part.makeCone(5, 1, 9, FreeCAD.Vector(-20, 0, 0))]
    )


@pytest.mark.parametrize("make", [lambda: rounded((1 / 3, 0, 0)), spline, pipe, inside_out, scattered])
def test_the_mesh_of_the_process_is_the_same_to_the_last_bit(make, monkeypatch):
    shape = make()
    here, counts = meshing.mesh_shape(shape, 0.02, 0.2, lambda *reported: None)
    monkeypatch.setattr(meshing, "QUICK", 0)
    monkeypatch.setattr(meshing.mesher, "solid_mesh", None)  # nothing is meshed here
    beside, again = meshing.mesh_shape(shape, 0.02, 0.2, Dialog())
    assert again == counts and sum(counts) == here.CountFacets > 50
    (points, facets), (others, same) = here.Topology, beside.Topology
    assert facets == same and [tuple(point) for point in points] == [tuple(point) for point in others]
    assert beside.isSolid() and beside.Volume == pytest.approx(abs(shape.Volume), rel=0.02)


def test_a_small_solid_is_meshed_here(monkeypatch):
    monkeypatch.setattr(meshing, "_beside", None)
    assert meshing.mesh_shape(Part.makeSphere(20), 0.05, 0.2, Dialog())[0].CountFacets > 500


def test_what_is_expected_is_about_what_is_built():
    for shape in (Part.makeSphere(20), Part.makeCylinder(5, 5), rounded((0, 0, 0)), Part.makeTorus(20, 5)):
        result = meshing.mesh_shape(shape, 0.02, 0.2, lambda *reported: None)[0].CountFacets
        assert 0.5 * result < meshing.estimate_facets(shape, 0.02, 0.2) < 20 * result


def test_an_invalid_solid_is_refused_by_the_process_too(doc, monkeypatch):
    def refused(reported):
        with pytest.raises(SelectionError, match="invalid"), long_work.reporting(reported):
            app.tessellate(obj)

    sheet = Part.makePolygon(
        [FreeCAD.Vector(*at) for at in ((0, 0, 0), (9, 9, 0), (9, 0, 0), (0, 9, 0), (0, 0, 0))]
    )
    obj = doc.addObject("Part::Feature", "Twisted")
    obj.Shape = Part.Face(sheet).extrude(FreeCAD.Vector(0, 0, 5))
    assert not obj.Shape.isValid()
    from freecad_fiveaxis.app import selection

    monkeypatch.setattr(selection, "CHECKED", 0)
    refused(lambda *reported: None)
    monkeypatch.setattr(meshing, "QUICK", 0)
    refused(Dialog())
    assert [one.Name for one in doc.Objects] == ["Twisted"]


def test_where_the_process_fails_the_solid_is_meshed_here(monkeypatch):
    monkeypatch.setattr(meshing, "QUICK", 0)
    monkeypatch.setattr(meshing, "command", lambda: "/bin/false")
    assert meshing.mesh_shape(Part.makeSphere(5), 0.1, 0.2, Dialog())[0].isSolid()


def test_esc_ends_the_process_and_leaves_nothing(doc, monkeypatch, tmp_path):
    started = []
    begin = meshing.subprocess.Popen
    monkeypatch.setattr(
        meshing.subprocess, "Popen", lambda *a, **k: started.append(begin(*a, **k)) or started[-1]
    )
    monkeypatch.setattr(meshing.tempfile, "tempdir", str(tmp_path))
    ball, dialog = doc.addObject("Part::Sphere", "Ball"), Dialog(stop_after=20)
    ball.Radius = 300
    doc.recompute()
    with pytest.raises(Cancelled), long_work.reporting(dialog):
        app.tessellate(ball, linear_deflection=0.001, angular_deflection=1)
    assert dialog.turns == 20, (
        "the window had its turns while the other process worked, and none after the stop"
    )
    assert [one.Name for one in doc.Objects] == ["Ball"]
    end = time.monotonic() + 60
    while time.monotonic() < end and (started[0].returncode is None or os.listdir(tmp_path)):
        time.sleep(0.05)
    assert started[0].returncode not in (None, 0) and os.listdir(tmp_path) == []
