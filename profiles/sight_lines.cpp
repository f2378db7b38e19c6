// SPDX-License-Identifier: GPL-3.0-or-later
// A vertex is *left* or *right* of the plane of a direction, and the plane crosses the edges
// between the two. Of a triangle that it cuts it comes in over the side that has left on its left,
// and goes out over another, into the next triangle; so each walk begins about the eye, or at a
// side of the border, and ends at another one.
#include "profiles/sight_lines.hpp"

#include "dem/extent.hpp"
#include "profiles/sight_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// The way through a mesh in a direction: from a side, by its left and its right end, over the
// triangle ahead to the next side.

template <class Lattice, class Height>
class GridWay {
public:
  using Side = GridSide;
  using Mesh = GridMesh<Lattice, Height>;

  GridWay(const Mesh& mesh, const View& view)
      : mesh_(mesh), heights_(mesh.heights), posts_(mesh.lattice, view),
        columns_(static_cast<unsigned>(mesh.grid.columns)),
        rows_(static_cast<unsigned>(mesh.grid.rows)) {}

  Post post(const Side& side, std::size_t n) const {
    const auto [column, row] = mesh_.corner(side.triangle, (side.k + n) % 3);
    return posts_.at(column, row, height(column, row));
  }
  void begin(const Side& side) {
    left_ = mesh_.corner(side.triangle, (side.k + 1U) % 3);
    const auto [column, row] = mesh_.corner(side.triangle, (side.k + 2U) % 3);
    for (right_ = 0; right_ < 6; ++right_)
      if (left_.column + kRound[right_][0] == column && left_.row + kRound[right_][1] == row) break;
  }
  /// The third corner of the triangle ahead; false where there is none.
  bool ahead(Post& post) {
    ahead_ = right_ == 0 ? 5 : right_ - 1;
    at_ = {left_.column + kRound[ahead_][0], left_.row + kRound[ahead_][1]};
    if (static_cast<unsigned>(at_.column) >= columns_ || static_cast<unsigned>(at_.row) >= rows_)
      return false;
    const double height_m = height(at_.column, at_.row);
    if (std::isnan(height_m)) return false;
    post = posts_.at(at_.column, at_.row, height_m);
    return true;
  }
  /// Goes on, the corner ahead being the next side's left end, or its right one.
  void go_on(bool as_left) {
    if (as_left) {
      left_ = at_;
      right_ = right_ == 5 ? 0 : right_ + 1;
    } else {
      right_ = ahead_;
    }
  }

private:
  // Vertices round a vertex, clockwise from the east: each with the next and the middle one makes a
  // triangle, and from each to the next it is as far as from the middle to the one after.
  static constexpr int kRound[6][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}};

  double height(int column, int row) const {
    return static_cast<double>(
        heights_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)]);
  }

  const Mesh& mesh_;
  const Heights<Height>& heights_;
  Posts<Lattice> posts_;
  unsigned columns_, rows_;
  CellVertex left_{}, at_{};
  unsigned right_ = 0, ahead_ = 0; ///< where they are, round the left one
};

class TinWay {
public:
  using Side = TinSide;

  TinWay(const TinMesh& mesh, const View& view) : mesh_(mesh), view_(view) {}

  Post post(const Side& side, std::size_t n) const {
    const std::uint32_t i = mesh_.index(side.triangle, (side.k + n) % 3);
    const ProfilePoint p = to_profile_frame(view_, mesh_.tin.vertices_m[i]);
    return {p.v, 0 - p.u, p.z};
  }
  void begin(const Side& side) { side_ = side; }
  bool ahead(Post& out) const {
    if (side_) out = post(*side_, 0);
    return side_.has_value();
  }
  void go_on(bool as_left) {
    side_->k = static_cast<std::uint8_t>((side_->k + (as_left ? 1 : 2)) % 3);
    side_ = mesh_.across(*side_);
  }

private:
  const TinMesh& mesh_;
  View view_;
  std::optional<Side> side_; ///< of the triangle ahead
};

template <class Lattice, class Height>
GridWay<Lattice, Height> way_through(const GridMesh<Lattice, Height>& mesh, const View& view) {
  return {mesh, view};
}
TinWay way_through(const TinMesh& mesh, const View& view) {
  return {mesh, view};
}

// One direction. Whether a vertex in the plane itself, to rounding, counts as left decides on which
// side of an edge along it the walk goes.
template <class Mesh, class Way>
class Look {
public:
  using Side = typename Mesh::Side;

  Look(const Mesh& mesh, Way way, const SightStarts<Side>& starts, double distance_m,
       double rounding_m, double eye_z_m)
      : mesh_(mesh), way_(std::move(way)), starts_(starts), rounding_m_(rounding_m),
        met_(distance_m, rounding_m, eye_z_m) {}

  /// Whether a vertex is in the plane: then the other side is to be looked at as well.
  bool along(std::span<const Side> border, bool plane_is_left) {
    limit_m_ = plane_is_left ? -rounding_m_ : rounding_m_;
    touches_ = false;
    for (const auto& triangle : starts_.under_eye) {
      for (std::uint8_t k = 0; k < 3; ++k) {
        const Side side{triangle, k};
        if (!comes_in(side)) continue;
        const auto before = mesh_.across(side);
        if (!before || !starts_.is_under_eye(before->triangle)) walk(side);
      }
    }
    for (const Side& side : border)
      if (comes_in(side) && !starts_.is_under_eye(side.triangle)) walk(side);
    return touches_;
  }

  SightLine found() const { return met_.found(at_border_); }

private:
  bool is_left(const Post& post) {
    touches_ = touches_ || std::abs(post.aside) <= rounding_m_;
    return post.aside >= limit_m_;
  }
  bool comes_in(const Side& side) {
    const bool from = is_left(way_.post(side, 1)), to = is_left(way_.post(side, 2));
    return from && !to;
  }

  void walk(const Side& side) {
    Post left = way_.post(side, 1), right = way_.post(side, 2), ahead{};
    way_.begin(side);
    before_.reset();
    bool took = false; // whether the highest place is on the last edge
    if (meet(left, right, took)) return;
    while (way_.ahead(ahead)) {
      const bool as_left = is_left(ahead);
      if (met_.reaches(left) || met_.reaches(right) || met_.reaches(ahead)) {
        if (!before_) before_ = SightCrossing::of(left, right);
      }
      (as_left ? left : right) = ahead;
      way_.go_on(as_left);
      took = false;
      if (meet(left, right, took)) return;
    }
    at_border_ = at_border_ || took;
  }

  // Takes what an edge that is crossed adds. Whether the distance is passed.
  bool meet(const Post& left, const Post& right, bool& took) {
    const bool reaching = met_.reaches(left) || met_.reaches(right);
    if (!reaching) {
      before_.reset();
      if (met_.adds_nothing(left, right)) return false;
    }
    const SightCrossing at = SightCrossing::of(left, right);
    if (met_.is_between(at)) {
      const bool is_new = met_.take(at);
      if (is_new) at_border_ = false;
      took = is_new || met_.is_highest(at);
    }
    if (!reaching) return false;
    if (before_) met_.take_ground(*before_, at);
    before_ = at;
    return met_.is_past(at);
  }

  const Mesh& mesh_;
  Way way_;
  const SightStarts<Side>& starts_;
  double rounding_m_;
  double limit_m_ = 0; ///< vertices as far to the left as this are left
  bool touches_ = false;
  std::optional<SightCrossing> before_; ///< the one before, where it is needed
  SightCrossings met_;
  bool at_border_ = false;
};

} // namespace

// Calls take(mesh).
template <class Take>
auto SightLines::with_mesh(const Take& take) const {
  if (const Tin* tin = std::get_if<Tin>(&surface_)) return take(TinMesh{*tin, view_});
  const Grid& grid = std::get<Grid>(surface_);
  return std::visit(
      [&](const auto& lattice, const auto& heights) {
        return take(GridMesh{grid, lattice, heights, view_});
      },
      grid.lattice, grid.heights_m);
}

SightLines::SightLines(const Surface& surface, std::span<const BorderEdge> border, const View& view)
    : surface_(surface), view_(view) {
  const Grid* grid = std::get_if<Grid>(&surface);
  const double reach = reach_m(surface) + length(view.depth_origin_m);
  rounding_m_ = 16 * kEpsilon * reach;
  if (grid && grid->is_on_earth()) rounding_m_ = std::max(rounding_m_, 1e-8); // LocalFrame's places
  if (grid)
    starts_ = starts_of(*grid, border, view_, rounding_m_);
  else
    starts_ = starts_of(std::get<Tin>(surface), view_, rounding_m_);
}

SightLine SightLines::up_to(Vec2 direction, double distance_m) const {
  return with_mesh([&]<class Mesh>(const Mesh& mesh) {
    const auto& starts = std::get<SightStarts<typename Mesh::Side>>(starts_);
    const std::span border = starts.towards(direction);
    auto way = way_through(mesh, turned_to(view_, direction));
    Look<Mesh, decltype(way)> look(mesh, std::move(way), starts, distance_m, rounding_m_,
                                   view_.eye_z_m);
    if (look.along(border, true)) look.along(border, false);
    return look.found();
  });
}

} // namespace orograph
