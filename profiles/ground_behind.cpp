// SPDX-License-Identifier: GPL-3.0-or-later
// From triangle to triangle along the ground line of a ray. A vertex is on the ray's left or on its
// right; the ray leaves a triangle over the edge between the two.
#include "profiles/ground_behind.hpp"

#include "profiles/slab_lines.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>

namespace orograph {
namespace {

struct Corner {
  std::uint32_t index;
  ProfilePoint at;
};

// Steps over a grid. The two triangles at any edge make a parallelogram, so the vertex beyond it is
// left + right - (the vertex on this side).
template <class Height>
class GridSteps {
public:
  GridSteps(const Grid& grid, const std::vector<Height>& heights, const View& view)
      : grid_(grid), heights_(heights), view_(view) {}

  // Onto the edge from `left` to `right`, with what is beyond it ahead.
  void begin(std::uint32_t left, std::uint32_t right) {
    left_ = place(left);
    right_ = place(right);
    const Place d{right_.column - left_.column, right_.row - left_.row};
    // Counterclockwise seen from above, the triangle on the left of an edge has its third vertex a
    // turn to the left: the edge turned by half a cell's angle.
    const bool down = d.column + d.row > 0; // away from vertex (0, 0)
    const Place turn = d.column != 0 && d.row != 0 ? (down ? Place{1, 0} : Place{-1, 0})
                       : d.row == 0                ? (down ? Place{0, -1} : Place{0, 1})
                                                   : (down ? Place{1, 1} : Place{-1, -1});
    ahead_ = {left_.column + turn.column, left_.row + turn.row};
    if (!grid_.is_on_earth() && grid_.plane().is_mirrored()) // rows run the other way
      ahead_ = {left_.column + right_.column - ahead_.column, left_.row + right_.row - ahead_.row};
  }
  std::optional<Corner> ahead() const {
    for (const Place& p : {left_, right_, ahead_})
      if (p.column < 0 || p.row < 0 || p.column >= grid_.columns || p.row >= grid_.rows ||
          std::isnan(heights_[grid_.index(p.column, p.row)]))
        return std::nullopt;
    const std::size_t index = grid_.index(ahead_.column, ahead_.row);
    return Corner{static_cast<std::uint32_t>(index),
                  to_profile_frame(view_, grid_.vertex_m(ahead_.column, ahead_.row))};
  }
  void leave_on_left() { leave(right_); }
  void leave_on_right() { leave(left_); }

private:
  struct Place {
    int column, row;
  };
  Place place(std::uint32_t index) const {
    const auto columns = static_cast<std::uint32_t>(grid_.columns);
    return {static_cast<int>(index % columns), static_cast<int>(index / columns)};
  }
  // Over the edge to the vertex ahead, which takes the place of `passed`.
  void leave(Place& passed) {
    const Place behind = passed;
    passed = ahead_;
    ahead_ = {left_.column + right_.column - behind.column, left_.row + right_.row - behind.row};
  }

  const Grid& grid_;
  const std::vector<Height>& heights_;
  const View& view_;
  Place left_{}, right_{}, ahead_{};
};

// Steps over a TIN.
class TinSteps {
public:
  TinSteps(const Tin& tin, const View& view, const std::vector<std::uint32_t>& begin,
           const std::vector<std::uint32_t>& triangles)
      : tin_(tin), view_(view), begin_(begin), triangles_(triangles) {}

  void begin(std::uint32_t left, std::uint32_t right) {
    triangle_ = kNoTriangle;
    for (std::uint32_t i = begin_[left]; i < begin_[left + 1]; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& corners = tin_.triangles[triangles_[i]];
        if (corners[(k + 1) % 3] != left || corners[(k + 2) % 3] != right) continue;
        triangle_ = triangles_[i];
        apex_ = k;
      }
  }
  std::optional<Corner> ahead() const {
    if (triangle_ == kNoTriangle) return std::nullopt;
    const std::uint32_t index = tin_.triangles[triangle_][apex_];
    return Corner{index, to_profile_frame(view_, tin_.vertices_m[index])};
  }
  void leave_on_left() { leave((apex_ + 2) % 3); }
  void leave_on_right() { leave((apex_ + 1) % 3); }

private:
  // Over the side opposite to corner k.
  void leave(std::size_t k) {
    const std::uint32_t next = tin_.neighbours[triangle_][k];
    if (next != kNoTriangle) {
      const auto& back = tin_.neighbours[next];
      apex_ =
          static_cast<std::size_t>(std::find(back.begin(), back.end(), triangle_) - back.begin());
    }
    triangle_ = next;
  }

  const Tin& tin_;
  const View& view_;
  const std::vector<std::uint32_t>&begin_, &triangles_;
  std::uint32_t triangle_ = kNoTriangle;
  std::size_t apex_ = 0;
};

template <class Steps>
bool rises(Steps steps, const View& view, const ProfileLine& line, SurfaceEdge edge,
           ProfilePoint from, double reach_m) {
  // How far to the right of the ray a point is, in some measure.
  const auto right_of_ray = [&](ProfilePoint p) {
    return view.is_perspective() ? p.u * from.v - from.u * p.v
                                 : (p.u - from.u) + view.x_per_v * (p.v - from.v);
  };
  // Along the ray Y stays what it is.
  const double z_per_m = z_along_ray(view, from);
  Corner left{edge.from, line.from}, right{edge.to, line.to};
  if (right_of_ray(left.at) > right_of_ray(right.at)) std::swap(left, right);
  steps.begin(left.index, right.index);
  std::array<std::uint32_t, 3> met{};
  std::size_t passed = 0;
  while (const std::optional<Corner> ahead = steps.ahead()) {
    // Round in a circle, around a vertex by rounding or where cliffs on the ellipsoid lean over,
    // and perhaps not from the first step on: what was passed before will be again.
    const std::array present{left.index, right.index, ahead->index};
    if (present == met) return false;
    if (std::has_single_bit(++passed)) met = present;
    // Of three corners one or two are on the right.
    const bool to_the_left = right_of_ray(ahead->at) > 0;
    (to_the_left ? right : left) = *ahead;
    // As every point on an edge, from the vertex of lower index.
    const bool left_first = left.index < right.index;
    const ProfilePoint a = (left_first ? left : right).at, b = (left_first ? right : left).at;
    const double side_a = right_of_ray(a), side_b = right_of_ray(b);
    const double share = side_a == side_b ? 0.5 : std::clamp(side_a / (side_a - side_b), 0.0, 1.0);
    const ProfilePoint p = point_between(a, b, share);
    const double distance = p.v - from.v;
    if (distance > reach_m) return false;
    // The silhouette's own edge is in reach of rounding: a thousandth of an edge is not behind it.
    const double least_m = 1e-3 * std::max(std::abs(b.u - a.u), std::abs(b.v - a.v));
    if (distance > least_m && p.z >= from.z + distance * z_per_m) return true;
    if (to_the_left)
      steps.leave_on_left();
    else
      steps.leave_on_right();
  }
  return false;
}

} // namespace

GroundBehind::GroundBehind(const Surface& surface, const View& view)
    : surface_(surface), view_(view) {
  const Tin* tin = std::get_if<Tin>(&surface);
  if (!tin) return;
  begin_.assign(tin->vertices_m.size() + 1, 0);
  for (const auto& triangle : tin->triangles)
    for (const std::uint32_t vertex : triangle) ++begin_[vertex + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  triangles_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t t = 0; t < tin->triangles.size(); ++t)
    for (const std::uint32_t vertex : tin->triangles[t]) triangles_[next[vertex]++] = t;
}

bool GroundBehind::rises_within(SurfaceEdge edge, ProfilePoint from, double reach_m) const {
  const ProfileLine line = line_of(surface_, view_, edge);
  if (const Tin* tin = std::get_if<Tin>(&surface_))
    return rises(TinSteps(*tin, view_, begin_, triangles_), view_, line, edge, from, reach_m);
  const Grid& grid = std::get<Grid>(surface_);
  return std::visit(
      [&](const auto& heights) {
        return rises(GridSteps(grid, heights, view_), view_, line, edge, from, reach_m);
      },
      grid.heights_m);
}

} // namespace orograph
