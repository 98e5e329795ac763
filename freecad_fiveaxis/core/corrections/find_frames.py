# SPDX-License-Identifier: LGPL-2.1-or-later
"""The few tool axes with which a part is cut with locked rotary axes, and which place is cut with which of them.

candidate  a direction that the machine takes up: many, evenly over the sphere, and the part's own main ones; on a machine of one
           rotary axis those that it turns through.
cover      of the candidates the one that frees most places, then the one that frees most of the rest, and so on: first where it
           stands well on the surface, then wherever it is free. Those that the later ones have made needless are taken out.
frame      a direction of the cover. A place is cut in the frame that sees it flattest of those in which the tool is free there.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Area, Number, Point, say
from freecad_fiveaxis.core.collision.obstacles import Reacher
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine.kinematics import Chain, forward
from freecad_fiveaxis.core.passes.frames import Frames

from .axis_field import Freedom, Nodes, even_directions, find_freedom, main_directions, surface_nodes, with_margin
from .facets_with_axis import AxisField, select_facets

MOST = 12
"""Frames, at most."""

WELL = 0.35
"""Cosine to the normal of directions that stand well on a place."""

BETTER = 0.1
"""Of a place: so much more it counts for a direction flat on it, and for an upright one."""

FEW = 0.004
"""Of the places: a frame that sees no more than that besides is not worth its turn."""

PLACES = 8000
"""Places that are given to frames, evenly by area."""

SOONER = 1e-3
"""Of a cosine: by that the earlier of two frames is taken that see a place alike, so that a plane is not cut in both."""

STEPS = 72
"""Positions of a single rotary axis that are tried."""


def find_frames(
    mesh: Mesh, facets: Bools, reacher: Reacher, most: float, count: int = MOST, progress: Progress = silent
) -> tuple[Frames, Bools, tuple[Finding, ...]]:
    """Find at most ``count`` frames for ``facets`` (f,), those of them that are cut in any (f,), and what is left out.

    ``reacher``: tool, machine and table; ``most`` rad: the largest angle from +Z that was wanted. Raises ReachError where
    nothing is left, SettingsError for sizes that no tool has.
    """
    tree, wide = facet_tree(mesh), with_margin(reacher)
    nodes = surface_nodes(mesh, facets, reacher, tree)
    freedom = find_freedom(nodes, wide, tree, candidates(mesh, reacher.kinematics), progress)
    freedom = Freedom(freedom.direction, freedom.free, np.zeros_like(freedom.upright), freedom.met)
    keep, left_out = select_facets(AxisField(nodes, freedom, nodes.normal), mesh, facets, most)
    axis = freedom.direction[find_cover(freedom.free, nodes.normal @ freedom.direction.T, freedom.direction[:, 2], count)]
    places = surface_nodes(mesh, keep, reacher, tree, PLACES)
    frames = _given(places, in_order(axis), wide, tree, progress)
    seen, rows = np.zeros_like(keep), np.flatnonzero(keep)
    seen[rows] = frames.at(mesh.vertex[mesh.face[rows]].mean(axis=1), mesh.normal[rows]) >= 0
    seen[places.facet[frames.frame >= 0]] = True
    return frames, seen, (*left_out, *_unseen(frames, mesh, keep), _told(frames))


def candidates(mesh: Mesh, kinematics: Chain | None) -> Floats:
    """Give the directions (d, 3), unit, that are tried: on a machine of one rotary axis those that it turns through."""
    if kinematics is None or all(axis.fitted for axis in kinematics.axes[3:]):
        return np.concatenate([main_directions(mesh), even_directions()])
    words = np.zeros((STEPS + 1, 5))
    words[:, 3:] = np.linspace(np.maximum(kinematics.low[3:], -math.pi), np.minimum(kinematics.high[3:], math.pi), STEPS + 1)
    return forward(kinematics, words)[1]


def find_cover(free: Bools, cosine: Floats, up: Floats, most: int) -> Ints:
    """Choose at most ``most`` directions (c,) that free most places, of what is ``free`` (n, d) of directions whose ``cosine``
    (n, d) to the places' normals and height ``up`` (d,) are known: of those that free about as many the flatter and more upright.
    """
    better = 1.0 + BETTER * (cosine + up)
    well, chosen = free & (cosine > WELL), list[int]()
    for frees in (well, free):
        left = free.any(axis=1) & ~_freed(frees, chosen)
        while len(chosen) < most and frees.shape[1]:
            best = int(np.where(frees[left], better[left], 0.0).sum(axis=0).argmax())
            if frees[left, best].sum() < max(1.0, FEW * len(free)):
                break
            chosen.append(best)
            left &= ~frees[:, best]
    return np.array(_needed(free, well, chosen), np.int64)


def _freed(free: Bools, chosen: list[int]) -> Bools:
    return np.asarray(free[:, chosen].any(axis=1))


def _needed(free: Bools, well: Bools, chosen: list[int]) -> list[int]:
    """Those chosen without each that frees hardly anything that the others do not free as well."""
    for one in list(chosen):
        rest = [other for other in chosen if other != one]
        alone = (free[:, one] & ~_freed(free, rest)).sum(), (well[:, one] & ~_freed(well, rest)).sum()
        if rest and max(alone) < max(1.0, FEW * len(free)):
            chosen = rest
    return chosen


def in_order(axis: Floats) -> Floats:
    """The axes (k, 3) from the most upright on, each the nearest to the one before it."""
    left = list(np.argsort(-axis[:, 2], kind="stable"))
    order = left[:1]
    left = left[1:]
    while left:
        order.append(left.pop(int((axis[left] @ axis[order[-1]]).argmax())))
    return axis[order]


def _given(nodes: Nodes, axis: Floats, reacher: Reacher, tree: FacetTree, progress: Progress) -> Frames:
    """The places with the frame in which each is cut."""
    free = find_freedom(nodes, reacher, tree, axis, progress).free
    worth = np.where(free, nodes.normal @ axis.T - SOONER * np.arange(len(axis)), -np.inf)
    frame = np.where(free.any(axis=1), worth.argmax(axis=1), -1) if len(axis) else np.full(len(nodes.point), -1)
    return Frames(axis, nodes.point, nodes.normal, frame, nodes.spacing)


def _unseen(frames: Frames, mesh: Mesh, keep: Bools) -> tuple[Finding, ...]:
    """The area that no frame sees, of what any direction would see, by the share of the places; nothing where it is no more than
    a single place."""
    out = np.flatnonzero(frames.frame < 0)
    if len(out) < 2:
        return ()
    lost = float(mesh.area[keep].sum()) * len(out) / len(frames.frame)
    x, y, z = frames.point[out[0]].tolist()
    text = say(
        "{area} ({share} % of the part), the first at {place}, are left out: none of the {count} frames sees them with the tool "
        "free. Allow more frames where there are fewer than {most}, use a smaller tool, or cut the rest with other passes.",
        area=Area(lost, ".4g"), share=Number(100.0 * lost / float(mesh.area.sum()), ".3g"), place=Point((x, y, z)),
        count=len(frames.axis), most=MOST,
    )  # fmt: skip
    return (Finding(Severity.WARNING, "outside-frames", text, lost, 0.0, "mm2", place=(x, y, z)),)


def _told(frames: Frames) -> Finding:
    """How many frames there are, and their axes."""
    shown = "; ".join(",".join(f"{number + 0.0:.3f}" for number in np.round(axis, 3)) for axis in frames.axis)
    text = say("The part is cut in {count} frames, each with a tool axis of its own: {axes}.", count=len(frames.axis), axes=shown)
    return Finding(Severity.NOTE, "frames", text, float(len(frames.axis)), None, "1")
