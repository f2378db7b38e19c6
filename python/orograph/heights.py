# SPDX-License-Identifier: GPL-3.0-or-later
"""Heights and their places, from whatever holds them: numpy, xarray, rasterio."""

import numbers

import numpy as np

from orograph.errors import error

_X_NAMES = {"x", "lon", "longitude", "easting"}


def borrowable(z):
    """The array itself where the engine can take it as it is, else a copy that it can.

    That is two dimensions, float32 or float64 of this machine's byte order, rows one behind the
    other. Masked heights become NaN. What can't be heights raises Error.
    """
    if isinstance(z, np.ma.MaskedArray):
        z = np.ma.filled(_as_floats(z), np.nan)
    array = np.asarray(z)
    if array.ndim != 2:
        raise error(
            f"z has {array.ndim} dimensions, {_shape(array)}",
            "give heights in rows and columns, as z[0] of an array of bands",
        )
    return np.require(_as_floats(array), requirements=["C", "A"])


def _shape(array):
    return " x ".join(map(str, array.shape)) or "a single value"


def _as_floats(array):
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind not in "fiu":
        raise error(f"z holds {array.dtype}", "give heights as numbers, best of float32")
    if kind == "f":
        wanted = np.float32 if size <= 4 else np.float64
    else:  # whole numbers above 2**24 aren't all in float32
        wanted = np.float32 if size <= 2 or _fits_float32(array) else np.float64
    return array.astype(wanted, copy=False)


def _fits_float32(array):
    return array.size == 0 or (array.max() <= 2**24 and array.min() >= -(2**24))


def geotransform_of(transform):
    """GDAL's six numbers, from those or from an affine.Affine."""
    if all(hasattr(transform, name) for name in "abcdef"):
        return [float(getattr(transform, name)) for name in "cabfde"]
    right = (
        "give an affine.Affine, or GDAL's six: (x, width, 0, y, 0, -height), x and y of the upper "
        "left corner and the size of a cell"
    )
    if transform is None:
        raise error("no transform tells where z lies", right)
    try:
        six = [float(number) for number in transform]
    except (TypeError, ValueError):
        raise error(f"transform {transform!r} isn't six numbers", right) from None
    if len(six) == 9 and six[6:] == [0, 0, 1]:
        six = six[:6]
        return [six[i] for i in (2, 0, 1, 5, 3, 4)]
    if len(six) != 6:
        raise error(f"transform has {len(six)} numbers", right)
    if not all(np.isfinite(six)):
        raise error(f"transform {tuple(six)} isn't finite", right)
    if six[1] == 0 and six[3] == 0 and six[0] != 0:
        raise error("transform has its numbers in the order of an Affine", right)
    return six


def crs_text(crs):
    """What GDAL reads as a CRS, from that, a code of EPSG, or what has `to_wkt`."""
    if crs is None:
        return ""
    if hasattr(crs, "to_wkt"):
        return crs.to_wkt()
    if isinstance(crs, numbers.Integral) and not isinstance(crs, bool):
        return f"EPSG:{int(crs)}"
    if isinstance(crs, str):
        return crs
    raise error(f"crs {crs!r} can't be used", 'give WKT, "EPSG:32632", 32632 or a CRS of pyproj')


def unpacked(z, transform, crs, nodata):
    """z and its place, where z is a dataset of rasterio or an array of xarray that tells them.

    What is given goes before what z says.
    """
    if hasattr(z, "read") and hasattr(z, "transform"):
        return _of_dataset(z, transform, crs, nodata)
    if hasattr(z, "dims") and hasattr(z, "coords"):
        return _of_data_array(z, transform, crs, nodata)
    return z, transform, crs, nodata


def _of_dataset(dataset, transform, crs, nodata):
    z = dataset.read(1)
    scale, offset = dataset.scales[0], dataset.offsets[0]
    if nodata is None:
        nodata = dataset.nodata
    if (scale, offset) != (1, 0):
        missing = np.zeros(z.shape, bool) if nodata is None else z == nodata
        z = np.where(missing, np.nan, z * np.float64(scale) + offset)
        nodata = None
    return (
        z,
        dataset.transform if transform is None else transform,
        dataset.crs if crs is None else crs,
        nodata,
    )


def _of_data_array(array, transform, crs, nodata):
    array = array.squeeze()
    if array.ndim == 2 and str(array.dims[0]).lower() in _X_NAMES:
        array = array.transpose()
    if nodata is None:
        nodata = array.attrs.get("_FillValue")
    if transform is None and array.ndim == 2:
        transform = _transform_of_coordinates(array)
    if crs is None and hasattr(array, "rio"):
        crs = array.rio.crs
    if crs is None and "spatial_ref" in array.coords:
        crs = array.coords["spatial_ref"].attrs.get("crs_wkt")
    return array.values, transform, crs, nodata


def _transform_of_coordinates(array):
    steps = []
    for dim in reversed(array.dims):
        if dim not in array.coords:
            return None
        places = np.asarray(array.coords[dim].values, float)
        if len(places) < 2:
            return None
        step = (places[-1] - places[0]) / (len(places) - 1)
        even = places[0] + step * np.arange(len(places))
        if step == 0 or not np.allclose(places, even, rtol=0, atol=1e-3 * abs(step)):
            raise error(
                f"the coordinates {dim} aren't evenly spaced",
                "bring z to even steps, as with interp, or give a transform",
            )
        steps.append((places[0] - step / 2, step))
    (x, width), (y, height) = steps
    return [x, width, 0.0, y, 0.0, height]
