# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the 3D view shows, as Coin nodes made from plain arrays.

``path_nodes`` draws a path, ``marks`` its markers, ``overlay`` the legend and the label, ``colours`` gives
the one colour map, ``words`` tells of a block in plain words. Nothing here knows a document object:
``view_providers`` brings both together.
"""
