# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which markers have a label, and what it says: one for each kind, and for each side that is not machined;
the most important first. Blocks over the tolerance and near the pole have none: their colour says it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from freecad_fiveaxis.gui.qt import translate

from . import gouge_words, words
from .marks import LARGEST, OTHER_COLOUR, largest_colour
from .nodes import Colour
from .on_screen import Label
from .units import area_text


class LargestDeviation(NamedTuple):
    """What is known of the largest deviation: mm, NC line (None for a program that nowhere feeds), the
    tolerance in mm; and the colours of what is within the tolerance and of what is over it."""

    deviation: float | None
    line: int | None
    tolerance: float
    good: Colour
    bad: Colour


def of_marks(
    places: Sequence[Sequence[float]],
    kinds: Sequence[str],
    values: Sequence[float | None],
    largest: LargestDeviation,
) -> list[Label]:
    """Return the labels of markers at ``places`` (mm) of these kinds; ``values``: how deep the tool enters
    the part there, mm, or the area of a side that is not machined, mm²; None where that is not known."""
    count = Counter(kinds)
    first = {kind: at for at, kind in reversed(list(enumerate(kinds)))}
    labels = gouge_words.labels(places, kinds, values)
    if LARGEST in first and largest.deviation is not None and largest.line is not None:
        colour = largest_colour(largest.deviation, largest.tolerance, largest.good, largest.bad)
        text = words.label_text(largest.deviation, largest.line, largest.tolerance)
        labels += [Label(places[first[LARGEST]], text, colour)] if colour else []
    sides = [at for at, kind in enumerate(kinds) if kind == words.SIDE]
    labels += [
        Label(places[at], _side(values[at] if at < len(values) else None), OTHER_COLOUR) for at in sides
    ]
    others = [kind for kind in dict.fromkeys(kinds) if kind in words.short_names() and kind != words.SIDE]
    return [*labels, *(Label(places[first[kind]], _name(kind, count[kind]), OTHER_COLOUR) for kind in others)]


def _side(area: float | None) -> str:
    """Return the label of a side that no pass machines; ``area`` mm², where it is known."""
    name = words.name_of(words.SIDE)
    return (
        translate("FiveAxis", "{finding}: {area}").format(finding=name, area=area_text(area))
        if area
        else name
    )


def _name(kind: str, count: int) -> str:
    if count == 1:
        return words.name_of(kind)
    return translate("FiveAxis", "{finding}: {count} places").format(finding=words.name_of(kind), count=count)
