# SPDX-License-Identifier: LGPL-2.1-or-later
"""Workers that are killed at their work. Nothing of the core is imported here before its time: who dies needs
none of it, and each worker that dies has another after it."""

import os
import pickle
import signal


def die():
    os.kill(os.getpid(), getattr(signal, "SIGKILL", signal.SIGTERM))


def die_first(mark, packed):
    """What a worker does that is killed in the first task of this kind: it leaves ``mark`` behind. ``packed``:
    the task, of which one that dies reads nothing."""
    if not mark:
        die()
    if not os.path.exists(mark):
        with open(mark, "w", encoding="utf-8"):
            pass
        die()
    work, given = pickle.loads(packed)
    return work(*given)


def _work_with_blank_pages(job):
    from roofs import work_with_blank_pages

    return work_with_blank_pages(job)


def die_once(job, mark):
    """What a worker does that is killed in its first job named b."""
    if os.path.basename(job.stem) == "b":
        return die_first(mark, pickle.dumps((_work_with_blank_pages, (job,))))
    return _work_with_blank_pages(job)


def die_always(job):
    """A job that no process survives."""
    if os.path.basename(job.stem) == "b":
        die()
    return _work_with_blank_pages(job)
