# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bodies of a machine's file and fixtures in the player: where they are drawn, by turns written out here;
red where they are hit."""

import json
from pathlib import Path

import numpy as np
import pytest
from test_play import matrix, opened, tick, toolpath, view_of

from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.geometry.solids import box_facets, frustum_facets

__all__ = ["opened", "tick"]
pytestmark = pytest.mark.usefixtures("kept")
EXAMPLE = Path(__file__).resolve().parents[2] / "resources" / "machines" / "trunnion_with_bodies.fcm"
ORIGIN, LENGTH, ZERO = np.array((10.0, -5.0, 20.0)), 90.0, np.array((3.0, 4.0, 5.0))
PIVOT = -50.0  # mm: height of the line of A, which runs along X; C turns about Z
POST = (np.array((70.0, -10.0, -200.0)), np.array((110.0, 10.0, 60.0)))
CHEEK = (np.array((-90.0, -10.0, -170.0)), np.array((-70.0, 10.0, 20.0)))
PLATTER = (np.array((0.0, 0.0, -110.0)), np.array((0.0, 0.0, -90.0)), 60.0)
NOSE = (np.array((0.0, 0.0, 0.0)), np.array((0.0, 0.0, 50.0)), 20.0, 30.0)
PROGRAM = """G21 G90 G94
G1 X0 Y0 Z60 A0 C0 F2000
G1 X10 Y5 Z50 A20 C40
G1 X52 Y-40 Z10 A20 C40
G1 X52 Y50 Z10 A20 C40
G1 X0 Y0 Z60 A-30 C100
G1 X-68 Y-40 Z60 A0 C100
G1 X-68 Y-40 Z-30 A0 C100
G1 X-68 Y50 Z-30 A0 C100
G1 X0 Y0 Z70 A0 C0
M2
"""
"""Block 3 drives along Y past the post, 7 mm into it, and block 7 past the cheek, 3 mm into it: deepest in
the middle of each."""
RED = (224, 31, 20)


def machine_file(folder, cheek=None):
    """The example with four bodies of its own, one of them an STL."""
    data = json.loads(EXAMPLE.read_text())
    write_stl(from_triangles(box_facets(*CHEEK) if cheek is None else cheek), folder / "cheek.stl")
    ends = [{"low": one[0].tolist(), "high": one[1].tolist()} for one in (POST, PLATTER, NOSE)]
    data["fiveaxis"]["bodies"] = [
        {"name": "post", "carrier": "base", "box": ends[0]},
        {"name": "cheek", "carrier": "A", "file": "cheek.stl"},
        {"name": "platter", "carrier": "C", "cylinder": {**ends[1], "radius": PLATTER[2]}},
        {
            "name": "nose",
            "carrier": "spindle",
            "cone": {**ends[2], "low_radius": NOSE[2], "high_radius": NOSE[3]},
        },
    ]
    path = folder / "with_bodies.fcm"
    path.write_text(json.dumps(data))
    return str(path)


def audited(doc, folder, cheek=None, **more):
    from freecad_fiveaxis import app

    path = folder / "bodies.ngc"
    path.write_text(PROGRAM)
    given = {
        "origin": tuple(ORIGIN),
        "tool_length": LENGTH,
        "work_zero": tuple(ZERO),
        "holder": "30x40",
        "cutter": "ball:6:20",
    }
    return app.audit(doc, str(path), machine_file(folder, cheek), **given | more)


def turn(axis, degrees):
    cos, sin = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array(
        [[1, 0, 0], [0, cos, -sin], [0, sin, cos]]
        if axis == "A"
        else [[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]]
    )


def true_corners(name, words):
    """The corners of a body in the document at words X Y Z C A, on a table that turns what it carries the
    other way round."""
    if name == "nose":
        facets = frustum_facets(*NOSE).reshape(-1, 3) + words[:3] + (0.0, 0.0, LENGTH)
        return np.unique(facets, axis=0) + ZERO
    corners = (
        frustum_facets(*PLATTER, PLATTER[2])
        if name == "platter"
        else box_facets(*(POST if name == "post" else CHEEK))
    )
    corners = np.unique(corners.reshape(-1, 3), axis=0)
    if name == "platter":
        corners = corners @ turn("C", -words[3]).T
    if name != "post":
        corners = (corners - (0, 0, PIVOT)) @ turn("A", -words[4]).T + (0, 0, PIVOT)
    return corners - ORIGIN + ZERO


def drawn_corners(doc, look):
    """Where the corners of the mesh are drawn whose colour this is, in the document."""
    from pivy import coin

    search = coin.SoSearchAction()
    search.setNode(look.node)
    search.apply(view_of(doc).getSceneGraph())
    path, found = search.getPath(), []
    path.truncate(path.getLength() - 1)
    act = coin.SoCallbackAction()

    def corners(_, action, *three):
        place = np.array(action.getModelMatrix().getValue()).reshape(4, 4)
        found.extend(np.array([*one.getPoint().getValue(), 1.0]) @ place for one in three)

    act.addTriangleCallback(coin.SoShape.getClassTypeId(), corners, None)
    act.apply(path)
    return np.array(found)[:, :3]


def apart(some, others):
    """How far two clouds of points are from each other, mm: the farthest nearest neighbour, both ways."""
    distance = np.linalg.norm(some[:, None] - others, axis=2)
    return max(distance.min(axis=0).max(), distance.min(axis=1).max())


def check_places(doc, shown):
    machine, words = shown.stage.machine, shown.player.pose.words
    for one, look in zip(machine.standing, machine.looks, strict=True):
        gap = apart(drawn_corners(doc, look), true_corners(one.name, words))
        assert gap < 1e-3, f"{one.name} is drawn {gap:.3g} mm off at {words}"


def reds(shown):
    return {
        one.name
        for one, look in zip(shown.stage.machine.standing, shown.stage.machine.looks, strict=True)
        if look.hit
    }


@pytest.mark.usefixtures("whole_screen")
def test_bodies_stand_where_the_axes_carry_them_and_are_red_where_they_are_hit(
    doc, tmp_path, opened, click, tick, screenshot, pixels, until, monkeypatch
):
    shown = opened(audited(doc, tmp_path))
    assert shown.player.colliding.tolist() == [3, 7]
    tick(shown.controls.machine)
    until(lambda: shown.controls.machine.isChecked(), 20000, "the machine")
    machine = shown.stage.machine
    assert [one.name for one in machine.standing] == ["post", "cheek", "platter", "nose"]
    assert not machine.bodies, "what the file names is not sketched too"
    for block, u in ((0, 1.0), (1, 0.5), (4, 0.3), (5, 0.7), (8, 0.5)):
        shown.player.block, shown.player.u = block, u
        shown.refresh()
        check_places(doc, shown)
        assert not reds(shown) and shown.readout.hit.text() == ""
    quiet = pixels(screenshot("play_bodies"), RED, 40)
    for block, name, place in ((3, "post", "base"), (7, "cheek", "cradle"), (3, "post", "base")):
        click(shown.controls.collision)
        until(lambda: shown.player.block == block, 20000, f"block {block}")  # noqa: B023
        assert reds(shown) == {name} and shown.player.u == pytest.approx(0.5, abs=0.15)
        assert shown.readout.hit.isVisible() and shown.readout.hit.text() == f"Collision: holder in {name}"
        assert f"into the {name}" in shown.readout.hit.toolTip()
        check_places(doc, shown)
        assert next(one.place for one in machine.standing if one.name == name) == place
        until(
            lambda name=name: pixels(screenshot(f"play_bodies_{name}"), RED, 40) > quiet + 500,
            30000,
            f"a red {name}",
        )
    shown.step(shown.player.forward)
    assert shown.player.block == 3 and reds(shown) == {"post"}, "all through the block"
    shown.step(shown.player.forward)
    until(lambda: shown.player.block == 4 and not reds(shown), 20000, "quiet again")
    until(
        lambda: pixels(screenshot("play_bodies_free"), RED, 40) < quiet + 20, 30000, "no red in the picture"
    )
    shown.stage.machine.carriers[3].matrix.setValue(*np.eye(4).reshape(-1).tolist())
    shown.stage.machine.carriers[4].matrix.setValue(*np.eye(4).reshape(-1).tolist())
    with pytest.raises(AssertionError, match="is drawn"):  # the comparison sees an axis that does not carry
        check_places(doc, shown)


MOST = 2000


def dense_cheek():
    """The cheek of 12,288 facets: each of the box's twelve divided five times."""
    facets = box_facets(*CHEEK)
    for _ in range(5):
        a, b, c = facets.transpose(1, 0, 2)
        ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
        parts = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        facets = np.concatenate([np.stack(part, axis=1) for part in parts])
    return facets


def facets_drawn(doc, shown, name):
    """How many facets of a body are drawn."""
    bodies = shown.stage.machine
    look = next(look for one, look in zip(bodies.standing, bodies.looks, strict=True) if one.name == name)
    return len(drawn_corners(doc, look)) // 3


@pytest.mark.usefixtures("whole_screen")
def test_a_large_body_is_drawn_from_its_copy_while_it_moves_and_whole_where_it_stands(
    doc, tmp_path, opened, click, tick, until, screenshot, pixels, monkeypatch
):
    from freecad_fiveaxis.gui.play import solids

    monkeypatch.setattr(solids, "BUDGET", MOST)
    shown = opened(audited(doc, tmp_path, dense_cheek()))
    post, cheek = shown.stage.machine.drawn[:2]
    assert post.copy is None and 0.5 * MOST < len(cheek.copy.mesh.face) <= MOST
    tick(shown.controls.machine)
    until(lambda: shown.controls.machine.isChecked(), 20000, "the machine")
    assert not shown.moving and facets_drawn(doc, shown, "cheek") == 12288
    click(shown.controls.play)
    until(lambda: shown.playing, 20000, "the motion")
    assert cheek.reduced and facets_drawn(doc, shown, "cheek") == len(cheek.copy.mesh.face)
    assert facets_drawn(doc, shown, "post") == 12, "what is small stays as it is"
    screenshot("play_moving")
    shown.controls.speed.setCurrentIndex(shown.controls.speed.count() - 1)
    for block in (3, 7):
        until(lambda: not shown.playing, 60000, "a pause")
        assert shown.player.block == block and not cheek.reduced
        assert facets_drawn(doc, shown, "cheek") == 12288
        if block == 3:
            click(shown.controls.play)
    assert reds(shown) == {"cheek"}
    until(lambda: pixels(screenshot("play_standing"), RED, 40) > 500, 30000, "a red cheek")
    slider = shown.controls.slider
    slider.setSliderDown(True)
    shown.refresh()
    assert cheek.reduced and reds(shown) == {"cheek"}, "dragged, the copy has the same colour"
    until(lambda: pixels(screenshot("play_dragged"), RED, 40) > 500, 30000, "a red copy")
    slider.setSliderDown(False)
    assert not cheek.reduced and facets_drawn(doc, shown, "cheek") == 12288


def test_playing_pauses_at_a_collision_and_goes_on(doc, tmp_path, opened, click, until):
    shown = opened(audited(doc, tmp_path))
    shown.controls.speed.setCurrentIndex(shown.controls.speed.count() - 1)
    for block in (3, 7):
        click(shown.controls.play)
        until(lambda: not shown.playing, 60000, "a pause")
        assert shown.player.block == block and shown.readout.hit.text()
    click(shown.controls.play)
    until(lambda: shown.player.at_end and not shown.playing, 60000, "the end")


def test_the_spindle_is_red_with_what_it_hits(doc, tmp_path, opened, click, until):
    """A tool so short that the nose, 20 mm in radius, comes below the top of the post."""
    shown = opened(audited(doc, tmp_path, tool_length=25.0, holder=None))
    click(shown.controls.collision)
    until(lambda: shown.player.block == 3, 20000, "the post")
    assert shown.readout.hit.text() == "Collision: spindle in post" and reds(shown) == {"post", "nose"}


def test_without_the_tools_length_the_spindle_is_the_sketchs(doc, tmp_path, opened):
    shown = opened(audited(doc, tmp_path, tool_length=None))
    machine = shown.stage.machine
    assert [one.name for one in machine.standing] == ["post", "cheek", "platter"]
    assert {"spindle", "ram"} <= {body.name for body in machine.bodies}


def test_a_machine_without_bodies_is_sketched_and_has_no_collisions(doc, opened):
    shown = opened(toolpath(doc, stepover=8.0, linearize="off", gouge="off"))
    assert not shown.stage.machine.standing and not shown.stage.fixtures.switches
    assert {"platter", "cradle", "base", "spindle", "ram"} <= {
        body.name for body in shown.stage.machine.bodies
    }
    assert not shown.controls.collision.isVisible() and not shown.readout.hit.isVisible()
    assert not shown.player.go_to_next_collision()


def test_a_fixture_is_drawn_by_the_document_and_red_over_that_where_it_is_hit(
    doc, opened, click, tick, screenshot, pixels, until
):
    """A clamp 1 mm beside a plate, and a ball that is not led around it."""
    import FreeCAD
    from pivy import coin

    from freecad_fiveaxis import app

    plate, clamp = (doc.addObject("Part::Box", name) for name in ("Plate", "Clamp"))
    for one, size, low in ((plate, (30, 20, 10), (0, 0, 0)), (clamp, (10, 7, 25), (10, -8, 0))):
        one.Length, one.Width, one.Height = size
        one.Placement.Base = FreeCAD.Vector(*low)
    doc.recompute()
    given = {
        "machine": "trunnion_ac",
        "tool_length": 120,
        "cutter": "ball:6",
        "stepover": 2.0,
        "passes": "planes",
    }
    path = app.create_toolpath(
        doc,
        plate,
        **given,
        max_axis_angle=30,
        linearize="off",
        gouge="report",
        fixtures=[clamp],
        work_zero=tuple(ZERO),
    )
    shown = opened(path)
    ((name, switch),) = shown.stage.fixtures.switches
    assert name == "Clamp" and clamp.ViewObject.Visibility and len(shown.player.colliding) == 1
    assert switch.whichChild.getValue() == coin.SO_SWITCH_NONE
    quiet = pixels(screenshot("play_fixture"), RED, 40)
    click(shown.controls.collision)
    block = shown.player.colliding[0]
    until(lambda: shown.player.block == block, 20000, "the collision")
    assert switch.whichChild.getValue() == coin.SO_SWITCH_ALL
    assert shown.readout.hit.text() == "Collision: cutter in Clamp"
    until(lambda: pixels(screenshot("play_fixture_hit"), RED, 40) > quiet + 200, 30000, "a red clamp")
    tick(shown.controls.machine)
    until(lambda: shown.controls.machine.isChecked(), 20000, "the machine")
    assert "riser" not in {body.name for body in shown.stage.machine.bodies}, "what holds the part is known"
    assert np.allclose(matrix(shown.stage.work), shown.player.pose.machine_from_work, atol=1e-5)
    measure = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(100, 100))
    measure.apply(switch)
    box = measure.getBoundingBox()
    low, high = np.array(box.getMin().getValue()), np.array(box.getMax().getValue())
    assert np.allclose(low, (10, -8, 0) - ZERO, atol=1e-4) and np.allclose(
        high, (20, -1, 25) - ZERO, atol=1e-4
    )
    screenshot("play_fixture_on_the_machine")
    click(shown.controls.begin)
    until(lambda: switch.whichChild.getValue() == coin.SO_SWITCH_NONE, 20000, "quiet again")


def ambers(shown):
    return {
        one.name
        for one, look in zip(shown.stage.machine.standing, shown.stage.machine.looks, strict=True)
        if look.near
    }


AMBER = (230, 158, 0)


@pytest.mark.usefixtures("whole_screen")
def test_what_is_come_near_to_is_amber_and_named_with_the_distance_between_the_collisions(
    doc, tmp_path, opened, click, tick, screenshot, pixels, until
):
    """A shelf that block 4 goes past within a few millimetres, between the two collisions."""
    machine = json.loads(Path(machine_file(tmp_path)).read_text())
    shelf = {"low": [0, 40, 100], "high": [20, 60, 140]}
    machine["fiveaxis"]["bodies"].append({"name": "shelf", "carrier": "base", "box": shelf, "clearance": 10})
    (tmp_path / "near.fcm").write_text(json.dumps(machine))
    result = audited(doc, tmp_path)
    result.Machine = str(tmp_path / "near.fcm")
    doc.recompute()
    shown = opened(result)
    near = next(one for one in shown.player.stops if one.near is not None)
    assert near.code == "machine-near" and near.near.entered == "shelf" and near.block == 4
    assert 0.5 < near.value < 7.0
    blocks, amber = [3, 4, 7], {"shelf", "nose"} if near.near.enters == "spindle" else {"shelf"}
    assert shown.player.colliding.tolist() == blocks and shown.controls.collision.text() == "Next collision"
    tick(shown.controls.machine)
    until(lambda: shown.controls.machine.isChecked(), 20000, "the machine")
    quiet = pixels(screenshot("play_near_none"), AMBER, 40)
    for block in blocks:
        click(shown.controls.collision)
        until(lambda: shown.player.block == block, 20000, f"block {block}")  # noqa: B023
        assert ambers(shown) == (amber if block == 4 else set()) and (not reds(shown)) == (block == 4)
    shown.player.block, shown.player.u = 3, 1.0
    click(shown.controls.collision)
    until(lambda: ambers(shown), 20000, "the near miss")
    text = shown.readout.hit.text()
    assert text.startswith(f"Near: {near.near.enters} within ") and text.endswith(" mm of shelf"), text
    assert shown.player.u == pytest.approx(near.near.u) and "nearer than" in shown.readout.hit.toolTip()
    until(lambda: pixels(screenshot("play_near"), AMBER, 40) > quiet + 300, 30000, "an amber shelf")
    shown.player.block, shown.player.u = 3, 1.0
    shown.play(True)
    until(lambda: not shown.playing, 60000, "a pause")
    assert shown.player.block == near.block and ambers(shown) == amber, "playing pauses there too"


def test_a_fixture_that_is_nearly_hit_is_amber_and_marked(
    doc, tmp_path, opened, click, until, screenshot, pixels
):
    """A clamp 2 mm beside a flat end of 6 mm, with 4 mm asked for; nothing is hit."""
    import FreeCAD
    from pivy import coin

    from freecad_fiveaxis import app

    clamp = doc.addObject("Part::Box", "Clamp")
    clamp.Length, clamp.Width, clamp.Height, clamp.Placement.Base = 10, 20, 25, FreeCAD.Vector(20, 5, 0)
    doc.recompute()
    (tmp_path / "near.ngc").write_text(
        "G21 G90 G94\nG1 X0 Y0 Z40 A0 C0 F2000\nG1 X0 Y0 Z20\nG1 X40 Y0 Z20\nG1 X40 Y0 Z40\nM2\n"
    )
    given = {"cutter": "flat:6:30", "fixtures": [clamp], "tool_length": 120}
    result = app.audit(doc, str(tmp_path / "near.ngc"), "trunnion_ac", fixture_clearance=4, **given)
    marks = app.annotate(result)
    at = marks.Kinds.index("fixture-near")
    assert marks.Labels[at] == "cutter within 2 mm of Clamp, line 4"
    shown = opened(result)
    assert shown.controls.collision.isVisible() and shown.controls.collision.text() == "Next near miss"
    (_, switch), (look,) = shown.stage.fixtures.switches[0], shown.stage.fixtures.looks
    quiet = pixels(screenshot("play_near_fixture_none"), AMBER, 40)
    click(shown.controls.collision)
    until(lambda: look.near and not look.hit, 20000, "the near miss")
    assert (
        switch.whichChild.getValue() == coin.SO_SWITCH_ALL
        and shown.readout.hit.text() == "Near: cutter within 2 mm of Clamp"
    )
    until(lambda: pixels(screenshot("play_near_fixture"), AMBER, 40) > quiet + 200, 30000, "an amber clamp")
    click(shown.controls.begin)
    until(lambda: switch.whichChild.getValue() == coin.SO_SWITCH_NONE, 20000, "quiet again")
    free = app.audit(doc, str(tmp_path / "near.ngc"), "trunnion_ac", fixture_clearance=1.5, **given)
    assert "fixture-near" not in app.annotate(free).Kinds, "the comparison can fail"
