# SPDX-License-Identifier: LGPL-2.1-or-later
"""An audit names F words that the controller does not take."""

import pytest

from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings

HEAD = "G21 G90 G17\nM3 S800\nG0 X0 Y0 Z10 A0 C0\n"


def found_in(tmp_path, controller, text):
    nc = tmp_path / "part.nc"
    nc.write_text(HEAD + text + "M30\n")
    draft = job.make(build_settings("audit", str(nc), {"machine": "trunnion_ac", "controller": controller}))
    return [one for one in draft.findings if one.code == "feed-word-too-large"]


@pytest.mark.parametrize(("controller", "count"), [("fanuc", 2), ("haas", 1), ("linuxcnc", 0)])
def test_an_f_above_the_largest_under_g93_is_named_with_its_line(tmp_path, controller, count):
    found = found_in(tmp_path, controller, "G93 G1 X0.1 F9999.999\nX0.2 F3121800.\nX0.3 F20000.\n")
    assert len(found) == min(count, 1)
    if found:
        assert (found[0].line, round(found[0].value)) == (5, 3121800)
        assert ("2 NC lines" in found[0].text) == (count == 2) and "F3121800" in found[0].text


def test_an_f_above_the_largest_per_minute_is_named_too(tmp_path):
    (found,) = found_in(tmp_path, "fanuc", "G94 G1 X5. F100000.\nX6. F99999.\n")
    assert (found.line, found.value, found.unit) == (4, 100000.0, "mm/min")


def test_an_arc_has_one_f_for_all_its_chords(tmp_path):
    assert found_in(tmp_path, "fanuc", "G93 G1 X10. F100.\nG2 X20. Y0. I5. J0. F9000.\n") == []
