# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which body of the machine takes most of the tool axes from places where none is left."""

from __future__ import annotations

from dataclasses import replace

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.carried_pieces import HELD
from freecad_fiveaxis.core.gouge.machine_check import is_held
from freecad_fiveaxis.core.gouge.machine_in_pose import machine_in_pose
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.machine.bodies import MachineBody

from .axis_field import Nodes, find_freedom


def find_blocking_body(nodes: Nodes, reacher: Reacher, tree: FacetTree, direction: Floats) -> str | None:
    """Name the body that takes most of the directions (d, 3) tried at the ``nodes``, which stand for equal
    areas of the part: each body of table and base with those of the head, and each of the head alone, for
    these meet the part. None where no single one takes any."""
    if reacher.machine is None:
        return None
    machine = reacher.machine.given.machine
    head = tuple(one for one in machine.bodies if not is_held(machine, one))

    def count_free(bodies: tuple[MachineBody, ...]) -> int:
        return int(find_freedom(nodes, _with_bodies(reacher, bodies), tree, direction).free.sum())

    without, with_head = count_free(()), count_free(head)
    taken = {one.name: without - count_free((one,)) for one in head}
    taken |= {one.name: with_head - count_free((*head, one)) for one in machine.bodies if one not in head}
    name = max(taken, key=lambda one: taken[one])
    return name if taken[name] > 0 else None


def _with_bodies(reacher: Reacher, bodies: tuple[MachineBody, ...]) -> Reacher:
    """Return the same on a machine with these bodies alone; part and fixtures stay."""
    pose = reacher.machine
    if pose is None or not bodies:
        return replace(reacher, machine=None)
    given = replace(pose.given, machine=replace(pose.given.machine, bodies=bodies), fixtures=())
    bare = machine_in_pose(given, None, pose.tolerance, margin=pose.margin)
    if bare is None:
        return replace(reacher, machine=None)
    work = tuple(one for one in pose.carried if one.kind == HELD)
    return replace(reacher, machine=replace(bare, carried=(*bare.carried, *work)))
