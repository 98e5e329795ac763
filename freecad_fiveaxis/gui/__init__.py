# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window's side: commands, task panels and drawings. It computes nothing; numbers come from the core."""
