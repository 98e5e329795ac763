# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proxy of a map of rest material. Its path stands in saved documents: it is forever. What it does is in
:mod:`.rest`."""

from __future__ import annotations

from .rest import RestMap, heights_of

__all__ = ["LeftMap", "heights_of"]


class LeftMap(RestMap):
    """Proxy of a map of rest material."""
