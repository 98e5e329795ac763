# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces to avoid of which the tool keeps an allowance: which places of the surface the cutter cannot touch
for that.

corner ball   the ball of the cutter's corner radius that touches the surface at a contact: of a ball end the
              whole end, of other cutters a part of it whatever the axis. Where it comes nearer than the
              allowance, no axis helps.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Area, Length, Number, Point, Template
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_triangles
from freecad_fiveaxis.core.geometry.nearest import Facets, Pieces, nearest, search

TOUCHING = 1e-6
"""mm; a ball that is so much too near keeps the allowance."""

ON_STRIP = Template(
    "{area} ({share} % of the part) beside the faces to avoid are not cut, as at {place}: the cutter would "
    "come nearer to these than {allowance}. Cut them with a smaller cutter, or with a smaller allowance."
)
ON_FACETS = Template(
    "{area} ({share} % of the part) on facets of their own, as at {place}, lie so near to the faces to "
    "avoid that they are left out: the cutter would come nearer to these than {allowance}."
)


@dataclass(frozen=True, eq=False)
class KeepOff:
    """``faces``: the facets to avoid alone, a mesh of its own; ``some`` (f,): which of the part these are;
    ``allowance`` mm, above 0; ``corner`` mm: the cutter's corner radius."""

    faces: Mesh
    some: Bools
    allowance: float
    corner: float

    def __post_init__(self) -> None:
        corner = np.ascontiguousarray(self.faces.vertex[self.faces.face].transpose(1, 0, 2))
        facets = Facets(corner, self.faces.normal)
        object.__setattr__(self, "_facets", facets)
        object.__setattr__(self, "_pieces", facets.pieces())

    @classmethod
    def of(cls, mesh: Mesh, some: Bools, allowance: float, corner: float) -> KeepOff:
        """Keep off these facets (f,) of the part's mesh."""
        return cls(from_triangles(mesh.vertex[mesh.face[some]]), some, allowance, corner)

    @property
    def least(self) -> float:
        """So near, mm, the middle of the corner ball may come."""
        return self.corner + self.allowance

    def room(self, centre: Floats) -> Floats:
        """How much farther (n,) mm than they must the corner balls about ``centre`` (n, 3) mm are from the
        faces; below 0: they are too near."""
        room = self._sure_room(centre)
        near = np.flatnonzero(room < self.least)
        if len(near):
            room[near] = self._exact_room(centre[near])
        return room

    def _sure_room(self, centre: Floats) -> Floats:
        """Return what the room (n,) mm about ``centre`` (n, 3) is at least; it is more by the pieces' reach
        at most."""
        pieces: Pieces = self._pieces  # type: ignore[attr-defined]
        return pieces.clear_by(centre) - self.least

    def _exact_room(self, centre: Floats) -> Floats:
        pieces, facets = self._pieces, self._facets  # type: ignore[attr-defined]
        return search(centre, pieces, facets.square_distances, nearest, 2)[:, 0] - self.least

    def allows(self, mesh: Mesh, point: Floats, facet: Ints) -> Bools:
        """Which places (k, 3) mm on facets (k,) of the part the corner ball can touch. How much room there is
        is asked only where the nearest piece leaves that open."""
        centre = point + self.corner * mesh.normal[facet]
        room, reach = self._sure_room(centre), self._pieces.reach  # type: ignore[attr-defined]
        open_ = np.flatnonzero((room < -TOUCHING) & (room + reach >= -TOUCHING))
        if len(open_):
            room[open_] = self._exact_room(centre[open_])
        return np.asarray(room >= -TOUCHING)

    def obstacle(self, joined: Mesh) -> Mesh:
        """Return what the tool keeps out of, the part's facets first, with the allowance on those to
        avoid."""
        allowance = np.zeros(len(joined.face))
        allowance[: len(self.some)] = np.where(self.some, self.allowance, 0.0)
        return replace(joined, allowance=allowance)

    def box_with(self, box: tuple[Floats, Floats]) -> tuple[Floats, Floats]:
        """Find the box, low and high corner (3,) mm, about a box and all that is too near to the faces."""
        low, high = self.faces.box
        return np.minimum(box[0], low - self.allowance), np.maximum(box[1], high + self.allowance)


def facets_allowed(keep_off: KeepOff, mesh: Mesh, facets: Bools) -> tuple[Bools, tuple[Finding, ...]]:
    """Find those of ``facets`` (f,) that the corner ball can touch, if only in part, and say what the others
    are. A facet is left out only where that is certain: the room changes no faster than the place does."""
    rows = np.flatnonzero(facets)
    corner = mesh.vertex[mesh.face[rows]]
    middle = corner.mean(axis=1)
    far = np.linalg.norm(corner - middle[:, None], axis=2).max(axis=1)
    out = np.zeros(len(facets), np.bool_)
    out[rows] = keep_off.room(middle + keep_off.corner * mesh.normal[rows]) + far < -TOUCHING
    area = np.where(out, mesh.area, 0.0)
    found = _report(
        Code.FACETS_NEAR_AVOIDED,
        ON_FACETS,
        keep_off,
        mesh,
        float(area.sum()),
        mesh.vertex[mesh.face[int(area.argmax())]].mean(axis=0),
    )
    return facets & ~out, found


def report_strip(
    keep_off: KeepOff, mesh: Mesh, point: Floats, facet: Ints, area: Floats
) -> tuple[Finding, ...]:
    """Say how much area the corner ball cannot touch, of places (k, 3) mm of facets (k,) that stand for
    ``area`` (k,) mm2."""
    out = np.where(keep_off.allows(mesh, point, facet), 0.0, area)
    return _report(
        Code.NEAR_AVOIDED_FACES, ON_STRIP, keep_off, mesh, float(out.sum()), point[int(out.argmax())]
    )


def _report(
    code: Code, words: Template, keep_off: KeepOff, mesh: Mesh, area: float, place: Floats
) -> tuple[Finding, ...]:
    if area == 0.0:
        return ()
    x, y, z = place.tolist()
    text = words.say(
        area=Area(area, ".4g"), share=Number(100.0 * area / float(mesh.area.sum()), ".3g"),
        place=Point((x, y, z), ".6g"),
        allowance=Length(keep_off.allowance),
    )  # fmt: skip
    return (report_finding(code, text, area, 0.0, place=(x, y, z)),)
