// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/upright_heights.hpp"

#include "profiles/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

// How many steps there are from a place in [0, last] back to its border.
int steps_back(int at, int step, int last) {
  if (step == 0) return std::numeric_limits<int>::max();
  return step > 0 ? at : last - at;
}

template <class Mesh>
bool is_there(const Mesh& mesh, const CellHalf& t) {
  if (t.column < 0 || t.row < 0 || t.column + 1 >= mesh.grid.columns || t.row + 1 >= mesh.grid.rows)
    return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (std::isnan(mesh.heights[mesh.index(t, k)])) return false;
  return true;
}

// Whether a vertex belongs to a triangle.
template <class Mesh>
bool is_ground(const Mesh& mesh, CellVertex v) {
  const auto& [c, r] = v;
  return is_there(mesh, {c, r, Half::lower}) || is_there(mesh, {c, r, Half::upper}) ||
         is_there(mesh, {c - 1, r - 1, Half::lower}) ||
         is_there(mesh, {c - 1, r - 1, Half::upper}) || is_there(mesh, {c, r - 1, Half::lower}) ||
         is_there(mesh, {c - 1, r, Half::upper});
}

template <class Mesh>
bool is_edge(const Mesh& mesh, CellVertex a, CellVertex b) {
  const auto i = static_cast<std::uint32_t>(mesh.grid.index(a.column, a.row)),
             k = static_cast<std::uint32_t>(mesh.grid.index(b.column, b.row));
  const SurfaceEdge edge{std::min(i, k), std::max(i, k)};
  return is_there(mesh, side_of(mesh.grid, edge, true).triangle) ||
         is_there(mesh, side_of(mesh.grid, edge, false).triangle);
}

} // namespace

double UprightHeights::in_front(SurfaceEdge edge, bool from_is_nearer, const SurfaceLine& line,
                                const BlockedHorizon& horizon) {
  if (grid_.is_on_earth()) return lower_height_beside(line, horizon);
  return std::visit([&](const auto& heights) { return in_front(heights, edge, from_is_nearer); },
                    grid_.heights_m);
}

template <class Height>
double UprightHeights::in_front(const Heights<Height>& heights, SurfaceEdge edge,
                                bool from_is_nearer) {
  const auto columns = static_cast<std::uint32_t>(grid_.columns);
  const std::uint32_t near = from_is_nearer ? edge.from : edge.to,
                      far = from_is_nearer ? edge.to : edge.from;
  const CellVertex end{static_cast<int>(near % columns), static_cast<int>(near / columns)};
  const CellVertex step{static_cast<int>(far % columns) - end.column,
                        static_cast<int>(far / columns) - end.row};
  const GridMesh mesh{grid_, grid_.plane(), heights, view_};
  const auto at = [&](CellVertex v) {
    return to_profile_frame(
        view_, grid_.plane().vertex_m(v.column, v.row, heights[grid_.index(v.column, v.row)]));
  };
  const int count = std::min(steps_back(end.column, step.column, grid_.columns - 1),
                             steps_back(end.row, step.row, grid_.rows - 1));
  const int family = step.row == 0 ? 0 : step.column == 0 ? 1 : 2;
  const int number = family == 0   ? end.row
                     : family == 1 ? end.column
                                   : end.column - end.row + grid_.rows;
  const auto key = static_cast<std::uint64_t>(number) * 3 + static_cast<std::uint64_t>(family);
  Line& line = lines_.try_emplace(key, Line{0, -kInfinity}).first->second;
  for (; line.steps_done <= count; ++line.steps_done) {
    const int back = count - line.steps_done;
    const CellVertex v{end.column - back * step.column, end.row - back * step.row};
    const ProfilePoint p = at(v);
    if (p.v >= from_m_) {
      if (is_ground(mesh, v)) line.greatest_y = std::max(line.greatest_y, project(view_, p).y);
      continue;
    }
    // Behind the near plane begins what isn't cut away.
    if (back == 0) continue;
    const CellVertex behind{v.column + step.column, v.row + step.row};
    const ProfilePoint next = at(behind);
    if (next.v <= from_m_ || !is_edge(mesh, v, behind)) continue;
    const ProfilePoint cut = point_between(p, next, (from_m_ - p.v) / (next.v - p.v));
    line.greatest_y = std::max(line.greatest_y, project(view_, {cut.u, from_m_, cut.z}).y);
  }
  return line.greatest_y;
}

} // namespace orograph
