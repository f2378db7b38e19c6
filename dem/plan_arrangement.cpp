// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/plan_arrangement.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace orograph {
namespace {

// Where a rounded crossing falls outside of the two triangles beside the crossed edge, CGAL 5.5
// reckons it again with the kernel's exact one, and takes the wrong sign of its place along the
// line (exact_intersection_point_for_cdt_2). A kernel without an exact one keeps the rounded point.
struct Kernel : CGAL::Exact_predicates_inexact_constructions_kernel {
  using Exact_kernel = void;
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<Delaunay>;

} // namespace

PlanArrangement arrange(std::span<const std::vector<Vec2>> lines) {
  Triangulation triangulation;
  std::vector<Triangulation::Constraint_id> ids;
  std::vector<Kernel::Point_2> points;
  for (const auto& line : lines) {
    points.clear();
    for (const Vec2 p : line) points.emplace_back(p.x, p.y);
    ids.push_back(triangulation.insert_constraint(points.begin(), points.end()));
  }

  PlanArrangement arrangement;
  for (const auto vertex : triangulation.finite_vertex_handles()) {
    vertex->info() = static_cast<std::uint32_t>(arrangement.points.size());
    arrangement.points.push_back({vertex->point().x(), vertex->point().y()});
  }
  for (const auto face : triangulation.finite_face_handles())
    arrangement.faces.push_back(
        {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  for (const auto& id : ids) {
    auto& line = arrangement.lines.emplace_back();
    for (auto v = triangulation.vertices_in_constraint_begin(id);
         v != triangulation.vertices_in_constraint_end(id); ++v)
      line.push_back((*v)->info());
  }
  return arrangement;
}

} // namespace orograph
