# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the recommended setup of a map needs beside the work zero: how far the tool must stick out, and how
high the jaws of a vise may reach. Where the tool hits the machine in every setup, the one in which it does so
least is recommended for a tool that sticks out farther, if one is free there."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from freecad_fiveaxis.core.base.progress import Progress, silent

from .jaws import clamping_findings, find_clamping
from .setups import SetupMap
from .standing import Standing
from .stick_out import StickOut, find_stick_out, stick_out_findings


def with_room(chart: SetupMap, stand: Standing, thick: float, progress: Progress = silent) -> SetupMap:
    """Add to a map with a recommended setup, which ``stand`` is, what the tool needs there, how high jaws
    ``thick`` mm thick may reach, and what is to be said of that."""
    stick_out = find_stick_out(stand, progress)
    clamping = find_clamping(stand, thick, progress, _longer(stick_out))
    more = (*stick_out_findings(stick_out), *clamping_findings(clamping))
    return replace(chart, stick_out=stick_out, clamping=clamping, findings=(*chart.findings, *more))


def _longer(found: StickOut | None) -> float:
    """How much farther the tool sticks out of which the jaws are told: not at all where it is free as it
    is."""
    return 0.0 if found is None or found.enough is None or found.met is None else found.enough - found.present


def with_longer_tool(
    chart: SetupMap, stand_in: Callable[[SetupMap], Standing], thick: float, progress: Progress = silent
) -> SetupMap | None:
    """Recommend the setup in which the machine is hit least, for a tool that sticks out farther and is proven
    to be free there; None where there is none. ``stand_in(chart)``: its recommended setup."""
    if chart.least_hit is None:
        return None
    chart = replace(chart, best=chart.least_hit)
    stand = stand_in(chart)
    found = with_room(chart, stand, thick, progress)
    return found if _frees(found.stick_out, stand, progress) else None


def _frees(found: StickOut | None, stand: Standing, progress: Progress) -> bool:
    """Whether a longer tool is why nothing is hit, cutter and all."""
    if found is None or found.enough is None or found.met is None:
        return False
    run = stand.run(found.enough - found.present, progress)
    return run.meets_machine(progress, cutter=True) is None
