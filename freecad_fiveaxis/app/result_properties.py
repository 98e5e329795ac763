# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of what the last computation of a path found."""

from __future__ import annotations

from .properties import FINDINGS, FINGERPRINT, QT_TRANSLATE_NOOP, RESULT, Property

RESULTS = (
    Property("Passes", "App::PropertyInteger", "Result", QT_TRANSLATE_NOOP("App::Property", "Passes over the "
        "part"), 0, RESULT),
    Property("Blocks", "App::PropertyInteger", "Result", QT_TRANSLATE_NOOP("App::Property", "Blocks of the "
        "program"), 0, RESULT),
    Property(
        "Time", "App::PropertyTime", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Time that the program takes"), 0.0, RESULT
    ),
    Property(
        "CutLength", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Way of the tip along the part"), 0.0, RESULT,
    ),
    Property(
        "MaxSurfaceDeviation", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Largest deviation of what makes the surface, which the verdict goes by: a ball cutter's centre, "
            "or the tip",
        ),
        0.0, RESULT,
    ),
    Property(
        "MaxSurfaceBound", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Proven upper bound of the deviation of what makes the surface"),
        0.0, RESULT,
    ),
    Property(
        "MaxSegmentDeviation", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Largest deviation of the tip from the commanded segments"), 0.0,
        RESULT,
    ),
    Property(
        "MaxLineDeviation", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Largest deviation of the tip from the lines of the commanded "
            "segments"),
        0.0, RESULT,
    ),
    Property(
        "MaxBound", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Proven upper bound of the tip's deviation from the commanded "
            "segments"), 0.0, RESULT,
    ),
    Property(
        "Proven", "App::PropertyBool", "Result",
        QT_TRANSLATE_NOOP("App::Property", "The proven bound of every block is within the tolerance"), False,
        RESULT,
    ),
    Property(
        "GuidedBlocks", "App::PropertyInteger", "Result",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Blocks under RTCP: only their end points are verified, the controller moves the tip between them"
        ),
        0, RESULT,
    ),
    Property(
        "Verdict", "App::PropertyString", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Whether the program is safe to run, and why, in a plain "
            "sentence"), "", RESULT,
    ),
    Property(
        "Light", "App::PropertyString", "Result",
        QT_TRANSLATE_NOOP("App::Property", "The verdict as a traffic light: red, amber or green"), "", RESULT,
    ),
    Property(
        "OverTolerance", "App::PropertyInteger", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Blocks that leave the commanded segment by more than the "
            "tolerance"), 0, RESULT,
    ),
    Property(
        "SingularBlocks", "App::PropertyInteger", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Blocks near the pole, where a rotary axis turns far to lean the "
            "tool a little"),
        0, RESULT,
    ),
    Property(
        "WorstLine", "App::PropertyInteger", "Result",
        QT_TRANSLATE_NOOP("App::Property", "NC line of the block with the largest deviation; 0: none"), 0,
        RESULT,
    ),
    FINDINGS,
    FINGERPRINT,
)  # fmt: skip
"""What a Toolpath and an Audit show of their last computation."""
