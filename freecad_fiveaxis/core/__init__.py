# SPDX-License-Identifier: LGPL-2.1-or-later
"""The headless core: numpy and scipy only. Read ``job.py`` first; every call in it lives in the module of its
name."""
