# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sources of the project as trees, parsed once for all tests of a process that look at them."""

import ast
from functools import cache
from pathlib import Path


@cache
def parse_source(path: Path) -> ast.Module:
    """The tree of a file; nobody changes it."""
    return ast.parse(path.read_text(encoding="utf-8"))
