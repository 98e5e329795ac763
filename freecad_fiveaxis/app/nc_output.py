# SPDX-License-Identifier: LGPL-2.1-or-later
"""The NC output: which file a toolpath was written to, and whether that file is still what the toolpath
makes.

written      sha256 of the bytes that went into the file, as hexadecimal digits.
up to date   the file holds what was written, and the toolpath still makes just that. The property is set when
             the document recomputes; ``out_of_date`` looks at any time, and says why.
ours         a file that still holds what one of the document's NC outputs wrote. Only such a file, or an
             empty one, is replaced without being asked.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from freecad_fiveaxis.core.base.errors import FileError, FiveAxisError
from freecad_fiveaxis.core.base.files import check_writable, read_bytes, write_all
from freecad_fiveaxis.core.base.sentences import say

from . import results, wording
from .plain_errors import hide_trace
from .properties import QT_TRANSLATE_NOOP, READ_ONLY, RESULT, Property
from .schema import Proxy
from .selection import SelectionError
from .toolpath import Toolpath

PROPERTIES = (
    Property(
        "Path", "App::PropertyLinkGlobal", "NC file",
        QT_TRANSLATE_NOOP("App::Property", "The toolpath that the file is made from"), None, READ_ONLY,
    ),
    Property("File", "App::PropertyFile", "NC file", QT_TRANSLATE_NOOP("App::Property", "The NC file"), "",
        RESULT),
    Property(
        "Written", "App::PropertyString", "NC file",
        QT_TRANSLATE_NOOP("App::Property", "Checksum (sha256) of what was written"), "", RESULT,
    ),
    Property(
        "UpToDate", "App::PropertyBool", "NC file",
        QT_TRANSLATE_NOOP("App::Property", "The file is what the toolpath makes now; if it is not, "
            "post-process again"),
        False, RESULT,
    ),
)  # fmt: skip


class NCOutput(Proxy):
    """The proxy of an NC output. Everything it knows stands in the object's properties."""

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """Those of this kind of object."""
        return PROPERTIES

    @hide_trace
    def execute(self, obj: Any) -> None:
        """See whether the file is still what the toolpath makes. Writes nothing."""
        obj.UpToDate = _is_up_to_date(obj)


def post_process(
    toolpath: Any,
    nc_path: str | os.PathLike[str],
    overwrite: bool = False,
    also: Mapping[str, bytes] | None = None,
) -> Any:
    """Write the toolpath's NC file and what is named ``also`` (its reports), all or none; returns its
    NCOutput object, one for each file.

    An existing file is replaced only if ``overwrite``, if it is empty, or if it still is what was written
    last. Raises FileError for a file that may not be replaced or a folder that cannot be written,
    SelectionError for what is no toolpath, and the core's errors for one that cannot be computed; the file
    then stays as it was.
    """
    if not isinstance(getattr(toolpath, "Proxy", None), Toolpath):
        raise SelectionError(say("only a toolpath can be post-processed: select a toolpath"), toolpath)
    path = Path(nc_path).expanduser().absolute()
    check_replaceable(toolpath.Document, path, overwrite)
    results.renew(toolpath)
    nc = results.nc_of(toolpath)
    write_all({str(path): nc, **(also or {})})
    obj = _output(toolpath, path)
    obj.File, obj.Written, obj.UpToDate = str(path), _digest(nc), True
    obj.purgeTouched()
    return obj


def check_replaceable(doc: Any, nc_path: str | os.PathLike[str], overwrite: bool = False) -> None:
    """Before the long work: the file can be written, and replaces nothing of the user's unasked. Raises
    FileError."""
    check_writable(nc_path)
    if not overwrite and os.path.lexists(nc_path) and not is_ours(doc, nc_path):
        raise FileError(
            say("{nc_path} exists; choose another name, or ask for it to be overwritten", nc_path=nc_path),
            nc_path,
        )


def is_ours(doc: Any, nc_path: str | os.PathLike[str]) -> bool:
    """Whether the file is empty, or still is what one of the document's NC outputs wrote. Raises FileError
    for no such file."""
    found = read_bytes(nc_path, "NC file")
    return not found or any(
        _same_file(one.File, nc_path) and one.Written == _digest(found) for one in outputs_of(doc)
    )


def out_of_date(obj: Any) -> str:
    """Why the file of an NC output is not what the toolpath makes now, and what helps; an empty text where it
    is.

    Looks at the document as it stands, also where a recompute is due or has failed; computes no toolpath.
    """
    if obj.Path is None:
        return wording.localize(
            say("the toolpath of {label} was deleted; the file stays as it is", label=obj.Label)
        )
    try:
        if not _holds_written(obj):
            return wording.localize(
                say(
                    "{file} was changed by somebody else; post-process to another file, or ask for it to be "
                    "overwritten",
                    file=obj.File,
                )
            )
    except FiveAxisError as error:
        return wording.localize(say("{error}; post-process again", error=error))
    why = results.out_of_date(obj.Path)
    if why or obj.UpToDate:
        return why
    return wording.localize(
        say(
            "{label} has changed since {file} was written; post-process again",
            label=obj.Path.Label,
            file=obj.File,
        )
    )


def _output(toolpath: Any, path: Path) -> Any:
    """Return the NC output of that toolpath and file; made where there is none."""
    for obj in outputs_of(toolpath.Document):
        if obj.Path is toolpath and _same_file(obj.File, path):
            return obj
    obj = toolpath.Document.addObject("App::FeaturePython", "NCOutput")
    NCOutput(obj)
    obj.Label, obj.Path = path.name, toolpath
    return obj


def outputs_of(doc: Any) -> list[Any]:
    """Return the NC outputs of a document, in its order."""
    return [obj for obj in doc.Objects if isinstance(getattr(obj, "Proxy", None), NCOutput)]


def _is_up_to_date(obj: Any) -> bool:
    if obj.Path is None or not obj.Written:
        return False
    try:
        return _holds_written(obj) and _digest(results.nc_of(obj.Path)) == obj.Written
    except (
        FiveAxisError
    ):  # no such file any more, or a path that cannot be computed: either is said at its own place
        return False


def _holds_written(obj: Any) -> bool:
    return bool(_digest(read_bytes(obj.File, "NC file")) == obj.Written)


def _same_file(one: str | os.PathLike[str], other: str | os.PathLike[str]) -> bool:
    return os.path.realpath(one) == os.path.realpath(other)


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()
