# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the view and the list of findings say, in the user's language and units. The numbers are the core's.

explain    three plain texts of one block: what happens there, why, and what helps.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from freecad_fiveaxis.gui.qt import translate

from . import gouge_words
from .units import angle_text, area_text, length_text, write_number

if TYPE_CHECKING:
    from freecad_fiveaxis.core.base.findings import Finding
    from freecad_fiveaxis.core.report import Figures, Spot

LARGEST, OVER, SINGULAR, UNPROVEN = (
    "largest-deviation",
    "deviation-over-tolerance",
    "singular-block",
    "bound-over-tolerance",
)
"""The codes that have words of their own; of every other finding the core's own sentence is shown."""
SIDE = "side-not-machined"
"""Each side has a marker and a label of its own."""

MOVES = ("cuts", "links", "rapids")
"""The kinds of moves of a path, as they are drawn (path_nodes.PARTS)."""

LEAST_LEAN = 1e-3
"""In degrees: by less than this the tool does not lean (it would read as "by 0°")."""

Explanation = tuple[str, str, str]


def name_of(code: str) -> str:
    """Return a few words for a code."""
    names = {
        LARGEST: translate("FiveAxis", "Largest deviation"),
        OVER: translate("FiveAxis", "Over the tolerance"),
        SINGULAR: translate("FiveAxis", "Near the pole"),
        UNPROVEN: translate("FiveAxis", "Not proven"),
    }
    return (names | short_names() | gouge_words.names()).get(code, code.replace("-", " ").capitalize())


def short_names() -> dict[str, str]:
    """Return a few words for each finding that stands at a place of the part: what its marker is labelled
    with."""
    return {
        SIDE: translate("FiveAxis", "Not machined"),
        "surface-looks-down": translate("FiveAxis", "Looks down"),
        "corner-not-reached": translate("FiveAxis", "Corner not reached"),
        "heel-in-hollow": translate("FiveAxis", "Heel of the cutter in the part"),
        "turns-at-pole": translate("FiveAxis", "Turns at the pole"),
        "not-freed": translate("FiveAxis", "Shank or holder not freed"),
        "table-collision": translate("FiveAxis", "Below the table"),
        "fixture-collision": translate("FiveAxis", "In a fixture"),
        "fixture-in-body": translate("FiveAxis", "Fixture in a machine body"),
        "part-in-body": translate("FiveAxis", "Part in a machine body"),
        "fixture-in-part": translate("FiveAxis", "Fixture in the part"),
        "machine-collision": translate("FiveAxis", "In the machine"),
        "fixture-near": translate("FiveAxis", "Near a fixture"),
        "machine-near": translate("FiveAxis", "Near the machine"),
        "retract-below-part": translate("FiveAxis", "Retract below the part"),
        "dip-below-part": translate("FiveAxis", "Dips below the part"),
        "start-through-part": translate("FiveAxis", "Start through the part"),
    }


def severity_name(severity: int) -> str:
    """Note, warning or error."""
    return (translate("FiveAxis", "Note"), translate("FiveAxis", "Warning"), translate("FiveAxis", "Error"))[
        severity
    ]


def value_text(finding: Finding) -> str:
    """Return a finding's value in the user's units; empty where it has none."""
    if finding.value is None:
        return ""
    if finding.unit in ("mm", "mm2"):
        return (length_text if finding.unit == "mm" else area_text)(finding.value)
    return (
        angle_text(finding.value)
        if finding.unit == "deg"
        else f"{write_number(f'{finding.value:.5g}')} {finding.unit.replace('1', '')}".strip()
    )


def explain(code: str, spot: Spot) -> Explanation | None:
    """Return what happens at a block, why, and what helps; None for a code without words of its own."""
    sayings = {LARGEST: _deviates, OVER: _deviates, SINGULAR: _near_pole, UNPROVEN: _unproven}
    return sayings[code](spot) if code in sayings else None


def count_text(code: str, numbers: Mapping[str, Any]) -> str:
    """How many blocks a finding of several tells of; ``numbers``: the core's summary."""
    texts = {
        OVER: translate("FiveAxis", "{over_tolerance} blocks are over the tolerance; this is the worst."),
        SINGULAR: translate("FiveAxis", "{singular_blocks} blocks lie near the pole; this is the worst."),
        UNPROVEN: translate("FiveAxis", "{unproven} blocks are not proven; this is the worst."),
    }
    return texts[code].format(**numbers)


def _deviates(spot: Spot) -> Explanation:
    given = {"deviation": length_text(spot.deviation), "tolerance": length_text(spot.tolerance)} | _turning(
        spot
    )
    what, why = _OFF()[spot.ball, spot.deviation > spot.tolerance], _CARRIED(spot.ball)
    texts = [why, *([_POLE()] if spot.singular else [])]
    helps = [_SPLIT(), *([_AWAY()] if spot.singular else []), _GUIDE()]
    return what.format(**given), " ".join(texts).format(**given), " ".join(helps)


def _near_pole(spot: Spot) -> Explanation:
    given = _turning(spot)
    what = _LEANS() if spot.lean >= LEAST_LEAN else _TURNS_UPRIGHT()
    return what.format(**given), _POLE().format(**given), _AWAY()


def _LEANS() -> str:
    return translate(
        "FiveAxis",
        "{first} turns {first_turn} and {second} {second_turn} to lean the tool by {lean}. The axis may be "
        "too slow for the programmed feed: then the tool dwells and may leave a mark.",
    )


def _TURNS_UPRIGHT() -> str:
    return translate(
        "FiveAxis",
        "{first} turns {first_turn} and {second} {second_turn} while the tool keeps its direction. The axis "
        "may be too slow for the programmed feed: then the tool dwells and may leave a mark.",
    )


def _unproven(spot: Spot) -> Explanation:
    tip = translate(
        "FiveAxis",
        "The tip was seen to leave the line by {deviation}; proven is only that it is no more than {bound}.",
    )
    ball = translate(
        "FiveAxis",
        "The ball's centre was seen to leave the line by {deviation}; proven is only that it is no more than "
        "{bound}.",
    )
    what = ball if spot.ball else tip
    why = translate(
        "FiveAxis", "The block is so near to the tolerance of {tolerance} that the proof does not reach."
    )
    given = {
        "deviation": length_text(spot.deviation, 7), "bound": length_text(spot.bound, 7),
        "tolerance": length_text(spot.tolerance)
    }  # fmt: skip
    return what.format(**given), why.format(**given), _SPLIT()


def _turning(spot: Spot) -> dict[str, str]:
    (first, first_turn), (second, second_turn) = spot.turns
    return {
        "first": first, "first_turn": angle_text(first_turn), "second": second,
        "second_turn": angle_text(second_turn, 3),
        "lean": angle_text(spot.lean, 3), "step": length_text(spot.step),
    }  # fmt: skip


def _OFF() -> dict[tuple[bool, bool], str]:
    """Return what leaves its line: by whether it is a ball's centre, and whether that is too far."""
    return {
        (False, True): translate(
            "FiveAxis", "The tip leaves the commanded straight line by {deviation}; allowed are {tolerance}."
        ),
        (False, False): translate(
            "FiveAxis",
            "The tip leaves the commanded straight line by {deviation}, within the {tolerance} allowed.",
        ),
        (True, True): translate(
            "FiveAxis",
            "The ball's centre leaves its commanded straight line by {deviation}; allowed are {tolerance}.",
        ),
        (True, False): translate(
            "FiveAxis",
            "The ball's centre leaves its commanded straight line by {deviation}, within the {tolerance} "
            "allowed.",
        ),
    }


def _CARRIED(ball: bool) -> str:
    """Why a ball's centre, or the tip, leaves its line."""
    tip = translate(
        "FiveAxis",
        "Within a step of {step}, {first} turns {first_turn} and {second} {second_turn}. While rotary axes "
        "turn, even moves of the axes carry the tip along a curve beside the straight line.",
    )
    centre = translate(
        "FiveAxis",
        "Within a step of {step}, {first} turns {first_turn} and {second} {second_turn}. While rotary axes "
        "turn, even moves of the axes carry the ball's centre along a curve beside the straight line.",
    )
    return centre if ball else tip


def _POLE() -> str:
    return translate(
        "FiveAxis",
        "The block lies near the pole: the tool stands almost along the {first} axis, and there {first} "
        "must turn far to lean the tool a little.",
    )


def _SPLIT() -> str:
    return translate(
        "FiveAxis",
        "Shorter blocks help: half the length leaves about a quarter of the deviation. Divide blocks, in "
        "the group Safety of the tool path's panel, makes as many of them as are needed.",
    )


def _AWAY() -> str:
    return translate(
        "FiveAxis",
        "Let the tool path's panel turn the axis past the pole, lean the tool by a few degrees, or clamp "
        "the part tilted.",
    )


def _GUIDE() -> str:
    return translate(
        "FiveAxis", "A controller with tool tip control (RTCP) guides the tip along the line itself."
    )


# --------------------------------------------------------------------------------------------------- the view


def label_text(deviation: float, line: int, tolerance: float) -> str:
    """Return what stands at the largest deviation; mm."""
    if deviation <= tolerance:
        text = translate("FiveAxis", "{deviation}, NC line {line}: within {tolerance}")
    else:
        text = translate("FiveAxis", "{deviation}, NC line {line}: over {tolerance}")
    return text.format(deviation=length_text(deviation), line=line, tolerance=length_text(tolerance))


def legend_of(
    label: str,
    figures: Figures,
    look: Any,
    warning: str,
    kinds: Sequence[str] = (),
    shown: Sequence[str] = MOVES[:2],
) -> Any:
    """Return the legend of a path, drawn with the colours of ``look`` (path_nodes.Look); ``kinds`` of its
    markers; which of MOVES are ``shown``."""
    from freecad_fiveaxis.core.report import find_largest_judged, summary

    from .overlay import Legend

    numbers = summary(figures)
    beside = translate("FiveAxis", "commanded line beside the real curve")
    centre_beside = translate("FiveAxis", "commanded and real way of the ball's centre")
    keys = [
        *_moves(look, shown),
        (
            look.bad,
            translate("FiveAxis", "over the tolerance: {count} blocks").format(
                count=numbers["over_tolerance"]
            ),
        ),
        (
            look.singular,
            translate("FiveAxis", "near the pole: {count} blocks").format(count=numbers["singular_blocks"]),
        ),
        ((1.0, 1.0, 1.0), beside if figures.surface is None else centre_beside),
        *gouge_words.legend_keys(kinds),
    ]
    tip = translate("FiveAxis", "Distance of the tip from the commanded line")
    ball = translate("FiveAxis", "Distance of the ball's centre from the commanded line")
    notes, largest = [tip if figures.surface is None else ball], ""
    if numbers["worst_line"] is not None:
        largest = label_text(find_largest_judged(numbers)[0], numbers["worst_line"], figures.tolerance)
        notes.append(translate("FiveAxis", "Largest: {largest}").format(largest=largest))
    if figures.gouge is not None and not figures.gouge.findings:
        notes.append(translate("FiveAxis", "Nothing enters the part"))
    if numbers["guided_blocks"]:
        notes.append(
            translate("FiveAxis", "Tip guided (RTCP): {count} blocks,").format(count=numbers["guided_blocks"])
        )
        notes.append(translate("FiveAxis", "not proven between their ends"))
    return Legend(label, *_scale(figures, look), keys, notes, warning, largest)


def _scale(figures: Figures, look: Any) -> tuple[Any, list[tuple[float, str]], tuple[str, str]]:
    """Return the ramp of a legend, its marks, and what its halves are called. A path within the tolerance has
    the calm half only."""
    from freecad_fiveaxis.core.report import scale_end, scale_marks

    from .colours import SHADES, ramp

    end, colours = scale_end(figures), ramp(look.good, look.bad)
    marks = [(level, length_text(value)) for level, value in scale_marks(figures.tolerance, end)]
    least = marks[0][1]
    marks[0] = (
        marks[0][0],
        least if least.startswith("<") else "≤ " + least,
    )  # too small for the unit's digits: said already
    within = translate("FiveAxis", "within tolerance")
    if end <= figures.tolerance:
        return colours[: SHADES // 2], [(2.0 * level, text) for level, text in marks], (within, "")
    if not (figures.judged.segment[figures.feeds] <= end).all():
        marks[-1] = (marks[-1][0], "≥ " + marks[-1][1].removeprefix("<"))
    return colours, marks, (within, translate("FiveAxis", "over tolerance"))


def _moves(look: Any, shown: Sequence[str]) -> list[tuple[Any, str]]:
    """Return the kinds of moves in the legend: colour and text."""
    from .path_nodes import LINK_COLOUR, RAPID_COLOUR

    texts = {
        "cuts": (look.good, translate("FiveAxis", "cut, coloured by its deviation")),
        "links": (LINK_COLOUR, translate("FiveAxis", "link between passes, or lifted: at feed")),
        "rapids": (RAPID_COLOUR, translate("FiveAxis", "rapid, dashed")),
    }
    return [texts[name] for name in MOVES if name in shown]


def empty_legend(label: str, warning: str) -> Any:
    """Return a legend that only says why nothing is drawn."""
    import numpy as np

    from .overlay import Legend

    return Legend(label, np.zeros((0, 3)), (), ("", ""), (), (), warning)
