// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/limit_lean.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace orograph {
namespace {

struct LatticeVertex {
  int row, column;
  auto operator<=>(const LatticeVertex&) const = default;
};
using CornersOfTriangle = std::array<LatticeVertex, 3>;

constexpr double kMostShift = 0.25; // of a triangle's shortest side: 14 degrees

// Counterclockwise on a lattice whose columns run east and rows south.
CornersOfTriangle corners(int column, int row, bool is_upper) {
  const LatticeVertex nw{row, column}, se{row + 1, column + 1};
  return is_upper ? CornersOfTriangle{nw, se, {row, column + 1}}
                  : CornersOfTriangle{nw, {row + 1, column}, se};
}

// Which way a triangle turns: 1, -1, or 0 where it can't be told from an upright one.
int turn_of(Vec2 a, Vec2 b, Vec2 c) {
  constexpr double kRounding = 1e-12;
  const Vec2 u = b - a, w = c - a;
  const double one = u.x * w.y, other = u.y * w.x,
               rounding = kRounding * (std::abs(one) + std::abs(other));
  return one - other > rounding ? 1 : one - other < -rounding ? -1 : 0;
}

// How a triangle lies whose corners lean by these heights.
enum class Lie { upright, shifted, turned_over };

// Shifted: a corner leans too far beside another for the side between them to have its direction,
// which the order of a lattice's strips needs.
Lie lie_of(const EarthLattice& earth, const CornersOfTriangle& corners,
           const std::array<double, 3>& heights_m) {
  const double common_m = (heights_m[0] + heights_m[1] + heights_m[2]) / 3;
  std::array<Vec2, 3> at, level;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [row, column] = corners[k];
    const Vec3 leaning = earth.vertex_m(column, row, heights_m[k]),
               on_level = earth.vertex_m(column, row, common_m);
    at[k] = {leaning.x, leaning.y};
    level[k] = {on_level.x, on_level.y};
  }
  // Comparisons with NaN are false.
  if (turn_of(at[0], at[1], at[2]) < 0) return Lie::turned_over;
  double shortest_m2 = std::numeric_limits<double>::infinity(), farthest_m2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Vec2 edge = level[next] - level[k], shift = at[next] - level[next] - (at[k] - level[k]);
    shortest_m2 = std::min(shortest_m2, dot(edge, edge));
    farthest_m2 = std::max(farthest_m2, dot(shift, shift));
  }
  return farthest_m2 > kMostShift * kMostShift * shortest_m2 ? Lie::shifted : Lie::upright;
}

// How far aside a metre of height takes a vertex at most, how far up at least, and the shortest
// side of a cell.
struct Bounds {
  double tilt = 0, up = 1, side_m = 0;
};
Bounds bounds_of(const EarthLattice& earth) {
  const int columns = earth.degrees().columns, rows = earth.degrees().rows;
  Bounds out{0, 1, std::numeric_limits<double>::infinity()};
  const auto flat = [](Vec3 at) { return Vec2{at.x, at.y}; };
  const auto take = [&](int column, int row) {
    const Vec3 at = earth.vertex_m(column, row, 0);
    const Vec3 higher = earth.vertex_m(column, row, 1 / earth.exaggeration());
    out.tilt = std::max(out.tilt, length(flat(higher) - flat(at)));
    out.up = std::min(out.up, higher.z - at.z);
    for (const auto& [right, down] : {std::pair{1, 0}, std::pair{0, 1}})
      if (column + right < columns && row + down < rows)
        out.side_m = std::min(
            out.side_m, length(flat(earth.vertex_m(column + right, row + down, 0)) - flat(at)));
  };
  // All are greatest, or least, at the border, or else on the origin's meridian, to less than the
  // share that is left of them.
  for (int column = 0; column < columns; ++column)
    for (const int row : {0, rows - 2, rows - 1}) take(column, std::max(row, 0));
  for (int row = 0; row < rows; ++row)
    for (const int column : {0, columns - 2, columns - 1}) take(std::max(column, 0), row);
  return out;
}

// Whether the two shorter sides of each triangle, at one height and seen from above, have about a
// right angle, between 70 and 110 degrees: within 45 degrees of the origin they do, but for what
// rounding makes of cells beside a pole, or below a millimetre.
bool has_right_angles(const DegreeLattice& degrees, const Bounds& bounds) {
  constexpr double kCosine45 = 0.707, kLeast_m = 1e-3, kMost_deg = 89;
  return bounds.up > kCosine45 && bounds.side_m > kLeast_m &&
         std::abs(degrees.lon_step_deg) * degrees.columns < 180 &&
         std::max(std::abs(degrees.lat_deg(0)), std::abs(degrees.lat_deg(degrees.rows - 1))) <
             kMost_deg;
}

// Triangles that are turned over or shifted, where neighbours differ enough that any may be.
template <class Height>
class SteepTriangles {
public:
  SteepTriangles(const Grid& grid, const Heights<Height>& heights)
      : grid_(grid), heights_(heights) {
    constexpr double kShare = 0.1;
    const Bounds bounds = bounds_of(grid.earth());
    has_right_angles_ = has_right_angles(grid.earth().degrees(), bounds);
    steep_ = kShare * bounds.side_m / (bounds.tilt * std::abs(grid.earth().exaggeration()));
  }

  struct Found {
    std::vector<CornersOfTriangle> triangles;
    std::size_t turned_over = 0;
    bool none_is_turned = false; ///< for certain
  };
  Found found() const {
    const int tasks = (grid_.rows - 1 + kRowsOfTask - 1) / kRowsOfTask;
    std::vector<Found> by_task(static_cast<std::size_t>(tasks));
    on_all_cores(by_task.size(), [&](std::size_t task) {
      throw_if_stopped();
      const int first = static_cast<int>(task) * kRowsOfTask;
      for (int row = first; row < std::min(first + kRowsOfTask, grid_.rows - 1); ++row)
        for (int column = 0; column < grid_.columns - 1; column += kBlock) {
          const int end = std::min(column + kBlock, grid_.columns - 1);
          if (are_steep(row, column, end)) find(row, column, end, by_task[task]);
        }
    });
    Found out;
    for (const Found& of : by_task) {
      out.triangles.insert(out.triangles.end(), of.triangles.begin(), of.triangles.end());
      out.turned_over += of.turned_over;
    }
    // Corners that lean a quarter of the shorter side beside each other turn that side and the next
    // by 15 degrees each.
    out.none_is_turned = has_right_angles_ && out.triangles.empty();
    return out;
  }

private:
  static constexpr int kRowsOfTask = 64, kBlock = 64;

  // Whether a side of a cell may be shifted by a tenth of the shortest, so that a diagonal may be
  // by a fifth.
  bool are_steep(int row, int first, int end) const {
    const Height* const a = &heights_[grid_.index(first, row)];
    const Height* const b = a + grid_.columns;
    const auto steep = static_cast<Height>(steep_);
    unsigned any = std::abs(b[0] - a[0]) > steep ? 1 : 0; // comparisons with NaN are false
    for (int i = 0; i < end - first; ++i)
      any |= static_cast<unsigned>(std::abs(a[i + 1] - a[i]) > steep) |
             static_cast<unsigned>(std::abs(b[i + 1] - b[i]) > steep) |
             static_cast<unsigned>(std::abs(b[i + 1] - a[i + 1]) > steep);
    return any != 0;
  }

  void find(int row, int first, int end, Found& out) const {
    for (int column = first; column < end; ++column)
      for (const bool is_upper : {false, true}) {
        const CornersOfTriangle triangle = corners(column, row, is_upper);
        std::array<double, 3> heights_m;
        for (std::size_t k = 0; k < 3; ++k)
          heights_m[k] = heights_[grid_.index(triangle[k].column, triangle[k].row)];
        const auto [low_m, high_m] = std::ranges::minmax(heights_m);
        if (!(high_m - low_m > steep_)) continue;
        const Lie lie = lie_of(grid_.earth(), triangle, heights_m);
        if (lie != Lie::upright) out.triangles.push_back(triangle);
        out.turned_over += lie == Lie::turned_over ? 1 : 0;
      }
  }

  const Grid& grid_;
  const Heights<Height>& heights_;
  double steep_; ///< between neighbours
  bool has_right_angles_;
};

// Of each of these triangles the vertex that is most out of its surroundings is limited to their
// height, until none is left; where all three are, larger surroundings count.
class Limiting {
public:
  explicit Limiting(const Grid& grid) : grid_(grid) {}

  LeanLimits limits(std::vector<CornersOfTriangle> steep, std::size_t turned_over) {
    while (!steep.empty()) {
      throw_if_stopped();
      std::vector<LatticeVertex> wider;
      for (const CornersOfTriangle& triangle : steep) add_of(triangle, wider);
      std::ranges::sort(wider);
      wider.erase(std::ranges::unique(wider).begin(), wider.end());
      for (const LatticeVertex& vertex : wider) widen(vertex);
      steep = steep_at(wider);
    }
    std::vector<std::vector<LeanLimit>> rows(static_cast<std::size_t>(grid_.rows));
    for (const auto& [vertex, limit] : limited_)
      rows[static_cast<std::size_t>(vertex.row)].push_back(
          {vertex.column, limit.height_m, height_m(vertex) > limit.height_m});
    return {std::move(rows), turned_over};
  }

private:
  static constexpr int kNarrow = 3, kWide = 24; // cells to each side
  struct Limit {
    int around; // cells; beyond kWide all there are
    double height_m;
  };

  double height_m(LatticeVertex v) const { return grid_.height_m(v.column, v.row); }
  double leaning_m(LatticeVertex v) const {
    const auto limit = limited_.find(v);
    return limit == limited_.end() ? height_m(v) : limit->second.height_m;
  }

  void add_of(const CornersOfTriangle& triangle, std::vector<LatticeVertex>& out) const {
    const LatticeVertex* farthest = nullptr;
    double away_m = -1;
    for (const LatticeVertex& v : triangle) {
      if (limited_.contains(v)) continue;
      const double here_m = std::abs(height_m(v) - middle_m(v, kNarrow));
      if (here_m <= away_m) continue;
      away_m = here_m;
      farthest = &v;
    }
    if (farthest)
      out.push_back(*farthest);
    else
      std::ranges::copy_if(triangle, std::back_inserter(out),
                           [&](const LatticeVertex& v) { return limited_.at(v).around <= kWide; });
  }

  void widen(LatticeVertex v) {
    const auto known = limited_.find(v);
    const int around = known == limited_.end() ? kNarrow : 2 * known->second.around;
    limited_[v] = {around, around <= kWide ? middle_m(v, around) : mean_m()};
  }

  // The median of the heights around a vertex.
  double middle_m(LatticeVertex v, int around) const {
    std::vector<double> heights;
    for (int row = std::max(v.row - around, 0); row <= std::min(v.row + around, grid_.rows - 1);
         ++row)
      for (int column = std::max(v.column - around, 0);
           column <= std::min(v.column + around, grid_.columns - 1); ++column)
        if (const double height = grid_.height_m(column, row); !std::isnan(height))
          heights.push_back(height);
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::ranges::nth_element(heights, middle);
    return *middle;
  }

  double mean_m() {
    if (!std::isnan(mean_m_)) return mean_m_;
    double sum = 0, count = 0;
    for (int row = 0; row < grid_.rows; ++row)
      for (int column = 0; column < grid_.columns; ++column)
        if (const double height = grid_.height_m(column, row); !std::isnan(height)) {
          sum += height;
          ++count;
        }
    return mean_m_ = sum / count;
  }

  // Of the triangles that vertices are of.
  std::vector<CornersOfTriangle> steep_at(const std::vector<LatticeVertex>& vertices) const {
    std::vector<CornersOfTriangle> out;
    for (const LatticeVertex& v : vertices)
      for (int row = std::max(v.row - 1, 0); row <= std::min(v.row, grid_.rows - 2); ++row)
        for (int column = std::max(v.column - 1, 0);
             column <= std::min(v.column, grid_.columns - 2); ++column)
          for (const bool is_upper : {false, true}) {
            const CornersOfTriangle t = corners(column, row, is_upper);
            if (std::ranges::find(t, v) == t.end()) continue;
            const std::array<double, 3> heights_m{leaning_m(t[0]), leaning_m(t[1]),
                                                  leaning_m(t[2])};
            if (lie_of(grid_.earth(), t, heights_m) == Lie::upright) continue;
            // Of one that isn't right when all its heights are one nothing can be had.
            if (std::ranges::any_of(t, [&](const LatticeVertex& corner) {
                  const auto limit = limited_.find(corner);
                  return limit == limited_.end() || limit->second.around <= kWide;
                }))
              out.push_back(t);
          }
    std::ranges::sort(out);
    out.erase(std::ranges::unique(out).begin(), out.end());
    return out;
  }

  const Grid& grid_;
  std::map<LatticeVertex, Limit> limited_;
  double mean_m_ = std::numeric_limits<double>::quiet_NaN();
};

} // namespace

void limit_lean(Grid& grid) {
  EarthLattice& earth = std::get<EarthLattice>(grid.lattice);
  const DegreeLattice& degrees = earth.degrees();
  // Mirrored lattices, which no reader makes, have no triangle that isn't turned over.
  if ((degrees.lon_step_deg > 0) == (degrees.lat_step_deg > 0)) return;
  std::visit(
      [&](const auto& heights) {
        auto [steep, turned_over, none_is_turned] = SteepTriangles(grid, heights).found();
        if (turned_over > 0) earth.limit_lean(Limiting(grid).limits(std::move(steep), turned_over));
        if (none_is_turned) earth.set_upright();
      },
      grid.heights_m);
}

} // namespace orograph
