# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a finished program in numbers.

feed block    a block that may touch the part: CUT, FILL or LINK (in a foreign program every G1). Every figure
              of the summary judges the feed blocks and none of the rapids: a rapid is driven in the air,
              where it may leave its line. The table of blocks (``block_table``) and ``max_rapid_deviation``
              show the rapids too.
surface       of a ball the way of its centre makes the surface, not that of the tip: where that is known
              (``Figures.surface``) it is what is judged, against the centre's own chord. The tip's deviation
              stays beside it.
proven        the proven bound of every feed block is within the tolerance, and in none of them the controller
              guides the tip (``guided_blocks``), which is its own affair. ``over_tolerance`` counts the feed
              blocks whose judged deviation from the commanded segment exceeds it, ``unproven`` those where
              only the bound does.
block         a row of the Program, counted from 0; ``line`` a line of the NC file, counted from 1.
pass          a run of CUT and FILL blocks between links and rapids. ``cut_length`` is theirs, ``link_length``
              that of other feed blocks, ``rapid_length`` that of the rapids: of the tip over the work, mm.
ends          the first and last moves of the NC file that are no blocks (:mod:`.ends`): axes and length of
              rapids count them as far as they are known; the time is that of the blocks.
peak rate     the largest mean rate of an axis over a feed block; travels and word ranges are those of all
              blocks.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from freecad_fiveaxis.core.audit import Audit
from freecad_fiveaxis.core.audit.rates import RATE_ROUNDING
from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.ranges import ROUNDING
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Sentence
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge import GougeCheck, RestMaterial
from freecad_fiveaxis.core.gouge.above_bodies import AbovePlane
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Chain, forward
from freecad_fiveaxis.core.motion.deviation import Deviation
from freecad_fiveaxis.core.motion.program import Program, feed_blocks, find_unknown_ways
from freecad_fiveaxis.core.motion.singularity import Singularity
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .audited import audit_rows, summarize_audit, worst_of
from .block_table import letter_order
from .contacts import Contacts
from .ends import measure_ends
from .near_part import near_part
from .part_facts import part_numbers
from .turns_at_pole import find_turns_at_pole
from .unfinished import Unfinished

WORST = 10
"""So many single blocks are named; more tell nobody anything that the table of blocks does not tell
better."""
_CHUNK = 16384


@dataclass(frozen=True, eq=False)
class Figures:
    """All that a report shows. ``tolerance`` mm; ``findings`` those of every stage.

    ``program``, ``deviation`` and ``singularity`` have one row a block; ``kinematics`` is the chain that
    ``program`` is for. ``deviation`` is that of the driven point, ``surface`` that of the point that makes
    the surface, where it is another one. ``audit`` where there was one; ``gouge`` (a row less: its row i is
    block i + 1) and ``rest`` where the settings ask for them; ``allowed`` mm: so much may be left; ``mesh``:
    the part where it is known; ``unfinished``: the share, 0 to 1, of the surface asked for that stays
    unfinished, ``unfinished_parts`` the same by why; ``programmed_feed`` (m,) mm/min: how fast the tip was to
    go over the part, where that is known; ``contacts``: where a ball that leans touches the part; ``stand``
    mm: how far from the part what is drawn of a cut stands at most (``near_part``); ``rapids``: how the
    controller drives them, one of
    :data:`~freecad_fiveaxis.core.base.rapids.RAPIDS`; ``table``: height of the table's face, mm, that the
    tool was checked against, None: it was not; ``fixtures``: names of those that the tool was checked
    against; ``above``: the plane on which the program begins and ends, None where it is not proven to be
    above the machine's bodies; ``plane``: the word of Z, mm, of the plane from which the NC file comes to its
    first block and to which it retracts, None where it says no such word; ``units``: of
    the ``inputs`` that have one; ``assumed``: what the NC text does not say and is taken for granted.
    """

    title: str
    kind: str
    machine: Machine
    kinematics: Chain
    program: Program
    deviation: Deviation
    singularity: Singularity
    tolerance: float
    findings: tuple[Finding, ...] = ()
    inputs: Mapping[str, object] = field(default_factory=dict)
    audit: Audit | None = None
    gouge: GougeCheck | None = None
    rest: RestMaterial | None = None
    allowed: float = 0.0
    mesh: Mesh | None = None
    unfinished: float = 0.0
    unfinished_parts: Unfinished | None = None
    surface: Deviation | None = None
    programmed_feed: Floats | None = None
    contacts: Contacts | None = None
    stand: float = 0.0
    rapids: str = ""
    table: float | None = None
    fixtures: tuple[str, ...] = ()
    above: AbovePlane | None = None
    plane: float | None = None
    units: Mapping[str, str] = field(default_factory=dict)
    assumed: tuple[Sentence, ...] = ()

    @property
    def judged(self) -> Deviation:
        """The deviation that is held against the tolerance: the surface's where it is known, else that of the
        driven point."""
        return self.deviation if self.surface is None else self.surface

    @cached_property
    def feeds(self) -> Ints:
        """The rows of the feed blocks."""
        return feed_blocks(self.program)

    @cached_property
    def at_pole(self) -> Bools:
        """The blocks (m,) near the pole at which there is nothing to look at: the tool stands at it."""
        return find_turns_at_pole(
            self.kinematics, self.program, self.judged, self.singularity, self.tolerance, self.programmed_feed
        )

    @cached_property
    def worst(self) -> Ints:
        """The feed blocks of the largest deviation from the segment, largest first; none whose tip the
        controller guides."""
        guided = self.program.guided
        measured = self.feeds if guided is None else self.feeds[~guided.on[self.feeds]]
        return worst_first(measured, self.judged.segment, WORST)

    @cached_property
    def tip(self) -> Floats:
        """The commanded tip at each block's end (m, 3) mm, work frame."""
        return self._poses[0]

    @cached_property
    def axis(self) -> Floats:
        """The tool axis at each block's end (m, 3) unit, work frame."""
        return self._poses[1]

    def place_drawn_ends(self, rows: Ints) -> Floats:
        """Where the blocks (k,) are drawn to end (k, 3) mm: a ball that leans at its contact, all else at the
        tip."""
        return (
            self.tip[rows]
            if self.contacts is None
            else self.contacts.find_touched(self.tip[rows], self.axis[rows])
        )

    @cached_property
    def at_part(self) -> Bools:
        """At which blocks' ends (m,) the tool stands at the part; at all of them where no part is known."""
        rows = np.arange(len(self.program.words))
        if self.mesh is None or not len(rows):
            return np.ones(len(rows), bool)
        return near_part(self.mesh, self.place_drawn_ends(rows), self.stand)

    @cached_property
    def _poses(self) -> tuple[Floats, Floats]:
        q = self.program.words
        tip, axis = np.empty((3, len(q))).T, np.empty((3, len(q))).T
        for start in range(0, len(q), _CHUNK):
            part = slice(start, start + _CHUNK)
            tip[part], axis[part] = forward(self.kinematics, inner_words(q[part]))
        return tip, axis


def inner_words(words: Floats) -> Floats:
    """Program words (m, 5) mm and degrees as the kinematics takes them: mm and radians."""
    return np.concatenate([words[:, :3], np.radians(words[:, 3:])], axis=1)


def find_guided_feeds(program: Program) -> Ints:
    """Return the feed blocks in which the controller guides the tip: nothing is proven of them but where they
    end."""
    feeds = feed_blocks(program)
    return feeds[program.guided.on[feeds]] if program.guided is not None else feeds[:0]


def travel(program: Program) -> Floats:
    """How far each word moves in each block (m, 5) mm and degrees, signed; row 0 is 0, and where the
    way is not known."""
    columns = np.ascontiguousarray(program.words.T)  # whole columns are read from here on
    moved = np.zeros_like(columns)
    np.subtract(columns[:, 1:], columns[:, :-1], out=moved[:, 1:])
    moved[:, 1:][:, find_unknown_ways(program)] = 0.0
    return moved.T


def worst_first(rows: Ints, values: Floats, most: int | None = None) -> Ints:
    """``rows`` by their ``values`` (m,), NaN and then the largest first, the earlier block first among
    equals; only the first ``most`` (at least 1), None: all."""
    key = -np.nan_to_num(values[rows], nan=np.inf)
    if most is not None and len(rows) > most:  # no need to sort a million for the first of them
        some = np.flatnonzero(key <= np.partition(key, most - 1)[most - 1])
        rows, key = rows[some], key[some]
    return rows[np.argsort(key, kind="stable")][:most]


def axis_rates(program: Program) -> Floats:
    """Mean rate of each axis in each block (m, 5) mm/min and deg/min; 0 where no time is known."""
    minutes, moved = program.seconds[:, None] / 60.0, np.abs(travel(program))
    return np.divide(moved, minutes, out=np.zeros_like(moved), where=minutes > 0.0)


def summary(figures: Figures) -> dict[str, Any]:
    """Return the figures in numbers: lengths mm, angles degrees, times s. Limits may be infinite."""
    program, deviation, feeds, judged = figures.program, figures.deviation, figures.feeds, figures.judged
    segment, bound = deviation.segment[feeds], deviation.bound[feeds]
    over = ~(judged.segment[feeds] <= figures.tolerance)
    unproven = ~over & ~(judged.bound[feeds] <= figures.tolerance)
    worst = figures.worst
    rapid = deviation.segment[1:][(program.motion[1:] == Motion.RAPID) & ~find_unknown_ways(program)]
    return (
        {
            "title": figures.title,
            "kind": figures.kind,
            "machine": figures.machine.name,
            "tolerance": figures.tolerance,
            "proven": bool(len(feeds))
            and not over.any()
            and not unproven.any()
            and not len(find_guided_feeds(program)),
            "over_tolerance": int(over.sum()),
            "unproven": int(unproven.sum()),
            "guided_blocks": len(find_guided_feeds(program)),
            "max_surface_deviation": _largest(judged.segment[feeds]) if figures.surface else None,
            "max_surface_bound": _largest(judged.bound[feeds]) if figures.surface else None,
            "max_line_deviation": _largest(deviation.line[feeds]),
            "max_segment_deviation": _largest(segment),
            "max_bound": _largest(bound),
            "max_axis_deviation_deg": math.degrees(_largest(deviation.axis[feeds])),
            "max_rapid_deviation": _largest(rapid),
            "worst_line": int(program.line[worst[0]]) if len(worst) else None,
            "worst_block": int(worst[0]) if len(worst) else None,
            "worst_lines": _name_worst_lines(figures),
            "singular_blocks": int(figures.singularity.singular[feeds].sum()),
            "blocks_at_pole": int(figures.at_pole.sum()),
            "blocks": len(program.words),
            "feed_blocks": len(feeds),
            "time_s": float(program.seconds.sum()),
            "start_plane": figures.plane if len(program.words) else None,
            "findings": {
                kind.name.lower(): sum(f.severity == kind for f in figures.findings)
                for kind in reversed(Severity)
            },
        }
        | _sum_travel(figures)
        | summarize_audit(figures.program, figures.audit)
        | part_numbers(figures.program, figures.gouge, figures.rest, figures.tolerance, figures.allowed)
        | ({} if figures.mesh is None else {"unfinished_share": figures.unfinished})
        | ({} if figures.unfinished_parts is None else {"unfinished_parts": figures.unfinished_parts.parts()})
    )


def _name_worst_lines(figures: Figures) -> dict[str, int | None]:
    """Name the NC line of each largest number of the summary; None where there is no such number, or none but
    0."""
    program, deviation, judged = figures.program, figures.deviation, figures.judged
    ways = np.concatenate([[False], ~find_unknown_ways(program)]) if len(program.words) else np.zeros(0, bool)
    rapids = np.flatnonzero((program.motion == Motion.RAPID) & ways)
    columns = {
        "max_surface_deviation": (judged.segment, figures.feeds if figures.surface else figures.feeds[:0]),
        "max_surface_bound": (judged.bound, figures.feeds if figures.surface else figures.feeds[:0]),
        "max_line_deviation": (deviation.line, figures.feeds),
        "max_segment_deviation": (deviation.segment, figures.feeds),
        "max_bound": (deviation.bound, figures.feeds),
        "max_axis_deviation_deg": (deviation.axis, figures.feeds),
        "max_rapid_deviation": (deviation.segment, rapids),
    }
    first = {name: worst_first(rows, values, 1) for name, (values, rows) in columns.items()}
    return {
        name: int(program.line[row[0]]) if len(row) and columns[name][0][row[0]] != 0.0 else None
        for name, row in first.items()
    }


def worst_table(figures: Figures, rows: Ints | None = None) -> list[dict[str, Any]]:
    """Return the worst feed blocks (or ``rows``) as rows: mm and degrees; the rotary letters tell how far
    those axes turn in the block. With an audit each has what that found in it, too, and where the surface was
    judged its deviation and bound."""
    chosen = figures.worst if rows is None else rows
    more = (
        [{} for _ in chosen] if figures.audit is None else audit_rows(figures.program, figures.audit, chosen)
    )
    if (surface := figures.surface) is not None:
        more = [
            one
            | {"surface_deviation": float(surface.segment[row]), "surface_bound": float(surface.bound[row])}
            for one, row in zip(more, chosen, strict=True)
        ]
    program, deviation, moved = figures.program, figures.deviation, travel(figures.program)[chosen]
    angles = letter_order(program.letters)[3:]
    return [
        {
            "block": int(row),
            "line": int(program.line[row]),
            "motion": Motion(program.motion[row]).name.lower(),
            "segment_deviation": float(deviation.segment[row]),
            "u_segment": float(deviation.u_segment[row]),
            "bound": float(deviation.bound[row]),
            "line_deviation": float(deviation.line[row]),
            "axis_deviation_deg": math.degrees(deviation.axis[row]),
            "turn_deg": {program.letters[i]: float(moved[at, i]) for i in angles},
            "singular": bool(figures.singularity.singular[row]),
            "place": deviation.place[row].tolist(),
        }
        | more[at]
        for at, row in enumerate(chosen)
    ]


def table_of_deviations(figures: Figures) -> list[dict[str, Any]]:
    """Return :func:`worst_table`; nothing where no block deviates by more than rounding."""
    shown = figures.judged.segment[figures.worst]
    return worst_table(figures) if len(shown) and not shown.max() < ROUNDING else []


def worst_of_audit(figures: Figures) -> dict[str, list[dict[str, Any]]]:
    """Return the worst lines of an audit by ``limits``, ``rates`` and ``off`` (the CL path or the part), each
    as ``worst_table``."""
    if figures.audit is None:
        return {}
    off = figures.audit.off()[0]
    kinds = {
        "limits": (figures.audit.limits.excess, 0.0),
        "rates": (figures.audit.rates.ratio, 1.0 + RATE_ROUNDING),
    }
    kinds["off"] = (off, figures.tolerance)
    return {name: worst_table(figures, worst_of(values, above)) for name, (values, above) in kinds.items()}


def _largest(values: Floats) -> float:
    return float(values.max(initial=0.0))


def _sum_travel(figures: Figures) -> dict[str, object]:
    program, order = figures.program, letter_order(figures.program.letters)
    cutting = (program.motion == Motion.CUT) | (program.motion == Motion.FILL)
    cutting[:1] = False
    rapid = program.motion == Motion.RAPID
    kinds = {"cut": cutting, "link": ~cutting & ~rapid, "rapid": rapid}
    steps = np.linalg.norm(np.diff(figures.tip, axis=0), axis=1) * ~find_unknown_ways(program)
    moved, ways = np.abs(travel(program)).sum(axis=0), measure_ends(program, figures.plane)
    moved[2] += ways.sum()
    lengths = {kind: float(steps[rows[1:]].sum()) for kind, rows in kinds.items()}
    lengths["rapid"] += float(ways.sum())
    return {
        "passes": int((cutting[1:] & ~cutting[:-1]).sum()),
        **{f"{kind}_length": length for kind, length in lengths.items()},
        "time_shares": time_shares(program.seconds, kinds),
        "rotary_travel_deg": {program.letters[i]: float(moved[i]) for i in order[3:]},
        "axes": _axes(figures, order, moved),
    }


def time_shares(seconds: Floats, kinds: Mapping[str, Bools]) -> dict[str, float]:
    """Give the share, 0 to 1, of the time that blocks of each kind take; ``seconds`` (m,) of the blocks, the
    first stands."""
    whole = float(seconds[1:].sum())
    return {
        kind: float(seconds[1:][rows[1:]].sum()) / whole if whole > 0.0 else 0.0
        for kind, rows in kinds.items()
    }


def _axes(figures: Figures, order: list[int], moved: Floats) -> dict[str, dict[str, object]]:
    program, kinematics = figures.program, figures.kinematics
    inner = np.array([1.0, 1.0, 1.0, math.degrees(1.0), math.degrees(1.0)])
    words = program.words
    if figures.plane is not None and len(words):
        words = np.concatenate([words, words[:1]])
        words[-1, 2] = figures.plane
    columns = {
        "least": np.array([word.min(initial=math.inf) for word in words.T]),
        "largest": np.array([word.max(initial=-math.inf) for word in words.T]),
        "low_limit": kinematics.low * inner,
        "high_limit": kinematics.high * inner,
        "travel": moved,
        "peak_rate": np.array([rate[figures.feeds].max(initial=0.0) for rate in axis_rates(program).T]),
        "max_rate": kinematics.rate * inner,
    }
    return {
        program.letters[i]: {"unit": "mm" if i < 3 else "deg"}
        | {name: float(values[i]) for name, values in columns.items()}
        for i in order
    }
