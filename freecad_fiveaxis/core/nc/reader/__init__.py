# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC text of any origin in."""

from .lines import Assumed
from .nc_reader import Reading, dialect_of_text, read_in_order, read_nc

__all__ = ["Assumed", "Reading", "dialect_of_text", "read_in_order", "read_nc"]
