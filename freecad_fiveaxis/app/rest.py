# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of rest material: what a toolpath's cutter leaves on the machined surface, and where it takes too
much.

height     of a place of the surface: how far the cutter stays away from it all along its real way, mm; below
           0 it cuts too deep.
uncut      more is left there than the passes are meant to leave: ``Allowed``, which is twice the scallop and
           the tolerance.

Where the toolpath itself is asked for the map (its property ``Left``), the map is the toolpath's; else it is
looked for here, and the toolpath stays as it is. The heights are arrays and not saved: after a document was
opened they are found again when drawn.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, cast

from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import Area, Length, join_sentences, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge import RestMaterial
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.collision_avoidance import compute_allowed_rest
from freecad_fiveaxis.core.pipeline.programs import MilledProgram
from freecad_fiveaxis.core.report import Figures

from . import results, wording
from .labels import translate
from .long_work import as_before, listening, run, take_back
from .plain_errors import hide_trace
from .properties import FINGERPRINT, QT_TRANSLATE_NOOP, READ_ONLY, RESULT, Property
from .schema import Proxy
from .selection import SelectionError
from .toolpath import Toolpath

PROPERTIES = (
    Property(
        "Path", "App::PropertyLinkGlobal", "Base",
        QT_TRANSLATE_NOOP("App::Property", "The toolpath whose cutter leaves what the map shows"), None,
        READ_ONLY,
    ),
    Property(
        "LargestUndercut", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Most that is left on the machined surface"), 0.0, RESULT,
    ),
    Property(
        "LargestOvercut", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Deepest that the cutter goes below the machined surface"), 0.0,
        RESULT,
    ),
    Property(
        "UncutArea", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Machined surface on which more is left than is allowed"), 0.0,
        RESULT,
    ),
    Property(
        "OvercutArea", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Machined surface that is cut too deep by more than the "
            "tolerance"), 0.0, RESULT,
    ),
    Property(
        "MachinedArea", "App::PropertyArea", "Result",
        QT_TRANSLATE_NOOP("App::Property", "The machined surface: what the map covers"), 0.0, RESULT,
    ),
    Property(
        "UncutVolume", "App::PropertyVolume", "Result",
        QT_TRANSLATE_NOOP("App::Property", "What is left beyond what is allowed"), 0.0, RESULT,
    ),
    Property(
        "Allowed", "App::PropertyLength", "Result",
        QT_TRANSLATE_NOOP("App::Property", "So much may be left: twice the scallop, and the tolerance"), 0.0,
        RESULT,
    ),
    Property(
        "Verdict", "App::PropertyString", "Result",
        QT_TRANSLATE_NOOP("App::Property", "What is left, in a plain sentence"), "", RESULT,
    ),
    Property(
        "UpToDate", "App::PropertyBool", "Result",
        QT_TRANSLATE_NOOP("App::Property", "The map is of the toolpath as it is now"), False, RESULT,
    ),
    FINGERPRINT,
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Heights:
    """What a map is drawn from, work frame: the heights ``rest`` over the facets of ``mesh``; mm that are
    ``allowed`` to be left, and the ``tolerance`` of the other side. ``fingerprint``: that of the toolpath
    they are of."""

    fingerprint: str
    mesh: Mesh
    rest: RestMaterial
    tolerance: float
    allowed: float

    @property
    def left(self) -> RestMaterial:
        """The heights under the name that macros of earlier versions have for them."""
        return self.rest


class RestMap(Proxy):
    """What the proxy of a map of rest material does; the one that documents save is
    :class:`.left.LeftMap`."""

    last: Heights | None

    def _begin(self) -> None:
        self.last = None

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """Return the toolpath and the results."""
        return PROPERTIES

    @hide_trace
    def execute(self, obj: Any) -> None:
        """FreeCAD recomputes the object."""
        obj.UpToDate = False
        _show(obj, heights_of(obj))


def of(path: Any) -> Any:
    """Return the map of a toolpath, or None."""
    return next((one for one in path.InList if isinstance(getattr(one, "Proxy", None), RestMap)), None)


def rest_map(path: Any) -> Any:
    """See :func:`freecad_fiveaxis.app.left_map`."""
    _check(path)
    obj, doc = of(path), path.Document
    new = obj is None
    if new:
        from .left import LeftMap  # it is a RestMap, so it is not known before

        obj = doc.addObject("App::FeaturePython", "LeftMap")
        LeftMap(obj)
        obj.Label = translate("FiveAxis", "What is left")
    try:
        with as_before(obj, ()):
            if obj.Path is not path:
                obj.Path = path
            heights_of(obj)  # errors reach the caller; the recompute then finds the work done
        obj.touch()
        doc.recompute([obj])
    except BaseException:
        if new:
            take_back(doc, obj)
        raise
    return obj


def _check(path: Any) -> None:
    if not isinstance(getattr(path, "Proxy", None), Toolpath):
        raise SelectionError(say("what is left is known of a toolpath only: select a toolpath"), path)


def heights_of(obj: Any, progress: Progress | None = None) -> Heights:
    """Return the heights of a map, found anew only where its toolpath has changed.

    Raises FiveAxisError, as SelectionError where the toolpath was deleted; Cancelled where the listener stops
    the work.
    """
    if obj.Path is None:
        raise SelectionError(
            say("The toolpath of {label} was deleted: make the map of another one.", label=obj.Label),
            obj.Label,
        )
    with listening(progress) as listener:
        figures, known = results.figures_of(obj.Path, listener), obj.Path.Proxy.last
        if obj.Proxy.last is None or obj.Proxy.last.fingerprint != known.fingerprint:
            obj.Proxy.last = run(
                lambda progress: _compute_heights(figures, known, progress), listener, obj.Document
            )
    last: Heights = obj.Proxy.last
    return last


def _compute_heights(figures: Figures, known: results.Last, progress: Progress) -> Heights:
    draft = cast(MilledProgram, known.result.draft)  # of a toolpath
    rest = figures.rest or job.rest_material_of(draft, progress)
    return Heights(
        known.fingerprint,
        draft.mesh,
        rest,
        figures.tolerance,
        compute_allowed_rest(draft.settings, draft.mesh, draft.keep),
    )


def out_of_date(obj: Any) -> str:
    """Why the map does not show what its toolpath leaves now; an empty text where it does."""
    if obj.Path is None:
        return wording.localize(say("The toolpath of {label} was deleted", label=obj.Label))
    if why := results.out_of_date(obj.Path):
        return why
    same = obj.UpToDate and obj.Fingerprint == obj.Path.Fingerprint
    return "" if same else wording.localize(say("{label} is old: recompute the document", label=obj.Label))


def _show(obj: Any, found: Heights) -> None:
    """Show the heights in the object's properties."""
    rest, height = found.rest, found.rest.height
    uncut, volume = rest.uncut(found.allowed)
    values = {
        "LargestUndercut": max(float(height.max(initial=0.0)), 0.0),
        "LargestOvercut": max(float(-height.min(initial=0.0)), 0.0),
        "UncutArea": uncut, "OvercutArea": rest.sum_overcut(found.tolerance)[0],
        "MachinedArea": float(rest.area.sum()),
        "UncutVolume": volume, "Allowed": found.allowed, "Verdict": wording.localize(verdict(found)),
        "Fingerprint": found.fingerprint,
        "UpToDate": True,
    }  # fmt: skip
    for name, value in values.items():
        setattr(obj, name, value)


def verdict(found: Heights) -> str:
    """Say in a plain sentence how much rest material there is, and what is cut too deep."""
    rest = found.rest
    whole, (uncut, _), (deep, _) = (
        float(rest.area.sum()),
        rest.uncut(found.allowed),
        rest.sum_overcut(found.tolerance),
    )
    if not uncut and not deep:
        return say(
            "Of {whole} that are machined, all are cut: no more than {allowed} is left, nothing is cut too "
            "deep.",
            whole=Area(whole, ".4g"),
            allowed=Length(found.allowed, ".3g"),
        )
    parts = []
    if uncut:
        most = Length(float(rest.height.max()), ".4g")
        parts.append(
            say(
                "on {uncut} more than {allowed} is left, at most {most}",
                uncut=Area(uncut, ".3g"),
                allowed=Length(found.allowed, ".3g"),
                most=most,
            )
        )
    if deep:
        most = Length(-float(rest.height.min()), ".4g")
        parts.append(say("{deep} are cut too deep, at most by {most}", deep=Area(deep, ".3g"), most=most))
    return say(
        "Of {whole} that are machined, {parts}.", whole=Area(whole, ".4g"), parts=join_sentences(parts, "; ")
    )
