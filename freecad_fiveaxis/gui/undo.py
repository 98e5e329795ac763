# SPDX-License-Identifier: LGPL-2.1-or-later
"""One step of undo for one wish of the user.

transaction   what undo takes back in one step. It is committed whole or aborted whole: an aborted one leaves
              the document as it was, also in what waits to be recomputed.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import FreeCAD


class OpenStep:
    """A step that stays open while a task panel shows what it does: ``begin``, then ``keep`` or
    ``take_back``."""

    def __init__(self, doc: Any, name: str) -> None:
        self.doc, self.name, self.is_open = doc, name, False
        self._doc_name = doc.Name
        self._settled: list[str] = []

    def begin(self) -> None:
        """Open the step unless it is open: FreeCAD ends it where the user presses Undo meanwhile."""
        if not self.is_open or not self.doc.HasPendingTransaction:
            self._settled = [obj.Name for obj in self.doc.Objects if "Touched" not in obj.State]
            self.doc.openTransaction(self.name)
            self.is_open = True

    def keep(self) -> None:
        """Keep the document as it is now."""
        if self.is_open and self.has_document():
            self.doc.commitTransaction()
        self.is_open = False

    def take_back(self) -> None:
        """Take the document back to what it was before ``begin``."""
        if self.is_open and self.has_document():
            self.doc.abortTransaction()
            for obj in filter(None, map(self.doc.getObject, self._settled)):
                obj.purgeTouched()  # putting properties back touches the objects, though nothing has changed
        self.is_open = False

    def has_document(self) -> bool:
        """Whether the document is still open."""
        return FreeCAD.listDocuments().get(self._doc_name) is self.doc


def is_there(obj: Any) -> bool:
    """Whether an object is in its document: neither deleted nor undone."""
    try:
        name = obj.Name  # of what was undone it is an error in FreeCAD 0.20, and None in 1.1
        return bool(name) and obj.Document.getObject(name) is not None
    except (ReferenceError, RuntimeError, AttributeError):
        return False


@contextmanager
def transaction(doc: Any, name: str) -> Iterator[None]:
    """Everything within is one step of undo of ``doc``; whatever is raised within takes all of it back."""
    step = OpenStep(doc, name)
    step.begin()
    try:
        yield
    except BaseException:  # FreeCADAbort (Esc) is no Exception
        step.take_back()
        raise
    step.keep()
