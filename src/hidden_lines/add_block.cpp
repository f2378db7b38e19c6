// SPDX-License-Identifier: GPL-3.0-or-later
// A block's walls (docs/blocks.md). One that is turned to the eye hides nothing that its upper edge
// doesn't, so that no more is asked of the pass than that its lines are compared before that edge
// rises; the others are seen from within, and have no lines.
#include "geometry/on_all_cores.hpp"
#include "hidden_lines/close_uprights.hpp"
#include "hidden_lines/ground_lines.hpp"
#include "hidden_lines/void_walls.hpp"
#include "placing/block.hpp"
#include "placing/contours.hpp"
#include "placing/vertex_values.hpp"
#include "profiles/mesh.hpp"
#include "profiles/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace orograph {
namespace {

// An edge of the border, the terrain on its left.
struct Side {
  std::uint32_t from, to; ///< numbers of ends
  bool is_towards_eye;
  bool is_looked_at; ///< its ground is: else nothing of the wall below shows
  bool has_lines() const { return is_towards_eye && is_looked_at; }
};

// A vertex of the border.
struct End {
  std::uint32_t vertex;
  double height_m;
  Vec3 ground_m;
  ProfilePoint top, foot;
  // A side each that begins and ends there, and points, once there are any.
  std::uint32_t leaving, coming, foot_point, rim_point;
};
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
// What a corner is told by: how many edges to either side make a direction, and how much that has
// to turn.
constexpr int kEdgesOfChord = 4;
const double kCorner = std::cos(35 * std::numbers::pi / 180);
constexpr std::size_t kOfTask = std::size_t{1} << 12U;
class Walls {
public:
  Walls(const TerrainData& terrain, const PlacedView& placed, const Style& style,
        const SeenGround* ground, GroundLines& out)
      : terrain_(terrain), placed_(placed), view_(placed.view), is_all_looked_at_(!ground),
        is_closed_(style.underside == Underside::draw), range_(page_range(placed.sectors.front())),
        by_azimuth_(placed.panorama || !std::isfinite(range_.begin) || !std::isfinite(range_.end)),
        first_point_(static_cast<std::uint32_t>(vertex_count(terrain.surface))), out_(out) {
    const std::size_t count = placed.border.size();
    find_ends();
    sides_.resize(count);
    on_all_cores((count + kOfTask - 1) / kOfTask, [&](std::size_t task) {
      std::size_t from_near = 0, to_near = 0;
      for (std::size_t i = task * kOfTask; i < std::min(count, (task + 1) * kOfTask); ++i) {
        const auto& [edge, left] = placed.border[i];
        const std::uint32_t from = end_of(edge.from, from_near), to = end_of(edge.to, to_near);
        Side& side = sides_[i];
        side = {left ? from : to, left ? to : from, false, !ground || is_looked_at(*ground, edge)};
        side.is_towards_eye = is_towards_eye(ends_[side.from].top, ends_[side.to].top);
      }
    });
    for (std::uint32_t i = 0; i < count; ++i) {
      ends_[sides_[i].from].leaving = i;
      ends_[sides_[i].to].coming = i;
    }
    of_void_ = around_voids(terrain.surface, placed.border);
    draws_rims_ = !style.asks_for("voids");
    find_hidden(tie_tolerance(placed.sectors.front(), style.visibility_tolerance_mm).greatest_y);
  }

  void add_outline(double apart_mm) {
    find_uprights(apart_mm);
    const auto feature = add_feature({LineKind::block, {}});
    for (std::uint32_t i = 0; i < sides_.size(); ++i) {
      const auto& [from, to, is_towards_eye, is_looked_at] = sides_[i];
      if (draws_rims_ && of_void_[i] && is_looked_at &&
          !is_hidden(i, ends_[from].top, ends_[to].top)) {
        out_.rims.push_back({static_cast<std::uint32_t>(out_.lines.size()), i,
                             ends_[from].vertex != placed_.border[i].edge.from});
        add_line(rim(from), rim(to), i, feature);
      }
      if ((sides_[i].has_lines() && !is_hidden(i, ends_[from].foot, ends_[to].foot)) || is_closed_)
        add_line(foot(from), foot(to), i, feature);
      for (const int at_end : {0, 1})
        if (uprights_[at_end][i] != Upright::none) add_upright(i, at_end, feature);
    }
  }

  // At equal steps of what the page shows to the right.
  void add_hatching(double spacing_mm) {
    const auto feature = add_feature({LineKind::wall, {}});
    constexpr double kAnywhere = std::numeric_limits<double>::infinity();
    const double step = step_of(spacing_mm);
    // A wall near the eye may be many pages wide.
    const XRange within = is_all_looked_at_ || by_azimuth_
                              ? XRange{-kAnywhere, kAnywhere}
                              : XRange{range_.begin - step, range_.end + step};
    for (std::uint32_t i = 0; i < sides_.size(); ++i) {
      if (!sides_[i].has_lines()) continue;
      const ProfilePoint a = ends_[sides_[i].from].top, b = ends_[sides_[i].to].top;
      for_each_step(a, b, step, within, [&](double t) {
        if (t >= 0 && t < 1) add_upright(i, t, feature);
      });
    }
  }

  void add_contours(const ContourLevels& levels, bool normal, bool index) {
    // What each level asks of each side, close together in memory.
    struct Wall {
      std::uint32_t side, from, to;
      double from_m, to_m, hidden_to_m;
    };
    std::vector<Wall> walls;
    for (std::uint32_t i = 0; i < sides_.size(); ++i)
      if (const auto& [from, to, is_towards_eye, is_looked_at] = sides_[i]; sides_[i].has_lines())
        walls.push_back({i, from, to, ends_[from].height_m, ends_[to].height_m, hidden_to_m(i)});
    std::vector<std::uint32_t> at_level;
    for (std::size_t k = 0; k < levels.heights_m.size(); ++k) {
      if (!(levels.is_index[k] ? index : normal)) continue;
      const double level_m = levels.heights_m[k];
      const auto feature =
          add_feature({levels.is_index[k] ? LineKind::wall_index_contour : LineKind::wall_contour,
                       {{"elevation", levels.heights[k]}}});
      at_level.assign(ends_.size(), kNone);
      const auto below = [&](std::uint32_t end) {
        if (at_level[end] == kNone) at_level[end] = add_point(below_end(ends_[end], level_m));
        return at_level[end];
      };
      for (const auto& [i, from, to, from_m, to_m, hidden_to_m] : walls) {
        if (std::max(from_m, to_m) <= level_m) continue;
        if (std::min(from_m, to_m) >= level_m) {
          if (level_m < hidden_to_m) continue;
          add_line(below(from), below(to), i, feature);
          continue;
        }
        const ProfilePoint crossing =
            point_between(ends_[from].top, ends_[to].top, (level_m - from_m) / (to_m - from_m));
        if (from_m > level_m)
          add_line(below(from), add_point(crossing), i, feature);
        else
          add_line(add_point(crossing), below(to), i, feature);
      }
    }
  }

private:
  // What of a wall is seen has its edge above it, which is seen then.
  bool is_looked_at(const SeenGround& ground, SurfaceEdge edge) const {
    const Grid& grid = std::get<Grid>(terrain_.surface);
    return std::ranges::any_of(std::array{true, false}, [&](bool left) {
      const auto& [column, row, half] = side_of(grid, edge, left).triangle;
      return column >= 0 && row >= 0 && column + 1 < grid.columns && row + 1 < grid.rows &&
             ground.seen[ground.index(column / SeenGround::kSide, row / SeenGround::kSide)] != 0;
    });
  }

  bool is_towards_eye(ProfilePoint a, ProfilePoint b) const {
    // Of the length: on the page such a wall is less than a step of 0.0001 mm wide.
    constexpr double kEdgeOn = 1e-6;
    const double size = std::hypot(b.u - a.u, b.v - a.v);
    if (!view_.is_perspective()) return b.u - a.u + view_.x_per_v * (b.v - a.v) > kEdgeOn * size;
    const double away = std::max(std::hypot(a.u, a.v), std::hypot(b.u, b.v));
    return a.v * b.u - a.u * b.v > kEdgeOn * size * away;
  }

  // Most of voids' walls, behind the near rim. A block that is closed below is seen from there,
  // too.
  void find_hidden(double slack_y) {
    if (is_closed_ || placed_.panorama || placed_.sectors.size() > 1) return;
    std::vector<ProfilePoint> tops(ends_.size());
    std::ranges::transform(ends_, tops.begin(), &End::top);
    std::vector<VoidRim> rims;
    for (std::size_t i = 0; i < sides_.size(); ++i)
      if (of_void_[i]) rims.push_back({sides_[i].from, sides_[i].to, sides_[i].is_towards_eye});
    hidden_below_y_.assign(sides_.size(), -std::numeric_limits<double>::infinity());
    const std::vector<double> hidden = hidden_below(view_, tops, rims, slack_y);
    auto y = hidden.begin();
    for (std::size_t i = 0; i < sides_.size(); ++i)
      if (of_void_[i]) hidden_below_y_[i] = *y++;
  }
  bool is_hidden(std::uint32_t side, ProfilePoint a, ProfilePoint b) const {
    return !hidden_below_y_.empty() &&
           std::max(project(view_, a).y, project(view_, b).y) < hidden_below_y_[side];
  }
  // Below which height level lines across its wall are hidden as well: Y is linear in it.
  double hidden_to_m(std::uint32_t side) const {
    if (hidden_below_y_.empty()) return -std::numeric_limits<double>::infinity();
    const auto at_end = [&](const End& end) {
      const double top_y = project(view_, end.top).y, foot_y = project(view_, end.foot).y;
      return end.height_m + (top_y - hidden_below_y_[side]) / (top_y - foot_y) * (1 + 1e-9) *
                                (*placed_.block_base_m - end.height_m);
    };
    return std::min(at_end(ends_[sides_[side].from]), at_end(ends_[sides_[side].to]));
  }

  // Shares of the way from a to b at which the page shows whole steps, of those that are within.
  template <class Take>
  void for_each_step(ProfilePoint a, ProfilePoint b, double step, XRange within,
                     const Take& take) const {
    const auto steps = [&](double from, double to, const auto& share_at) {
      const double low = std::max(std::min(from, to), within.begin),
                   high = std::min(std::max(from, to), within.end);
      if (!((high - low) / step < 1e5)) return;
      for (double k = std::ceil(low / step); k * step < high; ++k) take(share_at(k * step));
    };
    if (!view_.is_perspective()) {
      const double x_a = position(a), x_b = position(b);
      steps(x_a, x_b, [&](double x) { return (x - x_a) / (x_b - x_a); });
      return;
    }
    const double du = b.u - a.u, dv = b.v - a.v;
    if (!by_azimuth_) {
      if (std::min(a.v, b.v) <= view_.near_m) return;
      steps(a.u / a.v, b.u / b.v, [&](double x) { return (x * a.v - a.u) / (du - x * dv); });
      return;
    }
    const double begin = position(a);
    const double turn = std::remainder(position(b) - begin, 2 * std::numbers::pi);
    steps(begin, begin + turn, [&](double azimuth) {
      const double s = std::sin(azimuth), c = std::cos(azimuth);
      return (s * a.v - c * a.u) / (c * du - s * dv);
    });
  }

  double step_of(double spacing_mm) const {
    if (placed_.panorama) return spacing_mm / placed_.panorama->page.radius_mm;
    if (by_azimuth_) return 0.02; // radians
    return spacing_mm * (range_.end - range_.begin) / placed_.frame_mm.width();
  }
  double position(ProfilePoint at) const {
    return by_azimuth_ ? std::atan2(at.u, at.v) : project(view_, at).x;
  }

  void find_uprights(double apart_mm) {
    for (const bool at_end : {false, true}) {
      std::vector<Upright>& uprights = uprights_[at_end ? 1 : 0];
      uprights.assign(sides_.size(), Upright::none);
      std::vector<bool> is_done(sides_.size());
      for (std::uint32_t first = 0; first < sides_.size(); ++first) {
        std::vector<TurnedAway> along;
        for (std::uint32_t i = first; i != kNone && !is_done[i]; i = ends_[sides_[i].to].leaving) {
          is_done[i] = true;
          const ProfilePoint &from = ends_[sides_[i].from].top, &to = ends_[sides_[i].to].top;
          if (!sides_[i].has_lines() || is_hidden(i, from, to)) continue;
          uprights[i] = upright_of(i, at_end);
          if (uprights[i] == Upright::turned_away)
            along.push_back({i, position(at_end ? to : from)});
        }
        for (const std::uint32_t i : too_close(along, step_of(apart_mm), at_end))
          uprights[i] = Upright::none;
      }
    }
  }

  // Which upright line is drawn where a wall begins or ends: where the border has a corner, or
  // turns away from the eye. What a border does within a few edges is no corner.
  Upright upright_of(std::uint32_t side, bool at_end) const {
    const std::uint32_t at = at_end ? sides_[side].to : sides_[side].from;
    const std::uint32_t next = at_end ? ends_[at].leaving : ends_[at].coming;
    if (next == kNone) return Upright::corner;
    const Side& other = sides_[next];
    // Both walls of a corner would draw it.
    if (other.is_towards_eye && !at_end) return Upright::none;
    const auto way = [&](std::uint32_t from, std::uint32_t to) {
      const ProfilePoint a = ends_[from].top, b = ends_[to].top;
      return Vec2{b.u - a.u, b.v - a.v};
    };
    const auto turns = [](Vec2 a, Vec2 b) {
      return dot(a, b) < kCorner * plain_length(a) * plain_length(b);
    };
    if (other.is_towards_eye &&
        !turns(way(sides_[side].from, sides_[side].to), way(other.from, other.to)))
      return Upright::none;
    const std::uint32_t before = walked(at, &End::coming, &Side::from),
                        behind = walked(at, &End::leaving, &Side::to);
    if (turns(way(before, at), way(at, behind))) return Upright::corner;
    return is_towards_eye(ends_[before].top, ends_[at].top) ==
                   is_towards_eye(ends_[at].top, ends_[behind].top)
               ? Upright::none
               : Upright::turned_away;
  }

  std::uint32_t walked(std::uint32_t from, std::uint32_t End::*side_of,
                       std::uint32_t Side::*end_of_side) const {
    std::uint32_t at = from;
    for (int i = 0; i < kEdgesOfChord; ++i) {
      const std::uint32_t side = ends_[at].*side_of;
      if (side == kNone || sides_[side].*end_of_side == from) return at;
      at = sides_[side].*end_of_side;
    }
    return at;
  }

  void find_ends() {
    vertices_ = vertices_of(placed_.border);
    ends_.resize(vertices_.size());
    const VertexValues heights = heights_of(terrain_);
    const Grid* const grid = std::get_if<Grid>(&terrain_.surface);
    on_all_cores((ends_.size() + kOfTask - 1) / kOfTask, [&](std::size_t task) {
      for (std::size_t i = task * kOfTask; i < std::min(ends_.size(), (task + 1) * kOfTask); ++i) {
        End& end = ends_[i];
        end = {vertices_[i], 0, {}, {}, {}, kNone, kNone, kNone, kNone};
        heights(end.vertex, std::span(&end.height_m, 1));
        end.ground_m = grid ? grid->vertex_m(end.vertex)
                            : std::get<Tin>(terrain_.surface).vertices_m[end.vertex];
        end.top = to_profile_frame(view_, end.ground_m);
        end.foot = below_end(end, *placed_.block_base_m);
      }
    });
  }

  // Edges are in order, and so the ends of one are mostly near those of the last.
  std::uint32_t end_of(std::uint32_t vertex, std::size_t& near) const {
    constexpr int kMostSteps = 8;
    for (int i = 0; i < kMostSteps && vertices_[near] != vertex; ++i)
      near = vertices_[near] < vertex ? near + 1 : near - 1;
    if (vertices_[near] != vertex)
      near =
          static_cast<std::size_t>(std::ranges::lower_bound(vertices_, vertex) - vertices_.begin());
    return static_cast<std::uint32_t>(near);
  }
  ProfilePoint below_end(const End& end, double at_m) const {
    return to_profile_frame(view_, below_vertex_m(terrain_, end.ground_m, end.height_m, at_m));
  }

  std::uint32_t add_point(ProfilePoint point) {
    out_.points.push_back(point);
    return first_point_ + static_cast<std::uint32_t>(out_.points.size()) - 1;
  }
  std::uint32_t foot(std::uint32_t end) {
    if (ends_[end].foot_point == kNone) ends_[end].foot_point = add_point(ends_[end].foot);
    return ends_[end].foot_point;
  }
  std::uint32_t rim(std::uint32_t end) {
    if (ends_[end].rim_point == kNone) ends_[end].rim_point = add_point(ends_[end].top);
    return ends_[end].rim_point;
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
    const std::uint32_t from = sides_[side].from, to = sides_[side].to;
    const ProfilePoint top = point_between(ends_[from].top, ends_[to].top, t);
    const double foot_z = point_between(ends_[from].foot, ends_[to].foot, t).z;
    if (is_hidden(side, top, top)) return;
    add_line(add_point({top.u, top.v, foot_z}), add_point(top), side, feature);
  }
  void add_line(std::uint32_t from, std::uint32_t to, std::uint32_t side, std::uint32_t feature) {
    throw_if_stopped(out_.lines.size());
    out_.lines.push_back({{from, to}, side, feature});
  }

  const TerrainData& terrain_;
  const PlacedView& placed_;
  const View& view_;
  bool is_all_looked_at_;
  bool is_closed_; ///< below: its base is seen as well
  XRange range_;
  bool by_azimuth_; ///< tells what the page shows to the right, in a panorama or beneath the eye
  std::uint32_t first_point_;
  GroundLines& out_;
  std::vector<std::uint32_t> vertices_; ///< of the border, rising
  std::vector<End> ends_;               ///< of these
  std::vector<Side> sides_;             ///< one for each edge of the border
  std::vector<bool> of_void_;
  std::array<std::vector<Upright>, 2> uprights_; ///< by side: where it begins, and where it ends
  bool draws_rims_ = false;                      ///< of voids, which have no other layer
  std::vector<double> hidden_below_y_;           ///< by side; empty: nothing is known
};

} // namespace

void add_block(const TerrainData& terrain, const PlacedView& placed, const Style& style,
               const SeenGround* ground, GroundLines& out) {
  Walls walls(terrain, placed, style, ground, out);
  const double apart_mm = kPenWidthsApart * style.pen_width_mm;
  walls.add_outline(apart_mm);
  if (style.hatches_block()) walls.add_hatching(apart_mm);
  const bool contours = style.asks_for("contours"), index = style.draws_index_contours();
  if (contours || index)
    walls.add_contours(contour_levels(terrain, style.contours, placed.block_base_m), contours,
                       index);
}

} // namespace orograph
