# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where to clamp and what to compare and where the tool gets, whoever makes the trials: the same bytes, and a stop that is heard in the middle."""

import json
import multiprocessing
import pickle
import sys

import pytest
from roofs import Inline, Swapping, write_roof
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base import crew, workers
from freecad_fiveaxis.core.base.errors import Cancelled, SettingsError
from freecad_fiveaxis.core.jobs.settings import TRIALS, build_settings
from freecad_fiveaxis.core.studies import study

WAY = {"machine": "trunnion_ac", "passes": "planes", "tool_axis": "facet_mean", "stepover": 9}
SETUP = {"grid": "3,2,1", "turns": 2, "region": "40,30,0", "origin": "10,5,-20"}
STUDIES = {
    "setup": WAY | SETUP,
    "compare": WAY | {"stepover": 12, "machine": None, "machines": "mikron_ucp710,trunnion_ac", "max_axis_angle": 20},
    "reach": {"machine": "trunnion_ac", "cutter": "ball:6:12", "holder": "30x20", "face": None},
    "setup of little reach": WAY | SETUP | {"machine": "mikron_ucp710", "turns": 1, "region": "400,400,300", "grid": "2,2,2"},
}
STAGES = {"setup": "setup map", "compare": "compare", "reach": "reach"}
"""What progress calls the trials."""


@pytest.fixture(scope="module")
def roof(tmp_path_factory):
    path = tmp_path_factory.mktemp("roof") / "roof.stl"
    write_roof(path)
    return str(path)


def try_study(name, roof, executor=None, progress=lambda stage, fraction: None):
    return study.run(build_settings(name.split()[0], roof, options_of(name)), progress, executor)


def options_of(name):
    return {key: value for key, value in STUDIES[name].items() if value is not None}


def bytes_of(trial):
    return study.as_json(trial), study.as_html(trial), study.as_text(trial)


DEAR = ("compare", "reach")


@pytest.fixture(scope="module", params=[pytest.param(name, marks=[pytest.mark.thorough] * (name in DEAR)) for name in STUDIES])
def expected(request, roof):
    """A study's name and what it tells without an executor."""
    return request.param, bytes_of(try_study(request.param, roof))


@pytest.fixture(scope="module")
def processes():
    with crew.at_work(crew.process_crew(2)) as pool:
        yield pool


def test_threads_make_the_same_bytes(expected, roof):
    with crew.at_work(crew.thread_crew(2)) as pool:
        assert bytes_of(try_study(expected[0], roof, pool)) == expected[1]


def test_processes_make_the_same_bytes(expected, roof, processes):
    told = []
    made = try_study(expected[0], roof, processes, lambda stage, fraction: told.append((stage, fraction)))
    assert bytes_of(made) == expected[1] and told[-1][1] == 1.0


def test_plain_processes_make_the_same_bytes(expected, roof):
    """Those of FreeCAD's window: some trials are done here, the others by a Python that was started beside this one."""
    with workers.WorkerProcesses(lambda: workers.Command((sys.executable, "-c", workers.python_code("serve"))), 2, 0.0) as pool:
        assert bytes_of(try_study(expected[0], roof, pool)) == expected[1] and pool.died == 0


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


def test_a_result_of_another_task_is_noticed(expected, roof):
    with pytest.raises(SettingsError, match="gave back"):
        try_study(expected[0], roof, Swapping())


def test_a_stop_in_the_middle_leaves_no_process(expected, roof):
    before = set(multiprocessing.active_children())

    def stop(stage, fraction):
        if stage == STAGES[expected[0].split()[0]] and fraction > 0.0:
            raise Cancelled("enough")

    with pytest.raises(Cancelled, match="enough"), crew.at_work(crew.process_crew(1)) as pool:
        try_study(expected[0], roof, pool, stop)
    assert set(multiprocessing.active_children()) <= before


def words_of(name, roof):
    options = (word for key, value in options_of(name).items() for word in (f"--{key.replace('_', '-')}", str(value)))
    return [name, roof, *options, "--quiet"]


@some_in_core("name", TRIALS)
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
    told = capsys.readouterr().err
    assert told.count("\n") == 1 and "--workers" in told and "whole number" in told
