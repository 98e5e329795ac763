# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion lines, divided into chords, as the blocks of a Program."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.controllers.dialect import Dialect, feed_distance
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Guided, Program, rapid_minutes
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from . import codes
from .arcs import Chords
from .feed_measure import Measure
from .feeds import Feeds
from .lines import last_of
from .planes import Planes
from .positions import Moves, find_wraps, in_work, tool_axes, where_axes_stand


@dataclass(frozen=True, eq=False)
class Blocks:
    """One row a block, (n,): ``row`` of its motion line (all, where each is a block); all else as in
    :class:`.positions.Moves` and :class:`.feeds.Feeds`."""

    row: Ints | slice
    before: Floats
    programmed: Floats
    at: Ints
    mode: Ints
    on: Bools
    vector: Floats
    meaning: Ints
    feed: Floats
    inverse: Bools
    per_turn: Bools
    unit: Floats


def divide_blocks(motions: Moves, feeds: Feeds, chords: Chords | None) -> Blocks:
    """Return the blocks, of a move with chords one for each."""
    row: Ints | slice = slice(None)
    ends: Moves | Chords = motions
    feed = feeds.feed
    if chords is not None:
        row, ends = chords.row, chords
        feed = np.where(feeds.inverse, feed * chords.count, feed)
    return Blocks(
        row, ends.before, ends.programmed, motions.at[row], motions.mode[row], motions.on[row],
        motions.vector[row], motions.meaning[row], feed[row], feeds.inverse[row], feeds.per_turn[row],
        feeds.unit[row],
    )  # fmt: skip


def build_program(
    blocks: Blocks, kinematics: Chain, dialect: Dialect | None, planes: Planes | None,
    measure: Measure | None = None,
) -> Program:  # fmt: skip
    """Return the Program of the blocks, with what the controller guides and the time that it takes;
    ``measure``: what F is measured over, where the program says it itself."""
    on, meaning = blocks.on, blocks.meaning
    motion = np.where(blocks.mode == codes.RAPID, Motion.RAPID, Motion.CUT).astype(np.int8)
    programmed = in_work(blocks.programmed, meaning, planes)
    words = where_axes_stand(kinematics, programmed, on if planes is None else on | planes.by_tip(meaning))
    guided = _gather_guided(kinematics, words, programmed, on, blocks.vector) if on.any() else None
    travel = blocks.programmed - blocks.before
    travel = travel if planes is None else planes.scale_travel(travel, meaning)
    seconds = _seconds(blocks, travel, words, motion, kinematics, dialect, measure)
    return Program(
        kinematics.letters, words, blocks.feed, blocks.inverse, motion, seconds, np.full(len(motion), -1),
        blocks.at, (), guided, find_wraps(kinematics),
    )  # fmt: skip


def _gather_guided(kinematics: Chain, words: Floats, programmed: Floats, on: Bools, vector: Floats) -> Guided:
    """Return what the file says: a vector stays until the rotary words change."""
    given: Bools = np.asarray(~np.isnan(vector).all(axis=1))
    if not given.any():
        return Guided(on, programmed[:, :3])
    last = last_of(np.flatnonzero(given), len(given))
    stays = given[last] & (programmed[:, 3:] == programmed[last, 3:]).all(axis=1)
    return Guided(
        on,
        programmed[:, :3],
        np.where(stays[:, None], np.nan_to_num(vector[last]), tool_axes(kinematics, words)),
    )


def _feed_distance(
    blocks: Blocks, travel: Floats, dialect: Dialect | None, measure: Measure | None
) -> Floats:
    """Return what F measures in each block (n,), mm or degrees, of its ``travel`` (n, 5)."""
    if measure is not None:
        return measure.distance(travel)
    straight = np.flatnonzero((blocks.unit != 1.0) & travel[:, :3].any(axis=1))
    travel[straight, 3:] *= blocks.unit[straight, None]
    distance = feed_distance(dialect, travel)
    if blocks.on.any():
        guide = next(iter(dialect.guides.values()), None) if dialect is not None else None
        over_all = guide is not None and guide.rotary_in_feed
        guided = feed_distance(dialect if over_all else None, travel)
        distance = np.where(blocks.on, guided, distance)
    return distance


def _seconds(
    blocks: Blocks, travel: Floats, words: Floats, motion: Bytes, kinematics: Chain, dialect: Dialect | None,
    measure: Measure | None,
) -> Floats:  # fmt: skip
    """Return the time (n,) s that the controller takes by what the words say; 0 where nothing."""
    feed = blocks.feed
    distance = np.where(blocks.inverse, 1.0, _feed_distance(blocks, travel, dialect, measure))
    known = (feed > 0.0) & ~blocks.per_turn
    minutes = np.divide(distance, feed, out=np.zeros(len(feed)), where=known)
    change = np.diff(words, axis=0, prepend=words[:1])
    change[:, 3:] = np.radians(change[:, 3:])
    seconds: Floats = 60.0 * np.where(motion == Motion.RAPID, rapid_minutes(kinematics, change), minutes)
    seconds[0] = 0.0
    return seconds
