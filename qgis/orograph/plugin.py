# SPDX-License-Identifier: GPL-3.0-or-later
"""What QGIS starts: a plugin whose only part is the provider."""

from qgis.core import QgsApplication

from .provider import OrographProvider


class OrographPlugin:
    def __init__(self):
        self._provider = None

    def initProcessing(self):
        """Called alone by qgis_process, which has no window."""
        self._provider = OrographProvider()
        QgsApplication.processingRegistry().addProvider(self._provider)

    def initGui(self):
        self.initProcessing()

    def unload(self):
        if self._provider:
            QgsApplication.processingRegistry().removeProvider(self._provider)
            self._provider = None
