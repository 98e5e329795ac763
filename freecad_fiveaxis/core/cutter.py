# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter.

contact   where the cutter touches the part (CC).       tip     the lowest point of the cutter, on its axis.
centre    the centre of the ball end.                   axis    unit vector from the tip to the holder.
"""

from __future__ import annotations

from dataclasses import dataclass

from .errors import SettingsError
from .quantity import parse_length
from .records import Floats

KINDS = ("ball",)
"""The cutter shapes on offer."""

LEAST, MOST = 1e-3, 1e4
"""mm; a cutter below a micrometre or above ten metres is a slip of the pen."""


@dataclass(frozen=True)
class Cutter:
    """A ball-end cutter, mm: ``diameter`` and ``length`` (cutting edge, tip upwards), each from LEAST to MOST.

    Raises SettingsError where one of them is not.
    """

    diameter: float
    length: float = 50.0

    def __post_init__(self) -> None:
        for name in ("diameter", "length"):
            value = getattr(self, name)
            if not LEAST <= value <= MOST:
                raise SettingsError(f"cutter {name} is {value:g} mm; give {LEAST:g} to {MOST:g} mm", value)

    @property
    def radius(self) -> float:
        """Radius of the ball end, mm."""
        return self.diameter / 2.0

    def tip_at(self, centre: Floats, axis: Floats) -> Floats:
        """The tip (n, 3) mm where the ball's centre (n, 3) mm stands and the unit ``axis`` (n, 3) points."""
        return centre - self.radius * axis


def parse_cutter(text: str) -> Cutter:
    """The cutter written as ``KIND:DIAMETER`` or ``KIND:DIAMETER:LENGTH``, as ``ball:10``, ``ball:0.5in:2in`` (else mm).

    Raises SettingsError that names the kinds on offer, or the quantity that cannot be read.
    """
    kind, _, sizes = str(text).strip().partition(":")
    if kind.strip().lower() not in KINDS:
        raise SettingsError(f"cutter {text!r}: only {', '.join(KINDS)} cutters are on offer; write it as ball:10", text)
    parts = sizes.split(":")
    if not sizes.strip() or len(parts) > 2:
        raise SettingsError(f"cutter {text!r} needs KIND:DIAMETER or KIND:DIAMETER:LENGTH, as ball:10 or ball:10:60", text)
    names = ("cutter diameter", "cutter length")
    return Cutter(*(parse_length(part, name) for part, name in zip(parts, names, strict=False)))
