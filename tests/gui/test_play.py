# SPDX-License-Identifier: LGPL-2.1-or-later
"""The player in a real window: buttons clicked, the picture counted in pixels, the view and the document left
as they were."""

import numpy as np
import pytest

pytestmark = pytest.mark.usefixtures("kept", "every_frame")
TABLE_2 = "G21 G90 G94\nG1 X-90.9595 Y7.3103 Z227.6341 A1.0664 C148.9685 F1000\nG1 X-82.0656 Y-34.8175 Z228.3975 A1.1793 C121.5477\nM2\n"
CAMERA = ("position", "orientation", "height")  # FreeCAD fits the clipping planes to whatever is drawn
WORST, WORST_U = 2.12642, 0.54543
BRASS, CURVE = (217, 174, 46), (230, 76, 0)  # the cutter as it is lit, the real curve; red green blue to 255


def dome(doc):
    """The top of a ball on a plate: its middle passes cross the pole of a trunnion table."""
    import FreeCAD
    import Part

    solid = Part.makeSphere(20).common(Part.makeBox(24, 24, 12, FreeCAD.Vector(-12, -12, 10)))
    part = doc.addObject("Part::Feature", "Dome")
    part.Shape = solid
    return part


def toolpath(doc, **more):
    from freecad_fiveaxis import app

    given = {
        "machine": "trunnion_ac",
        "cutter": "ball:6:30",
        "stepover": 3.0,
        "linear_deflection": 0.1,
    } | more
    result = app.create_toolpath(doc, dome(doc), **{"passes": "planes", "tool_axis": "facet_mean", **given})
    doc.recompute()
    return result


def table_2(doc, folder):
    from freecad_fiveaxis import app

    path = folder / "table2.ngc"
    path.write_text(TABLE_2)
    return app.audit(doc, str(path), "mikron_ucp710")


def view_of(doc):
    import FreeCADGui

    return FreeCADGui.getDocument(doc.Name).ActiveView


@pytest.fixture
def opened(doc, pump, panel_closed):
    """opened(obj): the player of an object, its panel shown; closed afterwards."""
    from freecad_fiveaxis.gui import play
    from freecad_fiveaxis.gui.play import panel

    def show(obj):
        view = view_of(doc)
        view.viewIsometric()
        view.fitAll()
        play.show(obj)
        pump(400)
        return panel.current()

    yield show
    if panel.current() is not None:
        panel.current().reject()
    panel_closed()


@pytest.fixture
def tick(click):
    """tick(box): click the square of a check box, as a hand does."""
    from freecad_fiveaxis.gui.qt import QtCore

    def press(box):
        click(box, QtCore.QPoint(9, box.height() // 2))

    return press


def children(doc):
    graph = view_of(doc).getSceneGraph()
    return [graph.getChild(i).getName().getString() for i in range(graph.getNumChildren())]


def matrix(node):
    return np.array(node.matrix.getValue().getValue()).reshape(4, 4).T


def state(doc):
    """What of a document could have been changed: properties, visibility, placements, undo steps."""
    objects = {
        obj.Name: (
            sorted(obj.PropertiesList),
            obj.State,
            obj.ViewObject.Visibility,
            str(getattr(obj, "Placement", "")),
        )
        for obj in doc.Objects
    }
    lines = (line.split() for line in view_of(doc).getCamera().splitlines())
    camera = {
        line[0]: [round(float(word), 4) for word in line[1:]] for line in lines if line and line[0] in CAMERA
    }
    return objects, doc.UndoCount, camera


@pytest.mark.usefixtures("whole_screen")
def test_a_click_on_the_tool_bar_opens_it_and_close_leaves_the_view_as_it_was(
    doc, press, select, opened, panel_button, screenshot, pixels, until, panel_closed
):
    import FreeCADGui

    from freecad_fiveaxis.gui.play import panel

    path = toolpath(doc)
    view_of(doc).viewIsometric()
    view_of(doc).fitAll()
    before, nodes = state(doc), children(doc)
    select(path)
    press("FiveAxis_Play", wait=1500)
    until(lambda: panel.current() is not None and FreeCADGui.Control.activeDialog(), 20000, "the player")
    assert children(doc)[0] == "FiveAxisPlay" and len(children(doc)) == len(nodes) + 2
    until(lambda: pixels(screenshot("play_open"), BRASS, 30) > 1000, 30000, "the tool")
    with_tool = pixels(screenshot("play_open"), BRASS, 30)
    panel_button("Close")
    panel_closed()
    assert panel.current() is None and children(doc) == nodes
    until(lambda: state(doc) == before, 20000, "the document as it was")
    until(lambda: with_tool > pixels(screenshot("play_closed"), BRASS, 30) + 1000, 30000, "no tool")


@pytest.mark.usefixtures("whole_screen")  # in a small window FreeCAD 1.1 lays the panel over the tip
def test_table_2_leaves_its_chord_in_the_picture_and_overshoots(
    doc, tmp_path, opened, click, tick, screenshot, pixels, until
):
    shown = opened(table_2(doc, tmp_path))
    click(shown.controls.worst)
    until(lambda: shown.player.block == 1, 20000, "the worst block")
    assert shown.player.u == pytest.approx(WORST_U, abs=1e-4)
    assert shown.readout.gap.text() == "2.126 mm" and shown.readout.most.text().startswith("2.126 mm")
    assert shown.readout.rows.labelForField(shown.readout.gap).text() == "Tip off its segment"
    assert shown.readout.line.text() == "3" and shown.readout.text.text().startswith("G1 X-82.0656")
    tool, curve = (
        matrix(shown.stage.tool),
        np.array([v.getValue() for v in shown.stage.curve.vertex.getValues()]),
    )
    chord = curve[-1] - curve[0]
    distance = np.linalg.norm(np.cross(tool[:3, 3] - curve[0], chord)) / np.linalg.norm(chord)
    assert 0.7 < distance < 0.94  # from the line; from the segment it is more, for the tip is beyond its end
    assert ((curve - curve[0]) @ chord / (chord @ chord)).max() == pytest.approx(2.74, abs=0.02)
    tick(shown.controls.follow)
    camera = view_of(doc).getCameraNode()
    camera.height.setValue(12.0)
    shown.refresh()
    until(lambda: pixels(screenshot("play_table_2"), CURVE, 12) > 100, 30000, "the real curve, in orange")
    assert np.allclose(
        view_of(doc).getPointOnScreen(*map(float, shown.stage.tip)),
        np.array(view_of(doc).getSize()) / 2,
        atol=2,
    )


def test_of_a_ball_the_centre_is_played_and_named(doc, opened, click, screenshot, until):
    from freecad_fiveaxis.app import results

    path = toolpath(doc, linearize="off", stepover=8.0)
    shown, figures = opened(path), results.figures_of(path)
    click(shown.controls.worst)
    until(lambda: shown.player.block == figures.worst[0], 20000, "the worst block")
    readout, pose = shown.readout, shown.player.pose
    assert readout.rows.labelForField(readout.gap).text() == "Centre off its segment"
    assert "ball's centre" in readout.note.text() and readout.gap.text() == readout.most.text()
    assert float(pose.to_chord) == pytest.approx(figures.surface.segment[figures.worst[0]], abs=1e-6)
    drawn = np.array([v.getValue() for v in shown.stage.dots.vertex.getValues()])
    assert np.allclose(drawn, pose.tip + 3.0 * pose.axis, atol=1e-4)
    screenshot("play_centre")


def test_on_the_machine_the_table_turns_the_document_and_the_tool_stands_upright(
    doc, opened, tick, screenshot, until
):
    path = toolpath(doc, work_zero=(3.0, 4.0, 5.0))
    shown = opened(path)
    shown.step(lambda: shown.player.go_to_share(0.4))
    screenshot("play_over_the_part")
    from freecad_fiveaxis.gui.scene import layout

    lean = matrix(shown.stage.tool)[:3, 2]
    assert np.allclose(matrix(shown.stage.turn), np.eye(4)) and lean[2] < 0.99
    tick(shown.controls.machine)
    until(
        lambda: np.allclose(matrix(shown.stage.tool)[:3, 2], (0, 0, 1), atol=1e-6), 20000, "the tool upright"
    )
    view_of(doc).fitAll()
    until(lambda: path.ViewObject.Proxy.picture is not None, 20000, "the path is drawn")
    screenshot("play_on_the_machine")
    assert "riser" in {body.name for body in shown.stage.machine.bodies}, "the part floats over its table"
    part = layout.middle_of(part_on_screen(shown, doc))
    boxes = np.concatenate(
        [labels.boxes for labels in (shown.stage.letters, path.ViewObject.Proxy.picture.nodes.labels)]
    )
    boxes = boxes[np.isfinite(boxes).all(axis=1)]
    assert len(boxes) >= 2 and not layout.overlap(boxes, part).any(), "a label lies over the part"
    pose, zero = shown.player.pose, np.array((3.0, 4.0, 5.0))
    assert np.allclose(matrix(shown.stage.tool)[:3, 3], pose.words[:3], atol=1e-3)
    turned = matrix(shown.stage.turn)
    assert np.allclose(turned[:3, :3] @ lean, (0, 0, 1), atol=1e-6)
    assert np.allclose(turned[:3, :3] @ (pose.tip + zero) + turned[:3, 3], pose.words[:3] + zero, atol=1e-3)
    assert doc.Dome.Placement.isIdentity()


def part_on_screen(shown, doc):
    """The pixels of the corners of the path's box, as the table has turned it."""
    figures, pose = shown.player.figures, shown.player.pose
    tip = figures.tip[figures.feeds]
    ends = np.stack([tip.min(axis=0), tip.max(axis=0)])
    points = np.array([[ends[i, 0], ends[j, 1], ends[k, 2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    placed = points @ pose.machine_from_work[:3, :3].T + pose.machine_from_work[:3, 3] + shown.stage.zero
    return np.array([view_of(doc).getPointOnScreen(*map(float, point)) for point in placed], float)


def corners_on_screen(shown, doc):
    """Where the corners of all bodies of the machine are drawn, as shares of the view (0 to 1)."""
    from freecad_fiveaxis.core.report.machine_sketch import corners

    pose, zero = shown.player.pose, shown.stage.zero
    placed = []
    for body in shown.stage.machine.bodies:
        placement = np.eye(4) if body.carrier is None else pose.machine_from_carried[body.carrier]
        placed.append(corners(body.shape) @ placement[:3, :3].T + placement[:3, 3] + zero)
    seen = [view_of(doc).getPointOnScreen(*map(float, point)) for point in np.concatenate(placed)]
    return np.array(seen) / view_of(doc).getSize()


def test_on_the_machine_its_bodies_stand_where_the_axes_carry_them_and_are_all_in_view(
    doc, opened, tick, screenshot, until
):
    from pivy import coin

    shown = opened(toolpath(doc, machine="mikron_ucp710", work_zero=(3.0, 4.0, 5.0), stepover=8.0))
    before, stage = state(doc), shown.stage
    assert stage.sketch.whichChild.getValue() == coin.SO_SWITCH_NONE
    tick(shown.controls.machine)
    until(lambda: stage.sketch.whichChild.getValue() == coin.SO_SWITCH_ALL, 20000, "the machine")
    assert set(stage.machine.carriers) == {None, 2, 3, 4}  # the bed, Z with the spindle, platter, cradle
    for share in (0.0, 0.4, 1.0):
        shown.step(lambda share=share: shown.player.go_to_share(share))
        pose = shown.player.pose
        assert np.allclose(matrix(stage.machine.carriers[3]), pose.machine_from_work, atol=1e-3)
        assert np.allclose(matrix(stage.machine.carriers[2]), pose.machine_from_tool, atol=1e-3)
        for axis in (2, 3, 4):
            assert np.allclose(
                matrix(stage.machine.carriers[axis]), pose.machine_from_carried[axis], atol=1e-3
            )
        assert np.allclose(matrix(stage.machine.carriers[None]), np.eye(4))
        seen = corners_on_screen(shown, doc)
        assert seen.min() > 0.0 and seen.max() < 1.0
    assert np.ptp(seen, axis=0).max() > 0.4, "the machine is small in the view"
    screenshot("play_machine")
    tick(shown.controls.machine)
    until(lambda: state(doc) == before, 20000, "the document as it was")


def test_blocks_are_stepped_and_the_slider_and_the_time_follow(doc, opened, click, until):
    shown = opened(toolpath(doc))
    for block in (1, 2, 3):  # a hand looks, too, before it clicks again
        click(shown.controls.forward)
        until(lambda: (shown.player.block, shown.player.u) == (block, 1.0), 20000, f"block {block}")  # noqa: B023
    until(lambda: shown.readout.block.text().startswith("3 of "), 20000, "its number")
    click(shown.controls.back)
    until(lambda: shown.player.block == 2, 20000, "the second block")
    end = shown.player.playback.program.words[2]
    joints = [*(f"{word:.4f} mm" for word in end[:3]), *(f"{word:.4f}°" for word in end[3:])]
    until(lambda: [label.text() for label in shown.readout.joints.values()] == joints, 20000, f"{joints}")
    shown.controls.slider.setValue(5000)
    assert shown.player.time == pytest.approx(shown.player.playback.seconds / 2)
    click(shown.controls.begin)
    until(lambda: shown.player.block == 0 and shown.controls.slider.value() == 0, 20000, "the beginning")


def test_next_singular_goes_through_all_of_them(doc, opened, click, until):
    from freecad_fiveaxis.app import results

    path = toolpath(doc, linearize="off", stepover=8.0)
    shown = opened(path)
    figures = results.figures_of(path)
    rows = [row for row in np.flatnonzero(figures.singularity.singular) if row in set(figures.feeds)]
    assert len(rows) > 1
    for row in [*rows, rows[0]]:
        click(shown.controls.singular)
        until(lambda: shown.player.block == row, 20000, f"block {row}")  # noqa: B023
    until(lambda: "Near the pole" in shown.readout.note.text(), 20000, "what stands there")
    click(shown.controls.worst)
    until(lambda: shown.player.block == figures.worst[0], 20000, "the worst block")


def test_next_singular_passes_over_what_comes_from_a_position_of_the_machine(
    doc, opened, click, until, tmp_path
):
    """C turns by 90 deg with the tool upright: in two feeds, and from wherever the machine was, between."""
    from freecad_fiveaxis import app

    (tmp_path / "a.ngc").write_text(
        "G90 G94 G21\nG0 X0 Y0 Z10 A0 C0\nG1 Z1 F500\nG1 X5 C90\nG0 Z10\nG53 G0 Z0\n"
        "G0 X9 Y0 C0\nG0 Z10\nG1 Z1\nG1 X5 C90\nM2\n"
    )
    shown = opened(app.audit(doc, str(tmp_path / "a.ngc"), "trunnion_ac"))
    assert shown.player.figures.program.unknown_way.tolist() == [row == 4 for row in range(7)]
    for row in (2, 6, 2):
        click(shown.controls.singular)
        until(lambda: shown.player.block == row, 20000, f"block {row}")  # noqa: B023
    until(lambda: "Near the pole" in shown.readout.note.text(), 20000, "what stands there")
    for row in (2, 3, 4):  # to the end of that block, and on
        click(shown.controls.forward)
        until(lambda: (shown.player.block, shown.player.u) == (row, 1.0), 20000, f"block {row}")  # noqa: B023
    until(lambda: "a position of the machine" in shown.readout.note.text(), 20000, "whence it comes")
    assert "Near the pole" not in shown.readout.note.text()


class Clock:
    """A clock for the player in place of ``time``: 50 ms pass between two looks at it."""

    def __init__(self):
        self.now = 100.0

    def monotonic(self):
        self.now += 0.05
        return self.now


def test_playing_keeps_time_at_the_chosen_speed_and_stops_at_the_end(doc, opened, click, until, monkeypatch):
    from freecad_fiveaxis.gui.play import panel

    clock = Clock()
    shown = opened(toolpath(doc))
    monkeypatch.setattr(panel, "time", clock)
    for speed in (1.0, 10.0):
        shown.controls.speed.setCurrentIndex(shown.controls.speed.findText(f"× {speed:g}"))
        click(shown.controls.play)
        until(lambda: shown.playing, 20000, "that it plays")
        start, began = shown.player.time, clock.now
        until(lambda began=began: clock.now - began > 0.5, 60000, "ten ticks")
        assert shown.player.time - start == pytest.approx(speed * (clock.now - began), abs=1e-6)
        click(shown.controls.play)
        until(lambda: not shown.playing, 20000, "that it pauses")
    shown.player.go_to_time(shown.player.playback.seconds - 0.5)
    click(shown.controls.play)
    until(lambda: shown.player.at_end and not shown.playing, 60000, "the end of the program")
    click(shown.controls.play)
    until(lambda: shown.playing and shown.player.time < 5.0, 20000, "that it plays from the beginning")


def test_a_new_result_is_taken_up_while_it_plays(doc, opened, pump, until):
    path = toolpath(doc)
    shown = opened(path)
    shown.play(True)
    before = len(shown.player.playback.program.words)
    path.Stepover = 6.0
    doc.recompute()
    until(lambda: len(shown.player.playback.program.words) < before, 20000, "the new result")
    assert shown.playing and children(doc).count("FiveAxisPlay") == 1


@pytest.mark.parametrize("what", ["object", "document", "undo"])
def test_it_stops_and_closes_when_what_it_plays_goes(doc, opened, pump, what, until):
    import FreeCAD
    import FreeCADGui

    from freecad_fiveaxis.gui.play import panel

    doc.openTransaction("path")
    path = toolpath(doc)
    doc.commitTransaction()
    shown = opened(path)
    shown.play(True)
    pump(200)
    name = doc.Name
    if what == "object":
        doc.removeObject(path.Name)
    elif what == "undo":
        doc.undo()
    else:
        FreeCAD.closeDocument(name)
    assert not shown.playing
    until(
        lambda: panel.current() is None and not FreeCADGui.Control.activeDialog(), 20000, "the player closed"
    )
    if what != "document":
        assert "FiveAxisPlay" not in children(doc)


def test_it_goes_on_without_a_view_and_closes(doc, opened, pump, panel_button, panel_closed):
    import FreeCADGui

    from freecad_fiveaxis.gui.qt import QtWidgets

    shown = opened(toolpath(doc))
    shown.play(True)
    area = FreeCADGui.getMainWindow().findChild(QtWidgets.QMdiArea)
    first = area.subWindowList()[0]
    FreeCADGui.runCommand("Std_ViewCreate")
    pump(300)
    first.close()
    pump(400)
    shown.controls.follow.setChecked(True)
    shown.refresh()
    panel_button("Close")
    panel_closed()
    assert "FiveAxisPlay" not in children(doc)


def test_another_panel_is_not_pushed_aside(doc, opened):
    import FreeCADGui

    path = toolpath(doc)
    shown = opened(path)
    from freecad_fiveaxis.gui import play

    with pytest.raises(RuntimeError):
        play.show(path)
    assert children(doc).count("FiveAxisPlay") == 1
    assert FreeCADGui.Control.activeDialog() and shown.stage.shown


def test_it_closes_when_its_object_cannot_be_computed_any_more(doc, opened, pump, until):
    import FreeCADGui

    from freecad_fiveaxis.gui.play import panel

    path = toolpath(doc)
    opened(path)
    path.Machine = "no such machine"
    doc.recompute()
    until(
        lambda: panel.current() is None and not FreeCADGui.Control.activeDialog(), 20000, "the player closed"
    )
    assert "FiveAxisPlay" not in children(doc)


def test_a_dialog_closed_by_somebody_else_leaves_nothing_behind(doc, opened, pump, until):
    import FreeCADGui

    from freecad_fiveaxis.gui.play import panel

    shown = opened(toolpath(doc))
    shown.play(True)
    FreeCADGui.Control.closeDialog()
    until(lambda: panel.current() is None and not shown.playing, 20000, "the player closed")
    assert "FiveAxisPlay" not in children(doc)


def test_following_ends_where_the_camera_was(doc, opened, tick, panel_button, until, panel_closed):
    shown = opened(toolpath(doc))
    before = state(doc)
    tick(shown.controls.follow)
    shown.step(lambda: shown.player.go_to_share(0.7))
    assert state(doc)[2] != before[2]
    panel_button("Close")
    panel_closed()
    until(lambda: state(doc) == before, 20000, "the document as it was")


def test_lengths_are_shown_in_the_users_units(doc, tmp_path, opened, click, parameters, until):
    import FreeCAD

    units = parameters("User parameter:BaseApp/Preferences/Units")
    kept = units.GetInt("UserSchema", 0)
    FreeCAD.Units.setSchema(3)  # imperial decimal
    if hasattr(doc, "UnitSystem"):  # from 1.0 on a document has its own, and setEditorMode brings it back
        doc.UnitSystem = 3
    try:
        shown = opened(table_2(doc, tmp_path))
        click(shown.controls.worst)
        until(lambda: shown.readout.gap.text() == f"{WORST / 25.4:.4g} in", 20000, "the gap in inches")
        assert shown.readout.joints[0].text().endswith(" in") and shown.readout.joints[3].text().endswith("°")
        assert float(shown.readout.joints[0].text().split()[0]) * 25.4 == pytest.approx(
            shown.player.pose.words[0], abs=2e-4
        )
    finally:
        FreeCAD.Units.setSchema(kept)


@pytest.mark.parametrize("driven", [0.0, 4.0])
def test_the_tool_stands_with_its_driven_point_at_zero(driven):
    low, high = box_of(tool_body("ball:8:40", [(30.0, 50.0)]), driven)
    assert np.allclose(low, (-15, -15, -driven), atol=1e-4) and np.allclose(
        high, (15, 15, 90 - driven), atol=1e-4
    )


def tool_body(cutter, holder=()):
    from freecad_fiveaxis.core.tool import parse_cutter
    from freecad_fiveaxis.core.tool.body import body_of

    return body_of(parse_cutter(cutter), (), holder)


def box_of(body, driven=0.0):
    from pivy import coin

    from freecad_fiveaxis.gui.play.tool import DrawnTool, tool_node

    measure = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(100, 100))
    measure.apply(tool_node(DrawnTool(body, driven)))
    box = measure.getBoundingBox()
    return box.getMin().getValue(), box.getMax().getValue()


@pytest.mark.parametrize(
    "cutter", ["ball:10:30", "flat:10:30", "bull:10:2:30", "taperball:6:5deg:30", "taperbull:10:2:15deg:30"]
)
def test_every_point_that_is_drawn_lies_on_the_body_that_is_checked(cutter):
    from pivy import coin

    from freecad_fiveaxis.core.tool.body import depth_of
    from freecad_fiveaxis.gui.play.tool import TURNS, DrawnTool, tool_node

    body, drawn = tool_body(cutter, [(40.0, 25.0), (63.0, 50.0)]), []
    act = coin.SoCallbackAction()
    act.addTriangleCallback(
        coin.SoShape.getClassTypeId(), lambda _, __, *corners: drawn.extend(corners), None
    )
    act.apply(tool_node(DrawnTool(body)))
    points = np.array([corner.getPoint().getValue() for corner in drawn], float)
    normals = np.array([corner.getNormal().getValue() for corner in drawn], float)
    assert len(points) > 50 * TURNS
    up = np.array([0.0, 0.0, 1.0])
    assert np.abs(depth_of(body, np.zeros(3), up, points)).max() < 1e-4
    middles = points.reshape(-1, 3, 3).mean(axis=1)
    area = np.cross(*(points.reshape(-1, 3, 3)[:, k] - points.reshape(-1, 3, 3)[:, 0] for k in (1, 2)))
    thick = np.linalg.norm(area, axis=1) > 1e-3
    assert np.all(
        depth_of(body, np.zeros(3), up, middles + 0.5 * normals.reshape(-1, 3, 3).mean(axis=1))[thick] < 0.0
    )


@pytest.mark.parametrize("kind", ["bull:12:3:25", "taperball:6:8deg:30", "flat:12:25"])
def test_play_shows_cutter_shank_and_holder_in_their_true_shape(
    doc, opened, screenshot, pixels, kind, pump, until
):
    result = toolpath(
        doc, cutter=kind, lead=10, shank="8x12", holder="30x15,44x25", stepover=6.0, gouge="off"
    )
    shown = opened(result)
    low, high = box_of(shown_body(result))
    assert np.allclose((low[0], high[2]), (-22, float(result.CutterLength.Value) + 12 + 40), atol=1e-3)
    for _ in range(40):
        shown.step(shown.player.forward)
    view_of(doc).fitAll()
    pump(300)
    until(lambda: pixels(screenshot("play-" + kind.partition(":")[0]), BRASS, 60) > 200, 30000, "the tool")


def shown_body(obj):
    from freecad_fiveaxis.app import convert

    return convert.tool_of(obj).body


def test_another_holder_is_drawn_while_it_plays(doc, opened, pump, until):
    result = toolpath(doc, stepover=8.0)
    shown = opened(result)
    before = shown.stage
    result.Holder = "60x20"
    until(lambda: shown.stage is not before, 20000, "another tool")
    result.Holder = "60"
    from freecad_fiveaxis.gui.play import panel

    until(lambda: panel.current() is None, 20000, "no player of a tool that cannot be")


def test_a_path_without_blocks_and_a_thing_that_is_no_path_are_refused_in_words(doc, tmp_path):
    from freecad_fiveaxis.core.base.errors import FiveAxisError
    from freecad_fiveaxis.gui import play
    from freecad_fiveaxis.gui.play import panel

    with pytest.raises(FiveAxisError, match="no toolpath"):
        play.show(dome(doc))
    assert panel.current() is None and "FiveAxisPlay" not in children(doc)
