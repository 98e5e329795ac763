# SPDX-License-Identifier: LGPL-2.1-or-later
"""The configurations that come with LinuxCNC give the machines that come with this program."""

from __future__ import annotations

from pathlib import Path

import pytest

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.importing import import_machine

FIVE_AXIS = Path("/usr/share/doc/linuxcnc/examples/sample-configs/sim/axis/vismach/5axis")
SAMPLES = FIVE_AXIS / "table-rotary-tilting"
pytestmark = [
    pytest.mark.linuxcnc,
    pytest.mark.skipif(not SAMPLES.is_dir(), reason="LinuxCNC's samples are not installed"),
]


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


@pytest.mark.parametrize(
    ("name", "axes", "codes"),
    [
        (
            "table-dual-rotary/xyzab-tdr.ini",
            {
                "A": ("table", (1.0, 0.0, 0.0), (-50.0, -50.0, -110.0)),
                "B": ("table", (0.0, 1.0, 0.0), (-50.0, -50.0, -100.0)),
            },
            ["offset-from-panel"],
        ),
        (
            "max5/max5kins.ini",
            {
                "C": ("table", (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)),
                "B": ("head", (0.0, -1.0, 0.0), (0.0, 0.0, 0.0)),
            },
            ["forward-differs", "tool-length-in-w"],
        ),
    ],
)
def test_other_simulations_give_their_lines_and_what_is_to_be_stated(name, axes, codes) -> None:
    imported = import_machine(str(FIVE_AXIS / name))
    assert {axis.letter: (axis.side, axis.direction, axis.point) for axis in imported.machine.rotary} == axes
    assert [found.code for found in imported.findings] == codes


def test_the_bridge_mill_needs_the_length_that_its_picture_alone_knows() -> None:
    with pytest.raises(MachineError, match=r"write setp pivotsum\.in0 VALUE"):
        import_machine(str(FIVE_AXIS / "bridgemill" / "5axis.ini"))
