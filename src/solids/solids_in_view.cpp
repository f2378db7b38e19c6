// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/solids_in_view.hpp"

#include <cmath>
#include <limits>

namespace orograph {

SolidsInView::SolidsInView(std::span<const StandingSolid> standing, const View& view)
    : view_(view), x_begin_(std::numeric_limits<double>::infinity()), x_end_(-x_begin_) {
  std::vector<std::uint32_t> inside;
  for (const StandingSolid& one : standing) {
    const auto number = static_cast<std::uint32_t>(solids_.size());
    solids_.push_back(in_view(one, view));
    sliver_m_ = std::max(sliver_m_, 256 * solids_.back().rounding_m);
    const SeenBox& box = solids_.back().box;
    if (is_behind_eye(view, box)) continue;
    x_begin_ = std::min(x_begin_, box.x_begin);
    x_end_ = std::max(x_end_, box.x_end);
    if (std::isinf(box.x_begin)) {
      everywhere_.push_back(number);
      continue;
    }
    core_.include({box.x_begin, box.y_low});
    core_.include({box.x_end, box.y_high});
    inside.push_back(number);
  }
  if (inside.empty()) return;
  // Where solids stand apart most buckets are empty, and a line that passes by them costs a look.
  constexpr double kMost = 256;
  side_ = static_cast<std::size_t>(
      std::clamp(4 * std::sqrt(static_cast<double>(inside.size())), 1.0, kMost));
  buckets_.resize(side_ * side_);
  columns_.resize(side_);
  const auto per = [&](double size) { return size > 0 ? static_cast<double>(side_) / size : 0; };
  per_x_ = per(core_.width());
  per_y_ = per(core_.height());
  for (const std::uint32_t i : inside) {
    const SeenBox& box = solids_[i].box;
    for (std::size_t c = column_of(box.x_begin); c <= column_of(box.x_end); ++c)
      columns_[c].push_back(i);
    for (std::size_t r = row_of(box.y_low); r <= row_of(box.y_high); ++r)
      for (std::size_t c = column_of(box.x_begin); c <= column_of(box.x_end); ++c)
        buckets_[r * side_ + c].push_back(i);
  }
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
