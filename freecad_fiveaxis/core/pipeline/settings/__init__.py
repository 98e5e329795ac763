# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every input of a job: its groups and the tree that they make."""

from .groups import (
    RTCP,
    CureSettings,
    FacesSettings,
    GougeSettings,
    HeadSettings,
    OutputSettings,
    SetupSettings,
)
from .option import (
    AUDIT,
    COMPARE,
    MILL,
    POST,
    PROVE,
    REACH,
    RECOVER,
    SETUP,
    TASKS,
    TRIALS,
    WITHOUT_SOURCE,
    WORKSHOP,
    option,
)
from .tree import FRAMES, Settings, build_settings, flat_options, is_part, option_fields

__all__ = [
    "AUDIT",
    "COMPARE",
    "FRAMES",
    "MILL",
    "POST",
    "PROVE",
    "REACH",
    "RECOVER",
    "RTCP",
    "SETUP",
    "TASKS",
    "TRIALS",
    "WITHOUT_SOURCE",
    "WORKSHOP",
    "CureSettings",
    "FacesSettings",
    "GougeSettings",
    "HeadSettings",
    "OutputSettings",
    "Settings",
    "SetupSettings",
    "build_settings",
    "flat_options",
    "is_part",
    "option",
    "option_fields",
]
