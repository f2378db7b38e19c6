// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/earth_line.hpp"

#include "geometry/angle.hpp"
#include "profiles/eye_side.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// Of heights one after another and those beside them, another line's.
struct HeightSpread {
  float highest = 0, along = 0, across = 0; // without their signs: of a height, and of differences
  bool all_there = true;
};

// Of count + 1 heights; no differences of the last one along the line. Loops for the vector units.
HeightSpread spread_of(const float* heights, const float* beside, int count) {
  constexpr int kLanes = 8;
  std::array<float, kLanes> highest{}, along{}, across{}, gaps{};
  const auto take = [&](int i, std::size_t k, float next) {
    const auto raise = [&](std::array<float, kLanes>& most, float value) {
      value = std::abs(value);
      most[k] = value > most[k] ? value : most[k];
    };
    const float h = heights[i];
    raise(highest, h);
    raise(along, next - h);
    raise(across, h - beside[i]);
    gaps[k] += h - h; // no number from now on if that is none
  };
  int i = 0;
  for (; i + kLanes <= count; i += kLanes)
    for (std::size_t k = 0; k < kLanes; ++k)
      take(i + static_cast<int>(k), k, heights[i + static_cast<int>(k) + 1]);
  for (; i <= count; ++i) take(i, 0, i < count ? heights[i + 1] : heights[i]);
  HeightSpread out;
  for (std::size_t k = 0; k < kLanes; ++k) {
    out.highest = std::max(out.highest, highest[k]);
    out.along = std::max(out.along, along[k]);
    out.across = std::max(out.across, across[k]);
    out.all_there = out.all_there && gaps[k] == 0;
  }
  return out;
}

} // namespace

EarthLine::EarthLine(const Grid& grid, const View& view, const LookedAt& looked, bool are_rows,
                     bool next_is_left)
    : grid_(grid), earth_(grid.earth()), view_(view), looked_(looked), are_rows_(are_rows),
      next_is_left_(next_is_left), vertices_(are_rows ? grid.columns : grid.rows) {
  const DegreeLattice& degrees = earth_.degrees();
  const auto radians = [](double deg) { return std::abs(Angle::degrees(deg).in_radians()); };
  along_rad_ = radians(are_rows ? degrees.lon_step_deg : degrees.lat_step_deg);
  across_rad_ = radians(are_rows ? degrees.lat_step_deg : degrees.lon_step_deg);
  // Parallels and meridians at height 0 bend and turn by no more than this for a radian, flat as
  // the earth may be.
  const Ellipsoid& ellipsoid = earth_.frame().ellipsoid();
  const double round = 1 - ellipsoid.eccentricity_squared();
  bend_m_ = 4 * ellipsoid.semi_major_axis_m / (round * round);
  const auto count = static_cast<std::size_t>(vertices_);
  heights_.resize(count);
  beyond_.resize(count);
  sides_.resize(count - 1);
}

void EarthLine::read(int line, const EarthLine& before) {
  line_ = line;
  std::visit([&](const auto& heights) { take_heights(heights); }, grid_.heights_m);
  const std::size_t blocks = (heights_.size() + kBlock - 1) / kBlock;
  blocks_.clear();
  filled_m_.clear();
  is_filled_ = false;
  const bool is_limited = earth_.lean_limits() != nullptr;
  for (std::size_t i = 0; i < blocks && !is_limited && !is_filled_; ++i) {
    const auto first = i * kBlock;
    const int count = end_of(i) - static_cast<int>(first);
    const HeightSpread heights = spread_of(&heights_[first], &before.heights_[first], count);
    is_filled_ = !heights.all_there;
    // Floats are rounded, and so are their differences.
    const double rounding_m = 1e-6 * heights.highest;
    blocks_.push_back({});
    Block& block = blocks_.back();
    block.high_m = heights.highest + rounding_m;
    block.across_m = heights.across + rounding_m;
    block.along_m = heights.along + rounding_m;
  }
  if (is_limited || is_filled_) {
    blocks_.clear();
    fill();
  }
  for (std::size_t i = 0; i < blocks; ++i)
    if (blocks_.empty() || !bound(i)) judge(i);
}

template <class Height>
void EarthLine::take_heights(const Heights<Height>& heights) {
  const std::size_t step = are_rows_ ? 1 : static_cast<std::size_t>(grid_.columns);
  const Height* const from =
      heights.data() + (are_rows_ ? grid_.index(0, line_) : grid_.index(line_, 0));
  float* const to = heights_.data();
  for (std::size_t i = 0; i < heights_.size(); ++i) to[i] = static_cast<float>(from[i * step]);
}

// What is filled is as high as its neighbour leans.
void EarthLine::fill() {
  filled_m_.resize(heights_.size());
  for (int i = 0; i < vertices_; ++i) {
    const int column = are_rows_ ? i : line_, row = are_rows_ ? line_ : i;
    filled_m_[static_cast<std::size_t>(i)] =
        earth_.leaning_height_m(column, row, grid_.height_m(column, row));
  }
  const auto is_there = [](double height) { return !std::isnan(height); };
  const auto first = std::ranges::find_if(filled_m_, is_there);
  is_filled_ = first == filled_m_.end() || !std::ranges::all_of(filled_m_, is_there);
  double last = first == filled_m_.end() ? 0 : *first;
  for (double& height : filled_m_) last = height = std::isnan(height) ? last : height;
}

// The first vertex of the next block, or the last one.
int EarthLine::end_of(std::size_t block) const {
  return std::min(static_cast<int>(block + 1) * kBlock, vertices_ - 1);
}

Vec2 EarthLine::on_plane(Vec3 at) const {
  const Vec2 from_origin = Vec2{at.x, at.y} - view_.depth_origin_m;
  return {dot(from_origin, view_.right), dot(from_origin, view_.forward)};
}

Vec2 EarthLine::place(int vertex) const {
  const int column = are_rows_ ? vertex : line_, row = are_rows_ ? line_ : vertex;
  const double height_m =
      filled_m_.empty() ? grid_.height_m(column, row) : filled_m_[static_cast<std::size_t>(vertex)];
  return on_plane(earth_.vertex_m(column, row, height_m));
}

Vec2 EarthLine::at_height(int vertex, double height_m) const {
  const int column = are_rows_ ? vertex : line_, row = are_rows_ ? line_ : vertex;
  return on_plane(earth_.leaning_vertex_m(column, row, height_m));
}

// As a turn's sign: 1 where the eye is on the side of higher numbers.
double EarthLine::turn(Vec2 from, Vec2 to) const {
  const double left = way_to_left(view_, {from.x, from.y, 0}, {to.x, to.y, 0});
  return next_is_left_ ? left : -left;
}

// A bound on what it is off by, where a place and the way from there are off.
double EarthLine::off_turn(double place_m, double place_off_m, double way_m,
                           double way_off_m) const {
  return view_.is_perspective() ? place_m * way_off_m + place_off_m * (way_m + way_off_m)
                                : (1 + std::abs(view_.x_per_v)) * way_off_m;
}

EarthLine::Depths EarthLine::depths(std::size_t block) const {
  const int first = static_cast<int>(block) * kBlock;
  if (!blocks_.empty()) {
    const Block& of = blocks_[block];
    return {std::min(of.first.y, of.last.y) - of.off_m, std::max(of.first.y, of.last.y) + of.off_m};
  }
  Depths out{kInfinity, -kInfinity};
  for (int i = first; i < std::min(first + kBlock, vertices_); ++i) {
    const double depth_m = place(i).y;
    out = {std::min(out.nearest_m, depth_m), std::max(out.farthest_m, depth_m)};
  }
  return out;
}

// Whether all of a block is on one side of what is looked at, and the eye on one side of it.
bool EarthLine::bound(std::size_t number) {
  Block& block = blocks_[number];
  const int first = static_cast<int>(number) * kBlock, end = end_of(number);
  const double edges = std::max(end - first, 1), angle = along_rad_ * edges;
  constexpr double kUp_m = 1000;
  const double upright = earth_.exaggeration();
  block.first = at_height(first, 0);
  block.last = at_height(end, 0);
  block.slant = plain_length(at_height(first, kUp_m) - block.first) / kUp_m + upright * angle;
  const double places_m = 64 * std::numeric_limits<double>::epsilon() * bend_m_;
  block.off_m = bend_m_ * angle * angle / 8 + block.high_m * block.slant + places_m;
  block.away_m = std::max(plain_length(block.first), plain_length(block.last)) + block.off_m;

  const bool is_perspective = view_.is_perspective();
  std::uint8_t beyond = 0;
  bool is_told = true;
  const auto take = [&](std::uint8_t bit, double at_first, double at_last, double off) {
    if (at_first < -off && at_last < -off)
      beyond |= bit;
    else
      is_told = is_told && at_first > off && at_last > off;
  };
  const auto& [range, from_m] = looked_;
  take(kBehind, block.first.y - from_m, block.last.y - from_m, block.off_m);
  const auto take_side = [&](std::uint8_t bit, double x, double sign) {
    if (std::isinf(x)) return;
    const auto inwards = [&](Vec2 at) {
      return sign * (is_perspective ? at.x - x * at.y : at.x + at.y * view_.x_per_v - x);
    };
    take(bit, inwards(block.first), inwards(block.last),
         block.off_m * (1 + std::abs(is_perspective ? x : view_.x_per_v)));
  };
  take_side(kLeft, range.begin, 1);
  take_side(kRight, range.end, -1);
  if (!is_told) return false;

  const Vec2 edge = (1 / edges) * (block.last - block.first);
  const double edge_off_m = bend_m_ * angle * along_rad_ + block.along_m * block.slant +
                            block.high_m * upright * along_rad_ + places_m;
  const double side = turn(block.first, block.first + edge),
               off = off_turn(block.away_m, block.off_m, plain_length(edge), edge_off_m);
  if (!(std::abs(side) > off) && end > first) return false;
  const auto at = static_cast<std::ptrdiff_t>(first);
  const std::ptrdiff_t vertices = std::min(first + kBlock, vertices_) - first;
  std::fill_n(beyond_.begin() + at, vertices, beyond);
  std::fill_n(sides_.begin() + at, end - first, side > 0 ? kHigh : kLow);
  return true;
}

void EarthLine::judge(std::size_t block) {
  const int first = static_cast<int>(block) * kBlock, end = end_of(block);
  const auto& [range, from_m] = looked_;
  const bool is_perspective = view_.is_perspective();
  Vec2 at = place(first);
  for (int i = first;; ++i) {
    const double aside = is_perspective ? at.x : at.x + at.y * view_.x_per_v,
                 scale = is_perspective ? at.y : 1;
    const bool left = !std::isinf(range.begin) && aside < range.begin * scale,
               right = !std::isinf(range.end) && aside > range.end * scale;
    beyond_[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(
        (at.y <= from_m ? kBehind : 0) | (left ? kLeft : 0) | (right ? kRight : 0));
    if (i == end) break;
    const Vec2 next = place(i + 1);
    const double side = turn(at, next);
    sides_[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>((side > 0 ? kHigh : 0) | (side < 0 ? kLow : 0));
    at = next;
  }
}

void EarthLine::find_falls(const EarthLine& next, int first, int end,
                           std::span<std::uint8_t> falls) const {
  const double upright = earth_.exaggeration();
  for (int begin = first; begin < end;) {
    const auto number = static_cast<std::size_t>(begin / kBlock);
    const int past = std::min(static_cast<int>(number + 1) * kBlock, end);
    bool is_told = false;
    if (!blocks_.empty() && !next.blocks_.empty()) {
      const Block &a = blocks_[number], &b = next.blocks_[number];
      const Vec2 way = b.first - a.first;
      const double angle = along_rad_ * kBlock,
                   way_off_m = bend_m_ * angle * across_rad_ + b.across_m * b.slant +
                               a.high_m * upright * across_rad_ +
                               128 * std::numeric_limits<double>::epsilon() * bend_m_;
      const double at_first = turn(a.first, a.first + way), at_last = turn(a.last, a.last + way),
                   off = off_turn(a.away_m, a.off_m, plain_length(way), way_off_m);
      is_told = (at_first > off && at_last > off) || (at_first < -off && at_last < -off);
      if (is_told) std::fill(falls.begin() + begin, falls.begin() + past, at_first < 0 ? 1 : 0);
    }
    if (!is_told)
      for (int i = begin; i < past; ++i)
        falls[static_cast<std::size_t>(i)] = turn(place(i), next.place(i)) < 0 ? 1 : 0;
    begin = past;
  }
}

} // namespace orograph
