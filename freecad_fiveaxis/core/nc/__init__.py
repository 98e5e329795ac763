# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC files: written in the dialect of a controller, and read back."""
