// SPDX-License-Identifier: GPL-3.0-or-later
#include "solids/holds_eye.hpp"

#include "geometry/box.hpp"

#include <vector>

namespace orograph {
namespace {

struct Corner {
  Vec3 from_eye;
  std::uint32_t number;
};

// Whether the eye is left of the edge a -> b, seen from above; exactly the opposite for b -> a.
bool is_left(const Corner& a, const Corner& b) {
  const bool turned = a.number > b.number;
  const Vec3 p = turned ? b.from_eye : a.from_eye, q = turned ? a.from_eye : b.from_eye;
  const double cross_z = p.x * q.y - p.y * q.x;
  return (cross_z > 0) != turned;
}

// How an edge crosses the half plane north of the upright through the eye: half open, so that a
// vertex on it is crossed once.
int crossing(const Corner& a, const Corner& b) {
  const bool a_west = a.from_eye.x < 0, b_west = b.from_eye.x < 0;
  if (a_west == b_west || is_left(a, b) != b_west) return 0;
  return b_west ? 1 : -1;
}

} // namespace

bool holds_eye(const StandingSolid& standing, const View& view) {
  std::vector<Vec3> from_eye;
  from_eye.reserve(standing.vertices_m.size());
  Box3 box;
  for (const Vec3& vertex : standing.vertices_m) {
    const ProfilePoint at = to_profile_frame(view, vertex);
    from_eye.push_back({at.u, at.v, at.z - view.eye_z_m});
    box.include(from_eye.back());
  }
  const auto spans = [](double low, double high) { return low <= 0 && high >= 0; };
  if (!spans(box.low.x, box.high.x) || !spans(box.low.y, box.high.y) ||
      !spans(box.low.z, box.high.z))
    return false;
  int above = 0; // triangles that the upright goes out of, less those that it goes into
  for (const auto& triangle : standing.solid->triangles) {
    Corner corners[3];
    for (std::size_t i = 0; i < 3; ++i) corners[i] = {from_eye[triangle[i]], triangle[i]};
    const auto& [a, b, c] = corners;
    const int turn = crossing(a, b) + crossing(b, c) + crossing(c, a);
    if (turn != 0 && turn * dot(a.from_eye, cross(b.from_eye, c.from_eye)) > 0) above += turn;
  }
  return standing.mirrored ? above < 0 : above > 0;
}

} // namespace orograph
