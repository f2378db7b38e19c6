// SPDX-License-Identifier: GPL-3.0-or-later
// Whole scenes, drawn and asked of the ray walk.
#pragma once

#include "cli/draw_scene.hpp"
#include "tests/catch.hpp"

#include <cstdint>

namespace orograph {

struct Asked {
  std::uint64_t scenes = 0, asked = 0, ties = 0, hidden = 0, missing = 0;

  void add(const CheckReport& check) {
    ++scenes;
    asked += check.asked;
    ties += check.ties;
    hidden += check.hidden;
    missing += check.missing;
  }
};

/// Draws with every fold and the outlines of voids, and nothing simplified; checks that nothing
/// drawn is hidden and nothing visible is missing, and that the drawing has no fault. Throws what
/// place_scene throws.
inline CheckReport ask(const Terrain& terrain, RenderSettings settings, std::uint64_t probes) {
  settings.occluder = Occluder::surface;
  settings.simplify_mm = 0;
  settings.silhouette_jump = 0;
  settings.void_edges = true;
  settings.check = probes;
  const Scene scene = place_scene(terrain, settings);
  const DrawnScene drawn = draw_scene(terrain, scene, settings, [](double) {});
  const auto fault = find_fault(drawn.drawing);
  INFO(fault.value_or(""));
  REQUIRE(!fault);
  REQUIRE(drawn.check);
  CHECK(drawn.check->hidden == 0);
  CHECK(drawn.check->missing == 0);
  return *drawn.check;
}

inline void report(const char* what, const Asked& sum) {
  WARN(what << ": " << sum.scenes << " scenes, " << sum.asked << " asked, " << sum.ties << " ties, "
            << sum.hidden << " hidden but drawn, " << sum.missing << " missing");
}

} // namespace orograph
