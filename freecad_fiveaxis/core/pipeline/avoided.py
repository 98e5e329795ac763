# SPDX-License-Identifier: LGPL-2.1-or-later
"""The allowance on faces to avoid: passes end before the tool comes nearer to them, and the program is proven
to keep it.

Places that the cutter's corner ball cannot touch are cut off the passes first; what the rest of the tool
would come too near for is left out once its axes are known. Links, rapids and cures keep off by the allowance
on the facets of what they keep out of.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Length, Option, Point, Sentence, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge import check_program
from freecad_fiveaxis.core.gouge.leave_out import keep_away
from freecad_fiveaxis.core.gouge.lift import AIM
from freecad_fiveaxis.core.gouge.rest_material import surface_samples
from freecad_fiveaxis.core.gouge.worst import find_unproven, find_worst
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.orientation.order_with_axes import order_with_axes
from freecad_fiveaxis.core.passes.keep_off import KeepOff, facets_allowed, report_strip
from freecad_fiveaxis.core.tool.body import grow_body
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath
from freecad_fiveaxis.core.toolpath.cut_near_faces import cut_near_faces

from .context import MillContext
from .options import rapids_of, tip_to_driven, tip_to_surface, tool_body
from .settings import Settings

SAMPLES, FINEST = 20_000, 0.02
"""Places on the facets that are cut at which the strip beside faces to avoid is measured, about; they lie no
closer than that share of the cutter's diameter."""


def keep_off_of(settings: Settings, mesh: Mesh, avoided: Bools | None) -> KeepOff | None:
    """Find what the tool keeps off by the allowance of the settings, of the ``avoided`` facets (f,); None
    where no allowance is asked for. Raises SettingsError for an allowance without faces, or larger than the
    part."""
    allowance, option = settings.gouge.avoid_allowance, Option("avoid_allowance")
    if allowance == 0.0:
        return None
    if avoided is None:
        text = say(
            "{option} {allowance} is an allowance on faces to avoid, and there are none: give them with "
            "{avoid}, or leave it out",
            option=option, allowance=Length(allowance), avoid=Option("avoid"),
        )  # fmt: skip
        raise SettingsError(text, allowance)
    size = float(np.linalg.norm(mesh.box[1] - mesh.box[0]))
    if allowance > size:
        text = say(
            "{option} {allowance} is larger than the part, which is {size} from corner to corner; give less",
            option=option,
            allowance=Length(allowance), size=Length(size, ".4g"),
        )  # fmt: skip
        raise SettingsError(text, allowance)
    return KeepOff.of(mesh, avoided, allowance, settings.cutter.cutter.corner)


def facets_off(keep_off: KeepOff | None, mesh: Mesh, facets: Bools) -> tuple[Bools, tuple[Finding, ...]]:
    """Find those of ``facets`` (f,) that can be cut for the allowance, if only in part, and say what the
    others are. Raises SettingsError where there is none."""
    if keep_off is None or not facets.any():
        return facets, ()
    left, found = facets_allowed(keep_off, mesh, facets)
    if not left.any():
        raise SettingsError(_nothing_left(keep_off), keep_off.allowance)
    return left, found


def cut_clear_of_faces(context: MillContext, offset: OffsetPath) -> OffsetPath:
    """Cut the passes where the corner ball comes too near to faces to avoid, and order the pieces anew where
    passes run to and fro. Raises SettingsError where nothing is left."""
    keep_off = context.keep_off
    if keep_off is None:
        return offset
    cut = cut_near_faces(offset, keep_off)
    if not len(cut.point):
        raise SettingsError(_nothing_left(keep_off), keep_off.allowance)
    if cut is not offset and context.settings.links.order == "zigzag":
        cut = order_with_axes(cut, cut.normal)[0]
    area, diameter = float(context.mesh.area[context.keep].sum()), context.settings.cutter.cutter.diameter
    spacing = max(math.sqrt(area / SAMPLES), FINEST * diameter)
    return replace(
        cut, findings=(*cut.findings, *report_places(keep_off, context.mesh, context.keep, spacing))
    )


def report_places(
    keep_off: KeepOff | None, mesh: Mesh, facets: Bools | None, spacing: float
) -> tuple[Finding, ...]:
    """Say how much of ``facets`` (f,; None: all) the corner ball cannot touch, by places ``spacing`` mm
    apart."""
    return () if keep_off is None else report_strip(keep_off, mesh, *surface_samples(mesh, spacing, facets))


def far_enough_rows(context: MillContext, seated: OffsetPath, axis: Floats) -> tuple[OffsetPath, Floats]:
    """Return the rows, and their axes (n, 3), without those between which cutter, shank or holder come too
    near to faces to avoid. ``seated``: with hubs. Raises SettingsError where nothing is left."""
    settings, keep_off = context.settings, context.keep_off
    if keep_off is None:
        return seated, axis
    body, cutter, tolerance = (
        grow_body(tool_body(settings), keep_off.allowance),
        settings.cutter.cutter,
        settings.proof.tolerance,
    )
    tree, above = facet_tree(keep_off.faces), tip_to_surface(settings)
    return keep_away(
        seated, axis, tree, body, AIM * tolerance, cutter.corner, keep_off.allowance, context.progress, above
    )


def _nothing_left(keep_off: KeepOff) -> Sentence:
    return say(
        "nothing of what is to be machined can be cut {allowance} off the faces to avoid; give a smaller "
        "allowance or cutter",
        allowance=Length(keep_off.allowance),
    )


def check_keep_off(context: MillContext, program: Program) -> tuple[Finding, ...]:
    """Tell where the tool comes nearer to faces to avoid than the allowance, by more than the tolerance, on
    any block of its real way; and the rapids of which that is not known."""
    keep_off, settings = context.keep_off, context.settings
    if keep_off is None or keep_off.allowance <= settings.proof.tolerance:
        return ()
    rapids, tolerance = rapids_of(settings, context.machine, context.dialect), settings.proof.tolerance
    body, back = grow_body(tool_body(settings), keep_off.allowance), tip_to_driven(settings)
    check = check_program(
        keep_off.faces, body, context.kinematics, program, tolerance, back, context.progress, "", rapids
    )
    worst, open_ = find_worst(check, program), find_unproven(check.ways, program, tolerance)
    found = list[Finding]()
    if worst is not None:
        distance = max(keep_off.allowance - worst.depth, 0.0)
        text = say(
            "The {part} comes nearer than {distance} to the faces to avoid at {at}, nearest of {count} "
            "blocks; {allowance} are asked for. Let blocks be divided, or use a smaller cutter or holder.",
            part=worst.part, distance=Length(distance, ".3g"), at=Point(worst.place), count=worst.blocks,
            allowance=Length(keep_off.allowance),
        )  # fmt: skip
        found.append(
            report_finding(
                Code.AVOIDED_FACES_NEAR,
                text,
                distance,
                keep_off.allowance,
                worst.row,
                worst.line,
                worst.place,
            )
        )
    if open_ is not None:
        text = say(
            "In {count} rapids it is not proven that the tool keeps {allowance} off the faces to avoid on "
            "every way of "
            "independent axes, the first in NC line {line}. Drive one group of axes after the other.",
            count=open_.rapids, allowance=Length(keep_off.allowance), line=open_.line,
        )  # fmt: skip
        found.append(
            report_finding(Code.AVOIDED_FACES_UNPROVEN, text, open_.bound, tolerance, open_.row, open_.line)
        )
    return tuple(found)
