#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tries mutants of the package: one line of a copy is changed, and tests that are named with it must fail.

    make mutants                   eight of tests/mutation/mutants.toml, others every day
    make mutants ALL=1             all of them; N=20: so many; SEED=7: those of that seed; FILE=search.py:
                                   those of such files
    python tests/mutation/mutate.py --table MY.toml --root FOLDER

killed       a named test fails, or none can be collected, or the limit is over (said so: a mutant may hang)
survived     all pass: a test is missing
no longer    the old text does not occur exactly once in its file: the table is to be mended
equivalent   argued in the table, so not tried; its text must still be there

Exit 0 if all that were tried are killed, 1 if not, or where the tests fail without any change; 130 after
Ctrl-C.
"""

from __future__ import annotations

import argparse
import contextlib
import datetime
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import tomllib

ROOT = Path(__file__).resolve().parents[2]
LEFT_OUT = shutil.ignore_patterns(
    ".git", ".venv", ".cache", "out", "build", "*.egg-info", "__pycache__", ".*_cache", ".hypothesis"
)
SAMPLE = 8
LIMIT = 180.0
"""s of the clock that the tests of one mutant may take."""
HUNG = -1
"""Instead of pytest's exit code: the limit was over."""


@dataclass(frozen=True)
class Mutant:
    """``old``, which occurs once in ``file``, becomes ``new``; ``tests`` are words for pytest.
    ``equivalent``: why no test can tell."""

    file: str
    old: str
    new: str
    tests: tuple[str, ...] = ()
    equivalent: str = ""

    def __str__(self) -> str:
        return f"{self.file}: {_on_one_line(self.old)}  ->  {_on_one_line(self.new)}"


def _on_one_line(text: str) -> str:
    return " ".join(text.split()) or "(nothing)"


def read_table(path: Path) -> list[Mutant]:
    """Read the mutants of a table."""
    rows = tomllib.loads(path.read_text(encoding="utf-8"))["mutant"]
    return [Mutant(**{**row, "tests": tuple(row.get("tests", ()))}) for row in rows]


def choose(mutants: list[Mutant], count: int | None, seed: str, part: str) -> list[Mutant]:
    """Choose those whose file holds ``part``, and of them a sample, in the table's order; without a count
    all."""
    fitting = [mutant for mutant in mutants if part in mutant.file]
    if count is None or count >= len(fitting):
        return fitting
    chosen = set(random.Random(seed).sample(range(len(fitting)), count))
    return [mutant for place, mutant in enumerate(fitting) if place in chosen]


def run_tests(folder: Path, tests: tuple[str, ...], limit: float) -> tuple[int, str]:
    """Run pytest in ``folder``, with everything it begins in a group of its own: its exit code or HUNG, and
    its last lines."""
    words = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", *tests]
    environment = {**os.environ, "PYTHONPATH": str(folder), "FIVEAXIS_SLOWEST": "1"}
    with open(folder / "pytest.log", "w+", encoding="utf-8") as log:
        process = subprocess.Popen(
            words, cwd=folder, env=environment, stdout=log, stderr=log, start_new_session=True
        )
        try:
            code = process.wait(limit)
        except subprocess.TimeoutExpired:
            code = HUNG
        finally:
            end_group(process)
        log.seek(0)
        return code, "".join(log.readlines()[-15:])


def end_group(process: subprocess.Popen[bytes]) -> None:
    """End a process and what it has begun, also after Ctrl-C."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


class Bench:
    """A copy of the project in which one file at a time is changed; the tests named were seen to pass in it
    unchanged."""

    def __init__(self, root: Path, folder: Path, limit: float) -> None:
        self.folder, self.limit = folder / "copy", limit
        self._passes: dict[tuple[str, ...], str] = {}
        shutil.copytree(root, self.folder, ignore=LEFT_OUT, symlinks=True)

    def try_one(self, mutant: Mutant) -> tuple[bool, str]:
        """Whether all is well with a mutant, and what came of it in a few words."""
        path = self.folder / mutant.file
        text = path.read_text(encoding="utf-8") if path.is_file() else ""
        if text.count(mutant.old) != 1:
            return False, f"no longer applies: its old text occurs {text.count(mutant.old)} times"
        if mutant.equivalent:
            return True, f"equivalent: {_on_one_line(mutant.equivalent)}"
        trouble = self._trouble_unchanged(mutant.tests)
        if trouble:
            return False, f"its tests do not pass without it:\n{trouble}"
        self._write(path, text.replace(mutant.old, mutant.new))
        try:
            code, _ = run_tests(self.folder, mutant.tests, self.limit)
        finally:
            self._write(path, text)
        if code == HUNG:
            return True, f"killed by the limit of {self.limit:g} s"
        return code != 0, "SURVIVED" if code == 0 else "killed"

    def _trouble_unchanged(self, tests: tuple[str, ...]) -> str:
        """The last lines of these tests on the unchanged copy, where they do not pass; run once."""
        if tests not in self._passes:
            code, lines = run_tests(self.folder, tests, self.limit) if tests else (1, "no tests are named")
            self._passes[tests] = "" if code == 0 else lines or f"pytest ended with {code}"
        return self._passes[tests]

    def _write(self, path: Path, text: str) -> None:
        """Write a source file; what Python has compiled of it goes, for it may look as old and as long as the
        new one."""
        path.write_text(text, encoding="utf-8")
        for compiled in (path.parent / "__pycache__").glob(f"{path.stem}.*"):
            compiled.unlink()


def try_all(mutants: list[Mutant], root: Path, limit: float) -> int:
    """Try these mutants, a line each, and count those with which not all is well."""
    failed = 0
    with tempfile.TemporaryDirectory(prefix="mutants-") as folder:
        bench = Bench(root, Path(folder), limit)
        for mutant in mutants:
            begin = time.monotonic()
            well, words = bench.try_one(mutant)
            failed += not well
            print(f"{words} ({time.monotonic() - begin:.0f} s): {mutant}", flush=True)
    return failed


def parse(words: list[str] | None) -> argparse.Namespace:
    """Parse the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--table", type=Path, default=Path(__file__).with_name("mutants.toml"))
    parser.add_argument("--root", type=Path, default=ROOT, help="the project that is copied")
    parser.add_argument("--count", type=int, default=SAMPLE, help=f"how many are tried ({SAMPLE})")
    parser.add_argument("--all", action="store_true", help="try every one")
    parser.add_argument(
        "--seed", default=datetime.date.today().isoformat(), help="of the sample (today's date)"
    )
    parser.add_argument("--file", default="", help="only mutants of files whose path holds this")
    parser.add_argument(
        "--limit", type=float, default=LIMIT, help=f"s that the tests of one may take ({LIMIT:g})"
    )
    return parser.parse_args(words)


def main(words: list[str] | None = None) -> int:
    """Try what the command line asks for."""
    given = parse(words)
    mutants = choose(read_table(given.table), None if given.all else given.count, given.seed, given.file)
    try:
        failed = try_all(mutants, given.root, given.limit)
    except KeyboardInterrupt:
        print("mutants: interrupted; the copy is removed, the work tree was never changed", file=sys.stderr)
        return 130
    print(
        f"mutants: {len(mutants)} tried, {failed} of them not as they should be"
        + ("" if given.all else f" (seed {given.seed})")
    )
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
