// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/extent.hpp"
#include "geometry/on_all_cores.hpp"
#include "profiles/cut_earth_grid.hpp"
#include "profiles/cut_grid.hpp"
#include "profiles/profile.hpp"
#include "profiles/seen_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace orograph {
namespace {

constexpr int kSide = SeenGround::kSide;
// Beside a wide perspective view X runs off to infinity; what is farther aside is looked at.
constexpr double kFarAside = 8;
// Cells from a profile to the next: with 8 a tenth of the ground more is left out, at twice the
// cost. Columns of X in a band; bands, each a task.
constexpr double kCellsBetween = 24;
constexpr std::size_t kColumnsABand = 512, kBands = 4;

struct BlockInView {
  double x_begin = kInfinity, x_end = -kInfinity;
  double y_high = kInfinity;
  double nearest_m = -kInfinity;
};
constexpr BlockInView kOutside{kInfinity, -kInfinity, -kInfinity, 0};

// A lower bound of how far a rectangle's ground sinks: a quadratic form is no farther below the
// line between two places than a quarter of what it is for the way between them.
double least_drop(const FrameDrop& drop, const std::array<ProfilePoint, 4>& corners) {
  if (!drop.any()) return 0;
  double least = kInfinity;
  for (const ProfilePoint& p : corners) least = std::min(least, drop.at(p.u, p.v));
  const double across = std::hypot(corners[0].u - corners[2].u, corners[0].v - corners[2].v) +
                        std::hypot(corners[1].u - corners[3].u, corners[1].v - corners[3].v);
  return least -
         (std::abs(drop.per_uu) + std::abs(drop.per_uv) + std::abs(drop.per_vv)) * across * across;
}

class Finder {
public:
  Finder(const Grid& grid, const BlockBounds& bounds, const View& view,
         const SeenGroundRequest& request)
      : grid_(grid), bounds_(bounds), view_(view), request_(request), all_(grid),
        rounding_m_(1e-9 * (reach_m(grid) + length(view.depth_origin_m))) {
    if (grid.is_on_earth()) {
      earth_cutter_.emplace(grid, view, no_level_, request.border, request.box_m);
    } else {
      cutter_.emplace(grid, view, no_level_);
      over_blocks_.emplace(grid, view);
    }
  }

  SeenGround find() {
    place_blocks();
    plan_planes();
    if (planes_ == 0 || !(x_begin_ < x_end_)) return all_;
    std::array<SeenGround, kBands> seen{all_, all_, all_, all_};
    on_all_cores(kBands, [&](std::size_t band) { sweep_band(band, seen[band]); });
    for (std::size_t i = 0; i < all_.seen.size(); ++i) {
      std::uint8_t any = 0;
      for (const SeenGround& of_band : seen) any |= of_band.seen[i];
      all_.seen[i] = any;
    }
    return all_;
  }

private:
  void find_blocks();
  void place_blocks();
  BlockInView place(std::size_t i, const BoundsOfBlocks& of, int cells) const;
  BlockInView place_up_to(double height, const std::array<Vec2, 4>& corners_m) const;
  void cut(double depth_m, XRange band, const SeenGround& seen, std::vector<URange>& parts,
           Profile& out) const;
  bool is_in_view(const BlockInView& block) const;
  void plan_planes();
  void sweep_band(std::size_t band, SeenGround& seen) const;

  double depth_of_plane(std::size_t plane) const {
    return first_plane_m_ + static_cast<double>(plane) * between_m_;
  }

  const Grid& grid_;
  const BlockBounds& bounds_;
  const View& view_;
  const SeenGroundRequest& request_;
  TriangleSet no_level_;
  std::optional<GridCutter> cutter_;           ///< on a map plane
  std::optional<PlaneOverBlocks> over_blocks_; ///< the same
  std::optional<EarthGridCutter> earth_cutter_;
  SeenGround all_;
  double rounding_m_;
  /// Those blocks that may be in view, with their numbers; others are not.
  std::vector<BlockInView> in_view_;
  std::vector<std::uint32_t> numbers_;
  double x_begin_ = 0, x_end_ = 0; ///< finite; where there is terrain
  double first_plane_m_ = 0, between_m_ = 0;
  std::size_t planes_ = 0;
  /// Blocks, by their place in `in_view_`, that are wholly behind a plane, but not the next, and
  /// where each plane's end.
  std::vector<std::uint32_t> by_plane_, plane_end_;
};

// Of number `i` of the blocks, or of groups, of so many cells.
BlockInView Finder::place(std::size_t i, const BoundsOfBlocks& of, int cells) const {
  if (earth_cutter_) {
    const Box3& box = of.boxes_m[i];
    if (box.empty()) return kOutside;
    return place_up_to(box.high.z, {Vec2{box.low.x, box.low.y},
                                    {box.high.x, box.low.y},
                                    {box.high.x, box.high.y},
                                    {box.low.x, box.high.y}});
  }
  if (!(of.heights[i] > -kInfinity)) return kOutside;
  const auto across = static_cast<std::size_t>(of.columns);
  const int c0 = static_cast<int>(i % across) * cells, r0 = static_cast<int>(i / across) * cells,
            c1 = std::min(c0 + cells, grid_.columns - 1), r1 = std::min(r0 + cells, grid_.rows - 1);
  const PlaneLattice& plane = grid_.plane();
  return place_up_to(of.heights[i], {plane.position_m(c0, r0), plane.position_m(c1, r0),
                                     plane.position_m(c1, r1), plane.position_m(c0, r1)});
}

// Of all ground up to a height between four corners.
BlockInView Finder::place_up_to(double height, const std::array<Vec2, 4>& corners_m) const {
  std::array<ProfilePoint, 4> corners;
  for (std::size_t i = 0; i < 4; ++i)
    corners[i] = to_profile_frame(view_, {corners_m[i].x, corners_m[i].y, 0});
  BlockInView block;
  double nearest = kInfinity, farthest = -kInfinity;
  for (const ProfilePoint& p : corners) {
    nearest = std::min(nearest, p.v);
    farthest = std::max(farthest, p.v);
  }
  block.nearest_m = nearest - rounding_m_;
  if (view_.is_perspective()) {
    if (farthest < -view_.near_m - rounding_m_) return kOutside;
    if (!(block.nearest_m > view_.near_m)) return {-kInfinity, kInfinity, kInfinity, -kInfinity};
    // All corners on the outer side of one of the range's sides, by more than rounding.
    const auto is_beyond = [&](double x, double side) {
      return std::isfinite(x) && std::ranges::all_of(corners, [&](const ProfilePoint& p) {
               return side * (p.u - x * p.v) > 4 * rounding_m_ * (1 + std::abs(x));
             });
    };
    if (is_beyond(request_.range.begin, -1) || is_beyond(request_.range.end, 1)) return kOutside;
  }
  const double z = height * view_.exaggeration - least_drop(view_.drop, corners);
  if (view_.is_perspective()) {
    const double above = z - view_.eye_z_m;
    block.y_high = above > 0 ? above / nearest : above / farthest;
  } else {
    block.y_high = z * view_.y_per_z + std::max(nearest * view_.y_per_v, farthest * view_.y_per_v);
  }
  for (const ProfilePoint& p : corners) {
    const double x = view_.is_perspective() ? p.u / p.v : p.u + p.v * view_.x_per_v;
    block.x_begin = std::min(block.x_begin, x);
    block.x_end = std::max(block.x_end, x);
  }
  const double beside = view_.is_perspective()
                            ? rounding_m_ *
                                  (1 + std::max(std::abs(block.x_begin), std::abs(block.x_end))) /
                                  block.nearest_m
                            : rounding_m_ * (1 + std::abs(view_.x_per_v));
  block.x_begin -= beside;
  block.x_end += beside;
  return block;
}

bool Finder::is_in_view(const BlockInView& block) const {
  return block.y_high > -kInfinity && block.x_begin <= request_.range.end &&
         block.x_end >= request_.range.begin;
}

// Those of groups in view.
void Finder::find_blocks() {
  constexpr int kGroup = BlockBounds::kGroup;
  for (std::size_t i = 0; i < bounds_.groups.count(); ++i) {
    if (!is_in_view(place(i, bounds_.groups, kGroup * kSide))) continue;
    const int across = bounds_.groups.columns;
    const int first_column = static_cast<int>(i) % across * kGroup,
              first_row = static_cast<int>(i) / across * kGroup;
    for (int row = first_row; row < std::min(first_row + kGroup, all_.rows); ++row)
      for (int column = first_column; column < std::min(first_column + kGroup, all_.columns);
           ++column)
        numbers_.push_back(static_cast<std::uint32_t>(all_.index(column, row)));
  }
}

void Finder::place_blocks() {
  find_blocks();
  std::ranges::fill(all_.seen, std::uint8_t{0});
  in_view_.assign(numbers_.size(), kOutside);
  constexpr std::size_t kBlocksOfTask = 4096;
  on_all_cores((numbers_.size() + kBlocksOfTask - 1) / kBlocksOfTask, [&](std::size_t task) {
    const std::size_t end = std::min(numbers_.size(), (task + 1) * kBlocksOfTask);
    for (std::size_t at = task * kBlocksOfTask; at < end; ++at) {
      in_view_[at] = place(numbers_[at], bounds_.blocks, kSide);
      all_.seen[numbers_[at]] = is_in_view(in_view_[at]) ? 1 : 0;
    }
  });
}

// Planes, and X, that hold all blocks.
void Finder::plan_planes() {
  double nearest = kInfinity, farthest = -kInfinity;
  x_begin_ = kInfinity;
  x_end_ = -kInfinity;
  for (std::size_t i = 0; i < in_view_.size(); ++i) {
    const BlockInView& block = in_view_[i];
    if (all_.seen[numbers_[i]] == 0 || !(block.nearest_m > -kInfinity)) continue;
    nearest = std::min(nearest, block.nearest_m);
    farthest = std::max(farthest, block.nearest_m);
    x_begin_ = std::min(x_begin_, block.x_begin);
    x_end_ = std::max(x_end_, block.x_end);
  }
  x_begin_ = std::max(x_begin_, request_.range.begin);
  x_end_ = std::min(x_end_, request_.range.end);
  if (view_.is_perspective()) {
    x_begin_ = std::max(x_begin_, -kFarAside);
    x_end_ = std::min(x_end_, kFarAside);
  }
  if (!(nearest < farthest)) return;
  // Cells that are much longer than wide don't make millions of planes.
  between_m_ = kCellsBetween *
               std::max(cell_size_m(grid_), (farthest - nearest) / (grid_.columns + grid_.rows));
  // Off the rows' own depths by a share that they don't have in common.
  first_plane_m_ = nearest + 0.382 * between_m_;
  planes_ = static_cast<std::size_t>(std::ceil((farthest - first_plane_m_) / between_m_)) + 1;
  const auto plane_of = [&](const BlockInView& block) {
    return static_cast<std::size_t>((block.nearest_m - first_plane_m_) / between_m_);
  };
  const auto is_asked = [&](std::size_t i) {
    const BlockInView& block = in_view_[i];
    return all_.seen[numbers_[i]] != 0 && block.nearest_m > first_plane_m_ &&
           (block.x_begin >= x_begin_ || x_begin_ <= request_.range.begin) &&
           (block.x_end <= x_end_ || x_end_ >= request_.range.end);
  };
  plane_end_.assign(planes_ + 1, 0);
  for (std::size_t i = 0; i < in_view_.size(); ++i)
    if (is_asked(i)) ++plane_end_[plane_of(in_view_[i])];
  std::uint32_t sum = 0;
  for (std::uint32_t& end : plane_end_) end = sum += end;
  by_plane_.resize(sum);
  std::vector<std::uint32_t> at(plane_end_);
  for (std::size_t i = in_view_.size(); i-- > 0;)
    if (is_asked(i)) by_plane_[--at[plane_of(in_view_[i])]] = static_cast<std::uint32_t>(i);
}

// Lower bounds of the horizon in columns of X.
class ColumnHorizon {
public:
  ColumnHorizon(double begin, double end)
      : begin_(begin), per_x_(static_cast<double>(kColumnsABand) / (end - begin)),
        low_(kColumnsABand, -kInfinity) {}

  // By the profile's vertices from run.first to run.last: in each column that they span wholly, by
  // the lowest end of all spans that reach into it.
  void raise(const ProjectedProfile& profile, const VertexRun& run) {
    const double *x = profile.x.data(), *y = profile.y.data();
    const double last = static_cast<double>(kColumnsABand);
    const auto first_column =
        static_cast<std::size_t>(std::clamp(std::ceil(at(x[run.first]) + kRounding), 0.0, last));
    const auto end_column =
        static_cast<std::size_t>(std::clamp(std::floor(at(x[run.last]) - kRounding), 0.0, last));
    if (first_column >= end_column) return;
    auto i = static_cast<std::uint32_t>(
        std::upper_bound(x + run.first + 1, x + run.last, x_of(first_column)) - x - 1);
    for (std::size_t column = first_column; column < end_column; ++column) {
      const double stop = x_of(column + 1);
      double low = std::min(y[i], y[i + 1]);
      while (i + 1 < run.last && x[i + 1] < stop) {
        ++i;
        low = std::min(low, y[i + 1]);
      }
      low_[column] = std::max(low_[column], low);
    }
  }

  // Whether all of y is below the horizon from x_begin to x_end, as far as it reaches.
  bool hides(double x_begin, double x_end, double y) const {
    const double last = static_cast<double>(kColumnsABand) - 1;
    const auto first =
        static_cast<std::size_t>(std::clamp(std::floor(at(x_begin) - kRounding), 0.0, last));
    const auto end =
        static_cast<std::size_t>(std::clamp(std::floor(at(x_end) + kRounding), 0.0, last));
    for (std::size_t i = first; i <= end; ++i)
      if (!(y < low_[i])) return false;
    return true;
  }

private:
  static constexpr double kRounding = 1e-9; // columns
  double at(double x) const { return (x - begin_) * per_x_; }
  double x_of(std::size_t column) const { return begin_ + static_cast<double>(column) / per_x_; }

  double begin_, per_x_;
  std::vector<double> low_;
};

// A profile's parts in a band of X. On the ellipsoid all of it, whatever is seen.
void Finder::cut(double depth_m, XRange band, const SeenGround& seen, std::vector<URange>& parts,
                 Profile& out) const {
  const URange within = u_range(view_, depth_m, band);
  if (earth_cutter_) {
    earth_cutter_->cut(depth_m, std::span(&within, 1), out);
  } else {
    over_blocks_->seen_parts(depth_m, within, seen, parts);
    cutter_->cut(depth_m, parts, out);
  }
}

void Finder::sweep_band(std::size_t band, SeenGround& seen) const {
  const double width = (x_end_ - x_begin_) / static_cast<double>(kBands);
  const double begin = x_begin_ + static_cast<double>(band) * width,
               end = x_begin_ + static_cast<double>(band + 1) * width;
  ColumnHorizon horizon(begin, end);
  Profile profile;
  ProjectedProfile projected;
  std::vector<Segment> uprights;
  std::vector<URange> parts;
  for (std::size_t plane = 0; plane < planes_; ++plane) {
    throw_if_stopped();
    const double depth_m = depth_of_plane(plane);
    if (!view_.is_perspective() || depth_m > view_.near_m) {
      cut(depth_m, {begin, end}, seen, parts, profile);
      project_profile(profile, 0, view_, projected, uprights);
      for (const VertexRun& run : projected.runs) horizon.raise(projected, run);
    }
    for (std::uint32_t k = plane > 0 ? plane_end_[plane - 1] : 0; k < plane_end_[plane]; ++k) {
      const BlockInView& block = in_view_[by_plane_[k]];
      const bool is_beside =
          (block.x_end < begin && band > 0) || (block.x_begin > end && band + 1 < kBands);
      const double slack = request_.tolerance_y + 1e-9 * std::abs(block.y_high) +
                           (view_.is_perspective() ? 1e-9 : rounding_m_);
      if (is_beside || horizon.hides(block.x_begin, block.x_end, block.y_high + slack))
        seen.seen[numbers_[by_plane_[k]]] = 0;
    }
  }
}

} // namespace

SeenGround find_seen_ground(const Grid& grid, const BlockBounds& bounds, const View& view,
                            const SeenGroundRequest& request) {
  return Finder(grid, bounds, view, request).find();
}

} // namespace orograph
