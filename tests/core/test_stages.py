# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stages of ``mill``: each takes what the one before it gives, and the page about them is made from their
list."""

import sys
import typing
from dataclasses import fields, is_dataclass
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

import pytest
from mesh_shapes import field
from plain import build_settings

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.passes import Region
from freecad_fiveaxis.core.pipeline import job, milling
from freecad_fiveaxis.core.pipeline.context import MillContext
from freecad_fiveaxis.core.pipeline.milling import STAGES
from freecad_fiveaxis.core.pipeline.programs import MilledProgram
from freecad_fiveaxis.core.pipeline.settings import MILL

ROOT = Path(__file__).parents[2]


def types_of(stage):
    """What a stage takes besides the context, and what it gives."""
    hints = typing.get_type_hints(stage)
    assert hints.pop("context") is MillContext
    gives = hints.pop("return")
    (takes,) = hints.values()
    return takes, gives


def breaks(stages):
    """Where a stage does not take what the one before it gives."""
    ends = [Region, *(types_of(stage)[1] for stage in stages)]
    return [
        stage.__name__ for stage, given in zip(stages, ends, strict=False) if types_of(stage)[0] is not given
    ]


def test_each_stage_takes_what_the_one_before_it_gives():
    assert breaks(STAGES) == [] and types_of(STAGES[-1])[1] is MilledProgram


def test_stages_in_a_wrong_order_would_be_noticed():
    assert breaks((*STAGES[:4], *STAGES[5:])) == [STAGES[5].__name__]


def test_every_record_is_whole():
    records = {types_of(stage)[1] for stage in STAGES}
    assert all(is_dataclass(record) and fields(record) for record in records)
    with pytest.raises(TypeError):
        types_of(STAGES[0])[1]()


@pytest.mark.parametrize("stage", STAGES, ids=lambda stage: stage.__name__)
def test_a_stage_says_what_it_does(stage):
    first = (stage.__doc__ or "").partition("\n\n")[0]
    assert first.endswith(".") and first[0].isupper() and not first.startswith(("The ", "A "))


def test_mill_runs_every_stage_once_in_their_order(tmp_path, monkeypatch):
    ran = []

    def spied(stage):
        def run(context, record):
            ran.append(stage.__name__)
            return stage(context, record)

        return run

    monkeypatch.setattr(milling, "STAGES", tuple(spied(stage) for stage in STAGES))
    settings = build_settings(
        MILL, "field", {"machine": "trunnion_ac", "stepover": 8, "tool_axis": "facet_mean"}
    )
    job.make(settings, mesh=from_triangles(field(12, lambda x, y: 0.02 * x * x)))
    assert ran == [stage.__name__ for stage in STAGES]


@pytest.fixture(scope="module")
def script():
    loader = SourceFileLoader("pages", str(ROOT / "scripts" / "pages"))
    module = module_from_spec(spec_from_loader("pages", loader))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "dont_write_bytecode", True)  # no cache beside the scripts
        loader.exec_module(module)
    return module


def test_the_page_lists_the_stages_as_they_are(script):
    page = (script.DOCS / "pipeline.md").read_text(encoding="utf-8")
    assert script.replace_list(page, script.stage_table(STAGES)) == page
    assert script.replace_list(page, script.stage_table(STAGES[1:])) != page
