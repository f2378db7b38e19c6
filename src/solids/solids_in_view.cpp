// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/solids_in_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {

SolidsInView::SolidsInView(std::span<const StandingSolid> standing, const View& view)
    : view_(view) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  x_begin_ = core_begin_ = kInfinity;
  x_end_ = -kInfinity;
  double core_end = -kInfinity;
  for (const StandingSolid& one : standing) {
    solids_.push_back(in_view(one, view));
    sliver_m_ = std::max(sliver_m_, 256 * solids_.back().rounding_m);
    const SeenBox& box = solids_.back().box;
    if (is_behind_eye(view, box)) continue;
    x_begin_ = std::min(x_begin_, box.x_begin);
    x_end_ = std::max(x_end_, box.x_end);
    if (std::isinf(box.x_begin)) continue;
    core_begin_ = std::min(core_begin_, box.x_begin);
    core_end = std::max(core_end, box.x_end);
  }
  // A bucket holds a few, if they stand apart; beyond some thousand they cost more than they save.
  constexpr std::size_t kMostBuckets = 8192;
  const std::size_t count = std::clamp<std::size_t>(4 * solids_.size(), 1, kMostBuckets);
  buckets_.resize(count);
  if (!(core_begin_ < core_end))
    core_begin_ = 0;
  else
    per_x_ = static_cast<double>(count) / (core_end - core_begin_);
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    const SeenBox& box = solids_[i].box;
    if (is_behind_eye(view, box)) continue;
    for (std::size_t b = bucket_of(box.x_begin); b <= bucket_of(box.x_end); ++b)
      buckets_[b].push_back(static_cast<std::uint32_t>(i));
  }
}

std::size_t SolidsInView::bucket_of(double x) const {
  if (per_x_ == 0) return 0;
  const double number = (x - core_begin_) * per_x_;
  return static_cast<std::size_t>(
      std::clamp(number, 0.0, static_cast<double>(buckets_.size() - 1)));
}

void SolidsInView::add_hidden(const LineInView& line, const OwnEdge& own,
                              std::vector<Share>& hidden) const {
  for_each_before(line.box, [&](std::size_t i) {
    for (const TriangleShadow& triangle : solids_[i].shadows) {
      if (!overlap(triangle.box, line.box)) continue;
      if (i == own.solid && (triangle.triangle == own.left || triangle.triangle == own.right))
        continue;
      if (const auto share = hidden_share(triangle.shadow, line.from, line.to))
        hidden.push_back(*share);
    }
  });
}

} // namespace orograph
