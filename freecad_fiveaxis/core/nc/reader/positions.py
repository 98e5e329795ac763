# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the words of each motion line lead, from the words and the modes.

programmed   the words at the end of a motion line as the NC file means them: X Y Z (mm), first and second
             rotary word (deg, turns unfolded). Where the controller guides the tip, X Y Z are its place in
             the work; in a tilted plane its place there; else where the axes stand.
stretch      motion lines in a row whose X Y Z mean the same. Where one ends, the same pose begins the next.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Number, say
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, inverse_axis, words_to_q
from freecad_fiveaxis.core.motion.joint_path.branches import choose, within_limits
from freecad_fiveaxis.core.motion.joint_path.plan import find_crossings
from freecad_fiveaxis.core.motion.program import standing
from freecad_fiveaxis.core.motion.program.guided import AT_POLE

from . import codes
from .lines import Lines, last_of
from .planes import IN_PLANE, JOINTS, Planes

FARTHEST = 1e7
"""mm, deg; a word beyond this is no place of any machine."""
NOTHING, ABSOLUTE, STEP, SHORTER = 0, 1, 2, 3
"""How a word is meant: not given; absolute; added to the last place; by the shorter way."""
AxisWords = list[tuple[Floats, Bytes]]
"""The words of the machine's five axes, each (m,), and how each is meant (m,)."""


@dataclass(frozen=True, eq=False)
class MotionLines:
    """One row a motion line, (m,): ``at`` its line; ``words`` mm and degrees; ``mode`` of motion; ``on``
    whether the controller guides the tip; ``vector`` (m, 3) the tool axis where a vector gives it, else NaN;
    ``meaning`` of X Y Z, as of :meth:`.planes.Planes.of_blocks`."""

    at: Ints
    words: AxisWords
    mode: Ints
    on: Bools
    vector: Floats
    meaning: Ints

    def begin(self, row: int) -> MotionLines:
        """Return the motion lines from that row on."""
        columns = {name: column[row:] for name, column in vars(self).items() if name != "words"}
        return replace(self, words=[(value[row:], kind[row:]) for value, kind in self.words], **columns)


@dataclass(eq=False)
class Start:
    """Where a program begins: the first ``row`` of its motion lines after which the places of all axes are
    known, and the words ``programmed`` (5,) until there, NaN where none."""

    row: int
    programmed: Floats


def find_start(moving: MotionLines) -> Start:
    """How the motion lines begin.

    A safe start drives Z, the rotary axes, then X and Y, one after the other from an unknown place: these
    rapids are no blocks. Where other lines than absolute rapids stand before the places of all axes are
    known, row 0 begins.
    """
    rapid = moving.mode == codes.RAPID
    rapids = slice(0, len(rapid) if rapid.all() else int(np.argmin(rapid)) + 1)
    kind = np.column_stack([kind[rapids] for _, kind in moving.words])
    meaning, vector = moving.meaning[rapids], moving.vector[rapids]
    row = np.arange(len(kind))[:, None]
    last = np.maximum.accumulate(np.where((kind == ABSOLUTE) | (kind == SHORTER), row, -1), axis=0)
    stretch = last_of(np.flatnonzero(np.diff(meaning, prepend=meaning[:1])), len(meaning))
    by_vector = np.asarray(~np.isnan(vector).all(axis=1))[:, None]
    known: Bools = np.column_stack([last[:, :3] >= stretch[:, None], (last[:, 3:] >= 0) | by_vector])
    whole = np.flatnonzero(known.all(axis=1))
    first = int(whole[0]) if len(whole) and not (kind[: whole[0] + 1] == STEP).any() else 0
    at = np.where(known[first], last[first], -1)
    programmed = np.array(
        [
            value[source] if source >= 0 else np.nan
            for (value, _), source in zip(moving.words, at.tolist(), strict=True)
        ]
    )
    return Start(first, programmed)


@dataclass(frozen=True, eq=False)
class Moves(MotionLines):
    """The motion lines (m,) with where they lead: ``before``, ``programmed`` (m, 5) the words at the start
    and end; ``lost``: rows whose vector no rotary words take up; ``named`` (m, 5) whether the line has that
    word as an absolute one."""

    before: Floats
    programmed: Floats
    lost: Ints
    named: Bools


def axis_words(lines: Lines, letter: str) -> tuple[Floats, Bytes]:
    """Return the word of an axis in each line, whichever form it has, and how it is meant; absolute ones are
    so under G90."""
    value = lines.column(letter)
    kind = np.where(np.isnan(value), NOTHING, ABSOLUTE).astype(np.int8)
    for forms, meant in ((codes.STEP_OF, STEP), (codes.SHORTER_OF, SHORTER)):
        if forms.get(letter) in lines.letters:
            other = lines.column(forms[letter])
            given = ~np.isnan(other)
            value[given], kind[given] = other[given], meant
    check_near(lines, letter, value)
    return value, kind


def absolute_anyway(lines: Lines, letter: str) -> Bools:
    """Return the lines (lines,) whose word of that letter is absolute whatever is in force
    (:data:`.codes.ABSOLUTE`)."""
    found = np.zeros(lines.count, np.bool_)
    if codes.ABSOLUTE in lines.letters and letter in codes.AXIS_LETTERS:
        words = lines.words
        marked = (words.letter == ord(codes.ABSOLUTE)) & (words.value == codes.AXIS_LETTERS.index(letter))
        found[words.line[marked]] = True
    return found


def check_near(lines: Lines, letter: str, value: Floats) -> None:
    """Raise ProgramError, naming the place, where a word ``value`` (lines,) of that letter is beyond
    :data:`FARTHEST`."""
    far = np.flatnonzero(np.abs(np.nan_to_num(value)) > FARTHEST)
    if len(far):
        at = np.flatnonzero((lines.words.line == far[0]) & (lines.words.letter == ord(letter)))
        place = lines.words.place(int(at[0])) if len(at) else f"line {far[0]}"
        raise ProgramError(
            say(
                "{place}: {letter}{value} is beyond {farthest}; is a decimal point missing?",
                place=place,
                letter=letter,
                value=Number(value[far[0]]),
                farthest=Number(FARTHEST),
            ),
            letter,
        )


def find_wraps(kinematics: Chain) -> tuple[str, str]:
    """Return how the controller takes each rotary word, as the machine file says."""
    first, second = (axis.wrap for axis in kinematics.axes[3:])
    return first, second


def find_moves(moving: MotionLines, kinematics: Chain, planes: Planes | None) -> Moves:
    """Return where the motion lines lead, those of a safe start left out."""
    start = find_start(moving)
    moving = moving.begin(start.row)
    count, lost, meaning = len(moving.at), [np.empty(0, np.int64)], moving.meaning
    before, programmed = np.empty((5, count)).T, np.empty((5, count)).T
    named = np.column_stack([(kind == ABSOLUTE) | (kind == SHORTER) for _, kind in moving.words])
    named[0] |= ~np.isnan(start.programmed)
    place, modulo = (
        np.nan_to_num(start.programmed),
        [False] * 3 + [one == "modulo" for one in find_wraps(kinematics)],
    )
    cuts = np.flatnonzero((moving.on[1:] != moving.on[:-1]) | (meaning[1:] != meaning[:-1])) + 1
    for first, last in pairwise([0, *cuts.tolist(), count]):
        rows = slice(first, last)
        if first:
            place = _pose(
                kinematics, programmed[first - 1], int(meaning[first - 1]), int(meaning[first]), planes
            )
        words = [(value[rows], kind[rows]) for value, kind in moving.words]
        for k, (value, kind) in enumerate(words):
            programmed[rows, k] = track(value, kind, place[k], first > 0, modulo[k])
        if moving.on[first] and not np.isnan(moving.vector[rows]).all():
            turned = programmed[rows, 3:]
            lost.append(first + _turn(kinematics, turned, moving.vector[rows], words[3:], place[3:]))
        before[first], before[first + 1 : last] = place, programmed[first : last - 1]
    before[0] = programmed[0]
    return Moves(**vars(moving), before=before, programmed=programmed, lost=np.concatenate(lost), named=named)


def _pose(kinematics: Chain, programmed: Floats, was: int, now: int, planes: Planes | None) -> Floats:
    """Return the same pose as the next stretch says it; what X Y Z mean there, and meant before."""
    words = programmed[None]
    if was == now:
        return programmed
    words = in_work(words, np.array([was]), planes)
    if _of_tip(was, planes):
        words = standing(kinematics, words[:, :3], words[:, 3:])
    if _of_tip(now, planes):
        words = np.concatenate([forward(kinematics, words_to_q(words))[0], words[:, 3:]], axis=1)
    if planes is not None and now >= IN_PLANE:
        words[0, :3] = planes.in_plane(words[0, :3], now)
    return np.asarray(words[0])


def _of_tip(meaning: int, planes: Planes | None) -> bool:
    """Whether X Y Z of that meaning are the tip's."""
    if planes is None or meaning < IN_PLANE:
        return meaning != JOINTS
    return bool(planes.by_tip(np.array([meaning]))[0])


def in_work(programmed: Floats, meaning: Ints, planes: Planes | None) -> Floats:
    """Return the programmed words (m, 5), with the tip's place in the work where X Y Z stand in a tilted
    plane."""
    if planes is None:
        return programmed
    place = programmed.copy(order="K")
    place[:, :3] = planes.in_work(programmed[:, :3], meaning)
    return place


def track(value: Floats, kind: Bytes, start: float, known: bool, modulo: bool) -> Floats:
    """Places (n,) of one axis from its words (n,) and where it was before, if that is ``known``."""
    count, absolute = len(value), (kind == ABSOLUTE) | (kind == SHORTER)
    anchor = last_of(np.flatnonzero(absolute) + 1, count + 1)[1:]
    place: Floats = np.concatenate([[start], value])[anchor]
    step = kind == STEP
    if step.any():
        travelled = np.cumsum(np.where(step, value, 0.0))
        place += travelled - np.concatenate([[0.0], travelled])[anchor]
    shorter = absolute if modulo else kind == SHORTER
    if shorter.any():
        turns = np.where(shorter, -np.rint((place - np.concatenate([[start], place[:-1]])) / 360.0), 0.0)
        turns[0] *= known
        turns = np.cumsum(turns)
        anew = last_of(np.flatnonzero(absolute & ~shorter) + 1, count + 1)[1:]
        turns -= np.concatenate([[0.0], turns])[anew]
        place = np.where(turns != 0.0, np.round(place + 360.0 * turns, 9), place)
    return place


def _turn(kinematics: Chain, rotary: Floats, vector: Floats, words: AxisWords, start: Floats) -> Ints:
    """Put the words that the vectors (m, 3) ask for into ``rotary`` (m, 2), of which the lines say ``words``;
    return the rows that nothing takes up."""
    none = np.asarray(np.isnan(vector).all(axis=1))
    vector = np.where(none[:, None], np.nan, np.nan_to_num(vector))
    length = np.linalg.norm(vector, axis=1)
    given = np.flatnonzero(length > 1e-9)
    if not len(given):
        return given
    angles, reached = _angles(kinematics, vector[given] / length[given, None], start)
    keep = given[reached]
    count = len(vector)
    by_vector = last_of(keep + 1, count + 1)[1:]
    named = np.logical_or.reduce([kind != NOTHING for _, kind in words])
    by_words = last_of(np.flatnonzero(named) + 1, count + 1)[1:]
    turned = np.flatnonzero((by_vector > 0) & (by_vector >= by_words))
    rotary[turned] = angles[reached][np.searchsorted(keep, by_vector[turned] - 1)]
    return given[~reached]


def _angles(kinematics: Chain, axis: Floats, start: Floats) -> tuple[Floats, Bools]:
    """Rotary words (n, 2) degrees for unit axes (n, 3), and which of them the machine takes up: the way of
    least travel. From one vector to the next the axis is led through the pole where it passes there."""
    branches, sine = inverse_axis(kinematics, axis)
    reached: Bools = np.asarray(~np.isnan(branches).all(axis=(0, 2)))
    angles = branches[:, reached]
    if angles.shape[1] == 0:
        return np.empty((len(axis), 2)), reached
    pole = sine[reached] < AT_POLE
    source = last_of(np.flatnonzero(~pole) + 1, len(pole) + 1)[1:]
    for branch in angles:
        branch[pole, 0] = np.concatenate([[np.radians(start[0])], branch[:, 0]])[source[pole]]
    fits = within_limits(angles, kinematics.low[3:], kinematics.high[3:])
    none = ~fits.any(axis=0)
    fits[:, none] = ~np.isnan(angles[:, none, 0] + angles[:, none, 1])
    low, high = kinematics.low[3:], kinematics.high[3:]
    if (
        none.any()
    ):  # no way keeps to the limits: the least travel without them, which the check of limits then reports
        low, high = np.full(2, -np.inf), np.full(2, np.inf)
    _, crossing = find_crossings(axis[reached], kinematics.direction[3])
    words, _ = choose(angles, fits, low, high, np.ones(len(crossing), np.bool_), crossing)
    found = np.empty((len(axis), 2))
    found[reached] = np.degrees(words)
    return found, reached


def where_axes_stand(kinematics: Chain, programmed: Floats, by_tip: Bools) -> Floats:
    """Words (m, 5) mm and degrees of the axes, from what the lines say; ``by_tip`` (m,): X Y Z are
    the tip's place in the work."""
    rows = np.flatnonzero(by_tip)
    if not len(rows):
        return programmed
    words = programmed.copy(order="K")
    words[rows] = standing(kinematics, programmed[rows, :3], programmed[rows, 3:])
    lost = np.flatnonzero(np.isnan(words[rows, :3]).any(axis=1))
    if len(lost):
        first, second = programmed[rows[lost[0]], 3:]
        raise ProgramError(
            say(
                "with {letter}{first} {other}{second} the linear axes cannot place the tip; is it this "
                "machine's program?",
                letter=kinematics.letters[3],
                first=Number(first),
                other=kinematics.letters[4],
                second=Number(second),
            ),
            (first, second),
        )  # fmt: skip
    return words


def tool_axes(kinematics: Chain, words: Floats) -> Floats:
    """Return the tool axis (m, 3) at words (m, 5) mm and degrees."""
    return forward(kinematics, words_to_q(words))[1]
