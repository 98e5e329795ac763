# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same path on several machines, with and without tool-centre control, with each cure: one table."""

from .beside_fixtures import Beside
from .beside_part import CheckPart
from .stations import Cure, Row, Station, compare, solve_path, station
from .tool_centre import Guided, guide
from .words import compare_html, compare_json, compare_text, headline, say_unchecked, verdict

__all__ = [
    "Beside", "CheckPart", "Cure", "Guided", "Row", "Station", "compare", "compare_html", "compare_json",
    "compare_text", "guide", "headline", "say_unchecked", "solve_path", "station", "verdict",
]  # fmt: skip
