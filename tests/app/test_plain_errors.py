# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors of a recompute: those that were foreseen are printed without a trace, and nothing else changes for
anybody."""

import gc
import sys
import traceback

import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app.plain_errors import hide_trace
from freecad_fiveaxis.app.selection import SelectionError
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import Option, say


class Failing:
    """A proxy whose recompute fails."""

    def __init__(self, error):
        self.error = error

    @hide_trace
    def execute(self, obj):
        raise self.error


def printed(error):
    """What Python prints of the error that ``execute`` raises."""
    try:
        Failing(error).execute(None)
    except Exception:
        return traceback.format_exc()


def test_a_foreseen_error_has_no_trace_and_one_that_nobody_foresaw_keeps_it():
    assert "in execute" not in printed(SelectionError("The part was deleted.", 7))
    assert "in execute" in printed(ZeroDivisionError("by nought"))


def test_the_error_is_the_same_in_kind_in_words_and_in_value():
    with pytest.raises(SelectionError, match="was deleted") as reported:
        Failing(SelectionError("The part was deleted.", 7)).execute(None)
    assert reported.value.value == 7 and reported.value.text == "The part was deleted."


def test_it_names_the_field_and_not_the_option_of_the_command_line():
    error = SettingsError(say("the head turns: give {option}", option=Option("tool_length")), 0.0)
    assert "give --tool-length" in str(error)
    assert "the head turns: give Tool length" in printed(error)


@pytest.mark.parametrize("before", [None, 5])
def test_python_s_traces_are_as_before_once_the_error_is_gone(before, monkeypatch):
    gc.collect()  # what the test before has caught
    if before is not None:
        monkeypatch.setattr(sys, "tracebacklimit", before, raising=False)
    for _ in range(2):
        printed(SelectionError("gone"))
        assert getattr(sys, "tracebacklimit", None) == before


def test_freecad_s_recompute_lets_the_error_go(doc):
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    mesh = app.tessellate(box)
    doc.removeObject(box.Name)
    doc.recompute()
    assert "Invalid" in mesh.State and "The part was deleted" in mesh.getStatusString()
    assert not hasattr(sys, "tracebacklimit")
