# SPDX-License-Identifier: LGPL-2.1-or-later
"""One CL path on several machines, with each cure, with and without tool-centre control.

station   a machine with the part clamped on it, and how it is posted for.
cure      a way from the CL path to joints that deviate less: a function, so that every cure there is, and
          none, stands in the same table. A cure may divide blocks or lead the axes otherwise; it must not
          move what is cut.
pair      a station and a cure: the work of one worker, where there are several. No more workers have anything
          to do than there are pairs.
row       one combination. Its deviation is that of its own rounded blocks from the segments that they
          command; where there are fixtures, its program is proven against them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError, SettingsError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.base.spread import spread
from freecad_fiveaxis.core.gouge.fixtures import box_with
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain
from freecad_fiveaxis.core.motion.deviation import Deviation, measure, measure_above
from freecad_fiveaxis.core.motion.joint_path import JointPath, solve
from freecad_fiveaxis.core.motion.program import Program, build_program, feed_blocks
from freecad_fiveaxis.core.report.figures import axis_rates
from freecad_fiveaxis.core.studies.setup_map import Posting, part_box
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .beside_fixtures import Beside, find_hits, guide_tip
from .beside_part import CheckPart
from .tool_centre import guide

NO_RATES = (math.nan,) * 5


@dataclass(frozen=True, eq=False)
class Station:
    """``kinematics``: the machine in its setup. ``name`` as it stands in the table. ``refused``: why the
    machine cannot do what is asked for at all, or empty. ``beside``: the fixtures, None: there are none.
    ``setup``: that of the kinematics; ``check_part``: finds what a program enters of the part, None: that is
    not looked at."""

    name: str
    machine: Machine
    kinematics: Chain
    posting: Posting
    refused: str = ""
    beside: Beside | None = None
    setup: Setup = Setup()
    check_part: CheckPart | None = None


Cure = Callable[[CLPath, Station, Progress], JointPath]
"""From the CL path to the joints of one station. One that makes other joints where the controller guides
the tip has a method ``solve_guided`` for these, of a station: None where they are the same; one that does not
cut all of the surface has ``compute_left_out``, the share of it."""


@dataclass(frozen=True)
class Row:
    """``tool_centre``: the controller guides the tip. ``deviation``, ``bound`` mm and ``axis_deviation`` rad:
    the largest of the feed blocks, of a ball its centre's; ``time`` s of the whole program; ``peak_rate``:
    the largest rate of each axis, in the order of ``letters``, in a feed block, mm/min and rad/min; ``over``
    mm beyond linear limits. ``problem``: why there are no figures (then NaN), or empty. ``fixtures``: what
    hits a fixture or comes too near to one, None: there are none to look at. ``part``: what the program
    enters of part and table, None: that was not looked at; ``left_out``: the share, 0 to 1, of the surface
    asked for that the machine does not cut; ``length`` mm: how far the driven point goes in feed blocks;
    ``imagined``: the name of the controller, where it would have to guide the tip and cannot, else empty.
    """

    machine: str
    cure: str
    tool_centre: bool
    letters: str
    deviation: float = math.nan
    bound: float = math.nan
    axis_deviation: float = math.nan
    blocks: int = 0
    feed_blocks: int = 0
    time: float = math.nan
    peak_rate: tuple[float, ...] = NO_RATES
    over: float = math.nan
    problem: str = ""
    fixtures: tuple[Finding, ...] | None = None
    part: tuple[Finding, ...] | None = None
    left_out: float = 0.0
    length: float = math.nan
    imagined: str = ""


def station(
    machine: Machine, setup: Setup, posting: Posting, name: str = "", refused: str = "",
    beside: Beside | None = None, check_part: CheckPart | None = None,
) -> Station:  # fmt: skip
    """Return a machine with the part clamped in ``setup``. Raises MachineError for a chain without a
    solution."""
    kinematics = chain(machine, setup)
    return Station(name or machine.name, machine, kinematics, posting, refused, beside, setup, check_part)


def solve_path(path: CLPath, where: Station, progress: Progress = silent) -> JointPath:
    """Return the cure that is none: the joints as ``joint_path.solve`` finds them."""
    box, beside, tool = part_box(path, where.posting.part), where.beside, None
    if beside is not None:
        box, tool = box_with(box, beside.fixtures), beside.rapid
    return solve(path, where.kinematics, *box, where.posting.clearance, where.posting.radius, progress, tool)


NO_CURE: Mapping[str, Cure] = {"none": solve_path}


def compare(
    path: CLPath, stations: Sequence[Station], cures: Mapping[str, Cure] = NO_CURE,
    guided: Sequence[bool] = (False, True),
    progress: Progress = silent, executor: Executor | None = None,
) -> tuple[Row, ...]:  # fmt: skip
    """Return a row for each station, each cure, and each of ``guided`` (tool-centre control), in this order.

    What cannot be done (a machine that does not take up an axis, a cure that refuses) is a row with its
    problem. ``executor``: whose workers do a pair of station and cure each (for processes the cures must
    pickle), with the same rows to the last bit; None: all is done here. Raises SettingsError where there is
    nothing to compare, and what a cancelling ``progress`` raises.
    """
    if not stations or not cures or not guided:
        raise SettingsError(
            say("there is nothing to compare; name at least one machine and one correction"), 0
        )
    if not len(path.tip):
        raise SettingsError(say("there is no path to compare on: it has no rows"), 0)
    pairs = [Pair(place, name) for place in range(len(stations)) for name in cures]
    work = Compared(path, tuple(stations), dict(cures), tuple(guided))
    return tuple(
        row for rows in spread(_pair_rows, work, pairs, executor, progress, "compare") for row in rows
    )


@dataclass(frozen=True, eq=False)
class Compared:
    """What all pairs have in common."""

    path: CLPath
    stations: tuple[Station, ...]
    cures: dict[str, Cure]
    guided: tuple[bool, ...]


@dataclass(frozen=True)
class Pair:
    """``place`` of a station among all, and the name of a cure."""

    place: int
    cure: str


def _pair_rows(work: Compared, pair: Pair, progress: Progress) -> list[Row]:
    share = Share(progress)
    share("", 0.0)
    return _rows(work.path, work.stations[pair.place], pair.cure, work.cures[pair.cure], work.guided, share)


class Share:
    """The progress of one pair, of ``count`` the one ``at`` this place, as that of the whole. A cure has many
    stages, each from 0 to 1, and nobody knows how many are to come: each new one takes up half of what is
    left, so that the whole never goes back."""

    def __init__(self, progress: Progress, at: int = 0, count: int = 1) -> None:
        self._progress, self._at, self._count = progress, at, count
        self._stage, self._last, self._begin, self._room = "", 0.0, 0.0, 0.5

    def __call__(self, stage: str, fraction: float) -> None:
        """Tell how far a stage is, of the share that falls to this one."""
        fraction = min(max(fraction, 0.0), 1.0)
        if stage != self._stage or fraction < self._last:
            self._begin += self._room * self._last
            self._room, self._stage = 0.5 * (1.0 - self._begin), stage
        self._last = fraction
        self._progress("compare", (self._at + self._begin + self._room * fraction) / self._count)


def _rows(
    path: CLPath, where: Station, name: str, cure: Cure, guided: Sequence[bool], progress: Progress
) -> list[Row]:
    letters = where.kinematics.letters
    if where.refused:
        return [Row(where.name, name, one, letters, problem=where.refused) for one in guided]
    drives = _Drives(path, where, cure, progress)
    rows = (_row(drives, name, one, progress) for one in guided)
    dialect = where.posting.dialect
    return [
        replace(row, imagined=dialect.name) if one and not dialect.guides else row
        for one, row in zip(guided, rows, strict=True)
    ]


class _Drives:
    """The programs of a pair: as they are, and where the controller guides the tip; each made once, when it
    is asked for."""

    def __init__(self, path: CLPath, where: Station, cure: Cure, progress: Progress) -> None:
        self.where, self._path, self._cure, self._progress = where, path, cure, progress

    @cached_property
    def plain(self) -> Drive:
        """That of the joints as they are. Raises FiveAxisError."""
        return self._drive(self._cure(self._path, self.where, self._progress))

    @cached_property
    def guided(self) -> Drive:
        """That of the joints where the tip is guided. Raises FiveAxisError."""
        own = getattr(self._cure, "solve_guided", None)
        joints = None if own is None else own(self.where, self._progress)
        return self.plain if joints is None else self._drive(joints)

    @cached_property
    def left_out(self) -> float:
        """The share of the surface that is not cut."""
        own = getattr(self._cure, "compute_left_out", None)
        return 0.0 if own is None else float(own(self.where, self._progress))

    def _drive(self, joints: JointPath) -> Drive:
        where = self.where
        program = build_program(joints, where.kinematics, where.posting.dialect, where.posting.inverse_time)
        return Drive(joints, program, _measure_surface(where, program))


class Drive(NamedTuple):
    """Joints, their program, and its deviation."""

    joints: JointPath
    program: Program
    deviation: Deviation


def _row(drives: _Drives, name: str, guided: bool, progress: Progress) -> Row:
    where = drives.where
    make = _make_guided_row if guided else _make_unguided_row
    try:
        drive = drives.guided if guided else drives.plain
        row = make(where, name, *drive, progress)
        return replace(row, left_out=drives.left_out, length=_fed_length(drive.joints, drive.program))
    except Cancelled:
        raise
    except FiveAxisError as error:
        return Row(where.name, name, guided, where.kinematics.letters, problem=error.text)


def _fed_length(joints: JointPath, program: Program) -> float:
    """Return how far the driven point goes from end to end of the feed blocks, mm."""
    tip = joints.path.tip[program.row]
    chord = np.linalg.norm(np.diff(tip, axis=0), axis=1)
    return float(chord[feed_blocks(program) - 1].sum())


def _look_at_part(where: Station, program: Program, progress: Progress) -> tuple[Finding, ...] | None:
    return None if where.check_part is None else where.check_part(program, progress)


def _look_beside(where: Station, program: Program, progress: Progress) -> tuple[Finding, ...] | None:
    return None if where.beside is None else find_hits(where.beside, where.kinematics, program, progress)


def _measure_surface(where: Station, program: Program) -> Deviation:
    """Return the deviation of what makes the surface: a ball's centre, else the tip."""
    above, dialect = where.posting.above, where.posting.dialect
    if above == 0.0:
        return measure(where.kinematics, program.words)
    return measure_above(where.kinematics, program.words, above, dialect.linear_decimals, unit=dialect.unit)


def _make_unguided_row(
    where: Station, name: str, joints: JointPath, program: Program, deviation: Deviation, progress: Progress
) -> Row:
    feeds = feed_blocks(program)
    rates = axis_rates(program)[feeds].max(axis=0, initial=0.0) * np.array(
        [1.0, 1.0, 1.0, *[math.pi / 180.0] * 2]
    )
    return Row(
        where.name, name, False, where.kinematics.letters, _largest(deviation.segment[feeds]),
        _largest(deviation.bound[feeds]),
        _largest(deviation.axis[feeds]), len(program.words), len(feeds), float(program.seconds.sum()),
        tuple(rates.tolist()),
        _over(where.kinematics, joints.q), fixtures=_look_beside(where, program, progress),
        part=_look_at_part(where, program, progress),
    )  # fmt: skip


def _make_guided_row(
    where: Station, name: str, joints: JointPath, program: Program, deviation: Deviation, progress: Progress
) -> Row:
    feeds, row, dialect = feed_blocks(program), program.row, where.posting.dialect
    tip = np.stack([dialect.round_word(joints.path.tip[row, k], k) for k in range(3)], axis=1)
    guided = guide(
        where.kinematics, tip, np.radians(program.words[:, 3:]), program.motion, joints.path.feed[row]
    )
    posted = guide_tip(where.kinematics, program, tip)
    return Row(
        where.name, name, True, where.kinematics.letters, 0.0, 0.0, _largest(deviation.axis[feeds]), len(row),
        len(feeds),
        float(guided.seconds.sum()), tuple(guided.rates(feeds).tolist()), _over(where.kinematics, joints.q),
        fixtures=_look_beside(where, posted, progress), part=_look_at_part(where, posted, progress),
    )  # fmt: skip


def _largest(values: Floats) -> float:
    return float(values.max(initial=0.0))


def _over(kinematics: Chain, q: Floats) -> float:
    """How far the linear axes go beyond their limits, mm."""
    return float(np.maximum(q[:, :3] - kinematics.high[:3], kinematics.low[:3] - q[:, :3]).max(initial=0.0))
