// SPDX-License-Identifier: GPL-3.0-or-later
// Crossings are settled before (uncross_lines): CGAL 5.5's own way with crossings of inexact
// coordinates goes round in circles where lines are nearly parallel.
#include "dem/mesh/plan_arrangement.hpp"

#include "dem/mesh/uncross_lines.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <map>

namespace orograph {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<Delaunay>;

} // namespace

PlanArrangement arrange(std::span<const std::vector<Vec2>> lines, std::span<const Vec2> fixed,
                        double reach_m) {
  UncrossedLines uncrossed = uncross(lines, fixed, reach_m);
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  Triangulation::Face_handle near;
  for (const Vec2 p : uncrossed.points) {
    vertices.push_back(triangulation.insert({p.x, p.y}, near));
    vertices.back()->info() = static_cast<std::uint32_t>(vertices.size() - 1);
    near = vertices.back()->face();
  }
  std::map<Step, Triangulation::Constraint_id> id_of; // from the lower point to the higher
  for (const auto& line : uncrossed.lines)
    for (const auto& [a, b] : line) {
      const auto [low, high] = std::minmax({a, b});
      auto& id = id_of[{low, high}];
      if (id == Triangulation::Constraint_id())
        id = triangulation.insert_constraint(vertices[low], vertices[high]);
    }

  PlanArrangement arrangement;
  arrangement.points = std::move(uncrossed.points);
  for (const auto face : triangulation.finite_face_handles())
    arrangement.faces.push_back(
        {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  for (const auto& steps : uncrossed.lines) {
    auto& line = arrangement.lines.emplace_back();
    for (const auto& [a, b] : steps) {
      std::vector<std::uint32_t> through;
      const auto id = id_of.at({std::min(a, b), std::max(a, b)});
      for (auto v = triangulation.vertices_in_constraint_begin(id);
           v != triangulation.vertices_in_constraint_end(id); ++v)
        through.push_back((*v)->info());
      if (through.front() != a) std::reverse(through.begin(), through.end());
      const bool goes_on = !line.empty() && line.back() == a;
      line.insert(line.end(), through.begin() + (goes_on ? 1 : 0), through.end());
    }
  }
  return arrangement;
}

} // namespace orograph
