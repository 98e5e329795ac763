# SPDX-License-Identifier: LGPL-2.1-or-later
"""Setups and fixtures that macros give: a single object stands for a list, and what is neither is refused with
the document as it was."""

import pytest
from conftest import FAST, UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app.selection import SelectionError
from freecad_fiveaxis.core.base.errors import FiveAxisError, SettingsError

pytestmark = pytest.mark.usefixtures("kept")
GIVEN = {**FAST, **UNCURED}


@pytest.fixture
def given(doc, tmp_path):
    """A part, what holds it, a path and a program."""
    for name, x in (("Part", 0), ("Vise", 60)):
        box = doc.addObject("Part::Box", name)
        box.Height, box.Placement.Base.x = 4, x
    doc.recompute()
    path = app.create_toolpath(doc, doc.Part, setup=None, **GIVEN)
    (tmp_path / "a.ngc").write_text("G21 G90 G94\nG1 X0 Y0 Z50 A0 C0 F500\nG1 X9\nM2\n")
    return path, str(tmp_path / "a.ngc")


def calls(doc, given):
    """Every function that takes fixtures, as a function of them."""
    path, nc = given
    return {
        "create_toolpath": lambda held: app.create_toolpath(doc, doc.Part, fixtures=held, **GIVEN).Fixtures,
        "preview_passes": lambda held: app.preview_passes(path, fixtures=held) and [doc.Vise],
        "compare": lambda held: app.compare(path, "trunnion_ac", "none", fixtures=held) and [doc.Vise],
        "setup_map": lambda held: (
            app.setup_map(path, region=(20, 20, 0), grid=(3, 3, 1), fixtures=held).Path.Fixtures
        ),
        "reach_map": lambda held: app.reach_map(doc.Part, fixtures=held, linear_deflection=1).Fixtures,
        "audit": lambda held: app.audit(doc, nc, "trunnion_ac", fixtures=held).Fixtures,
    }


NAMES = ("create_toolpath", "preview_passes", "compare", "setup_map", "reach_map", "audit")


@pytest.mark.parametrize("name", NAMES)
def test_one_fixture_stands_for_a_list_of_one(doc, given, name):
    call = calls(doc, given)[name]
    assert call(doc.Vise) == [doc.Vise] == call((doc.Vise,))


@pytest.mark.parametrize("name", NAMES)
def test_what_is_no_fixture_is_refused(doc, given, name):
    note, call = doc.addObject("App::FeaturePython", "Note"), calls(doc, given)[name]
    before = [one.Name for one in doc.Objects]
    for wrong in (3, "Vise", note, [None], ["Vise"], [doc.Vise, 3], doc, {"a": 1}):
        with pytest.raises(SelectionError):
            call(wrong)
    assert [one.Name for one in doc.Objects] == before and not given[0].Fixtures


def test_what_is_no_setup_is_refused(doc, given):
    before = [one.Name for one in doc.Objects]
    for wrong in (doc.Part, given[0], 3, "Setup", doc):
        with pytest.raises(SelectionError, match="a setup"):
            app.create_toolpath(doc, doc.Part, setup=wrong, **GIVEN)
        with pytest.raises(SelectionError, match="a setup"):
            app.preview_passes(given[0], setup=wrong)
        with pytest.raises(SelectionError, match="a setup"):
            app.preview_passes(doc.Part, setup=wrong, **GIVEN)
    assert [one.Name for one in doc.Objects] == before


WRONG = [
    {"work_zero": "a"}, {"work_zero": 5}, {"work_zero": (1, 2)}, {"work_zero": (1, 2, "x")}, {"scallop": 1}, {"feed": 5},
    {"scalop": 1}, {"tools": 3}, {"tools": [3]},
    {"work_offset": "G99"}, {"work_offset": "G59.1", "controller": "fanuc"}, {"machine": 5}, {"controller": "x"},
]  # fmt: skip


@pytest.mark.parametrize("wrong", WRONG, ids=str)
def test_a_setup_of_values_that_cannot_be_used_is_refused(doc, wrong):
    with pytest.raises(FiveAxisError) as caught:
        app.create_setup(doc, **wrong)
    assert len(str(caught.value).splitlines()) == 1 and doc.Objects == []


def test_the_reach_map_wants_three_numbers_of_a_work_zero_too(doc, given):
    with pytest.raises(SettingsError, match="needs three numbers"):
        app.reach_map(doc.Part, work_zero=5)


def test_a_single_line_is_one_tool_and_a_zero_may_be_a_text(doc):
    setup = app.create_setup(doc, tools="T3 ball:6:30 name", work_zero="1,2,3", work_offset="G55")
    assert setup.Tools == ["T3 ball:6:30 name"] and tuple(setup.WorkZero) == (1, 2, 3)
    assert app.create_setup(doc, tools=["T1 ball:6", "T2 flat:8 End mill"]).Tools[1] == "T2 flat:8 End mill"
