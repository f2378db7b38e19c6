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
};

// Of count + 1 heights; no differences of the last one along the line. Loops for the vector units.
HeightSpread spread_of(const float* heights, const float* beside, int count) {
  constexpr int kLanes = 8;
  std::array<float, kLanes> highest{}, along{}, across{};
  const auto take = [&](int i, std::size_t k, float next) {
    const auto raise = [&](std::array<float, kLanes>& most, float value) {
      value = std::abs(value);
      most[k] = value > most[k] ? value : most[k];
    };
    const float h = heights[i];
    raise(highest, h);
    raise(along, next - h);
    raise(across, h - beside[i]);
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
  }
  return out;
}

bool are_there(std::span<const float> heights) {
  std::uint32_t missing = 0;
  for (const float h : heights) missing |= h == h ? 0U : 1U;
  return missing == 0;
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
  places_m_ = 64 * std::numeric_limits<double>::epsilon() * bend_m_;
  const auto count = static_cast<std::size_t>(vertices_);
  heights_.resize(count);
  beyond_.resize(count);
  sides_.resize(count - 1);
  blocks_.resize((count + kBlock - 1) / kBlock);
}

void EarthLine::read(int line, const EarthLine& before) {
  line_ = line;
  std::visit([&](const auto& heights) { take_heights(heights); }, grid_.heights_m);
  filled_m_.clear();
  missing_.clear();
  if (earth_.lean_limits() || !are_there(heights_)) fill();
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const auto first = i * kBlock;
    const int count = end_of(i) - static_cast<int>(first);
    const HeightSpread heights = spread_of(&heights_[first], &before.heights_[first], count);
    // Floats are rounded, and so are their differences.
    const double rounding_m = 1e-6 * heights.highest;
    Block& block = blocks_[i];
    block.high_m = heights.highest + rounding_m;
    block.across_m = heights.across + rounding_m;
    bound(i, heights.along + rounding_m);
    if (!is_told(i)) judge(i);
  }
}

template <class Height>
void EarthLine::take_heights(const Heights<Height>& heights) {
  const std::size_t step = are_rows_ ? 1 : static_cast<std::size_t>(grid_.columns);
  const Height* const from =
      heights.data() + (are_rows_ ? grid_.index(0, line_) : grid_.index(line_, 0));
  float* const to = heights_.data();
  for (std::size_t i = 0; i < heights_.size(); ++i) to[i] = static_cast<float>(from[i * step]);
}

// A vertex is where its lean takes it, and what is filled is as high as its neighbour leans.
void EarthLine::fill() {
  filled_m_.resize(heights_.size());
  for (int i = 0; i < vertices_; ++i) {
    const int column = are_rows_ ? i : line_, row = are_rows_ ? line_ : i;
    filled_m_[static_cast<std::size_t>(i)] =
        earth_.leaning_height_m(column, row, grid_.height_m(column, row));
  }
  const auto is_missing = [](double height) { return std::isnan(height); };
  const auto first = std::ranges::find_if_not(filled_m_, is_missing);
  double last = first == filled_m_.end() ? 0 : *first;
  if (std::ranges::any_of(filled_m_, is_missing)) missing_.assign(heights_.size(), 0);
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    if (is_missing(filled_m_[i])) missing_[i] = 1;
    last = filled_m_[i] = is_missing(filled_m_[i]) ? last : filled_m_[i];
    heights_[i] = static_cast<float>(last);
  }
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
  const Block& of = blocks_[block];
  return {std::min(of.first.y, of.last.y) - of.off_m, std::max(of.first.y, of.last.y) + of.off_m};
}

// Of heights on it that differ by so much from one to the next.
void EarthLine::bound(std::size_t number, double along_m) {
  Block& block = blocks_[number];
  const int first = static_cast<int>(number) * kBlock, end = end_of(number);
  const double edges = std::max(end - first, 1), angle = along_rad_ * edges;
  constexpr double kUp_m = 1000;
  const double upright = earth_.exaggeration();
  block.first = at_height(first, 0);
  block.last = at_height(end, 0);
  block.edge = (1 / edges) * (block.last - block.first);
  block.slant = plain_length(at_height(first, kUp_m) - block.first) / kUp_m + upright * angle;
  block.off_m = bend_m_ * angle * angle / 8 + block.high_m * block.slant + places_m_;
  block.away_m = std::max(plain_length(block.first), plain_length(block.last)) + block.off_m;
  block.edge_off_m = bend_m_ * angle * along_rad_ + along_m * block.slant +
                     block.high_m * upright * along_rad_ + places_m_;
}

// Whether all of a block is on one side of what is looked at, and the eye on one side of it; then
// that is noted.
bool EarthLine::is_told(std::size_t number) {
  const Block& block = blocks_[number];
  const int first = static_cast<int>(number) * kBlock, end = end_of(number);
  const bool is_perspective = view_.is_perspective();
  std::uint8_t beyond = 0;
  bool is_sure = true;
  const auto take = [&](std::uint8_t bit, double at_first, double at_last, double off) {
    if (at_first < -off && at_last < -off)
      beyond |= bit;
    else
      is_sure = is_sure && at_first > off && at_last > off;
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
  if (!is_sure) return false;

  const double side = turn(block.first, block.first + block.edge),
               off =
                   off_turn(block.away_m, block.off_m, plain_length(block.edge), block.edge_off_m);
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

// The way to the same vertex of the next line, at a block's first vertex; and what it is off at
// others.
EarthLine::Way EarthLine::way_to(const EarthLine& next, std::size_t block) const {
  const Block &a = blocks_[block], &b = next.blocks_[block];
  return {b.first - a.first, bend_m_ * along_rad_ * kBlock * across_rad_ + b.across_m * b.slant +
                                 a.high_m * earth_.exaggeration() * across_rad_ + 2 * places_m_};
}

void EarthLine::find_falls(const EarthLine& next, int first, int end,
                           std::span<std::uint8_t> falls) const {
  for (int begin = first; begin < end;) {
    const auto number = static_cast<std::size_t>(begin / kBlock);
    const int past = std::min(static_cast<int>(number + 1) * kBlock, end);
    const Block& a = blocks_[number];
    const auto [way, way_off_m] = way_to(next, number);
    const double at_first = turn(a.first, a.first + way), at_last = turn(a.last, a.last + way),
                 off = off_turn(a.away_m, a.off_m, plain_length(way), way_off_m);
    if ((at_first > off && at_last > off) || (at_first < -off && at_last < -off))
      std::fill(falls.begin() + begin, falls.begin() + past, at_first < 0 ? 1 : 0);
    else
      for (int i = begin; i < past; ++i)
        falls[static_cast<std::size_t>(i)] = turn(place(i), next.place(i)) < 0 ? 1 : 0;
    begin = past;
  }
}

bool EarthLine::are_apart(const EarthLine& next, int first, int end) const {
  if (missing_.empty() && next.missing_.empty()) return true;
  const double sign = next_is_left_ ? 1 : -1;
  for (int begin = first; begin < end;) {
    const auto number = static_cast<std::size_t>(begin / kBlock);
    const int past = std::min(static_cast<int>(number + 1) * kBlock, end);
    const auto [way, way_off_m] = way_to(next, number);
    // A triangle is as large as an edge of one of the lines times a way between them.
    bool are_told = true;
    for (const EarthLine* line : {this, &next}) {
      const Block& of = line->blocks_[number];
      const double off =
          of.edge_off_m * (plain_length(way) + way_off_m) + plain_length(of.edge) * way_off_m;
      are_told = are_told && sign * cross(of.edge, way) > off;
    }
    for (int i = begin; i < past && !are_told; ++i) {
      if (!is_missing(i) && !is_missing(i + 1) && !next.is_missing(i) && !next.is_missing(i + 1))
        continue;
      const Vec2 at = place(i), aslant = next.place(i + 1) - at;
      if (!(sign * cross(place(i + 1) - at, aslant) > 0) ||
          !(sign * cross(aslant, next.place(i) - at) > 0))
        return false;
    }
    begin = past;
  }
  return true;
}

} // namespace orograph
