# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part as geometry: the mesh, the tree of its facets that spatial searches run on, and the distance of
points from facets."""
