# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pythons that are started to work beside this one: what they give, how they end, and what happens where they
die."""

import os
import subprocess
import sys
import threading
import time
import zipfile
from concurrent.futures import BrokenExecutor
from pathlib import Path

import pytest

from freecad_fiveaxis.core.base import crew, worker, workers
from freecad_fiveaxis.core.base.errors import Cancelled, ReachError
from freecad_fiveaxis.core.base.progress import silent
from freecad_fiveaxis.core.base.spread import spread

ROOT = Path(__file__).parents[2]
LIMIT = 60.0
"""s: guards against hanging."""


def command():
    """This Python, which finds the functions below."""
    return workers.Command(
        (sys.executable, "-c", workers.python_code("serve")), {"PYTHONPATH": str(Path(__file__).parent)}
    )


@pytest.fixture
def started(monkeypatch):
    """The processes that were started."""
    processes, begin = [], workers.start
    monkeypatch.setattr(workers, "start", lambda *given: processes.append(begin(*given)) or processes[-1])
    return processes


def beside(count=1, find=command, patience=0.0):
    return workers.WorkerProcesses(find, count, patience)


@pytest.fixture
def pool(started):
    """One whose worker is ready: nothing is begun here any more."""
    result = beside()
    wait_for_worker(result)
    yield result
    result.stop()


def wait_for_worker(pool):
    end = time.monotonic() + LIMIT
    while pool.submit(os.getpid).result(LIMIT) == os.getpid():
        assert time.monotonic() < end, "no worker got ready"
        time.sleep(0.02)


def tell_place(common, task, progress):
    return common, task, os.getpid()


def refuse(given):
    raise ReachError(f"task {given}", given)


def die_elsewhere(home):
    if os.getpid() != home:
        os._exit(7)
    return "done here"


def print_much(given):
    print("x" * 100000, flush=True)
    os.write(1, b"y" * 100000)
    return given


def out_of_memory_elsewhere(home):
    if os.getpid() != home:
        raise MemoryError
    return "done here"


def has_one_thread():
    return set(map(os.environ.get, crew.ONE_THREAD)), crew.works_alone()


def work_on(folder, name):
    """Goes on long after any test."""
    Path(folder, str(name)).touch()
    for _ in range(60000):
        crew.look_for_stop("", 0.0)
        time.sleep(0.01)


def half_done(folder, task, progress):
    """Ends once somebody has heard that half of it is done."""
    while not Path(folder, "heard").exists():
        progress("", 0.5)
        time.sleep(0.01)


def test_tasks_are_done_by_a_process_of_its_own_and_come_in_their_order(pool, started):
    found = spread(tell_place, "common", range(9), pool, silent, "stage")
    assert [one[:2] for one in found] == [("common", task) for task in range(9)]
    assert {pid for *_, pid in found} == {started[0].pid} and pool.died == 0


def test_what_a_task_raises_comes_back_and_the_worker_goes_on(pool):
    with pytest.raises(ReachError, match="task 3") as reported:
        pool.submit(refuse, 3).result(LIMIT)
    assert (
        reported.value.value == 3 and pool.submit(os.getpid).result(LIMIT) != os.getpid() and pool.died == 0
    )


def test_what_a_task_prints_is_no_answer(pool):
    assert pool.submit(print_much, "given").result(LIMIT) == "given" and pool.died == 0


def test_libraries_keep_to_one_thread(pool):
    assert pool.submit(has_one_thread).result(LIMIT) == ({"1"}, False)


@pytest.mark.parametrize("task", [die_elsewhere, out_of_memory_elsewhere])
def test_the_task_of_a_worker_that_dies_is_done_here(pool, started, task):
    assert pool.submit(task, os.getpid()).result(LIMIT) == "done here" and pool.died == 1
    assert spread(tell_place, "common", [1, 2], pool, silent, "") == [
        ("common", task, os.getpid()) for task in (1, 2)
    ]
    assert started[0].wait(LIMIT)


def test_what_cannot_be_sent_is_done_here(pool):
    assert pool.submit(lambda: os.getpid()).result(LIMIT) == os.getpid() and pool.died == 0
    assert pool.submit(threading.Event).result(LIMIT).is_set() is False  # nor can what it gives
    assert pool.died == 1


def test_short_work_starts_no_process(started):
    wanted = []
    pool = beside(find=lambda: wanted.append(1), patience=600.0)
    assert spread(tell_place, "common", [1, 2], pool, silent, "") == [
        ("common", task, os.getpid()) for task in (1, 2)
    ]
    pool.stop()
    assert not wanted and not started


@pytest.mark.parametrize(
    "words", [None, ("no-such-program",), (sys.executable, "-c", "print('something else')")]
)
def test_without_a_worker_the_work_is_done_here(words, started):
    find = (lambda: None) if words is None else lambda: workers.Command(words)
    with beside(2, find) as pool:
        assert spread(tell_place, "common", range(50), pool, silent, "") == [
            ("common", at, os.getpid()) for at in range(50)
        ]
    assert all(process.returncode is not None for process in started)


def test_the_end_of_the_block_waits_for_the_tasks_and_leaves_no_process(started):
    with beside() as pool:
        wait_for_worker(pool)
        futures = [pool.submit(os.getpid) for _ in range(5)]
    assert {future.result(0) for future in futures} == {started[0].pid} and started[0].returncode is not None
    with pytest.raises(BrokenExecutor):
        pool.submit(os.getpid)


def test_a_stop_reaches_what_runs_here_and_there_and_what_waits(tmp_path, started):
    pool = beside()
    futures = [pool.submit(work_on, tmp_path, name) for name in range(4)]
    end = time.monotonic() + LIMIT
    while (
        len(os.listdir(tmp_path)) < 2 and time.monotonic() < end
    ):  # the first is done here, the second in a worker
        time.sleep(0.02)
    pool.stop()
    assert [process.returncode is not None for process in started] == [True]
    assert sorted(os.listdir(tmp_path)) == ["0", "1"] and [future.cancelled() for future in futures] == [
        False,
        False,
        True,
        True,
    ]
    for future in futures[:2]:
        with pytest.raises(Cancelled):
            future.result(LIMIT)


@pytest.mark.parametrize(("seconds", "died"), [(600, 0), (0, 1)], ids=["stopped", "ended"])
def test_a_worker_that_is_stopped_before_it_is_ready_has_not_died(tmp_path, started, seconds, died):
    pool = beside(find=lambda: workers.Command((sys.executable, "-c", f"import time; time.sleep({seconds})")))
    for name in range(3):
        pool.submit(work_on, tmp_path, name)
    end = time.monotonic() + LIMIT
    while not (started and pool.died == died) and time.monotonic() < end:
        time.sleep(0.02)
    pool.stop()
    pool.shutdown(wait=True)
    assert len(started) == 1 and pool.died == died


def test_a_worker_ends_with_its_parent_in_the_middle_of_a_task(tmp_path):
    """Stdin ends where the parent does, however it ends."""
    import pickle

    process = workers.start(command())
    workers.skip_greeting(process.stdout)
    worker.send(process.stdin, pickle.dumps((work_on, (tmp_path, "begun"), {})))
    end = time.monotonic() + LIMIT
    while not os.listdir(tmp_path) and time.monotonic() < end:
        time.sleep(0.02)
    process.stdin.close()
    assert process.wait(LIMIT) == 0 and os.listdir(tmp_path) == ["begun"]
    process.stdout.close()


def test_how_far_a_task_is_in_another_process_is_heard(pool, tmp_path):
    reported = []

    def hear(stage, fraction):
        reported.append(fraction)
        if fraction == 0.5:
            (tmp_path / "heard").touch()

    spread(half_done, str(tmp_path), ["task"], pool, hear, "stage")
    assert 0.5 in reported and reported == sorted(reported) and reported[-1] == 1.0


@pytest.mark.skipif(os.name != "posix", reason="signals and pipes of POSIX")
def test_a_worker_that_dies_takes_nobody_along_where_a_broken_pipe_is_a_signal(tmp_path):
    """As in FreeCAD 1.1, whose Python leaves that signal deadly; here another Python is made so."""
    code = """import operator, signal, test_workers
signal.signal(signal.SIGPIPE, signal.SIG_DFL)
pool = test_workers.beside()
test_workers.wait_for_worker(pool)
for one in pool._workers:
    one.kill()
print(pool.submit(operator.add, 2, 3).result(60), pool.died)"""
    path = os.pathsep.join((str(ROOT), str(Path(__file__).parent)))
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        timeout=LIMIT,
        env={**os.environ, "PYTHONPATH": path},
    )
    assert (done.returncode, done.stdout.split()) == (0, [b"5", b"1"]), done.stderr


def test_a_package_in_a_zip_is_found(tmp_path):
    archive = tmp_path / "add-on.zip"
    with zipfile.ZipFile(archive, "w") as result:
        for folder in ("freecad_fiveaxis", "freecad_fiveaxis/core", "freecad_fiveaxis/core/base"):
            for file in (ROOT / folder).glob("*.py"):
                result.write(file, file.relative_to(ROOT))
    code = (
        f"import sys\nsys.path.insert(0, {str(archive)!r})\nfrom freecad_fiveaxis.core.base import workers\n"
    )
    code += "print(workers.python_code('show_identity'))"
    boot = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=LIMIT, cwd=tmp_path, check=True
    ).stdout
    assert "add-on.zip" in boot and repr(str(ROOT)) not in boot, (
        "the package of this folder would be another one"
    )
    done = subprocess.run([sys.executable, "-c", boot], capture_output=True, timeout=LIMIT, cwd=tmp_path)
    assert done.stdout == worker.MARK + worker.identity().encode() + worker.MARK
