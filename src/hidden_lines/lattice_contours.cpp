// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/lattice_contours.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph {

void LatticeContours::take(const PlaceContours::Piece& piece) {
  const Point &a = place_.point(piece.from), &b = place_.point(piece.to);
  const double nearest = std::min(a.at.v, b.at.v);
  if (!(nearest > lattice_.work.from_m)) return take_exactly(piece);
  const auto [x_begin, x_end] = std::minmax({a.x, b.x});
  const auto [y_low, y_high] = std::minmax({a.y, b.y});
  const XRange looked_at = pictures_.looked_at();
  if (x_end < looked_at.begin || x_begin > looked_at.end) return;
  // In this strip alone, and not straight away from the eye.
  const bool is_plain = nearest >= lattice_.view.drawn_from_m && x_begin > inner_range_.begin &&
                        x_end < inner_range_.end &&
                        pictures_.is_wider(x_end - x_begin, std::max(-x_begin, x_end), nearest);
  if (!is_plain) return take_exactly(piece);
  // What is tied is nearer than this, and rounding far less.
  const double slack =
      lattice_.work.tolerance.greatest_y + 1e-12 * (std::abs(y_low) + std::abs(y_high));
  bool is_above = true, is_below = true;
  const auto& blocks = horizon_.blocks();
  // Mostly that of the piece before it.
  if (!(blocks[block_].x_begin <= x_begin && x_begin < blocks[block_].x_end))
    block_ = horizon_.block_at(x_begin);
  for (std::size_t i = block_; i < blocks.size() && blocks[i].x_begin <= x_end; ++i) {
    is_above = is_above && y_low > blocks[i].high + slack;
    is_below = is_below && y_high < blocks[i].low;
  }
  if (is_below) return;
  if (!is_above) {
    const bool rises = a.x < b.x;
    const Segment source{x_begin, rises ? a.y : b.y, x_end, rises ? b.y : a.y, 0};
    visible_.clear();
    add_above_horizon({source, 0, 0, x_begin, x_end, false, true}, 0, horizon_,
                      lattice_.work.tolerance, visible_);
    if (visible_.empty()) return;
    if (visible_.front().t_begin > 0 || visible_.front().t_end < 1) return take_exactly(piece);
  }
  link(piece);
}

void LatticeContours::take_exactly(const PlaceContours::Piece& piece) {
  const Point *from = &place_.point(piece.from), *to = &place_.point(piece.to);
  if (to->number < from->number) std::swap(from, to);
  if (std::max(from->at.v, to->at.v) <= pictures_.from_m()) return;
  const LinePicture picture = pictures_.picture(ProfileLine{from->at, to->at});
  SurfaceLine line = pictures_.surface_line({{}, LineKind::contour, false, true, false}, picture);
  if (!pictures_.cut_to_range(line)) return;
  visible_.clear();
  if (line.upright()) {
    const bool is_edge = to->number < lattice_.grid.size();
    if (pictures_.is_hidden(picture, horizon_)) return;
    add_above_height(line, 0,
                     is_edge ? uprights_.in_front({static_cast<std::uint32_t>(from->number),
                                                   static_cast<std::uint32_t>(to->number)},
                                                  picture.t_left < picture.t_right, line, horizon_)
                             : height_in_front(line, horizon_),
                     visible_);
  } else {
    add_above_horizon(line, 0, horizon_, lattice_.work.tolerance, visible_);
  }
  shares_.clear();
  for (const auto& [same, t_begin, t_end] : visible_)
    pictures_.add_part(0, picture, t_begin, t_end, shares_);
  const auto end = [&](const Point& point) {
    return ContourPoint{{piece.level, point.number}, point.at};
  };
  for (const auto& [same, t_begin, t_end] : shares_)
    if (t_begin <= 0 && t_end >= 1 && picture.source.x0 > inner_range_.begin &&
        picture.source.x1 < inner_range_.end)
      link(piece);
    else
      parts_.push_back({end(*from), end(*to), t_begin, t_end});
}

void LatticeContours::link(const PlaceContours::Piece& piece) {
  const auto number = [&](std::uint32_t of_place) {
    Point& point = place_.point(of_place);
    if (!chains_.has(point.chained))
      point.chained = chains_.add({{piece.level, point.number}, point.at});
    return point.chained;
  };
  const std::uint32_t from = number(piece.from);
  chains_.link(from, number(piece.to));
}

} // namespace orograph
