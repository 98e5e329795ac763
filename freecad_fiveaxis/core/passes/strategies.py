# SPDX-License-Identifier: LGPL-2.1-or-later
"""The registry of pass strategies: one entry, one name on the command line. Nothing outside asks for an entry
by its name."""

from __future__ import annotations

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import say

from .field import PassStrategy
from .frame_passes import FramePasses
from .morph_passes import Morph
from .planes import Planes
from .radial_passes import Radial
from .rotary_passes import Rotary
from .scallop_passes import ConstantScallop

PASS_STRATEGIES: dict[str, PassStrategy] = {
    "frames": FramePasses(
        "locked rotary axes: constant scallop, or planes, from the few directions that see most of the part, "
        "one after the other"
    ),
    "morph": Morph(
        "from one guide curve, or side of the border, to another, changing from the form of the one to that "
        "of the other"
    ),
    "planes": Planes("parallel planes: upright along the direction, or of the plane normal"),
    "radial": Radial(
        "half planes about an axis, which the passes radiate from, or run along on a part that is round "
        "about it"
    ),
    "rotary": Rotary(
        "around or along a rotary axis, about which the part turns under the tool (--rotary-by)"
    ),
    "scallop": ConstantScallop(
        "constant scallop: each pass one admissible step from the one before it, over the surface"
    ),
    "zlevel": Planes("level planes, one below the other", (0.0, 0.0, 1.0)),
}


def find_pass_strategy(name: str) -> PassStrategy:
    """Return the strategy of that name. Raises SettingsError for one that there is not."""
    if name not in PASS_STRATEGIES:
        known = ", ".join(PASS_STRATEGIES)
        raise SettingsError(
            say("unknown passes {name}; choose one of {known}", name=repr(name), known=known), name
        )
    return PASS_STRATEGIES[name]
