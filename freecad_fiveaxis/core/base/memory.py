# SPDX-License-Identifier: LGPL-2.1-or-later
"""Memory of a process that does one job and ends: what it keeps, and what it may take.

The pipeline makes and drops columns of some ten megabytes. glibc gives each of them back to the system at
once and asks for it anew, which on a virtual machine costs more than the work on it. A process that ends with
its job keeps them instead, in one arena for all threads: what a second one had freed would be of no use to
the first.

Work that cannot end says so before it begins: what it needs at least is estimated, and held against what is
free.
"""

from __future__ import annotations

import ctypes
import re
import sys
from contextlib import suppress
from pathlib import Path

from .errors import SettingsError
from .sentences import Number, say

GIGA = 1e9
"""Bytes."""

_TRIM_THRESHOLD, _MMAP_THRESHOLD, _ARENA_MAX = -1, -3, -8
"""Names of glibc's mallopt(3)."""
_NEVER = 2**31 - 1


def keep_freed_memory() -> bool:
    """Let this process reuse what it has freed; for a command line, not for a library. False where that is
    not on offer."""
    if not sys.platform.startswith("linux"):
        return False
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
    if mallopt is None:  # another C library
        return False
    return bool(
        mallopt(_MMAP_THRESHOLD, _NEVER) and mallopt(_TRIM_THRESHOLD, _NEVER) and mallopt(_ARENA_MAX, 1)
    )


def free_memory() -> float:
    """Bytes that this process can still take: what the system has free, and what the process's own limit
    leaves of addresses; infinite where neither is known."""
    return min(_of_system(), _of_limit())


def check_memory(needed: float, what: str, remedy: str) -> None:
    """Raise SettingsError where ``needed`` bytes are more than are free; ``what`` needs them, ``remedy`` is
    what helps."""
    free = free_memory()
    if needed <= free:
        return
    text = say(
        "{what} need at least {needed} GB of memory, and {free} GB are free; {remedy}",
        what=what,
        needed=Number(needed / GIGA, ".2g"),
        free=Number(free / GIGA, ".2g"),
        remedy=remedy,
    )
    raise SettingsError(text, needed)


def _of_system() -> float:
    return _kilobytes("/proc/meminfo", "MemAvailable")


def _of_limit() -> float:
    try:
        import resource
    except ImportError:  # no such limits on Windows
        return float("inf")
    limit = resource.getrlimit(resource.RLIMIT_AS)[0]
    return (
        float("inf")
        if limit == resource.RLIM_INFINITY
        else limit - _kilobytes("/proc/self/status", "VmSize", 0.0)
    )


def _kilobytes(file: str, name: str, unknown: float = float("inf")) -> float:
    """Return what Linux says under this name, bytes."""
    with suppress(OSError):
        found = re.search(
            rf"^{name}:\s+(\d+) kB", Path(file).read_text(encoding="ascii", errors="replace"), re.MULTILINE
        )
        return 1024.0 * int(found[1]) if found else unknown
    return unknown
