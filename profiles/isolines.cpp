// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/isolines.hpp"

#include "geometry/for_each_marked.hpp"
#include "geometry/on_all_cores.hpp"
#include "profiles/surface_edges.hpp"
#include "profiles/triangle_isolines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace orograph {
namespace {

// Those along edges may be there twice, once for each triangle.
void add_once(std::vector<Isoline>& along_edges, std::vector<Isoline>& lines) {
  std::size_t steps = 0;
  std::sort(along_edges.begin(), along_edges.end(), [&](const Isoline& a, const Isoline& b) {
    throw_if_stopped(++steps);
    return a.ends() != b.ends() ? a.ends() < b.ends() : a.triangle < b.triangle;
  });
  const auto last =
      std::unique(along_edges.begin(), along_edges.end(),
                  [](const Isoline& a, const Isoline& b) { return a.ends() == b.ends(); });
  lines.insert(lines.end(), along_edges.begin(), last);
}

// Some rows of a grid's vertices, with the cells behind them. Points are numbered row by row: those
// along a row of vertices, then those between it and the next; so the first row beyond goes on
// where the last one ends, and its numbers are known here too.
class GridRows {
public:
  GridRows(const Grid& grid, const VertexValues& values, const IsolineLevels& levels,
           const IsolineGround& ground)
      : grid_(grid), values_(values), levels_(levels), ground_(ground),
        width_(static_cast<std::size_t>(grid.columns)),
        vertices_(static_cast<std::uint32_t>(grid.size())) {}

  std::vector<EdgePoint> points;
  /// Points are numbered from the count of vertices on, and here from this object's first.
  std::vector<Isoline> lines, along_edges;

  void find(int first_row, int end_row) {
    Row row, below;
    std::vector<std::uint8_t> cells_above;
    read_cells(first_row - 1, cells_above);
    read(first_row, row);
    number_along(row, cells_above, first_row, true, along_);
    for (int r = first_row; r < end_row && r + 1 < grid_.rows; ++r) {
      throw_if_stopped();
      read(r + 1, below);
      number_between(row, below, r);
      number_along(below, row.cells, r + 1, r + 1 < end_row, along_below_);
      add_lines(row, below, r);
      std::swap(row, below);
      std::swap(along_, along_below_);
    }
  }

private:
  struct Row {
    std::vector<double> values;
    std::vector<std::int32_t> levels;   // as `LevelStanding` has them; nowhere behind the last
    std::vector<std::uint8_t> is_level; // that the last of those is the value
    // Behind it, from number 1 on: whether each is asked for. Before and behind them there is none.
    std::vector<std::uint8_t> cells;
  };

  void read_cells(int row, std::vector<std::uint8_t>& cells) const {
    cells.assign(width_ + 1, 0);
    if (row < 0 || row + 1 >= grid_.rows) return;
    if (!ground_.seen) {
      std::fill(cells.begin() + 1, cells.end() - 1, std::uint8_t{1});
      return;
    }
    std::vector<std::pair<int, int>> ranges;
    ground_.seen->cells_in_row(row / SeenGround::kSide, grid_.columns - 1, ranges);
    for (const auto& [first, end] : ranges)
      std::fill(cells.begin() + 1 + first, cells.begin() + 1 + end, std::uint8_t{1});
  }
  void read(int row, Row& out) {
    read_cells(row, out.cells);
    out.values.resize(width_);
    out.levels.assign(width_ + 1, LevelStanding::kNowhere);
    out.is_level.assign(width_, 0);
    values_(grid_.index(0, row), out.values);
    levels_.count_most(out.values, std::span(out.levels).first(width_), near_level_);
    for (const std::uint32_t column : near_level_) {
      const LevelStanding standing = levels_.standing_of(out.values[column]);
      out.levels[column] = standing.levels;
      out.is_level[column] = standing.on_level ? 1 : 0;
    }
  }
  IsolineEnd end(const Row& row, int r, std::size_t column) const {
    return {static_cast<std::uint32_t>(grid_.index(static_cast<int>(column), r)),
            {row.values[column], row.levels[column], row.is_level[column] != 0}};
  }
  std::uint32_t next_point() const { return vertices_ + static_cast<std::uint32_t>(points.size()); }

  // Calls take(c) with the columns that are marked, of which there are few: by a loop over all
  // that the compiler turns into vector instructions.
  template <class Mark, class Take>
  void for_each_column(std::size_t count, const Mark& mark, const Take& take) {
    marks_.resize(width_);
    std::uint8_t* const marks = marks_.data();
    const int columns = static_cast<int>(count);
    for (int c = 0; c < columns; ++c) marks[c] = mark(c);
    for_each_marked(marks_, 0, columns, kDown | kDiagonal,
                    [&](int c) { take(static_cast<std::size_t>(c)); });
  }

  // By column the number of the first point on the edge to the next one, if it has any. `stored`:
  // here, and not with the rows beyond.
  void number_along(const Row& row, const std::vector<std::uint8_t>& cells_above, int r,
                    bool stored, std::vector<std::uint32_t>& first) {
    first.resize(width_);
    std::uint32_t next = next_point();
    const std::int32_t* const levels = row.levels.data();
    const std::uint8_t *const cells = row.cells.data(), *const above = cells_above.data();
    for_each_column(
        width_ - 1,
        [=](int c) -> std::uint8_t {
          return levels[c] != levels[c + 1] ? cells[c + 1] | above[c + 1] : 0;
        },
        [&](std::size_t c) {
          const IsolineEnd a = end(row, r, c), b = end(row, r, c + 1);
          first[c] = next;
          next += crossed_within(a.standing, b.standing).count();
          if (stored) add_edge_points(a, b, levels_, points);
        });
  }
  void number_between(const Row& row, const Row& below, int r) {
    down_.resize(width_);
    diagonal_.resize(width_);
    const std::int32_t *const levels = row.levels.data(), *const under = below.levels.data();
    const std::uint8_t* const cells = row.cells.data();
    for_each_column(
        width_,
        [=](int c) -> std::uint8_t {
          const int down = levels[c] != under[c] ? cells[c] | cells[c + 1] : 0,
                    diagonal = levels[c] != under[c + 1] ? cells[c + 1] : 0;
          return static_cast<std::uint8_t>(down * kDown | diagonal * kDiagonal);
        },
        [&](std::size_t c) {
          down_[c] = next_point();
          if (marks_[c] & kDown)
            add_edge_points(end(row, r, c), end(below, r + 1, c), levels_, points);
          diagonal_[c] = next_point();
          if (marks_[c] & kDiagonal)
            add_edge_points(end(row, r, c), end(below, r + 1, c + 1), levels_, points);
        });
  }

  void add_lines(const Row& row, const Row& below, int r) {
    const auto take = [&](const Isoline& line) {
      (line.to < vertices_ ? along_edges : lines).push_back(line);
    };
    const std::int32_t *const levels = row.levels.data(), *const under = below.levels.data();
    const std::uint8_t* const cells = row.cells.data();
    for_each_column(
        width_ - 1,
        [=](int c) -> std::uint8_t {
          const std::int32_t level = levels[c];
          const std::int32_t crossed =
              (level ^ levels[c + 1]) | (level ^ under[c]) | (level ^ under[c + 1]);
          return crossed != 0 ? cells[c + 1] : 0;
        },
        [&](std::size_t c) {
          const IsolineEnd nw = end(row, r, c), ne = end(row, r, c + 1), sw = end(below, r + 1, c),
                           se = end(below, r + 1, c + 1);
          const auto triangle = [&](Half half) {
            return grid_triangle(grid_, static_cast<int>(c), r, half);
          };
          const std::size_t lower = triangle(Half::lower), upper = triangle(Half::upper);
          if (!ground_.triangles || ground_.triangles->has(lower))
            for_each_isoline({{nw, sw, se}, {along_below_[c], diagonal_[c], down_[c]}}, lower,
                             take);
          if (!ground_.triangles || ground_.triangles->has(upper))
            for_each_isoline({{nw, ne, se}, {down_[c + 1], diagonal_[c], along_[c]}}, upper, take);
        });
  }

  static constexpr std::uint8_t kDown = 1, kDiagonal = 2;
  const Grid& grid_;
  const VertexValues& values_;
  const IsolineLevels& levels_;
  const IsolineGround& ground_;
  std::size_t width_;
  std::uint32_t vertices_;
  // By column the number of the first point on an edge that has any: along the present row and the
  // one below, and from the one to the other.
  std::vector<std::uint32_t> along_, along_below_, down_, diagonal_;
  std::vector<std::uint8_t> marks_;       // columns
  std::vector<std::uint32_t> near_level_; // columns that may be on a level
};

// What was found with points numbered from 0 on goes behind what there is.
void append(const GridRows& found, std::uint32_t vertices, Isolines& out,
            std::vector<Isoline>& along_edges) {
  const auto before = static_cast<std::uint32_t>(out.points.size());
  out.points.insert(out.points.end(), found.points.begin(), found.points.end());
  for (Isoline line : found.lines) {
    throw_if_stopped(out.lines.size());
    for (std::uint32_t* end : {&line.from, &line.to})
      if (*end >= vertices) *end += before;
    out.lines.push_back(line);
  }
  along_edges.insert(along_edges.end(), found.along_edges.begin(), found.along_edges.end());
}

Isolines of_grid(const Grid& grid, const VertexValues& values, const IsolineLevels& levels,
                 const IsolineGround& ground) {
  constexpr int kRowsOfTask = 64;
  std::vector<GridRows> rows(static_cast<std::size_t>((grid.rows + kRowsOfTask - 1) / kRowsOfTask),
                             GridRows(grid, values, levels, ground));
  on_all_cores(rows.size(), [&](std::size_t task) {
    const int first = static_cast<int>(task) * kRowsOfTask;
    rows[task].find(first, std::min(first + kRowsOfTask, grid.rows));
  });
  Isolines out;
  std::vector<Isoline> along_edges;
  std::size_t points = 0, lines = 0;
  for (const GridRows& found : rows) {
    points += found.points.size();
    lines += found.lines.size() + found.along_edges.size();
  }
  out.points.reserve(points);
  out.lines.reserve(lines);
  for (GridRows& found : rows) {
    append(found, static_cast<std::uint32_t>(grid.size()), out, along_edges);
    found.points = {};
    found.lines = {};
  }
  add_once(along_edges, out.lines);
  return out;
}

// An edge is numbered with the first of its triangles.
bool is_numbered_with(const Tin& tin, std::size_t triangle, std::size_t side) {
  const std::uint32_t other = tin.neighbours[triangle][side];
  return other == kNoTriangle || triangle < other;
}

Isolines of_tin(const Tin& tin, const VertexValues& values, const IsolineLevels& levels,
                const IsolineGround& ground) {
  std::vector<double> of_vertices(tin.vertices_m.size());
  values(0, of_vertices);
  const auto end = [&](std::uint32_t vertex) {
    return IsolineEnd{vertex, levels.standing_of(of_vertices[vertex])};
  };
  Isolines out;
  const auto vertices = static_cast<std::uint32_t>(tin.vertices_m.size());
  std::vector<std::uint32_t> first_points(3 * tin.triangles.size());
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_numbered_with(tin, t, k)) continue;
      first_points[3 * t + k] = vertices + static_cast<std::uint32_t>(out.points.size());
      const SurfaceEdge edge = edge_opposite(tin, t, k).edge;
      add_edge_points(end(edge.from), end(edge.to), levels, out.points);
    }
  }
  const auto first_point = [&](std::uint32_t t, std::size_t k) {
    if (is_numbered_with(tin, t, k)) return first_points[3 * t + k];
    const std::uint32_t other = tin.neighbours[t][k];
    const SurfaceEdge edge = edge_opposite(tin, t, k).edge;
    for (std::size_t side = 0; side < 3; ++side)
      if (edge_opposite(tin, other, side).edge == edge) return first_points[3 * other + side];
    return vertices; // not reached: neighbours share an edge
  };
  std::vector<Isoline> along_edges;
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    if (ground.triangles && !ground.triangles->has(t)) continue;
    const auto& corners = tin.triangles[t];
    const IsolineTriangle triangle{{end(corners[0]), end(corners[1]), end(corners[2])},
                                   {first_point(t, 0), first_point(t, 1), first_point(t, 2)}};
    for_each_isoline(triangle, t, [&](const Isoline& line) {
      (line.to < vertices ? along_edges : out.lines).push_back(line);
    });
  }
  add_once(along_edges, out.lines);
  return out;
}

} // namespace

Isolines isolines(const Surface& surface, const VertexValues& values,
                  std::span<const double> levels, const IsolineGround& ground) {
  if (levels.empty()) return {};
  const IsolineLevels at(levels);
  if (const Grid* grid = std::get_if<Grid>(&surface)) return of_grid(*grid, values, at, ground);
  return of_tin(std::get<Tin>(surface), values, at, ground);
}

} // namespace orograph
