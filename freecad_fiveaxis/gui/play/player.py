# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moment that is shown, and how it moves on: by time, by block, to the worst block, to the next singular
one, to the next collision or near miss.

moment   a block and its u (0 to 1), as in the core's playback.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, Hit
from freecad_fiveaxis.core.report import Figures
from freecad_fiveaxis.core.report.playback import Playback, Pose, following
from freecad_fiveaxis.core.tool.body import PARTS, SPINDLE


class Struck(NamedTuple):
    """What is hit at a moment, or nearly: names of ``bodies`` of the machine and of ``fixtures``;
    ``spindle``: whether that hits, or nearly."""

    bodies: frozenset[str] = frozenset()
    fixtures: frozenset[str] = frozenset()
    spindle: bool = False


class Player:
    """Plays the program of ``figures``; begins at its first position. Raises ProgramError for a program
    without a block."""

    def __init__(self, figures: Figures) -> None:
        self.figures = figures
        self.playback = Playback(figures.kinematics, figures.program, figures.judged)
        self.singular = figures.feeds[figures.singularity.singular[figures.feeds]]
        self.stops = sorted(
            (one for one in figures.findings if _find_hit(one) is not None and one.block is not None),
            key=lambda one: (one.block, _deepest(one)),
        )
        self.colliding = np.unique([one.block for one in self.stops]).astype(int)
        self._stop_times = np.array(
            [float(self.playback.time(one.block or 0, _deepest(one))) for one in self.stops]
        )
        self.last = len(figures.program.words) - 1
        self.block, self.u = 0, 1.0

    @property
    def pose(self) -> Pose:
        """Where everything stands now."""
        return self.playback.at_block(self.block, self.u)

    @property
    def time(self) -> float:
        """Seconds from the program's start."""
        return float(self.playback.time(self.block, self.u))

    @property
    def at_end(self) -> bool:
        """Whether nothing comes any more."""
        return self.block == self.last and self.u >= 1.0

    def share(self) -> float:
        """How much of the program's time is done, 0 to 1."""
        return self.time / self.playback.seconds if self.playback.seconds > 0.0 else float(self.at_end)

    def go_to_share(self, share: float) -> None:
        """Go to a share, 0 to 1, of the program's time."""
        self.go_to_time(share * self.playback.seconds)

    def go_to_time(self, seconds: float) -> None:
        """Go to a time; before the start is the start, after the end the end."""
        block, u = self.playback.spot(seconds)
        self.block, self.u = int(block), float(u)

    def advance(self, seconds: float) -> bool:
        """Go on by so much of the program's time, but no farther than to the next collision or near miss;
        True where that is reached."""
        now = self.time
        ahead = np.flatnonzero((self._stop_times > now) & (self._stop_times <= now + seconds))
        if len(ahead):
            first = self.stops[ahead[self._stop_times[ahead].argmin()]]
            self.block, self.u = int(first.block or 0), _deepest(first)
        else:
            self.go_to_time(now + seconds)
        return bool(len(ahead))

    def begin(self) -> None:
        """Back to the first position."""
        self.block, self.u = 0, 1.0

    def forward(self) -> None:
        """To the end of this block, or of the next one where this one is done."""
        if self.u >= 1.0 and self.block < self.last:
            self.block += 1
        self.u = 1.0

    def back(self) -> None:
        """To the end of the block before."""
        self.block, self.u = max(self.block - 1, 0), 1.0

    def go_to_worst(self) -> bool:
        """To where the judged point is farthest from its segment, in the worst of all feed blocks; False
        where no block feeds."""
        return self._look_at(self.playback.worst)

    def go_to_next_singular(self) -> bool:
        """To the next singular block, from the last one on to the first again; False where there is none."""
        return self._look_at(following(self.singular, self.block))

    def go_to_next_collision(self) -> bool:
        """To the deepest place of the next block that collides, or to the nearest of one that nearly does, in
        order of time, from the last one on to the first again; False where there is none."""
        block = following(self.colliding, self.block)
        if block is None:
            return False
        self.block, self.u = block, _deepest(next(one for one in self.stops if one.block == block))
        return True

    @property
    def met(self) -> list[Finding]:
        """The collisions and near misses whose deepest or nearest place is in this block."""
        return [one for one in self.stops if one.block == self.block]

    @property
    def struck(self) -> Struck:
        """What the collisions are between."""
        return _between([(one.code, one.hit) for one in self.met if one.hit is not None])

    @property
    def near(self) -> Struck:
        """What the near misses are between."""
        return _between([(one.code, one.near) for one in self.met if one.near is not None])

    def _look_at(self, block: int | None) -> bool:
        """To where the judged point is farthest from the segment of ``block``."""
        if block is None:
            return False
        self.block, self.u = block, float(self.figures.judged.u_segment[block])
        return True

    def resume(self, other: Player) -> None:
        """Stand where another player stood, as far as this program goes."""
        self.block, self.u = min(other.block, self.last), other.u


def _between(hits: Sequence[tuple[str, Hit]]) -> Struck:
    """Return what is hit, of findings by their codes. A body of the machine may be what enters, and a fixture
    what it enters."""
    fixture = (Code.FIXTURE_COLLISION, Code.FIXTURE_NEAR)
    machine = [hit for code, hit in hits if code not in fixture]
    return Struck(
        frozenset(
            name for hit in machine for name in (hit.enters, hit.entered) if name and name not in PARTS
        ),
        frozenset(
            hit.entered for code, hit in hits if code in fixture or (hit.entered and hit.enters not in PARTS)
        ),
        any(hit.enters == PARTS[SPINDLE] for _, hit in hits),
    )


def _find_hit(finding: Finding) -> Hit | None:
    """Return the collision or near miss of a finding."""
    return finding.hit or finding.near


def _deepest(finding: Finding) -> float:
    """When in its block a collision is deepest or a near miss nearest, 0 to 1; the block's end where that is
    not known."""
    met = _find_hit(finding)
    return 1.0 if met is None or met.u is None else met.u
