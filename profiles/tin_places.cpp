// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/tin_places.hpp"

#include "geometry/on_all_cores.hpp"
#include "profiles/surface_edges.hpp"

namespace orograph {

TinPlaces tin_places(const Tin& tin) {
  TinPlaces out;
  out.walls = walls_of(tin);
  out.begin.assign(tin.vertices_m.size() + 1, 0);
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    for (std::uint8_t k = 0; k < 3; ++k) {
      ++out.begin[tin.triangles[t][k] + 1];
      if (tin.neighbours[t][k] == kNoTriangle)
        out.border.push_back({{t, k},
                              plan_m(tin, tin.triangles[t][(k + 1U) % 3]),
                              plan_m(tin, tin.triangles[t][(k + 2U) % 3])});
    }
  }
  out.boxes_m.resize((out.border.size() + TinPlaces::kSidesTogether - 1) /
                     TinPlaces::kSidesTogether);
  for (std::size_t i = 0; i < out.boxes_m.size(); ++i)
    for (const TinPlaces::BorderSide& side : out.sides_of(i)) {
      out.boxes_m[i].include(side.from_m);
      out.boxes_m[i].include(side.to_m);
    }
  for (std::size_t i = 1; i < out.begin.size(); ++i) out.begin[i] += out.begin[i - 1];
  out.triangles.resize(out.begin.back());
  std::vector<std::uint32_t> next(out.begin.begin(), out.begin.end() - 1);
  for (std::uint32_t t = 0; t < tin.triangles.size(); ++t) {
    throw_if_stopped(t);
    for (const std::uint32_t vertex : tin.triangles[t]) out.triangles[next[vertex]++] = t;
  }
  return out;
}

} // namespace orograph
