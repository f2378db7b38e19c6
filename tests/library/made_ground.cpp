// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/library/made_ground.hpp"

#include "bench/scenes.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/support/random.hpp"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>

namespace orograph {
namespace {

constexpr double kCell_m = 30, kWest_m = 500000, kNorth_m = 5000000;

} // namespace

OwnedHeights rough_heights(int side) {
  const Grid grid = fractal_terrain(side);
  const auto& heights = std::get<Heights<float>>(grid.heights_m);
  return std::make_shared<std::vector<float>>(heights.begin(), heights.end());
}

GridInput borrowed(const OwnedHeights& heights, int side) {
  GridInput input;
  input.columns = input.rows = side;
  input.heights = std::span<const float>(*heights);
  input.owner = heights;
  input.geotransform = {kWest_m, kCell_m, 0, kNorth_m, 0, -kCell_m};
  input.crs = "EPSG:32632";
  return input;
}

TinInput hill_of_triangles(int side) {
  TinInput input;
  const auto n = static_cast<std::uint32_t>(side);
  for (std::uint32_t row = 0; row < n; ++row)
    for (std::uint32_t column = 0; column < n; ++column) {
      const double x = column / (n - 1.0) - 0.5, y = row / (n - 1.0) - 0.5;
      const double height_m = 250 * std::exp(-8 * (x * x + y * y)) + 9 * std::sin(29 * x + 17 * y);
      input.points.push_back({kWest_m + 1000 * x, kNorth_m + 1000 * y, height_m});
    }
  for (std::uint32_t row = 0; row + 1 < n; ++row)
    for (std::uint32_t column = 0; column + 1 < n; ++column) {
      const std::uint32_t at = row * n + column;
      input.triangles.push_back({at, at + 1, at + n});
      input.triangles.push_back({at + 1, at + n + 1, at + n});
    }
  return input;
}

GivenPlace middle(int side) {
  return {kWest_m + 0.5 * kCell_m * side, kNorth_m - 0.5 * kCell_m * side};
}

std::vector<MapSpec> many_specs(int side) {
  std::vector<MapSpec> specs(8);
  specs[0].view.from_azimuth = Angle::degrees(217);
  specs[1].view.projection = Projection::orthographic;
  specs[1].style.layers = {"profiles", "edges", "border", "silhouettes", "skyline"};
  specs[1].style.silhouette_jump = 0;
  specs[2].view.eye_map = middle(side);
  specs[2].view.eye_height_m = 150;
  specs[2].view.look_azimuth = Angle::degrees(40);
  specs[2].view.field_of_view = Angle::degrees(70);
  specs[2].ground_points = true;
  specs[3].style.occluder = Occluder::profiles;
  specs[3].style.plan = ProfileCount{60};
  specs[3].style.flat = FlatGround::draw;
  specs[4].view.from_elevation = Angle::degrees(90); // straight down: sectors ahead and behind
  specs[4].view.field_of_view = Angle::degrees(70);
  specs[5].view.projection = Projection::oblique;
  specs[5].view.from_azimuth = Angle::degrees(300);
  specs[5].style.min_stroke_mm = 0.5;
  specs[6].check = 2000;
  specs[6].view.from_elevation = Angle::degrees(8);
  specs[7].style.plan = GroundSpacing{4 * kCell_m};
  specs[7].view.exaggeration = 3;
  specs[7].page.width_mm = 400;
  return specs;
}

std::vector<MapSpec> enough_specs(int side) {
  std::vector<MapSpec> specs = many_specs(side);
  specs.resize(last_seed(specs.size()));
  return specs;
}

std::string bytes_of(const Drawing& drawing) {
  const bool on_ground = !drawing.layers.empty() && !drawing.layers.front().map.empty();
  const TempFolder folder;
  const std::string path = folder.file(on_ground ? "map.geojson" : "map.svg");
  write_drawing(drawing, path, {.format = format_of_path(path)});
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string drawn_bytes(const Session& session, const MapSpec& spec, const Control& control) {
  return bytes_of(session.draw(spec, control).drawing);
}

} // namespace orograph
