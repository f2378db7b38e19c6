// SPDX-License-Identifier: GPL-3.0-or-later
// Why no edge is missed that stands as high as `from_slope`. The plane of a direction meets an edge
// between its ends, so at a distance, aside and at a height that are between those of vertices of
// its block, whose own edges belong to it. A block's box holds them all, and `top_m` is no lower
// than any of them as drawn. If no part of the box is as near the plane as the slack, the plane
// crosses none of its edges; and if its top, at that end of the box at which it is seen the
// steepest, is below `from_slope`, so is each crossing. The slack is some 64 times what a vertex's
// place is rounded by, and a bound of a slope is compared with a slope as it is rounded, so that
// what is left out is below by more than any rounding. Blocks about the distance itself are always
// looked into. What is looked into adds what the walk adds: the same edges, by the same arithmetic.
#include "profiles/sight_over_blocks.hpp"

#include "dem/extent.hpp"
#include "geometry/box.hpp"
#include "profiles/sight_crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

namespace orograph {
namespace {

constexpr int kCells = SeenGround::kSide, kGroup = BlockBounds::kGroup;
constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kSlack = 64; // roundings
// A block takes as long as a walk over so many cells.
constexpr double kBlocksAtLeast = 8, kCellsABlock = 32;

// A block, and the greatest slope of what is in it in a direction.
struct OpenBlock {
  double slope;
  std::uint32_t number;
};

// Adds what the triangles of blocks add to a look.
template <class Lattice, class Height>
class Blocks {
public:
  Blocks(const Grid& grid, const Lattice& lattice, const Heights<Height>& heights,
         const View& turned, double rounding_m)
      : grid_(grid), heights_(heights), posts_(lattice, turned), rounding_m_(rounding_m) {}

  void look_into(std::uint32_t block, SightCrossings& met) {
    const int across = SeenGround::blocks_in(grid_.columns - 1);
    const int column = static_cast<int>(block) % across * kCells,
              row = static_cast<int>(block) / across * kCells;
    const int columns = std::min(kCells, grid_.columns - 1 - column),
              rows = std::min(kCells, grid_.rows - 1 - row);
    for (int r = 0; r <= rows; ++r)
      for (int c = 0; c <= columns; ++c) place(column + c, row + r, at(c, r));
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) {
        const Vertex &north_west = at(c, r), &south_west = at(c, r + 1),
                     &south_east = at(c + 1, r + 1), &north_east = at(c + 1, r);
        look_into({&north_west, &south_west, &south_east}, met);
        look_into({&north_west, &south_east, &north_east}, met);
      }
  }

private:
  // On which side a vertex is: that of one in the plane itself, to rounding, is left for the one
  // look and right for the other.
  enum : std::uint8_t { is_right = 1, is_either = 2, is_left = 4, is_missing = 8 };
  struct Vertex {
    Post post;
    std::uint8_t side;
  };
  using Triangle = std::array<const Vertex*, 3>; // counter-clockwise

  Vertex& at(int column, int row) {
    return vertices_[static_cast<std::size_t>(row * (kCells + 1) + column)];
  }
  void place(int column, int row, Vertex& out) const {
    const double height_m = static_cast<double>(heights_[grid_.index(column, row)]);
    out.side = is_missing;
    if (std::isnan(height_m)) return;
    out.post = posts_.at(column, row, height_m);
    out.side = out.post.aside >= rounding_m_    ? is_left
               : out.post.aside >= -rounding_m_ ? is_either
                                                : is_right;
  }

  void look_into(const Triangle& triangle, SightCrossings& met) const {
    const int sides = triangle[0]->side | triangle[1]->side | triangle[2]->side;
    if (sides == is_left || sides == is_right || (sides & is_missing) != 0) return;
    look_across(triangle, is_left | is_either, met);
    if ((sides & is_either) != 0) look_across(triangle, is_left, met);
  }
  // In over the side that has left on its left, and out over the other.
  void look_across(const Triangle& triangle, int left, SightCrossings& met) const {
    const auto is_on_left = [&](std::size_t k) { return (triangle[k % 3]->side & left) != 0; };
    std::size_t in = 0;
    while (in < 3 && !(is_on_left(in) && !is_on_left(in + 1))) ++in;
    if (in == 3) return;
    const Post &in_left = triangle[in]->post, &in_right = triangle[(in + 1) % 3]->post,
               &third = triangle[(in + 2) % 3]->post;
    const bool third_is_left = is_on_left(in + 2);
    const Post &out_left = third_is_left ? third : in_left,
               &out_right = third_is_left ? in_right : third;
    const bool reaching = met.reaches(in_left) || met.reaches(in_right) || met.reaches(third);
    meet(in_left, in_right, reaching, met);
    meet(out_left, out_right, reaching, met);
    if (met.reaches(out_left) || met.reaches(out_right))
      met.take_ground(SightCrossing::of(in_left, in_right), SightCrossing::of(out_left, out_right));
  }
  static void meet(const Post& left, const Post& right, bool reaching, SightCrossings& met) {
    if (!reaching && met.adds_nothing(left, right)) return;
    const SightCrossing at = SightCrossing::of(left, right);
    if (met.is_between(at)) met.take(at);
  }

  const Grid& grid_;
  const Heights<Height>& heights_;
  Posts<Lattice> posts_;
  double rounding_m_;
  std::array<Vertex, static_cast<std::size_t>((kCells + 1) * (kCells + 1))> vertices_;
};

} // namespace

// Of a box, from the eye.
double SightOverBlocks::nearest_m(const Held& held) {
  return plain_length(Vec2{std::max(std::abs(held.middle.x) - held.half.x, 0.0),
                           std::max(std::abs(held.middle.y) - held.half.y, 0.0)});
}
double SightOverBlocks::farthest_m(const Held& held) {
  return plain_length(
      Vec2{std::abs(held.middle.x) + held.half.x, std::abs(held.middle.y) + held.half.y});
}

SightOverBlocks::SightOverBlocks(const Grid& grid, const BlockBounds& bounds, const View& view,
                                 double rounding_m)
    : grid_(grid), bounds_(bounds), view_(view), rounding_m_(rounding_m),
      slack_m_(kSlack * rounding_m), cell_m_(cell_size_m(grid)) {
  const auto& [uu, uv, vv] = view.drop;
  least_drop_ = 0.5 * (uu + vv - std::hypot(uu - vv, uv));
  for (std::uint32_t i = 0; i < bounds.groups.count(); ++i)
    if (const auto held = held_by(i, bounds.groups, kGroup * kCells))
      groups_.push_back(
          {*held, i, greatest_slope(held->top_m, nearest_m(*held), farthest_m(*held))});
  std::ranges::sort(groups_, [](const Group& a, const Group& b) {
    return std::pair(-a.slope, a.number) < std::pair(-b.slope, b.number);
  });
}

// Of ground no higher than `top_m`, between two distances.
double SightOverBlocks::greatest_slope(double top_m, double nearest_m, double farthest_m) const {
  const double rise_m = top_m - view_.eye_z_m;
  const double at_m = rise_m > 0 ? nearest_m - slack_m_ : farthest_m + slack_m_;
  return at_m > 0 ? rise_m / at_m : rise_m > 0 ? kEndless : -kEndless;
}

// A lower bound of how far a box's ground sinks: the form is least along one of its axes.
double SightOverBlocks::least_drop_m(const Held& held) const {
  if (!view_.drop.any()) return 0;
  const double away_m = least_drop_ > 0 ? nearest_m(held) : farthest_m(held);
  return least_drop_ * away_m * away_m;
}

// None: no ground.
std::optional<SightOverBlocks::Held>
SightOverBlocks::held_by(std::uint32_t number, const BoundsOfBlocks& of, int cells) const {
  Box2 plan;
  double height = 0;
  if (grid_.is_on_earth()) {
    const Box3& box = of.boxes_m[number];
    if (box.empty()) return std::nullopt;
    plan = {{box.low.x, box.low.y}, {box.high.x, box.high.y}};
    height = box.high.z;
  } else {
    height = of.heights[number];
    if (!(height > -kEndless)) return std::nullopt;
    const int block = static_cast<int>(number);
    const int c0 = block % of.columns * cells, r0 = block / of.columns * cells,
              c1 = std::min(c0 + cells, grid_.columns - 1),
              r1 = std::min(r0 + cells, grid_.rows - 1);
    for (const int c : {c0, c1})
      for (const int r : {r0, r1}) plan.include(grid_.plane().position_m(c, r));
  }
  Held out;
  out.middle = plan.centre() - view_.depth_origin_m;
  out.half = 0.5 * (plan.high - plan.low);
  const double z_m = height * view_.exaggeration, drop_m = least_drop_m(out);
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  out.top_m = z_m - drop_m + slack_m_ +
              kSlack * kEpsilon * (std::abs(z_m) + std::abs(drop_m) + std::abs(view_.eye_z_m));
  return out;
}

std::optional<SightLine> SightOverBlocks::up_to(Vec2 direction, double distance_m,
                                                double from_slope) const {
  const View turned = turned_to(view_, direction);
  const Vec2 place_m = distance_m * turned.forward;
  // An edge along the plane counts as crossed at both ends, and its block is as long at least.
  const auto is_about_place = [&](const Held& held) {
    return std::abs(place_m.x - held.middle.x) <= 3 * held.half.x + slack_m_ &&
           std::abs(place_m.y - held.middle.y) <= 3 * held.half.y + slack_m_;
  };
  // Of what the plane meets of a box, up to the distance; none where that is nothing, or too low.
  const auto slope_in = [&](const Held& held) -> std::optional<double> {
    if (is_about_place(held)) return kEndless;
    double begin_m = 0 - slack_m_, end_m = distance_m + slack_m_;
    for (const auto& [way, middle, half] :
         {std::array{turned.forward.x, held.middle.x, held.half.x + slack_m_},
          std::array{turned.forward.y, held.middle.y, held.half.y + slack_m_}}) {
      const double one_m = (middle - half) / way, other_m = (middle + half) / way;
      if (way == 0) {
        if (std::abs(middle) > half) return std::nullopt;
      } else {
        begin_m = std::max(begin_m, std::min(one_m, other_m));
        end_m = std::min(end_m, std::max(one_m, other_m));
      }
    }
    if (begin_m > end_m) return std::nullopt;
    const double slope = greatest_slope(held.top_m, begin_m, end_m);
    return slope < from_slope ? std::nullopt : std::optional(slope);
  };

  std::vector<OpenBlock> open;
  const auto open_blocks_of = [&](std::uint32_t group) {
    const int number = static_cast<int>(group);
    const int first_column = number % bounds_.groups.columns * kGroup,
              first_row = number / bounds_.groups.columns * kGroup,
              end_column = std::min(first_column + kGroup, bounds_.blocks.columns),
              end_row = std::min(first_row + kGroup, SeenGround::blocks_in(grid_.rows - 1));
    for (int row = first_row; row < end_row; ++row)
      for (int column = first_column; column < end_column; ++column) {
        const auto block = static_cast<std::uint32_t>(row * bounds_.blocks.columns + column);
        const auto held = held_by(block, bounds_.blocks, kCells);
        if (const auto slope = held ? slope_in(*held) : std::nullopt)
          open.push_back({*slope, block});
      }
  };
  // A walk takes less time than so many blocks.
  const double most = kBlocksAtLeast + distance_m / (kCellsABlock * cell_m_);
  for (const Group& group : groups_) {
    if (group.slope < from_slope ? is_about_place(group.held) : slope_in(group.held).has_value())
      open_blocks_of(group.number);
    if (static_cast<double>(open.size()) > most) return std::nullopt;
  }

  // The steepest first, so that others needn't be looked into.
  std::ranges::sort(open, [](const OpenBlock& a, const OpenBlock& b) {
    return std::pair(-a.slope, a.number) < std::pair(-b.slope, b.number);
  });
  SightCrossings met(distance_m, rounding_m_, view_.eye_z_m);
  std::visit(
      [&](const auto& lattice, const auto& heights) {
        Blocks blocks(grid_, lattice, heights, turned, rounding_m_);
        for (const OpenBlock& block : open)
          if (!(block.slope < met.slope())) blocks.look_into(block.number, met);
      },
      grid_.lattice, grid_.heights_m);
  return met.found(false);
}

} // namespace orograph
