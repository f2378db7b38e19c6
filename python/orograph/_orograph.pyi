# SPDX-License-Identifier: GPL-3.0-or-later
# What of the extension module is the package's own face.
__version__: str

class Error(ValueError):
    wrong: str
    right: str
