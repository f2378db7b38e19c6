// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/closed_parts.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace orograph {

const char* const list_counterclockwise =
    "list the corners of each face counterclockwise for who looks from outside";

namespace {

using Index = std::uint32_t;

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

} // namespace

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
                  list_counterclockwise);
  }
}

} // namespace orograph
