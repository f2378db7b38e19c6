// SPDX-License-Identifier: GPL-3.0-or-later
// Reading vector layers through GDAL: triangles, points, lines and rings.
#pragma once

#include "dem/read/map_shapes.hpp"
#include "dem/read/read_options.hpp"

#include <string>

namespace orograph {

/// What a file is read for.
enum class VectorUse {
  terrain,    ///< triangles, or points and lines (polygons are triangles)
  breaklines, ///< lines with heights
  boundary    ///< polygons; heights needn't be
};

/// One layer of a file that GDAL opens; of `options`, `layer` picks it if there are several (for a
/// terrain), `height_field` gives the heights of points, `open_options` go to GDAL.
///  - Triangles: TIN, PolyhedralSurface, Triangle, Polygon and MultiPolygon with Z and three
///    corners; more corners only where they repeat a neighbour.
///  - Points: Point and MultiPoint with Z, or with the field.
///  - Lines: LineString and MultiLineString with Z.
///  - Rings: those of Polygon and MultiPolygon. One that lacks a single height has none.
/// The CRS is the layer's; GeoJSON that names none and can't be in degrees has none. Heights
/// without a unit of their own are in the CRS's unit, and a note says so. A field
/// `surface_error_m` is read.
///
/// Throws Error, naming the feature: no such file or layer, several layers, nothing in it, other
/// geometries, no heights, heights or places that aren't numbers, a CRS in degrees.
MapShapes read_vector(const std::string& path, VectorUse use, const ReadOptions& options);

/// Whether GDAL opens the file as vector layers, and not as a raster.
bool is_vector_file(const std::string& path, const ReadOptions& options);
/// Whether GDAL opens it as a raster.
bool is_raster_file(const std::string& path, const ReadOptions& options);

} // namespace orograph
