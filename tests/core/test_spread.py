# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tasks on the workers of any executor: each result in its place, none of another task, and a stop is heard
by all."""

import itertools
import multiprocessing
import os
import pickle
import signal
import tempfile
import threading
import time
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from pathlib import Path

import pytest
from roofs import Forgetting, Inline, Swapping

from freecad_fiveaxis.core.base import chunks, crew, shared
from freecad_fiveaxis.core.base.errors import Cancelled, ReachError, SettingsError
from freecad_fiveaxis.core.base.progress import silent
from freecad_fiveaxis.core.base.spread import spread

COMMON = "common"
TASKS = tuple(range(9))


def tell_place(common, task, progress):
    return common, task, threading.get_ident(), os.getpid()


def refuse(common, task, progress):
    if task == 3:
        raise ReachError("task 3", 3)


def die(common, task, progress):
    os.kill(os.getpid(), getattr(signal, "SIGKILL", signal.SIGTERM))


def work_on(common, task, progress):
    """Goes on until it is stopped, but not for ever; ``common`` names a file by which it says that it has
    begun."""
    with open(f"{common}{task}", "w", encoding="utf-8"):
        pass
    for _ in range(6000):
        progress("", 0.0)
        time.sleep(0.01)
    with open(f"{common}{task}-ended", "w", encoding="utf-8"):
        pass


def threads_of(common, task, progress):
    return set(chunks.in_threads(lambda part: threading.get_ident(), range(50))) == {threading.get_ident()}


class Backwards(Executor):
    """Begins with what was given last, and ends with what was given first."""

    def __init__(self, count):
        self.count, self.given = count, []

    def submit(self, work, /, *given, **named):
        self.given.append((Future(), work, given, named))
        future = self.given[-1][0]
        if len(self.given) == self.count:
            for result, work, given, named in self.given[::-1]:
                result.set_result(work(*given, **named))
        return future


@pytest.fixture(params=["here", "inline", "threads", "processes", "backwards"])
def executor(request):
    if request.param == "threads":
        with crew.at_work(crew.thread_crew(2)) as pool:
            yield pool
    elif request.param == "processes":
        yield request.getfixturevalue("processes")
    else:
        yield {"here": None, "inline": Inline(), "backwards": Backwards(len(TASKS))}[request.param]


def test_results_come_in_the_order_of_the_tasks(executor):
    reported = []
    found = spread(
        tell_place,
        COMMON,
        TASKS,
        executor,
        lambda stage, fraction: reported.append((stage, fraction)),
        "stage",
    )
    assert [(common, task) for common, task, *_ in found] == [(COMMON, task) for task in TASKS]
    assert {stage for stage, _ in reported} == {"stage"} and reported == sorted(reported)
    assert reported[0][1] == 0.0 and reported[-1][1] == 1.0


def test_processes_are_others_and_get_what_is_common_once(processes):
    found = spread(tell_place, COMMON, TASKS, processes, silent, "stage")
    assert os.getpid() not in {pid for *_, pid in found}
    kept = spread(count_kept, COMMON, TASKS, processes, silent, "stage")
    assert len({pid for pid, _ in kept}) == len(set(kept))


def count_kept(common, task, progress):
    return os.getpid(), id(common)


def test_the_share_that_is_done_goes_by_weight():
    reported = []
    spread(
        tell_place,
        COMMON,
        (0, 1),
        None,
        lambda stage, fraction: reported.append(fraction),
        "stage",
        (3.0, 1.0),
    )
    assert reported == [0.0, 0.75, 1.0]


def test_no_task_is_none():
    assert spread(tell_place, COMMON, (), Inline(), silent, "stage") == []


LARGE = {"zeros": bytes(1 << 20), "list": list(range(9))}


class Packing(Inline):
    """Does each task from its pickle, as a worker elsewhere does, whose process has what is common from
    nobody else; keeps how long each pickle was and what lay among the temporary files. ``reach``: whether it
    can read them."""

    def __init__(self, reach=lambda file: True):
        self.reach, self.bytes, self.files = reach, [], []

    def submit(self, work, /, *given, **named):
        packed = pickle.dumps((work, given, named))
        self.bytes.append(len(packed))
        self.files.append(temporary_files())
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(shared, "_kept", {})
            if not self.reach(self.files[-1]):
                patch.setattr(shared, "_read", lambda key, file: None)
            work, given, named = pickle.loads(packed)
            return super().submit(work, *given, **named)


def temporary_files():
    return sorted(Path(tempfile.gettempdir()).iterdir())


@pytest.fixture
def own_temporary(tmp_path, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    return tmp_path


def test_what_is_common_goes_by_a_file_once_and_nothing_is_left(own_temporary):
    pool = Packing()
    found = spread(tell_place, LARGE, TASKS, pool, silent, "stage")
    assert [(common, task) for common, task, *_ in found] == [(LARGE, task) for task in TASKS]
    assert max(pool.bytes) < 1000 and [len(files) for files in pool.files] == [1] * len(TASKS)
    assert temporary_files() == []


def test_what_is_small_is_sent_and_makes_no_file(own_temporary):
    pool = Packing()
    spread(tell_place, COMMON, TASKS, pool, silent, "stage")
    assert pool.files == [[]] * len(TASKS)


@pytest.mark.parametrize("others", ["from the beginning", "among those of this computer"])
def test_who_cannot_read_the_file_gets_the_bytes(others, own_temporary):
    """As a worker of another computer; in the order of the tasks all the same, and each is done once."""
    done, turns = [], itertools.count()
    pool = Packing(
        (lambda files: False) if others == "from the beginning" else lambda files: next(turns) % 3 != 2
    )
    found = spread(
        common_and_task, (LARGE, "all"), TASKS, pool, lambda stage, fraction: done.append(fraction), "stage"
    )
    assert found == [(LARGE, task) for task in TASKS]
    assert done == sorted(done) and done[-1] == 1.0
    assert (
        len(TASKS) < len(pool.bytes) <= 2 * len(TASKS)
        and max(pool.bytes) > 1 << 20
        and temporary_files() == []
    )


def common_and_task(common, task, progress):
    return common[0], task


def test_a_file_that_is_not_the_one_written_is_not_unpickled(own_temporary):
    """Somebody has written over it: the bytes go instead."""

    class Spoiled(Packing):
        def submit(self, work, /, *given, **named):
            pickle.dumps(given)
            for file in temporary_files():
                file.write_bytes(pickle.dumps("another"))
            return super().submit(work, *given, **named)

    found = spread(tell_place, LARGE, TASKS, Spoiled(), silent, "stage")
    assert [common for common, *_ in found] == [LARGE] * len(TASKS)


def test_where_no_file_can_be_written_the_bytes_go(own_temporary, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(own_temporary / "nowhere"))
    found = spread(tell_place, LARGE, TASKS[:2], Instantly(), silent, "stage")
    assert [common for common, *_ in found] == [LARGE] * 2


class Instantly(Inline):
    """Does each task from its pickle."""

    def submit(self, work, /, *given, **named):
        return super().submit(work, *pickle.loads(pickle.dumps(given)))


def test_a_task_pickled_after_the_end_leaves_no_file_and_harms_no_worker(own_temporary):
    kept = shared.Shared(LARGE)
    kept.close()
    assert isinstance(pickle.loads(pickle.dumps(kept)), shared.Lost) and temporary_files() == []


def test_processes_of_a_pool_read_the_file_and_it_is_gone_after_errors_too(processes, own_temporary):
    found = spread(tell_place, LARGE, TASKS, processes, silent, "stage")
    assert [(common, task) for common, task, *_ in found] == [(LARGE, task) for task in TASKS]
    with pytest.raises(ReachError):
        spread(refuse, LARGE, TASKS, processes, silent, "stage")
    assert temporary_files() == []


@pytest.mark.parametrize("wrong", [Swapping, Forgetting])
def test_an_executor_that_gives_back_something_else_is_noticed(wrong):
    with pytest.raises(SettingsError, match="gave back"):
        spread(tell_place, COMMON, TASKS, wrong(), silent, "stage")


def test_what_a_task_raises_is_raised(executor):
    with pytest.raises(ReachError, match="task 3") as reported:
        spread(refuse, COMMON, TASKS, executor, silent, "stage")
    assert reported.value.value == 3


def test_a_process_that_dies_is_reported_in_one_line():
    with pytest.raises(SettingsError, match="--workers"), crew.at_work(crew.process_crew(1)) as pool:
        spread(die, COMMON, TASKS, pool, silent, "stage")


@pytest.mark.parametrize("kind", ["threads", "foreign threads", "processes"])
def test_a_stop_is_heard_by_what_runs_and_by_what_waits(kind, tmp_path):
    """What runs does not go on to its end, what waits does not begin, and no worker is left."""
    mark, before = str(tmp_path / "begun"), (threading.active_count(), set(multiprocessing.active_children()))

    def stop(stage, fraction):
        if os.listdir(tmp_path):
            raise Cancelled("enough")

    if kind == "foreign threads":
        with pytest.raises(Cancelled, match="enough"), ThreadPoolExecutor(1) as pool:
            spread(work_on, mark, TASKS, pool, stop, "stage")
    else:
        result = crew.thread_crew(1) if kind == "threads" else crew.process_crew(1)
        with pytest.raises(Cancelled, match="enough"), crew.at_work(result) as pool:
            spread(work_on, mark, TASKS, pool, stop, "stage")
    assert os.listdir(tmp_path) == ["begun0"]
    assert threading.active_count() <= before[0] and set(multiprocessing.active_children()) <= before[1]


def test_a_worker_keeps_to_one_thread(monkeypatch):
    monkeypatch.setattr(chunks, "ALONE", False)
    assert all(spread(threads_of, COMMON, (0, 1), Inline(), silent, "stage"))


def test_no_crew_is_no_executor():
    with crew.at_work(None) as executor:
        assert executor is None


@pytest.mark.parametrize("given", ["0", "-1", "two", "1.5", "", "99999", "\u0663"])
def test_workers_are_counted(given):
    with pytest.raises(SettingsError, match="whole number"):
        crew.read_workers(given)
    assert crew.read_workers("2") == 2
