# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a SetupMap object."""

from __future__ import annotations

from freecad_fiveaxis.core.pipeline.settings import SETUP, SetupSettings, option_fields

from .properties import (
    FINDINGS,
    FINGERPRINT,
    QT_TRANSLATE_NOOP,
    READ_ONLY,
    RESULT,
    Property,
    property_name,
    setting_properties,
)

LEAVES = tuple(leaf for cls, leaf in option_fields(SETUP) if cls is SetupSettings)
OWN = tuple(property_name(leaf.name) for leaf in LEAVES)

PROPERTIES = (
    Property(
        "Path", "App::PropertyLinkGlobal", "Base",
        QT_TRANSLATE_NOOP("App::Property", "The toolpath whose part is to be clamped"),
        None, READ_ONLY,
    ),
    *(one for one in setting_properties(SETUP) if one.name in OWN),
    Property(
        "Recommended", "App::PropertyVectorDistance", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Where the work zero should stand, in the machine frame"),
        (0.0, 0.0, 0.0), RESULT,
    ),
    Property(
        "RecommendedTurn", "App::PropertyAngle", "Result",
        QT_TRANSLATE_NOOP("App::Property", "How far the part should be turned about Z, counter-clockwise"),
        0.0, RESULT,
    ),
    Property(
        "DeviationBefore", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Largest deviation where the work zero stood"), 0.0, RESULT,
    ),
    Property(
        "DeviationAfter", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Largest deviation in the recommended setup"), 0.0, RESULT,
    ),
    Property(
        "TimeBefore", "App::PropertyTime", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Time of the program where the work zero stood"), 0.0, RESULT,
    ),
    Property(
        "TimeAfter", "App::PropertyTime", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Time of the program in the recommended setup"), 0.0, RESULT,
    ),
    Property(
        "Verdict", "App::PropertyString", "Result",
        QT_TRANSLATE_NOOP("App::Property", "What is recommended, in a plain sentence"), "", RESULT,
    ),
    FINDINGS,
    Property(
        "UpToDate", "App::PropertyBool", "Result",
        QT_TRANSLATE_NOOP("App::Property", "The map is of the toolpath as it is now; if it is not, try the "
            "setups again"),
        False, RESULT,
    ),
    Property(
        "Centre", "App::PropertyVectorDistance", "Map",
        QT_TRANSLATE_NOOP("App::Property", "The work zero in the machine frame about which setups were "
            "tried"),
        (0.0, 0.0, 0.0), RESULT,
    ),
    Property(
        "Places", "App::PropertyVectorList", "Map",
        QT_TRANSLATE_NOOP("App::Property", "Where the work zeros of the map lie in the document"), [], RESULT,
    ),
    Property(
        "Kinds", "App::PropertyStringList", "Map", QT_TRANSLATE_NOOP("App::Property", "What each place is"),
        [], RESULT,
    ),
    Property(
        "Deviations", "App::PropertyFloatList", "Map",
        QT_TRANSLATE_NOOP("App::Property", "The largest deviation at each place, mm"), [], RESULT,
    ),
    FINGERPRINT,
)  # fmt: skip
