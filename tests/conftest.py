# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every ring's closing lines name the tests that took most of the processor: what a test waits for costs
nobody anything.

FIVEAXIS_SLOWEST: how many (10). FIVEAXIS_UNTIL: no test begins after that time, s of the clock (``make
changed``).
"""

import gc
import hashlib
import os
import re
import time

import pytest

KEPT = {}
"""What the core made in this process, by what it was made of: see the fixture ``kept``."""
BEGAN = pytest.StashKey[float]()
SHOWN = int(os.environ.get("FIVEAXIS_SLOWEST") or 10)
UNTIL = float(os.environ.get("FIVEAXIS_UNTIL") or "inf")


def processor_seconds():
    """Processor time of this process and of its children that have ended, s."""
    return sum(os.times()[:4])


def _keeping(result, of):
    """The function ``draft``, whose result is kept under ``of(its arguments)`` and given to whoever asks for
    the same."""

    def act(*given):
        name = result.__module__, result.__name__, of(*given)
        if name not in KEPT:
            KEPT[name] = result(*given)
        return KEPT[name]

    return act


def _content(task):
    """All that a task of results.py holds, whether its fingerprint knows of it or not; what is large by its
    checksum."""
    data, matrix = (task.data, ()) if isinstance(task.data, bytes) else (task.data.kernel, task.data.matrix)
    solids = [one.stl for one in (*((task.part,) if task.part else ()), *task.fixtures)]
    return (
        repr(task.settings),
        task.runs,
        task.avoided,
        matrix,
        *(hashlib.sha256(one).digest() for one in (data, *solids)),
    )


@pytest.fixture
def kept(monkeypatch):
    """For tests inside FreeCAD that are not about the computing: results, maps of setups and of what is
    reached, and of rest material are those of an earlier test of this process, where all that they are made
    of is the same, the part's name too. Mark what is to be computed ``anew``."""
    from freecad_fiveaxis.app import reach, rest, results, setups
    from freecad_fiveaxis.core.studies import reach_map

    for module, name, of in (
        (
            results,
            "_compute_result",
            lambda proxy, task, fingerprint, progress: (type(proxy), fingerprint, *_content(task)),
        ),
        (setups, "_try_setups", lambda task, fingerprint, progress, executor: (fingerprint, *_content(task))),
        (
            reach,
            "_compute_map",
            lambda task, fingerprint, progress, executor: (fingerprint, reach_map.PLACES, *_content(task)),
        ),
        (
            rest,
            "_compute_heights",
            lambda figures, known, progress: (known.fingerprint, known.result.draft.settings.source),
        ),
    ):
        monkeypatch.setattr(module, name, _keeping(getattr(module, name), of))


@pytest.fixture
def anew():
    """anew(): forget what was kept, so that the next result is computed; done once before the test."""
    KEPT.clear()
    return KEPT.clear


WRITTEN = {
    "large": "large",
    "rs274": "rs274",
    "slow": "slow|thorough|some_in_core",
    "thorough": "slow|thorough|some_in_core",
}
"""Marks of rings, and by which words the Makefile finds the files that bear them."""


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    """A ring reads only files in which its mark is written: one that got it otherwise would be in no ring."""
    for mark, words in WRITTEN.items():
        for file in {item.path for item in items if item.get_closest_marker(mark)}:
            if not re.search(words, file.read_text(encoding="utf-8")):
                raise pytest.UsageError(
                    f"{file}: tests are marked {mark}, but {words} stands nowhere in the file"
                )


def pytest_sessionstart():
    """While tests are collected nothing becomes garbage in circles, and to look for it among all that is read
    takes longer than to read it; nor is there any in what has been read."""
    gc.disable()


def pytest_collection_finish():
    gc.freeze()
    gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    item.stash[BEGAN] = processor_seconds()
    if time.time() > UNTIL:
        pytest.skip("left: the minute is over")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item, call):
    report = yield
    if call.when == "teardown":
        report.user_properties.append(("processor_seconds", processor_seconds() - item.stash[BEGAN]))
    return report


def pytest_terminal_summary(terminalreporter):
    """The lines that scripts/rings reads back: SECONDS s of the processor: TEST."""
    spent = {
        report.nodeid: dict(report.user_properties).get("processor_seconds", 0.0)
        for reports in terminalreporter.stats.values()
        for report in reports
        if getattr(report, "when", None) == "teardown"
    }
    slowest = sorted(spent, key=spent.get, reverse=True)[:SHOWN]
    terminalreporter.section("most processor time")
    for name in slowest:
        terminalreporter.write_line(f"{spent[name]:.2f} s of the processor: {name}")
