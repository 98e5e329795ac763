# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feeds in mm/min in the property editor, where FreeCAD's own property of a speed shows mm/s in most of its
unit schemas.

speed        ``Feed``, ``PlungeFeed``: what counts, what files and scripts have; out of sight in the editor.
per minute   ``FeedPerMinute``, ``PlungeFeedPerMinute``: the same in mm/min, as a plain number. A change of
             either changes the other; where both are put back, by undo or from a file, nothing follows.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

SPEED = "App::PropertySpeed"
PER_MINUTE = "PerMinute"


def speeds(obj: Any) -> Iterator[str]:
    """Yield the names of the object's feeds that it also has in mm/min."""
    there = obj.PropertiesList
    return (name for name in there if name + PER_MINUTE in there and obj.getTypeIdOfProperty(name) == SPEED)


def per_minute(obj: Any, name: str) -> float:
    """mm/min of a speed, to the digits that its mm/s are known by: 1000, where a sixtieth of it is no finite
    number."""
    return float(f"{getattr(obj, name).Value * 60.0:.11g}")


def show(obj: Any) -> None:
    """Every feed in mm/min is that of its speed, which is hidden: for an object that is new or was read."""
    for name in speeds(obj):
        obj.setEditorMode(name, ["Hidden"])
        _give(obj, name)


def follow(obj: Any, name: str) -> None:
    """Make the other property of a pair the same where ``name``, which was changed, is one of such a pair."""
    speed = name.removesuffix(PER_MINUTE)
    if speed not in speeds(obj):
        return
    if name != speed and float(f"{getattr(obj, name):.11g}") != per_minute(obj, speed):
        setattr(obj, speed, f"{getattr(obj, name):.17g} mm/min")
    _give(obj, speed)


def _give(obj: Any, speed: str) -> None:
    if getattr(obj, speed + PER_MINUTE) != per_minute(obj, speed):
        setattr(obj, speed + PER_MINUTE, per_minute(obj, speed))
