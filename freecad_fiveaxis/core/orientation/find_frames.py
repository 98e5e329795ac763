# SPDX-License-Identifier: LGPL-2.1-or-later
"""The few tool axes with which a part is cut with locked rotary axes, and which place is cut with which of
them.

candidate  a direction that the machine takes up: many, evenly over the sphere, and the part's own main ones;
           on a machine of one rotary axis those that it turns through.
cover      of the candidates the one that frees most places, then the one that frees most of the rest, and so
           on: first where it stands well on the surface, then wherever it is free. Those that the later ones
           have made needless are taken out.
frame      a direction of the cover. A place is cut in the frame that sees it flattest of those in which the
           tool is free there.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import numpy as np
import scipy

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Area, Number, Point, Sentence, Template, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.machine.kinematics import Chain, forward
from freecad_fiveaxis.core.passes.frames import Frames

from .axis_field import (
    Freedom,
    Nodes,
    even_directions,
    find_freedom,
    main_directions,
    surface_nodes,
    with_margin,
)
from .facets_with_axis import OF_PART, AxisField, Whole, select_facets

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
"""Of a cosine: by that the earlier of two frames is taken that see a place alike, so that a plane is not cut
in both."""

LESS = 5e-4
"""Of the places: so few may be unseen by frames above a floor that others see."""

NEIGHBOURS, ROUNDS, TOGETHER = 8, 4, 0.2
"""Places beside a place, how often they are asked, and how much of a cosine it is worth to be cut in the
frame of all of them."""

FEWEST = 2
"""Places that no frame sees, at least, for their area to be told."""

STEPS = 72
"""Positions of a single rotary axis that are tried."""

_ELSEWHERE = Template(
    "{area} ({share} % {of_whole}), the first at {place}, are left out, for the tool is free there in none "
    "of the {count} frames, though it is along other axes: {more}."
)
_NOWHERE = Template(
    "{area} ({share} % {of_whole}), the first at {place}, are left out, for the tool is free there in none "
    "of the {count} frames, nor along any other axis that was tried: use a smaller tool."
)
_KINDS = ((Code.OUTSIDE_FRAMES, _ELSEWHERE), (Code.FACETS_WITHOUT_FREE_AXIS, _NOWHERE))


def find_frames(
    mesh: Mesh,
    facets: Bools,
    reacher: Reacher,
    most: float,
    count: int = MOST,
    progress: Progress = silent,
    whole: Whole | None = None,
) -> tuple[Frames, Bools, tuple[Finding, ...]]:
    """Find at most ``count`` frames for ``facets`` (f,), those of them that are cut in any (f,), and what is
    left out.

    ``reacher``: tool, machine and table; ``most`` rad: the largest angle from +Z that was wanted; ``whole``:
    of what shares are told, None: of the mesh. Frames above the floors of the ``reacher`` are taken only
    where they see as much as those without. Raises ReachError where nothing is left, SettingsError for sizes
    that no tool has.
    """
    whole = Whole(float(mesh.area.sum()), OF_PART) if whole is None else whole
    free = _find_frames(mesh, facets, replace(reacher, floors=()), most, count, progress, whole)
    if not reacher.floors:
        return free
    above = _find_frames(mesh, facets, reacher, most, count, progress, whole)
    seen, seen_above = ((one[0].frame >= 0).mean() for one in (free, above))
    return above if seen_above >= seen - LESS else free


def _find_frames(
    mesh: Mesh, facets: Bools, reacher: Reacher, most: float, count: int, progress: Progress, whole: Whole
) -> tuple[Frames, Bools, tuple[Finding, ...]]:
    tree, wide = facet_tree(mesh), with_margin(reacher)
    nodes = surface_nodes(mesh, facets, reacher, tree)
    freedom = find_freedom(nodes, wide, tree, candidates(mesh, reacher.kinematics), progress, False)
    freedom = Freedom(freedom.direction, freedom.free, np.zeros_like(freedom.upright), freedom.met)
    field = AxisField(nodes, freedom, nodes.normal)
    keep, left_out = select_facets(field, mesh, facets, most, reacher, whole=whole)
    chosen = _cover_of(nodes, freedom, count)
    places, direction = surface_nodes(mesh, keep, reacher, tree, PLACES), freedom.direction
    rest = np.flatnonzero(
        ~find_freedom(places, wide, tree, direction[chosen], progress, False).free.any(axis=1)
    )
    looked = find_freedom(_nodes_of(places, rest), wide, tree, direction, progress, False)
    more = _cover_of(_nodes_of(places, rest), looked, count - len(chosen), FEW * len(places.point))
    axis = in_order(direction[np.concatenate([chosen, more])])
    free = find_freedom(places, wide, tree, axis, progress, False).free
    frames = Frames(axis, places.point, places.normal, assign(free, places, axis), places.spacing)
    elsewhere = np.zeros(len(free), np.bool_)
    elsewhere[rest] = looked.free.any(axis=1)
    seen = _facets_seen(frames, places, mesh, keep)
    reports = (*left_out, *_unseen(frames, elsewhere, mesh, keep, seen, count, whole), _report_frames(frames))
    return frames, seen, reports


def _cover_of(nodes: Nodes, freedom: Freedom, most: int, least: float | None = None) -> Ints:
    return find_cover(freedom.free, nodes.normal @ freedom.direction.T, freedom.direction[:, 2], most, least)


def _facets_seen(frames: Frames, places: Nodes, mesh: Mesh, keep: Bools) -> Bools:
    """Those of the facets ``keep`` (f,) of which a frame sees a place, or one beside their middle."""
    seen, rows = np.zeros_like(keep), np.flatnonzero(keep)
    seen[rows] = frames.at(mesh.vertex[mesh.face[rows]].mean(axis=1), mesh.normal[rows]) >= 0
    seen[places.facet[frames.frame >= 0]] = True
    return seen


def candidates(mesh: Mesh, kinematics: Chain | None) -> Floats:
    """Give the directions (d, 3), unit, that are tried: on a machine of one rotary axis those that it turns
    through."""
    if kinematics is None or all(axis.fitted for axis in kinematics.axes[3:]):
        return np.concatenate([main_directions(mesh), even_directions()])
    words = np.zeros((STEPS + 1, 5))
    words[:, 3:] = np.linspace(
        np.maximum(kinematics.low[3:], -math.pi), np.minimum(kinematics.high[3:], math.pi), STEPS + 1
    )
    return forward(kinematics, words)[1]


def find_cover(free: Bools, cosine: Floats, up: Floats, most: int, least: float | None = None) -> Ints:
    """Choose at most ``most`` directions (c,) that free most places, of what is ``free`` (n, d) of directions
    whose ``cosine`` (n, d) to the places' normals and height ``up`` (d,) are known: of those that free about
    as many the flatter and more upright. One that frees fewer than ``least`` places besides, None: FEW of
    all, is not taken."""
    least = max(1.0, FEW * len(free) if least is None else least)
    better = 1.0 + BETTER * (cosine + up)
    well, chosen = free & (cosine > WELL), list[int]()
    for frees in (well, free):
        left = free.any(axis=1) & ~_find_freed(frees, chosen)
        while len(chosen) < most and frees.shape[1]:
            best = int(np.where(frees[left], better[left], 0.0).sum(axis=0).argmax())
            if frees[left, best].sum() < least:
                break
            chosen.append(best)
            left &= ~frees[:, best]
    return np.array(_merge_pairs(free, _drop_needless(free, well, chosen, least)), np.int64)


def _find_freed(free: Bools, chosen: list[int]) -> Bools:
    return np.asarray(free[:, chosen].any(axis=1))


def _drop_needless(free: Bools, well: Bools, chosen: list[int], least: float) -> list[int]:
    """Those chosen without each that frees hardly anything that the others do not free as well."""
    for one in list(chosen):
        rest = [other for other in chosen if other != one]
        alone = (
            (free[:, one] & ~_find_freed(free, rest)).sum(),
            (well[:, one] & ~_find_freed(well, rest)).sum(),
        )
        if rest and max(alone) < least:
            chosen = rest
    return chosen


def _merge_pairs(free: Bools, chosen: list[int]) -> list[int]:
    """Those chosen with one direction in place of two wherever one frees as much."""
    for one, other in itertools.combinations(chosen, 2):
        rest = [kept for kept in chosen if kept not in (one, other)]
        lost = free[_find_freed(free, [one, other]) & ~_find_freed(free, rest)]
        instead = np.flatnonzero(lost.sum(axis=0) == len(lost))
        if len(rest) + 2 == len(chosen) and len(lost) and len(instead):
            chosen = [*rest, int(instead[0])]
    return chosen


def in_order(axis: Floats) -> Floats:
    """Return the axes (k, 3) from the most upright on, each the nearest to the one before it."""
    left = list(np.argsort(-axis[:, 2], kind="stable"))
    order = left[:1]
    left = left[1:]
    while left:
        order.append(left.pop(int((axis[left] @ axis[order[-1]]).argmax())))
    return axis[order]


def assign(free: Bools, places: Nodes, axis: Floats) -> Ints:
    """Give each place the frame (n,), of unit ``axis`` (k, 3), that sees it flattest of those in which it is
    ``free`` (n, k), and that places beside it have; -1 where it is free in none."""
    if not len(axis):
        return np.full(len(free), -1)
    flat = np.where(free, places.normal @ axis.T - SOONER * np.arange(len(axis)), -np.inf)
    frame, none = flat.argmax(axis=1), np.asarray(~free.any(axis=1))
    near = (
        scipy.spatial.cKDTree(places.places())
        .query(places.places(), k=min(NEIGHBOURS + 1, len(free)))[1]
        .reshape(len(free), -1)[:, 1:]
    )
    for _ in range(ROUNDS if near.shape[1] else 0):
        alike = (frame[near][:, :, None] == np.arange(len(axis))) & ~none[near][:, :, None]
        frame = (flat + TOGETHER * alike.mean(axis=1)).argmax(axis=1)
    return np.where(none, -1, frame)


def _nodes_of(nodes: Nodes, rows: Ints) -> Nodes:
    return Nodes(
        nodes.point[rows],
        nodes.facet[rows],
        nodes.normal[rows],
        nodes.stand[rows],
        nodes.fits[rows],
        nodes.spacing,
    )


def _unseen(
    frames: Frames, elsewhere: Bools, mesh: Mesh, keep: Bools, seen: Bools, count: int, whole: Whole
) -> tuple[Finding, ...]:
    """Return the area that no frame sees, by the share of the places: what is free under another direction
    (``elsewhere`` (n,)), and what under none; nothing where it is no more than a single place. Facets
    ``keep`` (f,) without those ``seen`` (f,) are not cut; the rest of it lies on facets that are."""
    out = frames.frame < 0
    lost = int(np.count_nonzero(out))
    if lost < FEWEST:
        return ()
    dropped = float(mesh.area[keep & ~seen].sum()) / lost
    each = max(float(mesh.area[keep].sum()) / len(out), dropped)
    more = say("allow more frames") if len(frames.axis) == count < MOST else say("cut that with other passes")
    kinds = zip(_KINDS, _divide_unseen(out, elsewhere), strict=True)
    return tuple(
        _report_unseen(code, text, frames.point[some], each, each - dropped, whole, len(frames.axis), more)
        for (code, text), some in kinds
        if some.any()
    )


def _divide_unseen(out: Bools, elsewhere: Bools) -> tuple[Bools, Bools]:
    """Divide the places ``out`` (n,) that no frame sees into those that are free under another direction and
    those under none; hardly any of one kind count as the other."""
    free, none = out & elsewhere, out & ~elsewhere
    if np.count_nonzero(free) < FEWEST:
        return np.zeros_like(out), out
    return (free, none) if np.count_nonzero(none) >= FEWEST else (out, np.zeros_like(out))


def _report_unseen(
    code: Code, text: Template, place: Floats, each: float, within: float, whole: Whole, count: int,
    more: Sentence,
) -> Finding:  # fmt: skip
    """Report places (k, 3) of ``each`` mm2, of which so much lies ``within`` facets that are cut."""
    lost, (x, y, z) = each * len(place), place[0].tolist()
    sentence = text.say(
        area=Area(lost, ".4g"), share=Number(100.0 * lost / whole.area, ".3g"), of_whole=whole.name,
        place=Point((x, y, z)), count=count, more=more,
    )  # fmt: skip
    return report_finding(code, sentence, lost, 0.0, place=(x, y, z), within=within * len(place))


def _report_frames(frames: Frames) -> Finding:
    """How many frames there are, and their axes."""
    shown = "; ".join(
        ",".join(f"{number:g}" for number in (np.round(axis, 3) + 0.0).tolist()) for axis in frames.axis
    )
    text = say(
        "The part is cut in {count} frames, each with a tool axis of its own: {axes}.",
        count=len(frames.axis),
        axes=shown,
    )
    return report_finding(Code.FRAMES, text, float(len(frames.axis)))
