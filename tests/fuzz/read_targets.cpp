// SPDX-License-Identifier: GPL-3.0-or-later
// Readers of the library: what they take is a terrain, a scene, pens as they promise, or they
// refuse it with an Error.
#include "dem/overlay.hpp"
#include "dem/read/level_index.hpp"
#include "dem/read/netcdf_header.hpp"
#include "dem/read/read_overlay.hpp"
#include "dem/read/read_terrain.hpp"
#include "geometry/error.hpp"
#include "map/layer_table.hpp"
#include "placing/view_file.hpp"
#include "solids/read_scene.hpp"
#include "tests/fuzz/scratch_file.hpp"
#include "write/device.hpp"
#include "write/pens_file.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <variant>
#include <vector>

#include "gdal/gdal.hpp"

namespace orograph {
namespace {

// A header of a few bytes may tell of a raster, or of a block of one, that takes minutes: its size
// is a bound of the machine, not of the reader.
constexpr double kMostCells = 1e5;

bool is_small_raster(const std::string& path) {
  try {
    check_netcdf_header(path);
  } catch (const Error&) {
    return true; // the reader refuses it before anything is opened
  }
  const GdalMessages messages;
  const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
  if (!dataset) return true;
  const auto is_small = [](int columns, int rows) {
    return static_cast<double>(columns) * static_cast<double>(rows) <= kMostCells;
  };
  if (!is_small(dataset->GetRasterXSize(), dataset->GetRasterYSize())) return false;
  for (GDALRasterBand* const band : dataset->GetBands()) {
    int columns = 0, rows = 0;
    band->GetBlockSize(&columns, &rows);
    if (!is_small(columns, rows)) return false;
  }
  return true;
}

void check_surface(const Grid& grid) {
  expect(grid.columns >= 2 && grid.rows >= 2, "a grid without a cell");
  expect(std::visit([](const auto& h) { return h.size(); }, grid.heights_m) == grid.size(),
         "a grid of another size than its heights");
  bool has_height = false;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const double height = std::visit([&](const auto& h) -> double { return h[i]; }, grid.heights_m);
    expect(!std::isinf(height), "an infinite height");
    has_height = has_height || !std::isnan(height);
  }
  expect(has_height, "a grid without a height");
}

void check_surface(const Tin& tin) {
  expect(!tin.triangles.empty(), "a TIN without a triangle");
  for (const Vec3& vertex : tin.vertices_m)
    expect(std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z),
           "a vertex that isn't finite");
  for (const auto& corners : tin.triangles)
    for (const std::uint32_t corner : corners)
      expect(corner < tin.vertices_m.size(), "a triangle of a vertex that isn't there");
}

void read_as(const char* name, FuzzBytes bytes) {
  const std::string path = scratch_file(name, bytes);
  read_or_refuse([&] {
    ReadOptions options;
    options.max_memory = 1'000'000'000;
    const TerrainData terrain = read_terrain(path, options);
    std::visit([](const auto& surface) { check_surface(surface); }, terrain.surface);
  });
}

void lay_over(const std::string& path) {
  read_or_refuse([&] {
    const Overlay overlay =
        read_overlay({.path = path, .layer = {}, .where = {}}, MapFrame{}, {{0, 0}, {100, 100}}, 1);
    for (const Vec2 place : overlay.places)
      expect(std::isfinite(place.x) && std::isfinite(place.y), "a place that isn't finite");
    for (const Overlay::Line& line : overlay.lines)
      expect(line.first_place + line.place_count <= overlay.places.size(), "a line of no places");
    for (const Overlay::Feature& feature : overlay.features)
      expect(feature.first_line + feature.line_count <= overlay.lines.size(),
             "a feature of no lines");
  });
}

} // namespace

void fuzz_raster(FuzzBytes bytes) {
  if (is_small_raster(scratch_file("raster.tif", bytes))) read_as("raster.tif", bytes);
}

void fuzz_off(FuzzBytes bytes) {
  read_as("mesh.off", bytes);
}

void fuzz_ply(FuzzBytes bytes) {
  read_as("mesh.ply", bytes);
}

void fuzz_obj(FuzzBytes bytes) {
  read_as("mesh.obj", bytes);
}

void fuzz_stl(FuzzBytes bytes) {
  read_as("mesh.stl", bytes);
}

void fuzz_landxml(FuzzBytes bytes) {
  read_as("survey.landxml", bytes);
}

void fuzz_points(FuzzBytes bytes) {
  read_as("points.csv", bytes);
}

void fuzz_vector(FuzzBytes bytes) { // what GDAL takes for a raster is one whatever its name
  if (is_small_raster(scratch_file("shapes.geojson", bytes))) read_as("shapes.geojson", bytes);
}

void fuzz_overlay(FuzzBytes bytes) {
  lay_over(scratch_file("overlay.geojson", bytes));
}

void fuzz_places(FuzzBytes bytes) {
  lay_over(scratch_file("places.csv", bytes));
}

// Of a raster of 40 x 30 heights. Behind a first byte that is even, the bytes are all that an index
// tells of its levels, by as many bytes as the second says, with the right sum over it, and then
// their heights and nested cells.
void fuzz_levels(FuzzBytes bytes) {
  RasterSet set;
  set.sources.resize(1);
  set.grid.columns = 40;
  set.grid.rows = 30;
  const std::string state = "of this";
  std::string file;
  if (bytes.size() > 1 && bytes[0] % 2 == 0) {
    const FuzzBytes rest = bytes.subspan(2),
                    tells = rest.first(std::min<std::size_t>(bytes[1], rest.size()));
    const auto number = [](auto of) {
      return std::string(reinterpret_cast<const char*>(&of), sizeof of);
    };
    const std::string told = number(std::uint64_t{state.size()}) + state +
                             number(std::int32_t{40}) + number(std::int32_t{30}) +
                             number(std::uint32_t{4}) + std::string(tells.begin(), tells.end());
    std::uint64_t sum = 0xcbf29ce484222325ULL;
    for (std::size_t at = 0; at < told.size(); at += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, told.data() + at, std::min<std::size_t>(8, told.size() - at));
      sum = std::rotl((sum ^ word) * 0x100000001b3ULL, 29);
    }
    file = "orolev02" + number(std::uint32_t{0x01020304}) + number(std::uint64_t{told.size()}) +
           number(sum) + told +
           std::string(rest.begin() + static_cast<std::ptrdiff_t>(tells.size()), rest.end());
  } else {
    file.assign(bytes.begin(), bytes.end());
  }
  const FuzzBytes all(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
  const std::string path = scratch_file("dem.levels", all);
  const bool with_nested = bytes.size() % 2 == 0;
  const IndexFound found = find_level(path, state, set, 4, with_nested);
  expect(!found.level || found.why_not.empty(), "a level that isn't used");
  if (found.level)
    expect(std::get<std::vector<float>>(found.level->heights).size() ==
               static_cast<std::size_t>(found.level->columns * found.level->rows),
           "a level of another size than its heights");
  for (const int step : look_at_index(path, state, set).steps)
    expect(step >= 2 && step <= 30, "a step that the raster hasn't");
}

void fuzz_view(FuzzBytes bytes) {
  const std::string path = scratch_file("view.toml", bytes);
  read_or_refuse([&] {
    const std::string text = view_file_text(read_view_file(path));
    const FuzzBytes again(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    expect(view_file_text(read_view_file(scratch_file("again.toml", again))) == text,
           "a view that reads back as another");
  });
}

void fuzz_view_list(FuzzBytes bytes) {
  const std::string path = scratch_file("views.toml", bytes);
  read_or_refuse([&] { expect(!read_view_list(path).empty(), "a list without a view"); });
}

void fuzz_scene(FuzzBytes bytes) {
  const std::string path = scratch_file("scene.toml", bytes);
  read_or_refuse([&] {
    const SceneFile scene = read_scene(path);
    for (const SolidInstance& instance : scene.instances)
      expect(instance.place < scene.places.size() && instance.solid < scene.solids.size(),
             "an instance of nothing");
  });
}

void fuzz_pens(FuzzBytes bytes) {
  const std::string path = scratch_file("pens.toml", bytes);
  const std::vector<std::string_view> layers{"profiles", "border", "contours"};
  read_or_refuse([&] {
    for (const PenOfLayers& pen : read_pens(path, layers))
      expect(pen.pen.width_mm > 0 && pen.pen.number >= 1, "a pen that is none");
  });
}

void fuzz_device(FuzzBytes bytes) {
  const std::string path = scratch_file("device.toml", bytes);
  read_or_refuse([&] { expect(read_device(path).step_mm() > 0, "a device without a step"); });
}

} // namespace orograph
