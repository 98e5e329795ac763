# SPDX-License-Identifier: LGPL-2.1-or-later
"""An audit takes the cutter that its program names, as the command does, unless another one is given."""

import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app import changes, results

pytestmark = pytest.mark.usefixtures("kept")
MACHINE = "trunnion_ac"


@pytest.fixture
def posted(doc, ball, tmp_path):
    """The program of a ball of 6 mm."""
    path = app.create_toolpath(doc, ball, machine=MACHINE, cutter="ball:6", stepover=4, passes="planes")
    app.post_process(path, tmp_path / "six.ngc")
    return str(tmp_path / "six.ngc")


def codes(audit):
    return [one.code for one in results.result_of(audit).findings]


def taken(audit):
    return results.result_of(audit).draft.settings.cutter.cutter.diameter


def test_beside_a_part_it_is_the_programs_and_the_properties_show_it(doc, ball, posted, reopen):
    audit = app.audit(doc, posted, MACHINE, part=ball, tolerance=0.05)
    assert "cutter-from-program" in codes(audit) and taken(audit) == audit.CutterDiameter.Value == 6
    assert audit.Light != "red", (audit.Verdict, audit.Findings)
    assert not any("too deep" in text for text in audit.Findings)
    assert not results.out_of_date(audit) and audit.State == ["Up-to-date"]
    name = audit.Name
    again = reopen(doc).getObject(name)
    assert again.CutterFromProgram and not results.out_of_date(again) and taken(again) == 6


@pytest.mark.parametrize("cutter", ["ball:10", "ball:8"])
def test_one_that_is_given_counts(doc, ball, posted, cutter):
    audit = app.audit(doc, posted, MACHINE, part=ball, tolerance=0.05, cutter=cutter)
    assert taken(audit) == audit.CutterDiameter.Value == float(cutter[5:])
    assert "cutter-from-program" not in codes(audit) and not audit.CutterFromProgram


def test_one_that_is_typed_into_the_properties_counts_and_can_be_taken_back(doc, ball, posted):
    audit = app.audit(doc, posted, MACHINE, part=ball, tolerance=0.05)
    audit.CutterDiameter = 10
    doc.recompute()
    assert taken(audit) == 10 and not audit.CutterFromProgram
    changes.change_audit(audit, posted, {"machine": MACHINE})
    assert taken(audit) == audit.CutterDiameter.Value == 6 and "cutter-from-program" in codes(audit)


def test_of_an_earlier_version_a_cutter_that_is_not_the_default_was_given(doc, ball, posted, reopen):
    given = app.audit(doc, posted, MACHINE, part=ball, cutter="ball:8")
    unsaid = app.audit(doc, posted, MACHINE, part=ball, cutter="ball:10")
    names = [one.Name for one in (given, unsaid)]
    assert all(one.removeProperty("CutterFromProgram") for one in (given, unsaid))
    again = reopen(doc)
    assert [taken(again.getObject(name)) for name in names] == [8, 6]
