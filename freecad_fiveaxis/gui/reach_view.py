# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a reach map shows itself. The path of this class stands in saved documents: it is forever."""

from __future__ import annotations

from typing import Any

import FreeCAD

from . import redraw, view_properties
from .views import MapView, hangs_on, kind_of


class ReachMapView(MapView):
    """A reach map: the part's surface, coloured by what keeps the tool from it."""

    ROWS, SWITCHES = view_properties.REACH, ("ShowAxes", "ShowLegend", "FoldLegend")

    def make_picture(self) -> Any:
        """Return the map."""
        from .reach_picture import ReachPicture

        return ReachPicture(self.vobj)

    def restyle(self) -> None:
        """Draw the axes in the length and colour that they have now."""
        if self.picture is not None:
            self.picture.styled = False

    def claimChildren(self) -> list[Any]:
        """Return a tessellation that no tool path has stands below the map in the tree."""
        mesh: Any = getattr(
            getattr(self, "obj", None), "Mesh", None
        )  # FreeCAD asks this before it attaches the view
        if kind_of(mesh) != "tessellation" or any(
            kind_of(one) in ("toolpath", "audit") for one in mesh.InList
        ):
            return []
        return [mesh]

    def updateData(self, obj: Any, prop: str) -> None:
        """Hide the mesh of a map that is new, which would lie in it."""
        super().updateData(obj, prop)
        if prop == "Mesh" and kind_of(obj.Mesh) == "tessellation" and not FreeCAD.isRestoring():
            obj.Mesh.ViewObject.Visibility = False

    def depends_on(self, obj: Any) -> bool:
        """Whether a change of that object may put this map out of date."""
        own = getattr(self, "obj", None)
        mesh = getattr(own, "Mesh", None)
        base = getattr(mesh, "Base", None)
        needed = (own, mesh, base[0] if isinstance(base, tuple) else base, *getattr(own, "Fixtures", ()))
        return hangs_on(needed, obj)

    def says_old(self) -> bool:
        """Whether the picture says that it is out of date."""
        return self.picture is not None and bool(self.picture.warned)

    def look_again(self) -> None:
        """Something that the map depends on has changed."""
        redraw.soon(self)

    def doubleClicked(self, vobj: Any) -> bool:
        """Open the panel."""
        from .waiting import busy

        with busy():
            from .panels import reach

            reach.edit(self.obj)
        return True
