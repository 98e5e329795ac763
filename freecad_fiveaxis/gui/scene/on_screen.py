# SPDX-License-Identifier: LGPL-2.1-or-later
"""Legends and labels as nodes: they find their places anew in every frame, from what else is drawn in the
same view.

A view has one legend, that of the foremost of the objects which are drawn in it; the others' would bury the
part. Whatever is hidden, deleted or in another document is not drawn, so it asks for nothing: the next one's
legend comes by itself. It stands at the left, where no panel of FreeCAD 1.1 lies over the view, and labels go
out of its way, and of such panels'. A label stands beside its place with a line to it, which is solid where
the place is seen, and dashed where the part lies before it, as a hidden edge in a drawing; where there is no
room, the less important labels are left out.

All of it is drawn over everything else, cannot be picked, and is not part of the scene's box.
"""

from __future__ import annotations

import itertools
import weakref
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from pivy import coin

from freecad_fiveaxis.gui import qt

from . import layout, nodes
from .covers import find_covered_boxes
from .overlay import INK, PAPER, Legend, image, label_picture, legend_picture

_CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
MOST_VIEWS = 16
"""So many views are remembered."""
LEADER = (PAPER[0] / 255.0, PAPER[1] / 255.0, PAPER[2] / 255.0)
BRIGHT = (INK[0] / 255.0, INK[1] / 255.0, INK[2] / 255.0)
HIDDEN = 0x0F0F
"""Dashes of a line to a place behind the part."""
BURIED = 0.03
"""A place this share of the scene's depth below what is seen is seen as well: so far markers come through a
surface."""


class Label(NamedTuple):
    """A text at a ``place`` (3,) mm of the scene; ``colour`` of the bar at its side, that of its marker; None
    for none."""

    place: Sequence[float]
    text: str
    colour: nodes.Colour | None = None


Rank = tuple[bool, int]
"""Of a legend: whether its object is selected, and a number that is the higher the later it was shown or
selected."""
_numbers = itertools.count()


class _View:
    """The boxes (n, 4) pixels that stand in a view, by who drew them: in this frame, and in the one before.
    ``legends``: the ranks of the legends that are drawn in it, of which the highest leads; ``leader``: which
    one led in the frame before. ``middles``: of the parts, by who knows of them.
    ``ended``: what is drawn over everything else is being drawn, so all have their places."""

    def __init__(self) -> None:
        self.boxes: dict[int, np.ndarray] = {}
        self.before: dict[int, np.ndarray] = {}
        self.legends: dict[int, Rank] = {}
        self.leader: int | None = None
        self.middles: dict[int, np.ndarray] = {}
        self.ended = False

    def begin(self) -> None:
        """Somebody asks for a place: after the end of a frame that is the beginning of the next one."""
        if self.ended:
            self.leader = max(self.legends, key=self.legends.__getitem__, default=None)
            self.before, self.boxes, self.legends, self.ended = self.boxes, {}, {}, False
            self.middles = {item: middle for item, middle in self.middles.items() if item in self.before}

    def leads(self, legend: int) -> bool:
        """Whether no other legend of this frame has a higher rank; all have asked when ``ended``."""
        return legend in self.legends and self.legends[legend] == max(self.legends.values())

    def find_taken(self, item: int) -> np.ndarray:
        """Return what others have taken in this frame."""
        return np.concatenate([layout.NONE, *(boxes for other, boxes in self.boxes.items() if other != item)])

    def later(self, item: int) -> np.ndarray:
        """Return what stood in the frame before and may come again after the item."""
        rest = [boxes for other, boxes in self.before.items() if other != item and other not in self.boxes]
        return np.concatenate([layout.NONE, *rest])


_views: dict[int, _View] = {}


def _view_of(action: Any) -> _View:
    root = int(action.getCurPath().getHead().this)
    while root not in _views and len(_views) >= MOST_VIEWS:
        _views.pop(next(iter(_views)))
    return _views.setdefault(root, _View())


class _Overlay:
    """Nodes that are placed in pixels when a frame begins; ``root`` goes into the scene."""

    def __init__(self) -> None:
        self.camera, self.shown = coin.SoOrthographicCamera(), _build_moving_group()
        self.camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        self.camera.nearDistance, self.camera.farDistance = 0.0, 2.0
        over, placing, aiming = coin.SoAnnotation(), coin.SoCallback(), coin.SoCallback()
        over.renderCaching = coin.SoSeparator.OFF
        for child in (
            nodes.unpickable(),
            coin.SoResetTransform(),
            nodes.flat(),
            _depth(tested=False),
            self.camera,
            self.shown,
        ):
            over.addChild(child)
        placing.setCallback(_place, weakref.ref(self))
        aiming.setCallback(_aim)
        self.root = coin.SoGroup()
        for child in (placing, nodes.without_box(over), aiming):
            self.root.addChild(child)
        self.camera.enableNotify(False)  # what a frame changes must not ask for the next frame

    def place(self, action: Any) -> None:
        """Find the places for this frame."""
        pixels = action.getViewportRegion().getViewportSizePixels()
        size = int(pixels[0]), int(pixels[1])
        self.camera.position.setValue(size[0] / 2.0, size[1] / 2.0, 1.0)
        self.camera.height, self.camera.aspectRatio = float(size[1]), size[0] / max(size[1], 1)
        view = _view_of(action)
        view.begin()
        view.boxes[id(self)] = self.arrange(action, size, view)

    def arrange(self, action: Any, size: tuple[int, int], view: _View) -> np.ndarray:
        """Move the nodes to their places; returns the boxes (n, 4) that they take in a view of ``size``."""
        raise NotImplementedError

    def settle(self, view: _View) -> None:
        """All others have asked for their places in this frame."""


def _build_moving_group(*children: Any) -> Any:
    """Return a group whose nodes move within a frame, unheard: nothing of it is kept for the next one."""
    separator = nodes.separate(*children)
    separator.renderCaching = separator.renderCulling = coin.SoSeparator.OFF
    return separator


def _place(overlay: Any, action: Any) -> None:
    """Coin comes here twice a frame: when it goes through the scene, and before it draws what lies over
    everything else."""
    found = overlay()
    if found is None or not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
        return
    drawing = action if hasattr(action, "isRenderingDelayedPaths") else coin.cast(action, "SoGLRenderAction")
    if drawing.isRenderingDelayedPaths():
        view = _view_of(drawing)
        view.ended = True
        found.settle(view)
    else:
        found.place(drawing)


def _aim(_data: Any, action: Any) -> None:
    """Aim the mouse's ray at the scene again: an overlay has a camera of its own, and Coin aims the mouse's
    ray anew at every camera it meets. Aimed with that one, it would miss all that comes later in the scene:
    here it is aimed once more, with the view's camera."""
    if action.isOfType(coin.SoRayPickAction.getClassTypeId()):
        picking = action if hasattr(action, "computeWorldSpaceRay") else coin.cast(action, "SoRayPickAction")
        picking.computeWorldSpaceRay()


class LegendBox(_Overlay):
    """A legend, or none; seen where it leads in its view. ``chosen``: its object is selected. ``box``: where
    it was seen last."""

    def __init__(self) -> None:
        super().__init__()
        self.size, self.corner = (0, 0), coin.SoTranslation()
        self.switch = nodes.switch(_build_moving_group())
        self.corner.enableNotify(False)
        self.chosen, self.number, self.claimed, self.box = False, next(_numbers), layout.NONE, layout.NONE

    def show(self, legend: Legend | None) -> None:
        """Show a legend; None for none."""
        self.shown.removeAllChildren()
        self.size = (0, 0)
        if legend is not None:
            picture = legend_picture(legend)
            self.size = picture.width(), picture.height()
            self.switch = nodes.switch(_build_moving_group(self.corner, image(picture)))
            self.switch.enableNotify(False)
            self.shown.addChild(self.switch)

    def come_forward(self, chosen: bool | None = None) -> None:
        """Show this legend, of those in its view, from now on: the object was shown, or selected
        (``chosen``)."""
        self.chosen, self.number = self.chosen if chosen is None else chosen, next(_numbers)
        self.root.touch()

    def step_back(self) -> None:
        """Leave the legend's place to others: the object is no longer selected."""
        self.chosen = False
        self.root.touch()

    def arrange(self, action: Any, size: tuple[int, int], view: _View) -> np.ndarray:
        """Return the legend's box, where it led in the frame before: only when all have asked it is known
        which one leads in this."""
        self.claimed = layout.NONE
        if self.size[0]:
            view.legends[id(self)] = self.chosen, self.number
            corner = layout.legend_place(self.size, size)
            self.corner.translation.setValue(*corner, 0.0)
            self.claimed = np.array([[*corner, corner[0] + self.size[0], corner[1] + self.size[1]]])
        return self.claimed if view.leader == id(self) else layout.NONE

    def settle(self, view: _View) -> None:
        """Be seen if this legend leads."""
        leads = view.leads(id(self))
        nodes.turn(self.switch, leads)
        self.box = view.boxes[id(self)] = self.claimed if leads else layout.NONE
        if not np.array_equal(self.box, view.before.get(id(self), layout.NONE)):
            qt.later(self.root.touch)  # labels know of it in the next frame, which nobody else may ask for


class Labels(_Overlay):
    """Texts at places of the scene, the most important first. ``boxes`` (n, 4) pixels: where they stood last;
    NaN: not shown."""

    def __init__(self) -> None:
        super().__init__()
        self.places, self.sizes = np.zeros((0, 3)), np.zeros((0, 2))
        self.slots, self.boxes, self.part = np.zeros(0, int), layout.NONE, np.zeros((0, 3))
        self.corners: list[Any] = []
        self.switches: list[Any] = []
        self.ends, self.lines = coin.SoVertexProperty(), coin.SoLineSet()
        self.lines.vertexProperty = self.ends
        for node in (self.ends, self.lines):
            node.enableNotify(False)
        self.leaders = _build_moving_group(
            _build_moving_group(nodes.colour(LEADER), nodes.style(3.0, pattern=HIDDEN), self.lines),
            _build_moving_group(nodes.colour(BRIGHT), nodes.style(1.0, pattern=HIDDEN), self.lines),
            _build_moving_group(_depth(tested=True), nodes.colour(LEADER), nodes.style(3.0), self.lines),
            _build_moving_group(_depth(tested=True), nodes.colour(BRIGHT), nodes.style(1.0), self.lines),
        )

    def show(self, labels: Sequence[Label]) -> None:
        """Show these labels."""
        pictures = [label_picture(label.text, label.colour) for label in labels]
        self.sizes = np.array([(picture.width(), picture.height()) for picture in pictures], float).reshape(
            -1, 2
        )
        self.slots, self.boxes = np.full(len(labels), -1), np.full((len(labels), 4), np.nan)
        self.corners = [coin.SoTranslation() for _ in labels]
        self.switches = [
            nodes.switch(_build_moving_group(corner, image(picture)))
            for corner, picture in zip(self.corners, pictures, strict=True)
        ]
        self.shown.removeAllChildren()
        if labels:
            self.shown.addChild(self.leaders)
        for node in (*self.corners, *self.switches):
            node.enableNotify(False)
        for switch in self.switches:
            self.shown.addChild(switch)
        self.move([label.place for label in labels])

    def stand_beside(self, low: Any, high: Any) -> None:
        """No label of the view is to lie over the middle of the part between two corners (3,) mm, as long as
        there is room."""
        ends = np.stack([np.asarray(low, float), np.asarray(high, float)])
        self.part = ends[_CORNERS, [0, 1, 2]]

    def move(self, places: Any) -> None:
        """Let the labels speak of other places (n, 3) mm."""
        self.places = np.asarray(places, float).reshape(-1, 3)

    def arrange(self, action: Any, size: tuple[int, int], view: _View) -> np.ndarray:
        """Return the boxes of the labels that have room."""
        clip = clip_from_place(action.getState())
        view.middles[id(self)] = layout.middle_of(layout.project_places(self.part, clip, size))
        if not len(self.places):
            return layout.NONE
        anchor = layout.project_places(self.places, clip, size)
        taken = np.concatenate([view.find_taken(id(self)), view.later(id(self)), find_covered_boxes(size)])
        middle = np.concatenate([layout.NONE, *view.middles.values()])
        self.boxes, self.slots = layout.label_places(anchor, self.sizes, size, taken, self.slots, middle)
        seen = self.slots >= 0
        for switch, corner, box, on in zip(
            self.switches, self.corners, self.boxes.tolist(), seen.tolist(), strict=True
        ):
            nodes.turn(switch, on)
            if on:
                corner.translation.setValue(box[0], box[1], 0.0)
        self._lead(anchor[seen], self.boxes[seen], layout.depths(self.places[seen], clip))
        return self.boxes[seen]

    def _lead(self, anchor: np.ndarray, box: np.ndarray, depth: np.ndarray) -> None:
        """Draw the lines from the labels to their places, all along as far away (0 to 1) as the place is."""
        ends = np.zeros((2 * len(anchor), 3), np.float32)
        ends[0::2, :2], ends[1::2, :2] = anchor, layout.leader_ends(anchor, box)
        ends[:, 2] = np.repeat(1.0 - 2.0 * (1.0 - BURIED) * np.clip(depth, 0.0, 1.0), 2)
        self.ends.vertex.setNum(len(ends))
        self.lines.numVertices.setNum(len(anchor))
        if len(ends):
            self.ends.vertex.setValues(0, len(ends), ends)
            self.lines.numVertices.setValues(0, len(anchor), np.full(len(anchor), 2, np.int32))


def _depth(tested: bool) -> Any:
    """Whether what follows is hidden by what is drawn nearer; it hides nothing itself."""
    depth_buffer = coin.SoDepthBuffer()
    depth_buffer.test, depth_buffer.write = tested, False
    return depth_buffer


def clip_from_place(state: Any) -> np.ndarray:
    """From places of the scene, as they stand where the traversal is, to the view's cube (4, 4); Coin
    multiplies rows."""
    model = np.array(coin.SoModelMatrixElement.get(state).getValue())
    return np.asarray(model @ np.array(coin.SoViewVolumeElement.get(state).getMatrix().getValue()))
