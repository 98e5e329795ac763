# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tasks on the workers of any executor: each result in its place, none of another task, and a stop is heard by all."""

import multiprocessing
import os
import signal
import threading
import time
from concurrent.futures import Executor, Future, ThreadPoolExecutor

import pytest
from roofs import Forgetting, Inline, Swapping

from freecad_fiveaxis.core.base import chunks, crew
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
    """Goes on until it is stopped, but not for ever; ``common`` names a file by which it says that it has begun."""
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
            for made, work, given, named in self.given[::-1]:
                made.set_result(work(*given, **named))
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
    told = []
    found = spread(tell_place, COMMON, TASKS, executor, lambda stage, fraction: told.append((stage, fraction)), "stage")
    assert [(common, task) for common, task, *_ in found] == [(COMMON, task) for task in TASKS]
    assert {stage for stage, _ in told} == {"stage"} and told == sorted(told)
    assert told[0][1] == 0.0 and told[-1][1] == 1.0


def test_processes_are_others_and_get_what_is_common_once(processes):
    found = spread(tell_place, COMMON, TASKS, processes, silent, "stage")
    assert os.getpid() not in {pid for *_, pid in found}
    kept = spread(count_kept, COMMON, TASKS, processes, silent, "stage")
    assert len({pid for pid, _ in kept}) == len(set(kept))


def count_kept(common, task, progress):
    return os.getpid(), id(common)


def test_the_share_that_is_done_goes_by_weight():
    told = []
    spread(tell_place, COMMON, (0, 1), None, lambda stage, fraction: told.append(fraction), "stage", (3.0, 1.0))
    assert told == [0.0, 0.75, 1.0]


def test_no_task_is_none():
    assert spread(tell_place, COMMON, (), Inline(), silent, "stage") == []


@pytest.mark.parametrize("wrong", [Swapping, Forgetting])
def test_an_executor_that_gives_back_something_else_is_noticed(wrong):
    with pytest.raises(SettingsError, match="gave back"):
        spread(tell_place, COMMON, TASKS, wrong(), silent, "stage")


def test_what_a_task_raises_is_raised(executor):
    with pytest.raises(ReachError, match="task 3") as told:
        spread(refuse, COMMON, TASKS, executor, silent, "stage")
    assert told.value.value == 3


def test_a_process_that_dies_is_told_in_one_line():
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
        made = crew.thread_crew(1) if kind == "threads" else crew.process_crew(1)
        with pytest.raises(Cancelled, match="enough"), crew.at_work(made) as pool:
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
