// SPDX-License-Identifier: GPL-3.0-or-later
// A vertex is *left* or *right* of the plane of a direction, and the plane crosses the edges
// between the two. Of a triangle that it cuts it comes in over the side that has left on its left,
// and goes out over another, into the next triangle; so each walk begins about the eye, or at a
// side of the border, and ends at another one.
#include "profiles/sight_lines.hpp"

#include "dem/extent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// A vertex by its distance along a direction and to the left of it.
struct Post {
  double along, aside, z;
};

// The eye's frame, turned into a direction.
View turned_to(const View& view, Vec2 direction) {
  View out = view;
  out.forward = direction.x * view.right + direction.y * view.forward;
  out.right = {out.forward.y, 0 - out.forward.x};
  const auto& [uu, uv, vv] = view.drop;
  const double c = direction.y, s = direction.x; // u = c u' + s v', v = c v' - s u'
  out.drop = {uu * c * c - uv * s * c + vv * s * s, 2 * (uu - vv) * s * c + uv * (c * c - s * s),
              uu * s * s + uv * s * c + vv * c * c};
  return out;
}

// A grid's vertices in a direction. On a map plane distances grow evenly with columns and rows.
template <class Lattice>
class Posts {
public:
  Posts(const Lattice& lattice, const View& view) : lattice_(lattice), view_(view) {}
  Post at(int column, int row, double height_m) const {
    const Vec3 vertex = lattice_.vertex_m(column, row, height_m);
    const Vec2 from_eye = Vec2{vertex.x, vertex.y} - view_.depth_origin_m;
    const double along = dot(from_eye, view_.forward), right = dot(from_eye, view_.right);
    return {along, 0 - right, vertex.z * view_.exaggeration - view_.drop.at(right, along)};
  }

private:
  const Lattice& lattice_;
  View view_;
};

template <>
class Posts<PlaneLattice> {
public:
  Posts(const PlaneLattice& lattice, const View& view)
      : first_(in_direction(lattice.first_vertex_m - view.depth_origin_m, view)),
        column_(in_direction(lattice.column_step_m, view)),
        row_(in_direction(lattice.row_step_m, view)), exaggeration_(view.exaggeration),
        drop_(view.drop) {}
  Post at(int column, int row, double height_m) const {
    const double along = first_.x + column * column_.x + row * row_.x,
                 aside = first_.y + column * column_.y + row * row_.y;
    return {along, aside, height_m * exaggeration_ - drop_.at(0 - aside, along)};
  }

private:
  static Vec2 in_direction(Vec2 v, const View& view) {
    return {dot(v, view.forward), 0 - dot(v, view.right)};
  }
  Vec2 first_, column_, row_;
  double exaggeration_;
  FrameDrop drop_;
};

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
      : mesh_(mesh), way_(std::move(way)), starts_(starts), distance_m_(distance_m),
        rounding_m_(rounding_m), nearest_m_(4 * rounding_m), eye_z_m_(eye_z_m) {}

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

  SightLine found() const {
    SightLine out;
    out.ground = ground_;
    if (!highest_) return out;
    out.highest = place_of(*highest_);
    out.slope = slope_;
    out.rounding = (out.highest->rounding_m + rounding_m_ * std::abs(slope_)) / highest_->along;
    out.at_border = at_border_;
    return out;
  }

private:
  // Where the plane crosses an edge.
  struct Crossing {
    Post left, right;
    double along, z;
  };

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
      if (reaches(left) || reaches(right) || reaches(ahead)) {
        if (!before_) before_ = crossing(left, right);
      }
      (as_left ? left : right) = ahead;
      way_.go_on(as_left);
      took = false;
      if (meet(left, right, took)) return;
    }
    at_border_ = at_border_ || took;
  }

  // Whether a vertex is as far away as the distance asked for.
  bool reaches(const Post& post) const { return post.along >= distance_m_ - rounding_m_; }

  static Crossing crossing(const Post& left, const Post& right) {
    const double share = std::clamp(left.aside / (left.aside - right.aside), 0.0, 1.0);
    return {left, right, left.along + share * (right.along - left.along),
            left.z + share * (right.z - left.z)};
  }
  // By which share of its edge, at most, rounding may have moved it.
  double off_share(const Crossing& at) const {
    return std::min(rounding_m_ / (at.left.aside - at.right.aside), 1.0);
  }
  double off_m(const Crossing& at) const {
    return rounding_m_ + off_share(at) * std::abs(at.right.along - at.left.along);
  }
  SightPlace place_of(const Crossing& at) const {
    const double slope = std::abs(at.z - eye_z_m_) / std::max(std::abs(at.along), nearest_m_);
    const double moved =
        std::abs(at.right.z - at.left.z) + slope * std::abs(at.right.along - at.left.along);
    return {at.along, at.z,
            off_share(at) * moved +
                8 * kEpsilon * (std::abs(at.left.z) + std::abs(at.right.z) + std::abs(eye_z_m_))};
  }

  bool is_below(const Post& post) const {
    return post.along > nearest_m_ && post.z - eye_z_m_ < slope_ * post.along;
  }

  // Takes what an edge that is crossed adds. Whether the distance is passed.
  bool meet(const Post& left, const Post& right, bool& took) {
    const bool reaching = reaches(left) || reaches(right);
    if (!reaching) {
      before_.reset();
      // On an edge slopes are between those of its ends: most edges need no more.
      if (is_below(left) && is_below(right)) return false;
      if (left.along <= nearest_m_ && right.along <= nearest_m_) return false;
    }
    const Crossing at = crossing(left, right);
    if (at.along > nearest_m_ && at.along < distance_m_) took = take(at) || is_highest(at);
    if (!reaching) return false;
    if (before_) take_ground(*before_, at);
    before_ = at;
    return at.along > distance_m_ + off_m(at);
  }

  bool take(const Crossing& at) {
    const double slope = (at.z - eye_z_m_) / at.along;
    if (!(slope > slope_) && !(slope == slope_ && highest_ && at.along > highest_->along))
      return false;
    // Rounding may as well have it under the eye.
    const double across = at.left.aside - at.right.aside,
                 along = std::abs(at.right.along - at.left.along);
    if (!(at.along * across > 4 * rounding_m_ * (across + along))) return false;
    highest_ = at;
    slope_ = slope;
    at_border_ = false;
    return true;
  }

  // About a vertex in the plane all edges are crossed at that vertex.
  bool is_highest(const Crossing& at) const {
    return highest_ && std::abs(at.along - highest_->along) <= off_m(at) + off_m(*highest_);
  }

  // Of the section from one crossing to the next.
  void take_ground(const Crossing& from, const Crossing& to) {
    if (from.along > distance_m_ + off_m(from) || to.along < distance_m_ - off_m(to)) return;
    const double on = to.along - from.along, rise = to.z - from.z;
    double z = std::max(from.z, to.z); // a wall
    if (on > 2 * rounding_m_)
      z = from.z + std::clamp((distance_m_ - from.along) / on, 0.0, 1.0) * rise;
    if (ground_ && ground_->z_m >= z) return;
    const double steep = std::abs(rise) * std::min(1.0, rounding_m_ / std::max(on, rounding_m_));
    ground_ = SightPlace{distance_m_, z,
                         std::max(place_of(from).rounding_m, place_of(to).rounding_m) + steep};
  }

  const Mesh& mesh_;
  Way way_;
  const SightStarts<Side>& starts_;
  double distance_m_, rounding_m_, nearest_m_, eye_z_m_;
  double limit_m_ = 0; ///< vertices as far to the left as this are left
  bool touches_ = false;
  std::optional<Crossing> before_; ///< the one before, where it is needed
  std::optional<Crossing> highest_;
  double slope_ = -std::numeric_limits<double>::infinity();
  bool at_border_ = false;
  std::optional<SightPlace> ground_;
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
