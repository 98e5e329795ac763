# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moment that is shown, and how it moves on: by time, by block, to the worst block, to the next singular one.

moment   a block and its u (0 to 1), as in the core's playback.
"""

from __future__ import annotations

from freecad_fiveaxis.core.report import Figures
from freecad_fiveaxis.core.report.playback import Playback, Pose, following


class Player:
    """Plays the program of ``figures``; begins at its first position. Raises ProgramError for a program without a block."""

    def __init__(self, figures: Figures) -> None:
        self.figures = figures
        self.playback = Playback(figures.kinematics, figures.program, figures.judged)
        self.singular = figures.feeds[figures.singularity.singular[figures.feeds]]
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

    def advance(self, seconds: float) -> None:
        """Go on by so much of the program's time."""
        self.go_to_time(self.time + seconds)

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
        """To where the judged point is farthest from its segment, in the worst of all feed blocks; False where no block feeds."""
        return self._look_at(self.playback.worst)

    def go_to_next_singular(self) -> bool:
        """To the next singular block, from the last one on to the first again; False where there is none."""
        return self._look_at(following(self.singular, self.block))

    def _look_at(self, block: int | None) -> bool:
        """To where the judged point is farthest from the segment of ``block``."""
        if block is None:
            return False
        self.block, self.u = block, float(self.figures.judged.u_segment[block])
        return True

    def resume(self, other: Player) -> None:
        """Stand where another player stood, as far as this program goes."""
        self.block, self.u = min(other.block, self.last), other.u
