# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fuzz for as long as is asked for: ``python tests/fuzz/run.py [--minutes 5] [--seed 1] [TARGET...]``.

Files that are neither taken nor refused go to out/fuzz, each with what was said beside it; exit code 1 where
there is one.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parents[2]), str(Path(__file__).parent)]

from fuzzing import Flaw, hunt  # noqa: E402
from targets import TARGETS  # noqa: E402

OUT = Path(__file__).parents[2] / "out" / "fuzz"
BATCH = 200
"""Runs between two looks at the clock."""


def main() -> int:
    """Every target gets its share of the time."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=5.0, help="for all targets together [5]")
    parser.add_argument(
        "--seed", type=int, default=int(time.time()), help="of the random changes [the clock]"
    )
    parser.add_argument(
        "target", nargs="*", default=sorted(TARGETS), help=f"of {', '.join(sorted(TARGETS))} [all]"
    )
    wanted = parser.parse_args()
    share = 60.0 * wanted.minutes / len(wanted.target)
    return int(sum(_fuzz(name, wanted.seed, share) for name in wanted.target) > 0)


def _fuzz(name: str, seed: int, seconds: float) -> int:
    runs, flaws, end = 0, {}, time.monotonic() + seconds
    with tempfile.TemporaryDirectory() as folder:
        while time.monotonic() < end:
            for flaw in hunt(TARGETS[name], seed + runs, BATCH, Path(folder)):
                runs += 1
                if flaw is not None:
                    flaws.setdefault(flaw.message.strip().split("\n")[-1], flaw)
                if time.monotonic() >= end:
                    break
    for number, flaw in enumerate(flaws.values()):
        _keep(name, number, flaw)
    print(f"{name}: {runs} files, {len(flaws)} kinds of flaws (seed {seed})", flush=True)
    return len(flaws)


def _keep(name: str, number: int, flaw: Flaw) -> None:
    OUT.mkdir(parents=True, exist_ok=True)
    (OUT / f"{name}-{number}{TARGETS[name].ending}").write_bytes(flaw.data)
    (OUT / f"{name}-{number}.said.txt").write_text(flaw.message)


if __name__ == "__main__":
    sys.exit(main())
