# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stays unfinished of the surface asked for, by why, as far as findings say it.

out of reach      facets beyond the machine's limits, facets without a free axis, and of what stays uncut what
                  is too tight for the ball at the cutter's end.
left by settings  facets that lean more than the largest axis angle, and what the allowance on faces to avoid
                  keeps the tool off.
missed            all else: nothing says that the tool cannot get there. Whether it can is not known of the
                  shank and the holder, nor of a cutter without a ball at its end.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.sentences import Number, Sentence, join_sentences, say

NOTABLE_SHARE = 0.005
"""Of the surface asked for: where less stays unfinished, what is said of the single places tells it."""

WHY: Mapping[Code, Sentence] = {
    Code.FACETS_BEYOND_MACHINE: say("beyond the machine's limits"),
    Code.AXIS_BEYOND_LIMITS: say("beyond the machine's limits"),
    Code.FACETS_WITHOUT_FREE_AXIS: say("no free axis"),
    Code.UNCUT_TOO_TIGHT: say("tighter than the cutter"),
    Code.UNCUT_AT_TABLE: say("the table is in the way"),
    Code.UNCUT_AT_FIXTURE: say("a fixture is in the way"),
}
"""The codes of findings on what the tool cannot reach."""

BY_SETTINGS = (Code.FACETS_BEYOND_AXIS_ANGLE, Code.FACETS_NEAR_AVOIDED, Code.NEAR_AVOIDED_FACES)
"""The codes of findings on what the settings keep the tool off."""


@dataclass(frozen=True)
class Unfinished:
    """Shares, 0 to 1, of the surface asked for: ``whole`` that stays unfinished; of it ``beyond`` what is out
    of reach, by the code of WHY, and ``set_aside`` what the settings leave. ``at_least``: more may stay, for
    of what passes leave in corners it is not known how much that is."""

    whole: float
    beyond: Mapping[Code, float]
    set_aside: float
    at_least: bool = False

    @property
    def out_of_reach(self) -> float:
        """What the tool cannot reach, for whatever reason."""
        return min(sum(self.beyond.values()), self.whole)

    @property
    def missed(self) -> float:
        """What stays besides."""
        return max(self.whole - self.out_of_reach - self.set_aside, 0.0)

    def parts(self) -> dict[str, float]:
        """Return the three shares by their names, for scripts; together they are the whole."""
        return {
            "out_of_reach": self.out_of_reach,
            "left_by_settings": self.set_aside,
            "missed": self.missed,
        }


def name_unfinished(share: float, parts: Unfinished | None) -> Sentence:
    """Say which ``share`` stays unfinished, and where some of it is out of reach how much of it that is, and
    why."""
    given = _percent(share)
    text = say("{share} % of the surface to be milled stays unfinished", share=given)
    if parts is not None and parts.at_least:
        text = say("at least {share} % of the surface to be milled stays unfinished", share=given)
    if parts is None or parts.out_of_reach < NOTABLE_SHARE:
        return text
    reasons = {str(WHY[code]): WHY[code] for code, one in parts.beyond.items() if one > 0.0}
    why = join_sentences(list(reasons.values()), ", ")
    if parts.missed + parts.set_aside < NOTABLE_SHARE:
        return text + say(": the tool cannot reach it ({why})", why=why)
    beyond = say("{share} % the tool cannot reach ({why})", share=_percent(parts.out_of_reach), why=why)
    clauses = [beyond]
    if parts.set_aside >= NOTABLE_SHARE:
        clauses.append(say("{share} % the settings leave out", share=_percent(parts.set_aside)))
    if parts.missed >= NOTABLE_SHARE:
        clauses.append(say("{share} % it missed", share=_percent(parts.missed)))
    return text + say(": {parts}", parts=join_sentences(clauses, ", "))


def _percent(share: float) -> Number:
    return Number(100.0 * share, ".2g")
