// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/build_solid.hpp"

#include "geometry/box.hpp"
#include "geometry/error.hpp"
#include "solids/plane_polygon.hpp"
#include "solids/solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace orograph {
namespace {

using Index = std::uint32_t;
using Face = std::vector<Index>;

constexpr double kFarthest_m = 1e12; // cubes of it, and of its rounding, are still plain numbers
constexpr auto kSplitIt = "split it into triangles";
constexpr auto kListCounterclockwise =
    "list the corners of each face counterclockwise for who looks from outside";

// A side of a face, or of a triangle within one.
struct HalfEdge {
  Index from, to, triangle, face;
  bool within_face;

  Index low() const { return std::min(from, to); }
  Index high() const { return std::max(from, to); }
};

// Faces last, so that messages don't depend on how equals are sorted.
bool by_edge(const HalfEdge& a, const HalfEdge& b) {
  const auto order = [](const HalfEdge& side) {
    return std::array{
        side.low(), side.high(), Index{side.within_face}, side.within_face ? side.face : 0,
        side.from,  side.face};
  };
  return order(a) < order(b);
}

bool is_one_edge(const HalfEdge& a, const HalfEdge& b) {
  return a.low() == b.low() && a.high() == b.high() && a.within_face == b.within_face &&
         (!a.within_face || a.face == b.face);
}

Box3 checked_box(const std::vector<Vec3>& vertices_m) {
  Box3 box;
  for (std::size_t i = 0; i < vertices_m.size(); ++i) {
    const Vec3& p = vertices_m[i];
    if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kFarthest_m))
      throw Error(fmt::format("vertex {} is beyond 1e12 m", i), "give it nearer coordinates");
    box.include(p);
  }
  return box;
}

void check_corners(const Face& face, std::size_t number, std::size_t vertices) {
  if (face.size() < 3)
    throw Error(fmt::format("face {} has {} corners", number, face.size()),
                "a face has three or more");
  for (const Index corner : face)
    if (corner >= vertices)
      throw Error(fmt::format("face {} names vertex {}, which isn't there", number, corner),
                  fmt::format("there are vertices 0 to {}", static_cast<long>(vertices) - 1));
  Face sorted = face;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end())
    throw Error(fmt::format("face {} has vertex {} twice", number, *twice),
                "a face goes once round, through different vertices");
}

// Of the length of twice the face's area (Newell's method).
Vec3 normal_of(const Face& face, const std::vector<Vec3>& vertices_m) {
  Vec3 normal;
  const Vec3 first = vertices_m[face[0]];
  for (std::size_t i = 2; i < face.size(); ++i)
    normal = normal + cross(vertices_m[face[i - 1]] - first, vertices_m[face[i]] - first);
  return normal;
}

void check_plane(const Face& face, std::size_t number, const std::vector<Vec3>& vertices_m,
                 Vec3 unit_normal, double size_m) {
  Vec3 centre;
  for (const Index corner : face)
    centre = centre + (1.0 / static_cast<double>(face.size())) * vertices_m[corner];
  double farthest_m = 0;
  Index at = face[0];
  for (const Index corner : face) {
    const double off_m = std::abs(dot(vertices_m[corner] - centre, unit_normal));
    if (off_m <= farthest_m) continue;
    farthest_m = off_m;
    at = corner;
  }
  if (farthest_m > 1e-6 * size_m)
    throw Error(
        fmt::format("face {} isn't plane: its vertex {} is {:.3g} m off", number, at, farthest_m),
        kSplitIt);
}

// The face seen from outside, along the axis that it looks along most; unsheared enough to be
// judged there.
std::vector<Vec2> flat(const Face& face, const std::vector<Vec3>& vertices_m, Vec3 normal) {
  std::vector<Vec2> corners;
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  for (const Index corner : face) {
    const Vec3& p = vertices_m[corner];
    if (z >= x && z >= y)
      corners.push_back(normal.z > 0 ? Vec2{p.x, p.y} : Vec2{p.y, p.x});
    else if (x >= y)
      corners.push_back(normal.x > 0 ? Vec2{p.y, p.z} : Vec2{p.z, p.y});
    else
      corners.push_back(normal.y > 0 ? Vec2{p.z, p.x} : Vec2{p.x, p.z});
  }
  return corners;
}

std::vector<std::array<Index, 3>> split(const Face& face, std::size_t number,
                                        const std::vector<Vec3>& vertices_m, double size_m) {
  const Vec3 normal = normal_of(face, vertices_m);
  const double twice_area = length(normal);
  if (!(twice_area > 0))
    throw Error(fmt::format("face {} has no area", number),
                "its corners should go once round a plane area");
  check_plane(face, number, vertices_m, (1 / twice_area) * normal, size_m);
  const std::vector<Vec2> corners = flat(face, vertices_m, normal);
  if (const std::string fault = fault_of_line(corners, true); !fault.empty())
    throw Error(fmt::format("face {} {}", number, fault), "its edges should meet at corners only");
  auto triangles = triangles_of(corners);
  if (triangles.empty())
    throw Error(fmt::format("face {} is too narrow to be cut into triangles", number), kSplitIt);
  return triangles;
}

void check_edge(std::span<const HalfEdge> sides) {
  const std::string edge =
      fmt::format("the edge between vertices {} and {}", sides[0].low(), sides[0].high());
  if (sides.size() == 1)
    throw Error(
        fmt::format("{} has one face only, face {}, so the surface is open", edge, sides[0].face),
        "close it: each edge has two faces");
  if (sides.size() > 2)
    throw Error(fmt::format("{} has {} faces", edge, sides.size()),
                "each edge has two; bodies that touch need vertices of their own");
  if (sides[0].from == sides[1].from)
    throw Error(fmt::format("faces {} and {} run along {} the same way", sides[0].face,
                            sides[1].face, edge),
                kListCounterclockwise);
}

void drop_unused_vertices(Solid& solid) {
  constexpr Index unused = SolidEdge::kNoTriangle;
  std::vector<Index> number(solid.vertices_m.size(), unused);
  for (const SolidEdge& edge : solid.edges) number[edge.from] = number[edge.to] = 0;
  Index kept = 0;
  for (Index i = 0; i < number.size(); ++i) {
    if (number[i] == unused) continue;
    solid.vertices_m[kept] = solid.vertices_m[i];
    number[i] = kept++;
  }
  solid.vertices_m.resize(kept);
  for (SolidEdge& edge : solid.edges) {
    edge.from = number[edge.from];
    edge.to = number[edge.to];
  }
  for (auto& triangle : solid.triangles)
    for (Index& corner : triangle) corner = number[corner];
}

std::vector<SolidEdge> paired(std::vector<HalfEdge>& sides, const Polyhedron& polyhedron) {
  std::vector<std::array<Index, 2>> smooth = polyhedron.smooth_edges;
  for (auto& edge : smooth) std::sort(edge.begin(), edge.end());
  std::sort(smooth.begin(), smooth.end());
  std::sort(sides.begin(), sides.end(), by_edge);
  std::vector<SolidEdge> edges;
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && is_one_edge(sides[first], sides[end])) ++end;
    const HalfEdge& side = sides[first];
    check_edge(std::span(sides).subspan(first, end - first));
    edges.push_back({side.from, side.to, side.triangle, sides[first + 1].triangle,
                     side.within_face || std::binary_search(smooth.begin(), smooth.end(),
                                                            std::array{side.from, side.to})});
  }
  return edges;
}

// Triangles that are joined, each set by one of them.
class Parts {
public:
  explicit Parts(std::size_t triangles) : of_(triangles) {
    std::iota(of_.begin(), of_.end(), Index{0});
  }

  void join(Index a, Index b) { of_[root(a)] = root(b); }
  Index root(Index triangle) {
    while (of_[triangle] != triangle) triangle = of_[triangle] = of_[of_[triangle]];
    return triangle;
  }

private:
  std::vector<Index> of_;
};

struct Measure {
  double six_volumes_m3 = 0, twice_area_m2 = 0;
};

// Throws Error if a closed part of the solid, all that edges join, has no volume to rounding, or
// is inside out. `face_of` is the face of each triangle, for messages; the part's first is named.
// REQUIRES that every edge has its two triangles.
void require_outward(const Solid& solid, const std::vector<std::uint32_t>& face_of, double size_m) {
  Parts parts(solid.triangles.size());
  for (const SolidEdge& edge : solid.edges) parts.join(edge.left, edge.right);
  std::vector<Measure> measures(solid.triangles.size());
  const auto corner = [&](Index triangle, int number) {
    return solid.vertices_m[solid.triangles[triangle][number]];
  };
  for (Index i = 0; i < measures.size(); ++i) {
    const Index part = parts.root(i);
    const Vec3 normal = cross(corner(i, 1) - corner(i, 0), corner(i, 2) - corner(i, 0));
    // From a point of the part, so that a far part has no smaller volume.
    measures[part].six_volumes_m3 += dot(corner(i, 0) - corner(part, 0), normal);
    measures[part].twice_area_m2 += length(normal);
  }
  for (Index i = 0; i < measures.size(); ++i) {
    const Measure& part = measures[parts.root(i)];
    if (std::abs(part.six_volumes_m3) <= 1e-14 * part.twice_area_m2 * size_m)
      throw Error(fmt::format("the closed part with face {} has no volume", face_of[i]),
                  "a sheet needs a thickness");
    if (part.six_volumes_m3 < 0)
      throw Error(fmt::format("the closed part with face {} is inside out", face_of[i]),
                  kListCounterclockwise);
  }
}

} // namespace

Solid build_solid(const Polyhedron& polyhedron) {
  const std::vector<Vec3>& vertices_m = polyhedron.vertices_m;
  const Box3 box = checked_box(vertices_m);
  if (polyhedron.faces.empty()) throw Error("there are no faces", "a closed body has four or more");
  const double size_m = length(box.high - box.low);
  Solid solid{vertices_m, {}, {}};
  std::vector<HalfEdge> sides;
  std::vector<Index> face_of; // of each triangle
  for (Index number = 0; number < polyhedron.faces.size(); ++number) {
    const Face& face = polyhedron.faces[number];
    check_corners(face, number, vertices_m.size());
    for (const auto& [a, b, c] : split(face, number, vertices_m, size_m)) {
      const auto triangle = static_cast<Index>(solid.triangles.size());
      for (const auto& [from, to] : {std::array{a, b}, std::array{b, c}, std::array{c, a}})
        sides.push_back({face[from], face[to], triangle, number, to != (from + 1) % face.size()});
      solid.triangles.push_back({face[a], face[b], face[c]});
      face_of.push_back(number);
    }
  }
  solid.edges = paired(sides, polyhedron);
  require_outward(solid, face_of, size_m);
  drop_unused_vertices(solid);
  return solid;
}

Solid build_wires(const std::vector<Vec3>& vertices_m,
                  const std::vector<std::array<std::uint32_t, 2>>& lines) {
  checked_box(vertices_m);
  if (lines.empty()) throw Error("there are no lines", "give one or more");
  Solid solid{vertices_m, {}, {}};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto [from, to] = lines[i];
    if (std::max(from, to) >= vertices_m.size())
      throw Error(
          fmt::format("line {} names vertex {}, which isn't there", i, std::max(from, to)),
          fmt::format("there are vertices 0 to {}", static_cast<long>(vertices_m.size()) - 1));
    if (vertices_m[from] == vertices_m[to])
      throw Error(fmt::format("line {} has no length", i), "it joins two different places");
    solid.edges.push_back({from, to});
  }
  drop_unused_vertices(solid);
  return solid;
}

} // namespace orograph
