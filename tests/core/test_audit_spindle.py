# SPDX-License-Identifier: LGPL-2.1-or-later
"""An audit says that nothing starts the spindle before the tool feeds."""

import pytest

from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings

MOVES = "G21 G90\nG0 X0 Y0 Z10 A0 C0\n{before}\nG1 Z0 F100\nX5\n{after}\n{end}\n"


def found_in(tmp_path, before="", after="", end="M30", text=MOVES):
    nc = tmp_path / "part.ngc"
    nc.write_text(text.format(before=before, after=after, end=end))
    draft = job.make(build_settings("audit", str(nc), {"machine": "trunnion_ac"}))
    return [one.line for one in draft.findings if one.code == "spindle-off"]


@pytest.mark.parametrize("before", ["", "M5", "S800", "(M3 S800)", "; M3 S800", "G4 P3"])
def test_what_does_not_start_the_spindle_is_reported_with_the_first_line_that_feeds(tmp_path, before):
    assert found_in(tmp_path, before) == [4]


@pytest.mark.parametrize("before", ["M3 S800", "S800M03", "m4 s100", "M13", "N5 M14 S3"])
def test_what_starts_it_is_known(tmp_path, before):
    assert found_in(tmp_path, before) == []


def test_after_the_first_feed_it_is_too_late(tmp_path):
    assert found_in(tmp_path, after="M3 S800") == [4]


def test_a_part_of_a_program_may_be_called_with_the_spindle_on(tmp_path):
    assert found_in(tmp_path, end="") == found_in(tmp_path, end="(M30)") == []


def test_klartext_and_siemens_start_it_in_their_words(tmp_path):
    klartext = "BEGIN PGM A MM\nL X0 Y0 Z10 A0 C0 F9999{before}\nL Z0 F100\n{after}{end}\n"
    assert found_in(tmp_path, " M13", end="END PGM A MM", text=klartext) == []
    assert found_in(tmp_path, "", end="END PGM A MM", text=klartext) != []
