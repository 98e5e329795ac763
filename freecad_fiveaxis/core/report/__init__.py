# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said about a finished program, and the markers for the 3D view.

The numbers come from ``figures`` (which defines the words), the judgement from ``judgement``, the traffic
light over everything from ``verdict``, what that rests on from ``scope``; ``text`` writes for the terminal,
``json_text`` for scripts, ``html_page`` a page with plots, ``block_table`` and ``rate_table`` the CSV,
``drawing`` the arrays of a view, ``deviation_scale`` what they are coloured by. ``part_facts`` tells what the
program does to the part, ``rest_material_picture`` draws it (``raster``).
"""

from .block_table import blocks_csv
from .deviation_scale import scale_end, scale_marks
from .drawing import Drawing, Row, Spot, draw, list_findings, spot
from .figures import Figures, summary
from .html_page import as_html
from .json_text import as_json
from .judgement import judge
from .markers import Marker, markers
from .rate_table import rates_csv
from .scope import Scope, scope
from .text import as_text
from .verdict import Light, Verdict, find_largest_judged, verdict

__all__ = [
    "Drawing",
    "Figures",
    "Light",
    "Marker",
    "Row",
    "Scope",
    "Spot",
    "Verdict",
    "as_html",
    "as_json",
    "as_text",
    "blocks_csv",
    "draw",
    "find_largest_judged",
    "judge",
    "list_findings",
    "markers",
    "rates_csv",
    "scale_end",
    "scale_marks",
    "scope",
    "spot",
    "summary",
    "verdict",
]  # fmt: skip
