# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Any

import numpy as np
from numpy.typing import NDArray

class Sights:
    attributes: dict[str, NDArray[Any]]
    state: NDArray[np.str_]
    hidden_m: NDArray[np.float64]
    hidden_deg: NDArray[np.float64]
    azimuth_deg: NDArray[np.float64]
    altitude_deg: NDArray[np.float64]
    distance_m: NDArray[np.float64]
    height: NDArray[np.float64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    def __len__(self) -> int: ...
    def to_geopandas(self) -> Any: ...  # a GeoDataFrame

class Horizon:
    attributes: dict[str, NDArray[Any]]
    azimuth_deg: NDArray[np.float64]
    altitude_deg: NDArray[np.float64]
    distance_m: NDArray[np.float64]
    longitude: NDArray[np.float64]
    latitude: NDArray[np.float64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    height: NDArray[np.float64]
    at_border: NDArray[np.bool_]
    most_distant: dict[str, Any] | None
    def __len__(self) -> int: ...
    def to_geopandas(self) -> Any: ...  # a GeoDataFrame
