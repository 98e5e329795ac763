# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sentence is today's English to everyone, and says itself again in another language and in other units."""

import copy
import json
import pickle

import numpy as np
import pytest

from freecad_fiveaxis.core.base.errors import Cancelled, FileError, FiveAxisError, MachineError
from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.base.sentences import (
    CONTEXT,
    IN_FULL,
    Angle,
    Area,
    Choice,
    Feed,
    Length,
    Number,
    Option,
    Sentence,
    Task,
    Template,
    Time,
    beginning,
    join_sentences,
    measure,
    plural,
    render,
    say,
)

GERMAN = {
    "The tool enters the part by {depth} at {count} places.": "An {count} Stellen dringt das Werkzeug {depth} ein.",
    "{count} block leaves": "{count} Satz verlässt",
    "{count} blocks leave": "{count} Sätze verlassen",
    "Split it.": "Teilen Sie ihn.",
    "{file}: {reason}": "{file} – {reason}",
    "no axes": "keine Achsen",
}


def german(context, text):
    return GERMAN[text] if context != "none" else text


def inches(measure):
    return measure.between.join(f"{value / 25.4:.5f}" for value in measure.values) + " in"


def test_it_is_a_plain_str_in_mm():
    message = say("The tool enters the part by {depth} at {count} places.", depth=Length(5.0), count=203)
    assert message == "The tool enters the part by 5 mm at 203 places." and isinstance(message, str)
    assert json.loads(json.dumps({"text": message})) == {"text": str(message)} and type(str(message)) is str


def test_it_is_stated_again_in_german_and_inches():
    message = say("The tool enters the part by {depth} at {count} places.", depth=Length(5.0), count=203)
    assert render(message, german, inches) == "An 203 Stellen dringt das Werkzeug 0.19685 in ein."


def test_any_other_text_comes_back():
    assert render("{not} a template", german, inches) == "{not} a template"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (Length(2.12642, ".4g"), "2.126 mm"),
        (Length(0.5, ".6f", bare=True), "0.500000"),
        (Area(12.5), "12.5 mm2"),
        (Length((1.0, 2.5, -3.0)), "1, 2.5, -3 mm"),
        (Angle(27.416, ".3g"), "27.4 deg"),
        (Feed(1000.0), "1000 mm/min"),
        (Time(2.5, ".1f"), "2.5 s"),
        (Number(1e6, ".0f"), "1000000"),
        (np.float64(0.25), "0.25"),
        (np.int64(7), "7"),
        (Option("max_axis_angle"), "--max-axis-angle"),
        (Option("spindle", given="S"), "--spindle S"),
        (Choice("gouge", ("lift", "leave-out")), "gouge lift, leave-out"),
        (Choice("linearize", ("on",), flag=True), "--linearize on"),
        (Choice("cures", ("deform",), alone=True), "deform"),
        (Task("setup"), "`setup`"),
        ("{name}", "{name}"),
        (measure(3.0, "mm2"), "3 mm2"),
        (measure(3.0, "1"), "3"),
    ],
)
def test_values_in_english(value, text):
    assert say("a {value} b", value=value) == f"a {text} b"


NAMES = {
    Option("max_axis_angle"): "Steepest surface",
    Choice("gouge", ("lift",)): "Gouge: lift",
    Task("post"): "Post-process",
}


@pytest.mark.parametrize("named", NAMES)
def test_settings_choices_and_tasks_have_names_of_their_own_in_a_window(named):
    message = beginning(join_sentences([say("Split it."), say("{named}", named=named)]))
    assert render(message, lambda _, text: text, inches, NAMES.__getitem__) == f"Split it. {NAMES[named]}"


@pytest.mark.parametrize(
    ("count", "text", "reported"),
    [(1, "1 block leaves", "1 Satz verlässt"), (3, "3 blocks leave", "3 Sätze verlassen")],
)
def test_one_and_many(count, text, reported):
    message = plural(count, "{count} block leaves", "{count} blocks leave")
    assert message == text and render(message, german, inches) == reported


def test_joined_and_added_sentences_are_translated_one_by_one():
    message = (
        join_sentences([say("Split it."), "", plural(1, "{count} block leaves", "{count} blocks leave")])
        + ": {C}"
    )
    assert message == "Split it. 1 block leaves: {C}"
    assert render(message, german, inches) == "Teilen Sie ihn. 1 Satz verlässt: {C}"
    assert render("X: " + say("Split it."), german, inches) == "X: Teilen Sie ihn."


def test_nested_sentences_and_errors():
    inner = MachineError(say("no axes"), 0)
    outer = MachineError(say("{file}: {reason}", file="a.fcm", reason=inner), inner.value)
    assert str(outer) == "a.fcm: no axes" and type(str(outer)) is str
    assert render(outer.text, german, inches) == "a.fcm – keine Achsen"
    assert say("{reason}", reason=OSError("denied")) == "denied"


def test_templates_of_tables():
    assert Template("{count} blocks leave").say(count=2) == "2 blocks leave"


@pytest.mark.parametrize("kind", [FiveAxisError, FileError, Cancelled])
@pytest.mark.parametrize("again", [lambda one: pickle.loads(pickle.dumps(one)), copy.deepcopy])
def test_errors_keep_their_sentence_through_processes(kind, again):
    back = again(kind(say("{file}: {reason}", file="a", reason=say("no axes")), 3))
    assert type(back) is kind and str(back) == "a: no axes" and back.value == 3
    assert render(back.text, german, inches) == "a – keine Achsen"


@pytest.mark.parametrize("again", [lambda one: pickle.loads(pickle.dumps(one)), copy.deepcopy, copy.copy])
def test_findings_keep_theirs(again):
    text = say("The tool enters the part by {depth} at {count} places.", depth=Length(5.0), count=203)
    back = again(Finding(Severity.ERROR, "overcut", text))
    assert isinstance(back.text, Sentence) and back.text == text
    assert render(back.text, german, inches) == render(text, german, inches)


def test_the_context_is_requested():
    wanted = []
    render(say("Split it."), lambda context, text: wanted.append(context) or text, inches)
    assert wanted == [CONTEXT]


@pytest.mark.parametrize(
    ("value", "text"), [(1e-6, "0.000001 mm"), (1e6, "1000000 mm"), (0.01, "0.01 mm"), (89.99999999, "90 mm")]
)
def test_a_bound_is_written_without_an_exponent(value, text):
    assert str(Length(value, IN_FULL)) == text and str(Number(value, IN_FULL)) + " mm" == text
