# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine drawn from its axes alone: plain boxes and cylinders about the rotary lines, as large as the part
and the tool ask.

A sketch, not to scale: a machine file tells where the axes are and nothing of the bodies. Where the lines run
and how each body moves is exact; how wide and how thick the bodies are is made up, so that the part and the
tool find room.

platter   carries the work: a disc about the table axis that is nearest to it, its face under the part; a
          plain table where no rotary axis carries the work.
riser     stands under a part that is clamped above the table's face, so that it does not float; what clamps
          it is not known.
cradle    carries the platter: a U that hangs in the next table axis; a knuckle about its line where that is
          inclined.
base      carries the cradle or the platter: two bearings and a floor, below all that swings within the axis's
          limits.
spindle   carries the tool. fork: what the spindle swings in; a knuckle where the line is inclined. ram: what
          carries the fork or the spindle.

frame     machine frame as in :mod:`~freecad_fiveaxis.core.report.playback`: parallel to the machine's, its
          zero where the work zero stands while all words are 0, and so does the tip. Bodies are given as they
          stand then; :func:`~freecad_fiveaxis.core.report.playback.placements` says where they go.
carrier   the column of the words (0 to 4) whose axis carries a body; None for what stands still.
"""

from .both_sides import ToolRoom, sketch
from .shapes import Body, Box, Cylinder, corners

__all__ = ["Body", "Box", "Cylinder", "ToolRoom", "corners", "sketch"]
