# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading the JSON of a machine file, key by key: what is missing or makes no sense is a MachineError with
the key's dotted name.

Each ``get_`` function takes the object that holds the key, the dotted name of that object with its dot, and
the key.
"""

from __future__ import annotations

import json
import math
import reprlib
import sys
from collections.abc import Mapping
from typing import Any

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.sentences import say

from .model import Vector, finite_vector

JsonObject = Mapping[str, Any]


def parse_json(content: bytes) -> Any:
    """Read JSON whose numbers are finite and whose keys stand once each."""
    try:
        return json.loads(content.decode("utf-8-sig"), parse_constant=_no_constant, object_pairs_hook=_unique)
    except MachineError:
        raise
    except (ValueError, RecursionError) as error:
        kind = say("is empty") if not content.strip() else say("is not JSON ({error})", error=error)
        remedy = say("export the machine from FreeCAD again")
        if isinstance(error, json.JSONDecodeError) and content.strip():
            remedy = say("correct that place in a text editor, or {export}", export=remedy)
        raise MachineError(say("the file {kind}; {remedy}", kind=kind, remedy=remedy), content[:60]) from None


def _no_constant(text: str) -> float:
    raise MachineError(say("{text} is no usable number; write a finite one", text=text), text)


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for key, value in pairs:
        if key in found:
            raise MachineError(
                say("key {key} stands twice in one object; remove one", key=reprlib.repr(key)), key
            )
        found[key] = value
    return found


def fail(key: str, problem: str, value: object) -> MachineError:
    """Make the error of a ``key`` that cannot be used."""
    return MachineError(say("{key}: {problem}", key=key, problem=problem), value)


def get_key(holder: JsonObject, where: str, key: str) -> Any:
    """Get what stands under a key that has to be there."""
    if key not in holder:
        raise fail(where + key, say('the key is missing; add "{key}"', key=key), None)
    return holder[key]


def get_object(holder: JsonObject, where: str, key: str) -> JsonObject:
    """Get an object."""
    value = get_key(holder, where, key)
    if not isinstance(value, dict):
        raise fail(
            where + key, say("{value} is not an object; write {{ ... }}", value=reprlib.repr(value)), value
        )
    return value


def get_text(holder: JsonObject, where: str, key: str) -> str:
    """Get a string, its line breaks made spaces."""
    value = get_key(holder, where, key)
    text = " ".join(value.splitlines()) if isinstance(value, str) else "\0"
    if not text.isprintable():
        raise fail(
            where + key,
            say("{value} is not a text that can be shown; write one in quotes", value=reprlib.repr(value)),
            value,
        )
    return text


def get_choice(holder: JsonObject, where: str, key: str, known: Any) -> str:
    """Get a string that is one of the ``known``."""
    value = get_text(holder, where, key)
    if value not in known:
        raise fail(
            where + key,
            say("{value} is none of {known}", value=reprlib.repr(value), known=", ".join(known)),
            value,
        )
    return value


def as_number(value: Any, key: str) -> float:
    """Take a value as a finite number."""
    try:
        number = (
            float("nan") if isinstance(value, bool) or not isinstance(value, (int, float)) else float(value)
        )
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise fail(key, say("{value} is not a finite number", value=reprlib.repr(value)), value)
    return number


def get_number(holder: JsonObject, where: str, key: str) -> float:
    """Get a finite number."""
    return as_number(get_key(holder, where, key), where + key)


def as_vector(value: Any, key: str, unit: float = 1.0, most: float = sys.float_info.max) -> Vector:
    """Take a list of three numbers as a vector, ``unit`` mm each and none beyond ``most`` mm."""
    if not isinstance(value, list) or len(value) != 3:
        raise fail(key, say("{value} is not a vector; write [x, y, z]", value=reprlib.repr(value)), value)
    return finite_vector([unit * as_number(component, key) for component in value], key, most)


def get_names(holder: JsonObject, where: str, key: str) -> tuple[str, ...]:
    """Get a list of strings."""
    value = get_key(holder, where, key)
    if not isinstance(value, list) or not all(isinstance(name, str) for name in value):
        raise fail(
            where + key,
            say('{value} is no list of names; write ["M202", "CYCL DEF 392"]', value=reprlib.repr(value)),
            value,
        )
    return tuple(value)
