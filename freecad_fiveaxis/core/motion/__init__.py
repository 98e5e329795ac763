# SPDX-License-Identifier: LGPL-2.1-or-later
"""Joints and blocks of a program, and where a block really leads the tool: trajectory, deviation,
singularity."""
