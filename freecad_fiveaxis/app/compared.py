# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the document that an audit compares with, or a fixture: a solid, body, compound or mesh, about
the work zero.

digest    tells a changed part from the old one without meshing it, for it is asked for at every look at the
          audit.
stl       the part's surface, meshed as that of a tool path; made only where the audit is computed.
"""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Sequence
from typing import Any, NamedTuple

from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import say

from . import arguments, selection
from .convert import facets_of, move_to_zero
from .tessellation import ANGULAR, LINEAR, mesh_base

DIGITS = 9
"""Of an area or a volume: a document that is opened again has the last ones different."""


class Seen:
    """The shape that was looked at last, and its checksum: volumes take long, and the same shape has the same
    one."""

    shape: Any = None
    place: tuple[float, ...] = ()
    checksum = b""

    def checksum_of(self, shape: Any) -> bytes:
        """Return a checksum of a shape as it stands in the document."""
        place = tuple(shape.Placement.Matrix.A)
        if self.shape is None or place != self.place or not self.shape.isPartner(shape):
            self.shape, self.place, self.checksum = shape, place, _checksum(shape)
        return self.checksum


class Part(NamedTuple):
    """The object ``base``, relative to ``zero`` (mm, document); ``seen``: what the audit remembers of it;
    ``stl``: its surface, once it is meshed."""

    base: Any
    zero: tuple[float, float, float]
    seen: Seen
    stl: bytes = b""

    def digest(self) -> bytes:
        """Return a checksum that a change of the part, or of the zero, changes. Raises SelectionError."""
        if selection.is_mesh(self.base):
            return facets_of(self.base, self.zero).digest()
        shape = selection.solids(self.base)[0]
        return hashlib.sha256(self.seen.checksum_of(shape) + _text(self.zero).encode()).digest()

    def mesh(self, progress: Progress) -> Part:
        """Return the same with its surface as a binary STL. Raises FiveAxisError."""
        return self._replace(stl=self._stl(progress))

    def _stl(self, progress: Progress) -> bytes:
        if selection.is_mesh(self.base):
            return facets_of(self.base, self.zero).stl()
        mesh = mesh_base(self.base, (), LINEAR, ANGULAR, progress)[0]
        mesh.Placement = move_to_zero(mesh.Placement, self.zero)
        with tempfile.TemporaryDirectory() as folder:  # FreeCAD 0.20 writes nothing into a stream
            path = os.path.join(folder, "part.stl")
            mesh.write(path)
            return read_bytes(path, "part")


def check_part(doc: Any, part: Any) -> Any:
    """Return the part, or None where none is given. Raises SelectionError for what is neither solid nor mesh
    of the document."""
    if part is None:
        return None
    if getattr(part, "Document", None) is None or not hasattr(part, "Label"):
        raise selection.SelectionError(say("Nothing is selected: {what}.", what=selection.WHAT), part)
    if part.Document.Name != doc.Name:
        raise selection.SelectionError(
            say(
                "{label} is in another document: select something in {document}.",
                label=part.Label,
                document=doc.Label,
            ),
            part.Label,
        )
    if not selection.is_mesh(part):
        selection.solids(part)
    return part


def check_held(doc: Any, given: Any) -> list[Any]:
    """Return the objects that hold a part: a list of them, a single one, or None. Raises SelectionError for
    what is neither solid nor mesh of the document."""
    return [check_part(doc, one) for one in arguments.objects(given)]


def find_held_parts(
    fixtures: Sequence[Any], zero: tuple[float, float, float], seen: dict[str, Seen]
) -> tuple[Part, ...]:
    """Give objects that hold a part relative to ``zero`` (mm, document); ``seen``: what is remembered of
    them, by their names."""
    return tuple(Part(one, zero, seen.setdefault(one.Name, Seen())) for one in fixtures)


def fixture_names(fixtures: Sequence[Any]) -> dict[str, list[str]]:
    """Give the option by which the core knows fixtures of the document; none where there are none."""
    return {"fixture": [f"{one.Label}.stl" for one in fixtures]} if fixtures else {}


def parts_of(doc: Any) -> list[Any]:
    """Return the solids and meshes of a document, in its order; of a body not the features, of a tool path
    not its tessellation."""
    inner = {one.Name for body in doc.findObjects("PartDesign::Body") for one in body.Group}
    return [obj for obj in doc.Objects if obj.Name not in inner and _is_part(obj)]


def _is_part(obj: Any) -> bool:
    if selection.is_mesh(obj):
        return not hasattr(obj, "LinearDeflection")
    return bool(getattr(getattr(obj, "Shape", None), "Solids", None))


def _checksum(shape: Any) -> bytes:
    """Not of its box, which OpenCASCADE finds otherwise once the shape is meshed for the view."""
    corners = [_text(corner.Point) for corner in shape.Vertexes]
    features = (len(shape.Faces), corners, f"{shape.Volume:.{DIGITS}g}", f"{shape.Area:.{DIGITS}g}")
    return hashlib.sha256(repr(features).encode()).digest()


def _text(numbers: Sequence[float]) -> str:
    """Lengths to a millionth of a millimetre; there is one zero."""
    return " ".join(f"{round(number, 6) + 0.0:.6f}" for number in numbers)
