# SPDX-License-Identifier: LGPL-2.1-or-later
"""What would finish more of a path's part: tried on the part, faces and fixtures of the document, which stays
as it is."""

from dataclasses import replace

import Part
import pytest
from conftest import FAST, UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app import advising, results
from freecad_fiveaxis.app.selection import SelectionError
from freecad_fiveaxis.core.pipeline import advice


def test_it_is_what_the_path_of_these_settings_finishes_more_and_the_document_stays(doc, monkeypatch):
    monkeypatch.setattr(advice, "SMALLER", ())
    block = doc.addObject("Part::Feature", "Block")
    block.Shape = Part.makeBox(24, 16, 10)
    doc.recompute()
    given = {
        **FAST,
        **UNCURED,
        "cutter": "ball:6",
        "tool_axis": "facet_mean",
        "max_axis_angle": 90,
        "rest": "on",
    }
    given |= {"stepover": None, "scallop": 0.5}
    path = app.create_toolpath(doc, block, **{**given, "passes": "planes"})
    names, nc = [one.Name for one in doc.Objects], results.nc_of(path)
    figures = results.figures_of(path)
    assert advising.leaves_something(figures) is True  # FreeCAD 1.1's Qt takes no numpy.bool
    assert advising.leaves_something(replace(figures, unfinished=0.0)) is False
    trials = app.advise(path)
    assert (
        [one.Name for one in doc.Objects] == names
        and results.nc_of(path) == nc
        and not results.out_of_date(path)
    )
    best = next(one for one in trials if list(one.changes) == ["passes", "plane_normal", "direction"])
    other = app.create_toolpath(doc, block, **{**given, "passes": "scallop"})
    finished = [advice.measure_finished(results.result_of(one)) for one in (path, other)]
    assert best.gain == pytest.approx(finished[1] - finished[0], rel=1e-6, abs=1e-6) and best.gain > 300
    assert "would finish" in advising.tell_advice(path, trials)
    with pytest.raises(SelectionError, match="Block is no tool path"):
        app.advise(block)
