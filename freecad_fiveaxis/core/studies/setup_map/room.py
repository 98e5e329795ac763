# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the recommended setup of a map needs beside the work zero: how far the tool must stick out, and how
high the jaws of a vise may reach."""

from __future__ import annotations

from dataclasses import replace

from freecad_fiveaxis.core.base.progress import Progress, silent

from .jaws import clamping_findings, find_clamping
from .setups import SetupMap
from .standing import Standing
from .stick_out import find_stick_out, stick_out_findings


def with_room(chart: SetupMap, stand: Standing, thick: float, progress: Progress = silent) -> SetupMap:
    """Add to a map with a recommended setup, which ``stand`` is, what the tool needs there, how high jaws
    ``thick`` mm thick may reach, and what is to be said of that."""
    stick_out = find_stick_out(stand, progress)
    clamping = find_clamping(stand, thick, progress)
    more = (*stick_out_findings(stick_out), *clamping_findings(clamping))
    return replace(chart, stick_out=stick_out, clamping=clamping, findings=(*chart.findings, *more))
