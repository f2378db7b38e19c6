// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/read_terrain.hpp"

#include "dem/read/asked_window.hpp"
#include "dem/read/map_shapes.hpp"
#include "dem/read/network.hpp"
#include "dem/read/read_options.hpp"
#include "dem/read/read_raster.hpp"
#include "geometry/error.hpp"
#include "text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <new>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace orograph {
namespace {

template <class... Words>
bool is_one_of(std::string_view text, Words... words) {
  return ((text == words) || ...);
}

std::string first_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(2000, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

[[noreturn]] void refuse_lidar(const std::string& path) {
  const std::string stem = path.substr(0, path.size() - 4);
  throw Error(fmt::format("{} is a lidar point cloud (LAS or LAZ), which can't be read", path),
              fmt::format("make text of it: pdal translate {0} {1}.csv "
                          "--writers.text.order=X,Y,Z --writers.text.keep_unspecified=false, or "
                          "las2txt -i {0} -o {1}.txt -parse xyz",
                          path, stem));
}

std::optional<MeshFormat> mesh_format(const std::string& path, std::string_view begin) {
  if (const auto format = mesh_format_of(path)) return format;
  if (begin.starts_with("ply\n") || begin.starts_with("ply\r")) return MeshFormat::ply;
  if (begin.starts_with("OFF\n") || begin.starts_with("OFF\r")) return MeshFormat::off;
  return std::nullopt;
}

bool is_landxml(const std::string& extension, std::string_view begin) {
  return extension == ".landxml" ||
         (begin.find("<LandXML") != begin.npos || begin.find(":LandXML") != begin.npos);
}

void refuse_survey_options(const ReadOptions& options, const std::string& what) {
  const char* option = !options.breaklines.empty()     ? "`breaklines`"
                       : !options.boundary.empty()     ? "`boundary`"
                       : options.max_edge_m            ? "`max_edge_m`"
                       : !options.height_field.empty() ? "`height_field`"
                                                       : nullptr;
  if (option) throw Error(fmt::format("{} is for points, but {}", option, what), "leave it out");
}

TerrainData from_triangles(MapShapes shapes, const ReadOptions& options) {
  refuse_survey_options(options, fmt::format("{} holds triangles", shapes.path));
  return terrain_from_triangles(std::move(shapes), options);
}

TerrainData from_points(MapShapes shapes, const ReadOptions& options) {
  std::optional<MapShapes> lines, boundary;
  if (!options.breaklines.empty())
    lines = read_vector(options.breaklines, VectorUse::breaklines, options);
  if (!options.boundary.empty())
    boundary = read_vector(options.boundary, VectorUse::boundary, options);
  return terrain_from_points(std::move(shapes), std::move(lines), std::move(boundary), options);
}

TerrainData from_rasters(const std::vector<std::string>& paths, const ReadOptions& options,
                         const std::function<void(double)>& progress) {
  TerrainData terrain = read_rasters(paths, options, progress);
  refuse_survey_options(options, fmt::format("{} is a raster", paths.front()));
  return terrain;
}

TerrainData from_vector(const std::string& path, const ReadOptions& options) {
  MapShapes shapes = read_vector(path, VectorUse::terrain, options);
  return shapes.triangles.empty() ? from_points(std::move(shapes), options)
                                  : from_triangles(std::move(shapes), options);
}

enum class Kind { mesh, landxml, text_points, vector, raster };

Kind kind_of(const std::string& path, const ReadOptions& options) {
  const std::string extension = extension_of(path), begin = first_bytes(path);
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(path, ignored); // GDAL has names of its own
  if (is_one_of(extension, ".las", ".laz") || begin.starts_with("LASF")) refuse_lidar(path);
  if (is_file && mesh_format(path, begin)) return Kind::mesh;
  if (is_file && is_landxml(extension, begin)) return Kind::landxml;
  if (is_file && is_one_of(extension, ".csv", ".tsv")) return Kind::text_points;
  // Other text that GDAL takes for a grid is one: Arc/Info ASCII, or x, y, z in regular rows.
  if (is_file && is_one_of(extension, ".txt", ".xyz", ".dat", ".pts") &&
      !is_raster_file(path, options))
    return Kind::text_points;
  const bool is_vector =
      is_vector_file(path, options) ||
      (is_file && is_one_of(extension, ".gpkg", ".shp", ".geojson", ".json", ".dxf", ".fgb") &&
       !is_raster_file(path, options));
  return is_vector ? Kind::vector : Kind::raster;
}

TerrainData read_one(const std::string& path, const ReadOptions& options,
                     const std::function<void(double)>& progress) {
  switch (kind_of(path, options)) {
  case Kind::mesh:
    return from_triangles(read_mesh(path, *mesh_format(path, first_bytes(path))), options);
  case Kind::landxml:
    return from_triangles(read_landxml(path, options.layer), options);
  case Kind::text_points:
    return from_points(read_points(path, options.columns), options);
  case Kind::vector:
    return from_vector(path, options);
  case Kind::raster:
    break;
  }
  return from_rasters({path}, options, progress);
}

TerrainData read_several(const std::vector<std::string>& paths, const ReadOptions& options,
                         const std::function<void(double)>& progress) {
  for (const std::string& path : paths)
    if (kind_of(path, options) != Kind::raster)
      throw Error(fmt::format("{} isn't a raster, and of several files all must be", path),
                  "give it alone, or rasters only");
  return from_rasters(paths, options, progress);
}

} // namespace

TerrainData read_terrain(const std::vector<std::string>& paths, const ReadOptions& options,
                         const std::function<void(double)>& progress) {
  const auto too_large = [&] {
    return Error(fmt::format("{} doesn't fit into memory", in_brief(paths)),
                 "cut it into parts first");
  };
  try {
    std::vector<std::string> inputs = paths;
    for (const std::string& beside : {options.breaklines, options.boundary})
      if (!beside.empty()) inputs.push_back(beside);
    const NetworkGate gate(inputs, options.allow_network);
    TerrainData terrain = paths.size() == 1 ? read_one(paths.front(), options, progress)
                                            : read_several(paths, options, progress);
    for (std::vector<std::string>* told : {&terrain.doubts, &terrain.notes})
      told->insert(told->end(), gate.doubts().begin(), gate.doubts().end());
    terrain.paths = paths;
    return terrain;
  } catch (const std::bad_alloc&) {
    throw too_large();
  } catch (const std::length_error&) {
    throw too_large();
  }
}

TerrainData read_terrain(const std::string& path, const ReadOptions& options) {
  return read_terrain(std::vector<std::string>{path}, options);
}

} // namespace orograph
