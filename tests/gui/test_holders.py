# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that hold solids, fixtures and paths: the picture stands where the program cuts, and whatever shows
the result of another place says so, or computes it anew.

There is one path for a test or two: what they are about hangs on none of its settings.
"""

import FreeCAD
import FreeCADGui
import pytest
from pivy import coin

from freecad_fiveaxis import app
from freecad_fiveaxis.app import results
from freecad_fiveaxis.gui import findings_panel
from freecad_fiveaxis.gui.panels import post, toolpath

pytestmark = pytest.mark.usefixtures("kept")
OPTIONS = {"machine": "trunnion_ac", "cutter": "ball:6:30", "stepover": 8.0, "linear_deflection": 0.3,
           "angular_deflection": 30.0, "gouge": "off", "linearize": "off"}  # fmt: skip


@pytest.fixture
def path(doc, dome, until):
    """A coarse path over the dome, drawn."""
    drawn_path = app.create_toolpath(doc, dome, **OPTIONS)
    until(lambda: picture(drawn_path) and picture(drawn_path).styled, 20000, "the path drawn")
    return drawn_path


@pytest.fixture
def holder(doc):
    """A part that stands aside and is turned."""
    part = doc.addObject("App::Part", "Holder")
    part.Placement = FreeCAD.Placement(
        FreeCAD.Vector(200, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 30)
    )
    return part


def picture(path):
    """What is drawn of a path."""
    return path.ViewObject.Proxy.picture


def warning(path):
    """What the legend says of a path that is out of date."""
    return picture(path).checked


def drawn(obj):
    """The corners (x, y, z, mm) of the box in which the view draws an object."""
    search = coin.SoSearchAction()
    search.setNode(obj.ViewObject.RootNode)
    search.setSearchingAll(True)
    search.apply(FreeCADGui.getDocument(obj.Document.Name).ActiveView.getSceneGraph())
    box = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(800, 600))
    box.apply(search.getPath())
    bounds = box.getBoundingBox()  # kept: its corners are no more once it goes
    return [*bounds.getMin().getValue(), *bounds.getMax().getValue()]


def test_a_path_that_is_put_into_a_part_is_drawn_where_it_cuts(path, holder, pump, until):
    before = pytest.approx(drawn(path), abs=0.01)
    holder.addObject(path)
    until(lambda: drawn(path) == before, 10000, "drawn where it was")
    markers = app.annotate(path)
    pump(300)
    place = drawn(markers)
    holder.addObject(markers)
    until(lambda: drawn(markers) == pytest.approx(place, abs=0.01), 10000, "markers where they were")
    before = pytest.approx(drawn(path), abs=0.01)  # without its own markers
    holder.Placement.Base = FreeCAD.Vector(0, 300, 0)
    until(lambda: drawn(path) == before, 10000, "the part moved, the path where it was")
    holder.removeObject(path)
    until(lambda: drawn(path) == before, 10000, "out of the part again")


def test_the_legend_says_so_where_a_part_moves_the_solid_or_a_fixture(path, dome, holder, doc, until):
    vise = doc.addObject("Part::Box", "Vise")
    vise.Placement.Base = FreeCAD.Vector(40, 0, 0)
    path.Fixtures = [vise]
    doc.recompute()
    until(lambda: warning(path) == "", 10000, "up to date")
    listed = findings_panel.show(path)
    assert listed.old.text() == ""
    vise.Placement.Base = FreeCAD.Vector(45, 0, 0)
    until(lambda: "Vise was changed" in (warning(path) or ""), 10000, "the fixture moved")
    assert listed.old.text() == warning(path) and listed.old.isVisible()
    holder.Placement = FreeCAD.Placement()
    holder.addObject(vise)
    doc.recompute()
    until(lambda: warning(path) == "", 10000, "up to date again")
    holder.Placement.Base = FreeCAD.Vector(5, 0, 0)
    until(lambda: warning(path), 10000, "the fixture moved by its part")
    doc.recompute()
    until(lambda: warning(path) == "", 10000, "a recompute has helped")
    holder.addObject(dome)
    until(lambda: "Dome was moved" in (warning(path) or ""), 10000, "the solid moved by its part")
    doc.recompute()
    until(lambda: warning(path) == "", 10000, "a recompute has helped here too")
    assert listed.old.text() == ""
    findings_panel.forget(doc)


def test_a_panel_forgets_the_result_of_a_solid_that_was_changed(
    path, dome, until, modal, panel_button, panel_closed
):
    fingerprint = path.Fingerprint
    panel = toolpath.edit(path)
    assert not panel.stale
    dome.Radius = 18
    until(lambda: panel.stale, 10000, "the summary forgotten")
    modal("Keep anyway")
    panel_button("OK")
    panel_closed()
    assert path.Fingerprint != fingerprint and results.out_of_date(path) == ""
    assert path.Mesh.Mesh.BoundBox.ZMax == pytest.approx(18, abs=0.01)
    dome.Radius = 17
    assert toolpath.edit(path).stale
    FreeCADGui.Control.closeDialog()


def test_the_post_panel_says_that_the_part_was_moved_and_writes_where_it_stands(
    path, dome, tmp_path, field, modal, panel_button, panel_closed, type_into
):
    dome.Placement.Base = FreeCAD.Vector(10, 0, 0)
    panel = post.write(path)
    assert panel.error.text() == "Dome was changed: recompute the document"
    panel.file.show_value(str(tmp_path / "moved.ngc"))
    modal("Write anyway")
    panel_button("OK")
    panel_closed()
    written = (tmp_path / "moved.ngc").read_bytes()
    assert results.out_of_date(path) == "" and written == results.nc_of(path)
    assert path.Mesh.Mesh.BoundBox.XMax == pytest.approx(30, abs=0.3)


def test_a_part_moved_by_what_holds_it_is_drawn_where_it_was_written(
    path, dome, holder, doc, tmp_path, until, modal, panel_button, panel_closed
):
    holder.addObject(dome)
    doc.recompute()
    holder.Placement.Base = FreeCAD.Vector(10, 0, 0)
    panel = post.write(path)
    assert "Dome was moved" in panel.error.text()
    panel.file.show_value(str(tmp_path / "moved.ngc"))
    modal("Write anyway")
    panel_button("OK")
    panel_closed()
    assert results.out_of_date(path) == "" and path.Mesh.Mesh.BoundBox.XMax == pytest.approx(30, abs=0.3)
    until(lambda: warning(path) == "", 10000, "the legend says nothing")
