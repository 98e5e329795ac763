# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core says, in the user's language and units: findings, errors and verdicts are shown by
``localize``."""

from __future__ import annotations

import FreeCAD

from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.base.sentences import render

from .decimal_sign import write_number
from .labels import name_of
from .units import measure_text


def localize(text: str | BaseException) -> str:
    """Give a sentence, or the message of an error, as the user reads it; any other text as it is."""
    if isinstance(text, FiveAxisError):
        text = text.text
    if not isinstance(text, str):
        return str(text)
    return render(text, FreeCAD.Qt.translate, measure_text, name_of, write_number)
