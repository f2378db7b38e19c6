// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/sight_starts.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace orograph {
namespace {

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

bool is_same(const CellHalf& a, const CellHalf& b) {
  return a.column == b.column && a.row == b.row && a.half == b.half;
}
bool is_same(std::uint32_t a, std::uint32_t b) {
  return a == b;
}

} // namespace

template <class Side>
std::span<const Side> SightStarts<Side>::towards(Vec2 direction) const {
  const std::size_t b = bucket_of(turns_of(direction), begin.size() - 1);
  return {sides.data() + begin[b], sides.data() + begin[b + 1]};
}

template <class Side>
bool SightStarts<Side>::is_under_eye(const decltype(Side::triangle)& triangle) const {
  return std::ranges::any_of(under_eye,
                             [&](const auto& other) { return is_same(other, triangle); });
}

template struct SightStarts<GridSide>;
template struct SightStarts<TinSide>;

SightStarts<GridSide> starts_of(const Grid& grid, std::span<const BorderEdge> border,
                                const View& view, double rounding_m) {
  std::vector<GridSide> sides;
  for (const auto& [edge, left] : border) sides.push_back(side_of(grid, edge, left));
  SightStarts<GridSide> starts;
  std::visit(
      [&](const auto& lattice, const auto& heights) {
        const GridMesh mesh{grid, lattice, heights, view};
        add_border(mesh, sides, rounding_m, starts);
        starts.under_eye = triangles_about_eye(mesh, grid, view);
      },
      grid.lattice, grid.heights_m);
  return starts;
}

SightStarts<TinSide> starts_of(const Tin& tin, const View& view, double rounding_m) {
  const TinMesh mesh{tin, view};
  std::vector<TinSide> sides;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t)
    for (std::uint8_t k = 0; k < 3; ++k)
      if (tin.neighbours[t][k] == kNoTriangle) sides.push_back({t, k});
  SightStarts<TinSide> starts;
  add_border(mesh, sides, rounding_m, starts);
  starts.under_eye = triangles_about_eye(mesh, rounding_m);
  return starts;
}

} // namespace orograph
