# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts of measures for the view: those of the documents."""

from freecad_fiveaxis.app.decimal_sign import write_number
from freecad_fiveaxis.app.units import angle_text, area_text, length_text, measure_text

__all__ = ["angle_text", "area_text", "length_text", "measure_text", "write_number"]
