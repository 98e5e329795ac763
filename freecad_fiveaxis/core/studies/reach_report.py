# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reach map as text, JSON and a page: areas by what is in the way."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping, Sequence
from html import escape

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.sentences import Area, Length, Option, Sentence, join_sentences, say
from freecad_fiveaxis.core.gouge.obstacles import Obstacle
from freecad_fiveaxis.core.report.text import WIDTH, number

from .reach_map import TILTS, UNDERCUTS, ReachMap
from .setup_map.sheet import Table, findings_list, findings_text, json_text, page, section, table, text_table

VERSION = 2
"""Of the JSON record: raised when a key changes its meaning."""

KEYS = {
    Obstacle.CUTTER: "tighter_than_cutter", Obstacle.LIMITS: "beyond_machine", Obstacle.TABLE: "below_table",
    Obstacle.SHANK: "shank", Obstacle.HOLDER: "holder", Obstacle.FIXTURE: "fixture",
    Obstacle.MACHINE: "machine", Obstacle.FLANK: "cutter_flank", Obstacle.HOLLOW: "closed_hollow",
}  # fmt: skip

WORTH = 1.01
"""Times what the step before reached: a longer step that adds less is not worth a line."""

LEAST = 1e-3
"""Of the whole area: where less is in the way of the cutter itself, what helps is not worth a line."""

NOTE = (
    "Each place was tried with axes along the facet's normal and up to 80 deg from it, and along bores and "
    "walls. What is called reachable is, with the axis tried; what is not may still be, between those axes. "
    "Limits are those of the rotary axes; the table counts where its height is known, fixtures where they "
    "are given, the machine where its file names bodies. A part of the tool may enter by the tolerance."
)

WAYS = say("Reachable is where the tool can stand; whether it gets there and away again is not asked.")


def reason(obstacle: Obstacle) -> Sentence:
    """Return what is in the way, in words."""
    return {
        Obstacle.LIMITS: say("beyond the machine's limits"), Obstacle.TABLE: say("below the table"),
        Obstacle.CUTTER: say("tighter than the cutter"), Obstacle.SHANK: say("shank in the way"),
        Obstacle.HOLDER: say("holder in the way"), Obstacle.FIXTURE: say("fixture in the way"),
        Obstacle.MACHINE: say("machine in the way"),
        Obstacle.FLANK: say("cutter's flank in the way"),
        Obstacle.HOLLOW: say("in a closed hollow, where no tool gets in"), Obstacle.NONE: say("reachable"),
    }[obstacle]  # fmt: skip


def share_reached(found: ReachMap) -> float:
    """0 to 1 of the area."""
    return found.area_of(Obstacle.NONE) / float(found.area.sum())


def verdict(found: ReachMap) -> Sentence:
    """How much can be reached, and what keeps the tool from most of the rest; what of it ``mill`` leaves
    out."""
    whole, reached = float(found.area.sum()), found.area_of(Obstacle.NONE)
    if reached >= whole * (1.0 - 1e-9):
        text = say("The tool gets everywhere: {area}.", area=Area(whole, ".5g"))
    else:
        worst = max(KEYS, key=found.area_of)
        text = say(
            "The tool gets to {share} % of the surface, {reached} of {area}; most of the rest is {reason}.",
            share=f"{100.0 * reached / whole:.1f}", reached=Area(reached, ".5g"), area=Area(whole, ".5g"),
            reason=reason(worst),
        )  # fmt: skip
    return join_sentences((text, _name_standing(found.standing))) if found.standing > 0.0 else text


def _name_standing(area: float) -> Sentence:
    return say(
        "Of what is reachable, {area} are the underside on which the part stands: mill cuts it only with "
        "{max_axis_angle}.",
        area=Area(area, ".5g"),
        max_axis_angle=Option("max_axis_angle"),
    )


def name_shut(found: ReachMap) -> tuple[Sentence, ...]:
    """Say on how much of what is reached the tool has no way out, where that is worth a line."""
    if found.shut <= LEAST * float(found.area.sum()):
        return ()
    text = say(
        "On about {area} of what is reachable the tool cannot be drawn out along any axis tried: mill leaves "
        "out passes that lead nowhere else.",
        area=Area(found.shut, ".3g"),
    )
    return (text,)


def stick_out(found: ReachMap) -> tuple[Sentence, ...]:
    """Return what a tool that sticks out farther would reach besides, by each step that adds to it."""
    texts, last = tuple[Sentence, ...](), 0.0
    for step, area in found.longer:
        if area > WORTH * last:
            text = say(
                "Let the tool stick out {step} farther and it reaches {area} more.",
                step=Length(step),
                area=Area(area, ".3g"),
            )
            texts, last = (*texts, text), area
    return texts


def name_fixtures(found: ReachMap) -> tuple[Sentence, ...]:
    """Say of each fixture that is in the way how much more the tool reaches without it, where that is worth a
    line."""
    least = LEAST * float(found.area.sum())
    return tuple(
        say(
            "Without the fixture {fixture} the tool reaches about {area} more.",
            fixture=name, area=Area(area, ".3g"),
        )
        for name, area in found.without if area > least
    )  # fmt: skip


def remedies(found: ReachMap) -> tuple[Sentence, ...]:
    """Return what helps where the cutter itself is in the way: its end, or its flank, where that is worth a
    line."""
    end, flank = (found.area_of(one) for one in (Obstacle.CUTTER, Obstacle.FLANK))
    least, texts = LEAST * float(found.area.sum()), tuple[Sentence, ...]()
    if end > least:
        text = say(
            "Tighter than the cutter ({area}): its end does not fit there; use a smaller radius.",
            area=Area(end, ".4g"),
        )
        texts = (*texts, text)
    return (*texts, flank_remedy(flank)) if flank > least else texts


def flank_remedy(area: float) -> Sentence:
    """Return what helps where the cutter's end fits, and what is above it does not; ``area`` mm2."""
    return say(
        "Cutter's flank in the way ({area}): its end fits, what is above it does not, as under an overhang; "
        "a smaller radius need not help, a lollipop or another setup may.",
        area=Area(area, ".4g"),
    )


def _helps(found: ReachMap) -> tuple[Sentence, ...]:
    """Return what is said below the table."""
    return (*remedies(found), *stick_out(found), *name_fixtures(found), *name_shut(found), WAYS)


def _table(found: ReachMap) -> Table:
    whole = float(found.area.sum())
    rows = [(f"reachable, tilted {low:.0f} to {high:.0f} deg" if high else "reachable along the normal", area)
            for low, high, area in _tilts(found)]  # fmt: skip
    rows += [(str(reason(obstacle)), found.area_of(obstacle)) for obstacle in KEYS]
    return Table(
        ("surface", "mm2", "%"),
        tuple((name, number(area, 1), f"{100.0 * area / whole:.1f}") for name, area in rows if area > 0.0),
    )


def _tilts(found: ReachMap) -> list[tuple[float, float, float]]:
    """Tilt above, tilt up to, deg, and the area, mm2, that needs it."""
    edge = (*TILTS, *UNDERCUTS)
    deg = [round(math.degrees(tilt), 6) for tilt in edge]
    level = np.searchsorted(np.array(edge), np.where(np.isnan(found.tilt), math.inf, found.tilt - 1e-12))
    area = np.bincount(level, found.area, len(edge) + 1)
    return [(deg[max(k - 1, 0)], deg[k], float(area[k])) for k in range(len(edge)) if area[k] > 0.0]


def reach_text(found: ReachMap, findings: Sequence[Finding] = ()) -> str:
    """For the terminal."""
    paragraphs = [verdict(found), "", *text_table(_table(found)), "", *_helps(found)]
    lines = [part for line in paragraphs for part in textwrap.wrap(line, WIDTH) or [""]]
    return "\n".join([*lines, *findings_text(findings), *textwrap.wrap(NOTE, WIDTH)]) + "\n"


def reach_json(
    found: ReachMap, inputs: Mapping[str, object] | None = None, findings: Sequence[Finding] = ()
) -> str:
    """For scripts: areas in mm2, angles in degrees; ``inputs``: a job file."""
    summary = {
        "area": float(found.area.sum()), "reachable_area": found.area_of(Obstacle.NONE),
        "reachable_share": share_reached(found),
        "by_reason": {key: found.area_of(obstacle) for obstacle, key in KEYS.items()},
        "by_tilt": [{"above": low, "up_to": high, "area": area} for low, high, area in _tilts(found)],
        "stick_out": [{"longer": step, "area": area} for step, area in found.longer],
        "without_fixture": [{"fixture": name, "area": area} for name, area in found.without],
        "standing_area": found.standing, "no_way_out_area": found.shut, "note": str(WAYS),
        "places": len(found.area), "spacing": found.spacing,
    }  # fmt: skip
    return json_text({"version": VERSION, "summary": summary, "findings": findings, "inputs": inputs or {}})


def reach_html(found: ReachMap, title: str = "", findings: Sequence[Finding] = ()) -> str:
    """Return a page that needs nothing else."""
    longer = "".join(f"<p>{escape(line)}</p>" for line in _helps(found))
    body = [
        section("The surface", table(_table(found)) + longer + f'<p class="note">{escape(NOTE)}</p>'),
        section("Findings", findings_list(findings)),
    ]
    return page(
        "What the tool reaches",
        title,
        verdict(found),
        "good" if share_reached(found) > 1.0 - 1e-9 else "open",
        body,
    )
