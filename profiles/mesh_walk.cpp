// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles/mesh_walk.hpp"

#include <algorithm>
#include <utility>

namespace orograph {
namespace {

bool is_wall(const Profile& found, const Run& run) {
  return run.u_first == run.u_last && found.after[run.begin] == Span::wall;
}

bool is_before(const Run& a, const Run& b) {
  return a.u_first != b.u_first ? a.u_first < b.u_first : a.u_last < b.u_last;
}

// A wall that nothing joins to the ground, as where another of the same edge is missing, stands
// where that ground begins or ends. What rounds to a place within it is there as well.
void put_walls_at_ends(const Profile& found, std::vector<Run>& runs) {
  const Run* ground = nullptr;
  bool is_moved = false;
  for (Run& run : runs) {
    if (!is_wall(found, run)) {
      ground = &run;
      continue;
    }
    const double u = run.u_first;
    if (!ground || !(u > ground->u_first && u < ground->u_last)) continue;
    const bool at_begin = u - ground->u_first < ground->u_last - u;
    run.u_first = run.u_last = at_begin ? ground->u_first : ground->u_last;
    is_moved = true;
  }
  if (is_moved) std::sort(runs.begin(), runs.end(), is_before);
}

} // namespace

void keep_ground_in_front(std::vector<Run>& runs) {
  std::vector<Run> through;
  for (const Run& run : runs)
    if (!run.along) through.push_back(run);
  std::sort(through.begin(), through.end(),
            [](const Run& a, const Run& b) { return a.u_last < b.u_last; });
  std::erase_if(runs, [&](const Run& run) {
    if (!run.along) return false;
    const auto next = std::partition_point(through.begin(), through.end(), [&](const Run& other) {
      return other.u_last <= run.u_first;
    });
    return next != through.end() && next->u_first < run.u_last;
  });
}

void put_in_order(Profile& from, std::vector<Run>& runs, Profile& out) {
  if (runs.size() == 1 && runs.front().begin == 0 && runs.front().end == from.size()) {
    std::swap(from.u_m, out.u_m);
    std::swap(from.z_m, out.z_m);
    std::swap(from.after, out.after);
    std::swap(from.triangles, out.triangles);
    return;
  }
  std::sort(runs.begin(), runs.end(), is_before);
  put_walls_at_ends(from, runs);
  for (const Run& run : runs) {
    std::size_t i = run.begin;
    if (out.size() > 0) {
      if (run.u_last <= out.u_m.back() && run.u_first < out.u_m.back()) continue;
      if (from.u_m[i] == out.u_m.back() && from.z_m[i] == out.z_m.back()) {
        out.after.back() = from.after[i];
        if (!from.triangles.empty()) out.triangles.back() = from.triangles[i];
        ++i;
      }
    }
    for (; i < run.end; ++i) {
      const double u = from.u_m[i];
      out.u_m.push_back(out.size() > 0 ? std::max(u, out.u_m.back()) : u);
      out.z_m.push_back(from.z_m[i]);
      out.after.push_back(from.after[i]);
      if (!from.triangles.empty()) out.triangles.push_back(from.triangles[i]);
    }
  }
}

} // namespace orograph
