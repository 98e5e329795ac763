# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two threads over portions: the same results as one, in their order; exceptions pass through; no thread is
left behind."""

import threading
import time
import warnings

import numpy as np
import pytest
from plain import build_settings
from thorough import some_in_core

from freecad_fiveaxis.core.base import chunks as chunks_module
from freecad_fiveaxis.core.base import number_text
from freecad_fiveaxis.core.base.chunks import chunks, in_threads, meanwhile
from freecad_fiveaxis.core.base.errors import Cancelled
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.toolpath.coedge import junction


@pytest.fixture(autouse=True)
def two_threads(monkeypatch):
    """Also where the tests have one processor; and nothing may live longer than the call."""
    monkeypatch.setattr(chunks_module, "ALONE", False)
    monkeypatch.setattr(chunks_module, "PROCESSORS", 2)
    before = threading.active_count()
    yield
    assert threading.active_count() == before


def both_taking_part(work=lambda part: None):
    """``work`` on two threads, neither of which ends its first part before the other has begun one, however
    busy the machine."""
    seen, both = set(), threading.Barrier(2)

    def wait_and_work(part):
        if (thread := threading.get_ident()) not in seen:
            seen.add(thread)
            both.wait(300.0)
        return work(part)

    return wait_and_work


@pytest.mark.parametrize("count", [0, 1, 6, 7, 8, 21, 23])
def test_chunks_make_up_all_rows_in_order(monkeypatch, count):
    monkeypatch.setattr(chunks_module, "PORTION", 7)
    rows = [row for part in chunks(count) for row in range(part.start, part.stop)]
    assert rows == list(range(count))
    assert all(part.stop - part.start <= 7 for part in chunks(count))


def test_results_stand_in_the_order_of_the_parts_and_both_threads_took_some():
    assert in_threads(both_taking_part(lambda part: part * part), range(20)) == [k * k for k in range(20)]


@pytest.mark.parametrize("count", [0, 1])
def test_what_has_one_part_or_none_stays_on_the_calling_thread(count):
    assert in_threads(lambda part: threading.get_ident(), range(count)) == [threading.get_ident()] * count


def test_with_one_processor_all_stays_on_the_calling_thread(monkeypatch):
    monkeypatch.setattr(chunks_module, "ALONE", True)
    assert set(in_threads(lambda part: threading.get_ident(), range(9))) == {threading.get_ident()}


@pytest.mark.parametrize("processors", [3, 8])
def test_as_many_threads_as_processors_are_at_work_at_once(monkeypatch, processors):
    """Each part waits until there are so many of them: fewer threads would wait for ever, and break the
    barrier."""
    monkeypatch.setattr(chunks_module, "PROCESSORS", processors)
    together = threading.Barrier(processors)
    assert sorted(in_threads(lambda part: together.wait(60.0), range(processors))) == list(range(processors))


def test_within_work_another_on_all_keeps_to_its_thread_and_afterwards_there_are_two_again():
    def work(part):
        return {threading.get_ident(), *in_threads(lambda inner: threading.get_ident(), range(5))}

    assert all(len(threads) == 1 for threads in in_threads(both_taking_part(work), range(6)))
    assert len(set.union(*in_threads(both_taking_part(work), range(6)))) == 2


def test_progress_is_reported_on_the_calling_thread_and_only_grows():
    reported = []

    def tell(done):
        assert threading.current_thread() is caller
        reported.append(done)

    caller = threading.current_thread()
    in_threads(both_taking_part(), range(20), tell)
    assert reported == sorted(reported) and reported[0] > 0.0 and reported[-1] <= 1.0


LONG = range(10_000)
"""Parts of 10 ms and more: a thread that is not ended goes on for a minute and more."""


@pytest.mark.parametrize("where", ["helper", "caller"])
def test_an_exception_of_either_thread_passes_through_and_ends_both(where):
    """Both are at a part then, and the other one would go on with all that are left."""
    caller, done = threading.get_ident(), []

    def work(part):
        if (threading.get_ident() == caller) == (where == "caller"):
            raise ValueError(f"part {part}")
        time.sleep(0.01)
        done.append(part)

    with pytest.raises(ValueError, match="part"):
        in_threads(both_taking_part(work), LONG)
    assert 0 < len(done) < len(LONG) - 1


def test_cancelled_from_progress_passes_through_and_ends_both():
    """The helper is at a part when the caller has ended its first one."""
    done = []

    def tell(share):
        raise Cancelled("stopped")

    def work(part):
        time.sleep(0.01)
        done.append(part)

    with pytest.raises(Cancelled):
        in_threads(both_taking_part(work), LONG, tell)
    assert 1 < len(done) < len(LONG)
    assert in_threads(abs, [-1, -2, -3]) == [1, 2, 3]  # and nothing of it stays


def test_the_rules_for_floating_point_errors_hold_on_both_threads():
    def divide(part):
        return float((np.zeros(2) / np.zeros(2))[0])

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with np.errstate(invalid="ignore"):
            assert np.isnan(in_threads(both_taking_part(divide), range(8))).all()
        with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
            in_threads(both_taking_part(divide), range(8))


def test_meanwhile_gives_what_work_gives_and_raises_what_the_helper_raises():
    done = []
    assert meanwhile(lambda: done.append(1), lambda: 2) == 2 and done == [1]
    with pytest.raises(ZeroDivisionError):
        meanwhile(lambda: 1 // 0, lambda: 2)


@pytest.mark.thorough
@some_in_core("part, machine", [("blade", "trunnion_ac"), ("saddle", "nutating_table_b45")])
def test_the_pipeline_gives_the_same_bits_with_one_thread_and_two(monkeypatch, parts, part, machine):
    monkeypatch.setattr(chunks_module, "PORTION", 97)
    monkeypatch.setattr(junction, "GROUP", 50)
    monkeypatch.setattr(number_text, "CHUNK", 60)
    settings = build_settings("mill", str(parts / f"{part}.stl"), {"machine": machine, "stepover": 4.0})
    result = []
    for alone in (True, False):
        monkeypatch.setattr(chunks_module, "ALONE", alone)
        result.append(job.make(settings))
    one, two = result
    assert len(one.program.words) > 5 * 97 and one.nc == two.nc
    for record in ("mesh", "contact", "offset", "path", "joints", "program"):
        for field, column in vars(getattr(one, record)).items():
            if isinstance(column, np.ndarray):
                np.testing.assert_array_equal(
                    column, getattr(getattr(two, record), field), err_msg=f"{record}.{field}"
                )
