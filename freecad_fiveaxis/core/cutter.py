# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter.

contact   where the cutter touches the part (CC).       tip     the lowest point of the cutter, on its axis.
centre    the centre of the ball end.                   axis    unit vector from the tip to the holder.
"""

from __future__ import annotations

from dataclasses import dataclass

from .errors import SettingsError


@dataclass(frozen=True)
class Cutter:
    """A ball-end cutter, mm: ``diameter`` and ``length`` (cutting edge, tip upwards)."""

    diameter: float
    length: float = 50.0

    def __post_init__(self) -> None:
        for name in ("diameter", "length"):
            value = getattr(self, name)
            if not 0.0 < value < 1e6:
                raise SettingsError(f"cutter {name} is {value:g} mm; give a length above 0", value)

    @property
    def radius(self) -> float:
        """Radius of the ball end, mm."""
        return self.diameter / 2.0
