// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sheet_shadows.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/sheet_vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace orograph {
namespace {

// That a solid may be behind of.
struct Found {
  std::uint32_t solid;
  TriangleShadow shadow;
};

// To rounding: it hides nothing then, and what it would hide is told by rounding alone.
bool is_edge_on(const SightRays& rays, const std::array<Vec3, 3>& corners, double rounding_m) {
  const auto& [a, b, c] = corners;
  const Vec3 normal = cross(b - a, c - a), to_eye = rays.parallel ? rays.from : rays.from - a;
  const double longest_m = std::max({length(b - a), length(c - b), length(a - c)});
  const double off = rounding_m * (length(normal) + length(to_eye) * longest_m);
  return std::abs(dot(normal, to_eye)) <= off;
}

} // namespace

std::vector<std::vector<TriangleShadow>> sheet_shadows(const HidingGround& ground,
                                                       const SolidsInView& solids,
                                                       const std::vector<double>& touching_m) {
  const View& view = solids.view();
  const Sheet& sheet = *ground.sheet;
  const SheetPart all(sheet.triangles);
  const SheetPart& part = ground.sheet_part ? *ground.sheet_part : all;
  const SheetVertices vertices(ground.terrain.surface, view);
  const SightRays rays = sight_rays(view);
  const double rounding_m = touching_m.empty() ? 0 : std::ranges::max(touching_m);
  constexpr std::uint32_t kTrianglesOfTask = 1U << 15U;
  std::vector<std::vector<Found>> of_tasks((part.count() + kTrianglesOfTask - 1) /
                                           kTrianglesOfTask);
  on_all_cores(of_tasks.size(), [&](std::size_t task) {
    const std::uint32_t begin = static_cast<std::uint32_t>(task) * kTrianglesOfTask;
    part.for_each(
        begin, std::min(part.count(), begin + kTrianglesOfTask),
        [&](std::uint32_t t, std::uint32_t) {
          if (!sheet.triangles.is_there(t)) return;
          std::array<std::uint32_t, 3> order = sheet.triangles.corners(t);
          const bool is_up = sheet.is_up[t] != 0;
          if (!is_up) std::swap(order[1], order[2]); // counterclockwise for the eye
          std::array<Vec3, 3> corners;
          std::ranges::transform(order, corners.begin(),
                                 [&](std::uint32_t vertex) { return as_vec(vertices[vertex]); });
          const SeenBox box = seen_box(view, corners.data(), corners.size());
          if (is_behind_eye(view, box) || is_edge_on(rays, corners, rounding_m)) return;
          solids.for_each_behind(
              box.x_begin, box.x_end, box.y_high, box.nearest_m, [&](std::size_t i) {
                std::vector<Found>& found = of_tasks[task];
                const SeenBox& of_solid = solids.solids()[i].box;
                if (!SolidsInView::overlap(of_solid, box)) return;
                const auto number = static_cast<std::uint32_t>(i);
                // It may be in several buckets of X.
                for (auto of = found.rbegin(); of != found.rend() && of->shadow.triangle == t; ++of)
                  if (of->solid == number) return;
                const double slack_m = is_up ? touching_m[i] : -touching_m[i];
                found.push_back({number, {triangle_shadow(rays, corners, order, slack_m), box, t}});
              });
        });
  });
  std::vector<std::vector<TriangleShadow>> out(solids.solids().size());
  for (const std::vector<Found>& found : of_tasks)
    for (const auto& [solid, shadow] : found) out[solid].push_back(shadow);
  return out;
}

} // namespace orograph
