# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every panel is as narrow as FreeCAD's task panel gets, in both languages: no text, button or field of it
stands outside the dock."""

import FreeCAD
import FreeCADGui
import pytest
from conftest import QtWidgets
from test_workshop import cut

from freecad_fiveaxis import app
from freecad_fiveaxis.gui import play
from freecad_fiveaxis.gui.panels import (
    audit,
    compare,
    import_machine,
    machine_editor,
    post,
    prove_signs,
    reach,
    recover,
    setup,
    toolpath,
)
from freecad_fiveaxis.gui.panels.wrapping import find_lines

ROOM = 232 if int(FreeCAD.Version()[0]) < 1 else 300
"""Pixels within FreeCAD 0.20's task panel as it stands at first in a window of 1280 by 800; 1.1's, whose boxes
are wider, leaves 300 of 330."""
OPTIONS = {"machine": "trunnion_ac", "cutter": "ball:6:30", "stepover": 8.0, "linear_deflection": 0.3,
           "angular_deflection": 30.0, "gouge": "off", "linearize": "off"}  # fmt: skip


@pytest.fixture(autouse=True)
def _fresh(parameters):
    """Nobody has folded anything yet."""
    parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis").Clear()


@pytest.fixture(params=["English", "German"])
def language(request, window):
    """The window in one language after the other."""
    FreeCADGui.setLocale(request.param)
    yield request.param
    FreeCADGui.setLocale("English")


def open_player(path):
    """The panel that plays a path."""
    play.show(path)
    return play.panel.current()


OPENED = {
    "toolpath": toolpath.create,
    "audit": lambda dome: audit.create(dome.Document),
    "recover": lambda dome: recover.create(),
    "prove_signs": lambda dome: prove_signs.create(),
    "import_machine": lambda dome: import_machine.create(),
    "machine_editor": lambda dome: machine_editor.create(),
    "setup": setup.create_over,
    "reach": reach.create,
}
OF_PATH = {
    "calculated": toolpath.edit,
    "compare": compare.create,
    "post": post.write,
    "play": open_player,
}


def outside(form):
    """The widgets of a panel that are not to be seen in their whole width: what its task panel, or a box
    around them, cuts at the side. (Areas that scroll are covered by what is in them.)"""
    return [
        (type(one).__name__, one.objectName(), str(one.property("text"))[:40], one.width(), seen)
        for one in (form, *form.findChildren(QtWidgets.QWidget))
        if one.isVisible() and not isinstance(one, QtWidgets.QAbstractScrollArea)
        and 0 < (seen := one.visibleRegion().boundingRect().width()) < one.width()
    ]  # fmt: skip


def widen(opened):
    """Choose what has long names, and open all groups of a panel."""
    fields = opened.options.fields if hasattr(opened, "options") else {}
    long = {"machine": "fork_head_bc", "controller": "heidenhain_m128", "tool_axis": "minimax"}
    for choice, value in long.items():
        if choice in fields:
            fields[choice].show_value(value)
    for group in opened.options.groups.values() if fields else ():
        group.unfold()


@pytest.mark.parametrize("name", [*OPENED, *OF_PATH])
def test_every_panel_fits_the_task_panel_of_an_old_freecad(
    name, language, dome, doc, pump, until, screenshot
):
    base = app.create_toolpath(doc, dome, **OPTIONS) if name in OF_PATH else dome
    opened = (OPENED | OF_PATH)[name](base)
    pump(200)
    form = opened.form
    widen(opened)
    until(lambda: form.minimumSizeHint().width() <= ROOM, 5000, "a form as narrow as the panel")
    found = None

    def whole():
        nonlocal found
        found = outside(form), cut(form)
        return found == ([], [])

    try:
        until(whole, 10000, "nothing outside the panel")
    except TimeoutError:
        screenshot(f"narrow232_{name}_{language}")
        pytest.fail(f"outside the panel, and cut: {found}")
    assert form.width() <= form.window().width()
    screenshot(f"narrow232_{name}_{language}")
    opened.reject()
    pump(100)


def test_a_label_that_stands_outside_the_panel_would_be_noticed(dome, pump, until):
    opened = toolpath.create(dome)
    pump(300)
    assert outside(opened.form) == []
    opened.summary.setMinimumWidth(1400)
    until(lambda: outside(opened.form), 10000, "the summary outside the panel")
    opened.reject()


def test_no_line_of_the_player_lies_over_another_one(language, doc, dome, pump, until):
    opened = open_player(app.create_toolpath(doc, dome, **OPTIONS))
    opened.step(opened.player.go_to_worst)
    pump(300)
    labels = [one for one in opened.form.findChildren(QtWidgets.QLabel) if one.isVisible() and one.text()]
    assert len(labels) > 20 and all(
        one.wordWrap() for one in labels if one.objectName() in ("clock", "block")
    )

    def squeezed():
        return [
            one.text()
            for one in labels
            if one.height() < one.heightForWidth(one.width()) or one.width() < one.minimumSizeHint().width()
        ]

    until(lambda: not squeezed(), 10000, "lines as high as their texts")
    opened.reject()
    pump(100)


def test_a_title_too_long_for_the_panel_has_dots(doc, dome, pump):
    path = app.create_toolpath(doc, dome, **OPTIONS)
    path.Label = "The third path of the upper half of the housing"
    opened = post.write(path)
    pump(200)
    assert opened.form.windowTitle().endswith("…") and opened.form.windowTitle().startswith(
        "Post-process The"
    )
    assert outside(opened.form) == []
    opened.reject()


@pytest.mark.parametrize(
    ("widths", "room", "lines"),
    [
        ([50, 50, 50], 156, [0, 0, 0]),
        ([50, 50, 50], 155, [0, 0, 1]),
        ([50, 90, 20], 100, [0, 1, 2]),
        ([300, 10, 10], 100, [0, 1, 1]),
        ([], 100, []),
    ],
)
def test_buttons_stand_in_as_few_lines_as_they_need(widths, room, lines):
    assert find_lines(widths, room) == lines
