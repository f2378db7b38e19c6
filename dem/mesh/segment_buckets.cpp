// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/segment_buckets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph {

SegmentBuckets::SegmentBuckets(std::span<const std::vector<Vec2>> lines, double reach_m) {
  double count = 1;
  for (const auto& line : lines) {
    count += static_cast<double>(line.size());
    for (const Vec2 p : line) box_.include(p);
  }
  bucket_m_ = 4 * reach_m;
  if (!box_.empty()) {
    const double width = box_.width(), height = box_.height();
    bucket_m_ = std::max(
        {bucket_m_, std::sqrt(width) * std::sqrt(height / count), std::max(width, height) / count});
    columns_ = 1 + static_cast<int>(width / bucket_m_);
    rows_ = 1 + static_cast<int>(height / bucket_m_);
  }
  slack_m_ = 2 * reach_m + 0x1p-20 * bucket_m_;
  buckets_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

// Row by row of buckets, where the segment is, with slack for the reach and rounding.
template <class Visit>
void SegmentBuckets::for_each_bucket(Vec2 from, Vec2 to, Visit visit) const {
  if (from.y > to.y) std::swap(from, to);
  const auto number = [&](double place_m, int count) {
    return static_cast<int>(std::clamp(place_m / bucket_m_, 0.0, count - 1.0));
  };
  const int last_row = number(to.y + slack_m_ - box_.low.y, rows_);
  for (int row = number(from.y - slack_m_ - box_.low.y, rows_); row <= last_row; ++row) {
    const double low_y = box_.low.y + row * bucket_m_ - slack_m_;
    const double high_y = box_.low.y + (row + 1) * bucket_m_ + slack_m_;
    const auto x_at = [&](double y) {
      const double share = to.y > from.y ? (y - from.y) / (to.y - from.y) : 0;
      return from.x + std::clamp(share, 0.0, 1.0) * (to.x - from.x);
    };
    double x0 = from.y < low_y ? x_at(low_y) : from.x, x1 = to.y > high_y ? x_at(high_y) : to.x;
    if (x0 > x1) std::swap(x0, x1);
    const int last_column = number(x1 + slack_m_ - box_.low.x, columns_);
    for (int column = number(x0 - slack_m_ - box_.low.x, columns_); column <= last_column; ++column)
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column));
  }
}

void SegmentBuckets::add(std::uint32_t segment, Vec2 from, Vec2 to) {
  for_each_bucket(from, to, [&](std::size_t bucket) { buckets_[bucket].push_back(segment); });
}

void SegmentBuckets::near(Vec2 from, Vec2 to, std::vector<std::uint32_t>& out) const {
  out.clear();
  for_each_bucket(from, to, [&](std::size_t bucket) {
    out.insert(out.end(), buckets_[bucket].begin(), buckets_[bucket].end());
  });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

} // namespace orograph
