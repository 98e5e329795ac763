# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the view and the list of findings say of a tool that enters the part, and of what stays on it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

from freecad_fiveaxis.gui.qt import translate

from .marks import GOUGE_COLOURS, HOLDER_COLLISION, INDEPENDENT_RAPID, OVERCUT, RAPID_COLLISION
from .on_screen import Label
from .units import area_text, length_text

if TYPE_CHECKING:
    from freecad_fiveaxis.core.base.findings import Finding

UNCUT, TOO_DEEP, BURIED, LIFTED, LEFT_OUT = "uncut", "cut-too-deep", "buried", "lifted", "left-out"
"""Findings beside the marks: of the map of rest material, and of the cures."""


def names() -> dict[str, str]:
    """Return a few words for each code."""
    return {
        OVERCUT: translate("FiveAxis", "Cut too deep"),
        HOLDER_COLLISION: translate("FiveAxis", "Shank or holder collides"),
        RAPID_COLLISION: translate("FiveAxis", "Collision between passes"),
        INDEPENDENT_RAPID: translate("FiveAxis", "Collision in a rapid"),
        UNCUT: translate("FiveAxis", "Uncut"),
        TOO_DEEP: translate("FiveAxis", "Below the surface"),
        BURIED: translate("FiveAxis", "Cutter inside the part"),
        LIFTED: translate("FiveAxis", "Tool lifted"),
        LEFT_OUT: translate("FiveAxis", "Left out"),
    }


def label_text(kind: str, depth: float) -> str:
    """Return what stands at the deepest place of a kind of marks (mm)."""
    texts = {
        OVERCUT: translate("FiveAxis", "{depth} too deep"),
        HOLDER_COLLISION: translate("FiveAxis", "shank or holder {depth} in the part"),
        RAPID_COLLISION: translate("FiveAxis", "cutter {depth} in the part between passes"),
        INDEPENDENT_RAPID: translate("FiveAxis", "tool {depth} in the part if axes run independently"),
    }
    return texts[kind].format(depth=length_text(depth))


def labels(
    places: Sequence[Sequence[float]], kinds: Sequence[str], values: Sequence[float | None]
) -> list[Label]:
    """Return the label of the first mark of each kind, which is its deepest; ``values`` mm. A cut that is too
    deep comes first."""
    first = {kind: at for at, kind in reversed(list(enumerate(kinds)))}
    rows = [
        first[kind]
        for kind in (OVERCUT, HOLDER_COLLISION, RAPID_COLLISION, INDEPENDENT_RAPID)
        if kind in first
    ]
    return [
        Label(places[at], label_text(kinds[at], value), GOUGE_COLOURS[kinds[at]])
        for at in rows
        if at < len(values) and (value := values[at])
    ]


def legend_keys(kinds: Sequence[str]) -> list[tuple[tuple[float, float, float], str]]:
    """Colour and text of each kind of marks that is there; ``kinds`` of all marks."""
    count = Counter(kinds)
    texts = {
        OVERCUT: translate("FiveAxis", "cut too deep: {count} places"),
        HOLDER_COLLISION: translate("FiveAxis", "shank or holder collides: {count} places"),
        RAPID_COLLISION: translate("FiveAxis", "collision between passes: {count} places"),
        INDEPENDENT_RAPID: translate("FiveAxis", "collision in a rapid: {count} places"),
    }
    return [
        (GOUGE_COLOURS[kind], text.format(count=count[kind])) for kind, text in texts.items() if count[kind]
    ]


def explain(finding: Finding) -> tuple[str, str, str] | None:
    """Return what happens, why, and what helps; None for another code, or where no value is known."""
    sayings = {
        OVERCUT: _overcut, TOO_DEEP: _overcut, HOLDER_COLLISION: _holder, RAPID_COLLISION: _between,
        UNCUT: _uncut,
        INDEPENDENT_RAPID: _independent,
    }  # fmt: skip
    if finding.code not in sayings or finding.value is None:
        return None
    return sayings[finding.code](finding.value)


def _overcut(depth: float) -> tuple[str, str, str]:
    return (
        translate("FiveAxis", "The cutter goes {depth} too deep into the part.").format(
            depth=length_text(depth)
        ),
        translate(
            "FiveAxis",
            "The surface curls tighter than the cutter there, or another wall stands nearer than it is wide.",
        ),
        translate(
            "FiveAxis",
            "In the tool path's panel let the tool be lifted there, or leave such places out; or take a "
            "smaller cutter. The command What is left shows what then stays uncut. Where that is done "
            "already, the machine leaves the path between blocks: set Divide blocks to on.",
        ),
    )


def _holder(depth: float) -> tuple[str, str, str]:
    return (
        translate("FiveAxis",
            "The shank or the holder goes {depth} into the part.").format(depth=length_text(depth)),
        translate(
            "FiveAxis",
            "The tool is short, or leans towards a wall beside what is cut. Walls that are not selected "
            "count too."
        ),
        translate(
            "FiveAxis",
            "A longer tool, a slimmer holder, lead or tilt away from the wall; or leave such places out."
        ),
    )  # fmt: skip


def _between(depth: float) -> tuple[str, str, str]:
    return (
        translate("FiveAxis", "On its way between passes the cutter goes {depth} into the part.").format(
            depth=length_text(depth)
        ),
        translate(
            "FiveAxis",
            "While the rotary axes turn, the tip leaves the straight way over the part; or the part is over "
            "the tool.",
        ),
        translate(
            "FiveAxis",
            "In the tool path's panel a larger clearance; under the part let the tool be lifted, or leave "
            "such places out.",
        ),
    )


def _independent(depth: float) -> tuple[str, str, str]:
    return (
        translate(
            "FiveAxis", "In a rapid the tool goes {depth} into the part if its axes run independently."
        ).format(depth=length_text(depth)),
        translate(
            "FiveAxis",
            "Many controls drive each axis of G0 at a rate of its own; the way is then no straight line.",
        ),
        translate(
            "FiveAxis",
            "Drive one group of axes after the other. Where the control interpolates rapids, set Rapids to "
            "interpolated, or say so in the machine file.",
        ),
    )


def _uncut(area: float) -> tuple[str, str, str]:
    return (
        translate(
            "FiveAxis", "On {area} of the machined surface more is left than the passes are meant to leave."
        ).format(area=area_text(area)),
        translate(
            "FiveAxis",
            "The cutter does not fit there, or it was lifted or kept away so that nothing enters the part.",
        ),
        translate(
            "FiveAxis",
            "The command What is left shows where. Cut these places with a smaller cutter, or with another "
            "tool axis.",
        ),
    )
