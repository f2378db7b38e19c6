// SPDX-License-Identifier: GPL-3.0-or-later
// GeoJSON and GeoPackage of a grid in degrees are in the grid's own coordinates, with true heights.
#include "cli/render.hpp"
#include "dem/frame/local_frame.hpp"
#include "tests/catch.hpp"
#include "tests/dem/read/raster_file.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/support/random.hpp"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace orograph::earth_output_test {
namespace {

// As a user counts it, all in the file's own unit of angle and of longitudes.
struct Lattice {
  double first_lon = 0, first_lat = 0, lon_step = 0, lat_step = 0;
  int columns = 40, rows = 40;
};

struct DegreesFile {
  std::string crs = "EPSG:4326";
  std::string code = "4326";
  double unit_deg = 1;
  Ellipsoid ellipsoid;
  Lattice lattice;
  std::vector<double> heights_m;

  double lon(int column) const { return lattice.first_lon + column * lattice.lon_step; }
  double lat(int row) const { return lattice.first_lat - row * lattice.lat_step; }
  double height_m(int column, int row) const {
    return heights_m[static_cast<std::size_t>(row * lattice.columns + column)];
  }
};

// Hills with whole metres of roughness, no two neighbours of which are level.
DegreesFile made_file(Random& random, const Lattice& lattice) {
  DegreesFile file;
  file.lattice = lattice;
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column)
      file.heights_m.push_back(400 + 250 * std::sin(0.4 * column) * std::cos(0.3 * row) +
                               random.whole(0, 40) + 0.01 * column + 0.003 * row);
  return file;
}

void write(const DegreesFile& file, const std::string& path) {
  const Lattice& l = file.lattice;
  RasterFile raster;
  raster.pixels = l.columns;
  raster.lines = l.rows;
  raster.values = file.heights_m;
  raster.type = "Float64";
  raster.crs = file.crs;
  raster.geotransform = {l.first_lon - 0.5 * l.lon_step, l.lon_step, 0,
                         l.first_lat + 0.5 * l.lat_step, 0,          -l.lat_step};
  write_raster(raster, path);
}

struct WrittenStroke {
  std::string layer;
  double depth_m = 0;
  std::vector<Vec3> points;
};

std::vector<WrittenStroke> read_strokes(const std::string& path, const std::string& code) {
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
  REQUIRE(dataset);
  OGRLayer& layer = *dataset->GetLayer(0);
  REQUIRE(layer.GetSpatialRef() != nullptr);
  const char* found = layer.GetSpatialRef()->GetAuthorityCode(nullptr);
  CHECK(std::string(found ? found : "none") == code);
  std::vector<WrittenStroke> strokes;
  for (const auto& feature : layer) {
    WrittenStroke stroke;
    stroke.layer = feature->GetFieldAsString("layer");
    stroke.depth_m = feature->GetFieldAsDouble("depth");
    const OGRLineString& line = *feature->GetGeometryRef()->toLineString();
    for (int i = 0; i < line.getNumPoints(); ++i)
      stroke.points.push_back({line.getX(i), line.getY(i), line.getZ(i)});
    strokes.push_back(stroke);
  }
  return strokes;
}

struct Asked {
  std::string name, format;
  double exaggeration = 1, refraction = 0;
  double azimuth_deg = 20;
  Vec3 eye; ///< in the file's coordinates, true height
};

std::vector<WrittenStroke> drawn(const DegreesFile& file, const Asked& asked) {
  const TempFolder folder;
  RenderSettings settings;
  settings.inputs = {folder.file("made.tif")};
  write(file, settings.inputs.front());
  settings.output = folder.file("out." + asked.format);
  settings.write.format = format_of_name(asked.format);
  MapSpec& spec = settings.map;
  spec.ground_points = true;
  spec.view.eye_map = asked.eye;
  spec.view.look_azimuth = Angle::degrees(asked.azimuth_deg);
  spec.view.pitch = Angle::degrees(-5);
  spec.view.field_of_view = Angle::degrees(70);
  spec.view.exaggeration = asked.exaggeration;
  spec.view.curvature = Curvature::on;
  spec.view.refraction = asked.refraction;
  spec.style.simplify_mm = 0;
  spec.style.silhouette_jump = 0;
  spec.style.plan = ProfileCount{40};
  spec.style.layers = {"profiles", "edges", "border", "silhouettes", "skyline"};
  settings.quiet = true;
  render(settings);
  return read_strokes(settings.output, file.code);
}

// The frame below the eye, and the file's ground in it, exaggerated before it goes to its place.
struct Ground {
  const DegreesFile& file;
  LocalFrame frame;
  double exaggeration;

  Vec3 place_m(Vec3 in_file) const {
    return frame.to_frame(in_file.x * file.unit_deg, in_file.y * file.unit_deg,
                          in_file.z * exaggeration);
  }
  Vec3 vertex_m(int column, int row) const {
    return place_m({file.lon(column), file.lat(row), file.height_m(column, row)});
  }

  // How high a point of the frame lies above the triangle that is below it in the frame, of those
  // some cells around a place of the file. None where none is.
  std::optional<double> above_m(Vec3 p, Vec3 in_file) const {
    const Lattice& l = file.lattice;
    const int c0 = static_cast<int>(std::floor((in_file.x - l.first_lon) / l.lon_step));
    const int r0 = static_cast<int>(std::floor((l.first_lat - in_file.y) / l.lat_step));
    std::optional<double> least;
    for (int r = std::max(r0 - 1, 0); r <= std::min(r0 + 1, l.rows - 2); ++r)
      for (int c = std::max(c0 - 1, 0); c <= std::min(c0 + 1, l.columns - 2); ++c) {
        const Vec3 north_west = vertex_m(c, r), south_east = vertex_m(c + 1, r + 1);
        for (const Vec3& third : {vertex_m(c, r + 1), vertex_m(c + 1, r)}) {
          const Vec3 normal = cross(south_east - north_west, third - north_west);
          const auto side = [&](Vec3 a, Vec3 b) {
            return cross(Vec2{b.x - a.x, b.y - a.y}, Vec2{p.x - a.x, p.y - a.y}) *
                   (normal.z > 0 ? 1 : -1) / std::hypot(b.x - a.x, b.y - a.y);
          };
          // Points on the edges are within a tenth of a millimetre of either side.
          if (std::min({side(north_west, south_east), side(south_east, third),
                        side(third, north_west)}) < -1e-4)
            continue;
          const double above =
              p.z - north_west.z +
              (normal.x * (p.x - north_west.x) + normal.y * (p.y - north_west.y)) / normal.z;
          if (!least || std::abs(above) < std::abs(*least)) least = above;
        }
      }
    return least;
  }
};

// All that is wrong with a file's strokes, as the greatest differences.
struct Found {
  double from_plane_m = 0, above_m = 0; ///< of profiles: from the plane of their depth, the surface
  double from_vertex_deg = 0, from_vertex_m = 0; ///< of the vertices of edges
  int profile_points = 0, vertices = 0, off_the_ground = 0;
};

void judge_profile(const Ground& ground, const WrittenStroke& stroke, double azimuth_deg,
                   Found& found) {
  const Vec2 forward = direction_of_azimuth(Angle::degrees(azimuth_deg));
  for (const Vec3& point : stroke.points) {
    const Vec3 p = ground.place_m(point);
    found.from_plane_m =
        std::max(found.from_plane_m, std::abs(dot(Vec2{p.x, p.y}, forward) - stroke.depth_m));
    const auto above = ground.above_m(p, point);
    if (above)
      found.above_m = std::max(found.above_m, std::abs(*above));
    else
      ++found.off_the_ground;
    ++found.profile_points;
  }
}

// Inside of a stroke, where it goes on to the next edge, its points are vertices.
void judge_edges(const DegreesFile& file, const WrittenStroke& stroke, Found& found) {
  const Lattice& l = file.lattice;
  for (std::size_t i = 1; i + 1 < stroke.points.size(); ++i) {
    const Vec3 p = stroke.points[i];
    const int column = std::clamp(static_cast<int>(std::lround((p.x - l.first_lon) / l.lon_step)),
                                  0, l.columns - 1);
    const int row =
        std::clamp(static_cast<int>(std::lround((l.first_lat - p.y) / l.lat_step)), 0, l.rows - 1);
    found.from_vertex_deg =
        std::max({found.from_vertex_deg, file.unit_deg * std::abs(p.x - file.lon(column)),
                  file.unit_deg * std::abs(p.y - file.lat(row))});
    found.from_vertex_m = std::max(found.from_vertex_m, std::abs(p.z - file.height_m(column, row)));
    ++found.vertices;
  }
}

void check(const DegreesFile& file, const Asked& asked) {
  CAPTURE(asked.name, asked.format, asked.exaggeration, asked.refraction);
  const Ground ground{
      file, LocalFrame(asked.eye.x * file.unit_deg, asked.eye.y * file.unit_deg, file.ellipsoid),
      asked.exaggeration};
  Found found;
  for (const WrittenStroke& stroke : drawn(file, asked)) {
    if (stroke.layer == "profiles") judge_profile(ground, stroke, asked.azimuth_deg, found);
    if (stroke.layer == "edges") judge_edges(file, stroke, found);
  }
  CHECK(found.profile_points > 200);
  CHECK(found.vertices > 100);
  CHECK(found.off_the_ground == 0);
  CHECK(found.from_plane_m <= 1e-5); // 1e-9 degrees are 1e-4 m
  CHECK(found.above_m <= 1e-3);
  CHECK(found.from_vertex_deg <= 1e-9);
  CHECK(found.from_vertex_m <= 1e-4);
}

constexpr double kStep_deg = 1. / 1200;

// Above the middle of the southern side.
Asked seen_from_south(const DegreesFile& file, const std::string& name, const std::string& format) {
  const Lattice& l = file.lattice;
  Asked asked;
  asked.name = name;
  asked.format = format;
  asked.eye = {l.first_lon + 0.45 * (l.columns - 1) * l.lon_step,
               l.first_lat - (l.rows + 3) * l.lat_step, 1100};
  return asked;
}

} // namespace

TEST_CASE("strokes are written in degrees with true heights, exaggerated and refracted or not") {
  Random random(1);
  const DegreesFile file = made_file(random, {7.1, 46.3, kStep_deg, kStep_deg});
  for (const char* format : {"geojson", "gpkg"})
    for (const double exaggeration : {1.0, 3.0})
      for (const double refraction : {0.0, 0.13}) {
        Asked asked = seen_from_south(file, "plain", format);
        asked.exaggeration = exaggeration;
        asked.refraction = refraction;
        check(file, asked);
      }
}

TEST_CASE("longitudes are written in the grid's own turn") {
  Random random(2);
  for (const char* format : {"geojson", "gpkg"})
    for (const double lon : {359.98, 179.98, -180.0, -72.6}) {
      const DegreesFile file = made_file(random, {lon, -33.7, kStep_deg, kStep_deg});
      Asked asked = seen_from_south(file, "from longitude " + std::to_string(lon), format);
      check(file, asked);
      // An eye that is told in another turn is the same.
      asked.eye.x += asked.eye.x > 100 ? -360 : 360;
      asked.name += ", eye in another turn";
      check(file, asked);
    }
}

TEST_CASE("a CRS in grads, with a meridian of its own, is written in grads") {
  Random random(3);
  DegreesFile file = made_file(random, {4.2, 51.0, 0.001, 0.001});
  file.crs = "EPSG:4807";
  file.code = "4807";
  file.unit_deg = 0.9;
  file.ellipsoid = {6378249.2, 293.466021293627}; // Clarke 1880 (IGN)
  for (const char* format : {"geojson", "gpkg"}) {
    Asked asked = seen_from_south(file, "grads", format);
    asked.refraction = 0.13;
    asked.exaggeration = 2;
    check(file, asked);
  }
}

// Around the pole a grid spans all longitudes, and the eye may stand at any of them.
TEST_CASE("a ring around the pole is written in its own turn, wherever the eye stands") {
  Random random(4);
  for (const double eye_lon : {100.0, 10.0, 350.0}) {
    DegreesFile file = made_file(random, {0.5, 89.6, 1, 0.02, 360, 25});
    Asked asked = seen_from_south(file, "ring", "gpkg");
    asked.eye = {eye_lon, 88.9, 3000};
    asked.azimuth_deg = 5;
    check(file, asked);
  }
}

} // namespace orograph::earth_output_test
