// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh's border, by depth: where a plane may come in.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace orograph {

/// Sides of triangles that have nothing beyond them, in buckets of the depths that they reach into.
/// Memory: 12 bytes and more for a side.
template <class Side>
class BorderSides {
public:
  struct Depths {
    double nearest_m, farthest_m;
  };

  /// `depths_of(side)` are those of its two ends.
  template <class DepthsOf>
  BorderSides(const std::vector<Side>& border, const DepthsOf& depths_of) {
    std::vector<Depths> depths;
    depths.reserve(border.size());
    for (const Side& side : border) {
      depths.push_back(depths_of(side));
      nearest_m_ = std::min(nearest_m_, depths.back().nearest_m);
      farthest_m_ = std::max(farthest_m_, depths.back().farthest_m);
    }
    // As many as there are rows in a large grid, and no more than there are sides.
    constexpr std::size_t kMostBuckets = 4096;
    const std::size_t count = std::min(kMostBuckets, border.size() + 1);
    if (farthest_m_ > nearest_m_)
      buckets_per_m_ = static_cast<double>(count) / (farthest_m_ - nearest_m_);
    begin_.assign(count + 1, 0);
    const auto for_each_bucket = [&](std::size_t i, const auto& take) {
      const std::size_t last = bucket_of(depths[i].farthest_m);
      for (std::size_t b = bucket_of(depths[i].nearest_m); b <= last; ++b) take(b);
    };
    for (std::size_t i = 0; i < border.size(); ++i)
      for_each_bucket(i, [&](std::size_t b) { ++begin_[b + 1]; });
    for (std::size_t b = 0; b < count; ++b) begin_[b + 1] += begin_[b];
    sides_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < border.size(); ++i)
      for_each_bucket(i, [&](std::size_t b) { sides_[next[b]++] = border[i]; });
  }

  /// Of all sides; of no side at all, infinity and -infinity.
  double nearest_m() const { return nearest_m_; }
  double farthest_m() const { return farthest_m_; }

  /// All sides that the plane at a depth meets, and others about there.
  std::span<const Side> at(double depth_m) const {
    const std::size_t b = bucket_of(depth_m);
    return {sides_.data() + begin_[b], sides_.data() + begin_[b + 1]};
  }

private:
  std::size_t bucket_of(double depth_m) const {
    const double bucket = (depth_m - nearest_m_) * buckets_per_m_;
    return std::min(static_cast<std::size_t>(std::max(bucket, 0.0)), begin_.size() - 2);
  }

  double nearest_m_ = std::numeric_limits<double>::infinity(), farthest_m_ = -nearest_m_;
  double buckets_per_m_ = 0;
  std::vector<std::uint32_t> begin_; ///< of bucket i in `sides_`; one more at the end
  std::vector<Side> sides_;
};

} // namespace orograph
