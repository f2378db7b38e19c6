// SPDX-License-Identifier: GPL-3.0-or-later
// A TIN as a set of triangles in map coordinates, however its file orders them.
#pragma once

#include "dem/read/read_terrain.hpp"
#include "tests/dem/temp_folder.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace orograph {

inline const Tin& tin_in(const TerrainData& terrain) {
  return std::get<Tin>(terrain.surface);
}

using Corner = std::tuple<double, double, double>;

/// Rotated so that the least corner comes first, and sorted.
inline std::vector<std::array<Corner, 3>> triangles_on_map(const TerrainData& terrain) {
  const Tin& tin = tin_in(terrain);
  std::vector<std::array<Corner, 3>> all;
  for (const auto& triangle : tin.triangles) {
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = terrain.map.to_map(tin.vertices_m[triangle[k]]);
      corners[k] = {p.x, p.y, p.z};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

inline bool has_word(const std::vector<std::string>& notes, const std::string& words) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.find(words) != note.npos; });
}

} // namespace orograph
