// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/shown_of_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace orograph {
namespace {

// A corner of the part of a place that a range of X shows.
struct Corner {
  double u, v;
};

// A convex polygon of few corners, cut by half-planes.
class Shown {
public:
  void add(Corner corner) { corners_[count_++] = corner; }
  // Leaves what `inside` is not negative of; it is linear.
  template <class Inside>
  void cut(const Inside& inside) {
    Shown left;
    for (std::size_t i = 0; i < count_; ++i) {
      const Corner a = corners_[i], b = corners_[(i + 1) % count_];
      const double at_a = inside(a), at_b = inside(b);
      if (at_a >= 0) left.add(a);
      if ((at_a >= 0) == (at_b >= 0)) continue;
      const double share = at_a / (at_a - at_b);
      left.add({a.u + share * (b.u - a.u), a.v + share * (b.v - a.v)});
    }
    *this = left;
  }
  bool empty() const { return count_ == 0; }
  // The least and the greatest of what is asked of the corners.
  template <class Value>
  std::pair<double, double> range(const Value& value) const {
    std::pair<double, double> out{std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < count_; ++i) {
      const double at = value(corners_[i]);
      out = {std::min(out.first, at), std::max(out.second, at)};
    }
    return out;
  }

private:
  std::array<Corner, 12> corners_; // four, and at most one more for each cut
  std::size_t count_ = 0;
};

} // namespace

ShownOfPlace shown_of(const LatticeInWork& lattice, const LatticeOrder::Place& place,
                      XRange range) {
  const auto [line, strip] = place;
  constexpr int kNoLine = LatticeOrder::Place::kNone;
  const int first = line != kNoLine && (strip == kNoLine || line < strip) ? line : strip,
            last = strip == kNoLine ? line : std::max(line, strip + 1);
  if (first == kNoLine) return {};
  if (const EarthStrips* earth = lattice.order.earth()) {
    const auto [cells, nearest_m, farthest_m] = earth->shown(first, last, range);
    return cells.empty() ? ShownOfPlace{}
                         : ShownOfPlace{nearest_m, farthest_m, cells.first, cells.end};
  }
  const bool rows = lattice.order.rows_are_strips();
  const int cells = rows ? lattice.grid.columns - 1 : lattice.grid.rows - 1;
  const View& view = lattice.work.sector.view;
  Shown shown;
  for (const auto& [at_strip, at_cell] :
       {std::pair{first, 0}, {last, 0}, {last, cells}, {first, cells}}) {
    const Vec2 at =
        lattice.grid.plane().position_m(rows ? at_cell : at_strip, rows ? at_strip : at_cell) -
        view.depth_origin_m;
    shown.add({dot(at, view.right), dot(at, view.forward)});
  }
  const double slack_m = 1e-6 * lattice.work.placed.cell_m;
  if (view.is_perspective()) shown.cut([&](Corner p) { return p.v - view.near_m; });
  const auto beside = [&](Corner p, double x) {
    return view.is_perspective() ? p.u - x * p.v : p.u + p.v * view.x_per_v - x;
  };
  if (!std::isinf(range.begin))
    shown.cut([&](Corner p) { return beside(p, range.begin) + slack_m; });
  if (!std::isinf(range.end)) shown.cut([&](Corner p) { return slack_m - beside(p, range.end); });
  if (shown.empty()) return {};
  const auto [nearest_m, farthest_m] = shown.range([](Corner p) { return p.v; });
  const auto [first_cell, last_cell] =
      shown.range([&](Corner p) { return lattice.cell.at(p.u, p.v); });
  // What is shown of an edge is in a cell beside it, to rounding.
  const auto clamped = [&](double cell) {
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(cells)));
  };
  return {nearest_m - slack_m, farthest_m + slack_m, clamped(std::floor(first_cell) - 1),
          clamped(std::floor(last_cell) + 2)};
}

} // namespace orograph
