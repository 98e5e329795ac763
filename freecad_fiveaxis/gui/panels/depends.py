# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of a form that count only where another choice says so.

idle    an option that counts for nothing as the choices stand.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from .fields import Field


def _is(value: str) -> Callable[[Any], bool]:
    return lambda chosen: bool(chosen == value)


def _is_not(value: str) -> Callable[[Any], bool]:
    return lambda chosen: bool(chosen != value)


def _is_there(part: Any) -> bool:
    return part is not None


def _is_path(against: Any) -> bool:
    return bool(against) and not _is_part(against)


def _is_part(against: Any) -> bool:
    from freecad_fiveaxis.core.pipeline.settings import is_part

    return bool(against) and is_part(str(against))


DEPENDS: tuple[tuple[str, Callable[[Any], bool], Sequence[str], Sequence[str]], ...] = (
    ("passes", _is("planes"), ("direction", "plane_normal"), ()),
    ("passes", _is("scallop"), ("from_",), ()),
    ("passes", _is("morph"), ("from_", "to", "direction"), ()),
    ("passes", _is("radial"), ("pass_centre", "pass_axis"), ()),
    ("passes", _is("rotary"), ("pass_centre", "pass_axis", "rotary_by"), ("steep_shallow",)),
    ("tool_axis", _is("from_axis"), ("pass_centre", "pass_axis"), ()),
    ("avoid", bool, ("avoid_allowance",), ()),
    ("fixtures", bool, ("jaw_thickness",), ()),
    ("boundary", bool, ("boundary_axis", "boundary_by"), ()),
    ("within_frames", _is("planes"), ("direction",), ()),
    ("passes", _is("frames"), ("frames", "within_frames"), ("lead", "tilt", "steep_shallow")),
    ("passes", _is("zlevel"), (), ("steep_shallow",)),
    ("tool_axis", _is("fixed"), ("axis",), ()),
    ("tool_axis", _is("minimax"), ("max_tilt",), ("lead", "tilt")),
    ("gouge", _is("tilt"), ("max_tilt",), ()),
    ("singularity", _is("deform"), ("max_axis_change",), ()),
    ("rtcp", _is_not("off"), (), ("linearize",)),
    ("against", _is_path, ("axis_tolerance",), ()),
    ("against", _is_part, ("cutter", "gouge"), ()),
    ("part", _is_there, ("cutter", "gouge"), ("against", "axis_tolerance")),
)
"""A choice and what is asked of it; the options that count only if that holds (of several such lines: any),
and those that do not count then."""


def idle_options(fields: Mapping[str, Field]) -> set[str]:
    """Return the options that count for nothing as the choices stand: they are not shown, not checked and not
    given."""
    choices = [
        (choice, holds(fields[choice].value()), only, never)
        for choice, holds, only, never in DEPENDS
        if choice in fields
    ]
    idle = _idle(choices)  # a choice that is idle itself asks for nothing
    return _idle(
        [(choice, true and choice not in idle, only, never) for choice, true, only, never in choices]
    )


def _idle(choices: Sequence[tuple[str, bool, Sequence[str], Sequence[str]]]) -> set[str]:
    wanted = {name for _, true, only, _ in choices if true for name in only}
    return {name for _, true, only, never in choices for name in (never if true else set(only) - wanted)}
