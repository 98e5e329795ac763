# SPDX-License-Identifier: LGPL-2.1-or-later
"""The joints of a comparison's rows, as ``mill`` makes them on each machine with the options of each cure.

kept      what two cures have in common on a machine is made once: contacts with the strategy's tool axes
          where only a correction differs, the CL path where only blocks are divided. So are passes and lifts
          for machines that keep the same facets. Each process keeps its own, what is one machine's of the
          last one only, as long as the draft lives.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from functools import partial
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np

from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.orientation.axis_corrections import AxisCorrection
from freecad_fiveaxis.core.pipeline.avoided import check_keep_off
from freecad_fiveaxis.core.pipeline.build_path import lift_path
from freecad_fiveaxis.core.pipeline.collision_avoidance import (
    check_for_gouges,
    compute_unfinished_share,
    enters_table,
)
from freecad_fiveaxis.core.pipeline.context import MillContext
from freecad_fiveaxis.core.pipeline.fewer_axes import refuse_what_needs_more_axes, suit_tool_axis
from freecad_fiveaxis.core.pipeline.job import begin_mill
from freecad_fiveaxis.core.pipeline.milling import FROM_JOINTS, TO_AXES, TO_PATH, begin, run_stages
from freecad_fiveaxis.core.pipeline.options import axis_corrections, resolve_setup
from freecad_fiveaxis.core.pipeline.programs import MilledProgram, MillSource, PostedProgram
from freecad_fiveaxis.core.pipeline.records import AssignedAxes, LinkedPath, OffsetContacts
from freecad_fiveaxis.core.pipeline.settings import CureSettings, MachineSettings, Settings, check_together
from freecad_fiveaxis.core.pipeline.solve_joints import solve_joints
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .compare import CheckPart, Station, solve_path

Options = Mapping[str, Mapping[str, str]]
"""Fields of the groups of settings, by the groups' names."""


def with_options(settings: Settings, options: Options) -> Settings:
    """Return the settings with other options in them."""
    groups: dict[str, Any] = {
        name: replace(getattr(settings, name), **given) for name, given in options.items()
    }
    named = frozenset(name for given in options.values() for name in given)
    return replace(settings, explicit=settings.explicit | named, **groups)


@dataclass(frozen=True, eq=False)
class AsMilled:
    """A cure of the comparison: the joints that ``mill`` finds for what the ``draft`` was made of, with these
    options more. ``correction``: what leads the tool axes in place of those that the options name."""

    draft: MilledProgram
    options: Options
    correction: AxisCorrection | None = None

    def __call__(self, path: CLPath, where: Station, progress: Progress = silent) -> JointPath:
        """Return the joints of a station. Raises FiveAxisError for what the machine cannot do: first of all
        for an axis of the draft's path that it cannot take up."""
        return self._try(with_options(_base(self.draft), self.options), where, progress)

    def solve_guided(self, where: Station, progress: Progress = silent) -> JointPath | None:
        """Return those that ``mill`` finds where the controller guides the tip; None where that excludes the
        options: blocks are the others' then."""
        settings = with_options(_base(self.draft), self.options)
        if settings.cure.linearize == "on" or settings.cure.singularity == "linearize":
            return None
        return self._try(with_options(settings, {"head": {"rtcp": "angles"}}), where, progress)

    def compute_left_out(self, where: Station, progress: Progress = silent) -> float:
        """Return the share, 0 to 1, of the surface asked for that the program does not cut, because no tool
        axis of the machine or no free one is there."""
        settings = self._on(with_options(_base(self.draft), self.options), where)
        linked, context, reports = self._link(settings, where, progress)
        found = reports + linked.findings + linked.cut.findings + linked.axis_findings + linked.path.findings
        return compute_unfinished_share(found, context.mesh, context.keep)

    def _on(self, settings: Settings, where: Station) -> Settings:
        own = replace(settings, machine=replace(settings.machine, machine=where.name))
        return suit_tool_axis(own, where.machine)

    def _try(self, settings: Settings, where: Station, progress: Progress) -> JointPath:
        settings = self._on(settings, where)
        check_together(settings)
        refuse_what_needs_more_axes(settings, where.machine)
        try:
            return self._solve(settings, where, progress)
        except Cancelled:
            raise
        except FiveAxisError:
            solve_path(self.draft.path, where, progress)
            raise

    def _solve(self, settings: Settings, where: Station, progress: Progress) -> JointPath:
        linked, context, _ = self._link(settings, where, progress)
        if self.correction is not None:  # rings are begun with the stages, not with this
            joints: JointPath = run_stages(FROM_JOINTS[1:], context, solve_joints(context, linked)).joints
            return joints
        own = context.settings
        joints = _find_kept(self.draft, where).find(
            ("joints", own), lambda: run_stages(FROM_JOINTS, context, solve_joints(context, linked)).joints
        )
        return joints

    def _link(
        self, settings: Settings, where: Station, progress: Progress
    ) -> tuple[LinkedPath, MillContext, tuple[Finding, ...]]:
        kept, key = _find_kept(self.draft, where), ("axes", _without_cure(settings))
        begun, reports, assigned = kept.find(key, lambda: self._assign(settings, where, progress))
        dialect = _choose_guide(settings, where.posting.dialect)
        own = replace(begun.settings, cure=settings.cure, head=settings.head)
        context = replace(begun, settings=own, dialect=dialect, progress=progress)
        if self.correction is not None:
            corrected = _correct(self.correction, context, assigned)
            return run_stages(TO_PATH[1:], context, corrected), context, reports
        corrected = kept.find(_key_of_axes(own), lambda: run_stages(TO_PATH[:1], context, assigned))
        stages = [self._lift if one is lift_path else one for one in TO_PATH[1:]]
        path = ("path", _leave_undivided(own))
        return kept.find(path, lambda: run_stages(stages, context, corrected)), context, reports

    def _assign(
        self, settings: Settings, where: Station, progress: Progress
    ) -> tuple[MillContext, tuple[Finding, ...], AssignedAxes]:
        settings, draft = _without_cure(settings), self.draft
        given = draft.given or MillSource(draft.settings, draft.mesh, None, draft.fixtures)
        context, reports = begin_mill(
            settings, where.machine, where.kinematics, where.posting.dialect, given, progress
        )
        passes = self._offset(context)
        return replace(context, progress=silent), reports, run_stages(TO_AXES[2:], context, passes)

    def _offset(self, context: MillContext) -> OffsetContacts:
        """Return the passes and their offset, which depend on the machine only by what facets are kept."""

        def make() -> OffsetContacts:
            offset: OffsetContacts = run_stages(TO_AXES[:2], context, begin(context))
            return offset

        if context.frames is not None:  # each machine has its own
            return make()
        passes: OffsetContacts = _find_shared(self.draft).find(_passes_key(context), make)
        return passes

    def _lift(self, context: MillContext, linked: LinkedPath) -> LinkedPath:
        """Lift the tool out of the part: the same on every machine that has the same path there."""
        key = ("lift", context.settings.head.rtcp, digest_of(linked.path))
        plain = replace(linked, cured=False, entering=0.0)
        lifted: LinkedPath = _find_shared(self.draft).find(key, lambda: lift_path(context, plain))
        cured, entering = linked.cured or lifted.cured, max(linked.entering, lifted.entering)
        return replace(linked, path=lifted.path, cured=cured, entering=entering)


def _base(draft: MilledProgram) -> Settings:
    """Return the settings that the draft was made from."""
    return draft.settings if draft.given is None else draft.given.settings


def _leave_undivided(settings: Settings) -> Settings:
    """Return the settings as far as the CL path depends on them."""
    return replace(settings, cure=replace(settings.cure, linearize="off"))


def _without_cure(settings: Settings) -> Settings:
    """Return the settings as far as contacts and the strategy's axes depend on them."""
    head = replace(settings.head, rtcp="off")
    return replace(settings, cure=CureSettings(), head=head)


def _key_of_axes(settings: Settings) -> tuple[object, ...]:
    """Return the settings as far as corrected axes depend on them: whoever guides the tip."""
    return "corrected", _leave_undivided(with_options(settings, {"head": {"rtcp": "off"}}))


def _choose_guide(settings: Settings, dialect: Dialect) -> Dialect:
    """Return the dialect with the tip guided where that is asked for and the controller can: of others the
    blocks are told as they would be."""
    return dialect.guide_by(settings.head.rtcp) if settings.head.rtcp in dialect.guides else dialect


def _correct(correction: AxisCorrection, context: MillContext, assigned: AssignedAxes) -> AssignedAxes:
    options, progress = axis_corrections(context), context.progress
    axis, _ = correction.axes(assigned.cut, assigned.corrected, context.kinematics, options, progress)
    return replace(assigned, corrected=axis)


def check_against_part(
    draft: PostedProgram, machine: Machine, setup: Setup, dialect: Dialect
) -> CheckPart | None:
    """Return what finds a program's entries on a machine; None where no part is known, or nothing is to be
    looked at."""
    if not isinstance(draft, MilledProgram) or draft.settings.gouge.gouge == "off":
        return None
    context = replace(
        draft.context(silent), machine=machine, kinematics=chain(machine, setup), dialect=dialect
    )
    return partial(_find_entries, context)


def _find_entries(context: MillContext, program: Program, progress: Progress) -> tuple[Finding, ...]:
    context = replace(context, progress=progress)
    check = check_for_gouges(context, program)
    found = () if check is None else check.findings
    return found + enters_table(context, program) + check_keep_off(context, program)


class _Store:
    """What was made, by what it was made with."""

    def __init__(self) -> None:
        self._items: list[tuple[object, Any]] = []

    def find(self, key: object, make: Callable[[], Any]) -> Any:
        """Return what was made under an equal key, else make it."""
        for known, result in self._items:
            if known == key:
                return result
        result = make()
        self.put(key, result)
        return result

    def put(self, key: object, result: object) -> None:
        """Keep what was made under a key."""
        self._items.append((key, result))


class _Kept(_Store):
    """What was made for one machine in one setup."""

    def __init__(self, machine: Machine, setup: Setup) -> None:
        super().__init__()
        self.machine, self.setup = machine, setup


class Seen:
    """Sees what the stages make, and keeps of it what other cures have in common with the draft."""

    def __init__(self) -> None:
        self._records: list[Any] = []
        self._reports: tuple[Finding, ...] = ()
        self._context: MillContext | None = None

    def __call__(self, context: MillContext, record: object) -> None:
        """Take the record of a stage, or what was found before the first one."""
        self._context = context
        if isinstance(record, tuple):
            self._reports = record
        if type(record) in (OffsetContacts, AssignedAxes, LinkedPath):
            self._records.append(record)

    def keep(self, draft: PostedProgram) -> None:
        """Keep it for the machine and the setup of the draft."""
        if self._context is None or not isinstance(draft, MilledProgram):
            return
        kept = _Kept(draft.machine, resolve_setup(draft.settings, draft.machine)[1])
        context = replace(self._context, progress=silent)
        offset = next(one for one in self._records if type(one) is OffsetContacts)
        assigned, corrected, *_ = (one for one in self._records if type(one) is AssignedAxes)
        if context.frames is None:
            _find_shared(draft).put(_passes_key(context), offset)
        kept.put(("axes", _without_cure(_base(draft))), (context, self._reports, assigned))
        kept.put(_key_of_axes(context.settings), corrected)
        kept.put(("path", _leave_undivided(context.settings)), self._records[-1])
        kept.put(("joints", context.settings), draft.joints)
        _ALL[draft] = [kept]


_ALL: WeakKeyDictionary[MilledProgram, list[_Kept]] = WeakKeyDictionary()
_SHARED: WeakKeyDictionary[MilledProgram, _Store] = WeakKeyDictionary()


def forget(draft: PostedProgram) -> None:
    """Let go of what was kept for a draft."""
    if isinstance(draft, MilledProgram):
        _ALL.pop(draft, None)
        _SHARED.pop(draft, None)


def _find_shared(draft: MilledProgram) -> _Store:
    """Return what is kept for all machines."""
    return _SHARED.setdefault(draft, _Store())


def _passes_key(context: MillContext) -> tuple[object, ...]:
    settings = replace(_without_cure(context.settings), machine=MachineSettings())
    return "passes", settings, context.keep.tobytes()


def digest_of(path: CLPath) -> bytes:
    """Return a checksum of the columns of a path."""
    whole = hashlib.sha256()
    for leaf in fields(path):
        column = getattr(path, leaf.name)
        if isinstance(column, np.ndarray):
            whole.update(np.ascontiguousarray(column).tobytes())
    return whole.digest()


def _find_kept(draft: MilledProgram, where: Station) -> _Kept:
    """Return what is kept for a station: of the last machine only, for the pairs come machine by machine."""
    known = _ALL.get(draft, [])
    for kept in known:
        if kept.machine == where.machine and kept.setup == where.setup:
            return kept
    kept = _Kept(where.machine, where.setup)
    _ALL[draft] = [kept]
    return kept
