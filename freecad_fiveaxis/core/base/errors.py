# SPDX-License-Identifier: LGPL-2.1-or-later
"""The errors of the core: input that cannot be used.

A poor result is no error; it is a :class:`~freecad_fiveaxis.core.base.findings.Finding`.
Every kind is also a builtin, so that a caller may catch either; every one keeps the offending value
and says in one line what to do about it.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator

from .sentences import say


class FiveAxisError(Exception):
    """Input that cannot be used. ``value`` is what was given; ``text`` names it and the remedy.

    ``text`` is the message as it was made: a Sentence can be said in another language
    (core/base/sentences.py).
    """

    def __init__(self, message: str, value: object = None) -> None:
        super().__init__(message)
        self.text, self.value = message, value
        self.file = ""
        """The file whose text is wrong, where the message itself does not name it."""

    def name_file(self) -> str:
        """Return the message, behind the file where it does not name it."""
        return f"{self.file}: {self}" if self.file else str(self)


class MeshError(FiveAxisError, ValueError):
    """An STL file or a mesh that cannot be used at all."""


class MachineError(FiveAxisError, ValueError):
    """A machine description that is incomplete, contradictory or unknown."""


class ReachError(FiveAxisError, ValueError):
    """A pose that the machine cannot take up on any branch."""


class SettingsError(FiveAxisError, ValueError):
    """A setting outside its range, an unknown name, a malformed quantity."""


class ProgramError(FiveAxisError, ValueError):
    """An NC or CL text that cannot be read; the message names line and column."""


class FileError(FiveAxisError, OSError):
    """A file that is missing or a folder that cannot be written."""


class Cancelled(FiveAxisError):
    """The user stopped the work; nothing was written."""

    def __init__(self, message: str | None = None, value: object = None) -> None:
        """Have a message by default: a thread that is stopped from outside raises the bare class."""
        super().__init__(say("stopped; nothing was changed") if message is None else message, value)


@contextlib.contextmanager
def naming_file(path: str | os.PathLike[str]) -> Iterator[None]:
    """Note the file whose text is read in a ProgramError that comes of it."""
    try:
        yield
    except ProgramError as error:
        error.file = error.file or os.fspath(path)
        raise
