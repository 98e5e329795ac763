# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a map of rest material shows itself. Documents save it as :class:`.left_view.LeftMapView`."""

from __future__ import annotations

from typing import Any

import FreeCAD

from . import redraw, view_properties
from .views import PictureView


class RestMapView(PictureView):
    """A map of rest material: the machined surface, each part of it coloured by its height."""

    ROWS = view_properties.REST

    def make_picture(self) -> Any:
        """Return the map."""
        from .rest_picture import RestPicture

        return RestPicture(self.vobj)

    def updateData(self, obj: Any, prop: str) -> None:
        """Hide the path of a map that is new, which would cover it."""
        super().updateData(obj, prop)
        if prop == "Path" and obj.Path is not None and not FreeCAD.isRestoring():
            obj.Path.ViewObject.Visibility = False

    def depends_on(self, obj: Any) -> bool:
        """Whether a change of that object may put this map out of date."""
        path = getattr(getattr(self, "obj", None), "Path", None)
        view = getattr(
            getattr(path, "ViewObject", None), "Proxy", None
        )  # a path that is just deleted has lost its view already
        return path is not None and (obj is path or (view is not None and view.depends_on(obj)))

    def says_old(self) -> bool:
        """Whether the picture says that it is out of date."""
        return self.picture is not None and bool(self.picture.warned)

    def look_again(self) -> None:
        """Something that the map depends on has changed."""
        redraw.soon(self)

    def getElementPicked(self, point: Any) -> str:
        """Return the parts of the surface have no names."""
        return ""

    def path_object(self) -> Any:
        """Return the path whose cutter leaves it."""
        return self.obj.Path

    def doubleClicked(self, vobj: Any) -> bool:
        """Open the list of findings."""
        self.show_findings()
        return True
