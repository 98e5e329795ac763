# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options that change nothing beside the others that are given: a name that was meant for another strategy is
told, and not left out in silence."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.base.sentences import Choice, Option, Sentence, say
from freecad_fiveaxis.core.machine import load_machine

from .settings import COMPARE, Settings, option_fields

USERS: dict[str, tuple[tuple[str, tuple[str, ...]], ...]] = {
    "plane_normal": (("passes", ("planes",)),),
    "direction": (("passes", ("planes", "morph", "radial", "rotary", "frames")),),
    "from_": (("passes", ("scallop", "morph", "frames")),),
    "to": (("passes", ("morph",)),),
    "pass_centre": (("passes", ("radial", "rotary")), ("tool_axis", ("from_axis",))),
    "pass_axis": (("passes", ("radial", "rotary")), ("tool_axis", ("from_axis",))),
    "rotary_by": (("passes", ("rotary",)),),
    "frames": (("passes", ("frames",)),),
    "within_frames": (("passes", ("frames",)),),
    "axis": (("tool_axis", ("fixed",)),),
    "max_tilt": (("tool_axis", ("minimax",)), ("gouge", ("tilt",))),
    "max_axis_change": (("singularity", ("deform",)),),
}
"""What each option is for: settings, and the values of these with which it counts. An option that is not here
counts always, or is refused by itself."""


NEEDS = {
    "boundary_axis": "boundary",
    "boundary_by": "boundary",
    "fixture_clearance": "fixture",
    "jaw_thickness": "fixture",
    "axis_tolerance": "against",
}
"""Options that say more of what another one names: without that they have no effect."""


def find_unused(settings: Settings) -> list[Sentence]:
    """Return one sentence for each option of the task that was given another value than its own and has no
    effect beside the rest."""
    task = settings.task
    given = {leaf.name: getattr(_group(settings, cls), leaf.name) for cls, leaf in option_fields(task)}
    own = {leaf.name: leaf.default for _, leaf in option_fields(task)}
    other = {name for name in given if given[name] != own[name]}
    unused = [
        _name_users(name, users)
        for name, users in USERS.items()
        if name in other and not any(given.get(user, values[0]) in values for user, values in users)
    ]
    return [*unused, *_find_without(settings, given, other)]


def _find_without(settings: Settings, given: dict[str, Any], other: set[str]) -> Iterator[Sentence]:
    for name, needed in NEEDS.items():
        if name not in other or given.get(needed, True):
            continue
        if name != "fixture_clearance":
            yield say(
                "{option} has no effect without {needed}; give both, or leave it out",
                option=Option(name), needed=Option(needed),
            )  # fmt: skip
        elif not _has_bodies(settings):
            yield say(
                "{option} has no effect without {needed} and without bodies in the machine's file; give a "
                "fixture, or leave it out",
                option=Option(name), needed=Option(needed),
            )  # fmt: skip


def _has_bodies(settings: Settings) -> bool:
    """Tell whether the machine has bodies that the task looks at; of one whose file cannot be used its
    reader says why."""
    if settings.task == COMPARE:
        return False
    try:
        return bool(load_machine(settings.machine.machine).bodies)
    except FiveAxisError:
        return True


def _group(settings: Settings, cls: type) -> object:
    return next(group for group in vars(settings).values() if type(group) is cls)


def _name_users(name: str, users: tuple[tuple[str, tuple[str, ...]], ...]) -> Sentence:
    choices = [Choice(user, values, flag=True) for user, values in users]
    if len(choices) == 1:
        return say("{option} has no effect: it is for {choice}", option=Option(name), choice=choices[0])
    return say(
        "{option} has no effect: it is for {choice} and {other}",
        option=Option(name), choice=choices[0], other=choices[1],
    )  # fmt: skip
