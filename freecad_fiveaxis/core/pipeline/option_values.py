# SPDX-License-Identifier: LGPL-2.1-or-later
"""The value of one option, from what people and job files write and back to that.

kind      of a field of the settings (its metadata ``kind``): how its text is read, and in which unit.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from typing import Any

from freecad_fiveaxis.core.base import quantity
from freecad_fiveaxis.core.base.curve_text import is_inline
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.files import is_name
from freecad_fiveaxis.core.base.sentences import IN_FULL, Option, Sentence, Template, measure, say
from freecad_fiveaxis.core.machine import Vector
from freecad_fiveaxis.core.tool import Cutter, cutter_text, parse_cutter

UNITS = {
    "length": "mm",
    "height": "mm",
    "lengths": "mm",
    "point": "mm",
    "place": "mm",
    "angle": "deg",
    "feed": "mm/min",
}
SHOWN_UNITS = UNITS | {"speed": "1/min", "cutter": "(mm)", "stack": "(mm)"}
"""The units of options as they are shown; in brackets those of sizes within a text."""
BOUNDS = {
    "above": Template("above {bound}"),
    "least": Template("at least {bound}"),
    "most": Template("at most {bound}"),
}


def read_option(leaf: dataclasses.Field[Any], given: Any) -> Any:
    """One value from its text (or JSON value), checked against its choices and range."""
    name, rules = say("{option}", option=Option(leaf.name, flag=False)), leaf.metadata
    if rules["bare"] and isinstance(given, bool):
        given = rules["bare"] if given else leaf.default
    if rules["choices"] and given not in rules["choices"]:
        raise SettingsError(
            say(
                "{name} {given} is not one of {rules}",
                name=name,
                given=quantity.show_given(given),
                rules=", ".join(rules["choices"]),
            ),
            given,
        )
    try:
        value = READERS[rules["kind"]](given, name)
    except TypeError as error:
        raise SettingsError(
            say("{name} {given} is not of the right kind", name=name, given=quantity.show_given(given)), given
        ) from error
    numbers = [
        number for number in (value if isinstance(value, tuple) else (value,)) if isinstance(number, float)
    ]
    if not all(rules["least"] <= number <= rules["most"] and number > rules["above"] for number in numbers):
        raise SettingsError(
            say(
                "{name} {given} is out of range; {range}",
                name=name,
                given=_show_value(given, rules),
                range=_range_text(rules),
            ),
            given,
        )
    return value


def _show_value(given: Any, rules: Mapping[str, Any]) -> Any:
    """Return a number with its unit; a text as it was given."""
    unit = UNITS.get(rules["kind"], "")
    return measure(given, unit, "", bare=True) if isinstance(given, float) and unit else str(given)


def _range_text(rules: Mapping[str, Any]) -> Sentence:
    factor, unit = 180 / math.pi if rules["kind"] == "angle" else 1.0, UNITS.get(rules["kind"], "")
    bounds = [
        words.say(bound=measure(rules[bound] * factor, unit, IN_FULL))
        for bound, words in BOUNDS.items()
        if math.isfinite(rules[bound])
    ]
    both = bounds[0] if len(bounds) == 1 else say("{one} and {other}", one=bounds[0], other=bounds[-1])
    if rules["kind"] in ("point", "lengths", "vector", "counts", "place"):
        return say("each of its numbers must be {bounds}", bounds=both)
    return say("it must be {bounds}", bounds=both)


def read_text(given: Any, name: str) -> str:
    """Return a text that can name a file or a thing. Raises SettingsError."""
    if given == "":
        raise SettingsError(say("{name} '' is empty; give a value, or leave it out", name=name), given)
    if not isinstance(given, str):
        raise SettingsError(
            say("{name} {given} is not a text", name=name, given=quantity.show_given(given)), given
        )
    if not is_name(given):
        raise SettingsError(
            say(
                "{name} {given} holds a character that no name can have; give another",
                name=name,
                given=quantity.show_given(given),
            ),
            given,
        )
    return given


def _count(given: Any, name: str) -> float:
    value = quantity.parse(given, quantity.NUMBERS, name)
    if value != int(value):
        raise SettingsError(
            say("{name} {given} is not a whole number", name=name, given=quantity.show_given(given)), given
        )
    return value


def _speed(given: Any, name: str) -> float:
    """Return a spindle speed; 0 for ``off``. Raises SettingsError that names that choice too."""
    if given == "off":
        return 0.0
    try:
        return quantity.parse(given, quantity.NUMBERS, name)
    except SettingsError:
        raise SettingsError(
            say(
                "{name} {given} is no speed; give a number, 1/min, or off",
                name=name,
                given=quantity.show_given(given),
            ),
            given,
        ) from None


def _counts(given: Any, name: str) -> Vector:
    x, y, z = quantity.parse_triple(given, quantity.NUMBERS, name)
    return _count(x, name), _count(y, name), _count(z, name)


def _place(given: Any, name: str) -> str | Vector:
    """Return a word, a file's name or a curve; three lengths where it is X,Y,Z."""
    if isinstance(given, str) and (given.count(",") != 2 or is_inline(given)):
        return read_text(given, name)
    return quantity.parse_triple(given, quantity.LENGTHS, name)


def _names(given: Any, name: str) -> tuple[str, ...]:
    parts = [part.strip() for item in _paths(given, name) for part in item.split(",")]
    names = tuple(read_text(part, name) for part in parts)
    twice = next((one for at, one in enumerate(names) if one in names[:at]), None)
    if twice is not None:
        text = say("{value} is named twice in {option}; name it once", value=repr(twice), option=Option(name))
        raise SettingsError(text, twice)
    return names


def _paths(given: Any, name: str) -> tuple[str, ...]:
    if not isinstance(given, str | list | tuple):
        raise TypeError
    return tuple(read_text(item, name) for item in ([given] if isinstance(given, str) else given))


READERS: dict[str, Any] = {
    "length": quantity.parse_length,
    "height": quantity.parse_length,
    "angle": quantity.parse_angle,
    "feed": quantity.parse_feed,
    "point": lambda given, name: quantity.parse_triple(given, quantity.LENGTHS, name),
    "lengths": lambda given, name: quantity.parse_triple(given, quantity.LENGTHS, name),
    "vector": lambda given, name: quantity.parse_triple(given, quantity.NUMBERS, name),
    "cutter": lambda given, name: given if isinstance(given, Cutter) else parse_cutter(given),
    "stack": quantity.parse_stack,
    "number": lambda given, name: quantity.parse(given, quantity.NUMBERS, name),
    "speed": _speed,
    "count": _count,
    "counts": _counts,
    "text": read_text,
    "choice": read_text,
    "path": read_text,
    "curve": read_text,
    "place": _place,
    "paths": _paths,
    "names": _names,
}


def write_option(leaf: dataclasses.Field[Any], value: Any) -> Any:
    """Return the value as a job file would hold it: degrees, mm, lists; None where the option is left out."""
    if isinstance(value, Cutter):
        return cutter_text(value)
    if leaf.metadata["kind"] == "angle" and value is not None:
        return round(math.degrees(value), 12)
    if leaf.metadata["kind"] == "stack":
        return quantity.stack_text(value) or None
    if value == "":
        return None  # an option that is left out
    return list(value) if isinstance(value, tuple) else value
