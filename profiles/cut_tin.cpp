// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/box.hpp"
#include "geometry/on_all_cores.hpp"
#include "profiles/cut_mesh.hpp"
#include "profiles/facing.hpp"
#include "profiles/mesh_walk.hpp"
#include "profiles/surface_edges.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
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

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// With room for rounding, of which a vertex may have another than its box's corner.
BorderSides<std::uint32_t>::Depths depths_of(const View& view, const Box2& box) {
  Range corners;
  for (const double x : {box.low.x, box.high.x})
    for (const double y : {box.low.y, box.high.y})
      corners.include(dot(Vec2{x, y} - view.depth_origin_m, view.forward));
  const double rounding = 0x1p-40 * (std::abs(corners.low) + std::abs(corners.high));
  return {corners.low - rounding, corners.high + rounding};
}

// Beyond rounding.
bool is_beside(const View& view, const TinPlaces::BorderSide& side, const URange& part) {
  const double from = dot(side.from_m - view.depth_origin_m, view.right),
               to = dot(side.to_m - view.depth_origin_m, view.right);
  const double rounding = 0x1p-40 * (std::abs(from) + std::abs(to) + std::abs(part.low_m));
  return std::max(from, to) < part.low_m - rounding || std::min(from, to) > part.high_m + rounding;
}

// Whether a place may be in a triangle, seen from above, or is within rounding of it. `reach_m`:
// what the place is a sum of.
bool may_have(const Tin& tin, std::uint32_t triangle, Vec2 place, double reach_m) {
  constexpr double kRounding = 0x1p-40;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 from = plan_m(tin, tin.triangles[triangle][k]),
               to = plan_m(tin, tin.triangles[triangle][(k + 1) % 3]);
    const double scale = (reach_m + std::abs(from.x) + std::abs(from.y)) *
                         (std::abs(to.x - from.x) + std::abs(to.y - from.y));
    if (cross(to - from, place - from) < -kRounding * scale) return false;
  }
  return true;
}

// Of walks that were begun at several sides about a place, those that are the end of another.
void leave_out_ends(std::vector<Run>& runs, std::size_t begun_about, const Profile& found) {
  const auto is_end_of = [&](const Run& run, const Run& other) {
    const std::size_t count = run.end - run.begin;
    if (count > other.end - other.begin) return false;
    const auto is_same = [&](const std::vector<double>& values) {
      const auto end = values.begin() + static_cast<std::ptrdiff_t>(run.end);
      const auto other_end = values.begin() + static_cast<std::ptrdiff_t>(other.end);
      return std::equal(end - static_cast<std::ptrdiff_t>(count), end,
                        other_end - static_cast<std::ptrdiff_t>(count));
    };
    return is_same(found.u_m) && is_same(found.z_m);
  };
  for (std::size_t i = begun_about; i-- > 0;)
    for (std::size_t j = 0; j < runs.size(); ++j)
      if (i != j && is_end_of(runs[i], runs[j])) {
        runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(i));
        break;
      }
}

std::vector<std::uint32_t> numbers(std::size_t count) {
  std::vector<std::uint32_t> out(count);
  std::iota(out.begin(), out.end(), 0U);
  return out;
}

} // namespace

TinCutter::TinCutter(const Tin& tin, const View& view, const TriangleSet& level,
                     std::shared_ptr<const TinPlaces> places, std::shared_ptr<const TinIndex> index,
                     bool both_sides)
    : tin_(tin), view_(view), level_(level),
      places_(places ? std::move(places) : std::make_shared<const TinPlaces>(tin_places(tin))),
      index_(std::move(index)), boxes_(numbers(places_->boxes_m.size()), [&](std::uint32_t i) {
        return depths_of(view, places_->boxes_m[i]);
      }) {
  Range all;
  for (std::size_t i = 0; i < places_->boxes_m.size(); ++i) {
    const auto [nearest_m, farthest_m] = depths_of(view, places_->boxes_m[i]);
    if (nearest_m >= all.low && farthest_m <= all.high) continue;
    for (const TinPlaces::BorderSide& side : places_->sides_of(i))
      for (const std::size_t n : {1U, 2U})
        all.include(
            to_profile_frame(
                view, tin.vertices_m[tin.triangles[side.side.triangle][(side.side.k + n) % 3]])
                .v);
  }
  nearest_m_ = all.low;
  farthest_m_ = all.high;
  if (places_->walls.empty()) return;
  turned_walls_ = TriangleSet(tin.triangles.size());
  if (both_sides) return;
  const std::vector<std::uint8_t> facing = facing_of_triangles(tin, view);
  for (std::size_t t = 0; t < facing.size(); ++t)
    if (places_->walls.has(t) && (facing[t] & kMayTurn)) turned_walls_.add(t); // edge-on, too
}

// Vertices in the plane count as far, except where the TIN only touches the plane from behind: then
// nothing would be near.

void TinCutter::cut(double depth_m, Profile& out) const {
  out.clear();
  out.depth_m = depth_m;
  if (!(depth_m >= nearest_m() && depth_m <= farthest_m())) return;
  thread_local std::vector<TinSide> sides; // kept for its memory
  sides.clear();
  for (const std::uint32_t box : boxes_.at(depth_m))
    for (const TinPlaces::BorderSide& side : places_->sides_of(box)) sides.push_back(side.side);
  cut_mesh(CutTinMesh{{tin_, view_}, level_, places_->walls, turned_walls_}, sides, depth_m,
           depth_m > nearest_m(), out);
}

void TinCutter::cut(double depth_m, std::span<const URange> ranges, Profile& out) const {
  const URange part{ranges.front().low_m, ranges.back().high_m};
  if (!index_ || !std::isfinite(part.low_m) || !places_->walls.empty()) {
    cut(depth_m, out);
    return;
  }
  out.clear();
  out.depth_m = depth_m;
  if (!(depth_m >= nearest_m() && depth_m <= farthest_m())) return;
  const CutTinMesh mesh{{tin_, view_}, level_, places_->walls, turned_walls_};
  thread_local Profile found; // kept for its memory, as all of these are
  thread_local std::vector<Run> runs;
  thread_local std::vector<std::uint32_t> about, begun_in;
  found.clear();
  runs.clear();
  begun_in.clear();
  MeshWalk<CutTinMesh> walk(mesh, depth_m, part.high_m, depth_m > nearest_m(), found);
  const auto add = [&](const std::optional<Run>& run) {
    if (run) runs.push_back(*run);
  };
  const Vec2 left_end = view_.depth_origin_m + part.low_m * view_.right + depth_m * view_.forward;
  // Which may be next to the frame's origin, where it is no more than the rounding of its parts.
  const double reach_m = length(view_.depth_origin_m) + std::abs(part.low_m) + std::abs(depth_m);
  const double slack = 0x1p-40 * reach_m;
  index_->meeting({left_end - Vec2{slack, slack}, left_end + Vec2{slack, slack}}, about);
  for (const std::uint32_t t : about) {
    if (!may_have(tin_, t, left_end, reach_m)) continue;
    for (std::uint8_t k = 0; k < 3; ++k) {
      const TinSide side{t, k};
      if (mesh.across(side)) add(walk.over(side));
    }
    begun_in.push_back(t);
  }
  const std::size_t begun_about = runs.size();
  for (const std::uint32_t box : boxes_.at(depth_m))
    for (const TinPlaces::BorderSide& side : places_->sides_of(box))
      if (!is_beside(view_, side, part) ||
          std::ranges::find(begun_in, side.side.triangle) != begun_in.end())
        add(walk.from(side.side));
  leave_out_ends(runs, begun_about, found);
  keep_ground_in_front(runs);
  put_in_order(found, runs, out);
}

} // namespace orograph
