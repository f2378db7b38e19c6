// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/slab_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace orograph {

ProfileLine line_of(const Grid& grid, const View& view, SurfaceEdge edge) {
  return {to_profile_frame(view, grid.vertex_m(edge.from)),
          to_profile_frame(view, grid.vertex_m(edge.to))};
}

ProfileLine line_of(const Tin& tin, const View& view, SurfaceEdge edge) {
  return {to_profile_frame(view, tin.vertices_m[edge.from]),
          to_profile_frame(view, tin.vertices_m[edge.to])};
}

ProfileLine line_of(const Surface& surface, const View& view, SurfaceEdge edge) {
  return std::visit([&](const auto& s) { return line_of(s, view, edge); }, surface);
}

// Lines are parted into buckets of depth, which is cheaper than sorting them: a bucket is begun as
// a whole, and those of its lines that lie farther wait among the active ones.
SlabLines::SlabLines(std::uint32_t count, LineOf line_of, double from_m)
    : line_of_(std::move(line_of)), by_depth_(count), from_m_(from_m) {
  if (count == 0) return;
  std::vector<float> nearest(count);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::uint32_t i = 0; i < count; ++i) {
    const ProfileLine line = line_of_(i);
    const double depth = std::min(line.from.v, line.to.v);
    nearest[i] = static_cast<float>(depth);
    low = std::min(low, depth);
    high = std::max(high, depth);
  }
  constexpr std::size_t kBuckets = 4096; // as many as there are rows in a large grid
  const double per_m = high > low ? (kBuckets - 2) / (high - low) : 0;
  const auto bucket = [&](float depth) {
    return static_cast<std::size_t>(std::clamp((depth - low) * per_m, 0.0, kBuckets - 2.0));
  };
  bucket_end_.assign(kBuckets, 0);
  for (const float depth : nearest) ++bucket_end_[bucket(depth) + 1];
  std::partial_sum(bucket_end_.begin(), bucket_end_.end(), bucket_end_.begin());
  for (std::uint32_t i = 0; i < count; ++i) by_depth_[bucket_end_[bucket(nearest[i])]++] = i;
  bucket_begin_m_.resize(kBuckets);
  for (std::size_t b = 0; b < kBuckets; ++b) {
    // Rounding to float may have put a line into a bucket that begins behind it.
    const double slack = 1e-6 * std::max(std::abs(low), std::abs(high));
    bucket_begin_m_[b] = per_m > 0 ? low + static_cast<double>(b) / per_m - slack : low;
  }
}

// Adds the line's piece up to `to_m`; tells whether the line goes on behind it.
bool SlabLines::cut(std::uint32_t i, double to_m, const Hidden& hidden) {
  const ProfileLine line = line_of_(i);
  const auto& [from, to] = line;
  const auto [nearest, farthest] = std::minmax(from.v, to.v);
  if (nearest > to_m) return true;
  if (farthest < from_m_ || (farthest == from_m_ && nearest < farthest)) return false;
  if (hidden && nearest >= from_m_ && hidden(line)) return false;
  const auto t_at = [&, &a = from, &b = to](double depth) {
    return std::clamp((depth - a.v) / (b.v - a.v), 0.0, 1.0);
  };
  double t_near = from.v <= to.v ? 0 : 1, t_far = 1 - t_near;
  if (nearest < from_m_) t_near = t_at(from_m_);
  if (farthest > to_m) t_far = t_at(to_m);
  const auto [begin, end] = std::minmax(t_near, t_far);
  if (begin < end)
    pieces_.push_back(
        {i, begin, end, line, point_between(from, to, begin), point_between(from, to, end)});
  return farthest > to_m;
}

std::span<const SlabPiece> SlabLines::next(double to_m, const Hidden& hidden) {
  pieces_.clear();
  std::erase_if(active_, [&](std::uint32_t i) { return !cut(i, to_m, hidden); });
  for (; waiting_ < bucket_end_.size() && bucket_begin_m_[waiting_] <= to_m; ++waiting_)
    for (; begun_ < bucket_end_[waiting_]; ++begun_)
      if (cut(by_depth_[begun_], to_m, hidden)) active_.push_back(by_depth_[begun_]);
  from_m_ = to_m;
  return pieces_;
}

} // namespace orograph
