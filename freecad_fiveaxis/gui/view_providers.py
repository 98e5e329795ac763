# SPDX-License-Identifier: LGPL-2.1-or-later
"""How our document objects show themselves in the tree and in the 3D view.

The paths of these classes stand in saved documents: they are forever. A view keeps no data: it is drawn from
the object's properties and from the core's figures, which are computed anew after a document was opened.
Nothing here imports numpy or pivy before something is drawn.
"""

from __future__ import annotations

from typing import Any

import FreeCAD

from . import foremost, redraw, view_properties
from .views import DrawnView, MapView, PictureView, View, WithPanel, hangs_on, kind_of

CHILDREN = ("markers", "nc_output", "setups", "rest")
"""What stands below its path."""


def markers_of(path: Any) -> Any:
    """Return the Markers object of a path, or None. One that undo took away may still be told to lead here,
    but has no name any more."""
    return next(
        (one for one in path.InList if kind_of(one) == "markers" and one.Path is path and _has_name(one)),
        None,
    )


def _has_name(obj: Any) -> bool:
    """Whether an object is in its document."""
    try:
        return bool(obj.Name) and obj.ViewObject is not None
    except RuntimeError:
        return False


class TessellationView(View):
    """A mesh; FreeCAD itself draws it."""


class NCOutputView(View):
    """An NC file; nothing to draw."""

    def getDisplayModes(self, vobj: Any) -> list[str]:
        """None but FreeCAD's own."""
        return []


class PathView(WithPanel, DrawnView):
    """A toolpath or an audit: the path coloured by deviation, with legend, tool axes, markers and the worst
    blocks' curves."""

    ROWS, SWITCHES = view_properties.PATH, view_properties.PATH_SWITCHES

    def attach(self, vobj: Any) -> None:
        """Nothing drawn yet."""
        self.picture: Any = None
        self.childless = False
        super().attach(vobj)

    def setupContextMenu(self, vobj: Any, menu: Any) -> None:
        """Entries that open the list of findings, and that show or hide parts of the path."""
        from .shown_parts import add_entries

        super().setupContextMenu(vobj, menu)
        add_entries(menu, vobj.Object)

    def claimChildren(self) -> list[Any]:
        """Return the tessellation, markers, NC files and the maps stand below the path in the tree."""
        if not hasattr(self, "obj"):  # FreeCAD asks this before it attaches the view
            return []
        mesh = [one for one in (getattr(self.obj, "Mesh", None),) if kind_of(one) == "tessellation"]
        rest = [one for one in self.obj.InList if kind_of(one) in CHILDREN and one.Path is self.obj]
        return mesh + list(dict.fromkeys(rest))

    def updateData(self, obj: Any, prop: str) -> None:
        """Hide the mesh of a path that is new: the part's own surface is the better ground."""
        super().updateData(obj, prop)
        if prop == "Mesh" and kind_of(obj.Mesh) == "tessellation" and not FreeCAD.isRestoring():
            obj.Mesh.ViewObject.Visibility = False

    def depends_on(self, obj: Any) -> bool:
        """Whether a change of that object may put this path out of date."""
        if not hasattr(self, "obj"):
            return False
        mesh = getattr(self.obj, "Mesh", None)
        base = getattr(mesh, "Base", None)
        part = getattr(self.obj, "Part", None)  # what an audit compares with
        held = (base[0] if isinstance(base, tuple) else base, part, *getattr(self.obj, "Fixtures", ()))
        return hangs_on((self.obj, mesh, *held), obj)

    def adopt(self) -> None:
        """Let the tree ask for the path's children again: it has a new one."""
        self.childless = True
        redraw.soon(self)

    def says_old(self) -> bool:
        """Whether the picture says that it is out of date."""
        return self.picture is not None and bool(self.picture.checked)

    def look_again(self) -> None:
        """Something that the path depends on has changed."""
        if self.picture is not None:
            self.picture.checked = None
        redraw.soon(self)

    def refresh(self) -> None:
        """Draw what the path shows now. Computes it first where that has to be."""
        from .path_picture import Picture

        if self.childless:
            self.childless = False
            self.obj.WorstLine = (
                self.obj.WorstLine
            )  # the tree asks for the children of what has changed, and of nothing else
        view_properties.add_missing(self.vobj, self.ROWS)
        if self.picture is None:
            self.picture = Picture(self.vobj)
            self.root.addChild(self.picture.nodes.root)
            foremost.look()  # the object may be selected already
        self.stand_in_document()
        self.picture.refresh()

    def restyle(self) -> None:
        """Colours or sizes are others now."""
        if self.picture is not None:
            self.picture.styled = False

    def find_picked_marker(self, point: Any) -> int | None:
        """Return the row of the marker that a picked point lies on."""
        return None if self.picture is None else self.picture.nodes.marks.find_picked_marker(point)

    def doubleClicked(self, vobj: Any) -> bool:
        """Open the panel."""
        _edit(self.obj)
        return True


class MarkersView(PictureView):
    """Markers, each of which can be picked, and the label at the largest deviation."""

    ROWS = view_properties.MARKERS

    def make_picture(self) -> Any:
        """Return the markers."""
        from .markers_picture import MarkersPicture

        return MarkersPicture(self.vobj)

    def refresh(self) -> None:
        """Draw the markers."""
        super().refresh()
        if self.obj.Path is not None:
            redraw.soon(self.obj.Path.ViewObject.Proxy)  # the path leaves marks and label to this object

    def find_picked_marker(self, point: Any) -> int | None:
        """Return the row of the marker that a picked point lies on."""
        return None if self.picture is None else self.picture.marks.find_picked_marker(point)

    def path_object(self) -> Any:
        """Return the path that is marked."""
        return self.obj.Path

    def doubleClicked(self, vobj: Any) -> bool:
        """Open the list of findings."""
        self.show_findings()
        return True


class SetupMapView(MapView):
    """A map of setups: a point for each work zero tried, coloured by deviation, the recommended one with its
    value."""

    ROWS = view_properties.SETUPS

    def make_picture(self) -> Any:
        """Return the map."""
        from .setup_picture import SetupPicture

        return SetupPicture(self.vobj)

    def doubleClicked(self, vobj: Any) -> bool:
        """Open the panel."""
        from .panels import setup

        setup.edit(self.obj)
        return True


def _edit(obj: Any) -> None:
    """Open the object's task panel."""
    from .waiting import busy

    with busy():
        from .panels import audit, toolpath

        (audit if kind_of(obj) == "audit" else toolpath).edit(obj)
