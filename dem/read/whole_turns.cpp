// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/whole_turns.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orograph {
namespace {

struct Span {
  double west, width;
};

// How far eastward from one longitude to another, from 0 to a turn.
double eastward(double from, double to, double turn) {
  return (to - from) - turn * std::floor((to - from) / turn);
}

} // namespace

void bring_together(std::vector<Tile>& tiles, double turn) {
  std::vector<Span> spans;
  for (const Tile& tile : tiles) {
    const Box2 box = box_of(tile.lattice);
    spans.push_back({box.low.x, box.width()});
  }
  const double rounding = length(tiles.front().lattice.pixel_step) / 4;
  std::optional<std::size_t> start;
  double widest = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    double reach = 0;
    for (const Span& s : spans)
      reach = std::max(reach, eastward(spans[i].west, s.west, turn) + s.width);
    const double gap = turn - reach;
    const bool tied = start && std::abs(gap - widest) <= rounding;
    if (start && !(tied ? spans[i].west < spans[*start].west : gap > widest)) continue;
    start = i;
    widest = gap;
  }
  const double west = spans[*start].west;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const double there = west + eastward(west, spans[i].west, turn);
    tiles[i].lattice.first.x += turn * std::round((there - spans[i].west) / turn);
  }
}

double turned_onto(double x, double width, double low, double high, double turn) {
  const auto common = [&](double from) {
    return std::min(from + width, high) - std::max(from, low);
  };
  const double nearest = std::round((low - x) / turn);
  double best = x;
  for (const double turns : {nearest - 1, nearest, nearest + 1}) {
    const double from = x + turns * turn;
    const double more = common(from) - common(best);
    const double rounding = 1e-9 * turn;
    if (more > rounding || (more >= -rounding && std::abs(from - x) < std::abs(best - x)))
      best = from;
  }
  return best;
}

} // namespace orograph
