# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python -m freecad_fiveaxis ...``: the command line of :mod:`freecad_fiveaxis.core.cli`."""

import sys

from freecad_fiveaxis.core.cli import main

if __name__ == "__main__":
    sys.exit(main())
