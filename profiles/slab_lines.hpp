// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on the surface, handed out slab by slab.
#pragma once

#include "dem/surface.hpp"
#include "geometry/profile_point.hpp"
#include "geometry/turn.hpp"
#include "profiles/triangles.hpp"
#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace orograph {

/// Ends of a line in the profile frame.
struct ProfileLine {
  ProfilePoint from, to;
};
ProfileLine line_of(const Grid& grid, const View& view, SurfaceEdge edge);
ProfileLine line_of(const Tin& tin, const View& view, SurfaceEdge edge);
ProfileLine line_of(const Surface& surface, const View& view, SurfaceEdge edge);
/// The same of a vertex.
ProfilePoint point_of(const Surface& surface, const View& view, std::uint32_t vertex);

/// A point on an edge of the surface, a share of the way from its `from` end.
struct EdgePoint {
  SurfaceEdge edge;
  double t;
};

/// Points of lines on the ground, in the profile frame of a view.
struct GroundPoints {
  std::span<const ProfilePoint> points;
  Turn turn = {}; ///< to the frame that they are asked for in: that of one of the view's sectors
};

/// `line_of`, for who asks it of millions of edges: with what is the same for all edges of a grid
/// decided beforehand: on a map plane a fifth of its time.
/// Vertices from the surface's count of them on are those of `points`: lines on the ground.
class EdgeEnds {
public:
  /// REQUIRES that all outlive this.
  EdgeEnds(const Surface& surface, const View& view, const GroundPoints& points = {})
      : surface_(surface), view_(view), points_(points) {
    const Grid* grid = std::get_if<Grid>(&surface);
    first_point_ =
        static_cast<std::uint32_t>(grid ? grid->size() : std::get<Tin>(surface).vertices_m.size());
    if (!grid) return;
    lattice_ = std::get_if<PlaneLattice>(&grid->lattice);
    earth_ = std::get_if<EarthLattice>(&grid->lattice);
    columns_ = static_cast<std::uint32_t>(grid->columns);
    rows_an_index_ = 1.0 / columns_;
    if (const auto* heights = std::get_if<Heights<float>>(&grid->heights_m))
      heights_ = heights->data();
  }

  ProfileLine operator()(SurfaceEdge edge) const {
    if (edge.to >= first_point_) return {end(edge.from), end(edge.to)};
    if (!heights_) return line_of(surface_, view_, edge);
    const std::uint32_t row = row_of(edge.from), column = edge.from - row * columns_,
                        step = edge.to - edge.from;
    const std::uint32_t down = step == 1 ? 0 : 1, across = step == columns_ ? 0 : 1;
    return {at(column, row, edge.from), at(column + across, row + down, edge.to)};
  }

  /// Of a vertex of the surface.
  ProfilePoint vertex(std::uint32_t number) const {
    if (!heights_) return point_of(surface_, view_, number);
    const std::uint32_t row = row_of(number);
    return at(number - row * columns_, row, number);
  }

  /// Whether a line is an edge, and not one on the ground.
  bool is_edge(SurfaceEdge line) const { return line.to < first_point_; }

  /// Has a line's points on the ground brought into the cache, for who asks of them soon. (A call
  /// of what does nothing else is left out by GCC.)
  [[gnu::always_inline]] void fetch(SurfaceEdge line) const {
    if (line.from >= first_point_) __builtin_prefetch(&points_.points[line.from - first_point_]);
    if (line.to >= first_point_) __builtin_prefetch(&points_.points[line.to - first_point_]);
  }

private:
  ProfilePoint end(std::uint32_t number) const {
    return number < first_point_ ? vertex(number)
                                 : points_.turn(points_.points[number - first_point_]);
  }

  std::uint32_t row_of(std::uint32_t index) const {
    auto row = static_cast<std::uint32_t>(index * rows_an_index_);
    // The product is rounded.
    if (row * columns_ > index) --row;
    if (index - row * columns_ >= columns_) ++row;
    return row;
  }

  ProfilePoint at(std::uint32_t column, std::uint32_t row, std::uint32_t index) const {
    const auto c = static_cast<int>(column), r = static_cast<int>(row);
    return to_profile_frame(view_, lattice_ ? lattice_->vertex_m(c, r, heights_[index])
                                            : earth_->vertex_m(c, r, heights_[index]));
  }

  const Surface& surface_;
  const View& view_;
  GroundPoints points_;
  std::uint32_t first_point_;
  const PlaneLattice* lattice_ = nullptr; ///< of a grid one of the two
  const EarthLattice* earth_ = nullptr;
  const float* heights_ = nullptr; ///< where the quick way is to be gone
  std::uint32_t columns_ = 0;
  double rows_an_index_ = 0;
};

/// The part of a line that lies in one slab, from t_begin to t_end (0 at the line's `from` end, 1
/// at its `to` end). Where a slab's plane cuts a line, the t on both sides is the same number.
struct SlabPiece {
  std::uint32_t line;
  double t_begin, t_end;
  ProfileLine whole; ///< the line
  ProfilePoint begin, end;
};

/// A line by its number, and the depth of its nearer end.
struct LineAtDepth {
  std::uint32_t line;
  float nearest_m;
};

/// Cuts lines by the planes of consecutive slabs. `LineOf` tells the ends of the line of a number
/// (ProfileLine), and if it has `fetch(lines, at)`, is told which of a list is asked of next.
/// Memory: 4 bytes a line. Cost in all: a sort of the lines, and O(1) a piece.
template <class LineOf>
class SlabLines {
public:
  /// Lines are asked from `line_of` when they are needed. The first slab begins at depth `from_m`;
  /// what lies nearer is left out.
  SlabLines(std::span<const LineAtDepth> lines, LineOf line_of, double from_m);

  /// Calls take(piece) with each piece (SlabPiece) in the slab from the last plane to the one at
  /// `to_m`, which is in it, in no particular order. A line of which it returns false isn't looked
  /// at any more. REQUIRES that `to_m` never falls.
  template <class Take>
  void next(double to_m, const Take& take);

private:
  template <class Take>
  bool cut(std::uint32_t line, double to_m, const Take& take);

  LineOf line_of_;
  std::vector<std::uint32_t> by_depth_;   ///< lines, by bucket of their nearer end
  std::vector<std::uint32_t> bucket_end_; ///< in `by_depth_`
  std::vector<double> bucket_begin_m_;    ///< no line of the bucket is nearer
  std::size_t waiting_ = 0;               ///< first bucket that hasn't begun
  std::size_t begun_ = 0;                 ///< lines that have
  std::vector<std::uint32_t> active_;
  double from_m_;
};

// Lines are parted into buckets of depth, which is cheaper than sorting them: a bucket is begun as
// a whole, and those of its lines that lie farther wait among the active ones.
template <class LineOf>
SlabLines<LineOf>::SlabLines(std::span<const LineAtDepth> lines, LineOf line_of, double from_m)
    : line_of_(std::move(line_of)), by_depth_(lines.size()), from_m_(from_m) {
  if (lines.empty()) return;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const LineAtDepth& line : lines) {
    low = std::min<double>(low, line.nearest_m);
    high = std::max<double>(high, line.nearest_m);
  }
  constexpr std::size_t kBuckets = 4096; // as many as there are rows in a large grid
  const double per_m = high > low ? (kBuckets - 2) / (high - low) : 0;
  const auto bucket = [&](float depth) {
    return static_cast<std::size_t>(std::clamp((depth - low) * per_m, 0.0, kBuckets - 2.0));
  };
  bucket_end_.assign(kBuckets, 0);
  for (const auto& [line, depth] : lines) ++bucket_end_[bucket(depth) + 1];
  std::partial_sum(bucket_end_.begin(), bucket_end_.end(), bucket_end_.begin());
  for (const auto& [line, depth] : lines) by_depth_[bucket_end_[bucket(depth)]++] = line;
  bucket_begin_m_.resize(kBuckets);
  for (std::size_t b = 0; b < kBuckets; ++b) {
    // Rounding to float may have put a line into a bucket that begins behind it.
    const double slack = 1e-6 * std::max(std::abs(low), std::abs(high));
    bucket_begin_m_[b] = per_m > 0 ? low + static_cast<double>(b) / per_m - slack : low - slack;
  }
}

// Takes the line's piece up to `to_m`; tells whether the line is looked at behind it.
template <class LineOf>
template <class Take>
bool SlabLines<LineOf>::cut(std::uint32_t i, double to_m, const Take& take) {
  const ProfileLine line = line_of_(i);
  const auto& [from, to] = line;
  const double nearest = std::min(from.v, to.v), farthest = std::max(from.v, to.v);
  if (nearest > to_m) return true;
  if (farthest < from_m_ || (farthest == from_m_ && nearest < farthest)) return false;
  const auto t_at = [&, &a = from, &b = to](double depth) {
    return std::clamp((depth - a.v) / (b.v - a.v), 0.0, 1.0);
  };
  double t_near = from.v <= to.v ? 0 : 1, t_far = 1 - t_near;
  if (nearest < from_m_) t_near = t_at(from_m_);
  if (farthest > to_m) t_far = t_at(to_m);
  const double begin = std::min(t_near, t_far), end = std::max(t_near, t_far);
  if (begin < end && !take(SlabPiece{i, begin, end, line, point_between(from, to, begin),
                                     point_between(from, to, end)}))
    return false;
  return farthest > to_m;
}

template <class LineOf>
template <class Take>
void SlabLines<LineOf>::next(double to_m, const Take& take) {
  std::erase_if(active_, [&](std::uint32_t i) { return !cut(i, to_m, take); });
  for (; waiting_ < bucket_end_.size() && bucket_begin_m_[waiting_] <= to_m; ++waiting_)
    for (; begun_ < bucket_end_[waiting_]; ++begun_) {
      if constexpr (requires { line_of_.fetch(by_depth_, begun_); })
        line_of_.fetch(by_depth_, begun_);
      if (cut(by_depth_[begun_], to_m, take)) active_.push_back(by_depth_[begun_]);
    }
  from_m_ = to_m;
}

} // namespace orograph
