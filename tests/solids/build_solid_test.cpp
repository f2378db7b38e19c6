// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/error.hpp"
#include "solids/build_solid.hpp"
#include "tests/solids/solid_facts.hpp"
#include "tests/view/matrices.hpp"

#include <limits>

using namespace orograph;

namespace {

Polyhedron cube(Vec3 low = {0, 0, 0}, double side = 2) {
  Polyhedron cube;
  for (const double z : {low.z, low.z + side})
    for (const auto& [x, y] : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}})
      cube.vertices_m.push_back({low.x + side * x, low.y + side * y, z});
  cube.faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return cube;
}

Polyhedron both(Polyhedron a, const Polyhedron& b) {
  const auto first = static_cast<std::uint32_t>(a.vertices_m.size());
  a.vertices_m.insert(a.vertices_m.end(), b.vertices_m.begin(), b.vertices_m.end());
  for (std::vector<std::uint32_t> face : b.faces) {
    for (std::uint32_t& corner : face) corner += first;
    a.faces.push_back(face);
  }
  return a;
}

Polyhedron inside_out(Polyhedron p) {
  for (auto& face : p.faces) std::reverse(face.begin(), face.end());
  return p;
}

void refused(const Polyhedron& p, const std::string& words) {
  check_refused([&] { build_solid(p); }, words);
}

} // namespace

TEST_CASE("a cube: 12 edges, and six more within its faces") {
  const Solid solid = build_solid(cube());
  require_closed(solid);
  CHECK(solid.vertices_m.size() == 8);
  CHECK(solid.triangles.size() == 12);
  CHECK(solid.edges.size() == 18);
  CHECK(drawn_edges(solid) == 12);
  CHECK(euler_of(solid) == 2);
  CHECK(volume_of(solid) == Approx(8));
  for (const SolidEdge& edge : solid.edges) CHECK(edge.from < edge.to);
}

TEST_CASE("smooth edges are told in either direction; vertices without a face go") {
  Polyhedron p = cube();
  p.vertices_m.insert(p.vertices_m.begin(), {99, 99, 99});
  for (auto& face : p.faces)
    for (std::uint32_t& corner : face) ++corner;
  p.smooth_edges = {{1, 2}, {3, 2}};
  const Solid solid = build_solid(p);
  require_closed(solid);
  CHECK(solid.vertices_m == cube().vertices_m);
  CHECK(drawn_edges(solid) == 10);
}

TEST_CASE("two bodies in one polyhedron, one inside the other or touching in an edge") {
  CHECK(euler_of(build_solid(both(cube(), cube({5, 0, 0})))) == 4);
  // They share places, not vertices.
  require_closed(build_solid(both(cube(), cube({2, 2, 0}))));
  refused(both(cube(), inside_out(cube({5, 0, 0}))), "part with face 6 is inside out");
  // A hollow in a body is another part: it would have to be inside out.
  refused(both(cube({0, 0, 0}, 9), inside_out(cube({1, 1, 1}))), "face 6 is inside out");
}

TEST_CASE("a far polyhedron, a large one and a small one are still closed") {
  for (const double side : {1e-6, 1.0, 1e9})
    for (const double far : {0.0, 1e6}) {
      INFO(side << ' ' << far);
      if (side < 1e-3 && far > 0) continue; // its corners would be rounded away
      const Solid solid = build_solid(cube({far, far, far}, side));
      CHECK(solid.edges.size() == 18);
    }
}

TEST_CASE("polyhedra that bound nothing are refused") {
  refused(inside_out(cube()), "the closed part with face 0 is inside out");
  refused({cube().vertices_m, {}, {}}, "there are no faces");
  Polyhedron p = cube();
  p.faces.pop_back();
  refused(p, "the edge between vertices 0 and 3 has one face only, face 0, so the surface is open");
  p = cube();
  std::reverse(p.faces[1].begin(), p.faces[1].end());
  refused(p, "faces 1 and 2 run along the edge between vertices 4 and 5 the same way");
  p = cube();
  p.faces.push_back(p.faces[0]);
  p.faces.push_back({0, 1, 2, 3});
  refused(p, "the edge between vertices 0 and 1 has 4 faces");
  p = cube();
  p.vertices_m[6].z += 0.25;
  refused(p, "face 1 isn't plane: its vertex 4 is 0.0623 m off");
  p = cube();
  p.vertices_m[6].z += 1e-7; // as a file with seven digits has it
  CHECK_NOTHROW(build_solid(p));
  p.faces[2] = {0, 1};
  refused(p, "face 2 has 2 corners");
  p.faces[2] = {0, 1, 8, 4};
  refused(p, "face 2 names vertex 8, which isn't there");
  p.faces[2] = {0, 1, 5, 1};
  refused(p, "face 2 has vertex 1 twice");
  p.faces[2] = {0, 5, 1, 4};
  refused(p, "face 2");
  p = cube();
  p.vertices_m[5].x = std::numeric_limits<double>::quiet_NaN();
  refused(p, "vertex 5 is beyond 1e12 m");
  p.vertices_m[5].x = 2e12;
  refused(p, "vertex 5 is beyond 1e12 m");
  refused({{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}, {}},
          "face 0 has the corners 1 and 2 in one place");
  refused({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}, {}}, "has no volume");
  refused({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {2, 1, 0}}, {}}, "face 0 has no area");
}

TEST_CASE("wires have edges without faces") {
  const Solid solid = build_wires({{0, 0, 0}, {0, 0, 9}, {7, 7, 7}, {3, 0, 9}}, {{0, 1}, {3, 1}});
  CHECK(solid.triangles.empty());
  CHECK(solid.vertices_m == std::vector<Vec3>{{0, 0, 0}, {0, 0, 9}, {3, 0, 9}});
  CHECK(solid.edges == std::vector<SolidEdge>{{0, 1}, {2, 1}});
  CHECK(solid.edges[0].is_wire());
  CHECK_FALSE(solid.edges[0].smooth);
  check_refused([] { build_wires({{0, 0, 0}}, {}); }, "there are no lines");
  check_refused([] { build_wires({{0, 0, 0}, {0, 0, 1}}, {{0, 2}}); }, "line 0 names vertex 2");
  check_refused([] { build_wires({{0, 0, 1}, {0, 0, 1}}, {{0, 1}}); }, "line 0 has no length");
}
