# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machine files of FreeCAD's Machine editor from before its first release, which have version 1 too.

limits   stand beside the axis as ``min`` and ``max``, no ``limits`` object.
roles    ``role`` and ``parent`` are missing. For three linear axes alone they change no word and no path:
         taken is what FreeCAD's own templates say, X and Y under the table and Z at the head. Where there is
         a rotary axis they are asked for: a machine is what carries what.

Source: the templates in ``src/Mod/CAM/Machine/machines`` and ``models/machine.py`` of
github.com/sliptonic/FreeCAD.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

ROLES = {"X": "table_linear", "Y": "table_linear", "Z": "head_linear"}
LIMITS = ("min", "max")


def is_older(axes: Mapping[str, Any]) -> bool:
    """Tell whether some axis has its limits beside it, or no role in a file of linear axes alone."""
    plain = _all_linear(axes)
    return any(
        isinstance(axis, dict)
        and (_limits_beside(axis) or (plain and ("role" not in axis or "parent" not in axis)))
        for axis in axes.values()
    )


def as_today(axes: Mapping[str, Any]) -> Mapping[str, Any]:
    """Give the axes with the keys that files have today; what cannot be known stays missing, what is no
    object stays as it is."""
    plain = _all_linear(axes)
    return {
        letter: _axis(letter, axis, plain) if isinstance(axis, dict) else axis
        for letter, axis in axes.items()
    }


def _axis(letter: str, axis: dict[str, Any], plain: bool) -> dict[str, Any]:
    added: dict[str, Any] = {"limits": {key: axis[key] for key in LIMITS}} if _limits_beside(axis) else {}
    if plain and letter in ROLES:
        added |= {"role": ROLES[letter], "parent": None}
    return added | axis


def _limits_beside(axis: Mapping[str, Any]) -> bool:
    return "limits" not in axis and all(key in axis for key in LIMITS)


def _all_linear(axes: Mapping[str, Any]) -> bool:
    return all(isinstance(axis, dict) and axis.get("type") == "linear" for axis in axes.values())
