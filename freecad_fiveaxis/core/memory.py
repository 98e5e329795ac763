# SPDX-License-Identifier: LGPL-2.1-or-later
"""Memory of a process that does one job and ends.

The street makes and drops columns of some ten megabytes. glibc gives each of them back to the system at once and asks for it
anew, which on a virtual machine costs more than the work on it. A process that ends with its job keeps them instead, in one arena
for all threads: what a second one had freed would be of no use to the first.
"""

from __future__ import annotations

import ctypes
import sys

_TRIM_THRESHOLD, _MMAP_THRESHOLD, _ARENA_MAX = -1, -3, -8
"""Names of glibc's mallopt(3)."""
_NEVER = 2**31 - 1


def keep_freed_memory() -> bool:
    """Let this process reuse what it has freed; for a command line, not for a library. False where that is not on offer."""
    if not sys.platform.startswith("linux"):
        return False
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
    if mallopt is None:  # another C library
        return False
    return bool(mallopt(_MMAP_THRESHOLD, _NEVER) and mallopt(_TRIM_THRESHOLD, _NEVER) and mallopt(_ARENA_MAX, 1))
