# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cures there are, in one table: ``compare`` puts each of them into its columns.

To add one: a line in CURES. It makes the cure (see :mod:`.compare`) for what ``job.make`` has made, so it has the settings at
hand. A cure that divides blocks starts from :func:`~.compare.solved`; one that leads the tool axes is made by :func:`leading`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.cl.cl_path import CLPath
from freecad_fiveaxis.core.cl.coedge import OffsetPath
from freecad_fiveaxis.core.corrections.deform import deform_axes
from freecad_fiveaxis.core.corrections.linearize import linearize
from freecad_fiveaxis.core.corrections.minimax import minimax_axes
from freecad_fiveaxis.core.jobs.job import Milled, Posted, linked
from freecad_fiveaxis.core.jobs.options import driven_to_hub
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.joint_path import JointPath

from .compare import Cure, Station, solved

Lead = Callable[[OffsetPath, Floats, Chain, Progress], Floats]
"""From the rows of the passes, their tool axes (n, 3) and a machine to better axes (n, 3)."""


def dividing(made: Posted) -> Cure:
    """The cure that divides feed blocks over tolerance into the fewest that hold it."""

    def cure(path: CLPath, where: Station, progress: Progress) -> JointPath:
        joints = solved(path, where, progress)
        return linearize(joints, where.kinematics, where.posting.dialect, made.settings.proof.tolerance, None, progress)

    return cure


def known_cures(names: Sequence[str] = ()) -> tuple[str, ...]:
    """These names; without any, all there are. Raises SettingsError for a name that is not known."""
    for name in names:
        if name not in CURES:
            raise SettingsError(say("unknown correction {name}; known: {cures}", name=repr(name), cures=", ".join(CURES)), name)
    return tuple(names) or tuple(CURES)


def cures(made: Posted, names: Sequence[str] = ()) -> dict[str, Cure]:
    """The cures of these names (without any: all) for what was made. Raises SettingsError for a name that is not known."""
    return {name: CURES[name](made) for name in known_cures(names)}


def leading(made: Posted, lead: Lead) -> Cure:
    """A cure that gives the rows of the passes other tool axes; what is cut stays. It needs a path that was made from a solid."""

    def cure(path: CLPath, where: Station, progress: Progress) -> JointPath:
        if not isinstance(made, Milled):
            text = say("this correction turns the tool axes over the part's facets; give it the STL, not a CL file")
            raise SettingsError(text, made.settings.source)
        axis = lead(made.offset, made.axis, where.kinematics, progress)
        return solved(linked(made.settings, made.offset, axis, made.mesh, progress), where, progress)

    return cure


def _to_least_deviation(made: Posted) -> Cure:
    tool, feed, distance = made.settings.tool_axis, made.settings.feeds.feed, driven_to_hub(made.settings)
    ring = made.settings.cutter.cutter.ring
    return leading(
        made,
        lambda offset, axis, kinematics, progress: minimax_axes(
            offset, axis, kinematics, distance, tool.max_tilt, feed, progress, ring
        ),
    )


def _past_pole(made: Posted) -> Cure:
    change = made.settings.cure.max_axis_change
    return leading(made, lambda offset, axis, kinematics, progress: deform_axes(offset, axis, kinematics, change, progress)[0])


CURES: Mapping[str, Callable[[Posted], Cure]] = {
    "none": lambda made: solved,
    "linearize": dividing,
    "minimax": _to_least_deviation,
    "deform": _past_pole,
}
