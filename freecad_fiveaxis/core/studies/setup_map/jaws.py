# SPDX-License-Identifier: LGPL-2.1-or-later
"""How high the jaws of a vise may reach beside the part in a setup, on each of its four sides.

jaw      a block ``thick`` mm thick beside the part's box, as long as that side of it, from the part's lowest
         place up to the jaw's top.
top      the highest one, in STEPs, that cutter, shank, holder and spindle never enter on the real way of any
         block: **proven**. A jaw that is higher by a STEP is entered, or it is not proven that it is not; it
         holds all that a lower one does, so halving finds it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Length, Sentence, join_sentences, say
from freecad_fiveaxis.core.geometry.facet_tree import build_facet_tree
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.geometry.solids import box_facets
from freecad_fiveaxis.core.gouge.fixtures import check_fixtures
from freecad_fiveaxis.core.tool.body import Body, grow_body

from .standing import Run, Standing, first_entries

STEP = 0.1
"""mm; so well the height of a jaw is known."""

SIDES = (("-X", 0, -1), ("+X", 0, 1), ("-Y", 1, -1), ("+Y", 1, 1))
"""Names of the sides, their axis, and the way out."""


@dataclass(frozen=True)
class Jaw:
    """``top`` mm in the program's coordinates: up to there a jaw on this ``side`` is free; None: no jaw is,
    however low. ``limited``: whether the tool is why, and not the height of the part."""

    side: str
    top: float | None
    limited: bool


@dataclass(frozen=True)
class Clamping:
    """``hits``: what is to be said of the fixtures, that are hit or come too near; ``jaws`` of the four
    sides; ``thick`` mm: so thick these are, away from the part. ``stick_out`` mm:
    of the tool of which they are told."""

    hits: tuple[Finding, ...]
    jaws: tuple[Jaw, ...]
    thick: float
    stick_out: float


def find_clamping(
    stand: Standing, thick: float, progress: Progress = silent, more: float = 0.0
) -> Clamping | None:
    """Find what the tool hits of the fixtures, and how high jaws ``thick`` mm thick may reach, with a tool
    that sticks out ``more`` mm farther than it does. None where no fixture is given; no jaws where the part
    is not known. Raises ReachError."""
    if not stand.fixtures:
        return None
    run, part, quiet = stand.run(more, progress), stand.turned_part, _quiet(progress)
    hits = check_fixtures(
        stand.turned_fixtures, whole_tool(run), run.kinematics, run.program, stand.tolerance, stand.back,
        quiet, clearance=stand.clearance,
    )  # fmt: skip
    jaws = () if part is None else tuple(_jaw(run, part.box, side, thick, quiet) for side in SIDES)
    return Clamping(hits, jaws, thick, round(run.stack.stick_out, 6))


def whole_tool(run: Run) -> Body:
    """Return the tool, and what is round of the spindle."""
    return Body((*run.stack.body.pieces, *run.spindle.pieces))


def _quiet(progress: Progress) -> Progress:
    return lambda stage, share: progress("jaws", 0.0)


def _jaw(
    run: Run, box: tuple[Floats, Floats], side: tuple[str, int, int], thick: float, progress: Progress
) -> Jaw:
    name, axis, out = side
    bottom, top = float(box[0][2]), float(box[1][2])
    body = grow_body(whole_tool(run), run.stand.clearance)
    suspects = np.empty(0, np.int64)

    def is_free(height: float) -> bool:
        nonlocal suspects
        tree = build_facet_tree(from_triangles(box_facets(*jaw_corners(box, axis, out, thick, height))))
        found = first_entries(tree, body, run.swept, run.stand.tolerance, suspects, progress)
        suspects = found if len(found) else suspects
        return not len(found)

    if is_free(top):
        return Jaw(name, round(top, 6), False)
    free, entered = math.floor(bottom / STEP + 1e-9), math.ceil(top / STEP - 1e-9)
    while entered - free > 1:
        middle = (free + entered) // 2
        free, entered = (middle, entered) if is_free(middle * STEP) else (free, middle)
    return Jaw(name, round(free * STEP, 6) if free * STEP > bottom + 1e-9 else None, True)


def jaw_corners(
    box: tuple[Floats, Floats], axis: int, out: int, thick: float, top: float
) -> tuple[Floats, Floats]:
    """Return the low and the high corner (3,) mm of a jaw beside a ``box``, ``thick`` mm thick, up to
    ``top``."""
    low, high = np.array(box[0], float), np.array(box[1], float)
    face = high[axis] if out > 0 else low[axis]
    low[axis], high[axis] = min(face, face + out * thick), max(face, face + out * thick)
    high[2] = top
    return low, high


def clamping_findings(found: Clamping | None) -> Iterator[Finding]:
    """Tell what is hit of the fixtures, and how high jaws may reach."""
    if found is None:
        return
    yield from found.hits
    if not found.jaws:
        return
    able = [jaw.top for jaw in found.jaws if jaw.top is not None]
    sides = join_sentences([_words(jaw) for jaw in found.jaws], ", ")
    text = say(
        "Jaws {thick} thick beside the part are free in the recommended setup up to these heights, from its "
        "work zero, where the tool sticks out {length}: {sides}.",
        thick=Length(found.thick, ".6g"), sides=sides,
        length=Length(found.stick_out, ".6g"),
    )  # fmt: skip
    yield report_finding(Code.JAWS_FREE, text, min(able, default=None))


def _words(jaw: Jaw) -> Sentence:
    if jaw.top is None:
        return say("{side}: none", side=jaw.side)
    if not jaw.limited:
        return say("{side}: as high as the part", side=jaw.side)
    return say("{side}: Z {top}", side=jaw.side, top=Length(jaw.top, ".6g"))


def jaws_record(found: Clamping | None) -> list[dict[str, object]] | None:
    """Return the jaws for scripts, mm."""
    return None if found is None else [vars(jaw) | {"thick": found.thick} for jaw in found.jaws]
