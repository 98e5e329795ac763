# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool as a picture: ball end, shank and holder, along z, with its driven point at zero."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pivy import coin

from freecad_fiveaxis.gui.scene import nodes

CUTTER, HOLDER = (0.95, 0.76, 0.20), (0.45, 0.50, 0.58)
"""Brass against the part's usual greys, and dark steel."""
HOLDER_TRANSPARENCY = 0.35
FINENESS = 0.8
"""Of the round faces: 1 is the finest that Coin draws."""
SUNK = 2.0
"""mm; how far the shank reaches into the holder, so that no two faces lie in one plane and flicker."""
QUARTER = 1.5707963267948966
DIAMETER, LENGTH = 10.0, 50.0
"""mm; where an object says no size, unless the preferences do."""


@dataclass(frozen=True)
class ToolSize:
    """mm. ``driven``: how far the driven point lies above the tip: 0, or the radius where the ball's centre is driven."""

    diameter: float
    length: float
    holder_diameter: float = 0.0
    holder_length: float = 0.0
    driven: float = 0.0


def size_of(obj: Any, centre_driven: bool = False) -> ToolSize:
    """The tool of a Toolpath or an Audit, from its properties."""
    from freecad_fiveaxis.app import preferences

    diameter = _mm(obj, "CutterDiameter") or preferences.cutter_diameter() or DIAMETER
    length = _mm(obj, "CutterLength") or max(LENGTH, diameter)
    driven = diameter / 2.0 if centre_driven else 0.0
    return ToolSize(diameter, length, _mm(obj, "HolderDiameter"), _mm(obj, "HolderLength"), driven)


def tool_node(size: ToolSize) -> Any:
    """The tool's nodes in the tool frame."""
    radius = size.diameter / 2.0
    shift = coin.SoTranslation()
    shift.translation.setValue(0.0, 0.0, -size.driven)
    fine = coin.SoComplexity()
    fine.value = FINENESS
    sunk = min(SUNK, size.holder_length / 2.0) if size.holder_diameter > 0.0 else 0.0
    return nodes.separate(
        shift, fine,
        nodes.separate(_material(CUTTER), _ball(radius), _cylinder(radius, radius, size.length + sunk)),
        nodes.separate(
            _material(HOLDER, HOLDER_TRANSPARENCY),
            _cylinder(size.holder_diameter / 2.0, size.length, size.length + size.holder_length),
        ),
    )  # fmt: skip


def _mm(obj: Any, name: str) -> float:
    value = getattr(obj, name, 0.0)
    return float(getattr(value, "Value", value))


def _ball(radius: float) -> Any:
    place, ball = coin.SoTranslation(), coin.SoSphere()
    place.translation.setValue(0.0, 0.0, radius)
    ball.radius = radius
    return nodes.separate(place, ball)


def _cylinder(radius: float, low: float, high: float) -> Any:
    """A cylinder about z between two heights; nothing where it has no size."""
    if radius <= 0.0 or high <= low:
        return coin.SoGroup()
    place, body = coin.SoTransform(), coin.SoCylinder()
    place.translation.setValue(0.0, 0.0, (low + high) / 2.0)
    place.rotation.setValue(coin.SbVec3f(1.0, 0.0, 0.0), QUARTER)  # Coin's cylinder stands along y
    body.radius, body.height = radius, high - low
    return nodes.separate(place, body)


def _material(rgb: nodes.Colour, transparency: float = 0.0) -> Any:
    made = coin.SoMaterial()
    made.diffuseColor.setValue(*rgb)
    made.ambientColor.setValue(*(0.4 * part for part in rgb))
    made.specularColor.setValue(0.3, 0.3, 0.3)
    made.shininess, made.transparency = 0.4, transparency
    return made
