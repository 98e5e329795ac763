# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many parts, or one part in many ways, in one command: each job by itself, on whatever executor there is.

job       one part with one set of options; what it writes lies side by side under one name.
executor  what runs jobs: Python's own pools, or one of another package that keeps to ``concurrent.futures``.
crew      how an executor is made, made anew where its processes died, and told to stop.
"""
