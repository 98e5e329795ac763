# SPDX-License-Identifier: LGPL-2.1-or-later
"""The configurations that come with LinuxCNC give the machines that come with this program."""

from __future__ import annotations

from pathlib import Path

import pytest

from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.importing import import_machine

SAMPLES = Path("/usr/share/doc/linuxcnc/examples/sample-configs/sim/axis/vismach/5axis/table-rotary-tilting")
pytestmark = [pytest.mark.linuxcnc, pytest.mark.skipif(not SAMPLES.is_dir(), reason="LinuxCNC's samples are not installed")]


@pytest.mark.parametrize("kind", ["xyzac", "xyzbc"])
def test_linuxcncs_own_simulation_is_the_shipped_machine_but_for_its_size(kind: str) -> None:
    imported = import_machine(str(SAMPLES / f"{kind}-trt.ini"))
    shipped = load_machine(f"linuxcnc_{kind}_trt")
    assert imported.findings == ()
    for ours, theirs in zip(imported.machine.axes, shipped.axes, strict=True):
        assert (ours.letter, ours.side, ours.direction, ours.point) == (
            theirs.letter,
            theirs.side,
            theirs.direction,
            theirs.point,
        )
        assert not ours.rotary or (ours.low, ours.high) == (theirs.low, theirs.high)
