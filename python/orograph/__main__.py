# SPDX-License-Identifier: GPL-3.0-or-later
"""`python -m orograph` is the command `orograph`."""

import sys

from orograph._orograph import run_command

if __name__ == "__main__":
    sys.stdout.flush()
    sys.exit(run_command(["orograph", *sys.argv[1:]]))
