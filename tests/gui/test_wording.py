# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core says reaches the user in German and in inches: findings, errors, the verdict in the document
and in the panel."""

import re

import FreeCAD
import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app import wording
from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.base.sentences import CONTEXT, Choice, Length, Option, Point, Task, say
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.gui.qt import translate
from freecad_fiveaxis.gui.scene import gouge_words

SCHEMAS = {0: "mm", 1: "mm", 2: "in", 3: "in", 4: "mm", 5: "in", 6: "mm"}


@pytest.fixture(params=SCHEMAS)
def unit(request):
    before = FreeCAD.Units.getSchema()
    FreeCAD.Units.setSchema(request.param)
    if hasattr(
        FreeCAD.ActiveDocument, "UnitSystem"
    ):  # from 1.0 on a document has units of its own, which win over the user's
        document = FreeCAD.ActiveDocument
        document.UnitSystem = document.getEnumerationsOfProperty("UnitSystem")[request.param]
    yield SCHEMAS[request.param]
    FreeCAD.Units.setSchema(before)


def test_a_finding_in_german_and_in_every_schema(german, unit):
    message = say(
        "The cutter goes {depth} too deep into the part at {at}.",
        depth=Length(5.08, ".4g"),
        at=Point((25.4, 0.0, -12.7)),
    )
    depth, place = ("0.2 in", "(1, 0, -0.5) in") if unit == "in" else ("5.08 mm", "(25.4, 0, -12.7) mm")
    assert wording.localize(message) == f"Der Fräser dringt bei {place} {depth} zu tief ins Werkstück ein."


def test_an_error_names_the_field_as_the_window_does(german):
    with pytest.raises(FiveAxisError) as caught:
        build_settings("mill", "a.stl", {"machine": "trunnion_ac", "max_tilt": 400.0})
    message = wording.localize(caught.value)
    assert (
        message.startswith(translate("FiveAxis", "Largest axis angle"))
        and "liegt außerhalb" in message
        and "°" in message
    )
    assert str(caught.value).startswith("max-tilt 400")


NAMED = [
    (Choice("gouge", ("lift", "leave-out")), "Gouge protection: lift the tool, skip these places",
     "Eindringschutz: Werkzeug abheben, Stellen auslassen"),
    (Choice("linearize", ("on",)), "Divide blocks: on", "Sätze teilen: ein"),
    (Choice("cures", ("deform",), alone=True), "turn the axis past the pole", "Achse am Pol vorbeidrehen"),
    (Option("spindle", given="S"), "Spindle speed", "Drehzahl"),
    (Task("setup"), "“Where to clamp”", "„Wohin spannen“"),
]  # fmt: skip
"""What a sentence names, and what the window calls it in English and in German."""


def test_settings_choices_and_tasks_are_named_as_in_the_window():
    for named, english, _ in NAMED:
        assert wording.localize(say("{named}", named=named)) == english != str(named)


def test_settings_choices_and_tasks_are_named_as_in_the_german_window(german):
    for named, _, reported in NAMED:
        assert wording.localize(say("{named}", named=named)) == reported


def test_the_document_holds_what_is_shown(german, doc, dome, unit):
    path = app.create_toolpath(doc, dome, passes="planes", stepover=8.0, tolerance=0.05)
    doc.recompute()
    head = path.Verdict.split(":")[0]
    assert head in {translate(CONTEXT, text) for text in ("SAFE", "CHECK", "NOT SAFE")} - {
        "SAFE",
        "CHECK",
        "NOT SAFE",
    }
    assert path.Findings
    other = r"\d mm" if unit == "in" else r"\d in[,.;:)]"  # "in" is a word in German, too
    assert not [text for text in (*path.Findings, path.Verdict) if re.search(other, text)]


def test_a_label_of_the_view(unit):
    text = gouge_words.label_text(gouge_words.OVERCUT, 0.254)
    assert text == ("0.01 in too deep" if unit == "in" else "0.254 mm too deep")


@pytest.mark.parametrize(
    ("lean", "words"), [(0.0, "keeps its direction"), (0.25, "to lean the tool by 0.25")]
)
def test_a_tool_that_only_turns_at_the_pole_is_not_stated_to_lean_by_nothing(lean, words):
    from freecad_fiveaxis.core.report.drawing import Spot
    from freecad_fiveaxis.gui.scene.words import explain

    spot = Spot(3, 12, 0.001, 0.002, 0.01, True, (("C", 90.0), ("A", lean)), lean, 1.0, (0.0, 0.0, 0.0))
    what = explain("singular-block", spot)[0]
    assert words in what and "by 0°" not in what and "C turns 90" in what, what
