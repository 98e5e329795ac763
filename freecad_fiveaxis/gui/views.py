# SPDX-License-Identifier: LGPL-2.1-or-later
"""What view providers have in common: drawn when the window is idle, with or without a picture.

Nothing here imports numpy or pivy before something is drawn.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from . import foremost, redraw, view_properties
from .qt import icon, translate

MODE = "Path"
APP = "freecad_fiveaxis.app."
KINDS = {"auditing": "audit", "left": "rest"}
"""The kind of an object by the module of its proxy, where they differ."""


ICONS = {
    "tessellation": "Tessellation", "toolpath": "Toolpath", "audit": "Audit", "markers": "Markers",
    "nc_output": "NCOutput",
    "setups": "SetupMap", "rest": "RestMap", "reach": "ReachMap", "job_setup": "FiveAxis_JobSetup",
}  # fmt: skip


def kind_of(obj: Any) -> str:
    """``toolpath``, ``audit``, ``markers``, ``nc_output``, ``tessellation``, ``setups``, ``rest``, ``reach``;
    empty for objects that are not ours."""
    module = type(getattr(obj, "Proxy", None)).__module__
    name = module[len(APP) :] if module.startswith(APP) else ""
    return KINDS.get(name, name)


IDENTITY = tuple(float(at % 5 == 0) for at in range(16))
"""The rows of a matrix that moves nothing."""
HOLDER = "App::GeoFeatureGroupExtension"
"""What a part or a body is to FreeCAD: it moves what it holds."""


def list_holders(obj: Any) -> list[Any]:
    """Return the parts and bodies that hold the object, the innermost first."""
    found, holder = list[Any](), obj.getParentGeoFeatureGroup()
    while holder is not None:
        found.append(holder)
        holder = holder.getParentGeoFeatureGroup()
    return found


def hangs_on(needed: Iterable[Any], obj: Any) -> bool:
    """Whether the object is one of those needed, or moves one of them with it."""
    there = [one for one in needed if one is not None]
    if any(one is obj for one in there):
        return True
    return bool(obj.hasExtension(HOLDER)) and any(
        obj is holder for one in there for holder in list_holders(one)
    )


class View:
    """What all our view providers have in common."""

    ROWS: tuple[view_properties.Row, ...] = ()

    def __init__(self, vobj: Any) -> None:
        view_properties.add_missing(vobj, self.ROWS)
        vobj.Proxy = self

    def attach(self, vobj: Any) -> None:
        """FreeCAD has made the view object, or has read it from a file."""
        self.vobj, self.obj = vobj, vobj.Object

    def getIcon(self) -> str:
        """Return the icon in the tree."""
        return icon(ICONS.get(kind_of(self.obj), "fiveaxis")) if hasattr(self, "obj") else icon("fiveaxis")

    def dumps(self) -> None:
        """FreeCAD 0.21 and later: nothing to save but the properties."""

    def loads(self, state: Any) -> None:
        """FreeCAD 0.21 and later."""

    def __getstate__(self) -> None:
        """FreeCAD 0.20 knows these two names only."""

    def __setstate__(self, state: Any) -> None:
        """FreeCAD 0.20."""


class DrawnView(View):
    """A view with nodes of ours. They are made when it is first drawn. ``SWITCHES``: properties that only
    show and hide."""

    SWITCHES: tuple[str, ...] = ()

    def attach(self, vobj: Any) -> None:
        """Attach an empty place in the scene, which is filled when the window is idle."""
        from pivy import coin

        super().attach(vobj)
        self.root, self.stand = coin.SoSeparator(), coin.SoMatrixTransform()
        self.root.addChild(self.stand)
        vobj.addDisplayMode(self.root, MODE)
        redraw.soon(self)

    def getDisplayModes(self, vobj: Any) -> list[str]:
        """There is one."""
        return [MODE]

    def getDefaultDisplayMode(self) -> str:
        """Return that one."""
        return MODE

    def setDisplayMode(self, mode: str) -> str:
        """Return that one."""
        return mode

    def refresh(self) -> None:
        """Draw what the object shows now; called when the window is idle."""
        raise NotImplementedError

    def stand_in_document(self) -> None:
        """Draw in the document's coordinates, in which the path is computed, also where the object was put
        into a part, with which FreeCAD would move the drawing."""
        holders = list_holders(self.obj)
        rows = holders[0].getGlobalPlacement().inverse().Matrix.A if holders else IDENTITY
        self.stand.matrix.setValue(*(rows[4 * column + row] for row in range(4) for column in range(4)))

    def updateData(self, obj: Any, prop: str) -> None:
        """Hear that a property of the object has changed. While a document is read, FreeCAD calls this before
        it attaches the view."""
        if hasattr(self, "root"):
            redraw.soon(self)

    def onChanged(self, vobj: Any, prop: str) -> None:
        """Hear that a property of the view has changed."""
        if not hasattr(self, "root") or prop not in ("Visibility", *(row[1] for row in self.ROWS)):
            return
        if prop not in self.SWITCHES:
            self.restyle()
        if prop == "Visibility" and vobj.Visibility:
            self.come_forward()
        redraw.soon(self)

    def come_forward(self) -> None:
        """Show the legend of an object that is shown, in place of the others'."""
        legend = foremost.legend_of(self.obj)
        if legend is not None:
            legend.come_forward()

    def restyle(self) -> None:
        """Draw anew what is drawn, in other colours or sizes."""

    def find_picked_marker(self, point: Any) -> int | None:
        """Return the row of the marker that a picked point lies on."""
        raise NotImplementedError

    def getElementPicked(self, point: Any) -> str:
        """Return the name of what was clicked: a marker is a sub-element."""
        row = self.find_picked_marker(point)
        return "" if row is None else f"Marker{row + 1}"

    def getDetailPath(self, name: str, path: Any, append: bool) -> bool:
        """FreeCAD would light up the sub-element; a marker shows itself in the list of findings instead."""
        return False

    def setupContextMenu(self, vobj: Any, menu: Any) -> None:
        """Add an entry that opens the list of findings, and one that folds the legend where there is one."""
        menu.addAction(translate("FiveAxis", "Show findings")).triggered.connect(
            lambda *_: self.show_findings()
        )
        self.add_fold(menu)

    def add_fold(self, menu: Any) -> None:
        """Add an entry that folds the legend, where there is one."""
        from .shown_parts import FOLD, add_fold

        if hasattr(self.vobj, FOLD):
            add_fold(menu, self.vobj)

    def show_findings(self) -> None:
        """Open the list of findings."""
        from . import findings_panel

        findings_panel.show(self.path_object())

    def path_object(self) -> Any:
        """Return the path that the view is of."""
        return self.obj


class PictureView(DrawnView):
    """A view that is one picture, made when it is first drawn."""

    def attach(self, vobj: Any) -> None:
        """Nothing drawn yet."""
        self.picture: Any = None
        super().attach(vobj)

    def refresh(self) -> None:
        """Draw the picture."""
        view_properties.add_missing(self.vobj, self.ROWS)
        if self.picture is None:
            self.picture = self.make_picture()
            self.root.addChild(self.picture.root)
            foremost.look()  # the object may be selected already
        self.stand_in_document()
        self.picture.refresh()

    def make_picture(self) -> Any:
        """Return the picture: it has a ``root`` and can ``refresh``."""
        raise NotImplementedError


class WithPanel:
    """What an object has that a double click or *Edit* opens a panel of."""

    def doubleClicked(self, vobj: Any) -> bool:
        """Open the panel."""
        raise NotImplementedError

    def setEdit(self, vobj: Any, mode: int = 0) -> bool:
        """Open the panel."""
        if mode:
            return False
        self.doubleClicked(vobj)
        return True

    def unsetEdit(self, vobj: Any, mode: int = 0) -> bool:
        """Return the panel closes itself."""
        return True


class MapView(WithPanel, PictureView):
    """A map that has a panel of its own: it opens by a double click or *Edit*, and closes itself."""

    def getElementPicked(self, point: Any) -> str:
        """Return what is drawn has no names."""
        return ""

    def setupContextMenu(self, vobj: Any, menu: Any) -> None:
        """Add an entry that folds the legend."""
        self.add_fold(menu)
