// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/on_all_cores.hpp"
#include "profiles/cut_mesh.hpp"
#include "profiles/facing.hpp"
#include "profiles/mesh_walk.hpp"
#include "profiles/surface_edges.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace orograph {
namespace {

struct CutTinMesh : TinMesh {
  const TriangleSet &level, &walls, &turned_walls;

  bool is_wall(std::uint32_t t) const { return !walls.empty() && walls.has(t); }
  Span span_in(std::uint32_t t) const {
    if (is_wall(t)) return turned_walls.has(t) ? Span::gap : Span::wall;
    return !level.empty() && level.has(t) ? Span::level : Span::slope;
  }
};

std::vector<TinSide> border_of(const Tin& tin) {
  std::vector<TinSide> border;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    for (std::uint8_t k = 0; k < 3; ++k)
      if (tin.neighbours[t][k] == kNoTriangle) border.push_back({t, k});
  }
  return border;
}

} // namespace

TinCutter::TinCutter(const Tin& tin, const View& view, const TriangleSet& level)
    : tin_(tin), view_(view), level_(level), nearest_m_(std::numeric_limits<double>::infinity()),
      farthest_m_(-nearest_m_), walls_(walls_of(tin)),
      border_(border_of(tin), [&](const TinSide& side) {
        const auto depth = [&](std::size_t n) {
          return to_profile_frame(view,
                                  tin.vertices_m[tin.triangles[side.triangle][(side.k + n) % 3]])
              .v;
        };
        const double a = depth(1), b = depth(2);
        return BorderSides<TinSide>::Depths{std::min(a, b), std::max(a, b)};
      }) {
  std::size_t step = 0;
  for (const Vec3& vertex : tin.vertices_m) {
    throw_if_stopped(step++);
    const double v = to_profile_frame(view, vertex).v;
    nearest_m_ = std::min(nearest_m_, v);
    farthest_m_ = std::max(farthest_m_, v);
  }
  if (walls_.empty()) return;
  turned_walls_ = TriangleSet(tin.triangles.size());
  const std::vector<std::uint8_t> facing = facing_of_triangles(tin, view);
  for (std::size_t t = 0; t < facing.size(); ++t)
    if (walls_.has(t) && (facing[t] & kMayTurn)) turned_walls_.add(t); // edge-on, too
}

void TinCutter::cut(double depth_m, Profile& out) const {
  out.clear();
  out.depth_m = depth_m;
  if (!(depth_m >= nearest_m_ && depth_m <= farthest_m_)) return;
  // Vertices in the plane count as far, except where the TIN only touches the plane from behind:
  // then nothing would be near.
  cut_mesh(CutTinMesh{{tin_, view_}, level_, walls_, turned_walls_}, border_.at(depth_m), depth_m,
           depth_m > nearest_m_, out);
}

} // namespace orograph
