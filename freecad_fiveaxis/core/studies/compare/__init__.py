# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same path on several machines, with and without tool-centre control, with each cure: one table."""

from .beside_fixtures import Beside
from .stations import Cure, Row, Station, compare, solve_path, station
from .tool_centre import Guided, guide
from .words import compare_html, compare_json, compare_text, verdict

__all__ = [
    "Beside", "Cure", "Guided", "Row", "Station", "compare", "compare_html", "compare_json", "compare_text",
    "guide", "solve_path", "station", "verdict",
]  # fmt: skip
