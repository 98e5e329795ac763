# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core says reaches the user in German and in inches: findings, errors, the verdict in the document and in the panel."""

import re

import FreeCAD
import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app import wording
from freecad_fiveaxis.core.errors import FiveAxisError
from freecad_fiveaxis.core.sentences import CONTEXT, OPTIONS, Length, Option, Point, say
from freecad_fiveaxis.core.settings import build_settings
from freecad_fiveaxis.gui.qt import translate
from freecad_fiveaxis.gui.scene import gouge_words

SCHEMAS = {0: "mm", 1: "mm", 2: "in", 3: "in", 4: "mm", 5: "in", 6: "mm"}


@pytest.fixture(params=SCHEMAS)
def unit(request):
    before = FreeCAD.Units.getSchema()
    FreeCAD.Units.setSchema(request.param)
    yield SCHEMAS[request.param]
    FreeCAD.Units.setSchema(before)


@pytest.fixture
def dome(doc):
    part = doc.addObject("Part::Sphere", "Dome")
    part.Radius, part.Angle1 = 20, 0
    doc.recompute()
    return part


def test_a_finding_in_german_and_in_every_schema(german, unit):
    said = say("The cutter goes {depth} too deep into the part at {at}.", depth=Length(5.08, ".4g"), at=Point((25.4, 0.0, -12.7)))
    depth, place = ("0.2 in", "(1, 0, -0.5) in") if unit == "in" else ("5.08 mm", "(25.4, 0, -12.7) mm")
    assert wording.told(said) == f"Der Fräser dringt bei {place} {depth} zu tief ins Werkstück ein."


def test_an_error_names_the_field_as_the_window_does(german):
    with pytest.raises(FiveAxisError) as caught:
        build_settings("mill", "a.stl", {"machine": "trunnion_ac", "max_tilt": 400.0})
    said = wording.told(caught.value)
    assert said.startswith(translate(OPTIONS, Option("max_tilt").label)) and "liegt außerhalb" in said and "°" in said
    assert str(caught.value).startswith("max-tilt 400")


def test_the_document_holds_what_is_shown(german, unit, doc, dome):
    path = app.create_toolpath(doc, dome, stepover=8.0, tolerance=0.05)
    doc.recompute()
    head = path.Verdict.split(":")[0]
    assert head in {translate(CONTEXT, text) for text in ("SAFE", "CHECK", "NOT SAFE")} - {"SAFE", "CHECK", "NOT SAFE"}
    assert path.Findings
    other = r"\d mm" if unit == "in" else r"\d in[,.;:)]"  # "in" is a word in German, too
    assert not [text for text in (*path.Findings, path.Verdict) if re.search(other, text)]


def test_a_label_of_the_view(unit):
    text = gouge_words.label_text(gouge_words.OVERCUT, 0.254)
    assert text == ("0.01 in too deep" if unit == "in" else "0.254 mm too deep")
