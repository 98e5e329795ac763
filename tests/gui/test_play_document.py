# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids and meshes of the document in the player: drawn from coarser copies while it moves, and as FreeCAD
draws them at rest, when they change and when the player is closed."""

import numpy as np
import pytest
from test_play import opened, table_2

from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl

__all__ = ["opened"]
pytestmark = pytest.mark.usefixtures("kept")
MOST, SIDE, HEIGHT = 2000, 100, 4.0
GREY = (204, 204, 204)


def field(height=HEIGHT, side=SIDE):
    """A wavy surface of 60 x 60 mm and 2 side^2 facets."""
    line = np.linspace(-30.0, 30.0, side + 1)
    x, y = np.meshgrid(line, line, indexing="ij")
    vertex = np.stack([x, y, height * np.sin(x / 6.0) * np.cos(y / 9.0)], axis=-1).reshape(-1, 3)
    corner = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).ravel()
    face = np.concatenate([corner[:, None] + [0, side + 1, side + 2], corner[:, None] + [0, side + 2, 1]])
    return vertex[face]


def kernel(folder, facets):
    import Mesh

    write_stl(from_triangles(facets), folder / "field.stl")
    return Mesh.Mesh(str(folder / "field.stl"))


@pytest.fixture
def part(doc, tmp_path):
    obj = doc.addObject("Mesh::Feature", "Part")
    obj.Mesh = kernel(tmp_path, field())
    return obj


@pytest.fixture
def clamp(doc):
    """A solid of several thousand facets, moved by its own placement and by that of the part it stands in."""
    import FreeCAD
    import Part

    holder, obj = doc.addObject("App::Part", "Holder"), doc.addObject("Part::Feature", "Clamp")
    obj.ViewObject.AngularDeflection = 5.0
    obj.Shape = Part.makeSphere(12)
    obj.Placement.Base = FreeCAD.Vector(0, 50, 0)
    holder.Placement.Base = FreeCAD.Vector(40, 0, 0)
    holder.addObject(obj)
    doc.recompute()
    return obj


@pytest.fixture
def few(monkeypatch):
    """So few facets are drawn while it moves."""
    from freecad_fiveaxis.gui.play import document_copies

    monkeypatch.setattr(document_copies, "BUDGET", MOST)
    return document_copies


def drawn(obj):
    """The corners (n, 3) of the facets of an object that are drawn, in the document."""
    import FreeCADGui
    from pivy import coin

    act, found, root = coin.SoCallbackAction(), [], obj.ViewObject.RootNode
    search = coin.SoSearchAction()
    search.setNode(root)
    search.apply(FreeCADGui.getDocument(obj.Document.Name).ActiveView.getSceneGraph())

    def corners(_, action, *three):
        place = np.array(action.getModelMatrix().getValue()).reshape(4, 4)
        found.extend(np.array([*one.getPoint().getValue(), 1.0]) @ place for one in three)

    act.addTriangleCallback(coin.SoShape.getClassTypeId(), corners, None)
    act.apply(search.getPath())
    return np.array(found).reshape(-1, 4)[:, :3]


def shape_of(shown, count):
    """The shape of so many facets at rest."""
    return next(one for one in shown.stage.document.shapes if one.count == count)


def ready(shown, until):
    until(lambda: not shown.stage.document.busy, 60000, "the copies")


def drag(shown, on):
    shown.controls.slider.setSliderDown(on)
    shown.refresh()


def check_near(points, others, most):
    """No point is farther from the nearest of others than ``most``."""
    from scipy.spatial import cKDTree

    off = cKDTree(others).query(points)[0].max()
    assert off <= most, f"{off:.3g} mm off"


@pytest.mark.usefixtures("whole_screen", "few")
def test_part_and_fixture_are_copies_while_it_moves_and_whole_at_rest(
    doc, tmp_path, part, clamp, opened, click, until, screenshot, pixels
):
    shown = opened(table_2(doc, tmp_path))
    whole = {one.Name: drawn(one) for one in (part, clamp)}
    assert len(whole["Part"]) == 3 * 2 * SIDE**2 and len(whole["Clamp"]) > 3000
    ready(shown, until)
    assert len(shown.stage.document.shapes) == 2
    grey = pixels(screenshot("play_document_standing"), GREY, 60)
    click(shown.controls.play)
    until(lambda: shown.playing, 20000, "the motion")
    for one in (part, clamp):
        shape, moved = shape_of(shown, len(whole[one.Name]) // 3), drawn(one)
        assert shape.reduced and len(moved) == 3 * len(shape.copy.mesh.face)
        assert len(moved) < 0.5 * len(whole[one.Name])
        step = 60.0 / SIDE if one is part else 2.0  # mm: how far the corners of what is drawn whole are apart
        check_near(moved, whole[one.Name], shape.copy.deviation + step)
        with pytest.raises(AssertionError, match="mm off"):  # it would see another place
            check_near(moved + (0.0, 0.0, 30.0), whole[one.Name], shape.copy.deviation + step)
    assert sum(len(one.copy.mesh.face) for one in shown.stage.document.shapes) <= MOST
    until(lambda: pixels(screenshot("play_document_moving"), GREY, 60) > 0.9 * grey, 30000, "the same colour")
    click(shown.controls.play)
    until(lambda: not shown.playing, 20000, "a pause")
    for one in (part, clamp):
        assert np.array_equal(drawn(one), whole[one.Name])
    drag(shown, on=True)
    assert all(one.reduced for one in shown.stage.document.shapes)
    shown.reject()
    for one in (part, clamp):
        assert np.array_equal(drawn(one), whole[one.Name]), "closed while it moved"


@pytest.mark.usefixtures("few")
def test_what_changes_or_is_hidden_while_it_moves_is_never_drawn_from_an_old_copy(
    doc, tmp_path, part, opened, until
):
    shown = opened(table_2(doc, tmp_path))
    ready(shown, until)
    drag(shown, on=True)
    (shape,) = shown.stage.document.shapes
    assert shape.reduced
    part.ViewObject.Visibility = False
    shown.refresh()
    assert not len(drawn(part))
    part.ViewObject.Visibility = True
    shown.refresh()
    assert len(drawn(part)) == 3 * len(shape.copy.mesh.face)
    part.Mesh = kernel(tmp_path, field(2.0 * HEIGHT))
    doc.recompute()
    shown.refresh()
    assert not shape.reduced and len(drawn(part)) == 3 * 2 * SIDE**2
    assert drawn(part)[:, 2].max() > 1.9 * HEIGHT
    drag(shown, on=False)
    drag(shown, on=True)
    ready(shown, until)
    shown.refresh()
    (shape,) = shown.stage.document.shapes
    assert shape.reduced and drawn(part)[:, 2].max() > 1.8 * HEIGHT
    doc.removeObject("Part")
    shown.refresh()
    drag(shown, on=False)


def test_faces_of_several_colours_and_small_shapes_have_no_copy(doc, tmp_path, clamp, few, opened, until):
    import Part

    clamp.Shape = Part.makeCompound([Part.makeSphere(12), Part.makeBox(5, 5, 40)])
    clamp.ViewObject.DiffuseColor = [(1.0, 0.0, 0.0), *[(0.0, 1.0, 0.0)] * 6]
    doc.recompute()
    few.BUDGET = 100
    shown = opened(table_2(doc, tmp_path))
    assert len(drawn(clamp)) > 3000 and not shown.stage.document.shapes
    clamp.ViewObject.DiffuseColor = [(1.0, 0.0, 0.0)]
    drag(shown, on=True)
    ready(shown, until)
    assert len(shown.stage.document.shapes) == 1


def test_the_window_goes_on_while_a_copy_is_computed(doc, tmp_path, part, few, opened, monkeypatch, until):
    """Piece by piece, each an event of its own."""
    from freecad_fiveaxis.gui.play.document_copies import DocumentCopies

    pieces, go_on = [], DocumentCopies._go_on
    monkeypatch.setattr(DocumentCopies, "_go_on", lambda copies: (pieces.append(1), go_on(copies)))
    monkeypatch.setattr(few, "POINTS", 1000)
    shown = opened(table_2(doc, tmp_path))
    drag(shown, on=True)
    ready(shown, until)
    shown.refresh()
    assert len(pieces) >= 10 and shown.stage.document.shapes[0].reduced


def test_while_time_passes_the_figures_are_written_now_and_then_and_at_a_pause_at_once(
    doc, tmp_path, opened, click, until, pump, monkeypatch
):
    from freecad_fiveaxis.gui.play import panel

    monkeypatch.setattr(panel, "READ", 1e9)
    shown = opened(table_2(doc, tmp_path))
    written, show = [], shown.readout.show
    monkeypatch.setattr(shown.readout, "show", lambda *what: (written.append(what[0]), show(*what)))
    click(shown.controls.play)
    until(lambda: shown.playing and shown.player.share() > 0.1, 20000, "the motion")
    assert not written
    click(shown.controls.play)
    until(lambda: not shown.playing, 20000, "a pause")
    assert len(written) == 1 and np.allclose(written[0].words, shown.player.pose.words)
    monkeypatch.setattr(panel, "READ", 0.0)
    click(shown.controls.play)
    until(lambda: len(written) > 3, 20000, "the figures")


def test_while_the_slider_is_dragged_figures_are_written_now_and_then_and_where_it_rests(
    doc, tmp_path, opened, until, monkeypatch
):
    from freecad_fiveaxis.gui.play import panel

    monkeypatch.setattr(panel, "READ", 0.3)
    shown = opened(table_2(doc, tmp_path))
    written, show = [], shown.readout.show
    monkeypatch.setattr(shown.readout, "show", lambda *what: (written.append(what[0]), show(*what)))
    slider = shown.controls.slider
    slider.setSliderDown(True)
    for value in range(100, 400, 10):
        slider.setValue(value)
    assert len(written) < 10
    until(
        lambda: written and np.allclose(written[-1].words, shown.player.pose.words),
        20000,
        "the figures at rest",
    )
    assert slider.isSliderDown()
    slider.setValue(700)
    slider.setSliderDown(False)
    assert np.allclose(written[-1].words, shown.player.pose.words)
