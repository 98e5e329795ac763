# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bridge to FreeCAD's CAM workbench: a preview that CAM can show, and a CAM Job's model and tool as a
toolpath's settings.

preview   a ``Path::FeaturePython`` with the tip's path over the part, in the document's coordinates: G0 and
          G1 with X Y Z and F. It holds no A, B or C word: FreeCAD would turn the drawing by them, and rightly
          so for one kind of machine only. It shows the way of the tool; it is not what the machine gets.
feed      FreeCAD's CAM keeps it in mm/s. The preview's feed is the speed of the tip along the segment: its
          length over the block's time, so that CAM's cycle time is ours.
Job       the CAM workbench's object that holds model, stock and tools. ``Path.*`` was ``PathScripts.*`` until
          FreeCAD 0.20.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.sentences import join_sentences, say
from freecad_fiveaxis.core.report import Figures
from freecad_fiveaxis.core.tool import kind_of
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from . import results
from .plain_errors import hide_trace
from .properties import QT_TRANSLATE_NOOP, READ_ONLY, Property
from .schema import Proxy
from .selection import SelectionError
from .tool_bit import JobTool, cutters_of_job

FINEST = 1e-6
"""mm; along a segment shorter than this the tip stands still, and its speed says nothing."""

PROPERTIES = (
    Property(
        "Toolpath", "App::PropertyLinkGlobal", "Base",
        QT_TRANSLATE_NOOP("App::Property", "The toolpath that is shown"), None, READ_ONLY,
    ),
)  # fmt: skip


class Preview(Proxy):
    """The proxy of a preview. It follows its toolpath: when that is computed anew, so is the preview."""

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """Those of this kind of object."""
        return PROPERTIES

    @hide_trace
    def execute(self, obj: Any) -> None:
        """Draw the toolpath as it is now. Raises the core's errors where it cannot be computed."""
        if obj.Toolpath is None:
            raise SelectionError(say("the toolpath of this preview is gone; delete the preview"), obj.Label)
        figures, zero = results.figures_of(obj.Toolpath), work_zero(obj.Toolpath)
        obj.Path = path_of(figures, zero)
        _show(obj, (figures.tip[0] + zero).tolist() if len(figures.tip) else ())

    def onDocumentRestored(self, obj: Any) -> None:
        """Show the preview also where the document was made without a window."""
        super().onDocumentRestored(obj)
        if obj.ViewObject is not None and not obj.ViewObject.Proxy:
            _show(obj, obj.Path.Commands[0].Placement.Base if obj.Path.Size else ())


def preview(toolpath: Any) -> Any:
    """Return the toolpath's preview for CAM, a ``Path::FeaturePython``, computed: one for each toolpath,
    renewed when there is one."""
    doc = toolpath.Document
    obj = next((one for one in doc.Objects if _is_preview(one) and one.Toolpath is toolpath), None)
    if obj is None:
        obj = doc.addObject("Path::FeaturePython", "CAMPreview")
        Preview(obj)
        obj.Label, obj.Toolpath = f"{toolpath.Label} (CAM)", toolpath
    obj.Proxy.execute(obj)
    obj.purgeTouched()
    return obj


def _show(obj: Any, start: Sequence[float] = ()) -> None:
    """Have FreeCAD draw the path in its own way: an object with a proxy of ours stays invisible until its
    view has one too.

    Without the ``start`` (3,) mm, document, FreeCAD draws a line to it from the document's origin.
    """
    view = obj.ViewObject
    if view is None:  # no window
        return
    if not view.Proxy:
        view.Proxy = 0
    if len(start):
        view.StartPosition = tuple(start)


def path_of(figures: Figures, zero: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Any:
    """Return the tip's path as a ``Path.Path``, shifted by the work zero (mm, document).

    From commands, not from G-code text: that takes as long (0.2 s for 100k blocks), rounds, and reads 1e-05
    as a word E.
    """
    import Path

    names = np.where(figures.program.motion == Motion.RAPID, "G0", "G1").tolist()
    points = (figures.tip + np.asarray(zero)).tolist()
    feeds, command = tip_feeds(figures).tolist(), Path.Command
    return Path.Path(
        [
            command(name, {"X": x, "Y": y, "Z": z, "F": feed} if name == "G1" else {"X": x, "Y": y, "Z": z})
            for name, (x, y, z), feed in zip(names, points, feeds, strict=True)
        ]
    )


def tip_feeds(figures: Figures) -> np.ndarray:
    """Speed of the tip along the segment of every block (m,), mm/s; where only the tool turns, that of the
    block before."""
    seconds, length = figures.program.seconds, np.zeros(len(figures.tip))
    length[1:] = np.linalg.norm(np.diff(figures.tip, axis=0), axis=1)
    moving = (figures.program.motion != Motion.RAPID) & (seconds > 0.0) & (length > FINEST)
    if not moving.any():
        return np.zeros(len(length))
    last = np.maximum(np.cumsum(moving) - 1, 0)
    return np.asarray((length[moving] / seconds[moving])[last])


def work_zero(obj: Any) -> tuple[float, float, float]:
    """Where the work zero of a toolpath or an audit stands in its document, mm."""
    return tuple(getattr(obj, "WorkZero", (0.0, 0.0, 0.0)))


def job_of(obj: Any) -> Any | None:
    """Return the CAM Job whose model contains the object (or a clone of it, or the body around it); None, or
    the first of several."""
    wanted = {obj, obj.getParentGeoFeatureGroup()} - {None}
    return next(
        (job for job in jobs_of(obj.Document) if any(wanted & _stands_for(one) for one in job.Model.Group)),
        None,
    )


def jobs_of(doc: Any) -> list[Any]:
    """Return the CAM Jobs of a document."""
    return [obj for obj in doc.Objects if _is_job(obj)]


def settings_from_job(job: Any, number: int | None = None) -> tuple[list[Any], dict[str, Any]]:
    """Model and settings for a toolpath, ``(objects, settings)``, from a CAM Job.

    The model is the Job's own clone of the part, because the user may have turned or moved it in the Job. The
    tool is the one of that number, else the first ball end, else the first
    that is of use here. Settings: cutter (a Cutter), tool, and where the Job gives
    them feed and plunge_feed (mm/min) and spindle (1/min). Raises SelectionError for a Job without a model or
    without a tool that is of use here; the message says what is the matter with each.
    """
    model = list(job.Model.Group)
    if not model:
        raise SelectionError(
            say(
                "{label} has no model; add one in the Job's editor, or select the part itself",
                label=job.Label,
            ),
            job.Label,
        )
    tool = _tool(job, number)
    given = {"feed": tool.feed, "plunge_feed": tool.plunge_feed, "spindle": tool.spindle}
    return model, {"cutter": tool.cutter, "tool": tool.number} | {
        name: value for name, value in given.items() if value > 0
    }


def _tool(job: Any, number: int | None) -> JobTool:
    tools = [tool for tool in cutters_of_job(job) if number in (None, tool.number)]
    able = [tool for tool in tools if tool.cutter is not None]
    if able:  # a Job begins with an end mill that nobody has chosen
        return next((tool for tool in able if tool.cutter and kind_of(tool.cutter) == "ball"), able[0])
    if not tools:
        named = say("no tool") if number is None else say("no tool {number}", number=number)
        raise SelectionError(
            say(
                "{label} has {named}; add one to it, or give the cutter by hand", label=job.Label, named=named
            ),
            number,
        )
    raise SelectionError(
        say(
            "{label}: {errors}", label=job.Label, errors=join_sentences((tool.error for tool in tools), "; ")
        ),
        number,
    )


def _is_preview(obj: Any) -> bool:
    return isinstance(getattr(obj, "Proxy", None), Preview)


def _is_job(obj: Any) -> bool:
    """By what it has, not by its class: that has moved between modules, and the CAM workbench need not be
    loaded."""
    return (
        obj.isDerivedFrom("Path::Feature")
        and hasattr(getattr(obj, "Model", None), "Group")
        and hasattr(obj, "Tools")
    )


def _stands_for(model: Any) -> set[Any]:
    """Return the Job's own clone of what the user drew, and what it is a clone of."""
    return {model, *getattr(model, "Objects", ())}
