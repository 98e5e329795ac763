# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a stranger mistypes is refused in one line that names what was meant, and nothing is written."""

import json

import pytest
from mesh_shapes import box

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl


@pytest.fixture
def typed(tmp_path, capsys, monkeypatch):
    """typed(words): the one line on stderr of a command that is refused, beside a part."""
    write_stl(from_triangles(box((-9, -9, 0), (9, 9, 9))), tmp_path / "part.stl")
    monkeypatch.chdir(tmp_path)

    def run(*words):
        before = sorted(tmp_path.rglob("*"))
        try:
            code = cli.main(list(words))
        except SystemExit as stop:
            code = stop.code
        assert code == 2 and sorted(tmp_path.rglob("*")) == before
        (line,) = capsys.readouterr().err.splitlines()
        return line

    return run


MILL = ("mill", "part.stl", "--machine", "trunnion_ac", "-o", "o.ngc")


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        ((*MILL, "--stepovr", "3"), "did you mean --stepover?"),
        ((*MILL, "--singularity", "defrom"), "did you mean deform?"),
        (("mil", "part.stl"), "did you mean mill?"),
        (
            ("reach", "part.stl", "--machine", "trunnion_ac", "--scallop", "0.1"),
            "--scallop is for `mill`, `setup`, `compare`, `batch`; leave it out here",
        ),
        ((*MILL, "--jaw-thickness", "3"), "--jaw-thickness is for `setup`; leave it out here"),
    ],
)
def test_a_word_that_is_not_known_is_refused_in_one_line_with_what_was_meant(typed, words, meant):
    assert typed(*words).endswith(meant)


def test_a_word_that_is_near_to_none_is_named_alone(typed):
    assert typed(*MILL, "--qqqqqq").endswith("unrecognized arguments: --qqqqqq")


@pytest.mark.parametrize(
    ("job", "meant"),
    [
        ({"task": "mil", "source": "part.stl"}, "do you mean 'mill'?"),
        ({"task": "mill", "sourec": "part.stl"}, "do you mean 'source'?"),
        ({"tasak": "mill", "source": "part.stl"}, "do you mean 'task'?"),
    ],
)
def test_a_misspelt_key_or_task_of_a_job_file_is_named_with_what_was_meant(typed, tmp_path, job, meant):
    (tmp_path / "job.json").write_text(json.dumps({"machine": "trunnion_ac", "output": "o.ngc", **job}))
    assert typed("run", "job.json").endswith(meant)


@pytest.mark.parametrize(
    ("table", "meant"),
    [
        ({"parts": ["part.stl"], "option": {}}, "'option' stands there, do you mean 'options'?"),
        ({"part": ["part.stl"]}, "'part' stands there, do you mean 'parts'?"),
        ({"parts": ["part.stl"], "machine": "trunnion_ac"}, "'machine' is not known"),
        ({"parts": ["part.stl"], "options": {"machin": "trunnion_ac"}}, "do you mean 'machine'?"),
    ],
)
def test_a_misspelt_key_of_a_table_is_named_with_what_was_meant(typed, tmp_path, table, meant):
    (tmp_path / "jobs.json").write_text(json.dumps(table))
    assert typed("batch", "jobs.json", "--out", "done").endswith(meant)
