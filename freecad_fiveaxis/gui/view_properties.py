# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of our view providers, with the user's preferred colours as defaults."""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.app import preferences

from .qt import QT_TRANSLATE_NOOP

GROUP = "Five-axis"
AXIS_COLOUR = (0.68, 0.86, 1.0)
STROKE_COLOUR = (0.10, 0.13, 0.16)
"""Of axes over a part that is coloured itself."""

Row = tuple[str, str, Any, str]
"""Kind, name, default, documentation. A default that can be called is called when the property is made."""

COLOURS: tuple[Row, ...] = (
    ("App::PropertyColor", "ColourGood", preferences.colour_good,
     QT_TRANSLATE_NOOP("App::Property", "Colour of blocks within the tolerance")),
    ("App::PropertyColor", "ColourBad", preferences.colour_bad,
     QT_TRANSLATE_NOOP("App::Property", "Colour of blocks over the tolerance")),
    ("App::PropertyColor", "ColourSingular", preferences.colour_singular,
     QT_TRANSLATE_NOOP("App::Property", "Colour of markers near the pole")),
)  # fmt: skip
MARKS: tuple[Row, ...] = (
    ("App::PropertyBool", "ShowLabel", True, QT_TRANSLATE_NOOP("App::Property", "Show the value at the "
        "largest deviation")),
    ("App::PropertyFloatConstraint", "MarkerSize", (7.0, 3.0, 25.0, 1.0),
     QT_TRANSLATE_NOOP("App::Property", "Size of the markers in pixels")),
)  # fmt: skip
LEGEND: tuple[Row, ...] = (
    ("App::PropertyBool", "ShowLegend", True, QT_TRANSLATE_NOOP("App::Property", "Show what the colours "
        "mean")),
    ("App::PropertyBool", "FoldLegend", False, QT_TRANSLATE_NOOP("App::Property", "Leave one line of the "
        "legend")),
)  # fmt: skip
PATH: tuple[Row, ...] = (
    ("App::PropertyBool", "ShowCuts", True,
     QT_TRANSLATE_NOOP("App::Property", "Show what cuts, in the colours of its deviation")),
    ("App::PropertyBool", "ShowLinks", True,
     QT_TRANSLATE_NOOP("App::Property", "Show the ways between passes at feed, and where the tool is lifted "
         "off the part")),
    ("App::PropertyBool", "ShowAxes", True, QT_TRANSLATE_NOOP("App::Property", "Show the tool axis here and "
        "there on the path")),
    ("App::PropertyBool", "ShowMarkers", True,
     QT_TRANSLATE_NOOP("App::Property", "Show blocks over the tolerance and near the pole")),
    ("App::PropertyBool", "ShowCurves", True,
     QT_TRANSLATE_NOOP("App::Property", "Show the real curve of the worst blocks beside the commanded line")),
    ("App::PropertyBool", "ShowRapids", False, QT_TRANSLATE_NOOP("App::Property", "Show the rapids")),
    *LEGEND,
    *MARKS,
    ("App::PropertyFloatConstraint", "LineWidth", (2.0, 1.0, 10.0, 0.5),
     QT_TRANSLATE_NOOP("App::Property", "Width of the path in pixels")),
    ("App::PropertyLength", "AxisLength", 0.0,
     QT_TRANSLATE_NOOP("App::Property", "Length of the tool axes; 0: as the part needs it")),
    *COLOURS,
    ("App::PropertyColor", "ColourAxes", AXIS_COLOUR, QT_TRANSLATE_NOOP("App::Property", "Colour of the tool "
        "axes")),
)  # fmt: skip
PATH_SWITCHES = tuple(row[1] for row in PATH if row[0] == "App::PropertyBool")
MARKERS: tuple[Row, ...] = (*MARKS, *COLOURS)


SETUPS: tuple[Row, ...] = (
    ("App::PropertyBool", "ShowLabel", True, QT_TRANSLATE_NOOP("App::Property", "Show the value at the "
        "recommended place")),
    *LEGEND,
    ("App::PropertyBool", "ShowAllPlaces", False,
     QT_TRANSLATE_NOOP("App::Property", "Show the places at all heights, not only those at the recommended "
         "one")),
    ("App::PropertyFloatConstraint", "MarkerSize", (9.0, 3.0, 25.0, 1.0),
     QT_TRANSLATE_NOOP("App::Property", "Size of the markers in pixels")),
    ("App::PropertyColor", "ColourGood", preferences.colour_good,
     QT_TRANSLATE_NOOP("App::Property", "Colour of places within the tolerance")),
    ("App::PropertyColor", "ColourBad", preferences.colour_bad,
     QT_TRANSLATE_NOOP("App::Property", "Colour between the least and the largest deviation")),
)  # fmt: skip
REST: tuple[Row, ...] = (
    ("App::PropertyBool", "ShowLabel", True,
     QT_TRANSLATE_NOOP("App::Property", "Show the values where most is left and where the cut is deepest")),
    *LEGEND,
)  # fmt: skip
REACH: tuple[Row, ...] = (
    *LEGEND,
    ("App::PropertyBool", "ShowAxes", False,
     QT_TRANSLATE_NOOP("App::Property", "Show the tool axis with which each place is reached, as a short "
         "stroke")),
    ("App::PropertyLength", "AxisLength", 0.0,
     QT_TRANSLATE_NOOP("App::Property", "Length of the tool axes; 0: as the part needs it")),
    ("App::PropertyColor", "ColourAxes", STROKE_COLOUR, QT_TRANSLATE_NOOP("App::Property", "Colour of the "
        "tool axes")),
)  # fmt: skip


def add_missing(vobj: Any, rows: tuple[Row, ...]) -> None:
    """Give the view object each property that it does not have."""
    there = set(vobj.PropertiesList)
    for kind, name, default, text in rows:
        if name not in there:
            vobj.addProperty(kind, name, GROUP, text)
            setattr(vobj, name, default() if callable(default) else default)


def rgb(colour: Any) -> tuple[float, float, float]:
    """Return a colour property without its alpha."""
    return tuple(colour)[:3]
