# SPDX-License-Identifier: LGPL-2.1-or-later
"""What would finish more of the part of a Toolpath: other settings, tried before they are advised."""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.advice import SHARE, Trial, report_advice, try_others
from freecad_fiveaxis.core.pipeline.programs import Result
from freecad_fiveaxis.core.report.figures import Figures

from . import results, wording
from .long_work import listening, run
from .selection import SelectionError
from .toolpath import Toolpath


def advise(path: Any) -> tuple[Trial, ...]:
    """See :func:`freecad_fiveaxis.app.advise`."""
    if not isinstance(getattr(path, "Proxy", None), Toolpath):
        label = getattr(path, "Label", path)
        raise SelectionError(say("{label} is no tool path: choose one.", label=label), label)
    with listening() as listener:
        result, task = results.result_of(path, listener), path.Proxy.task(path)

        def work(progress: Progress) -> tuple[Trial, ...]:
            mesh, faces = task.mesh_and_mask(progress)

            def make(settings: Any) -> Result:
                draft = job.make(settings, progress, mesh=mesh, faces=faces, fixtures=result.draft.fixtures)
                return job.prove(draft, progress)

            return try_others(result, make)

        return run(work, listener, path.Document)


def leaves_something(figures: Figures) -> bool:
    """Tell whether a result leaves so much unfinished that trials are worth their time."""
    return figures.unfinished >= SHARE


def tell_advice(path: Any, trials: tuple[Trial, ...]) -> str:
    """Say which of the trials finishes most more, or that none does, in the user's language."""
    seconds = float(results.result_of(path).draft.program.seconds.sum())
    return wording.localize(report_advice(trials, seconds).text)
