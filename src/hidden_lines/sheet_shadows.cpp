// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/sheet_shadows.hpp"

#include "geometry/on_all_cores.hpp"
#include "placing/block.hpp"
#include "placing/vertex_values.hpp"
#include "profiles/sheet_vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace orograph {
namespace {

// That a solid may be behind of.
struct Found {
  std::uint32_t solid;
  TriangleShadow shadow;
};

// How much a triangle is turned to the eye, over its size: above 0 where its corners run
// counterclockwise for the eye. To rounding it is edge-on where that is no more than `rounding_m`:
// it hides nothing then, and what it would hide is told by rounding alone.
double turned_to_eye_m(const SightRays& rays, const std::array<Vec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vec3 normal = cross(b - a, c - a),
             to_eye = rays.parallel ? -1.0 * rays.from : rays.from - a;
  const double longest_m = std::max({length(b - a), length(c - b), length(a - c)});
  const double size = length(normal) + length(to_eye) * longest_m;
  return size > 0 ? dot(normal, to_eye) / size : 0;
}

using Corners = std::array<std::uint32_t, 3>;

// The solids that triangles may stand in front of, with what these hide.
class ShadowsOfTriangles {
public:
  ShadowsOfTriangles(const SolidsInView& solids, const std::vector<double>& touching_m)
      : solids_(solids), touching_m_(touching_m), rays_(sight_rays(solids.view())),
        rounding_m_(touching_m.empty() ? 0 : std::ranges::max(touching_m)) {}

  const SightRays& rays() const { return rays_; }

  // `number` tells it from all others; what touches it behind is hidden, too, or isn't.
  void add(const std::array<Vec3, 3>& corners, const Corners& order, std::uint32_t number,
           bool hides_touching, std::vector<Found>& found) const {
    const SeenBox box = seen_box(solids_.view(), corners.data(), corners.size());
    if (is_behind_eye(solids_.view(), box) || !(turned_to_eye_m(rays_, corners) > rounding_m_))
      return;
    solids_.for_each_behind(box.x_begin, box.x_end, box.y_high, box.nearest_m, [&](std::size_t i) {
      if (!SolidsInView::overlap(solids_.solids()[i].box, box)) return;
      const auto solid = static_cast<std::uint32_t>(i);
      // It may be in several buckets of X.
      for (auto of = found.rbegin(); of != found.rend() && of->shadow.triangle == number; ++of)
        if (of->solid == solid) return;
      const double slack_m = hides_touching ? -touching_m_[i] : touching_m_[i];
      found.push_back({solid, {triangle_shadow(rays_, corners, order, slack_m), box, number}});
    });
  }

private:
  const SolidsInView& solids_;
  const std::vector<double>& touching_m_;
  SightRays rays_;
  double rounding_m_;
};

// Walls and base of a block that is closed below. They and the surface are the faces of one solid:
// those that are turned to the eye hide all that it hides.
class BlockFaces {
public:
  BlockFaces(const HidingGround& ground, const SheetVertices& vertices)
      : ground_(ground), vertices_(vertices), heights_m_(heights_of(ground.terrain)),
        count_(static_cast<std::uint32_t>(vertex_count(ground.terrain.surface))) {}

  void add_wall(std::size_t edge, const ShadowsOfTriangles& shadows,
                std::vector<Found>& found) const {
    const auto& [ends, left] = ground_.placed.border[edge];
    const std::uint32_t from = left ? ends.from : ends.to, to = left ? ends.to : ends.from;
    // Counterclockwise from outside, the terrain being on the left of from -> to.
    const std::array<Vec3, 4> p{as_vec(vertices_[from]), foot(from), foot(to),
                                as_vec(vertices_[to])};
    const auto number = static_cast<std::uint32_t>(2 * edge);
    shadows.add({p[0], p[1], p[2]}, {from, count_ + from, count_ + to}, number, false, found);
    shadows.add({p[0], p[2], p[3]}, {from, count_ + to, to}, number + 1, false, found);
  }

  // Below a triangle.
  void add_base(const Corners& corners, std::uint32_t number, const ShadowsOfTriangles& shadows,
                std::vector<Found>& found) const {
    const auto& [a, b, c] = corners;
    shadows.add({foot(a), foot(c), foot(b)}, {a, c, b}, number, false, found);
  }

private:
  Vec3 foot(std::uint32_t vertex) const {
    double height_m = 0;
    heights_m_(vertex, std::span(&height_m, 1));
    const Surface& surface = ground_.terrain.surface;
    const Grid* const grid = std::get_if<Grid>(&surface);
    const Vec3 at = grid ? grid->vertex_m(vertex) : std::get<Tin>(surface).vertices_m[vertex];
    return as_vec(
        to_profile_frame(ground_.sector.view, below_vertex_m(ground_.terrain, at, height_m,
                                                             *ground_.placed.block_base_m)));
  }

  const HidingGround& ground_;
  const SheetVertices& vertices_;
  VertexValues heights_m_;
  std::uint32_t count_; ///< of vertices
};

} // namespace

std::vector<std::vector<TriangleShadow>> sheet_shadows(const HidingGround& ground,
                                                       const SolidsInView& solids,
                                                       const std::vector<double>& touching_m) {
  const Sheet& sheet = *ground.sheet;
  const SheetPart all(sheet.triangles);
  const SheetPart& part = ground.sheet_part ? *ground.sheet_part : all;
  const SheetVertices vertices(ground.terrain.surface, solids.view());
  const ShadowsOfTriangles shadows(solids, touching_m);
  std::optional<BlockFaces> block;
  if (ground.placed.block_base_m) block.emplace(ground, vertices);
  const auto first_base = static_cast<std::uint32_t>(sheet.triangles.count());
  constexpr std::uint32_t kTrianglesOfTask = 1U << 15U;
  const std::size_t tasks = (part.count() + kTrianglesOfTask - 1) / kTrianglesOfTask;
  std::vector<std::vector<Found>> of_tasks(tasks + 1); // the last for walls
  on_all_cores(tasks, [&](std::size_t task) {
    const std::uint32_t begin = static_cast<std::uint32_t>(task) * kTrianglesOfTask;
    part.for_each(begin, std::min(part.count(), begin + kTrianglesOfTask),
                  [&](std::uint32_t t, std::uint32_t) {
                    if (!sheet.triangles.is_there(t)) return;
                    Corners order = sheet.triangles.corners(t);
                    if (block) block->add_base(order, first_base + t, shadows, of_tasks[task]);
                    const bool is_up = sheet.is_up[t] != 0;
                    if (!is_up && block) return;               // within it
                    if (!is_up) std::swap(order[1], order[2]); // counterclockwise for the eye
                    std::array<Vec3, 3> corners;
                    std::ranges::transform(order, corners.begin(), [&](std::uint32_t vertex) {
                      return as_vec(vertices[vertex]);
                    });
                    shadows.add(corners, order, t, !is_up, of_tasks[task]);
                  });
  });
  if (block)
    for (std::size_t i = 0; i < ground.placed.border.size(); ++i)
      block->add_wall(i, shadows, of_tasks.back());
  std::vector<std::vector<TriangleShadow>> out(solids.solids().size());
  for (const std::vector<Found>& found : of_tasks)
    for (const auto& [solid, shadow] : found) out[solid].push_back(shadow);
  return out;
}

} // namespace orograph
