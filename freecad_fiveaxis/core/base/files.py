# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files in and out: whole or not at all, and an error that names the file and the remedy.

target    the file that an output becomes: the one behind a symbolic link, so that the link stays.
part      a file beside the target, under a short name that ends in ``.part``; nobody takes it for the result.
"""

from __future__ import annotations

import contextlib
import errno
import os
import re
import shutil
import stat
import tempfile
from collections.abc import Mapping
from io import BufferedReader

from .errors import FileError
from .memory import check_memory
from .sentences import say
from .signals import defer_signals, raise_received

PathName = str | os.PathLike[str]

FORBIDDEN = re.compile(r'[\\/:*?"<>|\x00-\x1f]+')
"""What no file name can hold on one system or another."""

written: list[str] = []
"""The outputs that this process has written since its command began: what a message may truthfully say when a
signal comes."""


def is_name(text: PathName) -> bool:
    """Whether a file can have that name (or path) at all: no NUL, no character that the system cannot
    write."""
    try:
        return b"\0" not in os.fsencode(text)
    except UnicodeEncodeError:
        return False


def plain_name(text: str, otherwise: str) -> str:
    """Give a file's name without its ending after a ``text``; ``otherwise`` where nothing of that can be
    one."""
    return FORBIDDEN.sub("_", text).strip(" .") or otherwise


def open_file(path: PathName) -> BufferedReader:
    """Return an ordinary file to read from. Raises FileError for a folder, a device, a pipe or a socket,
    which may have no end, and OSError where the file cannot be opened."""
    _check_regular(os.stat(path).st_mode, path)  # opening a device may already do something to it
    descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    file = os.fdopen(descriptor, "rb")
    try:
        _check_regular(os.fstat(descriptor).st_mode, path)  # a pipe may have taken the file's place
    except FileError:
        file.close()
        raise
    return file


def read_bytes(path: PathName, what: str) -> bytes:
    """Return the whole file. Raises FileError that says what is missing or unreadable, SettingsError where
    memory cannot hold it."""
    _check_name(path)
    try:
        with open_file(path) as file:
            label = say("{what} {path}: its bytes", what=what, path=os.fspath(path))
            check_memory(os.fstat(file.fileno()).st_size, label, say("give a smaller file, or free memory"))
            return file.read()
    except FileError:
        raise
    except OSError as error:
        raise FileError(
            say(
                "{what} {path} cannot be read: {strerror}; check its name, its folder and your right "
                "to read it",
                what=what,
                path=os.fspath(path),
                strerror=error.strerror or error,
            ),
            path,
        ) from error


def same_file(one: PathName, other: PathName) -> bool:
    """Whether two names are one file, by whatever links; of files that are not there yet, whether they would
    be."""
    try:
        return os.path.samefile(one, other)
    except (OSError, ValueError):
        return os.path.normcase(os.path.realpath(one)) == os.path.normcase(os.path.realpath(other))


class _Output:
    """One file on its way to its target. ``old``: the file that is there; ``backup``: a second name or a copy
    of it."""

    def __init__(self, path: PathName, data: bytes) -> None:
        self.path, self.data = path, data
        self.target = os.path.realpath(path)
        self.old = _state(path)
        self.part = self.backup = ""
        self.placed = False

    @property
    def in_place(self) -> bool:
        """A file with other names (hard links) stays the file of all of them: its content is exchanged, not
        the file."""
        return self.old is not None and self.old.st_nlink > 1

    def prepare(self) -> None:
        """Write the data beside the target, with the access that the old file gives; back up what is
        there."""
        handle, self.part = self._beside()
        with os.fdopen(handle, "wb") as stream:
            stream.write(self.data)
        self._give_access(self.part)
        if self.old is not None:
            handle, self.backup = self._beside()
            os.close(handle)
            self._back_up()

    def place(self) -> None:
        """To the target."""
        self.placed = True
        if self.in_place:
            _exchange(self.part, self.target)
        else:
            os.replace(self.part, self.target)

    def put_back(self) -> None:
        """As it was before. Raises OSError; the backup then stays."""
        if not self.placed:
            return
        if self.in_place:
            _exchange(self.backup, self.target)
        elif self.backup:
            os.replace(self.backup, self.target)
        elif os.path.exists(self.target) and not os.path.exists(self.part):
            os.unlink(self.target)

    def tidy(self) -> None:
        """Nothing stays beside the target."""
        for name in filter(None, (self.part, self.backup)):
            with contextlib.suppress(OSError):
                os.unlink(name)

    def _beside(self) -> tuple[int, str]:
        return tempfile.mkstemp(prefix="fiveaxis-", suffix=".part", dir=os.path.dirname(self.target))

    def _give_access(self, name: str) -> None:
        """mkstemp makes files for the owner alone; the result is an ordinary file, or what the old one
        was."""
        if self.old is None:
            os.chmod(name, 0o666 & ~_umask())
            return
        if hasattr(os, "chown"):
            with contextlib.suppress(OSError):  # only root may give a file away
                os.chown(name, self.old.st_uid, self.old.st_gid)
        os.chmod(name, stat.S_IMODE(self.old.st_mode))

    def _back_up(self) -> None:
        """By a second name, which costs nothing, or by a copy where the file itself will be written or has no
        second name."""
        if not self.in_place:
            os.unlink(self.backup)
            with contextlib.suppress(OSError, NotImplementedError):
                os.link(self.target, self.backup)
                return
        shutil.copy2(self.target, self.backup)


def write_all(files: Mapping[str, bytes] | Mapping[PathName, bytes]) -> None:
    """Write all files, or none: an old file is then as it was, and nothing stays beside it.

    All are written beside their targets first and then renamed, so nobody ever sees half a file. A symbolic
    link is followed, a file's access rights and hard links are kept. A signal that comes meanwhile waits.
    Raises FileError that names the file.
    """
    for path in files:
        check_target(path)
    raise_received()
    with defer_signals():
        outputs = [_Output(path, data) for path, data in files.items()]
        at = None
        try:
            for at in outputs:
                at.prepare()
            for at in sorted(
                outputs, key=lambda output: not output.in_place
            ):  # what may fail most comes first
                at.place()
        except BaseException as error:
            lost = _put_back(outputs)
            if isinstance(error, OSError) and at is not None:
                raise _not_written(at, error, lost) from error
            raise
        finally:
            for output in outputs:
                output.tidy()
        written.extend(os.fspath(path) for path in files)


def write_whole(path: PathName, data: bytes) -> None:
    """Write one file, whole or not at all (:func:`write_all`). Raises FileError; an old file then stays as it
    was."""
    write_all({path: data})


def _put_back(outputs: list[_Output]) -> list[str]:
    """Return the backups of those that could not be put back."""
    lost = []
    for output in reversed(outputs):
        try:
            output.put_back()
        except OSError:
            lost.append(output.backup)
            output.backup = ""  # all that is left of the old file
    return [name for name in lost if name]


def _not_written(output: _Output, error: OSError, lost: list[str]) -> FileError:
    target, why = output.path, error.strerror or error
    text = say("{target} cannot be written: {strerror}; choose another folder", target=target, strerror=why)
    if lost:
        text += say("; what was there before is in {backups}", backups=", ".join(lost))
    return FileError(text, target)


def _exchange(source: str, target: str) -> None:
    """Put the content of ``source`` into the file ``target``, which is cut to its length last: what room it
    had, it keeps."""
    with open(source, "rb") as new, open(target, "r+b") as old:
        shutil.copyfileobj(new, old)
        old.truncate()


def check_readable(path: PathName) -> None:
    """Fail early where there is no file to read. Raises FileError."""
    _check_name(path)
    try:
        mode = os.stat(path).st_mode
    except FileNotFoundError as error:
        raise FileError(say("{path} does not exist; name the file to read", path=path), path) from error
    except OSError as error:
        raise FileError(
            say(
                "{path} cannot be read: {strerror}; check its folder and your right to read it",
                path=path,
                strerror=error.strerror or error,
            ),
            path,
        ) from error
    _check_regular(mode, path)


def check_target(path: PathName) -> None:
    """Check that what is there may be replaced: an ordinary file that its owner may write, or none yet.
    Raises FileError."""
    _check_name(path)
    old = _state(path)
    if old is None:
        return
    if stat.S_ISDIR(old.st_mode):
        raise FileError(say("{path} is a folder; name a file", path=path), path)
    if not stat.S_ISREG(old.st_mode):
        raise FileError(say("{path} is no ordinary file; name a file to write", path=path), path)
    if not old.st_mode & stat.S_IWUSR or not os.access(
        path, os.W_OK
    ):  # root may write anything: what counts is the mark
        raise FileError(say("{path} is read-only; make it writable, or choose another name", path=path), path)


def check_writable(path: PathName) -> None:
    """Fail early, before the long work, where a result could not be written. Raises FileError. ``-`` stands
    for the standard output elsewhere, and is no file here."""
    if os.fspath(path) == "-":
        raise FileError(say("- is no file, and nothing is written to the standard output; name a file"), path)
    check_target(path)
    folder = os.path.dirname(os.path.realpath(path))
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


def _state(path: PathName) -> os.stat_result | None:
    """Of the file behind the name, None where there is none yet. Raises FileError where that is not to be
    had."""
    try:
        return os.stat(path)
    except FileNotFoundError:
        return None
    except NotADirectoryError:
        return None  # the folder is told by name
    except OSError as error:
        why = error.strerror or error
        text = say("{target} cannot be written: {strerror}; choose another folder", target=path, strerror=why)
        if error.errno in (errno.ENAMETOOLONG, errno.ELOOP):
            text = say(
                "{target} cannot be written: {strerror}; choose another name", target=path, strerror=why
            )
        raise FileError(text, path) from error


def _check_regular(mode: int, path: PathName) -> None:
    if not stat.S_ISREG(mode):
        raise FileError(
            say("{path} is a folder; name the file to read", path=path)
            if stat.S_ISDIR(mode)
            else say("{path} is no ordinary file; name the file to read", path=path),
            path,
        )


def _check_name(path: PathName) -> None:
    if not is_name(path):
        raise FileError(
            say("{path} cannot be the name of a file; give another", path=repr(os.fspath(path))), path
        )


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
