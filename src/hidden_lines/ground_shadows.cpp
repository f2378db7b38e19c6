// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/ground_shadows.hpp"

#include "dem/triangles_over.hpp"
#include "geometry/on_all_cores.hpp"
#include "profiles/slab_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

// What lies on the ground by no more than this lies on it, times the rounding of positions: a
// triangle's plane is told by three of them, across its own slope.
constexpr double kTouching = 16;

struct Found {
  std::uint32_t solid;
  GroundEdge edge;
};

// Edges of the ground, against the solids that they may stand in front of.
class EdgeShadows {
public:
  EdgeShadows(const SolidsInView& solids, const View& view) : solids_(solids), view_(view) {}

  void add(ProfilePoint from, ProfilePoint to, std::vector<Found>& found) const {
    if (view_.is_perspective()) {
      const double near_m = view_.near_m;
      if (from.v < near_m && to.v < near_m) return;
      if (std::min(from.v, to.v) < near_m)
        (from.v < to.v ? from : to) = point_between(from, to, (near_m - from.v) / (to.v - from.v));
    }
    Vec2 left = project(view_, from), right = project(view_, to);
    if (left.x > right.x) {
      std::swap(left, right);
      std::swap(from, to);
    }
    if (!(left.x < right.x)) return;
    const double high = std::max(left.y, right.y);
    const std::size_t first = found.size();
    solids_.for_each_behind(left.x, right.x, high, std::min(from.v, to.v), [&](std::size_t i) {
      // It may be in several buckets of X.
      for (std::size_t k = first; k < found.size(); ++k)
        if (found[k].solid == i) return;
      found.push_back(
          {static_cast<std::uint32_t>(i), {as_vec(from), as_vec(to), left.x, right.x, high}});
    });
  }

private:
  const SolidsInView& solids_;
  const View& view_;
};

void add_buried(const TerrainData& terrain, const PlacedView& placed, const SolidsInView& solids,
                std::vector<GroundShadows>& out) {
  std::vector<Box2> boxes;
  for (const SolidInView& solid : solids.solids()) {
    Box2 box;
    for (const Vec3& vertex : solid.standing->vertices_m) box.include({vertex.x, vertex.y});
    boxes.push_back(box);
  }
  const auto triangles = triangles_over(terrain.surface, placed.extent, boxes);
  on_all_cores(boxes.size(), [&](std::size_t i) {
    for (const GroundTriangle& triangle : triangles[i]) {
      std::array<Vec3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = as_vec(to_profile_frame(solids.view(), triangle[k]));
      out[i].buried.push_back(buried_under(corners, out[i].touching_m));
    }
  });
}

} // namespace

std::vector<GroundShadows> ground_shadows(const TerrainData& terrain, const PlacedView& placed,
                                          const Sector& sector, const std::vector<EdgeLine>& lines,
                                          const std::vector<LinePart>& visible,
                                          std::span<const Segment> near_cut,
                                          const SolidsInView& solids) {
  const View& view = sector.view;
  std::vector<GroundShadows> out(solids.solids().size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i].touching_m = kTouching * solids.solids()[i].rounding_m;
  add_buried(terrain, placed, solids, out);
  // Straight down, nothing stands in front of anything.
  if (!view.is_perspective() && !(view.y_per_z > 0)) return out;

  const EdgeShadows shadows(solids, view);
  const EdgeEnds ends(terrain.surface, view);
  std::vector<LinePart> hiding;
  for (const LinePart& part : visible)
    if (lines[part.line].hides) hiding.push_back(part);
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].hides && !lines[i].drawn) hiding.push_back({static_cast<std::uint32_t>(i), 0, 1});
  constexpr std::size_t kPartsOfTask = 1U << 12U;
  const std::size_t tasks = (hiding.size() + kPartsOfTask - 1) / kPartsOfTask;
  std::vector<std::vector<Found>> of_tasks(tasks + 1); // the last for the near cut
  on_all_cores(tasks, [&](std::size_t task) {
    const std::size_t end = std::min(hiding.size(), (task + 1) * kPartsOfTask);
    for (std::size_t i = task * kPartsOfTask; i < end; ++i) {
      const ProfileLine line = ends(lines[hiding[i].line].edge);
      shadows.add(point_between(line.from, line.to, hiding[i].t_begin),
                  point_between(line.from, line.to, hiding[i].t_end), of_tasks[task]);
    }
  });
  for (const Segment& s : near_cut)
    shadows.add({s.x0 * view.near_m, view.near_m, s.y0 * view.near_m + view.eye_z_m},
                {s.x1 * view.near_m, view.near_m, s.y1 * view.near_m + view.eye_z_m},
                of_tasks.back());
  for (const auto& found : of_tasks)
    for (const auto& [solid, edge] : found) out[solid].edges.push_back(edge);
  return out;
}

} // namespace orograph
