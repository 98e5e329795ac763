# SPDX-License-Identifier: LGPL-2.1-or-later
"""A window writes numbers as its fields do, with the decimal sign of the system; reports keep the point."""

import pytest
from conftest import QtCore

from freecad_fiveaxis.app import units, wording
from freecad_fiveaxis.core.base.sentences import Area, Length, Number, Point, say
from freecad_fiveaxis.gui.panels.measure_box import MeasureBox
from freecad_fiveaxis.gui.play.readout import joint_text


@pytest.fixture(params=["de_DE", "en_US"])
def sign(request, window):
    """The decimal sign of a system."""
    before = QtCore.QLocale()
    QtCore.QLocale.setDefault(QtCore.QLocale(request.param))
    yield "," if request.param == "de_DE" else "."
    QtCore.QLocale.setDefault(before)


def test_texts_have_the_sign_of_the_fields(sign):
    box = MeasureBox("length")
    box.show_measured(0.0447)
    assert box.text() == f"0{sign}0447 mm" == units.length_text(0.0447)
    assert units.area_text(451.887, 6) == f"451{sign}887 mm²"
    assert units.angle_text(27.42) == f"27{sign}42°" and joint_text(-0.7615, False) == f"-0{sign}7615 mm"
    text = say("{a} of {b}: {c} in a.5.stl", a=Length(1.5), b=Area(2.25), c=Number(0.5))
    assert wording.localize(text) == f"1{sign}5 mm of 2{sign}25 mm²: 0{sign}5 in a.5.stl"
    assert text == "1.5 mm of 2.25 mm2: 0.5 in a.5.stl", "as reports have it"
    between = "; " if sign == "," else ", "
    point = between.join(f"{one}{sign}5" for one in (1, 2, 3))
    assert wording.localize(say("{p}", p=Point((1.5, 2.5, 3.5)))) == f"({point}) mm"
