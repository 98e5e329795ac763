# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC text of any origin in."""

from .nc_reader import read_nc

__all__ = ["read_nc"]
