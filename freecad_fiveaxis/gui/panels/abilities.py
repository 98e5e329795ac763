# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a controller can do: the options that count for nothing on it, and the choices that it does not know.

dialect   the core's table of the controller.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from freecad_fiveaxis.app.labels import controller_label
from freecad_fiveaxis.gui.qt import translate

LACKING = {"rtcp": "off", "high_speed": "off"}
"""Options that a controller may not have, and what they are then."""


def reasons(dialect: Any) -> dict[str, str]:
    """Why an option cannot be chosen on a controller, by its name."""
    texts = {
        "rtcp": (
            not dialect.guides,
            translate("FiveAxis", "{controller} does not guide the tip itself: divide blocks instead."),
        ),
        "high_speed": (
            not dialect.high_speed[0],
            translate("FiveAxis", "{controller} has no high-speed mode to switch."),
        ),
        "feed_mode": (
            not dialect.inverse_time,
            translate("FiveAxis", "{controller} has no inverse time: F is in mm/min."),
        ),
    }
    name = controller_label(dialect.name)
    return {option: text.format(controller=name) for option, (lacks, text) in texts.items() if lacks}


def unknown_choices(dialect: Any) -> dict[str, set[str]]:
    """Return the choices of each option that a controller does not know."""
    from freecad_fiveaxis.core.pipeline.settings import RTCP

    return {"rtcp": set(RTCP) - {"off", *dialect.guides}, "nc_units": set() if dialect.inch else {"inch"}}


def check_guide(dialect: Any, options: Mapping[str, Any]) -> None:
    """Raise SettingsError where the controller does not guide the tip as it is asked to, or misses what it
    needs for it."""
    from freecad_fiveaxis.core.base.errors import SettingsError

    how = options.get("rtcp", "off")
    if how != "off" and dialect.guide_by(how).guide.needs_tool and not options.get("tool"):
        text = translate(
            "FiveAxis", "{controller} needs the number of the tool for it: give it in the group Tool."
        )
        raise SettingsError(text.format(controller=controller_label(dialect.name)), how)
