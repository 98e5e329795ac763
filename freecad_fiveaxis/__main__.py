# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python -m freecad_fiveaxis ...``: the command line of :mod:`freecad_fiveaxis.core.cli`."""

import sys

if __name__ == "__main__":
    from freecad_fiveaxis.core.base import signals

    try:
        signals.watch()
        from freecad_fiveaxis.core.cli import main

        code = main()
    except KeyboardInterrupt as stop:  # before main could take care of it
        signals.tell()
        code = signals.exit_code(stop)
    sys.exit(code)
