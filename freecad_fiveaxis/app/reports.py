# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of work that is no program, written in the form that the ending of their file says."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import Any

from freecad_fiveaxis.core.base.errors import FileError
from freecad_fiveaxis.core.base.files import check_writable, write_whole
from freecad_fiveaxis.core.base.sentences import say


def write_report(
    reports: Mapping[str, Callable[[Any], str]], find: Callable[[], Any], file: str | os.PathLike[str],
    overwrite: bool,
) -> None:  # fmt: skip
    """Write what ``find()`` gives, by the function that ``reports`` have for the ending of the file. A file
    that is there is replaced only where asked. Raises FileError."""
    ending = os.path.splitext(os.fspath(file))[1].lower()
    if ending not in reports:
        raise FileError(
            say("{file} needs one of the endings {reports}", file=file, reports=", ".join(reports)), file
        )
    check_writable(file)
    if not overwrite and os.path.lexists(file):
        raise FileError(
            say("{file} exists; choose another name, or ask for it to be overwritten", file=file), file
        )
    write_whole(file, reports[ending](find()).encode("utf-8", "backslashreplace"))
