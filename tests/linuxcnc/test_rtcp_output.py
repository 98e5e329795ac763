# SPDX-License-Identifier: LGPL-2.1-or-later
"""What ``post --rtcp`` writes for LinuxCNC, run on its whole controller: the tip stays on the chords of the
CL path."""

from __future__ import annotations

import numpy as np
import pytest
from controller import LENGTH, TOOL, missing, run_programs, write_configuration
from test_whole_controller import CHORD_TOLERANCE, PINS, blocks_of, from_segment, some_joints, tip_of

from freecad_fiveaxis.core.machine import save_machine
from freecad_fiveaxis.core.machine.importing import import_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.apt import ClHead, write_apt

pytestmark = [pytest.mark.linuxcnc, pytest.mark.skipif(bool(missing()), reason=missing() or "it is here")]


@pytest.mark.parametrize("kinematics", PINS)
def test_the_tip_of_a_posted_rtcp_program_stays_on_the_chords_of_the_cl_path(kinematics, tmp_path) -> None:
    machine = import_machine(str(write_configuration(tmp_path, kinematics, PINS[kinematics]))).machine
    save_machine(machine, tmp_path / "ring.fcm")
    path = some_joints(chain(machine, Setup(machine.origin)), blocks=6).path
    (tmp_path / "a.apt").write_bytes(write_apt(path, Cutter(10.0), "ring", head=ClHead(tool=TOOL)))
    given = {"machine": str(tmp_path / "ring.fcm"), "controller": "linuxcnc", "rtcp": "angles"}
    posted = [
        job.make(build_settings("post", str(tmp_path / "a.apt"), given | {"feed_mode": mode}))
        for mode in ("g93", "g94")
    ]
    travelled = run_programs(kinematics, PINS[kinematics], [result.nc.decode() for result in posted])
    for result, samples in zip(posted, travelled, strict=True):
        samples[:, 3] -= LENGTH
        program, tip = result.program, result.program.guided.tip
        at = np.arange(1, len(tip))
        assert np.abs(tip - path.tip[program.row]).max() < 1e-4
        for k, block in zip(at, blocks_of(samples, program.line[at].tolist()), strict=True):
            assert from_segment(tip_of(kinematics, block), tip[k - 1], tip[k]).max() < CHORD_TOLERANCE
