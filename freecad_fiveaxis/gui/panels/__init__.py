# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panels: tool path, audit, and writing the NC file."""
