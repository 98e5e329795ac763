# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two threads give what one gives, and pass on what is raised."""

import threading
import time

import pytest

from freecad_fiveaxis.core import side_by_side as module
from freecad_fiveaxis.core.side_by_side import side_by_side


@pytest.fixture(params=[1, 2])
def cores(request, monkeypatch):
    monkeypatch.setattr(module, "_cores", lambda: request.param)
    return request.param


def test_results_come_in_the_order_of_the_parts(cores):
    def slow_first(part):
        time.sleep(0.02 if part == 0 else 0.0)
        return part * part

    assert side_by_side(slow_first, range(20)) == [part * part for part in range(20)]


def test_no_part_gives_no_result(cores):
    assert side_by_side(abs, []) == []


def test_the_share_that_is_done_is_told_in_the_thread_that_asked(cores):
    told = []
    side_by_side(abs, range(4), lambda share: told.append((share, threading.current_thread())))
    assert told == [(share, threading.current_thread()) for share in (0.25, 0.5, 0.75, 1.0)]


def test_several_parts_go_to_threads_only_where_there_are_cores(cores):
    threads = set(side_by_side(lambda part: threading.current_thread(), range(50)))
    assert (threading.current_thread() in threads) == (cores == 1)
    assert side_by_side(lambda part: threading.current_thread(), range(1)) == [threading.current_thread()]


def test_what_a_part_raises_is_raised(cores):
    def work(part):
        if part == 3:
            raise KeyError(part)

    with pytest.raises(KeyError, match="3"):
        side_by_side(work, range(5))


def test_who_stops_it_does_not_wait_for_the_parts_that_are_left(cores):
    class Stop(Exception):
        pass

    begun = []

    def work(part):
        begun.append(part)
        time.sleep(0.01)

    def stop(share):
        raise Stop

    with pytest.raises(Stop):
        side_by_side(work, range(100), stop)
    count = len(begun)
    time.sleep(0.05)
    assert len(begun) == count < 10
