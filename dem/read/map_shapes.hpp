// SPDX-License-Identifier: GPL-3.0-or-later
// What files hold of triangles, points and lines, how it is read, and the terrain it makes.
#pragma once

#include "dem/read/read_options.hpp"
#include "dem/terrain.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// What one file holds, in map coordinates and the file's own unit of height: either triangles, or
/// points and lines. All numbers are finite but for the heights of a ring that has none.
struct MapShapes {
  std::string path;
  MapFrame map;             ///< without its origin; no CRS where the file has none
  bool units_known = false; ///< the file told the units of `map`, by its CRS or without one

  std::vector<Vec3> points; ///< scattered, or the triangles' corners
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::vector<Vec3>> breaklines;
  std::vector<std::vector<Vec3>> rings; ///< of a boundary; z is NaN in all of one or in none

  double surface_error_m = 0;
  std::vector<std::string> notes;
  std::vector<std::string> doubts; ///< as a terrain's: they are among the notes too
};

enum class MeshFormat { off, ply, obj, stl };

/// By the extension of `path`, in upper or lower case; none where there is no such format.
std::optional<MeshFormat> mesh_format_of(const std::string& path);

/// Triangles of OFF, PLY (text or binary), OBJ or STL (text or binary), x east, y north, z up.
/// Comments that `write_tin` leaves (dem/read/read_mesh.cpp says how) tell the CRS, the units and
/// the error; without them coordinates and heights are metres.
///
/// Throws Error: the file can't be read, ends early, holds more or less than it says, isn't of the
/// format; a coordinate isn't a finite number; a face isn't a triangle or names a vertex that isn't
/// there; no faces.
MapShapes read_mesh(const std::string& path, MeshFormat format);

/// Adds the points and triangles that `text`, all of a mesh file, holds; `path` of `shapes` is what
/// errors name, with the line where there are lines. Of STL, vertices at the same place are one
/// point. Throws Error as `read_mesh` does, but where there are no faces at all.
void take_off(std::string_view text, MapShapes& shapes);
void take_obj(std::string_view text, MapShapes& shapes);
void take_ply(std::string_view text, MapShapes& shapes);
void take_stl(std::string_view text, MapShapes& shapes);

/// The advice for faces that aren't triangles.
extern const char* const triangulate_faces;

/// The surface named `surface`, or the only one if that is empty: Surfaces/Surface/Definition with
/// surfType="TIN", its points (northing, easting, elevation) and its visible faces. Units come from
/// the file's Units, the CRS from its CoordinateSystem; one that contradicts the units is left out,
/// with a note. Throws Error: not XML (with the line), not LandXML, no such surface, several, no
/// TIN, a point or face that isn't three numbers, a face of a point that isn't there.
MapShapes read_landxml(const std::string& path, const std::string& surface);

/// Points in lines of text with a first line that names the columns: separated by semicolons, tabs,
/// commas or blanks, whichever the first line has (in this order). Names may be in quotes and in
/// upper or lower case. Of the columns `columns` are taken; by default ("x", "y", "z") those with
/// other usual names are found too (easting, northing, elevation, height). Without a first line of
/// names there must be three columns, taken as x, y, z, with a note. Lines that begin with '#' and
/// empty lines are passed over.
///
/// Throws Error, with the number of the line: a value that isn't a finite number, more or fewer
/// columns than the first line has, no such column, columns in degrees, no text.
/// A line at a time is held in memory beside the points.
MapShapes read_points(const std::string& path, const std::array<std::string, 3>& columns);

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

/// The Tin of the triangles, with the ground frame's origin at the north-west corner of the box of
/// their vertices. Of `options`, `bbox` keeps the triangles with all three vertices inside it and
/// `repair` is handed on. Throws Error where nothing is left, a place is none on earth, or the
/// triangles aren't a terrain.
TerrainData terrain_from_triangles(MapShapes shapes, const ReadOptions& options);

/// The Tin of the triangulation of `points` with its own lines, those of `lines` and the rings of
/// `boundary`. Where one of the files has no CRS, that of the others is taken, with a note. Of
/// `options`, `bbox` keeps the points inside it, lines between them included, and `max_edge_m` is
/// handed on. Throws Error where the CRSs differ, and as above.
TerrainData terrain_from_points(MapShapes points, std::optional<MapShapes> lines,
                                std::optional<MapShapes> boundary, const ReadOptions& options);

} // namespace orograph
