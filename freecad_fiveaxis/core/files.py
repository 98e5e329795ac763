# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files in and out: whole or not at all, and an error that names the file and the remedy."""

from __future__ import annotations

import contextlib
import os
import stat
import tempfile
from pathlib import Path

from freecad_fiveaxis.core.sentences import say

from .errors import FileError


def is_name(text: str | os.PathLike[str]) -> bool:
    """Whether a file can have that name (or path) at all: no NUL, no character that the system cannot write."""
    try:
        return b"\0" not in os.fsencode(text)
    except UnicodeEncodeError:
        return False


def read_bytes(path: str | os.PathLike[str], what: str) -> bytes:
    """The whole file. Raises FileError that says what is missing or unreadable."""
    _check_name(path)
    try:
        return Path(path).read_bytes()
    except OSError as error:
        raise FileError(
            say("{what} {path} cannot be read: {strerror}", what=what, path=os.fspath(path), strerror=error.strerror or error),
            path,
        ) from error


def write_whole(path: str | os.PathLike[str], data: bytes) -> None:
    """Write beside, then rename: nobody ever sees half a file. Raises FileError; an old file then stays as it was."""
    _check_name(path)
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
        raise FileError(
            say("{target} cannot be written: {strerror}; choose another folder", target=target, strerror=error.strerror or error),
            path,
        ) from error


def check_readable(path: str | os.PathLike[str]) -> None:
    """Fail early where there is no file to read. Raises FileError."""
    _check_name(path)
    try:
        mode = os.stat(path).st_mode
    except FileNotFoundError as error:
        raise FileError(say("{path} does not exist; name the file to read", path=path), path) from error
    except OSError as error:
        raise FileError(say("{path} cannot be read: {strerror}", path=path, strerror=error.strerror or error), path) from error
    if not stat.S_ISREG(mode):
        raise FileError(
            say("{path} is a folder; name the file to read", path=path)
            if stat.S_ISDIR(mode)
            else say("{path} is no ordinary file; name the file to read", path=path),
            path,
        )


def check_writable(path: str | os.PathLike[str]) -> None:
    """Fail early, before the long work, where a result could not be written. Raises FileError."""
    _check_name(path)
    folder = Path(path).parent
    if os.path.isdir(path):
        raise FileError(say("{path} is a folder; name a file", path=path), path)
    if not os.path.isdir(folder):
        raise FileError(say("folder {folder} does not exist; make it first", folder=folder), path)
    try:
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise FileError(
            say(
                "folder {folder} cannot be written: {strerror}; choose another one",
                folder=folder,
                strerror=error.strerror or error,
            ),
            path,
        ) from error


def _check_name(path: str | os.PathLike[str]) -> None:
    if not is_name(path):
        raise FileError(say("{path} cannot be the name of a file; give another", path=repr(os.fspath(path))), path)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
