# SPDX-License-Identifier: GPL-3.0-or-later
import os
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

class Layer(NamedTuple):
    name: str
    colour: str
    width_mm: float
    hidden: bool
    strokes: slice

class Drawing:
    @property
    def page(self) -> tuple[float, float]: ...
    @property
    def title(self) -> str: ...
    @property
    def coords(self) -> NDArray[np.float64]: ...
    @property
    def offsets(self) -> NDArray[np.int64]: ...
    @property
    def ground(self) -> NDArray[np.float64]: ...
    @property
    def attributes(self) -> dict[str, NDArray[Any]]: ...
    @property
    def layers(self) -> dict[str, Layer]: ...
    @property
    def report(self) -> dict[str, Any]: ...
    def to_svg(self) -> str: ...
    def save(
        self,
        path: str | os.PathLike[str],
        *,
        overwrite: bool = False,
        dpi: float | None = None,
        device: str | os.PathLike[str] | None = None,
    ) -> None: ...
    # A LineCollection, Axes and a GeoDataFrame, of packages that need not be there.
    def line_collection(self, layer: str | None = None, **kwargs: Any) -> Any: ...
    def plot(self, ax: Any = None, **kwargs: Any) -> Any: ...
    def to_geopandas(self) -> Any: ...
