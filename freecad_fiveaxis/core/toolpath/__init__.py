# SPDX-License-Identifier: LGPL-2.1-or-later
"""From contact point to cutter location: co-edges, tool axis, CL offset, links between passes, CL files."""
