# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nodes of the 3D view, made from the core's figures alone and looked at on the screen: colours, marks,
legend.

How long a frame takes is measured by benchmarks/freecad (``make bench-window``); here is counted what a frame
is made of.
"""

import importlib.util
from dataclasses import replace
from pathlib import Path

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from conftest import picture as picture_of
from scipy.spatial import cKDTree

pytest.importorskip("pivy")

from large_scenes import Frames, long_path, picture_of_long, surface

from freecad_fiveaxis.app.units import area_text
from freecad_fiveaxis.core.report import draw
from freecad_fiveaxis.core.report.drawing import STROKES
from freecad_fiveaxis.core.report.rest_material_map import height_scale
from freecad_fiveaxis.gui.panels import toolpath
from freecad_fiveaxis.gui.scene import (
    camera,
    colours,
    covers,
    labels,
    layout,
    marks,
    nodes,
    on_screen,
    overlay,
    path_nodes,
    rest_nodes,
    words,
)

pytestmark = pytest.mark.usefixtures("every_frame")

CORE_TESTS = Path(__file__).parents[1] / "core"
GOOD, BAD, SINGULAR = (0.0, 0.62, 0.45), (0.835, 0.369, 0.0), (0.8, 0.475, 0.655)
LOOK = path_nodes.Look(GOOD, BAD, SINGULAR)


def _example(name):
    spec = importlib.util.spec_from_file_location("report_examples", CORE_TESTS / "report_examples.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return getattr(module, name)()


@pytest.fixture(scope="module")
def dome():
    return _example("dome")


@pytest.fixture(scope="module")
def table2():
    return _example("table2")


@pytest.fixture
def scene(doc, pump):
    """scene(node): put it into the view, seen from above; taken out afterwards."""
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    added = []

    def add(node, direction="viewTop"):
        view.getSceneGraph().addChild(node)
        added.append(node)
        getattr(view, direction)()
        view.fitAll()
        pump(400)
        return view

    yield add
    root = view.getSceneGraph()
    for node in added:
        if root.findChild(node) >= 0:
            root.removeChild(node)
    pump(100)


def _pixels(colour):
    return [round(255 * float(part)) for part in colour]


def test_the_colours_are_calm_below_the_tolerance_and_loud_above():
    levels = np.array([0.0, 0.5, np.nextafter(0.5, 1), 1.0])
    got = colours.pack_levels(levels, GOOD, BAD)
    assert got[0] == pytest.approx(colours.pack(GOOD)) and got[3] == colours.pack(BAD)
    light = [
        colours._to_lab(np.array([(code >> shift & 255) / 255 for shift in (24, 16, 8)]))[0]
        for code in got.tolist()
    ]
    assert light[0] > light[1] + 0.15  # darker is more
    assert light[2] > light[1] + 0.3  # the step at the tolerance is seen without seeing the hue
    assert light[2] > light[3] + 0.1


@pytest.mark.parametrize(("schema", "least"), [(0, "≤ "), (3, "<")])
def test_the_marks_of_the_scale_have_one_comparison_sign_each(dome, schema, least):
    before = FreeCAD.Units.getSchema()
    FreeCAD.Units.setSchema(schema)
    try:
        small = replace(dome, tolerance=0.0001 if schema else dome.tolerance)
        marks = [text for _, text in words._scale(small, LOOK)[1]]
    finally:
        FreeCAD.Units.setSchema(before)
    assert marks[0].startswith(least) and not [
        text for text in marks if sum(text.count(sign) for sign in "≤≥<") > 1
    ]


def test_each_half_of_the_map_darkens_evenly():
    light = colours._to_lab(colours.ramp(GOOD, BAD))[:, 0]
    for half in (light[: colours.SHADES // 2], light[colours.SHADES // 2 :]):
        steps = np.diff(half)
        assert (steps < 0).all()
        assert steps.min() > 3.0 * steps.mean()


def test_the_path_is_seen_in_its_colours(dome, scene, screenshot, view_box, until):
    picture = path_nodes.PathNodes()
    drawing = draw(dome)
    picture.show(drawing, LOOK)
    for part in ("axes", "marks", "curves", "rapids"):
        picture.turn(part, False)
    scene(picture.root)
    used = set(colours.pack_levels(drawing.level, GOOD, BAD).tolist())
    loud = used & set(colours.pack_levels(drawing.level[drawing.level > 0.5], GOOD, BAD).tolist())
    assert loud and len(loud) < len(used)
    left, top, width, height = view_box()

    def rgb(codes):
        return np.array(list(codes))[:, None] >> (24, 16, 8) & 255

    def count(shot, codes):
        """Pixels of the picture within 2 of one of the colours."""
        seen = picture_of(shot)[top : top + height, left : left + width] @ (1 << 24, 1 << 16, 1 << 8)
        hues, often = np.unique(seen, return_counts=True)
        return often[cKDTree(rgb(codes)).query(rgb(hues), p=np.inf)[0] <= 2].sum()

    until(lambda: count(screenshot("scene-path"), loud) > 1000, 30000, "a loud colour")
    until(lambda: count(screenshot("scene-path"), used - loud) > 1000, 30000, "a calm colour")
    picture.turn("cuts", False)
    until(lambda: count(screenshot("scene-no-path"), loud) == 0, 30000, "no loud colour")


def test_markers_stand_where_the_core_says_and_can_be_distinguished(
    dome, scene, screenshot, pixels, view_box, until
):
    picture = path_nodes.PathNodes()
    picture.show(draw(dome), LOOK)
    for part in ("cuts", "links", "axes", "curves", "rapids"):
        picture.turn(part, False)
    scene(picture.root)
    for colour, what in ((BAD, "marks over the tolerance"), (SINGULAR, "marks of singular blocks")):
        until(lambda: pixels(screenshot("scene-marks"), _pixels(colour), 2, view_box()) > 300, 30000, what)  # noqa: B023


def test_the_curve_of_table_2_is_seen_to_overshoot_its_chord(
    table2, scene, screenshot, pixels, view_box, until
):
    """The picture of the curve is larger than that of the chord by as much as the curve is."""
    picture = path_nodes.PathNodes()
    drawing = draw(table2)
    picture.show(drawing, LOOK)
    for part in ("cuts", "links", "marks", "rapids", "axes"):
        picture.turn(part, False)
    scene(picture.root)
    until(lambda: pixels(screenshot("scene-table2"), _pixels(BAD), 2, view_box()) > 1000, 30000, "the curve")
    shot = screenshot("scene-table2")
    bad, white = (pixels(shot, _pixels(colour), 2, view_box()) for colour in (BAD, (1, 1, 1)))
    flat = drawing.curve[:, :2]  # seen from above
    ways = [np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in (flat, drawing.chord[:, :2])]
    assert bad > 1000 and white > 50
    assert bad / white == pytest.approx(ways[0] / ways[1], rel=0.5)


def test_the_legend_is_no_part_of_the_scenes_box(dome, scene, screenshot, pixels, view_box, until):
    picture = path_nodes.PathNodes()
    picture.show(draw(dome), LOOK)
    view = scene(picture.root)
    height = view.getCameraNode().height.getValue()
    picture.legend.show(words.legend_of("Path", dome, LOOK, "Out of date"))
    picture.labels.show([on_screen.Label((0.0, 0.0, 0.0), words.label_text(0.1278, 459, 0.01))])
    view.fitAll()
    assert view.getCameraNode().height.getValue() == pytest.approx(height, rel=1e-3)
    until(lambda: pixels(screenshot("scene-legend"), overlay.WARN, 40, view_box()) > 30, 30000, "the warning")
    picture.turn("cuts", False)
    picture.turn("legend", False)
    until(
        lambda: pixels(screenshot("scene-no-legend"), overlay.WARN, 40, view_box()) < 10, 30000, "no warning"
    )


def overlapping(boxes):
    """Pairs of boxes (n, 4) pixels that share a pixel."""
    return [
        (i, j)
        for i in range(len(boxes))
        for j in range(i)
        if (np.maximum(boxes[i, :2], boxes[j, :2]) < np.minimum(boxes[i, 2:], boxes[j, 2:])).all()
    ]


def standing(labels):
    """The boxes of the labels that have a place."""
    return labels.boxes[labels.slots >= 0]


@pytest.mark.usefixtures("whole_screen")
def test_labels_lie_beside_each_other_and_beside_the_legend_from_every_side(
    dome, scene, screenshot, pump, monkeypatch, capsys
):
    """Eight labels on 6 mm, in two sets as of two objects, whose legends take turns; the camera goes round.
    And few places are tried."""
    rng = np.random.default_rng(2)
    sets, legends = [on_screen.Labels(), on_screen.Labels()], [on_screen.LegendBox(), on_screen.LegendBox()]
    places = rng.uniform(-3.0, 3.0, (8, 3))
    for at, one in enumerate(sets):
        one.show(
            [
                on_screen.Label(places[4 * at + i], f"{0.1278 * i:.4f} mm, NC line {1000 * at + i}", BAD)
                for i in range(4)
            ]
        )
    for title, one in zip(("First", "Second"), legends, strict=True):
        one.show(words.legend_of(title, dome, LOOK, ""))
    ball, frames = nodes.coin.SoSphere(), Frames()
    ball.radius = 20.0
    view = scene(
        nodes.separate(frames.node, ball, *(one.root for one in (sets[0], legends[0], sets[1], legends[1])))
    )
    tried, wanted, overlap, place = [], [], layout.overlap, on_screen._Overlay.place

    def counted(box, *others):
        tried.append(len(box))
        return overlap(box, *others)

    def noted(overlay, action):
        wanted.append(overlay)
        place(overlay, action)

    monkeypatch.setattr(layout, "overlap", counted)
    monkeypatch.setattr(on_screen._Overlay, "place", noted)
    frames.count = 0
    for turn in range(12):
        legends[turn % 2].come_forward()
        view.redraw()
        view.setCameraOrientation(FreeCAD.Rotation(FreeCAD.Vector(1, 0.3, 0.2), 30 * turn))
        view.redraw()
        pump(20)
        boxes = np.concatenate([*(standing(one) for one in sets), *(one.box for one in legends)])
        assert len(standing(sets[0])) == len(standing(sets[1])) == 4 and len(boxes) == 9
        assert [len(one.box) for one in legends] == [1 - turn % 2, turn % 2], "one legend"
        assert not overlapping(boxes), turn
        width, height = view.getSize()
        seen = np.array([view.getPointOnScreen(*map(float, place)) for place in places])
        near = np.concatenate([one.boxes for one in sets])
        assert (seen > 0).all() and (seen < (width, height)).all()
        assert np.linalg.norm(np.clip(seen, near[:, :2], near[:, 2:]) - seen, axis=1).max() < 250.0, (
            "far from its place"
        )
    assert frames.count >= 12 and len(wanted) == 4 * frames.count
    with capsys.disabled():
        print(f"\nplaces tried for 8 labels: {sum(tried) / frames.count:.0f} in a frame")
    assert sum(tried) <= frames.count * 8 * (len(layout.SLOTS) + 1), (
        "more than each slot and the one of the last frame"
    )
    screenshot("scene-labels")


def test_one_legend_is_seen_that_shown_last_and_after_it_the_next_one(dome, scene, until):
    """Also one that only some frames have; and that of a selected object before one that is shown later."""
    legends = [on_screen.LegendBox() for _ in range(3)]
    switches = [nodes.switch(one.root) for one in legends]
    for one in legends:
        one.show(words.legend_of("Path", dome, LOOK, ""))
    view = scene(nodes.separate(nodes.coin.SoCube(), *switches))
    drawn = [True] * 3

    def sees(expected, why):
        def seen():
            return [at for at, one in enumerate(legends) if drawn[at] and len(one.box)]

        until(lambda: seen() == [expected], 20000, why)
        assert legends[expected].box[0, [0, 3]].tolist() == [layout.EDGE, view.getSize()[1] - layout.EDGE]

    def turn(at, on):
        drawn[at] = on
        nodes.turn(switches[at], on)

    sees(2, "that made last")
    turn(2, False)
    sees(1, "that before it")
    legends[0].come_forward()
    sees(0, "that shown last")
    turn(2, True)
    sees(0, "that shown last, though another is there again")
    legends[1].come_forward(chosen=True)
    legends[2].come_forward()
    sees(1, "that of the selected object")
    legends[1].step_back()
    sees(2, "that shown last, as nothing is selected")
    legends[2].show(None)
    sees(1, "that of an object which has one")


def test_a_legend_comes_to_the_left_whatever_labels_stand_there_and_they_go(dome, scene, until):
    """At the other edge it would lie under the panel of FreeCAD 1.0 and later."""
    label, legend, ball = on_screen.Labels(), on_screen.LegendBox(), nodes.coin.SoSphere()
    ball.radius = 20.0
    legend.show(words.legend_of("Path", dome, LOOK, ""))
    switch = nodes.switch(legend.root)
    nodes.turn(switch, False)
    view = scene(nodes.separate(ball, label.root, switch))
    sizes = []

    # in a window that may still be being laid out, of whatever shape: what begins with the legend asks for no
    # frame
    def at_rest():
        if sizes[-1:] != [view.getSize()]:
            sizes.append(view.getSize())
            corner = [tuple(view.getPoint(120, sizes[-1][1] - 60 - 40 * row)) for row in range(5)]
            label.show([on_screen.Label(place, "A label near the left edge", BAD) for place in corner])
        view.redraw()
        return len(standing(label)) == 5

    until(at_rest, 20000, "the labels, in a view that keeps its size")
    before = standing(label).copy()
    nodes.turn(switch, True)

    def in_its_corner():
        return [(left, top) for left, _, _, top in legend.box] == [
            (layout.EDGE, view.getSize()[1] - layout.EDGE)
        ]

    until(in_its_corner, 20000, "the legend in its corner")
    assert overlapping(np.concatenate([before, legend.box])), "the labels stood elsewhere: nothing is shown"
    until(
        lambda: not overlapping(np.concatenate([standing(label), legend.box])), 20000, "the labels beside it"
    )


OVERLAYS = tuple(int(part) for part in FreeCAD.Version()[:2]) >= (
    1,
    1,
)  # from there on unless the user asks otherwise


@pytest.mark.usefixtures("whole_screen")
@pytest.mark.skipif(not OVERLAYS, reason="this FreeCAD lays no panels over a view")
def test_labels_stand_beside_a_panel_that_lies_over_the_view(scene, doc, until, screenshot, monkeypatch):
    """A label whose place lies just left of the panel would reach under it."""
    box, label, ball = doc.addObject("Part::Box", "Box"), on_screen.Labels(), nodes.coin.SoSphere()
    doc.recompute()
    ball.radius = 20.0
    view = scene(nodes.separate(ball, label.root))
    size = view.getSize()
    toolpath.create(box)
    until(lambda: len(covers.find_covered_boxes(size)), 20000, "a panel over the view")
    covered = covers.find_covered_boxes(size)
    place = view.getPoint(int(covered[0, 0]) - 40, int(covered[0, 1] + covered[0, 3]) // 2)
    label.show([on_screen.Label(tuple(place), "0.1278 mm, NC line 1000, left of the panel", BAD)])
    until(lambda: view.redraw() or len(standing(label)), 20000, "the label")
    screenshot("scene-covered")
    assert not overlapping(np.concatenate([standing(label), covered]))
    monkeypatch.setattr(on_screen, "find_covered_boxes", lambda size: layout.NONE)
    label.show([on_screen.Label(tuple(place), "0.1278 mm, NC line 1000, left of the panel", BAD)])
    until(lambda: view.redraw() or len(standing(label)), 20000, "the label")
    assert overlapping(np.concatenate([standing(label), covered])), "it would have stood there"


def test_an_idle_view_is_not_drawn_again_and_again_because_labels_find_their_places(dome, scene, pump, until):
    one, frames = on_screen.Labels(), Frames()
    one.show([on_screen.Label((0.0, 0.0, 0.0), "here"), on_screen.Label((0.5, 0.0, 0.0), "there")])
    scene(nodes.separate(frames.node, nodes.coin.SoCube(), one.root))
    until(lambda: frames.count, 20000, "a first frame")
    pump(400)
    frames.count = 0
    pump(600)
    assert frames.count <= 1


@pytest.mark.parametrize(
    ("deviation", "colour"),
    [(0.0, None), (4e-5, None), (0.004, GOOD), (0.01, GOOD), (0.011, BAD), (float("nan"), BAD)],
)
def test_the_largest_deviation_is_loud_only_over_the_tolerance(deviation, colour):
    assert marks.largest_colour(deviation, 0.01, GOOD, BAD) == colour
    result = marks.Marks()
    result.show(np.zeros((1, 3)), [marks.LARGEST], colour, BAD, SINGULAR, 7.0)
    search = nodes.coin.SoSearchAction()
    search.setType(nodes.coin.SoMaterial.getClassTypeId())
    search.setInterest(nodes.coin.SoSearchAction.ALL)
    search.apply(result.root)
    found = [
        search.getPaths()[i].getTail().diffuseColor[0].getValue()
        for i in range(search.getPaths().getLength())
    ]
    assert any(np.allclose(one, BAD, atol=1e-6) for one in found) == (colour == BAD)
    assert any(np.allclose(one, GOOD, atol=1e-6) for one in found) == (colour == GOOD)
    reported = labels.LargestDeviation(deviation, 12, 0.01, GOOD, BAD)
    message = labels.of_marks([(0, 0, 0)], [marks.LARGEST], [None], reported)
    assert [one.colour for one in message] == ([colour] if colour else [])
    assert not message or ("within" in message[0].text) == (colour == GOOD)


@pytest.mark.parametrize(("factor", "seen"), [(0.5, {BAD}), (2.0, {GOOD}), (None, {GOOD, BAD})])
def test_the_real_curves_are_loud_only_over_the_tolerance(dome, factor, seen):
    from dataclasses import replace

    drawing = draw(dome)
    off = np.linalg.norm(drawing.spoke[1::2] - drawing.spoke[0::2], axis=1)
    tolerance = factor * (off.min() if factor < 1.0 else off.max()) if factor else float(np.median(off))
    result = path_nodes._curves(replace(drawing, tolerance=tolerance), LOOK)
    (lines,) = [
        result[2].getChild(i)
        for i in range(result[2].getNumChildren())
        if hasattr(result[2].getChild(i), "numVertices")
    ]
    codes = np.array(lines.vertexProperty.getValue().orderedRGBA.getValues()).reshape(len(off), -1)
    assert {int(code) for code in codes.ravel()} == {colours.pack(colour) for colour in seen}
    assert ((codes[:, 0] == colours.pack(GOOD)) == (off <= tolerance)).all()


def test_a_kind_of_markers_has_one_label_and_each_side_that_is_not_machined_its_own():
    kinds = [marks.LARGEST, marks.OVER, marks.SINGULAR, "side-not-machined", "side-not-machined", marks.OVERCUT,
             "corner-not-reached", "corner-not-reached", "unit-suspected"]  # fmt: skip
    places = np.arange(27.0).reshape(-1, 3).tolist()
    values = [None, None, None, 2100.0, None, 0.4, None, None, None]
    message = labels.of_marks(places, kinds, values, labels.LargestDeviation(0.02, 12, 0.01, GOOD, BAD))
    assert [one.place for one in message] == [
        places[5],
        places[0],
        places[3],
        places[4],
        places[6],
    ]  # first what scraps the part
    assert "0.4" in message[0].text and "over" in message[1].text and area_text(2100.0) in message[2].text
    assert message[3].text == words.name_of("side-not-machined") and message[4].text.endswith(": 2 places")


@pytest.mark.parametrize("behind", ["nothing", "a legend"])
def test_a_marker_is_found_under_the_mouse(behind, dome, scene):
    """Also behind a legend, whose own camera would turn the mouse's ray away from what comes after it."""
    from pivy import coin

    drawing, result = draw(dome), marks.Marks()
    places = np.array([one.place for one in drawing.markers])
    kinds = [one.kind for one in drawing.markers]
    result.show(places, kinds, BAD, BAD, SINGULAR, 7.0)
    view = scene(result.root)
    found = []
    for row in range(0, len(places), 7):
        x, y = view.getPointOnScreen(FreeCAD.Vector(*places[row]))
        action = coin.SoRayPickAction(coin.SbViewportRegion(*view.getSize()))
        action.setPoint(coin.SbVec2s(int(x), int(y)))
        root = coin.SoSeparator()
        root.addChild(view.getCameraNode())
        if behind == "a legend":
            legend = on_screen.LegendBox()
            legend.show(words.legend_of("Path", dome, LOOK, ""))
            root.addChild(legend.root)
        root.addChild(result.root)
        action.apply(root)
        point = action.getPickedPoint()
        if point is not None:
            found.append(np.linalg.norm(places[result.find_picked_marker(point)][:2] - places[row][:2]))
    assert len(found) == len(range(0, len(places), 7))
    assert max(found) < 1.5  # mm: a neighbour that covers it


def test_looking_at_a_place_puts_it_into_the_middle(dome, scene, doc, pump, until):
    picture = path_nodes.PathNodes()
    drawing = draw(dome)
    picture.show(drawing, LOOK)
    view = scene(picture.root, "viewIsometric")
    for kind in ("Orthographic", "Perspective"):
        view.setCameraType(kind)
        view.viewIsometric()
        view.fitAll()
        pump(100)
        place = drawing.markers[0].place
        camera.look_at(doc, place, 5.0)
        width, height = view.getSize()
        middle = (pytest.approx(width / 2, abs=3), pytest.approx(height / 2, abs=3))
        until(
            lambda: tuple(view.getPointOnScreen(FreeCAD.Vector(*place))) == middle,  # noqa: B023
            20000,
            "the place in the middle",
        )
        y = view.getPointOnScreen(FreeCAD.Vector(*place))[1]
        up = view.getCameraNode().orientation.getValue().multVec(nodes.coin.SbVec3f(0, 2.4, 0)).getValue()
        above = view.getPointOnScreen(FreeCAD.Vector(*place) + FreeCAD.Vector(*up))
        assert above[1] - y == pytest.approx(0.48 * height, rel=0.1)  # 5 mm fill the view
    view.setCameraType("Orthographic")


def handed(node):
    """How many nodes, lines and triangles Coin gets with a node."""
    search, count = nodes.coin.SoSearchAction(), nodes.coin.SoGetPrimitiveCountAction()
    search.setType(nodes.coin.SoNode.getClassTypeId())
    search.setInterest(nodes.coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    search.apply(node)
    count.apply(node)
    return search.getPaths().getLength(), count.getLineCount(), count.getTriangleCount()


def drawn(scene, node):
    """Whether the view is drawn with a node in it."""
    frames = Frames()
    scene(nodes.separate(frames.node, node)).redraw()
    return frames.count > 0


@pytest.mark.parametrize("count", [500_000, 1_000_000])
def test_a_long_path_is_few_nodes_and_no_more_strokes_than_a_view_can_turn(count, dome, scene):
    """The whole picture: strokes as the core thins them, axes, 1000 marks, curves, legend. Each part is one
    node with all its lines."""
    pairs, level = long_path(count)
    small, large = (picture_of_long(dome, LOOK, *few) for few in ((pairs[:2], level[:1]), (pairs, level)))
    (nodes_of_one, lines_of_one, _), (nodes_of_all, lines, _) = handed(small.root), handed(large.root)
    assert nodes_of_all == nodes_of_one and lines - lines_of_one == len(level) - 1
    assert min(count, STROKES) / 2 < len(level) <= STROKES
    assert drawn(scene, large.root)


@pytest.mark.parametrize(("side", "most"), [(316, None), (223, 1000)])
def test_a_map_of_many_facets_is_few_nodes_and_one_triangle_for_each(side, most, scene, monkeypatch):
    """200 000 facets, each its own sample; and 100 000 where the facets' worst samples are drawn."""
    if most:
        monkeypatch.setattr(rest_nodes, "MOST_PATCHES", most)
    small, large = (
        rest_nodes.rest_surface(mesh, remainder, height_scale(remainder, 0.01, 0.03))
        for mesh, remainder in (surface(40), surface(side))
    )
    assert handed(large)[0] == handed(small)[0]
    assert [handed(node)[2] for node in (small, large)] == [2 * 40**2, 2 * side**2]
    assert drawn(scene, large)


def test_a_map_shows_each_height_where_it_is_in_the_core_s_colour(scene, screenshot, pixels, view_box, until):
    """Half of the surface is left, half is cut too deep: so are the pixels, but for light and shade."""
    mesh, remainder = surface(40)
    node = rest_nodes.rest_surface(mesh, remainder, height_scale(remainder, 0.01, 0.03))
    scene(nodes.separate(nodes.flat(), node))
    ramp = rest_nodes.scale_ramp() * 255.0
    for row, what in ((ramp[-40], "what is left"), (ramp[40], "what is cut too deep")):
        until(lambda: pixels(screenshot("scene-left"), row.round(), 60, view_box()) > 3000, 30000, what)  # noqa: B023


@pytest.mark.parametrize("camera", ["Orthographic", "Perspective"])
def test_the_line_to_a_place_behind_the_part_is_dashed(camera, scene, until, screenshot, view_box, pump):
    """A square plate and a place on its top: seen from above and from below."""
    one = on_screen.Labels()
    one.show([on_screen.Label((0.0, 0.0, 1.0), "here")])
    plate = nodes.coin.SoCube()
    plate.width, plate.height, plate.depth = 80.0, 80.0, 2.0
    view = scene(nodes.separate(plate, one.root))
    view.setCameraType(camera)
    share = {}
    for side in ("Top", "Bottom"):
        getattr(view, f"view{side}")()
        view.fitAll()
        one.boxes = np.full((1, 4), np.nan)
        until(lambda: view.redraw() or np.isfinite(one.boxes).all(), 20000, "a label")
        pump(300)
        share[side] = bright_share(one, view_box(), screenshot(f"leader_{side}_{camera}"))
    view.setCameraType("Orthographic")
    assert share["Top"] > 0.9, share
    assert 0.2 < share["Bottom"] < 0.9, share


def bright_share(labels, box, path):
    """Along the line to the only label: how much of it is bright."""
    ends = np.array([list(end.getValue()) for end in labels.ends.vertex.getValues()])[:, :2]
    x, y = (ends[0] + np.linspace(0.1, 0.9, 200)[:, None] * (ends[1] - ends[0])).T
    left, top, _, height = box
    seen = picture_of(path)
    rows, columns = np.rint(top + height - 1 - y).astype(int), np.rint(left + x).astype(int)
    near = [seen[rows + down, columns + right].min(axis=1) for down in (-1, 0, 1) for right in (-1, 0, 1)]
    return float((np.max(near, axis=0) > 235).mean())


@pytest.mark.parametrize("pixels_of_part", [10.0, 100.0, 400.0, 4000.0])
def test_markers_have_a_size_between_bounds_and_do_not_cover_a_far_part(pixels_of_part):
    result, rng = marks.Marks(), np.random.default_rng(1)
    places = np.concatenate([rng.uniform(0.0, 100.0, (2000, 3)), rng.uniform(0.0, 100.0, (30, 3))])
    result.show(places, [marks.SINGULAR] * 2000 + [marks.OVER] * 30, BAD, BAD, SINGULAR, 7.0)
    result.stand_on(np.zeros(3), np.full(3, 100.0))
    result.zoom_to(pixels_of_part / np.sqrt(3e4))
    sizes = [style.pointSize.getValue() for style, _, _ in result.sizes]
    assert min(sizes) >= marks.LEAST and max(sizes) <= 14.0 + marks.RIM
    shown = {int(shape.numPoints.getValue()) for shape, _, _ in result.many}
    assert len(shown) == 1 and (shown == {2000} if pixels_of_part == 4000.0 else shown.pop() >= marks.FEW)
    (one, *_) = result.many
    size = marks.choose_size(pixels_of_part, marks.least_size(14.0), 14.0) ** 2
    assert one[0].numPoints.getValue() * size <= max(
        0.5 * marks.COVERED * pixels_of_part**2, marks.FEW * size
    )


def test_a_far_part_is_seen_between_its_markers(scene, until, screenshot, pixels, view_box, pump):
    """A ball with a thousand markers near the pole, small in the view: the more so without the bounds of
    their sizes."""
    result, rng = marks.Marks(), np.random.default_rng(2)
    places = rng.normal(size=(1000, 3))
    places *= 20.0 / np.linalg.norm(places, axis=1)[:, None]
    result.show(places, [marks.SINGULAR] * 1000, BAD, BAD, SINGULAR, 7.0)
    ball, green = nodes.coin.SoSphere(), nodes.coin.SoMaterial()
    ball.radius = 20.0
    green.emissiveColor.setValue(0.0, 1.0, 0.0)
    green.diffuseColor.setValue(0.0, 0.0, 0.0)
    view = scene(nodes.separate(green, ball, result.root))
    view.getCameraNode().height = 12.0 * view.getCameraNode().height.getValue()
    seen = {}
    for bounded in (False, True):
        if bounded:
            result.stand_on(np.full(3, -20.0), np.full(3, 20.0))
            view.redraw()
        pump(300)
        path = screenshot(f"markers_of_a_far_part_{'bounded' if bounded else 'before'}")
        seen[bounded] = pixels(path, (0, 255, 0), 40, view_box())
    assert seen[True] > 3 * max(seen[False], 1), seen
