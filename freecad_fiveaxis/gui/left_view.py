# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of a map of rest material. The path of this class stands in saved documents: it is forever. What
it does is in :mod:`.rest_view`."""

from __future__ import annotations

from .rest_view import RestMapView


class LeftMapView(RestMapView):
    """A map of rest material."""
