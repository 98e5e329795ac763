# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Markers object: where on the part a toolpath or an audit is worth a look."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD

from freecad_fiveaxis.core import report
from freecad_fiveaxis.core.base.sentences import Area, say
from freecad_fiveaxis.core.gouge import GOUGES

from .plain_errors import hide_trace
from .properties import QT_TRANSLATE_NOOP, READ_ONLY, Property
from .results import figures_of
from .schema import Proxy
from .selection import SelectionError

PROPERTIES = (
    Property(
        "Path", "App::PropertyLinkGlobal", "Base",
        QT_TRANSLATE_NOOP("App::Property", "The toolpath or audit that is marked")
    ),
    Property(
        "Places", "App::PropertyVectorList", "Markers",
        QT_TRANSLATE_NOOP("App::Property", "Where the markers stand in the document"), [], READ_ONLY,
    ),
    Property(
        "Kinds", "App::PropertyStringList", "Markers",
        QT_TRANSLATE_NOOP("App::Property", "What each marker marks"), [], READ_ONLY
    ),
    Property(
        "Labels", "App::PropertyStringList", "Markers",
        QT_TRANSLATE_NOOP("App::Property", "A few words to each marker"), [],
        READ_ONLY,
    ),
    Property(
        "Depths", "App::PropertyFloatList", "Markers",
        QT_TRANSLATE_NOOP("App::Property", "How deep the tool enters the part at each marker, mm; 0: not at "
            "all"), [], READ_ONLY,
    ),
    Property(
        "Areas", "App::PropertyFloatList", "Markers",
        QT_TRANSLATE_NOOP("App::Property", "Area that each marker stands for, as a side that no pass cuts, "
            "mm²; 0: none"), [],
        READ_ONLY,
    ),
)  # fmt: skip


class Markers(Proxy):
    """Proxy of the markers."""

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """Return the path, and place, kind, label, depth and area of each marker."""
        return PROPERTIES

    @hide_trace
    def execute(self, obj: Any) -> None:
        """FreeCAD recomputes the object."""
        if obj.Path is None:
            raise SelectionError(
                say(
                    "The path of {label} was deleted: choose another one in its property Path.",
                    label=obj.Label,
                ),
                obj.Label,
            )
        marks, zero = report.markers(figures_of(obj.Path)), obj.Path.WorkZero
        obj.Places = [FreeCAD.Vector(*mark.place) + zero for mark in marks]
        obj.Kinds = [mark.kind for mark in marks]
        obj.Labels = [mark.label for mark in marks]
        obj.Depths = [_depth(mark) for mark in marks]
        obj.Areas = [_area(mark) for mark in marks]


def _depth(mark: report.Marker) -> float:
    """mm; known of the deepest places of each kind, which have a finding."""
    return mark.finding.value or 0.0 if mark.kind in GOUGES and mark.finding else 0.0


def _area(mark: report.Marker) -> float:
    """mm², where the marker's finding measures an area."""
    return mark.finding.value or 0.0 if mark.finding and mark.finding.unit == Area.unit else 0.0


def of(path: Any) -> Any:
    """Return the Markers object of a path, or None."""
    return next((one for one in path.InList if isinstance(getattr(one, "Proxy", None), Markers)), None)


def make(path: Any) -> Any:
    """Return a Markers object, not yet computed."""
    obj = path.Document.addObject("App::FeaturePython", "Markers")
    Markers(obj)
    obj.Path = path
    return obj
