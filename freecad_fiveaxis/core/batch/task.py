# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes to a worker and what comes back: plain values that can be pickled."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import say

FAILED = "failed"
"""In the place of a verdict's light: there is no program."""

OUT, OVERWRITE, SHARD = "--out", "--overwrite", "--shard"
"""Of the command line, which alone knows batches: no window has a name for them."""

COLUMNS = (
    "name", "part", "machine", "verdict", "deviation_mm", "bound_mm", "cut_mm", "links_mm", "rapids_mm",
    "minutes",
    "scallop_mm", "stepover_mm", "unfinished_percent", "rank", "errors", "says", "error",
)  # fmt: skip
"""Of the report's rows, in their order. ``minutes`` are those of the program; ``scallop_mm`` or
``stepover_mm``: what was asked of its passes; ``rank``: among the jobs of the same part with the same of
these, see :mod:`.rank`; ``errors`` counts the findings of that severity."""


@dataclass(frozen=True)
class BatchJob:
    """One job. ``part``: its STL, or what :mod:`.solids` meshes; ``options``: as a job file has them;
    ``stem``: folder and name of its files, without an ending; ``suffix``: the NC file's ending;
    ``overwrite``: others' files there may be replaced; ``label``: what the report calls the part, where its
    file's name would not tell it from others."""

    part: str
    options: Mapping[str, Any] = field(hash=False)
    stem: str
    suffix: str = ".ngc"
    overwrite: bool = False
    task: str = "mill"
    label: str = ""

    @property
    def nc(self) -> str:
        """The NC file."""
        return self.stem + self.suffix

    @property
    def html(self) -> str:
        """The report as a page."""
        return self.stem + ".html"

    @property
    def json(self) -> str:
        """The report for scripts, which also keeps what the job was made of."""
        return self.stem + ".json"

    @property
    def files(self) -> tuple[str, str, str]:
        """All that the job writes."""
        return self.nc, self.html, self.json


@dataclass(frozen=True)
class JobOutcome:
    """How a job ended. ``stem``: the job's; ``row``: by COLUMNS; ``files``: what it wrote, nothing where it
    failed; ``error``: why it failed, in one line."""

    stem: str
    row: Mapping[str, Any] = field(hash=False)
    files: tuple[str, ...] = ()
    error: str = ""

    @property
    def spoiled(self) -> bool:
        """Whether it failed or has findings of severity error."""
        return bool(self.error or self.row.get("errors"))


def not_of_batch(path: str) -> SettingsError:
    """Return the error of a file that would be replaced and that no batch wrote."""
    text = say(
        "{path} is there and not of this batch; choose another folder ({out}), or give {overwrite}",
        path=path, out=OUT, overwrite=OVERWRITE,
    )  # fmt: skip
    return SettingsError(text, path)
