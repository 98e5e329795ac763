# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options that change nothing beside the others that are given: a name that was meant for another strategy is
told, and not left out in silence."""

from __future__ import annotations

from freecad_fiveaxis.core.base.sentences import Choice, Option, Sentence, say

from .settings import MILL, Settings, option_fields

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


def find_unused(settings: Settings) -> list[Sentence]:
    """Return one sentence for each option of ``mill`` that was given another value than its own and has no
    effect beside the rest."""
    if settings.task != MILL:
        return []
    given = {leaf.name: getattr(_group(settings, cls), leaf.name) for cls, leaf in option_fields(MILL)}
    own = {leaf.name: leaf.default for _, leaf in option_fields(MILL)}
    return [
        _name_users(name, users)
        for name, users in USERS.items()
        if given[name] != own[name] and not any(given[user] in values for user, values in users)
    ]


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
