# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a ReachMap: the mesh, what holds it, the settings of ``fiveaxis reach``, and what was
found."""

from __future__ import annotations

from freecad_fiveaxis.core.pipeline.settings import REACH

from .properties import (
    FINDINGS,
    FINGERPRINT,
    QT_TRANSLATE_NOOP,
    RESULT,
    WORK_ZERO,
    Property,
    setting_properties,
)

ANY_ANGLE = 180.0
"""deg: the tool may lean as far as the machine turns."""

PROPERTIES = (
    Property(
        "Mesh", "App::PropertyLinkGlobal", "Base",
        QT_TRANSLATE_NOOP("App::Property", "The tessellation, or any mesh, that the tool is to reach"),
    ),
    Property(
        "Fixtures", "App::PropertyLinkListGlobal", "Safety",
        QT_TRANSLATE_NOOP("App::Property", "Solids and meshes of the document that hold the part: they are "
            "in the tool's way"),
    ),
    *setting_properties(REACH),
    Property(
        "LargestAxisAngle", "App::PropertyAngle", "Axis",
        QT_TRANSLATE_NOOP("App::Property", "So far the tool may lean from the work frame's Z; 180°: as far "
            "as the machine turns"),
        ANY_ANGLE,
    ),
    WORK_ZERO,
    Property(
        "WholeArea", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "The surface that was looked at"), 0.0, RESULT,
    ),
    Property(
        "ReachableArea", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Surface that the tool reaches, with an axis that was tried"), 0.0,
        RESULT,
    ),
    Property(
        "ReachableShare", "App::PropertyFloat", "Result",
        QT_TRANSLATE_NOOP("App::Property", "How much of the surface that is, in per cent"), 0.0, RESULT,
    ),
    Property(
        "TighterThanCutter", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Surface where the cutter's end would enter the part, however "
            "it leans"),
        0.0, RESULT,
    ),
    Property(
        "FlankInTheWay", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Surface where the cutter's end would be free, but not what of "
            "the cutter is above it"),
        0.0, RESULT,
    ),
    Property(
        "ShankInTheWay", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Surface where the cutter would be free, but not the shank"), 0.0,
        RESULT,
    ),
    Property(
        "HolderInTheWay", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Surface where cutter and shank would be free, but not the "
            "holder"), 0.0, RESULT,
    ),
    Property(
        "FixtureInTheWay", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Surface where the part would let the tool, but fixtures are in "
            "the way"),
        0.0, RESULT,
    ),
    Property(
        "MachineInTheWay", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Surface where the tool would be free, but bodies of the machine "
            "are in the way"),
        0.0, RESULT,
    ),
    Property(
        "BelowTable", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Surface where a part of the tool would be below the table's "
            "face"), 0.0, RESULT,
    ),
    Property(
        "BeyondMachine", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Surface for which no axis that was tried is within the machine's "
            "limits"),
        0.0, RESULT,
    ),
    Property(
        "InClosedHollow", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Surface in hollows of the part that are closed all round: no "
            "tool gets in"),
        0.0, RESULT,
    ),
    Property(
        "StickOut", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "So much farther the tool should stick out where holder, "
            "fixture or machine are in the way"),
        0.0, RESULT,
    ),
    Property(
        "StickOutArea", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Surface that the tool then reaches besides"), 0.0, RESULT,
    ),
    Property(
        "RadiusTooLarge", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "By so much the ball's radius is too large where the cutter "
            "itself is in the way"),
        0.0, RESULT,
    ),
    Property(
        "Advice", "App::PropertyString", "Result",
        QT_TRANSLATE_NOOP("App::Property", "What would help where holder, fixture, machine or cutter are "
            "in the way, in plain sentences"),
        "", RESULT,
    ),
    Property(
        "Verdict", "App::PropertyString", "Result",
        QT_TRANSLATE_NOOP("App::Property", "How much the tool reaches, in a plain sentence"), "", RESULT,
    ),
    FINDINGS,
    Property(
        "UpToDate", "App::PropertyBool", "Result",
        QT_TRANSLATE_NOOP("App::Property", "The map is of the part and the settings as they are now"), False,
        RESULT,
    ),
    FINGERPRINT,
)  # fmt: skip
