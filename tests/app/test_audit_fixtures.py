# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of an audit: solids of the document that somebody's program is proven against, wherever the
machine takes them."""

from pathlib import Path

import FreeCAD
import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app import changes, proposing, results
from freecad_fiveaxis.core.base.errors import FiveAxisError

PROGRAM = "G21 G90 G94\nG1 X0 Y0 Z40 {rotary} F2000\nG1 X0 Y0 Z20\nG1 X40 Y0 Z20\nG1 X40 Y0 Z40\nM2\n"
"""Along X at a height of 20: a clamp whose top is at 25 stands 5 mm in the way of the flat end."""
MACHINES = {"trunnion_ac": "A0 C0", "head_b_table_c": "B0 C0", "fork_head_bc": "B0 C0"}


def box(doc, name, low, size):
    one = doc.addObject("Part::Box", name)
    one.Length, one.Width, one.Height = size
    one.Placement.Base = FreeCAD.Vector(*low)
    doc.recompute()
    return one


def clamp(doc, shift=(0, 0, 0)):
    return box(doc, "Clamp", (20 + shift[0], -10 + shift[1], shift[2]), (10, 20, 25))


def program(folder, machine="trunnion_ac"):
    file = folder / "given.ngc"
    file.write_text(PROGRAM.format(rotary=MACHINES[machine]))
    return str(file)


EXAMPLE = Path(__file__).resolve().parents[2] / "resources" / "machines" / "trunnion_with_bodies.fcm"
GIVEN = {"machine": "trunnion_ac", "cutter": "flat:6:30", "tool_length": 120}


def hits(audit):
    return [one for one in results.result_of(audit).findings if one.code == "fixture-collision"]


@pytest.mark.parametrize("machine", MACHINES)
def test_the_tool_is_proven_against_a_solid_on_every_kind_of_machine(doc, tmp_path, machine):
    file = program(tmp_path, machine)
    given = GIVEN | {"machine": machine, "work_zero": (5, 6, 7)}
    result = app.audit(doc, file, fixtures=[clamp(doc, (5, 6, 7))], **given)
    (one,) = hits(result)
    assert one.line == 4 and one.hit.enters == "cutter" and one.hit.entered == "Clamp"
    assert any("into the fixture Clamp" in text for text in result.Findings)
    assert results.figures_of(result).fixtures == ("Clamp",)
    far = app.audit(doc, file, fixtures=[box(doc, "Far", (5, 60, 0), (10, 10, 40))], **given)
    assert not hits(far), "the comparison can fail"


def test_moving_changing_and_taking_away_a_fixture_makes_the_audit_another(doc, tmp_path):
    held, file = clamp(doc), program(tmp_path)
    result = app.audit(doc, file, fixtures=[held], **GIVEN)
    assert hits(result) and not results.out_of_date(result)
    held.Placement.Base.y = 60
    assert "Clamp was changed" in results.out_of_date(result)
    doc.recompute()
    assert not results.out_of_date(result) and not hits(result)
    held.Placement.Base.y = -10
    doc.recompute()
    changes.change_audit(result, file, GIVEN)
    assert result.Fixtures == [held] and hits(result), "what is not named stays"
    changes.change_audit(result, file, {**GIVEN, "fixtures": []})
    assert not result.Fixtures and not hits(result) and results.figures_of(result).fixtures == ()


def test_shank_holder_and_spindle_are_looked_at_beside_fixtures_without_a_part(doc, tmp_path):
    tall = box(doc, "Tall", (20, 10, 0), (10, 10, 60))  # 10 mm beside the way, up past the cutter of 30 mm
    file = program(tmp_path)
    assert not hits(app.audit(doc, file, fixtures=[tall], **GIVEN))
    (one,) = hits(app.audit(doc, file, fixtures=[tall], holder="30x40", **GIVEN))
    assert one.hit.enters == "holder" and one.value == pytest.approx(5.0, rel=0.02)
    with_spindle = GIVEN | {"machine": str(EXAMPLE), "tool_length": 35}
    (one,) = hits(app.audit(doc, file, fixtures=[tall], **with_spindle))
    assert one.hit.enters == "spindle" and one.hit.entered == "Tall"


def test_near_misses_are_reported_beside_a_fixture(doc, tmp_path):
    result = app.audit(
        doc, program(tmp_path), fixtures=[clamp(doc, (0, 15, 0))], fixture_clearance=4, **GIVEN
    )
    (one,) = [one for one in results.result_of(result).findings if one.code == "fixture-near"]
    assert one.value == pytest.approx(2.0, abs=0.05) and not hits(result)


def test_the_part_itself_and_what_is_no_solid_are_refused_and_nothing_is_left_behind(doc, tmp_path):
    held, file = clamp(doc), program(tmp_path)
    note = doc.addObject("App::FeaturePython", "Note")
    many = len(doc.Objects)
    with pytest.raises(FiveAxisError, match="Clamp is the part to compare with"):
        app.audit(doc, file, part=held, fixtures=[held], **GIVEN)
    with pytest.raises(FiveAxisError):
        app.audit(doc, file, fixtures=[note], **GIVEN)
    assert len(doc.Objects) == many


def test_fixtures_are_kept_in_the_file_of_the_document(doc, tmp_path, reopen):
    result = app.audit(doc, program(tmp_path), fixtures=[clamp(doc)], **GIVEN)
    name = result.Name
    again = reopen(doc).getObject(name)
    assert [one.Label for one in again.Fixtures] == ["Clamp"]
    assert not results.out_of_date(again) and hits(again)


def test_those_of_the_tool_path_are_proposed_for_the_audit_of_its_program(doc):
    part, held = box(doc, "Plate", (0, 0, 0), (30, 20, 10)), clamp(doc, (0, -20, 0))
    path = app.create_toolpath(
        doc, part, machine="trunnion_ac", cutter="ball:6", passes="planes", stepover=8, fixtures=[held]
    )
    assert proposing.values_of(path)["fixtures"] == [held]
