# SPDX-License-Identifier: LGPL-2.1-or-later
"""``scripts/rings``: rings side by side, each heard whole; what fails is told; Ctrl-C leaves no process
behind."""

import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

pytestmark = [
    pytest.mark.texts,
    pytest.mark.skipif(
        os.name != "posix" or not shutil.which("make") or not shutil.which("bash"),
        reason="needs make and bash",
    ),
]

HEARS = """
import os, signal, sys
for number in (signal.SIGINT, signal.SIGHUP):
    signal.signal(number, signal.SIG_DFL)
os.execvp("bash", ["bash", *sys.argv[1:]])
"""
"""A process takes over what its parent ignores, and a shell cannot change that: SIGHUP under nohup, SIGINT
behind an ampersand."""

RING = """
{name}:
\t@echo {name} one; echo begin {name} >>log; sleep {seconds}; echo end {name} >>log; echo {name} two; exit {code}
"""


@pytest.fixture
def rings(tmp_path):
    """rings({name: (seconds, code)}, *words, more="", waiting=2): the process of scripts/rings over such
    targets, and ``more``."""
    (tmp_path / "scripts").mkdir()
    shutil.copy(ROOT / "scripts/rings", tmp_path / "scripts")

    def begin(targets, *words, more="", waiting=2):
        text = "".join(
            RING.format(name=name, seconds=seconds, code=code) for name, (seconds, code) in targets.items()
        )
        (tmp_path / "Makefile").write_text(text + more)
        around = {**os.environ, "FIVEAXIS_WAITING": str(waiting), "FIVEAXIS_GRACE": "1", "MAKEFLAGS": ""}
        return subprocess.Popen(
            [sys.executable, "-c", HEARS, "scripts/rings", *words],
            cwd=tmp_path,
            env=around,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )

    return begin


def most_at_once(log, names):
    """How many of these rings were under way at the same time, at most."""
    now = most = 0
    for word, name in re.findall(r"(begin|end) (\w+)", log):
        if name in names:
            now += 1 if word == "begin" else -1
            most = max(most, now)
    return most


def test_rings_run_side_by_side_and_what_each_says_stays_whole(rings, tmp_path):
    names = "abcdef"
    process = rings(dict.fromkeys(names, (0.6, 0)), "a", "b", "c", "--", "d", "e", "f")
    message = process.communicate(timeout=300)[0]
    assert process.returncode == 0, message
    log = (tmp_path / "log").read_text()
    assert most_at_once(log, "abc") == 1, "each of these keeps every core busy"
    assert most_at_once(log, "def") == 2 and most_at_once(log, names) == 3
    for name in names:
        assert f"{name} one\n{name} two\nrings: {name} passed" in message
    assert message.splitlines()[-7].startswith("rings: ================ all after")
    assert sorted(line.split()[1] for line in message.splitlines()[-6:]) == sorted(names)


def test_one_that_fails_makes_all_fail_and_the_others_are_run(rings):
    process = rings({"a": (0, 3), "b": (0, 0), "c": (0, 1), "d": (0, 0)}, "a", "b", "--", "c", "d", waiting=1)
    message = process.communicate(timeout=300)[0]
    assert process.returncode == 1
    reported = dict(re.findall(r"^rings: (\w) (passed|FAILED)", message.split("all after")[1], re.MULTILINE))
    assert reported == {"a": "FAILED", "b": "passed", "c": "FAILED", "d": "passed"}


def test_a_ring_over_its_budget_is_named_with_its_ten_dearest_tests_and_fails_nothing(rings, tmp_path):
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests/budget.toml").write_text("# seconds\n[budget]\na = -1\nb = 500\n")
    lines = "".join(
        f"\t@echo '{seconds}.25 s of the processor: tests/test_{seconds}.py::test'\n" for seconds in range(12)
    )
    process = rings({"c": (0, 0)}, "a", "b", "c", more=f"a:\n{lines}b:\n{lines}")
    message = process.communicate(timeout=300)[0]
    assert process.returncode == 0, message
    closing = message.split("all after")[1]
    assert "(budget -1)" in closing and "(budget 500)" in closing and closing.count("budget") == 4, closing
    assert re.findall(r"^(\d+)\.25 s  tests/test_\1\.py::test$", closing, re.MULTILINE) == [
        str(n) for n in range(11, 1, -1)
    ]
    assert (
        len(re.findall("^rings: a is over its budget: [0-9]", closing, re.MULTILINE)) == 1
        and "b is over" not in closing
    )


def test_every_ring_of_make_test_all_has_a_budget():
    names = re.search(
        r"^test-all:.*\n.*\n\t@bash scripts/rings (.*)", (ROOT / "Makefile").read_text(), re.MULTILINE
    )[1].split()
    budgets = re.findall(r"^([\w-]+) = \d+$", (ROOT / "tests/budget.toml").read_text(), re.MULTILINE)
    assert set(names) - {"--"} <= set(budgets) and len(names) > 10


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_ctrl_c_ends_all_also_what_is_deaf_or_has_a_group_of_its_own(rings, tmp_path, number):
    """``timeout`` has a process group of its own, as FreeCAD has under it; sh is deaf to both signals."""
    deaf = """trap '' INT TERM; echo $$$$ >>ids; while :; do sleep 0.1; done"""
    grouped = "sh -c 'echo $$$$ >>ids; exec sleep 600'"
    more = f"a:\n\t@timeout 600 {grouped}\nb:\n\t@timeout 600 {grouped} & {deaf}\n"
    process = rings({"c": (0, 0)}, "a", "c", "--", "b", more=more)
    ids = tmp_path / "ids"
    end = time.monotonic() + 300
    while not ids.exists() or len(ids.read_text().split()) < 3:
        assert time.monotonic() < end
        time.sleep(0.05)
    process.send_signal(number)
    message = process.communicate(timeout=300)[0]
    assert process.returncode == 130 and "rings: stopped" in message and "c begins" not in message, message
    assert not [number for number in ids.read_text().split() if alive(int(number))]


def alive(process):
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return Path(f"/proc/{process}/stat").exists() and ") Z " not in Path(f"/proc/{process}/stat").read_text()
