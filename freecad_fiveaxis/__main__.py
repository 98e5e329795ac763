# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python -m freecad_fiveaxis ...``: the command line of :mod:`freecad_fiveaxis.core.cli`."""

import sys

if __name__ == "__main__":
    try:
        from freecad_fiveaxis.core.cli import main
    except KeyboardInterrupt:  # before main could take care of it
        sys.exit(130)
    sys.exit(main())
