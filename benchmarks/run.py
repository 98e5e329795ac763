# SPDX-License-Identifier: LGPL-2.1-or-later
"""``make bench``: every benchmark of this folder, one after the other; each prints its ratios to peers in the
same run."""

import runpy
import sys
from pathlib import Path

HERE = Path(__file__).parent


def main(names):
    """Run the named benchmarks (``slicing`` for bench_slicing.py), or all."""
    sys.path[:0] = [str(HERE), str(HERE.parent)]
    sys.argv[1:] = []  # a benchmark's own arguments are for when it is run alone
    for path in sorted(HERE.glob("bench_*.py")):
        if not names or path.stem.removeprefix("bench_") in names:
            print(f"\n== {path.stem.removeprefix('bench_')} ==", flush=True)
            runpy.run_path(str(path), run_name="__main__")


if __name__ == "__main__":
    main(list(sys.argv[1:]))
