# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which blocks of a program are not proven to keep out of the machine: yes or no for each of them, for ways
that can still be laid otherwise.

It is the proof of :mod:`.machine_check` without depths and places: what tool and spindle do to the bodies of
table and base, the spindle to part and fixtures, and bodies to each other and to these.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.rapids import INTERPOLATED
from freecad_fiveaxis.core.base.records import Bools, Ints
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.tool.body import Body

from .body_pairs import which_meet
from .carried_pieces import CarriedPair, pair_up
from .check import program_motion
from .joint_box import JointBoxes, JointSpace
from .machine_bodies import make_mesh
from .machine_check import (
    InMachine,
    carry_all,
    find_locked_letters,
    is_held,
    lock_words,
    needs_length,
    pair_check,
    spindle_of,
    stack_of,
)
from .rapid_check import independent_rapids
from .rapid_ways import which_ways_enter
from .search import which_enter


@dataclass(frozen=True, eq=False)
class MachineBlocks:
    """``given``: machine, setup, chain and tool; ``part`` (None: not known), and the ``obstacles``, part and
    fixtures, that tool and spindle keep out of; ``tolerance`` mm that may be entered."""

    given: InMachine
    part: Mesh | None
    obstacles: Mesh
    tolerance: float
    progress: Progress = silent

    @cached_property
    def held(self) -> tuple[tuple[str, FacetTree], ...]:
        """Of each body of table and base the axes that are locked seen from it, and its facets; those of
        unknown place are left out."""
        given = self.given
        return tuple(
            (
                find_locked_letters(given.machine, body),
                facet_tree(make_mesh(body, -np.array(given.setup.origin), self.progress)),
            )
            for body in given.machine.bodies
            if is_held(given.machine, body)
            and (given.length is not None or not needs_length(given.machine, body))
        )

    @cached_property
    def pairs(self) -> list[CarriedPair]:
        """What moves against each other."""
        return pair_up(self.given.machine, carry_all(self.given, self.part, self.progress))[0]

    def which_hit(self, program: Program, blocks: Ints, tool: bool = True) -> Bools:
        """Tell which of these ``blocks`` (k,) of a program are not proven to hit nothing; block i leads to
        row i + 1. ``tool``: whether it is asked, too, what cutter, shank and holder do to part and
        fixtures."""
        given, stack = self.given, stack_of(self.given)
        looked_at = stack if tool else spindle_of(given)
        hit = self._enter(looked_at, facet_tree(self.obstacles), program, blocks)
        for letters, tree in self.held:
            words = lock_words(given.machine, given.setup, given.kinematics, program.words, letters)
            hit |= self._enter(stack, tree, replace(program, words=words), blocks)
        left = np.flatnonzero(~hit)
        check = pair_check(given, program, self.tolerance)
        hit[left] = which_meet(check, self.pairs, blocks[left], self.progress)
        return hit

    def _enter(self, stack: Body, tree: FacetTree, program: Program, blocks: Ints) -> Bools:
        """Which blocks (k,) the stack is not proven to keep out of these facets in."""
        given = self.given
        if not stack.pieces:
            return np.zeros(len(blocks), np.bool_)
        swept = program_motion(given.kinematics, program, given.back)
        hit = which_enter(stack, tree, swept, self.tolerance, blocks, self.progress)[blocks]
        if given.rapids == INTERPOLATED:
            return hit
        at = np.flatnonzero(~hit & np.isin(blocks, independent_rapids(program)))
        start, end = program.words[blocks[at]], program.words[blocks[at] + 1]
        boxes = JointBoxes(np.arange(len(at)), 0.5 * (start + end), 0.5 * np.abs(end - start))
        space = JointSpace.of(given.kinematics, given.back)
        hit[at] = which_ways_enter(stack, tree, space, boxes, self.tolerance, self.progress)
        return hit
