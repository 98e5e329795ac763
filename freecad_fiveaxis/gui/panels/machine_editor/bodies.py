# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bodies of a draft: a table of all, and the fields of the one that is chosen there."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import Vector
from freecad_fiveaxis.core.machine.bodies import (
    BASE,
    BOX,
    CONE,
    CYLINDER,
    FILE,
    POINTS,
    RADII,
    SPHERE,
    SPINDLE,
    MachineBody,
)
from freecad_fiveaxis.core.machine.editing import AttachedMeshes, MachineDraft, attach_bodies
from freecad_fiveaxis.gui.panels.fields import ChoiceField, Field, QuantityField, TextField
from freecad_fiveaxis.gui.panels.files import FileField, all_files
from freecad_fiveaxis.gui.panels.folding import FoldingGroup
from freecad_fiveaxis.gui.panels.triple import TripleField
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate

from .attach import AttachFields
from .table import Table, buttons_row, show_items, tool_button

SHAPES = (BOX, CYLINDER, CONE, SPHERE, FILE)
HALF, TALL = 50.0, 50.0
"""mm: half the width, and the height, of a body that is new; it ends at the table's face."""


class BodiesEditor(QtCore.QObject):
    """``group`` is what to show; ``draft`` the machine as it stands, with the meshes ``attached``. ``edited``
    tells that the user changed it, ``refused`` why that cannot be."""

    edited = QtCore.Signal()
    refused = QtCore.Signal(str)

    def __init__(self, attached: AttachedMeshes) -> None:
        super().__init__()
        self.attached, self.attach = attached, AttachFields()
        self.draft: MachineDraft | None = None
        self.filling = False
        self.group = FoldingGroup("bodies", translate("FiveAxis", "Bodies"), "machine-editor_bodies", False)
        heads = (
            translate("FiveAxis", "Name"),
            translate("FiveAxis", "Carried by"),
            translate("FiveAxis", "Shape"),
        )
        self.table = Table("bodies_table", translate("FiveAxis", "Bodies that the tool must not hit"), heads)
        self.add = tool_button("body_add", translate("FiveAxis", "Add"), translate("FiveAxis", "Add a body"))
        self.remove = tool_button(
            "body_remove", translate("FiveAxis", "Remove"), translate("FiveAxis", "Remove the chosen body")
        )
        self.fields: dict[str, Field] = {field.name: field for field in _fields()}
        self.group.body.add_wide(self.table)
        self.group.body.add_wide(buttons_row(self.add, self.remove))
        self.group.body.add_wide(self.attach.group)
        self.rows = {name: self.group.body.add(field) for name, field in self.fields.items()}
        self._connect()

    def _connect(self) -> None:
        for name, field in self.fields.items():
            field.edited.connect(lambda name=name: self._change(name))
        self.table.itemSelectionChanged.connect(self._fill)
        self.remove.clicked.connect(lambda *_: self._remove())
        menu = QtWidgets.QMenu(self.add)
        for shape in SHAPES:
            menu.addAction(shape_label(shape)).triggered.connect(lambda *_, shape=shape: self._add(shape))
        self.add.setPopupMode(QtWidgets.QToolButton.InstantPopup)
        self.add.setMenu(menu)
        self.attach.found.connect(self._attach)
        self.attach.refused.connect(self.refused)

    @property
    def body(self) -> MachineBody | None:
        """The chosen body."""
        at = self.table.at()
        return self.draft.bodies[at] if self.draft is not None and 0 <= at < len(self.draft.bodies) else None

    def show_draft(self, draft: MachineDraft, at: int | None = None) -> None:
        """Show a draft, its body ``at`` chosen; None: the same row as before."""
        self.draft = draft
        self.table.show_rows([self._cells(body) for body in draft.bodies], at)
        self._fill()

    def _cells(self, body: MachineBody) -> tuple[str, ...]:
        carrier = "–" if body.carrier == BASE else carrier_label(body.carrier)
        attached = self.attached.holds(body.file)
        return body.name, carrier, translate("FiveAxis", "attached") if attached else shape_label(body.shape)

    def follow(self, draft: MachineDraft) -> None:
        """Show a draft whose axes were changed: bodies go with their axes."""
        if self.draft is None or draft.bodies != self.draft.bodies or draft.letters() != self.draft.letters():
            self.show_draft(draft)
        self.draft = draft

    def _fill(self) -> None:
        """Put the chosen body into the fields."""
        body, draft = self.body, self.draft
        if draft is None:
            return
        self.filling = True
        carriers = [(one, carrier_label(one)) for one in (BASE, *draft.letters(), SPINDLE)]
        show_items(self.fields["body_carrier"], carriers)
        self.attach.show_carriers(carriers)
        shown = {"body_name", "body_carrier", "body_clearance"} | (
            self._sizes(body) if body is not None else set()
        )
        for name, row in self.rows.items():
            for widget in row:
                widget.setVisible(body is not None and name in shown)
        if body is not None:
            for name in shown:
                self.fields[name].show_value(_value(body, name))
        self.remove.setEnabled(body is not None)
        self.filling = False
        self.group.show_state(str(len(draft.bodies)) if draft.bodies else translate("FiveAxis", "none"))

    def _sizes(self, body: MachineBody) -> set[str]:
        """Return the fields of a body's shape; none of a mesh that has no file of the user's yet."""
        return set() if self.attached.holds(body.file) else _sizes(body.shape)

    def _change(self, name: str) -> None:
        body, draft = self.body, self.draft
        if self.filling or body is None or draft is None:
            return
        new, at = _change_body(body, name, self.fields[name].value()), self.table.at()
        if new == body:
            return
        self.draft = replace(draft, bodies=(*draft.bodies[:at], new, *draft.bodies[at + 1 :]))
        self.table.show_cells(at, self._cells(new))
        self.edited.emit()

    def _add(self, shape: str) -> None:
        if self.draft is not None:
            bodies = (*self.draft.bodies, new_body(self.draft, shape))
            self._put(replace(self.draft, bodies=bodies), len(bodies) - 1)

    def _attach(self, surfaces: list[tuple[str, Mesh]]) -> None:
        if self.draft is None:
            return
        try:
            draft = attach_bodies(self.draft, surfaces, self.attach.carrier, self.attached)
        except FiveAxisError as error:
            self.refused.emit(wording.localize(error))
            return
        self._put(draft, len(draft.bodies) - 1)

    def _remove(self) -> None:
        at = self.table.at()
        if self.draft is not None and at >= 0:
            self._put(replace(self.draft, bodies=(*self.draft.bodies[:at], *self.draft.bodies[at + 1 :])), at)

    def _put(self, draft: MachineDraft, at: int) -> None:
        self.show_draft(draft, at)
        self.edited.emit()


def new_body(draft: MachineDraft, shape: str) -> MachineBody:
    """Return a body of that shape on the base, under the table's face, with a name of its own."""
    names = {body.name for body in draft.bodies}
    label = shape_label(shape)
    name = next(one for at in range(1, len(names) + 2) if (one := f"{label} {at}") not in names)
    x, y, _ = draft.gauge_point
    top = draft.table or 0.0
    low, high = (x, y, top - TALL), (x, y, top)
    points: dict[str, tuple[Vector, ...]] = {
        BOX: ((x - HALF, y - HALF, top - TALL), (x + HALF, y + HALF, top)), CYLINDER: (low, high),
        CONE: (low, high),
        SPHERE: ((x, y, top - HALF),), FILE: (),
    }  # fmt: skip
    radii = {BOX: (), CYLINDER: (HALF,), CONE: (HALF, 0.5 * HALF), SPHERE: (HALF,), FILE: ()}
    return MachineBody(name, BASE, shape, points[shape], radii[shape])


def shape_label(shape: str) -> str:
    """Return what a shape is called."""
    labels = {
        BOX: translate("FiveAxis", "box"), CYLINDER: translate("FiveAxis", "cylinder"),
        CONE: translate("FiveAxis", "cone"),
        SPHERE: translate("FiveAxis", "sphere"), FILE: translate("FiveAxis", "STL file"),
    }  # fmt: skip
    return str(labels[shape])


def carrier_label(carrier: str) -> str:
    """Return what carries a body, in a word."""
    labels = {
        BASE: translate("FiveAxis", "nothing, it stands still"),
        SPINDLE: translate("FiveAxis", "the spindle"),
    }
    return str(labels.get(carrier, carrier))


def _sizes(shape: str) -> set[str]:
    """Return the fields of a shape."""
    if shape == FILE:
        return {"body_file"}
    return {f"body_{name}" for name in (*POINTS[shape], *RADII[shape])}


def _value(body: MachineBody, name: str) -> Any:
    """Return what a field shows of a body."""
    key = name.removeprefix("body_")
    points = dict(zip(POINTS.get(body.shape, ()), body.points, strict=False))
    sizes = points | dict(zip(RADII.get(body.shape, ()), body.radii, strict=False))
    return sizes[key] if key in sizes else getattr(body, key)


def _change_body(body: MachineBody, name: str, value: Any) -> MachineBody:
    """Return the body with another value."""
    key = name.removeprefix("body_")
    points, radii = POINTS.get(body.shape, ()), RADII.get(body.shape, ())
    if key in points:
        return replace(
            body,
            points=tuple(
                tuple(value) if key == one else old for one, old in zip(points, body.points, strict=True)
            ),
        )
    if key in radii:
        return replace(
            body,
            radii=tuple(value if key == one else old for one, old in zip(radii, body.radii, strict=True)),
        )
    return replace(body, **{key: value})


def _fields() -> list[Field]:
    place = translate("FiveAxis", "In machine coordinates, with all axes at zero")
    stl = ";;".join([translate("FiveAxis", "Meshes (*.stl)"), all_files()])
    return [
        TextField("body_name", translate("FiveAxis", "What findings call the body")),
        ChoiceField("body_carrier", [], translate("FiveAxis", "The axis of the table that it moves with, or "
            "the spindle")),
        TripleField("body_low", "point", place),
        TripleField("body_high", "point", place),
        TripleField("body_centre", "point", place),
        QuantityField("body_radius", "length"),
        QuantityField("body_low_radius", "length"),
        QuantityField("body_high_radius", "length"),
        FileField("body_file", translate("FiveAxis", "Choose the mesh of the body"), stl,
                  translate("FiveAxis", "An STL in mm, in machine coordinates with all axes at zero")),
        QuantityField("body_clearance", "length", translate("FiveAxis", "What comes nearer to it than this "
            "is told; 0: nothing")),
    ]  # fmt: skip
