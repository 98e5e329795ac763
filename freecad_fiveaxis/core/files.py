# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files in and out: whole or not at all, and an error that names the file and the remedy."""

from __future__ import annotations

import contextlib
import os
import tempfile
from pathlib import Path

from .errors import FileError


def read_bytes(path: str | os.PathLike[str], what: str) -> bytes:
    """The whole file. Raises FileError that says what is missing or unreadable."""
    try:
        return Path(path).read_bytes()
    except OSError as error:
        raise FileError(f"{what} {os.fspath(path)} cannot be read: {error.strerror or error}", path) from error


def write_whole(path: str | os.PathLike[str], data: bytes) -> None:
    """Write beside, then rename: nobody ever sees half a file. Raises FileError; an old file then stays as it was."""
    target = Path(path)
    part = None
    try:
        handle, part = tempfile.mkstemp(prefix=target.name, suffix=".part", dir=target.parent)
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
        os.chmod(part, 0o666 & ~_umask())  # mkstemp makes files for the owner alone; the result is an ordinary file
        os.replace(part, target)
    except OSError as error:
        if part is not None:
            with contextlib.suppress(FileNotFoundError):
                os.unlink(part)
        raise FileError(f"{target} cannot be written: {error.strerror or error}; choose another folder", path) from error


def check_writable(path: str | os.PathLike[str]) -> None:
    """Fail early, before the long work, where a result could not be written. Raises FileError."""
    folder = Path(path).parent
    if Path(path).is_dir():
        raise FileError(f"{path} is a folder; name a file", path)
    if not folder.is_dir():
        raise FileError(f"folder {folder} does not exist; make it first", path)
    try:
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise FileError(f"folder {folder} cannot be written: {error.strerror or error}; choose another one", path) from error


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
