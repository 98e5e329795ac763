# SPDX-License-Identifier: LGPL-2.1-or-later
"""The flank of a tangential barrel cutter: an arc of large radius between a ball at the tip and the largest
diameter.

flank     the arc: it touches the tip's ball and ends, parallel to the axis, where the cutter is widest; above
          that the cutter is a cylinder. Makers call this shape the oval or tangential form.
ring      radius of the circle on which the arc's centres lie: diameter / 2 - radius. It is negative: the
          centre of an arc lies beyond the axis. But for that sign the flank touches as the corner of a bull
          nose does.
rise      of these centres, and of the largest diameter, above the hub, the centre of the tip's ball.
begins    the angle between the surface's normal and the axis from which the flank touches; it does up to a
          right angle. Where the axis leans less from the normal the tip's ball touches.

A contact p on the flank with the unit normal n and the axis k, *out* the part of n across k made unit: the
tip's ball would touch there with its hub at ``p + corner n``; the flank has it at ``p + radius n + ring out -
rise k``.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import Length, say

if TYPE_CHECKING:
    from freecad_fiveaxis.core.base.records import Bools, Floats

MOST_FLANK = 1e4
"""mm; a flank of a larger radius is a cylinder for all that a machine can tell."""


class Flank(NamedTuple):
    """The arc, mm: its ``radius``, the ``corner`` radius of the ball that it touches, ``ring`` and ``rise``
    of its centres."""

    radius: float
    corner: float
    ring: float
    rise: float

    @property
    def cosine(self) -> float:
        """The cosine of ``begins``."""
        return self.rise / (self.radius - self.corner)

    @property
    def begins(self) -> float:
        """The angle, rad, between normal and axis from which the flank touches."""
        return math.acos(self.cosine)

    @property
    def middle(self) -> float:
        """The angle, rad, with which the middle of the arc touches."""
        return 0.5 * (self.begins + 0.5 * math.pi)

    def touches(self, normal: Floats, axis: Floats) -> Bools:
        """Find where (n,) the flank touches, and not the tip's ball, with unit ``normal`` and ``axis`` (n,
        3)."""
        import numpy as np

        return np.asarray(np.einsum("...i,...i->...", normal, axis) < self.cosine)

    def hub_shift(self, normal: Floats, axis: Floats) -> Floats:
        """How far (n, 3) mm the hub lies from the place where it is when the tip's ball touches: 0 where that
        does."""
        import numpy as np

        along = np.einsum("...i,...i->...", normal, axis)[..., None]
        across = normal - along * axis
        out = (
            across
            / np.maximum(np.sqrt(np.einsum("...i,...i->...", across, across)), np.finfo(float).tiny)[
                ..., None
            ]
        )
        shift = (self.radius - self.corner) * normal + self.ring * out - self.rise * axis
        return np.where(along < self.cosine, shift, 0.0)


def flank_of(diameter: float, corner: float, radius: float) -> Flank:
    """Return the flank of a barrel of these sizes, mm: the arc of ``radius`` touches the ball of the
    ``corner`` radius from outside."""
    ring = 0.5 * diameter - radius
    return Flank(radius, corner, ring, math.sqrt((radius - corner) ** 2 - ring**2))


def check_flank(
    diameter: float, corner: float, radius: float, taper: float, length: float, least: float
) -> None:
    """Raise SettingsError for sizes, mm (``taper`` rad), of which no barrel can be made; ``least`` mm of the
    corner."""
    if not least <= corner < 0.5 * diameter:
        text = say(
            "cutter corner radius is {corner}; a barrel has a ball of {least} or more at its tip, of less "
            "than {radius}, half the diameter",
            corner=Length(corner),
            least=Length(least),
            radius=Length(0.5 * diameter),
        )
        raise SettingsError(text, corner)
    if not 0.5 * diameter < radius <= MOST_FLANK:
        text = say(
            "cutter flank radius is {flank}; give more than {radius}, half the diameter, and at most {most}",
            flank=Length(radius),
            radius=Length(0.5 * diameter),
            most=Length(MOST_FLANK),
        )
        raise SettingsError(text, radius)
    if taper != 0.0:
        raise SettingsError(
            say("cutter flank radius: only a barrel has one, and it has no taper; leave one of them out"),
            taper,
        )
    ends = corner + flank_of(diameter, corner, radius).rise
    if not length >= ends:
        text = say(
            "cutter length is {length}, its flank ends {ends} above the tip; give a longer cutter or a "
            "smaller flank radius",
            length=Length(length),
            ends=Length(ends),
        )
        raise SettingsError(text, length)
