// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/shapes.hpp"

#include "geometry/error.hpp"
#include "solids/build_solid.hpp"
#include "solids/plane_polygon.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace orograph {
namespace {

using Index = std::uint32_t;

// Counterclockwise, from above.
std::vector<Vec2> checked_base(std::vector<Vec2> base_m) {
  if (base_m.size() < 3)
    throw Error("the base has fewer than three corners", "give three or more, [x, y] each");
  if (const std::string fault = fault_of_line(base_m, true); !fault.empty())
    throw Error("the base " + fault, "its edges should meet at corners only; its last corner is "
                                     "joined to the first without being told");
  if (signed_area(base_m) < 0) std::reverse(base_m.begin(), base_m.end());
  return base_m;
}

std::vector<Index> bottom_face(std::size_t corners) {
  std::vector<Index> face;
  for (std::size_t i = corners; i-- > 0;) face.push_back(static_cast<Index>(i));
  return face;
}

Vec3 apex_of(const std::vector<Vec2>& base_m, const Apex& apex_m) {
  if (const Vec3* point = std::get_if<Vec3>(&apex_m)) return *point;
  Vec2 middle;
  for (const Vec2 corner : base_m)
    middle = middle + (1.0 / static_cast<double>(base_m.size())) * corner;
  return {middle.x, middle.y, std::get<double>(apex_m)};
}

} // namespace

Solid box(Vec3 size_m) {
  const auto [x, y, z] = size_m;
  if (!(x > 0 && y > 0 && z > 0)) throw Error("the box is flat", "its lengths should be above 0");
  return prism({{-x / 2, -y / 2}, {x / 2, -y / 2}, {x / 2, y / 2}, {-x / 2, y / 2}}, z);
}

Solid prism(std::vector<Vec2> base_m, double height_m) {
  if (!(height_m > 0)) throw Error("the prism is flat", "its height should be above 0");
  const std::vector<Vec2> base = checked_base(std::move(base_m));
  const auto n = static_cast<Index>(base.size());
  Polyhedron polyhedron;
  for (const double z : {0.0, height_m})
    for (const Vec2 corner : base) polyhedron.vertices_m.push_back({corner.x, corner.y, z});
  polyhedron.faces.push_back(bottom_face(n));
  std::vector<Index> top;
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    polyhedron.faces.push_back({i, next, n + next, n + i});
    top.push_back(n + i);
  }
  polyhedron.faces.push_back(top);
  return build_solid(polyhedron);
}

Solid pyramid(std::vector<Vec2> base_m, const Apex& apex_m) {
  const std::vector<Vec2> base = checked_base(std::move(base_m));
  const Vec3 apex = apex_of(base, apex_m);
  if (!(apex.z > 0))
    throw Error("the pyramid's apex isn't above its base", "give it a height above 0");
  const auto n = static_cast<Index>(base.size());
  Polyhedron polyhedron;
  for (const Vec2 corner : base) polyhedron.vertices_m.push_back({corner.x, corner.y, 0});
  polyhedron.vertices_m.push_back(apex);
  polyhedron.faces.push_back(bottom_face(n));
  for (Index i = 0; i < n; ++i) polyhedron.faces.push_back({i, (i + 1) % n, n});
  return build_solid(polyhedron);
}

Solid tetrahedron(const std::array<Vec3, 4>& vertices_m) {
  Polyhedron polyhedron{{vertices_m.begin(), vertices_m.end()}, {}, {}};
  const auto& [a, b, c, d] = vertices_m;
  if (dot(cross(b - a, c - a), d - a) < 0)
    std::swap(polyhedron.vertices_m[2], polyhedron.vertices_m[3]);
  polyhedron.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return build_solid(polyhedron);
}

} // namespace orograph
