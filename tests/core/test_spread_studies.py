# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where to clamp and what to compare and where the tool gets by workers: small tasks, a stop that is heard in
the middle, the command line."""

import json
import multiprocessing
import pickle

import pytest
from roofs import Inline, Swapping, write_roof
from small_studies import STUDIES, options_of, try_study
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base import crew
from freecad_fiveaxis.core.base.errors import Cancelled, SettingsError
from freecad_fiveaxis.core.pipeline.settings import TRIALS

STAGES = {"setup": "setup map", "compare": "compare", "reach": "reach"}
"""What progress calls the trials."""


@pytest.fixture(scope="module")
def roof(tmp_path_factory):
    path = tmp_path_factory.mktemp("roof") / "roof.stl"
    write_roof(path)
    return str(path)


class Packing(Inline):
    """Does each task from what it looks like on its way to another process."""

    def __init__(self):
        self.longest = self.count = 0

    def submit(self, work, /, *given, **named):
        packed = pickle.dumps((work, given, named))
        self.longest, self.count = max(self.longest, len(packed)), self.count + 1
        work, given, named = pickle.loads(packed)
        return super().submit(work, *given, **named)


def test_a_task_is_small_but_for_what_is_common(roof):
    packing = Packing()
    try_study("setup", roof, packing)
    assert packing.count == 1 + 2 * (2 + 1) and packing.longest < 100_000


@pytest.mark.oldest
@some_in_core("name", STUDIES)
def test_a_result_of_another_task_is_noticed(name, roof):
    with pytest.raises(SettingsError, match="gave back"):
        try_study(name, roof, Swapping())


@some_in_core("name", STUDIES)
def test_a_stop_in_the_middle_leaves_no_process(name, roof):
    before = set(multiprocessing.active_children())

    def stop(stage, fraction):
        if stage == STAGES[name.split()[0]] and fraction > 0.0:
            raise Cancelled("enough")

    with pytest.raises(Cancelled, match="enough"), crew.at_work(crew.process_crew(1)) as pool:
        try_study(name, roof, pool, stop)
    assert set(multiprocessing.active_children()) <= before


def words_of(name, roof):
    options = (
        word for key, value in options_of(name).items() for word in (f"--{key.replace('_', '-')}", str(value))
    )
    return [name, roof, *options, "--quiet"]


@pytest.mark.oldest
@pytest.mark.thorough
@pytest.mark.parametrize("name", TRIALS)
def test_the_command_line_spreads_it(name, roof, tmp_path):
    report, other = tmp_path / "one.json", tmp_path / "two.json"
    assert cli.main([*words_of(name, roof), "--report", str(report)]) == cli.main(
        [*words_of(name, roof), "--workers", "2", "--report", str(other)]
    )
    one, two = (json.loads(path.read_text().replace(str(path), "")) for path in (report, other))
    assert one == two and one["inputs"]
    assert not [child for child in multiprocessing.active_children() if child.exitcode is not None]


@pytest.mark.parametrize("name", TRIALS)
@pytest.mark.parametrize("workers", ["0", "many", "-3"])
def test_no_count_of_workers_is_one_line_and_no_work(name, workers, roof, capsys):
    assert cli.main([*words_of(name, roof), f"--workers={workers}"]) == cli.UNUSABLE
    reported = capsys.readouterr().err
    assert reported.count("\n") == 1 and "--workers" in reported and "whole number" in reported
