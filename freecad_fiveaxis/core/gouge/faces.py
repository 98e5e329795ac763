# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facets of a part that lie on given faces: what a second STL file says is to be machined.

faces     a mesh of its own, open or not: faces of the part as the CAD system wrote them, perhaps in other
          facets.
sag       of a facet: how far the curved surface that it stands for may lie off it, mm; from the angle to its
          neighbours.
on        the faces lie a facet's corners and its middle, to the tolerance and the sags of both, where at its
          middle both point the same way.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Area, Length, Number, Option, Sentence, Template, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.tool.body import Body, round_piece

from .known_depths import RELATIVE, Entries
from .search import find_entries
from .swept_motion import still_positions

EDGE = math.radians(40.0)
"""Facets that differ by more meet in an edge of the part; by less, they stand for one curved surface."""

ALIKE = math.cos(math.radians(45.0))
"""Cosine of the angle by which a facet and the face that it lies on may differ, for the faces' facets may be
coarser."""

MISSED = 0.02
"""A share of the faces' area that may be missing before it is told: at borders other facets cover other
ground."""

MACHINED = Template(
    "{count} facets of {area} ({share} % of the part) lie on {name} and are machined. The others are not;"
    " {gouge} keeps the tool out of all of them."
)
AVOIDED = Template(
    "{count} facets of {area} ({share} % of the part) lie on {name} and are not machined; {gouge} keeps the "
    "tool out of them."
)


def facets_on(
    mesh: Mesh,
    faces: Mesh,
    tolerance: float,
    name: str = "the faces",
    progress: Progress = silent,
    machined: bool = True,
) -> tuple[Bools, tuple[Finding, ...]]:
    """Find the facets (f,) of the mesh that lie on ``faces``, and how much area that is; ``tolerance`` mm,
    above 0. ``machined``: whether these are what is machined, or what is not.

    Raises SettingsError where none does.
    """
    sag, given = facet_sags(mesh), facet_sags(faces)
    reach = tolerance + float(sag.max()) + float(given.max())
    low, high = faces.vertex.min(axis=0) - reach, faces.vertex.max(axis=0) + reach
    near = np.flatnonzero(((mesh.vertex >= low) & (mesh.vertex <= high)).all(axis=1)[mesh.face].all(axis=1))
    used = np.unique(mesh.face[near])
    middle = mesh.vertex[mesh.face[near]].mean(axis=1)
    found = _standing(np.concatenate([mesh.vertex[used], middle]), faces, reach, tolerance, progress)
    off = np.where(
        found.facet >= 0, reach - found.depth - given[found.facet], np.inf
    )  # what the face's own sag does not explain
    corner = np.searchsorted(used, mesh.face[near])
    farthest = np.maximum(off[corner].max(axis=1), off[len(used) :])
    there = farthest <= tolerance + sag[near] + RELATIVE * reach
    alike = (mesh.normal[near] * faces.normal[found.facet[len(used) :]]).sum(axis=1)
    chosen = np.zeros(len(mesh.face), np.bool_)
    chosen[near[there & (alike > ALIKE)]] = True
    if not chosen.any():
        raise SettingsError(_none(name, tolerance, bool((there & (alike < -ALIKE)).any())), name)
    return chosen, _report_area(mesh, faces, chosen, name, machined)


def _standing(point: Floats, faces: Mesh, reach: float, tolerance: float, progress: Progress) -> Entries:
    """Return the faces about points (n, 3): how deep they go into a ball of radius ``reach`` mm that stands
    there."""
    upward = np.tile([0.0, 0.0, 1.0], (len(point), 1))
    ball = Body((round_piece(0.0, reach, 0.0),))
    return find_entries(
        ball,
        facet_tree(faces),
        still_positions(point, upward),
        1e-6 * tolerance,
        0.01 * tolerance,
        progress=progress,
    )


def facet_sags(mesh: Mesh) -> Floats:
    """Return the sag (f,) mm: of an arc over the longest side that turns as far as the surface does to a
    neighbour. Edges count not."""
    one, two = mesh.coedge_face.T
    turn = np.arccos(np.clip((mesh.normal[one] * mesh.normal[two]).sum(axis=1), -1.0, 1.0))
    turn[(two < 0) | (turn > EDGE)] = 0.0
    corner = mesh.vertex[mesh.face]
    longest = np.linalg.norm(corner - np.roll(corner, 1, axis=1), axis=2).max(axis=1)
    return np.asarray(0.5 * longest * np.tan(0.25 * turn[mesh.face_coedge].max(axis=1)))


def _none(name: str, tolerance: float, opposite: bool) -> Sentence:
    if opposite:
        return say(
            "{name} lies on the part, but its facets look into it; export the faces again, with their "
            "normals outward",
            name=name,
        )
    return say(
        "no facet of the part lies on {name} within {tolerance}; export the faces in the part's own place "
        "and units, or raise the tolerance",
        name=name,
        tolerance=Length(tolerance),
    )


def _report_area(mesh: Mesh, faces: Mesh, chosen: Bools, name: str, machined: bool) -> tuple[Finding, ...]:
    areas = mesh.area
    area, whole, wanted = float(areas[chosen].sum()), float(areas.sum()), float(faces.area.sum())
    words = MACHINED if machined else AVOIDED
    text = words.say(
        count=int(chosen.sum()),
        area=Area(area, ".6g"),
        share=Number(100.0 * area / whole, ".3g"),
        name=name,
        gouge=Option("gouge"),
    )
    reports = [report_finding(Code.FACES_CHOSEN if machined else Code.FACES_AVOIDED, text, area)]
    if area < (1.0 - MISSED) * wanted:
        text = say(
            "{name} has {wanted}, but only {area} of the part lie on it. Export the faces from the same "
            "solid, with as fine facets, or raise the tolerance.",
            name=name,
            wanted=Area(wanted, ".6g"),
            area=Area(area, ".6g"),
        )
        reports.append(report_finding(Code.FACES_MISSED, text, wanted - area, MISSED * wanted))
    return tuple(reports)
