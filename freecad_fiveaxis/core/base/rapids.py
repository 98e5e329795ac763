# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a controller drives its axes in a rapid (G0): the words of machine files, dialects and ``--rapids``.

interpolated   all axes begin and end together: a rapid is the way of a feed block.
independent    each axis runs at a rate of its own: of the way only the two ends are known.
unknown        nobody has said which of the two.
"""

INTERPOLATED, INDEPENDENT, UNKNOWN = "interpolated", "independent", "unknown"
RAPIDS = (INTERPOLATED, INDEPENDENT, UNKNOWN)
