#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_jacksboro.py OUT.tif: the Jacksboro fault DEM of Debian's python-matplotlib-data, brought to
UTM zone 16N and cropped to its inner rectangle. Needs python3-numpy and python3-gdal as well."""

import sys

import numpy
from osgeo import gdal

SOURCE = "/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz"
CELL_M = 85  # between the source's 75 m eastward and 92 m northward
NODATA = -32768


def source_raster():
    dem = numpy.load(SOURCE)
    heights = dem["elevation"]
    rows, columns = heights.shape
    # The file has ymin and ymax swapped; its first row is the northmost.
    north = max(float(dem["ymin"]), float(dem["ymax"]))
    raster = gdal.GetDriverByName("MEM").Create("", columns, rows, 1, gdal.GDT_Int16)
    raster.SetGeoTransform([float(dem["xmin"]), float(dem["dx"]), 0, north, 0, -float(dem["dy"])])
    raster.SetProjection("EPSG:4326")
    raster.GetRasterBand(1).WriteArray(heights)
    return raster


def inner_rectangle(valid):
    """Takes away, one at a time, the border row or column that has the most gaps."""
    top, bottom, left, right = 0, valid.shape[0], 0, valid.shape[1]
    while not valid[top:bottom, left:right].all():
        inner = valid[top:bottom, left:right]
        gaps = [1 - side.mean() for side in (inner[0], inner[-1], inner[:, 0], inner[:, -1])]
        worst = gaps.index(max(gaps))
        top, bottom = top + (worst == 0), bottom - (worst == 1)
        left, right = left + (worst == 2), right - (worst == 3)
    return left, top, right - left, bottom - top


def main(out):
    gdal.UseExceptions()
    projected = gdal.Warp("", source_raster(), format="MEM", dstSRS="EPSG:32616", xRes=CELL_M,
                          yRes=CELL_M, targetAlignedPixels=True, resampleAlg="cubic",
                          dstNodata=NODATA)
    valid = projected.ReadAsArray() != NODATA
    projected.GetRasterBand(1).DeleteNoDataValue()
    cropped = gdal.Translate("", projected, format="MEM", srcWin=inner_rectangle(valid))
    cropped.GetRasterBand(1).SetUnitType("m")
    gdal.GetDriverByName("GTiff").CreateCopy(
        out, cropped, options=["COMPRESS=DEFLATE", "PREDICTOR=2", "ZLEVEL=9", "BLOCKYSIZE=512"])


main(sys.argv[1])
