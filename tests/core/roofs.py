# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small parts for a batch, and executors that do not keep their word."""

import os
import pickle
from concurrent.futures import BrokenExecutor, Executor, Future
from unittest.mock import patch

import numpy as np
from dying import die_first

from freecad_fiveaxis.core.batch import plan, work
from freecad_fiveaxis.core.batch.crews import work_in_crew
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl

WAY = {
    "machine": "trunnion_ac",
    "passes": "planes",
    "tool_axis": "facet_mean",
    "stepover": 9,
    "linearize": "off",
    "gouge": "off",
    "tolerance": 10,
}


def write_roof(path, peak=16.0):
    """A gable roof on a block, 40 x 30 mm."""
    low = [(0, 0, 0), (40, 0, 0), (40, 30, 0), (0, 30, 0)]
    high = [(0, 0, 10), (40, 0, 10), (40, 30, 10), (0, 30, 10), (20, 0, peak), (20, 30, peak)]
    v = np.array(low + high, float) - (20, 15, 0)
    faces = [(0, 2, 1), (0, 3, 2), (0, 1, 5), (0, 5, 8), (0, 8, 4), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 9), (2, 9, 6),
             (3, 0, 4), (3, 4, 7), (5, 6, 9), (5, 9, 8), (4, 8, 9), (4, 9, 7)]  # fmt: skip
    write_stl(from_triangles(v[np.array(faces)]), path)


def blank_pages():
    """A context in which pages are blank: a page with its plots is nearly all that such a small job takes,
    and who does the jobs does not depend on it."""
    return patch.object(work, "as_html", lambda figures, progress: "<html></html>")


class Inline(Executor):
    """Does each job as it is given."""

    def submit(self, work, /, *given, **named):
        future = Future()
        future.set_result(work(*given, **named))
        return future


class Swapping(Inline):
    """Gives the second job what came of the first."""

    def __init__(self):
        self.first = None

    def submit(self, work, /, *given, **named):
        future = super().submit(work, *given, **named)
        self.first = self.first or future
        return self.first


class Forgetting(Inline):
    """Does a job, and gives nothing back."""

    def submit(self, work, /, *given, **named):
        super().submit(work, *given, **named)
        future = Future()
        future.set_result(None)
        return future


class Dropping(Inline):
    """Gives up every job but the first."""

    def __init__(self):
        self.count = 0

    def submit(self, work, /, *given, **named):
        self.count += 1
        if self.count == 1:
            return super().submit(work, *given, **named)
        future = Future()
        future.cancel()
        future.set_running_or_notify_cancel()
        return future


def work_with_blank_pages(job):
    """What a worker does whose pages nobody reads."""
    with blank_pages():
        return work_in_crew(job)


class Dying(Inline):
    """A pool that the job named b breaks."""

    broken = False

    def submit(self, work, /, job):
        self.broken = self.broken or os.path.basename(job.stem) == "b"
        if not self.broken:
            return super().submit(work, job)
        future = Future()
        future.set_exception(BrokenExecutor("dead"))
        return future


class Killing(Executor):
    """A pool with a worker that is killed in the second task, the first time that it is given; without a
    ``mark``, each time."""

    def __init__(self, pool, mark=""):
        self.pool, self.mark, self.count = pool, mark, 0

    def submit(self, work, /, *given):
        self.count += 1
        if self.count != 2:
            return self.pool.submit(work, *given)
        return self.pool.submit(die_first, self.mark, pickle.dumps((work, given)))


class Instead(Executor):
    """A pool whose workers do something else with a job than what they are asked for."""

    def __init__(self, pool, instead, *more):
        self.pool, self.instead, self.more = pool, instead, more

    def submit(self, work, /, job):
        return self.pool.submit(self.instead, job, *self.more)

    def shutdown(self, wait=True, **more):
        self.pool.shutdown(wait, **more)


class Kept(Instead):
    """And who has it does not end the pool: others use it too."""

    def shutdown(self, wait=True, **more):
        pass


def write_parts(folder):
    """Three parts in a folder, the last of which is none."""
    write_roof(folder / "a.stl")
    write_roof(folder / "b.stl", 18.0)
    (folder / "c.stl").write_text("solid nothing\nendsolid\n")
    return folder


def jobs_of(parts, out):
    out.mkdir(exist_ok=True)
    return plan.read_jobs(str(parts), WAY, str(out))


def contents(folder):
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}
