# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job from its settings to its output files; :mod:`.job` reads as the process runs."""
