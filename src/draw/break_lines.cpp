// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/break_lines.hpp"

#include "draw/round_drawing.hpp"
#include "geometry/box.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace orograph {
namespace {

using Corners = std::array<Vec2, 4>;

struct Shares {
  double begin, end;
};

// Which part of a straight line is inside.
std::optional<Shares> inside(const Corners& box, Vec2 from, Vec2 to) {
  Shares part{0, 1};
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec2 axis = box[i + 1] - box[i];
    const double square = dot(axis, axis);
    if (!(square > 0)) return std::nullopt;
    const double a = dot(from - box[0], axis) / square, b = dot(to - box[0], axis) / square;
    if (a == b) {
      if (a <= 0 || a >= 1) return std::nullopt;
      continue;
    }
    double enters = (0 - a) / (b - a), leaves = (1 - a) / (b - a);
    if (enters > leaves) std::swap(enters, leaves);
    part = {std::max(part.begin, enters), std::min(part.end, leaves)};
  }
  if (!(part.begin < part.end)) return std::nullopt;
  return part;
}

class Breaker {
public:
  Breaker(Layer& layer, std::span<const Corners> boxes, double min_stroke_mm)
      : from_(std::move(layer)), to_(layer), boxes_(boxes), min_stroke_mm_(min_stroke_mm) {
    to_ = from_;
    to_.clear();
    to_.texts = from_.texts;
    for (const Corners& box : boxes) {
      Box2& bounds = bounds_.emplace_back();
      for (const Vec2 corner : box) bounds.include(corner);
    }
  }

  void take_all() {
    for (const Stroke& stroke : from_.strokes) {
      throw_if_stopped(to_.strokes.size());
      take(stroke);
    }
  }

private:
  void take(const Stroke& stroke) {
    const auto points = from_.points(stroke);
    Box2 bounds;
    for (const Vec2 point : points) bounds.include(point);
    near_.clear();
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if (bounds_[i].low.x <= bounds.high.x && bounds.low.x <= bounds_[i].high.x &&
          bounds_[i].low.y <= bounds.high.y && bounds.low.y <= bounds_[i].high.y)
        near_.push_back(i);
    is_broken_ = false;
    piece_ = {points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) cut(points[i - 1], points[i], stroke);
    end_piece(stroke);
  }

  // What of a straight line is in no box.
  void cut(Vec2 from, Vec2 to, const Stroke& stroke) {
    gone_.clear();
    for (const std::size_t box : near_)
      if (const auto part = inside(boxes_[box], from, to)) gone_.push_back(*part);
    std::ranges::sort(gone_, {}, &Shares::begin);
    const auto at = [&](double share) {
      const Vec2 place = from + share * (to - from);
      return Vec2{rounded_to_page_step(place.x), rounded_to_page_step(place.y)};
    };
    double done = 0;
    for (const auto& [begin, end] : gone_) {
      is_broken_ = true;
      if (begin > done) {
        if (piece_.empty()) piece_.push_back(at(done));
        piece_.push_back(at(begin));
      }
      end_piece(stroke);
      done = std::max(done, end);
    }
    if (done >= 1) return;
    if (piece_.empty()) piece_.push_back(at(done));
    piece_.push_back(to);
  }

  void end_piece(const Stroke& stroke) {
    const auto repeated = std::ranges::unique(piece_);
    if (is_broken_) piece_.erase(repeated.begin(), repeated.end());
    const bool stays =
        piece_.size() > 1 && (!is_broken_ || line_length_mm(piece_) >= min_stroke_mm_);
    if (stays) {
      to_.strokes.push_back(stroke);
      to_.strokes.back().first_point = static_cast<std::uint32_t>(to_.page_mm.size());
      to_.strokes.back().point_count = static_cast<std::uint32_t>(piece_.size());
      to_.page_mm.insert(to_.page_mm.end(), piece_.begin(), piece_.end());
    }
    piece_.clear();
  }

  Layer from_;
  Layer& to_;
  std::span<const Corners> boxes_;
  double min_stroke_mm_;
  std::vector<Box2> bounds_;
  // Of the stroke in work.
  std::vector<std::size_t> near_;
  std::vector<Shares> gone_;
  std::vector<Vec2> piece_;
  bool is_broken_ = false;
};

} // namespace

void break_lines(Layer& layer, std::span<const Corners> boxes, double min_stroke_mm) {
  if (!boxes.empty()) Breaker(layer, boxes, min_stroke_mm).take_all();
}

} // namespace orograph
