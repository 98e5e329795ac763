# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every cell of a comparison against ``mill`` with the cure's options on the row's machine, the defaults of both
and none of ours: its deviation, time and length, and what of the tool goes into the part."""

import json

import numpy as np
import pytest
from setup_examples import cap
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.motion.program import feed_blocks
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report import summary
from freecad_fiveaxis.core.studies import as_milled
from freecad_fiveaxis.core.studies.compare import (
    compare_html,
    compare_json,
    compare_text,
    say_unchecked,
    verdict,
)
from freecad_fiveaxis.core.studies.compare.beside_part import enters_part
from freecad_fiveaxis.core.studies.corrections import CURES
from freecad_fiveaxis.core.studies.study import as_text, try_machines

pytestmark = pytest.mark.usefixtures("fields_kept")

CAP = cap(rings=6, sectors=18)
OPTIONS = {
    "none": {}, "linearize": {"linearize": "on"}, "minimax": {"tool_axis": "minimax"},
    "auto": {"tool_axis": "auto"}, "deform": {"singularity": "deform"},
}  # fmt: skip
"""What makes ``mill`` do what a cure of the table does."""
GIVEN = {"stepover": 20.0, "cutter": "ball:12", "tool_length": 120.0}


def valley(depth=12.0, wide=6.0, long=30.0):
    """A V along Y, too narrow for a ball of 10 mm with the tool on the facets' normals: open, two facets a side."""
    low, sides = (0.0, 0.0, -depth), []
    for x in (-wide, wide):
        a, b = (x, 0.0, 0.0), (x, long, 0.0)
        c, d = low, (0.0, long, -depth)
        sides += [[a, c, b], [b, c, d]] if x < 0 else [[c, a, d], [d, a, b]]
    return from_triangles(np.array(sides, dtype=float))


VALLEY = valley()
NARROW = {
    "cutter": "ball:10",
    "stepover": 2.0,
    "passes": "planes",
    "direction": 90.0,
    "tool_axis": "facet_mean",
}


def compared(mesh, cures, machines="trunnion_ac", **options):
    settings = build_settings("compare", "part.stl", {"machines": machines, "cures": cures, **options})
    return try_machines(settings, mesh=mesh)


def milled(mesh, machine="trunnion_ac", **options):
    settings = build_settings("mill", "part.stl", {"machine": machine, "linearize": "off", **options})
    return job.prove(job.make(settings, mesh=mesh))


def fed_length(program, joints):
    steps = np.linalg.norm(np.diff(joints.path.tip[program.row], axis=0), axis=1)
    return steps[feed_blocks(program) - 1].sum()


def cell_of(row):
    return [row.deviation, row.bound, row.blocks, row.time, row.length]


def cell_of_mill(result):
    numbers, draft = summary(job.figures(result)), result.draft
    deviations = [numbers["max_surface_deviation"], numbers["max_surface_bound"]]
    return [*deviations, numbers["blocks"], numbers["time_s"], fed_length(draft.program, draft.joints)]


def entries(findings):
    return sorted(
        (one.code, one.value)
        for one in findings or ()
        if one.code in (Code.OVERCUT, Code.RAPID_COLLISION, Code.HOLDER_COLLISION, Code.BURIED)
    )


@some_in_core(
    ("cure", "gouge"), [(cure, gouge) for gouge in ("lift", "off") for cure in OPTIONS], kept=range(6)
)
def test_each_cure_is_what_mill_makes_with_its_option(cure, gouge):
    more = {} if gouge == "lift" else {"gouge": gouge}
    row = compared(CAP, cure, **GIVEN, **more).rows[0]
    result = milled(CAP, **GIVEN, **OPTIONS[cure], **more)
    assert not row.problem and cell_of(row) == pytest.approx(cell_of_mill(result), rel=1e-12)
    if gouge == "lift":
        assert entries(row.part) == entries(result.findings)
    else:
        assert row.part is None


def test_all_cures_of_the_table_are_tried_here_and_differ():
    assert set(OPTIONS) == set(CURES)
    rows = compared(CAP, "none,linearize,minimax", **GIVEN).rows[::2]
    assert len({row.deviation for row in rows}) == 3


@pytest.mark.thorough
@pytest.mark.oldest
def test_each_machine_gets_the_program_that_mill_makes_for_it():
    names = ("trunnion_ac", "head_b_table_c")
    rows = compared(CAP, "none,linearize", ",".join(names), **GIVEN).rows[::2]
    for row, (name, linearize) in zip(rows, [(n, one) for n in names for one in ("off", "on")], strict=True):
        result = milled(CAP, name, **{**GIVEN, "linearize": linearize})
        assert row.machine == name and cell_of(row) == pytest.approx(cell_of_mill(result), rel=1e-12)


def test_a_guided_row_goes_as_far_as_mill_with_rtcp():
    row = compared(VALLEY, "none", **NARROW).rows[1]
    draft = milled(VALLEY, **NARROW, rtcp="angles", controller="heidenhain").draft
    assert row.tool_centre and row.length == pytest.approx(fed_length(draft.program, draft.joints), rel=1e-12)
    assert row.time == pytest.approx(draft.program.seconds.sum(), rel=1e-3)


def test_by_default_the_path_is_lifted_out_of_the_part_as_by_mill():
    found = compared(VALLEY, "linearize", **NARROW)
    result = milled(VALLEY, **{**NARROW, "linearize": "on"})
    assert found.settings.gouge.gouge == "lift" and cell_of(found.rows[0]) == cell_of_mill(result)
    assert [row.part for row in found.rows] == [(), ()] and found.findings == ()
    assert verdict(found.rows, 0.01).startswith("2 of 2 ways hold 0.01 mm")
    assert compare_text(found.rows, 0.01).count(" free\n") == 2 and say_unchecked(found.rows) is None


def test_what_goes_into_the_part_does_not_hold_and_is_not_the_quickest():
    found = compared(VALLEY, "linearize", gouge="report", **NARROW)
    result = milled(VALLEY, gouge="report", **{**NARROW, "linearize": "on"})
    assert all(enters_part(row.part) for row in found.rows)
    assert entries(found.rows[0].part) == entries(result.findings) and found.rows[0].bound <= 0.01
    text, record = as_text(found), json.loads(compare_json(found.rows))
    assert "Nothing here holds 0.01 mm" in text and "quickest" not in text
    assert "In 2 of 2 ways the tool goes into the part." in text and text.count("mm deep") == 2
    assert "mm deep" in compare_html(found.rows, "", 0.01) and "quickest" not in compare_html(
        found.rows, "", 0.01
    )
    assert all(row["part_checked"] and row["part"] for row in record["rows"])
    (deepest,) = found.findings
    assert deepest.severity is Severity.ERROR and deepest.code == Code.OVERCUT


def test_text_page_and_record_say_what_is_not_checked():
    found = compared(VALLEY, "linearize", gouge="off", **NARROW)
    words = "In 2 of 2 ways it is not checked whether the tool goes into the part."
    assert words in as_text(found) and as_text(found).count("not checked\n") == 2
    assert words in compare_html(found.rows, "", 0.01)
    assert [row["part_checked"] for row in json.loads(compare_json(found.rows))["rows"]] == [False, False]


def test_cures_and_machines_that_have_stages_in_common_do_these_once(monkeypatch):
    ran = []
    whole = as_milled.run_stages
    monkeypatch.setattr(as_milled, "run_stages", lambda *given: ran.append(given[0]) or whole(*given))
    passes, axes = as_milled.TO_AXES[:2], as_milled.TO_AXES[2:]
    compared(CAP, "none,linearize,deform", **GIVEN)
    assert axes not in ran and passes not in ran, "those of the draft are taken"
    ran.clear()
    compared(CAP, "none,linearize,deform", "trunnion_ac,trunnion_bc", **{**GIVEN, "tool_axis": "facet_mean"})
    assert ran.count(axes) == 1 and passes not in ran, "the other machine has the same passes"


def test_a_machine_named_twice_is_one_line_before_the_work(tmp_path, capsys):
    with pytest.raises(SettingsError, match="'trunnion_ac' is named twice in --machines; name it once"):
        build_settings("compare", "part.stl", {"machines": "trunnion_ac,trunnion_bc,trunnion_ac"})
    write_stl(CAP, tmp_path / "part.stl")
    words = ["compare", str(tmp_path / "part.stl"), "--machine", "trunnion_ac", "--machine", "trunnion_ac"]
    assert cli.main(words) == cli.UNUSABLE
    (line,) = capsys.readouterr().err.strip().splitlines()
    assert "named twice" in line
