# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field of an option of the core's settings, by the kind of its value."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from freecad_fiveaxis.app.labels import option_hint

from .fields import ChoiceField, FeedField, Field, NumberField, QuantityField, SpindleField, TextField
from .triple import TripleField

STACK = "40x25,63x50"
"""An example of cylinders upon each other."""


def option_field(leaf: Any, choices: Sequence[tuple[Any, str]] = (), none_text: str = "") -> Field:
    """Return the field of one option of the core's settings (a field of its dataclass).

    ``choices`` where it is one of some names; ``none_text`` for a triple that may be left open.
    """
    kind, hint = leaf.metadata["kind"], option_hint(leaf)
    optional = leaf.default is None
    if choices:
        return ChoiceField(leaf.name, choices, hint)
    makers: dict[str, Callable[[], Field]] = {
        "number": lambda: NumberField(leaf.name, hint, optional=optional),
        "speed": lambda: SpindleField(leaf.name, hint),
        "count": lambda: NumberField(leaf.name, hint, whole=True, optional=optional),
        "text": lambda: TextField(leaf.name, hint),
        "place": lambda: TextField(leaf.name, hint),
        "height": lambda: TextField(leaf.name, hint),
        "stack": lambda: TextField(leaf.name, hint, STACK),
        "vector": lambda: TripleField(leaf.name, "vector", hint),
        "point": lambda: TripleField(leaf.name, "point", hint, none_text),
        "lengths": lambda: TripleField(leaf.name, "point", hint, none_text, 90),
        "counts": lambda: TripleField(leaf.name, "counts", hint, none_text),
        "feed": lambda: FeedField(leaf.name, hint),
    }
    return makers[kind]() if kind in makers else QuantityField(leaf.name, kind, hint, optional)
