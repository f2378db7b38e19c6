// SPDX-License-Identifier: GPL-3.0-or-later
// A vertex is *left* or *right* of the plane of a direction, and the plane crosses the edges
// between the two. Of a triangle that it cuts it comes in over the side that has left on its left,
// and goes out over another, into the next triangle; so each walk begins about the eye, or at a
// side of the border, and ends at another one.
#include "profiles/sight_lines.hpp"

#include "dem/extent.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orograph {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kTurn = 2 * std::numbers::pi;

Vec2 on_ground(ProfilePoint p) {
  return {p.u, p.v};
}

std::size_t bucket_of(double turns, std::size_t count) {
  const double bucket = (turns - std::floor(turns)) * static_cast<double>(count);
  return std::min(static_cast<std::size_t>(bucket), count - 1);
}
double turns_of(Vec2 direction) {
  return std::atan2(direction.y, direction.x) / kTurn;
}

// Where a side is seen from the eye, in turns; all round where the eye is on it, or nearly.
struct Turns {
  double begin, end;
};
Turns turns_of(Vec2 a, Vec2 b, double rounding_m) {
  const Vec2 along = b - a;
  const double squared = dot(along, along);
  const double share = squared > 0 ? std::clamp(-dot(a, along) / squared, 0.0, 1.0) : 0;
  const double nearest_m = length(a + share * along);
  if (!(nearest_m > 1e3 * rounding_m)) return {0, 1};
  const double from = turns_of(a), by = std::remainder(turns_of(b) - from, 1);
  const double beside = 1e-12 + rounding_m / nearest_m;
  return {std::min(from, from + by) - beside, std::max(from, from + by) + beside};
}

template <class Side>
void lay_buckets(const std::vector<Side>& border, const std::vector<Turns>& turns,
                 SightStarts<Side>& out) {
  constexpr std::size_t kMostBuckets = 65536;
  const std::size_t count = std::clamp<std::size_t>(border.size(), 1, kMostBuckets);
  const auto for_each_bucket = [&](const Turns& range, const auto& take) {
    const std::size_t first = bucket_of(range.begin, count), last = bucket_of(range.end, count);
    const bool all = range.end - range.begin >= 1;
    const std::size_t buckets = all ? count : (last + count - first) % count + 1;
    for (std::size_t i = 0; i < buckets; ++i) take((first + i) % count);
  };
  out.begin.assign(count + 1, 0);
  for (const Turns& range : turns)
    for_each_bucket(range, [&](std::size_t b) { ++out.begin[b + 1]; });
  for (std::size_t b = 0; b < count; ++b) out.begin[b + 1] += out.begin[b];
  out.sides.resize(out.begin.back());
  std::vector<std::uint32_t> next(out.begin.begin(), out.begin.end() - 1);
  for (std::size_t i = 0; i < border.size(); ++i)
    for_each_bucket(turns[i], [&](std::size_t b) { out.sides[next[b]++] = border[i]; });
}

template <class Mesh, class Side>
ProfilePoint corner(const Mesh& mesh, const Side& side, std::size_t n) {
  return mesh.vertex(side.triangle, (side.k + n) % 3).at;
}

// Sides with ground beyond them, as the eye sees them, or along its look.
template <class Mesh, class Side>
void add_border(const Mesh& mesh, const std::vector<Side>& border, double rounding_m,
                SightStarts<Side>& out) {
  std::vector<Side> sides;
  std::vector<Turns> turns;
  for (std::size_t i = 0; i < border.size(); ++i) {
    throw_if_stopped(i);
    const Vec2 a = on_ground(corner(mesh, border[i], 1)), b = on_ground(corner(mesh, border[i], 2));
    if (cross(a, b) > 2 * rounding_m * (length(a) + length(b))) continue;
    sides.push_back(border[i]);
    turns.push_back(turns_of(a, b, rounding_m));
  }
  lay_buckets(sides, turns, out);
}

// Column and row of the place below the eye.
Vec2 column_row_below(const Grid& grid, const View& view) {
  const Vec2 at = view.depth_origin_m;
  if (grid.is_on_earth()) return grid.earth().column_row_at({at.x, at.y, 0});
  const PlaneLattice& plane = grid.plane();
  const Vec2 from_first = at - plane.first_vertex_m;
  const double area = cross(plane.column_step_m, plane.row_step_m);
  return {cross(from_first, plane.row_step_m) / area,
          cross(plane.column_step_m, from_first) / area};
}

// Those of the eye's cell and the cells around it: its place is known to a rounding.
template <class Mesh>
std::vector<CellHalf> triangles_about_eye(const Mesh& mesh, const Grid& grid, const View& view) {
  std::vector<CellHalf> out;
  const Vec2 at = column_row_below(grid, view);
  if (!(at.x > -2 && at.y > -2 && at.x < grid.columns + 1 && at.y < grid.rows + 1)) return out;
  const int column = static_cast<int>(std::floor(at.x)), row = static_cast<int>(std::floor(at.y));
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows - 2); ++r)
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, grid.columns - 2); ++c)
      for (const Half half : {Half::lower, Half::upper}) {
        double sum = 0; // NaN where a corner is missing
        for (std::size_t k = 0; k < 3; ++k) sum += mesh.vertex({c, r, half}, k).at.z;
        if (!std::isnan(sum)) out.push_back({c, r, half});
      }
  return out;
}

// Those that hold the place below the eye, their edges included.
std::vector<std::uint32_t> triangles_about_eye(const TinMesh& mesh, double rounding_m) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t t = 0; t < mesh.tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    bool holds = true;
    for (std::size_t k = 0; k < 3 && holds; ++k) {
      const Vec2 a = on_ground(mesh.vertex(t, k).at), b = on_ground(mesh.vertex(t, (k + 1) % 3).at);
      holds = cross(a, b) >= -2 * rounding_m * (length(a) + length(b));
    }
    if (holds) out.push_back(t);
  }
  return out;
}

bool is_among(const std::vector<CellHalf>& triangles, const CellHalf& wanted) {
  return std::ranges::any_of(triangles, [&](const CellHalf& t) {
    return t.column == wanted.column && t.row == wanted.row && t.half == wanted.half;
  });
}
bool is_among(const std::vector<std::uint32_t>& triangles, std::uint32_t wanted) {
  return std::ranges::find(triangles, wanted) != triangles.end();
}

// One direction. Whether a vertex in the plane itself, to rounding, counts as left decides on which
// side of an edge along it the walk goes.
template <class Mesh>
class Look {
public:
  using Side = typename Mesh::Side;

  Look(const Mesh& mesh, const SightStarts<Side>& starts, Vec2 direction, double distance_m,
       double rounding_m, double eye_z_m, Sight& found)
      : mesh_(mesh), starts_(starts), direction_(direction), distance_m_(distance_m),
        rounding_m_(rounding_m), nearest_m_(4 * rounding_m), eye_z_m_(eye_z_m), found_(found) {}

  /// Whether a vertex is in the plane: then the other side is to be looked at as well.
  bool along(bool plane_is_left) {
    limit_m_ = plane_is_left ? -rounding_m_ : rounding_m_;
    touches_ = false;
    for (const auto& triangle : starts_.under_eye) {
      for (std::uint8_t k = 0; k < 3; ++k) {
        const Side side{triangle, k};
        if (!comes_in(side)) continue;
        const auto before = mesh_.across(side);
        if (!before || !is_among(starts_.under_eye, before->triangle)) walk(side);
      }
    }
    for (const Side& side : starts_.towards(direction_))
      if (comes_in(side) && !is_among(starts_.under_eye, side.triangle)) walk(side);
    return touches_;
  }

private:
  // A vertex by its distance along the direction and to the left of it.
  struct Post {
    double along, aside, z;
  };

  Post post(const Side& side, std::size_t n) {
    const ProfilePoint p = corner(mesh_, side, n);
    const Post out{direction_.x * p.u + direction_.y * p.v, direction_.x * p.v - direction_.y * p.u,
                   p.z};
    touches_ = touches_ || std::abs(out.aside) <= rounding_m_;
    return out;
  }
  bool is_left(const Post& post) const { return post.aside >= limit_m_; }
  bool comes_in(const Side& side) { return is_left(post(side, 1)) && !is_left(post(side, 2)); }

  void walk(Side side) {
    Post left = post(side, 1), right = post(side, 2);
    before_.reset();
    if (meet(left, right)) return;
    for (;;) {
      const Post ahead = post(side, 0), was_left = left, was_right = right;
      const bool goes_right = is_left(ahead);
      (goes_right ? left : right) = ahead;
      side.k = static_cast<std::uint8_t>((side.k + (goes_right ? 1 : 2)) % 3);
      if (!before_ && reaches(left, right)) before_ = crossing(was_left, was_right);
      if (meet(left, right)) return;
      const auto next = mesh_.across(side);
      if (!next) {
        found_.at_border = found_.at_border || took_;
        return;
      }
      side = *next;
    }
  }

  // Whether an edge may be as far away as the distance asked for.
  bool reaches(const Post& left, const Post& right) const {
    return std::max(left.along, right.along) >= distance_m_ - rounding_m_;
  }

  // With a bound on the rounding of its distance.
  struct Crossing : SightPlace {
    double off_m;
  };
  Crossing crossing(const Post& left, const Post& right) const {
    const double between = left.aside - right.aside;
    const double share = std::clamp(left.aside / between, 0.0, 1.0);
    const double rise = right.z - left.z, on = right.along - left.along;
    const double distance_m = left.along + share * on, z_m = left.z + share * rise;
    // By such a share it may be elsewhere on the edge.
    const double off = std::min(rounding_m_ / between, 1.0);
    const double slope = std::abs(z_m - eye_z_m_) / std::max(std::abs(distance_m), nearest_m_);
    const double rounding =
        off * (std::abs(rise) + slope * std::abs(on)) +
        8 * kEpsilon * (std::abs(left.z) + std::abs(right.z) + std::abs(eye_z_m_));
    return {{distance_m, z_m, rounding}, rounding_m_ + off * std::abs(on)};
  }

  // Takes what an edge that is crossed adds. Whether the distance is passed.
  bool meet(const Post& left, const Post& right) {
    took_ = false;
    const bool reaching = reaches(left, right);
    if (!reaching) {
      // On an edge slopes are between those of its ends: most edges need no more.
      before_.reset();
      const bool left_ahead = left.along > nearest_m_, right_ahead = right.along > nearest_m_;
      if (!left_ahead && !right_ahead) return false;
      if (left_ahead && right_ahead && left.z - eye_z_m_ < found_.slope * left.along &&
          right.z - eye_z_m_ < found_.slope * right.along)
        return false;
    }
    const Crossing at = crossing(left, right);
    if (at.distance_m > nearest_m_ && at.distance_m < distance_m_) take(at);
    if (!reaching) return false;
    if (before_) take_ground(*before_, at);
    before_ = at;
    return at.distance_m > distance_m_ + at.off_m;
  }

  void take(const SightPlace& at) {
    const double slope = (at.z_m - eye_z_m_) / at.distance_m;
    if (found_.highest && !(slope > found_.slope) &&
        !(slope == found_.slope && at.distance_m > found_.highest->distance_m))
      return;
    took_ = true;
    found_.at_border = false;
    found_.highest = at;
    found_.slope = slope;
    found_.rounding = (at.rounding_m + rounding_m_ * std::abs(slope)) / at.distance_m;
  }

  // Of the section from one crossing to the next.
  void take_ground(const Crossing& from, const Crossing& to) {
    if (from.distance_m > distance_m_ + from.off_m || to.distance_m < distance_m_ - to.off_m)
      return;
    const double on = to.distance_m - from.distance_m, rise = to.z_m - from.z_m;
    const auto z_at = [&](double share) { return from.z_m + share * rise; };
    double z = std::max(from.z_m, to.z_m); // a wall
    if (on > 2 * rounding_m_) z = z_at(std::clamp((distance_m_ - from.distance_m) / on, 0.0, 1.0));
    if (found_.ground && found_.ground->z_m >= z) return;
    const double steep = std::abs(rise) * std::min(1.0, rounding_m_ / std::max(on, rounding_m_));
    found_.ground = SightPlace{distance_m_, z, std::max(from.rounding_m, to.rounding_m) + steep};
  }

  const Mesh& mesh_;
  const SightStarts<Side>& starts_;
  Vec2 direction_;
  double distance_m_, rounding_m_, nearest_m_, eye_z_m_;
  Sight& found_;
  double limit_m_ = 0; ///< vertices no farther to the right than this, or to the left, are left
  bool touches_ = false;
  bool took_ = false;              ///< whether the last edge is the highest
  std::optional<Crossing> before_; ///< the crossing before, where it is needed
};

} // namespace

template <class Side>
std::span<const Side> SightStarts<Side>::towards(Vec2 direction) const {
  const std::size_t b = bucket_of(turns_of(direction), begin.size() - 1);
  return {sides.data() + begin[b], sides.data() + begin[b + 1]};
}

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
  if (grid) {
    std::vector<GridSide> sides;
    for (const auto& [edge, left] : border) sides.push_back(side_of(*grid, edge, left));
    SightStarts<GridSide> starts;
    std::visit(
        [&](const auto& lattice, const auto& heights) {
          const GridMesh mesh{*grid, lattice, heights, view_};
          add_border(mesh, sides, rounding_m_, starts);
          starts.under_eye = triangles_about_eye(mesh, *grid, view_);
        },
        grid->lattice, grid->heights_m);
    starts_ = std::move(starts);
    return;
  }
  const Tin& tin = std::get<Tin>(surface);
  const TinMesh mesh{tin, view_};
  std::vector<TinSide> sides;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
    for (std::uint8_t k = 0; k < 3; ++k)
      if (tin.neighbours[t][k] == kNoTriangle) sides.push_back({t, k});
  SightStarts<TinSide> starts;
  add_border(mesh, sides, rounding_m_, starts);
  starts.under_eye = triangles_about_eye(mesh, rounding_m_);
  starts_ = std::move(starts);
}

Sight SightLines::up_to(Vec2 direction, double distance_m) const {
  Sight found;
  with_mesh([&]<class Mesh>(const Mesh& mesh) {
    const auto& starts = std::get<SightStarts<typename Mesh::Side>>(starts_);
    Look<Mesh> look(mesh, starts, direction, distance_m, rounding_m_, view_.eye_z_m, found);
    if (look.along(true)) look.along(false);
  });
  return found;
}

} // namespace orograph
