// SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/block.hpp"

#include "dem/surface.hpp"
#include "geometry/error.hpp"
#include "geometry/sort_by_number.hpp"
#include "placing/vertex_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <variant>

namespace orograph {
namespace {

// Of the relief, by eye: so much of a pedestal that one sees a block, and not a plinth.
constexpr double kDepthOverRelief = 0.15;

// Of points.
constexpr std::size_t kOfBlock = 2048;

} // namespace

double block_base_m(const TerrainData& terrain, const BlockSpec& spec) {
  if (!has_ground(terrain.surface))
    throw UsageError("without a terrain there is no block", "leave the block out");
  const auto [low_m, high_m] = height_range_of(terrain);
  const double base_m = spec.base ? *spec.base * spec.unit_m.value_or(terrain.map.height_unit_m)
                                  : low_m - kDepthOverRelief * (high_m - low_m);
  if (base_m < low_m) return base_m;
  const double unit_m = spec.unit_m.value_or(terrain.map.height_unit_m);
  if (!spec.base)
    throw UsageError(
        fmt::format("a terrain that is level, at {:.6g}, has no relief that tells a block's depth",
                    low_m / unit_m),
        "give the block a base below that");
  throw UsageError(fmt::format("a block's base at {:.6g} isn't below the terrain, whose lowest "
                               "height is {:.6g}",
                               *spec.base, low_m / unit_m),
                   fmt::format("give a base below {:.6g}", low_m / unit_m));
}

std::vector<std::uint32_t> vertices_of(const std::vector<BorderEdge>& border) {
  std::vector<std::uint32_t> vertices;
  for (const auto& [edge, left] : border) vertices.insert(vertices.end(), {edge.from, edge.to});
  sort_by_number(vertices, [](std::uint32_t vertex) { return vertex; });
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<Vec3> block_feet_m(const TerrainData& terrain, const std::vector<BorderEdge>& border,
                               double base_m) {
  const VertexValues heights = heights_of(terrain);
  std::vector<Vec3> feet;
  for (const std::uint32_t vertex : vertices_of(border)) {
    double height_m = 0;
    heights(vertex, std::span(&height_m, 1));
    const Grid* grid = std::get_if<Grid>(&terrain.surface);
    const Vec3 at =
        grid ? grid->vertex_m(vertex) : std::get<Tin>(terrain.surface).vertices_m[vertex];
    feet.push_back(below_vertex_m(terrain, at, height_m, base_m));
  }
  return feet;
}

namespace {

double exaggeration_of_heights(const View& view, const MapFrame& map) {
  return map.earth ? map.earth->exaggeration : view.exaggeration;
}

} // namespace

// On the ellipsoid the frame lies below the eye, and heights went there exaggerated.
double base_z_m(double base_m, const View& view, const MapFrame& map) {
  return base_m * exaggeration_of_heights(view, map);
}

void check_outside_block(const View& view, double ground_z_m, double base_m, const MapFrame& map) {
  if (view.eye_z_m >= ground_z_m || view.eye_z_m < base_z_m(base_m, view, map)) return;
  const double exaggeration = exaggeration_of_heights(view, map);
  throw Error(fmt::format("the eye is in the block, {:.6g} m under the ground",
                          (ground_z_m - view.eye_z_m) / exaggeration),
              "raise the eye, lower it below the block's base, or leave out `block`");
}

void add_points(const std::vector<Vec3>& feet_m, BlockedPoints& beside) {
  const std::size_t others = beside.boxes.size();
  for (std::size_t first = 0; first < feet_m.size(); first += kOfBlock) {
    Box3 box;
    for (std::size_t i = first; i < std::min(first + kOfBlock, feet_m.size()); ++i)
      box.include(feet_m[i]);
    beside.boxes.push_back(box);
  }
  beside.points = [&feet_m, others, before = beside.points](std::size_t i) {
    if (i < others) return before(i);
    const std::size_t first = (i - others) * kOfBlock;
    return std::span(feet_m).subspan(first, std::min(kOfBlock, feet_m.size() - first));
  };
}

} // namespace orograph
