# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a pass strategy is asked, and what it answers: a scalar field on the mesh and the levels of it that
are cut.

strategy  says where to cut: passes are the level sets of its field. Planes are those of a linear one. What
          comes after it (slicing, co-edges, tool axes, links, checks) never knows which strategy it was.
surface   a finer copy of the region that carries the field, where the facets of the part are too large for
          it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import Any, Protocol

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, freeze
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .contact_path import ContactPath, slice_field, slice_mesh
from .frames import Frames
from .piece_order import order_pieces
from .refine import Copy, copy_facets
from .spacing_tool import SpacingTool
from .spirals import carry, find_spirals, has_loops, merge_passes, off_levels, without_loops

Vector = tuple[float, float, float]

BEND = 0.03
"""Of the interval on a flat: a spiral may be straighter by that inside a facet of the part."""

ALL_ROUND = (0.0, 0.25 * math.pi, 0.5 * math.pi, 0.75 * math.pi)
"""rad: travels that stand for all, of a strategy whose passes run in every direction."""


@dataclass(frozen=True)
class PassOptions:
    """``direction`` rad of the travel of upright planes; ``stepover`` or ``scallop``, and ``least`` interval,
    mm; ``normal`` of planes, any length, None: upright; ``source`` where passes begin and ``target`` where
    they end: the word ``border``, a point, or the path of a curve; ``centre``, the word ``middle`` or a
    point, and ``axis``, any length, of passes that radiate or turn with the part, these ``by`` the words
    ``around`` or ``along``; ``within`` frames lie passes of constant ``scallop`` or ``planes``."""

    direction: float = 0.0
    stepover: float | None = None
    scallop: float | None = None
    least: float = 0.05
    normal: Vector | None = None
    source: str | Vector = "border"
    target: str | Vector = "border"
    centre: str | Vector = "middle"
    axis: Vector = (0.0, 0.0, 1.0)
    by: str = "around"
    within: str = "scallop"


@dataclass(frozen=True, eq=False)
class Region:
    """``mesh``; ``keep`` (f,) the facets to cut; ``radius`` mm of the ball whose passes may stand as far
    apart as the cutter's, at most ``widest`` intervals of a flat (None: the strategy's own); ``interval`` mm
    of a flat. ``covered`` mm: so far from a pass no more than twice the scallop stays on a flat, None: as far
    as that ball leaves it. ``frames``: what sees which of them, for passes that are cut with locked rotary
    axes. ``tool``: how the cutter bends on each facet, None: everywhere as that ball."""

    mesh: Mesh
    keep: Bools
    radius: float
    interval: float
    widest: float | None = None
    progress: Progress = field(default=silent, repr=False)
    frames: Frames | None = None
    covered: float | None = None
    tool: SpacingTool | None = None


@dataclass(frozen=True, eq=False)
class PassField:
    """``value`` (v,) at the vertices of the mesh, or of ``surface`` where there is one; ``levels`` (k,) of
    it, ascending, that are cut; ``upright`` rad: the travel of upright planes, whose points are then exact.
    ``findings``: what is poor about it; ``frame`` (k,): of each level the frame in which it is cut, where
    rotary axes are locked; ``turns`` (n,): facets of the surface about which the field turns, None: not
    known."""

    value: Floats
    levels: Floats
    findings: tuple[Finding, ...] = ()
    upright: float | None = None
    surface: Copy | None = None
    frame: Ints | None = None
    turns: Ints | None = None

    def __post_init__(self) -> None:
        freeze(self, None, value="f")
        freeze(self, None, levels="f")


class PassStrategy(Protocol):
    """One entry of the registry."""

    @property
    def text(self) -> str:
        """In one line what its passes are."""

    @property
    def over_surface(self) -> bool:
        """Whether its passes lie as close on walls and undersides as on level faces, so that free tool axes
        are worth finding."""

    def travels(self, options: PassOptions) -> tuple[float, ...]:
        """rad: the directions of travel, seen from above, that stand for all of its passes."""

    def check(self, region: Region, options: PassOptions) -> None:
        """Refuse, without the field's long work, options that cannot be used on the region. Raises
        SettingsError, FileError."""

    def field(self, region: Region, options: PassOptions) -> PassField:
        """Return the field and its levels. Raises what ``check`` raises."""

    def report_untouched(
        self, region: Region, options: PassOptions, field: PassField, touched: Ints
    ) -> tuple[Finding, ...]:
        """Return the field's findings, and what no pass touches; ``touched`` (n,): facets that passes
        touch."""


def cut(region: Region, found: PassField, order: str, spiral: bool = False) -> ContactPath:
    """Return the passes: the level sets of the field, in the ``order`` of slice_mesh; where they may run to
    and fro, in one that spares air, where there is one (:func:`.piece_order.order_pieces`). ``spiral``:
    closed passes round one another become one long open one (:mod:`.spirals`). Raises SettingsError."""
    if spiral and found.surface is not None and len(found.levels) > 1 and (np.diff(found.levels) > 0.0).all():
        found = replace(found, value=off_levels(found.value, found.levels))
    contact = _slice_field(region, found, {"order": order, "progress": region.progress})
    wound = _spirals(region, found, contact) if spiral else None
    if wound is not None:
        contact, spirals = wound
    if found.surface is not None:
        contact = found.surface.on_part(contact, region.mesh)
    if wound is not None:
        contact = merge_passes(contact, spirals)
    return order_pieces(contact) if order == "zigzag" else contact


def _slice_field(region: Region, found: PassField, plain: dict[str, Any]) -> ContactPath:
    """Return the passes one after the other, on the surface of the field where it has one."""
    if found.surface is not None:
        return slice_field(found.surface.mesh, found.value, found.levels, **plain)
    if found.upright is not None:
        return slice_mesh(region.mesh, found.levels, found.upright, plain=~region.keep, **plain)
    return slice_field(region.mesh, found.value, found.levels, plain=~region.keep, **plain)


def _spirals(
    region: Region, found: PassField, contact: ContactPath
) -> tuple[ContactPath, ContactPath] | None:
    """Return the passes without the loops of which spirals are made, and the spirals, on the part; None where
    there is none."""
    if not has_loops(contact):
        return None
    rows = np.flatnonzero(region.keep)
    copy, value = found.surface, found.value
    if copy is None:
        copy = replace(copy_facets(region.mesh, rows), bend=BEND * region.interval)
        value = carry(copy.mesh, value[region.mesh.face[rows]])
    wound = find_spirals(region.mesh, copy, value, found.levels)
    if wound is None:
        return None
    spirals, face, pass_ = wound
    if found.surface is None:
        face = rows[face]
    return without_loops(contact, face, pass_), spirals
