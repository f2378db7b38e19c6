// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/verify_tin.hpp"

#include "dem/mesh/overlap.hpp"
#include "dem/triangulate/orientation.hpp"
#include "geometry/on_all_cores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

using Kind = TinFault::Kind;

std::optional<TinFault> size_fault(const Tin& tin) {
  if (tin.triangles.empty()) return TinFault{Kind::no_triangles, "there are no triangles"};
  if (tin.neighbours.size() != tin.triangles.size())
    return TinFault{Kind::bad_sizes, fmt::format("{} triangles have neighbours of {}",
                                                 tin.triangles.size(), tin.neighbours.size())};
  return std::nullopt;
}

std::optional<TinFault> index_fault(const Tin& tin) {
  for (std::size_t t = 0; t < tin.triangles.size(); ++t) {
    for (const std::uint32_t v : tin.triangles[t])
      if (v >= tin.vertices_m.size())
        return TinFault{Kind::bad_index, fmt::format("triangle {} has vertex {}, and there are {}",
                                                     t, v, tin.vertices_m.size())};
    for (const std::uint32_t n : tin.neighbours[t])
      if (n != kNoTriangle && n >= tin.triangles.size())
        return TinFault{Kind::bad_index,
                        fmt::format("triangle {} has triangle {} as a neighbour, and there are {}",
                                    t, n, tin.triangles.size())};
  }
  return std::nullopt;
}

std::optional<TinFault> vertex_fault(const Tin& tin) {
  for (std::size_t v = 0; v < tin.vertices_m.size(); ++v) {
    const Vec3& p = tin.vertices_m[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return TinFault{Kind::not_finite,
                      fmt::format("vertex {} is at {}, {}, {}", v, p.x, p.y, p.z)};
  }
  return std::nullopt;
}

std::optional<TinFault> triangle_fault(const Tin& tin, std::size_t t) {
  const auto& [i, j, k] = tin.triangles[t];
  const Vec3 &a = tin.vertices_m[i], &b = tin.vertices_m[j], &c = tin.vertices_m[k];
  const int turn = plan_orientation(a, b, c);
  if (turn > 0) return std::nullopt;
  if (turn < 0)
    return TinFault{Kind::turned_over,
                    fmt::format("triangle {} runs clockwise seen from above", t)};
  if (a == b || b == c || c == a)
    return TinFault{Kind::repeated_vertex,
                    fmt::format("triangle {} has two vertices at one point", t)};
  if (on_one_line(a, b, c))
    return TinFault{Kind::no_area, fmt::format("triangle {} has its vertices on one line", t)};
  return std::nullopt;
}

std::optional<TinFault> neighbour_fault(const Tin& tin, const Neighbours& right) {
  for (std::size_t t = 0; t < tin.triangles.size(); ++t)
    if (tin.neighbours[t] != right.of[t])
      return TinFault{Kind::neighbours_disagree,
                      fmt::format("triangle {} doesn't name the triangles across its edges", t)};
  return std::nullopt;
}

} // namespace

std::optional<Misfit> edge_misfit(const Tin& tin, const Neighbours& neighbours) {
  if (!neighbours.crowded.empty()) {
    Misfit misfit{TinFault::Kind::edge_of_three, {}};
    for (const TriangleSide& side : neighbours.crowded.front())
      misfit.triangles.push_back(side.triangle);
    return misfit;
  }
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t other = neighbours.of[t][k];
      if (other != kNoTriangle && run_alike(tin, t, k, other))
        return Misfit{TinFault::Kind::edge_runs_twice, {std::min(t, other), std::max(t, other)}};
    }
  }
  return std::nullopt;
}

std::string phrase(const Misfit& misfit) {
  const auto& t = misfit.triangles;
  switch (misfit.kind) {
  case TinFault::Kind::edge_of_three:
    return fmt::format("triangles {}, {} and {} have one edge in common", t[0], t[1], t[2]);
  case TinFault::Kind::edge_runs_twice:
    return fmt::format("triangles {} and {} run the same way along their common edge", t[0], t[1]);
  default:
    return fmt::format("triangles {} and {} overlap seen from above", t[0], t[1]);
  }
}

std::optional<TinFault> verify(const Tin& tin) {
  if (auto fault = size_fault(tin)) return fault;
  if (auto fault = index_fault(tin)) return fault;
  if (auto fault = vertex_fault(tin)) return fault;
  for (std::size_t t = 0; t < tin.triangles.size(); ++t)
    if (auto fault = triangle_fault(tin, t)) return fault;
  const Neighbours neighbours = find_neighbours(tin.triangles, tin.vertices_m.size());
  if (const auto misfit = edge_misfit(tin, neighbours))
    return TinFault{misfit->kind, phrase(*misfit)};
  if (auto fault = neighbour_fault(tin, neighbours)) return fault;
  if (const auto pair = first_overlap(tin))
    return TinFault{Kind::overlap, phrase({Kind::overlap, {(*pair)[0], (*pair)[1]}})};
  return std::nullopt;
}

} // namespace orograph
