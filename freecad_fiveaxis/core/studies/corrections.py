# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cures there are, in one table: ``compare`` puts each of them into its columns.

To add one: a line in CURES. It makes the cure (see :mod:`.compare`) for what ``job.make`` has made, so it has
the settings at hand. Those that ``mill`` has as options make its program anew with these (:mod:`.as_milled`);
a cure that divides blocks otherwise starts from :func:`~.compare.solve_path`, one that leads the tool axes
otherwise is a correction as those of ``core.orientation.axis_corrections``. A cure is a function of a module
with what it needs put in first (``partial``), so that it can be sent to another process.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.linearize import linearize
from freecad_fiveaxis.core.orientation.axis_corrections import AxisCorrection
from freecad_fiveaxis.core.pipeline.programs import MilledProgram, PostedProgram
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .as_milled import AsMilled
from .compare import Cure, Station, solve_path


def dividing(draft: PostedProgram) -> Cure:
    """Return the cure that divides feed blocks over tolerance into the fewest that hold it."""
    if isinstance(draft, MilledProgram):
        return AsMilled(draft, {"cure": {"linearize": "on"}})
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
    if isinstance(draft, MilledProgram):
        return AsMilled(draft, {}, correction)
    return partial(_refuse_leading, draft.settings.source)


def driving(draft: PostedProgram) -> Cure:
    """Return the cure that is none: the joints as the pipeline finds them."""
    return AsMilled(draft, {}) if isinstance(draft, MilledProgram) else solve_path


def choosing(group: str, option: str, value: str, draft: PostedProgram) -> Cure:
    """Return the cure that ``mill`` has as an option which leads the tool axes."""
    if isinstance(draft, MilledProgram):
        return AsMilled(draft, {group: {option: value}})
    return partial(_refuse_leading, draft.settings.source)


def _refuse_leading(source: str, path: CLPath, where: Station, progress: Progress) -> JointPath:
    text = say("this correction turns the tool axes over the part's facets; give it the STL, not a CL file")
    raise SettingsError(text, source)


CURES: Mapping[str, Callable[[PostedProgram], Cure]] = {
    "none": driving,
    "linearize": dividing,
    "minimax": partial(choosing, "tool_axis", "tool_axis", "minimax"),
    "auto": partial(choosing, "tool_axis", "tool_axis", "auto"),
    "deform": partial(choosing, "cure", "singularity", "deform"),
}
