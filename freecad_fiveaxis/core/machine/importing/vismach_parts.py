# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a vismach model as records: what the script calls them with, and what of it is not plain."""

from __future__ import annotations

import ast
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

PARTS = {
    "Collection": "parts", "Color": "color parts", "Capture": "",
    "Translate": "parts x y z", "Rotate": "parts th x y z",
    "HalTranslate": "parts comp var x y z", "HalRotate": "parts comp var th x y z",
    "HalVectorTranslate": "parts comp xvar yvar zvar scale",
    "Box": "x1 y1 z1 x2 y2 z2", "BoxCentered": "xw yw zw", "BoxCenteredXY": "xw yw zw",
    "CylinderX": "x1 r1 x2 r2", "CylinderY": "y1 r1 y2 r2", "CylinderZ": "z1 r1 z2 r2",
    "Sphere": "x y z r", "AsciiSTL": "filename",
}  # fmt: skip
"""The parts that are read, and their arguments."""
OTHERWISE: dict[str, Any] = {"scale": 1.0}
NAMES = ("parts", "color", "comp", "filename", "var", "xvar", "yvar", "zvar")
"""Arguments that are no numbers, or need not be."""


@dataclass(eq=False)
class Unread:
    """What is not plain: the ``line`` of the script, and the text that stands there."""

    line: int
    text: str


@dataclass(eq=False)
class Listing:
    """A list of the script; ``spoilt``: the line of what may have changed it, 0 for none."""

    items: list[Any]
    spoilt: int = 0


@dataclass(frozen=True)
class Component:
    """A HAL component: what its pins begin with."""

    prefix: str


@dataclass(eq=False)
class Part:
    """One of :data:`PARTS`: its ``given`` arguments by name, numbers as floats, pins (``var`` and the like)
    by their whole names; ``label``: the name that the script first gave it; ``spoilt`` as of a Listing."""

    kind: str
    line: int
    text: str
    given: dict[str, Any]
    label: str = ""
    spoilt: int = 0

    def numbers(self, *names: str) -> tuple[float, ...]:
        """Give arguments that are numbers."""
        return tuple(self.given[name] for name in names)


def make_part(call: ast.Call, kind: str, values: Sequence[Any], by_word: Mapping[str, Any]) -> Part | Unread:
    """Make the part that a call of one of :data:`PARTS` gives; what has arguments that are not plain is
    unread."""
    words = PARTS[kind].split()
    found = OTHERWISE | dict(zip(words, values, strict=False)) | dict(by_word)
    given = {word: found[word] for word in words if word in found}
    plain = len(values) <= len(words) and set(by_word) <= set(words) - set(words[: len(values)])
    if not plain or len(given) < len(words) or not all(_fits(*one) for one in given.items()):
        return unread(call)
    return Part(kind, call.lineno, _text(call), _whole_pins(given))


def _fits(word: str, value: Any) -> bool:
    """Tell whether an argument is of the kind that its part needs."""
    if word not in NAMES:
        return isinstance(value, float)
    kinds: dict[str, Any] = {"parts": Listing, "color": object, "comp": Component | None}
    return isinstance(value, kinds.get(word, str)) or (word in ("xvar", "yvar", "zvar") and value == 0.0)


def _whole_pins(given: dict[str, Any]) -> dict[str, Any]:
    comp = given.get("comp")
    prefix = "" if comp is None else f"{comp.prefix}."
    return {
        word: prefix + value if word.endswith("var") and isinstance(value, str) else value
        for word, value in given.items()
    }


def unread(node: ast.AST) -> Unread:
    """Return the mark of what is not plain."""
    return Unread(getattr(node, "lineno", 1), _text(node))


def _text(node: ast.AST) -> str:
    """Return the beginning of what stands there, on one line."""
    try:
        text = " ".join(ast.unparse(node).split())
    except (ValueError, RecursionError):  # a number of thousands of digits
        text = type(node).__name__
    return text if len(text) <= 40 else text[:37] + "..."
