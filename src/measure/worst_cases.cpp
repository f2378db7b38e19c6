// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/worst_cases.hpp"

#include "dem/mesh/tin_from_triangles.hpp"

#include <array>

namespace orograph {
namespace {

constexpr auto kGate = "gate before ridges", kComb = "comb before a slope";
// From the south, so that the last row of a grid is the nearest.
constexpr double kAzimuth_deg = 180, kElevation_deg = 10;
constexpr double kWidth_m = 1000, kDepth_m = 1000;

TerrainData terrain_of(Surface surface, const std::string& name) {
  TerrainData terrain{std::move(surface), {}, name, {}, {}, {}, 0};
  return terrain;
}

} // namespace

TerrainData gate_before_ridges(int ridges) {
  constexpr int kColumns = 16, kPost = 5; // columns of either post
  constexpr double kPostHeight_m = 1200;  // above the eye: what is beside the gate is hidden
  const int rows = 2 * ridges + 2;
  Grid grid;
  grid.columns = kColumns;
  grid.rows = rows;
  const double row_m = kDepth_m / (rows - 1);
  grid.lattice =
      PlaneLattice{{-kWidth_m / 2, kDepth_m}, {kWidth_m / (kColumns - 1), 0}, {0, -row_m}};
  std::vector<float> heights(grid.size());
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const int from_front = rows - 1 - row;
      const bool post = column < kPost || column >= kColumns - kPost;
      // Ridges fall at 45 degrees, steeper than the eye looks.
      double height_m = from_front % 2 == 1 ? row_m : 0;
      if (from_front == 0 && post) height_m = kPostHeight_m;
      heights[grid.index(column, row)] = static_cast<float>(height_m);
    }
  grid.heights_m = std::move(heights);
  return terrain_of(std::move(grid), kGate);
}

TerrainData comb_before_slope(int teeth) {
  constexpr double kTooth_m = 600; // on the page the slope ends below it
  const auto corner = [](double x, double y, double z) { return Vec3{x, y, z}; };
  TriangleSoup soup;
  const auto add_quad = [&](const std::array<Vec3, 4>& corners) {
    const auto first = static_cast<std::uint32_t>(soup.points_m.size());
    soup.points_m.insert(soup.points_m.end(), corners.begin(), corners.end());
    soup.triangles.push_back({first, first + 1, first + 2});
    soup.triangles.push_back({first, first + 2, first + 3});
  };
  const double depth_m = 3 * kDepth_m / teeth; // some profiles cut the comb, however many there are
  for (int i = 0; i < 2 * teeth; ++i) {
    const double left = kWidth_m * (i / (2.0 * teeth) - 0.5);
    const double right = kWidth_m * ((i + 1) / (2.0 * teeth) - 0.5);
    const double at_left = i % 2 == 0 ? 0 : kTooth_m, at_right = kTooth_m - at_left;
    add_quad({corner(left, 0, at_left), corner(right, 0, at_right),
              corner(right, depth_m, at_right), corner(left, depth_m, at_left)});
  }
  const double side = 0.45 * kWidth_m, front = 2 * depth_m, back = front + kDepth_m;
  add_quad({corner(-side, front, 0), corner(side, front, 0), corner(side, back, 200),
            corner(-side, back, 200)});
  return terrain_of(tin_from_triangles(soup, false, kComb).tin, kComb);
}

std::vector<FragmentationRow> worst_case_rows(const FragmentationSpec& spec) {
  std::vector<FragmentationRow> rows;
  const auto add = [&](const std::string& scene, Occluder occluder, int size) {
    FragmentationRow& row = rows.emplace_back();
    row.scene = scene;
    row.occluder = occluder;
    row.azimuth_deg = kAzimuth_deg;
    row.elevation_deg = kElevation_deg;
    row.profiles = size;
  };
  for (const char* scene : {kGate, kComb})
    for (const Occluder occluder : {Occluder::profiles, Occluder::surface})
      for (int share = 16; share >= 1; share /= 2)
        if (const int size = spec.worst_case / share; size >= 8) add(scene, occluder, size);
  return rows;
}

TerrainData worst_case_terrain(const FragmentationRow& row) {
  return row.scene == kGate ? gate_before_ridges(row.profiles) : comb_before_slope(row.profiles);
}

} // namespace orograph
