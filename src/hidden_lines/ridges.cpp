// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/ridges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {

void Ridges::take(const LinePicture& picture, std::span<const VisibleLinePart> visible, bool stands,
                  std::vector<LinePart>& parts, std::size_t first) {
  join_of_line(parts, first);
  const Segment& s = picture.source;
  for (std::size_t i = first; i < parts.size(); ++i) {
    const LinePart& part = parts[i];
    const double share =
        (0.5 * (part.t_begin + part.t_end) - picture.t_left) / (picture.t_right - picture.t_left);
    const ProfilePoint middle = point_between(picture.left, picture.right, share);
    // Nearly all lines have one part, whose ends in the picture are at hand.
    double length_mm = std::numeric_limits<double>::quiet_NaN();
    if (visible.size() == 1 &&
        std::min(picture.left.v, picture.right.v) >= pictures_.sector().view.drawn_from_m) {
      const auto at = [&](double t) {
        return Vec2{s.x0 + t * (s.x1 - s.x0), s.y0 + t * (s.y1 - s.y0)};
      };
      length_mm =
          folds_.length_if_inside_mm(at(visible.front().t_begin), at(visible.front().t_end));
    }
    const double reach_m = folds_.reach_m(middle.v);
    // Asked sooner, more of them still stand; later, the last strip of cells is out of reach.
    constexpr double kAskAt = 0.6;
    waiting_.push_back({part, middle, s.x0, s.x1, middle.v + reach_m, middle.v + kAskAt * reach_m,
                        length_mm, parts.size() == first + 1, stands});
  }
  parts.resize(first);
}

bool Ridges::stands(const Unjudged& unjudged, const BlockedHorizon& horizon) const {
  return horizon.shows(source_id(unjudged.part.line), unjudged.x_begin, unjudged.x_end);
}

bool Ridges::is_fold(const Unjudged& unjudged) const {
  return folds_.is_fold(pictures_.line(unjudged.part.line), unjudged.middle);
}

void Ridges::tell(const Unjudged& judged, bool is_fold) {
  const LinePart& part = judged.part;
  if (!is_fold) {
    ridges_.push_back(part);
    return;
  }
  folded_mm_ += std::isnan(judged.length_mm) ? folds_.length_mm(pictures_.whole(part.line), part)
                                             : judged.length_mm;
  if (judged.is_all) pictures_.drop_found(part.line);
}

void Ridges::judge_rest(const BlockedHorizon& horizon) {
  std::erase_if(rest_, [&](const Unjudged& unjudged) {
    if (stands(unjudged, horizon)) return false;
    tell(unjudged, unjudged.is_fold ? *unjudged.is_fold : is_fold(unjudged));
    return true;
  });
  judge_at_ = std::max(judge_at_, 2 * rest_.size()); // so that few are asked about often
}

void Ridges::judge(const BlockedHorizon& horizon) {
  rest_.insert(rest_.end(), waiting_.begin() + static_cast<std::ptrdiff_t>(next_), waiting_.end());
  waiting_.clear();
  next_ = 0;
  judge_rest(horizon);
}

std::vector<LinePart> Ridges::unjudged() const {
  std::vector<LinePart> out;
  out.reserve(rest_.size());
  for (const Unjudged& unjudged : rest_) out.push_back(unjudged.part);
  return out;
}

} // namespace orograph
