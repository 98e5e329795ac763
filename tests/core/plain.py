# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests ask for that look at something else than passes and tool axes: parallel planes, the tool on the
facets' normals, as Lin & Ye. That is quick, and known in closed form."""

from freecad_fiveaxis.core.pipeline import settings

PLAIN = {"passes": "planes", "tool_axis": "facet_mean"}
PLAIN_WORDS = ("--passes", "planes", "--tool-axis", "facet_mean")


def build_settings(task, source, options):
    """The core's settings, plain where the options leave that open."""
    plain = PLAIN if task in (settings.MILL, settings.SETUP, settings.COMPARE) else {}
    return settings.build_settings(task, source, {**plain, **options})
