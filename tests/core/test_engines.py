# SPDX-License-Identifier: LGPL-2.1-or-later
"""Batches and studies on real engines: the same bytes from each, and a worker that is killed costs nothing
that was done.

Packages of others (loky, distributed, mpi4py) are in the slow ring; where they are not installed, their tests
are skipped.
"""

import shutil
import subprocess
import sys
import threading
from contextlib import contextmanager, nullcontext
from functools import cache
from pathlib import Path

import engines
import pytest
import roofs
from dying import die_always, die_once
from engines import mpi_environment
from roofs import (
    WAY,
    Instead,
    Kept,
    Killing,
    contents,
    jobs_of,
    work_with_blank_pages,
    write_parts,
)
from small_studies import STUDIES, texts_of, try_study
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.crew import Crew, end_pool
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.batch import crews
from freecad_fiveaxis.core.batch.run import run_batch
from freecad_fiveaxis.core.studies import study

ROOT = Path(__file__).parents[2]
KILLED = [name for name in engines.APART if name != "mpi"]
"""Engines of which one worker may be killed: MPI ends all of its processes together."""
WORDS = [word for name, value in WAY.items() for word in (f"--{name.replace('_', '-')}", str(value))]


@pytest.fixture(scope="module")
def parts(tmp_path_factory):
    """A folder with three parts, the last of which is none."""
    return write_parts(tmp_path_factory.mktemp("parts"))


def rows_of(outcomes):
    rows = [outcome.row for outcome in outcomes]
    assert sorted(row["name"] for row in rows) == ["a", "b", "c"]  # each of them once
    return {row["name"]: row for row in rows}


@pytest.fixture(scope="module")
def expected(parts, tmp_path_factory):
    """expected(blank): rows and files of one job after the other, here."""

    @cache
    def make(blank):
        out = tmp_path_factory.mktemp("expected")
        if not blank:
            return rows_of(run_batch(jobs_of(parts, out))), contents(out)
        with roofs.blank_pages():
            return rows_of(run_batch(jobs_of(parts, out))), contents(out)

    return make


@pytest.fixture(scope="module")
def reported(parts):
    """told(study): what it tells without an executor."""

    @cache
    def tell(name):
        trial = try_study(name, str(parts / "a.stl"))
        return trial, texts_of(trial)

    return tell


def test_a_batch_makes_the_same_bytes(engine, parts, expected, tmp_path):
    """Whoever does the jobs, in whatever order they are given."""
    if engine.name == "plain processes":
        pytest.skip("they load nothing of the tests, and cannot leave the pages blank")
    executor = Instead(engine.executor, work_with_blank_pages) if engine.apart else engine.executor
    with roofs.blank_pages():
        rows = rows_of(run_batch(jobs_of(parts, tmp_path / "out")[::-1], executor))
    assert (rows, contents(tmp_path / "out")) == expected(True)


@pytest.mark.thorough
def test_a_batch_makes_the_same_pages(engine, parts, expected, tmp_path):
    rows = rows_of(run_batch(jobs_of(parts, tmp_path / "out")[::-1], engine.executor))
    assert (rows, contents(tmp_path / "out")) == expected(False)
    assert expected(False)[1]["a.html"] != expected(True)[1]["a.html"]


@some_in_core("name", STUDIES)
def test_a_study_tells_the_same(name, engine, parts, reported):
    shares = []
    trial = try_study(
        name, str(parts / "a.stl"), engine.executor, lambda stage, fraction: shares.append((stage, fraction))
    )
    assert texts_of(trial) == reported(name)[1] and shares[-1][1] == 1.0


@pytest.mark.oldest
@pytest.mark.thorough
@pytest.mark.parametrize("name", STUDIES)
def test_a_page_of_a_study_is_the_same(name, processes, parts, reported):
    trial = try_study(name, str(parts / "a.stl"), processes)
    assert study.as_html(trial) == study.as_html(reported(name)[0])


@contextmanager
def mortal(name, living):
    """A crew of which workers may be killed: of dask the one that all have, as it begins another worker."""
    with nullcontext(living(name)) if name == "dask" else engines.OPEN[name]() as pool:
        yield pool


def fail_at_once(request, monkeypatch):
    """Dask gives a task up after a second death, not after a fourth: each worker that dies has another after
    it."""
    cluster = request.getfixturevalue("dask").cluster
    monkeypatch.setattr(cluster.scheduler, "allowed_failures", 1)


@pytest.mark.slow
@pytest.mark.parametrize("name", KILLED)
def test_the_jobs_of_a_killed_worker_run_again_and_none_twice(name, living, parts, expected, tmp_path):
    """The second crew is one that others have too; of dask none is ever asked for."""
    mark, again = tmp_path / "died", []

    def open_again(workers):
        again.append(workers)
        return Kept(living(name), work_with_blank_pages)

    with mortal(name, living) as pool:
        dying = Instead(pool, die_once, str(mark))
        rows = rows_of(run_batch(jobs_of(parts, tmp_path / "out"), dying, again=open_again))
    assert again == ([] if name == "dask" else [None])
    assert mark.exists() and (rows, contents(tmp_path / "out")) == expected(True)


@pytest.mark.slow
@pytest.mark.parametrize("name", KILLED)
def test_a_job_that_no_worker_survives_is_reported_and_harms_no_other_bytes(
    name, living, request, parts, expected, tmp_path, monkeypatch
):
    if name == "dask":
        fail_at_once(request, monkeypatch)
    with mortal(name, living) as pool:
        rows = rows_of(run_batch(jobs_of(parts, tmp_path / "out"), Instead(pool, die_always)))
    assert (
        "died" in rows["b"]["error"] and "\n" not in rows["b"]["error"] and rows["b"]["verdict"] == "failed"
    )
    for key, data in contents(tmp_path / "out").items():
        assert data == expected(True)[1][key] and key[0] != "b"


KILLS = [(KILLED[0], name) for name in ("setup", "compare", "reach")] + [
    (name, "setup") for name in KILLED[1:]
]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "of"), KILLS)
def test_a_worker_killed_in_a_study_is_reported_or_its_task_is_done_again(
    name, of, living, parts, reported, tmp_path
):
    """Pools of Python and loky break, which is one clear error and no result; a second run has all. Dask has
    another worker."""
    mark, shares, roof = tmp_path / "died", [], str(parts / "a.stl")

    def tell(stage, fraction):
        shares.append(fraction)

    with mortal(name, living) as pool:
        killing = Killing(pool, str(mark))
        if name != "dask":
            with pytest.raises(SettingsError, match="a process died"):
                try_study(of, roof, killing)
        else:
            assert texts_of(try_study(of, roof, killing, tell)) == reported(of)[1]
    assert mark.exists()
    if name != "dask":
        assert texts_of(try_study(of, roof, Killing(living(name), str(mark)), tell)) == reported(of)[1]
    assert shares[-1] == 1.0


def run_by_command(parts, out, *words, before=()):
    """The files that ``batch`` writes, in a process of its own."""
    command = [
        *before,
        "-m",
        "freecad_fiveaxis",
        "batch",
        str(parts),
        "--out",
        str(out),
        "--quiet",
        *words,
        *WORDS,
    ]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=600)
    assert done.returncode == cli.DONE_WITH_ERRORS, done.stderr
    return contents(out)


@pytest.mark.slow
@pytest.mark.parametrize("name", KILLED)
def test_a_task_that_no_worker_survives_is_one_clear_error(name, living, request, parts, monkeypatch):
    if name == "dask":
        fail_at_once(request, monkeypatch)
    with mortal(name, living) as pool, pytest.raises(SettingsError, match="a process died"):
        try_study("setup", str(parts / "a.stl"), Killing(pool))


class Plain(roofs.Inline):
    """Ends as loky's and dask's executors do."""

    ended = False

    def shutdown(self, wait=True):
        self.ended = True


def test_an_executor_may_know_little_of_its_end(parts, tmp_path, monkeypatch):
    """Of ``shutdown`` only what every executor has is asked for."""
    pool = Plain()
    monkeypatch.setattr(
        crews, "find_crew", lambda name, workers: Crew(lambda number: pool, workers, threading.Event())
    )
    with roofs.blank_pages():
        cli.main(["batch", str(parts), "--out", str(tmp_path / "out"), "--quiet", *WORDS])
    assert pool.ended and "batch.csv" in contents(tmp_path / "out")


@pytest.fixture(scope="module")
def by_command(parts, tmp_path_factory):
    """What the command writes without workers, here."""
    out = tmp_path_factory.mktemp("serial")
    words = ["batch", str(parts), "--out", str(out), "--quiet", "--executor", "serial", *WORDS]
    assert cli.main(words) == cli.DONE_WITH_ERRORS
    return contents(out)


@pytest.mark.slow
def test_the_command_on_mpi_makes_the_same_files(parts, by_command, tmp_path, monkeypatch):
    for key, value in mpi_environment().items():
        monkeypatch.setenv(key, value)
    ranks = [shutil.which("mpiexec"), "-n", "3", sys.executable, "-m", "mpi4py.futures"]
    assert run_by_command(parts, tmp_path / "out", "--executor", "mpi", before=ranks) == by_command


@pytest.mark.slow
def test_the_command_on_a_scheduler_of_dask_makes_the_same_files(parts, by_command, tmp_path):
    with engines.dask_client() as client:  # of its own: none of its workers was killed before
        words = ("--executor", address_of(client))
        result = run_by_command(parts, tmp_path / "out", *words, before=[sys.executable])
    assert result == by_command


@pytest.mark.slow
@pytest.mark.parametrize("workers", [0, 1])
def test_jobs_that_wait_for_a_worker_of_dask_are_reported(workers, capsys):
    with engines.dask_client(workers) as client:
        address = address_of(client)
        pool = crews.find_crew(address, 2).open()
        reported = capsys.readouterr().err
        end_pool(pool, wait=True)
        assert pool.client.status == "closed"
    address = address.removeprefix("dask://")
    assert ("has no worker yet" in reported, f"`dask worker {address}`" in reported) == 2 * (not workers,)


def address_of(client):
    return client.scheduler.address.replace("tcp://", "dask://")
