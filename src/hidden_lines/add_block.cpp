// SPDX-License-Identifier: GPL-3.0-or-later
// A block's walls (docs/blocks.md). One that is turned to the eye hides nothing that its upper edge
// doesn't, so that no more is asked of the pass than that its lines are compared before that edge
// rises; the others are seen from within, and have no lines.
#include "hidden_lines/ground_lines.hpp"
#include "placing/block.hpp"
#include "placing/contours.hpp"
#include "placing/vertex_values.hpp"
#include "profiles/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace orograph {
namespace {

// An edge of the border, the terrain on its left.
struct Side {
  std::uint32_t from, to; ///< vertices
  bool is_towards_eye;
};

// What a corner is told by: how many edges to either side make a direction, and how much that has
// to turn.
constexpr int kEdgesOfChord = 4;
const double kCorner = std::cos(35 * std::numbers::pi / 180);

class Walls {
public:
  Walls(const TerrainData& terrain, const PlacedView& placed, const Style& style, GroundLines& out)
      : terrain_(terrain), placed_(placed), view_(placed.view), heights_(heights_of(terrain)),
        first_point_(static_cast<std::uint32_t>(vertex_count(terrain.surface))), out_(out) {
    const std::size_t count = placed.border.size();
    sides_.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto& [edge, left] = placed.border[i];
      Side side{left ? edge.from : edge.to, left ? edge.to : edge.from, false};
      side.is_towards_eye = is_towards_eye(vertex(side.from), vertex(side.to));
      sides_.push_back(side);
      leaving_.emplace(side.from, i);
      coming_.emplace(side.to, i);
    }
    const bool draws_voids = style.asks_for("voids");
    of_void_ =
        draws_voids ? std::vector<bool>(count) : around_voids(terrain.surface, placed.border);
  }

  void add_outline() {
    const auto feature = add_feature({LineKind::block, {}});
    for (std::uint32_t i = 0; i < sides_.size(); ++i) {
      const auto& [from, to, is_towards_eye] = sides_[i];
      if (of_void_[i]) add_line(rim(from), rim(to), i, feature);
      if (!is_towards_eye) continue;
      add_line(foot(from), foot(to), i, feature);
      if (is_corner(i, false)) add_upright(i, 0, feature);
      if (is_corner(i, true)) add_upright(i, 1, feature);
    }
  }

  // At equal steps of what the page shows to the right.
  void add_hatching(double spacing_mm) {
    const auto feature = add_feature({LineKind::wall, {}});
    const XRange range = page_range(placed_.sectors.front());
    const bool by_azimuth =
        placed_.panorama || !std::isfinite(range.begin) || !std::isfinite(range.end);
    constexpr double kAroundEye = 0.02; // radians, where the page shows what is beneath the eye
    const double step = placed_.panorama ? spacing_mm / placed_.panorama->page.radius_mm
                        : by_azimuth
                            ? kAroundEye
                            : spacing_mm * (range.end - range.begin) / placed_.frame_mm.width();
    for (std::uint32_t i = 0; i < sides_.size(); ++i) {
      if (!sides_[i].is_towards_eye) continue;
      const ProfilePoint a = vertex(sides_[i].from), b = vertex(sides_[i].to);
      for_each_step(a, b, by_azimuth, step, [&](double t) {
        if (t >= 0 && t < 1) add_upright(i, t, feature);
      });
    }
  }

  void add_contours(const ContourLevels& levels, bool normal, bool index) {
    for (std::size_t k = 0; k < levels.heights_m.size(); ++k) {
      if (!(levels.is_index[k] ? index : normal)) continue;
      const double level_m = levels.heights_m[k];
      if (level_m < *placed_.block_base_m) continue;
      const auto feature =
          add_feature({levels.is_index[k] ? LineKind::wall_index_contour : LineKind::wall_contour,
                       {{"elevation", levels.heights[k]}}});
      std::unordered_map<std::uint32_t, std::uint32_t> at_level;
      const auto below = [&](std::uint32_t vertex) {
        const auto [found, is_new] = at_level.try_emplace(vertex, 0);
        if (is_new) found->second = add_point(below_vertex(vertex, level_m));
        return found->second;
      };
      for (std::uint32_t i = 0; i < sides_.size(); ++i) {
        const auto& [from, to, is_towards_eye] = sides_[i];
        if (!is_towards_eye) continue;
        const double from_m = height_m(from), to_m = height_m(to);
        if (std::max(from_m, to_m) <= level_m) continue;
        if (std::min(from_m, to_m) >= level_m) {
          add_line(below(from), below(to), i, feature);
          continue;
        }
        const ProfilePoint crossing =
            point_between(vertex(from), vertex(to), (level_m - from_m) / (to_m - from_m));
        if (from_m > level_m)
          add_line(below(from), add_point(crossing), i, feature);
        else
          add_line(add_point(crossing), below(to), i, feature);
      }
    }
  }

private:
  bool is_towards_eye(ProfilePoint a, ProfilePoint b) const {
    // Of the length: on the page such a wall is less than a step of 0.0001 mm wide.
    constexpr double kEdgeOn = 1e-6;
    const double size = std::hypot(b.u - a.u, b.v - a.v);
    if (!view_.is_perspective()) return b.u - a.u + view_.x_per_v * (b.v - a.v) > kEdgeOn * size;
    const double away = std::max(std::hypot(a.u, a.v), std::hypot(b.u, b.v));
    return a.v * b.u - a.u * b.v > kEdgeOn * size * away;
  }

  // Shares of the way from a to b at which the page shows whole steps.
  template <class Take>
  void for_each_step(ProfilePoint a, ProfilePoint b, bool by_azimuth, double step,
                     const Take& take) const {
    const auto steps = [&](double from, double to, const auto& share_at) {
      const auto [low, high] = std::minmax(from, to);
      constexpr double kMost = 1e5;
      if (!((high - low) / step < kMost)) return;
      for (double k = std::ceil(low / step); k * step < high; ++k) take(share_at(k * step));
    };
    if (!view_.is_perspective()) {
      const double x_a = project(view_, a).x, x_b = project(view_, b).x;
      steps(x_a, x_b, [&](double x) { return (x - x_a) / (x_b - x_a); });
      return;
    }
    const double du = b.u - a.u, dv = b.v - a.v;
    if (!by_azimuth) {
      if (std::min(a.v, b.v) <= view_.near_m) return;
      steps(a.u / a.v, b.u / b.v, [&](double x) { return (x * a.v - a.u) / (du - x * dv); });
      return;
    }
    const double begin = std::atan2(a.u, a.v);
    const double turn = std::remainder(std::atan2(b.u, b.v) - begin, 2 * std::numbers::pi);
    steps(begin, begin + turn, [&](double azimuth) {
      const double s = std::sin(azimuth), c = std::cos(azimuth);
      return (s * a.v - c * a.u) / (c * du - s * dv);
    });
  }

  // Whether an upright line is drawn where a wall begins or ends: where the border has a corner, or
  // turns away from the eye. What a border does within a few edges is no corner.
  bool is_corner(std::uint32_t side, bool at_end) const {
    const auto& next_of = at_end ? leaving_ : coming_;
    const std::uint32_t at = at_end ? sides_[side].to : sides_[side].from;
    const auto next = next_of.find(at);
    if (next == next_of.end()) return true;
    const Side& other = sides_[next->second];
    const auto way = [&](const Side& of) {
      const ProfilePoint a = vertex(of.from), b = vertex(of.to);
      return Vec2{b.u - a.u, b.v - a.v};
    };
    const auto turns = [](Vec2 a, Vec2 b) {
      return dot(a, b) < kCorner * plain_length(a) * plain_length(b);
    };
    // Both walls of a corner would draw it.
    const bool is_others = other.is_towards_eye && !at_end;
    if (is_others) return false;
    if (!turns(way(sides_[side]), way(other)) && other.is_towards_eye) return false;
    const std::uint32_t before = walked(at, coming_, &Side::from),
                        behind = walked(at, leaving_, &Side::to);
    const ProfilePoint here = vertex(at), a = vertex(before), b = vertex(behind);
    const Vec2 in{here.u - a.u, here.v - a.v}, out{b.u - here.u, b.v - here.v};
    if (turns(in, out)) return true;
    return is_towards_eye(a, here) != is_towards_eye(here, b);
  }

  std::uint32_t walked(std::uint32_t from,
                       const std::unordered_multimap<std::uint32_t, std::uint32_t>& sides,
                       std::uint32_t Side::*end) const {
    std::uint32_t at = from;
    for (int i = 0; i < kEdgesOfChord; ++i) {
      const auto side = sides.find(at);
      if (side == sides.end() || sides_[side->second].*end == from) return at;
      at = sides_[side->second].*end;
    }
    return at;
  }

  Vec3 ground_m(std::uint32_t number) const {
    const Grid* grid = std::get_if<Grid>(&terrain_.surface);
    return grid ? grid->vertex_m(number) : std::get<Tin>(terrain_.surface).vertices_m[number];
  }
  double height_m(std::uint32_t number) const {
    double height = 0;
    heights_(number, std::span(&height, 1));
    return height;
  }
  ProfilePoint vertex(std::uint32_t number) const {
    return to_profile_frame(view_, ground_m(number));
  }
  ProfilePoint below_vertex(std::uint32_t number, double at_m) const {
    return to_profile_frame(view_,
                            below_vertex_m(terrain_, ground_m(number), height_m(number), at_m));
  }
  ProfilePoint foot_of(std::uint32_t number) const {
    return below_vertex(number, *placed_.block_base_m);
  }

  std::uint32_t add_point(ProfilePoint point) {
    out_.points.push_back(point);
    return first_point_ + static_cast<std::uint32_t>(out_.points.size()) - 1;
  }
  std::uint32_t foot(std::uint32_t number) {
    const auto [found, is_new] = feet_.try_emplace(number, 0);
    if (is_new) found->second = add_point(foot_of(number));
    return found->second;
  }
  std::uint32_t rim(std::uint32_t number) {
    const auto [found, is_new] = rims_.try_emplace(number, 0);
    if (is_new) found->second = add_point(vertex(number));
    return found->second;
  }
  std::uint32_t add_feature(GroundFeature feature) {
    out_.features.push_back(std::move(feature));
    return static_cast<std::uint32_t>(out_.features.size()) - 1;
  }
  // From the foot of a wall up to its upper edge. At a corner a little within the wall: of what is
  // in front of the corner itself some may be in front of the other wall alone.
  void add_upright(std::uint32_t side, double share, std::uint32_t feature) {
    constexpr double kWithin = 1e-6;
    const double t = std::clamp(share, kWithin, 1 - kWithin);
    const auto& [from, to, is_towards_eye] = sides_[side];
    const ProfilePoint top = point_between(vertex(from), vertex(to), t);
    const double foot_z = point_between(foot_of(from), foot_of(to), t).z;
    add_line(add_point({top.u, top.v, foot_z}), add_point(top), side, feature);
  }
  void add_line(std::uint32_t from, std::uint32_t to, std::uint32_t side, std::uint32_t feature) {
    throw_if_stopped(out_.lines.size());
    out_.lines.push_back({{from, to}, side, feature});
  }

  const TerrainData& terrain_;
  const PlacedView& placed_;
  const View& view_;
  VertexValues heights_;
  std::uint32_t first_point_;
  GroundLines& out_;
  std::vector<Side> sides_; ///< one for each edge of the border
  std::vector<bool> of_void_;
  std::unordered_multimap<std::uint32_t, std::uint32_t> leaving_, coming_; ///< sides, by vertex
  std::unordered_map<std::uint32_t, std::uint32_t> feet_, rims_;           ///< points, by vertex
};

} // namespace

void add_block(const TerrainData& terrain, const PlacedView& placed, const Style& style,
               GroundLines& out) {
  Walls walls(terrain, placed, style, out);
  walls.add_outline();
  if (style.hatches_block()) walls.add_hatching(kPenWidthsApart * style.pen_width_mm);
  const bool contours = style.asks_for("contours"), index = style.draws_index_contours();
  if (contours || index)
    walls.add_contours(contour_levels(terrain, style.contours), contours, index);
}

} // namespace orograph
