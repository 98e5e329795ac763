# SPDX-License-Identifier: LGPL-2.1-or-later
"""A batch: no job lost and none twice, and what is finished is not done again."""

import concurrent.futures
import json
import os
from pathlib import Path

import pytest
import roofs
from dying import die_always, die_once
from roofs import (
    WAY,
    Dropping,
    Dying,
    Forgetting,
    Inline,
    Instead,
    Swapping,
    contents,
    jobs_of,
    work_with_blank_pages,
    write_parts,
    write_roof,
)

from freecad_fiveaxis.core.base import crew
from freecad_fiveaxis.core.base.chunks import in_threads
from freecad_fiveaxis.core.base.errors import Cancelled, SettingsError
from freecad_fiveaxis.core.batch import crews, plan, work
from freecad_fiveaxis.core.batch.run import run_batch
from freecad_fiveaxis.core.batch.task import FAILED


@pytest.fixture(scope="module")
def parts(tmp_path_factory):
    """A folder with three parts, the last of which is none."""
    return write_parts(tmp_path_factory.mktemp("parts"))


@pytest.fixture(scope="module")
def expected(parts, tmp_path_factory):
    """What one job after the other gives, with blank pages: rows by name, and the files."""
    out = tmp_path_factory.mktemp("blank")
    with roofs.blank_pages():
        rows = {outcome.row["name"]: outcome.row for outcome in run_batch(jobs_of(parts, out))}
    assert list(rows) == ["a", "b", "c"] and sorted(contents(out)) == [
        f"{name}.{kind}" for name in "ab" for kind in ("html", "json", "ngc")
    ]
    assert rows["a"]["deviation_mm"] > 0 and rows["c"]["verdict"] == FAILED and "c.stl" in rows["c"]["part"]
    return rows, contents(out)


@pytest.fixture
def blank_pages():
    with roofs.blank_pages():
        yield


@pytest.mark.parametrize("wrong", [Swapping, Forgetting])
def test_an_executor_that_gives_back_something_else_is_noticed(wrong, parts, tmp_path, blank_pages):
    with pytest.raises(SettingsError, match="gave back"):
        list(run_batch(jobs_of(parts, tmp_path / "out"), wrong()))


def test_what_an_executor_gives_up_is_done_by_a_new_one_or_reported(parts, expected, tmp_path, blank_pages):
    reported = {
        outcome.row["name"]: outcome.error
        for outcome in run_batch(jobs_of(parts, tmp_path / "one"), Dropping())
    }
    assert (
        list(reported) == ["a", "b", "c"]
        and not reported["a"]
        and "process died" in reported["b"]
        and "process died" in reported["c"]
    )
    rows = {
        one.row["name"]: one.row
        for one in run_batch(jobs_of(parts, tmp_path / "two"), Dropping(), again=lambda workers: Inline())
    }
    assert (rows, contents(tmp_path / "two")) == expected


def test_the_jobs_of_a_process_that_dies_run_again_and_none_twice(parts, expected, tmp_path):
    crew, result = crews.process_crew(1), []

    def again(workers=None):
        result.append(workers)
        return Instead(crew.open(workers), work_with_blank_pages)

    with Instead(crew.open(), die_once, str(tmp_path / "died")) as pool:
        ended = list(run_batch(jobs_of(parts, tmp_path / "out"), pool, again=again))
    assert (tmp_path / "died").exists() and result == [None] and len(ended) == 3
    assert ({one.row["name"]: one.row for one in ended}, contents(tmp_path / "out")) == expected


@pytest.mark.parametrize("kind", ["reported so", pytest.param("processes", marks=pytest.mark.thorough)])
def test_only_the_job_that_kills_its_process_fails(kind, parts, expected, tmp_path, blank_pages):
    crew = crews.process_crew(1)

    def again(workers=None):
        return Instead(crew.open(workers), die_always) if kind == "processes" else Dying()

    with again() as pool:
        ended = {
            one.row["name"]: one for one in run_batch(jobs_of(parts, tmp_path / "out"), pool, again=again)
        }
    assert sorted(ended) == ["a", "b", "c"] and "process died" in ended["b"].error
    assert ended["a"].row == expected[0]["a"] and ended["c"].row == expected[0]["c"]
    assert sorted(contents(tmp_path / "out")) == ["a.html", "a.json", "a.ngc"]


class Queue(Inline):
    """Never begins a job."""

    def __init__(self):
        self.given = []

    def submit(self, work, /, *given, **named):
        self.given.append(concurrent.futures.Future())
        return self.given[-1]


def test_who_stops_a_batch_cancels_what_waits(parts, tmp_path):
    def stop(stage, fraction):
        raise Cancelled("stopped")

    queue = Queue()
    with pytest.raises(Cancelled):
        list(run_batch(jobs_of(parts, tmp_path / "out"), queue, stop))
    assert len(queue.given) == 3 and all(future.cancelled() for future in queue.given)
    with pytest.raises(Cancelled):
        list(run_batch(jobs_of(parts, tmp_path / "out"), None, stop))
    assert contents(tmp_path / "out") == {}


def test_workers_leave_what_they_are_at_when_their_crew_stops(parts, tmp_path):
    crew = crews.thread_crew(1)
    crew.stop()
    with crew.open() as pool, pytest.raises(Cancelled):
        list(run_batch(jobs_of(parts, tmp_path / "out"), pool))
    assert contents(tmp_path / "out") == {}


def test_progress_tells_the_share_of_the_jobs(parts, tmp_path):
    reported = []
    list(
        run_batch(
            jobs_of(parts, tmp_path / "out")[2:] * 2, None, lambda stage, fraction: reported.append(fraction)
        )
    )
    assert reported[0] == 0.0 and reported[-1] == 1.0 and reported == sorted(reported)


def test_a_job_in_a_worker_keeps_to_its_thread(monkeypatch, parts, tmp_path):
    import threading

    from freecad_fiveaxis.core.base import chunks

    monkeypatch.setattr(chunks, "ALONE", False)
    seen = []

    def pipeline(settings, progress):
        seen.extend(in_threads(lambda part: threading.get_ident(), range(50)))
        seen.append(chunks.meanwhile(lambda: seen.append(threading.get_ident()), threading.get_ident))
        raise SettingsError("enough", "")

    monkeypatch.setattr(work.pipeline, "run", pipeline)
    assert work.run_in_worker(jobs_of(parts, tmp_path / "out")[0]).error == "enough"
    assert set(seen) == {threading.get_ident()} and len(seen) == 52


def test_a_finished_job_is_known_until_anything_of_it_changes(parts, tmp_path, blank_pages):
    part, out = tmp_path / "a.stl", tmp_path / "out"
    part.write_bytes((parts / "a.stl").read_bytes())
    (job,) = jobs_of(tmp_path, out)
    assert work.read_finished(job) is None
    done = work.run_one(job)
    assert work.read_finished(job) == done
    (other,) = plan.read_jobs(str(tmp_path), WAY | {"stepover": 8}, str(out))
    assert work.read_finished(other) is None and work.foreign_files(other) == []
    write_roof(part, 17.0)
    assert work.read_finished(job) is None
    part.write_bytes((parts / "a.stl").read_bytes())
    assert work.read_finished(job) == done
    Path(job.nc).write_text("M2\n")  # somebody has edited it
    assert work.read_finished(job) is None and work.foreign_files(job) == [job.nc]
    assert job.nc in work.run_one(job).error and Path(job.nc).read_text() == "M2\n"


def test_a_result_is_not_computed_twice(monkeypatch, parts, tmp_path, blank_pages):
    job = jobs_of(parts, tmp_path / "out")[0]
    done = work.run_one(job)
    monkeypatch.setattr(work.pipeline, "run", None)
    assert work.run_one(job) == done


def test_a_fault_of_the_program_fails_its_job_alone(monkeypatch, parts, tmp_path):
    def broken(settings, progress):
        raise ZeroDivisionError("a\nb")

    monkeypatch.setattr(work.pipeline, "run", broken)
    assert [one.error for one in run_batch(jobs_of(parts, tmp_path / "out"))] == [
        "ZeroDivisionError: a\\nb"
    ] * 3
    assert os.listdir(tmp_path / "out") == []


def test_the_report_of_a_job_is_that_of_mill_with_what_the_batch_keeps(expected):
    report = json.loads(expected[1]["a.json"])
    assert (
        report["summary"]["cut_length"] == expected[0]["a"]["cut_mm"] and report["inputs"]["output"] is None
    )
    assert sorted(report["batch"]["files"]) == ["a.html", "a.ngc"]


def test_processes_find_one_thread_in_their_environment_before_they_import_anything(monkeypatch):
    for name in crew.ONE_THREAD:
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv(crew.ONE_THREAD[0], "3")
    crew.process_crew(1).open().shutdown()
    assert [os.environ.get(name) for name in crew.ONE_THREAD] == ["3", "1", "1"]


def test_a_missing_folder_of_a_jobs_files_is_created(parts, tmp_path, blank_pages):
    out = tmp_path / "new" / "out"
    job = plan.read_jobs(str(parts), dict(roofs.WAY), str(out))[0]
    assert not out.exists()
    assert [one.error for one in run_batch([job])] == [""] and Path(job.nc).is_file()
    (tmp_path / "file").write_text("in the way")
    job = plan.read_jobs(str(parts), dict(roofs.WAY), str(tmp_path / "file" / "out"))[0]
    assert ["cannot be written" in one.error for one in run_batch([job])] == [True]
