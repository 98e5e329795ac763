# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cures there are, in one table: ``compare`` puts each of them into its columns.

To add one: a line in CURES. It makes the cure (see :mod:`.compare`) for what ``job.make`` has made, so it has
the settings at hand. A cure that divides blocks starts from :func:`~.compare.solve_path`; those that turn the
tool axes are the corrections of ``core.orientation.axis_corrections``. A cure is a function of a module with
what it needs put in first (``partial``), so that it can be sent to another process.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.linearize import linearize
from freecad_fiveaxis.core.orientation.axis_corrections import AXIS_CORRECTIONS, AxisCorrection
from freecad_fiveaxis.core.pipeline.build_path import lift_rows, link_contacts
from freecad_fiveaxis.core.pipeline.options import axis_corrections
from freecad_fiveaxis.core.pipeline.programs import MilledProgram, PostedProgram
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .compare import Cure, Station, solve_path


def dividing(draft: PostedProgram) -> Cure:
    """Return the cure that divides feed blocks over tolerance into the fewest that hold it."""
    return partial(_divide_blocks, draft.settings.proof.tolerance)


def _divide_blocks(tolerance: float, path: CLPath, where: Station, progress: Progress) -> JointPath:
    joints, posting = solve_path(path, where, progress), where.posting
    return linearize(joints, where.kinematics, posting.dialect, tolerance, None, progress, posting.above)


def check_cures(names: Sequence[str] = ()) -> tuple[str, ...]:
    """Return these names; without any, all there are. Raises SettingsError for a name that is not known."""
    for name in names:
        if name not in CURES:
            raise SettingsError(
                say("unknown correction {name}; known: {cures}", name=repr(name), cures=", ".join(CURES)),
                name,
            )
    return tuple(names) or tuple(CURES)


def cures(draft: PostedProgram, names: Sequence[str] = ()) -> dict[str, Cure]:
    """Return the cures of these names (without any: all) for what was made. Raises SettingsError for a name
    that is not known."""
    return {name: CURES[name](draft) for name in check_cures(names)}


def leading(correction: AxisCorrection, draft: PostedProgram) -> Cure:
    """Return the cure that gives the rows of the passes the corrected axes; what is cut stays. It needs a
    path that was made from a solid."""
    return partial(_correct_axes, correction, draft)


def _correct_axes(
    correction: AxisCorrection, draft: PostedProgram, path: CLPath, where: Station, progress: Progress
) -> JointPath:
    if not isinstance(draft, MilledProgram):
        text = say(
            "this correction turns the tool axes over the part's facets; give it the STL, not a CL file"
        )
        raise SettingsError(text, draft.settings.source)
    context = draft.context(progress)
    options = axis_corrections(context)
    offset, given = correction.rows(draft.offset, draft.axis, options)
    axis, _ = correction.axes(offset, given, where.kinematics, options, progress)
    linked = link_contacts(context, offset, axis)
    lifts = draft.fixtures and draft.settings.gouge.gouge in ("lift", "tilt")
    return solve_path(lift_rows(context, linked).path if lifts else linked, where, progress)


CURES: Mapping[str, Callable[[PostedProgram], Cure]] = {
    "none": lambda draft: solve_path,
    "linearize": dividing,
    **{name: partial(leading, correction) for name, correction in AXIS_CORRECTIONS.items()},
}
