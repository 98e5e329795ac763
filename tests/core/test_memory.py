# SPDX-License-Identifier: LGPL-2.1-or-later
"""A process of its own keeps what it frees, so that the next column costs no new pages."""

import subprocess
import sys

import pytest

FAULTS = """
import resource, sys
import numpy as np
from freecad_fiveaxis.core.memory import keep_freed_memory
if sys.argv[1] == "keep" and not keep_freed_memory():
    sys.exit(3)
np.ones(4_000_000)
before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
for _ in range(8):
    np.ones(4_000_000)
print(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
"""


def new_pages(mode: str) -> int:
    environment = {"NUMPY_MADVISE_HUGEPAGE": "0", "OPENBLAS_NUM_THREADS": "1"}  # small pages: each one counts
    done = subprocess.run([sys.executable, "-c", FAULTS, mode], capture_output=True, text=True, env=environment)
    if done.returncode == 3:
        pytest.skip("this system's C library has no mallopt")
    return int(done.stdout)


def test_a_freed_column_is_used_again() -> None:
    assert new_pages("keep") < new_pages("leave") / 10
