# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bodies of a machine's file as a picture shows them: each on the axis that carries it, beside what is
left of the sketch.

frame     as in :mod:`.playback`: parallel to the machine's, its zero where the work zero stands while all
          words are 0. A file gives its bodies at all *joints* zero; from there each is moved back to where
          its axis has it while all words are 0.
place     ``base``, ``spindle``, ``platter`` (on the table axis next to the work) or ``cradle`` (on one of the
          others, those of the head among them).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.machine_bodies import make_mesh
from freecad_fiveaxis.core.gouge.machine_check import needs_length, zero_words
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.bodies import BASE, SPINDLE
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup

from .machine_sketch import Body
from .playback import placements, rigid_inverse, sides

PLATTER, CRADLE = "platter", "cradle"
SHARP = 0.9
"""Cosine of 26 deg: facets that meet at more than that meet in an edge that is drawn; the sides of a round
body meet at less."""
ON_TABLE = ("platter", "riser", "table", "cradle", "base")
ON_HEAD = ("spindle", "fork", "ram")
"""Of the sketch."""


@dataclass(frozen=True, eq=False)
class StandingBody:
    """``mesh``, mm, as it stands while all words are 0; ``carrier``: the column (0 to 4) of the words whose
    axis moves it, None for what stands still; ``place`` as at the head of the module."""

    name: str
    place: str
    carrier: int | None
    mesh: Mesh


def stand_bodies(
    machine: Machine, setup: Setup, kinematics: Chain, length: float | None, progress: Progress = silent
) -> tuple[StandingBody, ...]:
    """Stand up the bodies of a machine. ``length`` mm, gauge point to the driven point; None: not known, and
    what depends on it is left out. Raises FiveAxisError for the file of a body that cannot be used."""
    known = [body for body in machine.bodies if length is not None or not needs_length(machine, body)]
    if not known:
        return ()
    resting = placements(kinematics, zero_words(machine, setup, kinematics)[None])
    at_zero = resting["machine_from_work"][0, :3, 3] - setup.origin
    table = [axis for axis in sides(kinematics)[0] if kinematics.axes[axis].fitted]
    head = _last_of_head(kinematics)
    found = []
    for body in known:
        if body.carrier == SPINDLE:
            over = np.array([0.0, 0.0, length or 0.0]) - machine.gauge_point
            found.append(StandingBody(body.name, SPINDLE, head, make_mesh(body, over, progress)))
        elif body.carrier == BASE:
            found.append(StandingBody(body.name, BASE, None, make_mesh(body, at_zero, progress)))
        else:
            axis = kinematics.letters.index(body.carrier)
            back = rigid_inverse(resting["machine_from_carried"][0, axis])[:3, 3]
            place = PLATTER if axis in table[:1] else CRADLE
            found.append(StandingBody(body.name, place, axis, make_mesh(body, at_zero + back, progress)))
    return tuple(found)


def leave_out(
    sketched: Sequence[Body], standing: Sequence[StandingBody], kinematics: Chain
) -> tuple[Body, ...]:
    """Leave out of a sketch what stands where bodies of the machine's file do: on an axis or base that
    carries some, and where they are the spindle's."""
    taken = {one.carrier for one in standing if one.place != SPINDLE}
    spindle, head = any(one.place == SPINDLE for one in standing), _last_of_head(kinematics)

    def is_replaced(body: Body) -> bool:
        if body.name in ON_HEAD:
            return body.carrier in taken or (spindle and (body.name == "spindle" or body.carrier == head))
        return body.name in ON_TABLE and body.carrier in taken

    return tuple(body for body in sketched if not is_replaced(body))


def find_edges(mesh: Mesh) -> Floats:
    """Find the edges (e, 2, 3), mm, in which a mesh bends sharply, and those at a border."""
    border = mesh.coedge_face[:, 1] < 0
    return np.asarray(mesh.vertex[mesh.coedge_vertex[border | find_sharp(mesh)]])


def find_sharp(mesh: Mesh) -> Bools:
    """Find the co-edges (e,) of two facets in which a mesh bends sharply."""
    first, second = mesh.coedge_face.T
    bend = (mesh.normal[first] * mesh.normal[second]).sum(axis=1)
    return np.asarray((second >= 0) & (bend < SHARP))


def _last_of_head(kinematics: Chain) -> int | None:
    """Return the column of the axis that carries the spindle; None where none does."""
    fitted = [axis for axis in sides(kinematics)[1] if kinematics.axes[axis].fitted]
    return fitted[-1] if fitted else None
