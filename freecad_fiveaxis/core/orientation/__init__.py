# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the tool stands: strategies and fields of tool axes, least turns, past the pole, tilted out of the
part."""
