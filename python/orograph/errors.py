# SPDX-License-Identifier: GPL-3.0-or-later
from orograph._orograph import Error


def error(wrong, right):
    """An Error as the engine raises it: what is wrong, and what would be right."""
    made = Error(f"{wrong}: {right}")
    made.wrong, made.right = wrong, right
    return made
